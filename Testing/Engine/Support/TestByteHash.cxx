// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The hash of bytes is the published function: files that another build has written are read.
#include "Support/ByteHash.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

/// The check of SMHasher, a collection of tests of hashes: the hash of the hashes of 0 to 255 bytes
/// with a seed each begins with a number that it lists for each function.
TEST(ByteHash, IsMurmurHash64A)
{
  std::vector<unsigned char> key;
  std::vector<std::uint64_t> hashes;
  for (unsigned i = 0; i < 256; ++i)
  {
    hashes.push_back(byteHash(key.data(), key.size(), 256 - i));
    key.push_back(static_cast<unsigned char>(i));
  }
  const std::uint64_t all = byteHash(hashes.data(), hashes.size() * sizeof(std::uint64_t));
  EXPECT_EQ(static_cast<std::uint32_t>(all), 0x1F0D3804u);
}

TEST(ByteHash, HasFixedValues)
{
  const auto hashOf = [](const std::string& text) { return byteHash(text.data(), text.size()); };
  EXPECT_EQ(hashOf(""), 0u);
  EXPECT_EQ(hashOf("flipflop"), 0x130bd685bc6e2869u);
  EXPECT_EQ(hashOf("a streamed run"), 0x8e63ff24bf6976eeu);
}

}

}
}
