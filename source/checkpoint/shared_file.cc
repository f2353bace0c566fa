// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/checkpoint/shared_file.h>
#include <signorini/output/whole_file.h>

#include <boost/crc.hpp>

#include <cerrno>
#include <fstream>
#include <vector>

namespace signorini
{
  void write_parts(const std::string  &path,
                   const void         *part,
                   const std::size_t   length,
                   const std::uint64_t place,
                   const MPI_Comm      communicator)
  {
    succeed_together(communicator, [&] {
      errno = 0;
      if (dealii::Utilities::MPI::this_mpi_process(communicator) == 0 && !std::ofstream(path))
        throw_write_error(path, errno);
    });
    succeed_together(communicator, [&] {
      errno = 0;
      std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
      file.seekp(static_cast<std::streamoff>(place));
      file.write(static_cast<const char *>(part), static_cast<std::streamsize>(length));
      file.close();
      if (!file)
        throw_write_error(path, errno);
    });
  }


  void read_part(const std::string  &path,
                 void               *part,
                 const std::size_t   length,
                 const std::uint64_t place)
  {
    std::ifstream file(path, std::ios::binary);
    file.seekg(static_cast<std::streamoff>(place));
    file.read(static_cast<char *>(part), static_cast<std::streamsize>(length));
    if (!file)
      throw RunError("cannot read `" + path + "`.");
  }


  std::uint32_t checksum(const std::string &path)
  {
    boost::crc_32_type crc;
    std::ifstream      file(path, std::ios::binary);
    std::vector<char>  buffer(1 << 16);
    do
      {
        file.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
        crc.process_bytes(buffer.data(), static_cast<std::size_t>(file.gcount()));
      }
    while (file);
    return crc.checksum();
  }
} // namespace signorini
