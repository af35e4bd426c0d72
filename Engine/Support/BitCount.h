// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// How many bits of a word are set, on host and device. C++17 has no function for it.
#ifndef flipflop_BitCount_h
#define flipflop_BitCount_h

#include "Support/HostDevice.h"

#include <cstdint>

namespace flipflop
{

FF_HD inline std::uint32_t bitCount(std::uint64_t word)
{
  word -= (word >> 1) & 0x5555555555555555ull;
  word = (word & 0x3333333333333333ull) + ((word >> 2) & 0x3333333333333333ull);
  word = (word + (word >> 4)) & 0x0F0F0F0F0F0F0F0Full;
  return static_cast<std::uint32_t>(word * 0x0101010101010101ull >> 56);
}

/// Of the bits below bit @p i only.
FF_HD inline std::uint32_t bitCountBelow(std::uint64_t word, std::uint32_t i)
{
  return bitCount(word & ((std::uint64_t(1) << i) - 1));
}

}

#endif
