// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A hash of bytes, by which files and saved blocks show damage. It is a part of their format, so
/// it is the same in all builds of one byte order, which std::hash is not: MurmurHash64A
/// (A. Appleby, 2008).
#ifndef flipflop_ByteHash_h
#define flipflop_ByteHash_h

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace flipflop
{

inline std::uint64_t byteHash(const void* bytes, std::size_t size, std::uint64_t seed = 0)
{
  constexpr std::uint64_t Factor = 0xc6a4a7935bd1e995;
  const auto* next = static_cast<const char*>(bytes);
  std::uint64_t hash = seed ^ size * Factor;
  for (; size >= sizeof(hash); size -= sizeof(hash), next += sizeof(hash))
  {
    std::uint64_t word;
    std::memcpy(&word, next, sizeof(word));
    word *= Factor;
    hash = (hash ^ (word ^ word >> 47) * Factor) * Factor;
  }
  if (size > 0)
  {
    std::uint64_t rest = 0;
    std::memcpy(&rest, next, size);
    hash = (hash ^ rest) * Factor;
  }
  hash = (hash ^ hash >> 47) * Factor;
  return hash ^ hash >> 47;
}

}

#endif
