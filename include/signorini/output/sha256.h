// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#ifndef signorini_output_sha256_h
#define signorini_output_sha256_h

#include <iosfwd>
#include <string>

namespace signorini
{
  /**
   * Checksum of all that is left in a stream, in 64 hexadecimal digits, as the command `sha256sum`
   * prints it (FIPS 180-4).
   */
  std::string sha256(std::istream &in);

  /** The same of a file. @throws UserError if it cannot be read */
  std::string sha256_of_file(const std::string &path);
} // namespace signorini

#endif
