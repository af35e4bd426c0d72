// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The order in which many points are edited: neighbours follow each other.
#ifndef flipflop_SlotOrder_h
#define flipflop_SlotOrder_h

#include "Geometry/HilbertCurve.h"
#include "Support/Monitor.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipflop
{

/// Slots in the order of a curve through their points.
template <class VertexOf>
void sortAlongCurve(std::vector<std::uint32_t>& slots, const VertexOf& vertexOf, Monitor& monitor)
{
  const HilbertCurve curve = curveThrough(slots.size(), monitor,
    [&](std::size_t i, double* uv) { std::copy_n(vertexOf(slots[i]).x, 2, uv); });
  std::vector<std::uint64_t> keys;
  keys.reserve(slots.size());
  for (const std::uint32_t slot : slots)
  {
    keys.push_back(std::uint64_t(curve.at(vertexOf(slot).x)) << 32 | slot);
  }
  std::sort(keys.begin(), keys.end());
  std::transform(keys.begin(), keys.end(), slots.begin(),
    [](std::uint64_t key) { return static_cast<std::uint32_t>(key); });
}

}

#endif
