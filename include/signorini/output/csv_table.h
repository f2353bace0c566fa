// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_output_csv_table_h
#define signorini_output_csv_table_h

#include <deal.II/base/mpi.h>

#include <fstream>
#include <string>
#include <vector>

namespace signorini
{
  /**
   * A table of comma-separated numbers with a header line. Every row is on the disk before
   * write_row() returns, so that nothing is lost when the program is killed. Doubles are written
   * with 17 significant digits and can be read back without loss; whole numbers appear as integers.
   */
  class CsvTable
  {
  public:
    /**
     * Collective; the first process replaces the file. @throws RunError on all processes if that
     * is not possible.
     */
    CsvTable(const std::string              &path,
             const std::vector<std::string> &column_names,
             MPI_Comm                        communicator);

    /**
     * Collective; the values of the first process count. @throws RunError on all processes if the
     * disk is full.
     */
    void write_row(const std::vector<double> &values) { write_row(values, true); }

    /** A row that is not due yet: written by finish(), if no other one follows. Collective. */
    void write_row(const std::vector<double> &values, bool is_due);

    /** There will be no more rows. Collective. */
    void finish();

  private:
    std::string         path;
    std::size_t         n_columns;
    MPI_Comm            communicator;
    bool                first_process;
    std::ofstream       out;  ///< open on the first process only
    std::vector<double> last; ///< row that was not due; empty if there is none

    void write_line(const std::string &line);
  };
} // namespace signorini

#endif
