// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include <flipflop/CellComplex.h>

#include "Support/EngineCall.h"

#include <algorithm>
#include <array>
#include <vector>

namespace flipflop
{

namespace
{

/// The fans of all cells, in canonical order.
Buffer<std::int64_t> fansOf(const CellComplex& complex)
{
  const std::int64_t* const corners = complex.connectivity.data();
  std::vector<std::array<std::int64_t, 3>> triangles;
  triangles.reserve(complex.connectivity.size());
  // Polygons are sorted: only triangles of one lowest corner can be out of order.
  std::size_t group = 0;
  const auto sortGroup = [&]
  { std::sort(triangles.begin() + static_cast<std::ptrdiff_t>(group), triangles.end()); };
  for (std::int64_t cell = 0; cell < complex.cellCount(); ++cell)
  {
    const std::int64_t begin = complex.cellBegin(cell);
    const std::int64_t end = complex.cellBegin(cell + 1);
    if (group < triangles.size() && triangles[group][0] != corners[begin])
    {
      sortGroup();
      group = triangles.size();
    }
    for (std::int64_t k = begin + 1; k + 1 < end; ++k)
    {
      triangles.push_back({ corners[begin], corners[k], corners[k + 1] });
    }
  }
  sortGroup();

  Buffer<std::int64_t> connectivity(3 * triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    std::copy(triangles[i].begin(), triangles[i].end(), connectivity.data() + 3 * i);
  }
  return connectivity;
}

}

void fanPolygons(CellComplex& complex)
{
  engineCall(
    [&]
    {
      if (complex.dimension < 2 || complex.cellSize == 3)
      {
        return;
      }
      complex.connectivity = fansOf(complex);
      complex.offsets = Buffer<std::int64_t>();
      complex.cellSize = 3;
    });
}

}
