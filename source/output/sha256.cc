// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/user_error.h>
#include <signorini/output/sha256.h>

#include <openssl/evp.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <memory>
#include <vector>

namespace signorini
{
  std::string sha256(std::istream &in)
  {
    const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context(EVP_MD_CTX_new(),
                                                                          EVP_MD_CTX_free);
    bool              is_in_order = EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) == 1;
    std::vector<char> bytes(1 << 16);
    while (in.read(bytes.data(), static_cast<std::streamsize>(bytes.size())) || in.gcount() > 0)
      is_in_order &= EVP_DigestUpdate(context.get(), bytes.data(), in.gcount()) == 1;

    std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
    unsigned int                               length = 0;
    is_in_order &= EVP_DigestFinal_ex(context.get(), digest.data(), &length) == 1;
    if (!is_in_order)
      throw RunError("OpenSSL cannot form the SHA-256 of a file.");

    std::string text;
    for (unsigned int i = 0; i < length; ++i)
      {
        char digits[3];
        std::snprintf(digits, sizeof(digits), "%02x", digest[i]);
        text += digits;
      }
    return text;
  }


  std::string sha256_of_file(const std::string &path)
  {
    std::ifstream in(path, std::ios::binary);
    if (!in)
      throw UserError("cannot read `" + path + "`. Check its path and permissions.");
    return sha256(in);
  }
} // namespace signorini
