// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/CellMesh.h"

#include "Mesh/Faults.h"
#include "Mesh/VertexStars.h"
#include "Support/Parallel.h"

#include <algorithm>

namespace flipflop
{

std::vector<Vertex> cornersIn(const PointSource& source, const CellComplex& complex)
{
  std::vector<Vertex> corners;
  // Where there are no other points, ids are indices.
  const std::size_t count = complex.pointIds.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto id = source.count() == count ? static_cast<std::int64_t>(i) : complex.pointIds[i];
    corners.push_back(source.vertex(static_cast<std::uint32_t>(id)));
    corners.back().flags = VertexAlive;
  }
  return corners;
}

Validation checkFinite(const std::vector<Vertex>& corners)
{
  const auto found = std::find_if(
    corners.begin(), corners.end(), [](const Vertex& corner) { return !isFinite(corner.x); });
  return found == corners.end() ? Validation() : faultAt(Fault::Structure, found - corners.begin());
}

Validation CellMesh::link(const CellComplex& complex, bool mayBeOpen, Monitor& monitor)
{
  // A cell of k corners makes k - 2 triangles.
  const std::int64_t cellCount = complex.cellCount();
  const std::int64_t count = cellCount > 0 ? complex.cellBegin(cellCount) - 2 * cellCount : 0;
  if (count >= NoIndex / 4)
  {
    throw Error(ErrorCode::TooManyPoints, -1, count);
  }
  this->triangles.allocate(static_cast<std::size_t>(count));
  this->cells.allocate(static_cast<std::size_t>(count));
  constexpr std::size_t CellsPerTask = 1 << 13;
  eachChunk(static_cast<std::size_t>(cellCount), CellsPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t)
    {
      monitor.poll();
      for (auto cell = static_cast<std::int64_t>(begin); cell < std::int64_t(end); ++cell)
      {
        this->addFan(complex, cell);
      }
    });

  // Each side is linked at its end.
  const std::size_t points = complex.pointIds.size();
  const VertexStars<TriangleSides> stars(
    TriangleSides(this->triangles.data(), this->triangles.size(), points));
  this->lowestAt.allocate(points);
  FaultyCells parted, unused;
  stars.eachStar([&] { monitor.poll(); },
    [&](std::uint32_t v, Star& star)
    {
      if (star.leaving.empty())
      {
        unused.add(v);
      }
      else if (!star.isFan() || !(star.isClosed || mayBeOpen))
      {
        parted.add(this->cells[triangleOf(star.leaving.front())]);
      }
      else
      {
        this->lowestAt[v] = triangleOf(star.leaving.front());
        stars.eachTwin(star,
          [this](std::uint32_t h, std::uint32_t twin)
          { setTwin(this->triangles.data(), h, twin); });
      }
    });
  return parted.count() > 0 ? faultAt(Fault::NotClosed, parted.first())
    : unused.count() > 0    ? faultAt(Fault::Structure, unused.first())
                            : Validation();
}

void CellMesh::addFan(const CellComplex& complex, std::int64_t cell)
{
  const std::int64_t begin = complex.cellBegin(cell);
  const auto corner = [&complex](std::int64_t i)
  { return static_cast<std::uint32_t>(complex.connectivity[static_cast<std::size_t>(i)]); };
  auto t = static_cast<std::size_t>(begin - 2 * cell);
  for (std::int64_t i = begin + 1; i + 1 < complex.cellBegin(cell + 1); ++i, ++t)
  {
    this->cells[t] = static_cast<std::uint32_t>(cell);
    this->triangles[t] = { { corner(begin), corner(i), corner(i + 1) }, 0,
      { NoIndex, NoIndex, NoIndex }, 0 };
  }
}

std::vector<std::int64_t> ringOfCells(const CellComplex& complex)
{
  std::vector<std::int64_t> ring;
  const std::int64_t* corners = complex.connectivity.data();
  const std::int64_t cellCount = complex.cellCount();
  if (cellCount == 1)
  {
    ring.assign(corners, corners + complex.connectivity.size());
    return ring;
  }
  // Triangles 0ab, 0bc, ...
  std::vector<std::int64_t> next(complex.pointIds.size(), -1);
  std::vector<bool> hasPrevious(next.size());
  for (std::int64_t cell = 0; cell < cellCount; ++cell)
  {
    const std::int64_t begin = complex.cellBegin(cell);
    const std::int64_t* c = corners + begin;
    if (complex.cellBegin(cell + 1) - begin != 3 || c[0] != 0 || next[c[1]] >= 0 ||
      hasPrevious[c[2]])
    {
      return {};
    }
    next[c[1]] = c[2];
    hasPrevious[c[2]] = true;
  }
  ring.push_back(0);
  for (std::size_t v = 1; v < next.size(); ++v)
  {
    if (next[v] >= 0 && !hasPrevious[v])
    {
      for (auto w = static_cast<std::int64_t>(v); w >= 0; w = next[w])
      {
        ring.push_back(w);
      }
      break;
    }
  }
  return ring.size() == next.size() ? ring : std::vector<std::int64_t>();
}

}
