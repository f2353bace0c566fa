// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/base/user_error.h>
#include <signorini/output/csv_table.h>
#include <signorini/output/whole_file.h>

#include <cerrno>
#include <cstdio>

namespace signorini
{
  CsvTable::CsvTable(const std::string              &path,
                     const std::vector<std::string> &column_names,
                     const MPI_Comm                  communicator)
    : path(path)
    , n_columns(column_names.size())
    , communicator(communicator)
    , first_process(dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
  {
    succeed_together(communicator, [&] {
      if (!first_process)
        return;
      errno = 0;
      out.open(path);
      write_line(join(column_names, ","));
    });
  }


  void CsvTable::write_row(const std::vector<double> &values, const bool is_due)
  {
    last.clear();
    if (!is_due)
      {
        last = values;
        return;
      }
    succeed_together(communicator, [&] {
      if (!first_process)
        return;
      if (values.size() != n_columns)
        throw RunError("a row of " + std::to_string(values.size()) + " numbers for the "
                       + std::to_string(n_columns) + " columns of `" + path + "`.");
      std::string line;
      char        number[32];
      for (const double value : values)
        {
          std::snprintf(number, sizeof(number), "%.17g", value);
          line += (line.empty() ? "" : ",") + std::string(number);
        }
      write_line(line);
    });
  }


  void CsvTable::finish()
  {
    if (!last.empty())
      write_row(std::vector<double>(last)); // a copy, as a row makes it forget the last one
  }


  void CsvTable::write_line(const std::string &line)
  {
    errno = 0;
    out << line << '\n' << std::flush;
    if (!out)
      throw_write_error(path, errno);
  }
} // namespace signorini
