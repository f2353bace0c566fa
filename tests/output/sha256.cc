// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception OR LGPL-2.1-or-later
// Copyright (C) 2026 by the signorini authors

// Checksums are those that the standard gives for its examples, also of texts whose padding needs
// another block and of texts longer than what is read at once; else nobody could compare them with
// those of other programs.

#include <signorini/base/user_error.h>
#include <signorini/output/sha256.h>

#include <gtest/gtest.h>

#include <sstream>

using namespace signorini;

namespace
{
  std::string checksum(const std::string &text)
  {
    std::istringstream in(text);
    return sha256(in);
  }
} // namespace

TEST(Sha256, ExamplesOfTheStandard)
{
  EXPECT_EQ(checksum(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(checksum("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(checksum("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(checksum(std::string(1000000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, MissingFileIsNamed)
{
  try
    {
      sha256_of_file("/no/such/mesh.msh");
      FAIL() << "no error";
    }
  catch (const UserError &error)
    {
      EXPECT_NE(std::string(error.what()).find("/no/such/mesh.msh"), std::string::npos);
    }
}
