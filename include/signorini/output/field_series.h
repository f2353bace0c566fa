// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_output_field_series_h
#define signorini_output_field_series_h

#include <signorini/base/archive.h>

#include <deal.II/base/data_out_base.h>

#include <string>
#include <utility>
#include <vector>

namespace signorini
{
  /**
   * Moments of one kind of field: `fields/<name>_<step>.pvtu` with one piece per process, and
   * `<name>.pvd` in the folder above, which names the moments written so far and is valid at any
   * time. A moment is written in two halves, because the first one needs no other process: all
   * write their pieces, and when all have, name_moment() makes them known.
   */
  class FieldSeries
  {
  public:
    /** Collective. Makes the folders, and removes the .pvd that an earlier run may have left. */
    FieldSeries(const std::string &directory, const std::string &name, MPI_Comm communicator);

    /**
     * Write the piece of this process. Not collective; it changes nothing but the file, so that
     * another thread can do it.
     * @throws RunError if the file cannot be written
     */
    template <int dim, int spacedim>
    void write_piece(dealii::DataOutInterface<dim, spacedim> &data,
                     unsigned int                             step,
                     double                                   time) const;

    /**
     * Write the files that name the pieces of all processes, which have to be complete. Collective.
     * @throws RunError on all processes if a file cannot be written
     */
    template <int dim, int spacedim>
    void name_moment(const dealii::DataOutInterface<dim, spacedim> &data,
                     unsigned int                                   step,
                     double                                         time);

    /**
     * The moments so far. Read from an archive, they are those of the .pvd but for those whose
     * files somebody has taken away, and files of other moments are removed: of steps that come
     * again. Collective if it reads.
     */
    void archive(Archive &archive);

  private:
    std::string                                 directory, name;
    MPI_Comm                                    communicator;
    unsigned int                                this_process, n_processes;
    std::vector<std::pair<double, std::string>> moments; ///< time, file relative to the directory

    // On the first process.
    void forget_missing_moments();
    void remove_later_moments() const;
    void write_record(const std::vector<std::pair<double, std::string>> &known) const;
    /** Without folder and ending. */
    std::string moment(unsigned int step) const;
    /** Without folder. */
    std::string piece(unsigned int step, unsigned int process) const;
  };
} // namespace signorini

#endif
