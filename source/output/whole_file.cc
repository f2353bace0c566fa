// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/output/whole_file.h>

#include <deal.II/base/exceptions.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace signorini
{
  void throw_write_error(const std::string &path, const int error_number)
  {
    throw RunError("cannot write `" + path + "`"
                   + (error_number != 0 ? std::string(": ") + std::strerror(error_number) : "")
                   + ".");
  }


  void write_whole_file(const std::string &path, const std::function<void(std::ostream &)> &write)
  {
    const std::string temporary = path + ".part";
    std::error_code   error;
    errno = 0;
    {
      std::ofstream out(temporary, std::ios::binary);
      try
        {
          if (out)
            write(out);
        }
      catch (const dealii::ExceptionBase &)
        {
          // deal.II looks at its streams too, but cannot name the file.
          if (out.good())
            throw;
        }
      out.close();
      if (!out)
        {
          const int error_number = errno;
          std::filesystem::remove(temporary, error);
          throw_write_error(path, error_number);
        }
    }
    std::filesystem::rename(temporary, path, error);
    if (error)
      {
        const int       error_number = error.value();
        std::error_code ignored;
        std::filesystem::remove(temporary, ignored);
        throw_write_error(path, error_number);
      }
  }


  void succeed_together(const MPI_Comm communicator, const std::function<void()> &action)
  {
    namespace Communication = dealii::Utilities::MPI;
    bool        failed      = false;
    std::string message;
    try
      {
        action();
      }
    catch (const std::exception &exception)
      {
        failed  = true;
        message = exception.what();
      }
    const unsigned int n     = Communication::n_mpi_processes(communicator);
    const unsigned int rank  = Communication::this_mpi_process(communicator);
    const unsigned int first = Communication::min(failed ? rank : n, communicator);
    if (first < n)
      throw RunError(Communication::broadcast(communicator, message, first));
  }
} // namespace signorini
