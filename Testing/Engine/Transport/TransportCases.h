// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Sites to move and to weigh, and the cells that their weights give.
#ifndef flipflop_test_TransportCases_h
#define flipflop_test_TransportCases_h

#include <flipflop/PowerDiagram.h>
#include <flipflop/RegularTriangulation.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace flipflop
{
namespace test
{

using Numbers = std::vector<double>;

inline PointView sitesView(const Numbers& sites)
{
  return PointView(sites.data(), static_cast<std::int64_t>(sites.size() / 2), 2);
}

inline WeightView numbersView(const Numbers& numbers)
{
  return numbers.empty() ? WeightView()
                         : WeightView(numbers.data(), static_cast<std::int64_t>(numbers.size()));
}

inline Options onThreads(int threads)
{
  Options options;
  options.threads = threads;
  return options;
}

inline Numbers randomNumbers(std::size_t count, double from, double to, unsigned seed)
{
  std::mt19937 random(seed);
  Numbers numbers(count);
  for (double& x : numbers)
  {
    x = from + (to - from) * 0x1p-32 * static_cast<double>(random());
  }
  return numbers;
}

/// By a power of two.
inline Numbers scaled(Numbers numbers, int exponent)
{
  for (double& x : numbers)
  {
    x = std::ldexp(x, exponent);
  }
  return numbers;
}

inline Numbers grid(int side)
{
  Numbers sites;
  for (int i = 0; i < side * side; ++i)
  {
    sites.push_back((i % side + 0.5) / side);
    sites.push_back((i / side + 0.5) / side);
  }
  return sites;
}

inline PowerDiagram cellsOf(
  const Numbers& sites, const WeightView& weights, const ConvexDomain& domain)
{
  Options options;
  options.facets = FacetMode::Polygons;
  const PointView points = sitesView(sites);
  return powerDiagram(points, weights, regularTriangulation(points, weights, options), domain);
}

}
}

#endif
