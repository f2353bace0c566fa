// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

#include <signorini/base/sha256.h>
#include <signorini/base/user_error.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <vector>

namespace signorini
{
  namespace
  {
    /** FIPS 180-4, 4.2.2: the cube roots of the first 64 primes. */
    constexpr std::array<std::uint32_t, 64> round_constants = {
      0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4,
      0xab1c5ed5, 0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe,
      0x9bdc06a7, 0xc19bf174, 0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f,
      0x4a7484aa, 0x5cb0a9dc, 0x76f988da, 0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7,
      0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967, 0x27b70a85, 0x2e1b2138, 0x4d2c6dfc,
      0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85, 0xa2bfe8a1, 0xa81a664b,
      0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070, 0x19a4c116,
      0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
      0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7,
      0xc67178f2};

    using Hash = std::array<std::uint32_t, 8>;

    std::uint32_t rotated(const std::uint32_t x, const unsigned int n)
    {
      return x >> n | x << (32 - n);
    }

    /** FIPS 180-4, 6.2.2, for one block of 64 bytes. */
    void digest(const unsigned char *block, Hash &hash)
    {
      std::array<std::uint32_t, 64> w;
      for (unsigned int t = 0; t < 16; ++t)
        w[t] = std::uint32_t(block[4 * t]) << 24 | std::uint32_t(block[4 * t + 1]) << 16
               | std::uint32_t(block[4 * t + 2]) << 8 | block[4 * t + 3];
      for (unsigned int t = 16; t < 64; ++t)
        {
          const std::uint32_t x = w[t - 15], y = w[t - 2];
          w[t] = w[t - 16] + w[t - 7] + (rotated(x, 7) ^ rotated(x, 18) ^ x >> 3)
                 + (rotated(y, 17) ^ rotated(y, 19) ^ y >> 10);
        }
      auto [a, b, c, d, e, f, g, h] = hash;
      for (unsigned int t = 0; t < 64; ++t)
        {
          const std::uint32_t first = h + (rotated(e, 6) ^ rotated(e, 11) ^ rotated(e, 25))
                                      + ((e & f) ^ (~e & g)) + round_constants[t] + w[t],
                              second = (rotated(a, 2) ^ rotated(a, 13) ^ rotated(a, 22))
                                       + ((a & b) ^ (a & c) ^ (b & c));
          h = g;
          g = f;
          f = e;
          e = d + first;
          d = c;
          c = b;
          b = a;
          a = first + second;
        }
      const Hash change = {a, b, c, d, e, f, g, h};
      for (unsigned int i = 0; i < 8; ++i)
        hash[i] += change[i];
    }
  } // namespace


  std::string sha256(std::istream &in)
  {
    Hash                       hash   = {0x6a09e667,
                                         0xbb67ae85,
                                         0x3c6ef372,
                                         0xa54ff53a,
                                         0x510e527f,
                                         0x9b05688c,
                                         0x1f83d9ab,
                                         0x5be0cd19};
    std::uint64_t              n_bits = 0;
    std::vector<unsigned char> bytes(1 << 16);
    const auto                 digest_all = [&] {
      for (std::size_t start = 0; start + 64 <= bytes.size(); start += 64)
        digest(bytes.data() + start, hash);
    };
    while (in.read(reinterpret_cast<char *>(bytes.data()), bytes.size()))
      {
        n_bits += 8 * bytes.size();
        digest_all();
      }
    bytes.resize(in.gcount());
    n_bits += 8 * bytes.size();
    bytes.push_back(0x80);
    while (bytes.size() % 64 != 56)
      bytes.push_back(0);
    for (int shift = 56; shift >= 0; shift -= 8)
      bytes.push_back(n_bits >> shift & 0xff);
    digest_all();

    char text[65];
    for (unsigned int i = 0; i < 8; ++i)
      std::snprintf(text + 8 * i, 9, "%08x", hash[i]);
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
