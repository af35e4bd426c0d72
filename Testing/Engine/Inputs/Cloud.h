// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef flipflop_test_Cloud_h
#define flipflop_test_Cloud_h

#include <array>
#include <vector>

namespace flipflop
{
namespace test
{

/// x y z, or x y and the weight.
using Point = std::array<double, 3>;
using Cloud = std::vector<Point>;

}
}

#endif
