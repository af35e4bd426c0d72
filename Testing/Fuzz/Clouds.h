// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Point clouds from a few bytes: of small or any numbers, of a palette, or of a family by seed.
#ifndef flipflop_fuzz_Clouds_h
#define flipflop_fuzz_Clouds_h

#include "Bytes.h"
#include "Testing/Engine/Inputs/Inputs.h"

namespace flipflop
{
namespace fuzz
{

using test::Cloud;
using test::Point;

/// Mostly some ten points, sometimes a few hundred, and now and then more than the engine's samples
/// begin at. Coordinates may be NaN or infinite.
/// @param most points at most
Cloud drawCloud(Bytes& bytes, int most);

/// Weights for a cloud, in z's place: its z, one for all, ties, or numbers.
void drawWeights(Bytes& bytes, Cloud& cloud);

/// How many points have a coordinate that is not finite, and which is the first.
struct NonFinite
{
  std::int64_t count = 0;
  std::int64_t first = -1;
};
/// @param axes that count: the first so many
NonFinite findNonFinite(const Cloud& cloud, int axes = 3);

}
}

#endif
