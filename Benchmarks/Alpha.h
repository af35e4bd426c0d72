// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef flipflop_Alpha_h
#define flipflop_Alpha_h

#include "Program.h"

#include <algorithm>
#include <cmath>

namespace flipflop
{

/// The alpha that all programs take: 0.7 of the step between so many points in a square.
inline double alphaOf(const Input& input)
{
  double low = input.xyz[0];
  double high = low;
  for (std::size_t i = 0; i < input.xyz.size(); i += 3)
  {
    low = std::min(low, input.xyz[i]);
    high = std::max(high, input.xyz[i]);
  }
  return 0.7 * (high - low) / std::sqrt(static_cast<double>(input.count()));
}

}

#endif
