// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_sweeps_sweep_exchange_h
#define signorini_sweeps_sweep_exchange_h

#include <signorini/sweeps/sweep_order.h>

#include <mpi.h>

namespace signorini
{
  /**
   * Sends the values of the interface from process to process in the order of a sweep, while both
   * go on with their other nodes. Nodes have four numbers, see Lanes.
   */
  class SweepExchange
  {
  public:
    /** @param position_of of owned nodes in the order */
    SweepExchange(const SweepOrder                &order,
                  const std::vector<unsigned int> &position_of,
                  MPI_Comm                         communicator);

    bool any() const { return !neighbours.empty(); }

    /** A sweep begins. @param forward from earlier processes to later ones, or back */
    void expect(bool forward);
    /** Wait for what comes. @return four numbers per ghost, from those processes only */
    const std::vector<float> &receive();
    /** @param values four numbers per position, of which those of the interface are ready */
    void send(const std::vector<float> &values, bool forward);
    /** Wait until all is sent. */
    void finish();

  private:
    struct Neighbour
    {
      unsigned int              rank;
      bool                      is_earlier;
      unsigned int              first_ghost;
      std::vector<float>        incoming, outgoing;
      std::vector<unsigned int> wanted; ///< positions
    };
    std::vector<Neighbour>   neighbours;
    MPI_Comm                 communicator;
    std::vector<float>       ghosts;
    std::vector<MPI_Request> receiving, sending;
    bool                     expects_earlier = false;
  };
} // namespace signorini

#endif
