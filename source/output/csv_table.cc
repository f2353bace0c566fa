// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/spelling.h>
#include <signorini/base/user_error.h>
#include <signorini/output/csv_table.h>
#include <signorini/output/whole_file.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>

namespace signorini
{
  CsvTable::CsvTable(const std::string              &path,
                     const std::vector<std::string> &column_names,
                     const MPI_Comm                  communicator)
    : path(path)
    , column_names(column_names)
    , communicator(communicator)
    , first_process(dealii::Utilities::MPI::this_mpi_process(communicator) == 0)
  {
  }


  void CsvTable::open()
  {
    errno  = 0;
    length = 0;
    out.open(path);
    write_line(join(column_names, ","));
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
      if (values.size() != column_names.size())
        throw RunError("a row of " + std::to_string(values.size()) + " numbers for the "
                       + std::to_string(column_names.size()) + " columns of `" + path + "`.");
      if (length == 0)
        open();
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


  void CsvTable::archive(Archive &archive)
  {
    archive(length, last);
    if (!archive.reads())
      return;
    const std::string what_lacks =
      dealii::Utilities::MPI::broadcast(communicator, first_process ? what_it_lacks() : "");
    if (!what_lacks.empty())
      throw UserError("cannot go on with `" + path + "`: " + what_lacks
                      + ". Put the file of the run back, or run anew without --resume.");
    succeed_together(communicator, [&] {
      if (first_process && length > 0)
        reopen();
    });
  }


  std::string CsvTable::what_it_lacks() const
  {
    if (length == 0)
      return "";
    std::error_code      error;
    const std::uintmax_t now = std::filesystem::file_size(path, error);
    return error          ? error.message()
           : now < length ? "it is shorter than when the checkpoint was written"
                          : "";
  }


  void CsvTable::reopen()
  {
    std::error_code error;
    std::filesystem::resize_file(path, length, error);
    if (error)
      throw_write_error(path, error.value());
    errno = 0;
    out.open(path, std::ios::app);
    if (!out)
      throw_write_error(path, errno);
  }


  void CsvTable::write_line(const std::string &line)
  {
    errno = 0;
    out << line << '\n' << std::flush;
    if (out)
      {
        length += line.size() + 1;
        return;
      }
    const int error_number = errno;
    out.close();
    std::error_code ignored;
    std::filesystem::resize_file(path, length, ignored); // rows are whole, also on a full disk
    throw_write_error(path, error_number);
  }
} // namespace signorini
