// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_output_csv_table_h
#define signorini_output_csv_table_h

#include <signorini/base/archive.h>

#include <deal.II/base/mpi.h>

#include <cstdint>
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
    /** The first process writes the file: the first row replaces one of an earlier run. */
    CsvTable(const std::string              &path,
             const std::vector<std::string> &column_names,
             MPI_Comm                        communicator);

    /**
     * Collective; the values of the first process count. @throws RunError on all processes if the
     * file cannot be written, as when the disk is full.
     */
    void write_row(const std::vector<double> &values) { write_row(values, true); }

    /** A row that is not due yet: written by finish(), if no other one follows. Collective. */
    void write_row(const std::vector<double> &values, bool is_due);

    /** There will be no more rows. Collective. */
    void finish();

    /**
     * Where the file ends now. Read from an archive: the file is cut there, and rows go on.
     * Collective if it reads. @throws UserError on all processes if the file is not that of the
     * archive any more
     */
    void archive(Archive &archive);

  private:
    std::string              path;
    std::vector<std::string> column_names;
    MPI_Comm                 communicator;
    bool                     first_process;
    std::ofstream            out;  ///< open on the first process only, from the first row on
    std::vector<double>      last; ///< row that was not due; empty if there is none

    std::uintmax_t length = 0; ///< of the file, in bytes, on the first process

    void open();
    void write_line(const std::string &line);
    /** Why a run cannot go on with its file; empty if it can. */
    std::string what_it_lacks() const;
    /** Go on after the first bytes. */
    void reopen();
  };
} // namespace signorini

#endif
