// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_checkpoint_shared_file_h
#define signorini_checkpoint_shared_file_h

#include <deal.II/base/mpi.h>

#include <cstdint>
#include <string>

namespace signorini
{
  /**
   * Write a file of bytes, each process its part at its place; on all processes the file is seen
   * under the same name. Collective. @throws RunError on all processes, as when the disk is full
   */
  void write_parts(const std::string &path,
                   const void        *part,
                   std::size_t        length,
                   std::uint64_t      place,
                   MPI_Comm           communicator);

  /** A part of a file. @throws RunError if it is not there */
  void read_part(const std::string &path, void *part, std::size_t length, std::uint64_t place);

  /** CRC-32 of the content; of nothing if the file is not there. */
  std::uint32_t checksum(const std::string &path);
} // namespace signorini

#endif
