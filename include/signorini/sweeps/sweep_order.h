// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_sweeps_sweep_order_h
#define signorini_sweeps_sweep_order_h

#include <signorini/linear_algebra/separate_parts.h>

#include <array>

namespace signorini
{
  /**
   * One order of all nodes of all processes, in which a sweep of Gauss and Seidel goes on
   * everywhere at the same time. Neighbouring processes have different colours, and their nodes
   * follow each other in the order of the colours where they are coupled. A process comes to its
   * coupled nodes (the interface) the later the higher its colour is: the one of two that is first
   * begins with its interface and sends it, while the other one is busy with the rest of its nodes.
   * So nobody waits, and the sweep is the same method on any number of processes. The rest follows
   * the interface level by level, or comes up to it.
   *
   * The graph of all neighbours is known to each process: a few numbers per process of the run.
   */
  class SweepOrder
  {
  public:
    /** Collective. */
    template <int dim>
    static SweepOrder of(const NodePattern &pattern);

    /** The same without some nodes. @param is_wanted per owned node */
    SweepOrder restricted_to(const std::vector<char> &is_wanted) const;

    std::vector<unsigned int> nodes;           ///< position -> owned node
    unsigned int              interface_begin; ///< first position of the interface
    unsigned int              interface_end;   ///< behind its last

    /**
     * Parts that nothing couples follow each other before the interface, in it, and behind it.
     * These are their first positions there, and the end.
     */
    std::array<std::vector<unsigned int>, 3> part_begin;

    unsigned int n_parts() const { return part_begin[0].size() - 1; }

    /** Values of nodes that another process owns (received) or wants (sent). */
    struct Neighbour
    {
      unsigned int              rank;
      bool                      is_earlier;            ///< comes before this process in the order
      unsigned int              first_ghost, n_ghosts; ///< those that it owns; counted in ghosts
      std::vector<unsigned int> wanted; ///< owned nodes that it wants, in the order of its ghosts
    };
    std::vector<Neighbour> neighbours;

    /** Whether the owner of a ghost (counted in ghosts) comes before this process. */
    bool is_earlier(unsigned int ghost) const;

  private:
    void sort_by(const SeparateParts &parts);
  };
} // namespace signorini

#endif
