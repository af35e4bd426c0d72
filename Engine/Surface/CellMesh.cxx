// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/CellMesh.h"

#include <algorithm>

namespace flipflop
{

namespace
{

using Fan = std::array<std::uint32_t, 3>;

/// Add a triangle to vertex @p apex, turned around, at every side without a twin.
void closeBorder(const CellComplex& complex, std::vector<Fan>& fans, std::uint32_t apex)
{
  Buffer<std::uint8_t> isOpen(complex.connectivity.size());
  std::fill(isOpen.begin(), isOpen.end(), 0);
  const VertexStars<CellSides> stars{ CellSides(complex) };
  LinkFaults faults;
  linkTwins(
    stars, [] {},
    [&](std::uint32_t side, std::uint32_t twin) { isOpen[side] = twin == NoIndex ? 1 : 0; },
    faults);
  for (std::uint32_t side = 0; side < isOpen.size(); ++side)
  {
    if (isOpen[side])
    {
      fans.push_back({ stars.destination(side), stars.of().origin(side), apex });
    }
  }
}

}

CellMesh meshOfCells(const CellComplex& complex, const std::vector<Vertex>& corners, bool open)
{
  CellMesh mesh;
  std::vector<Fan> fans;
  for (std::int64_t cell = 0; cell < complex.cellCount(); ++cell)
  {
    const std::int64_t begin = complex.cellBegin(cell);
    const std::int64_t* c = complex.connectivity.data();
    for (std::int64_t i = begin + 2; i < complex.cellBegin(cell + 1); ++i)
    {
      fans.push_back({ static_cast<std::uint32_t>(c[begin]), static_cast<std::uint32_t>(c[i - 1]),
        static_cast<std::uint32_t>(c[i]) });
      mesh.cellOf.push_back(cell);
    }
  }
  constexpr std::size_t Most = NoIndex / 4; // half-edges have 32 bits, and no result of ours more
  if (open && fans.size() < Most)
  {
    closeBorder(complex, fans, static_cast<std::uint32_t>(corners.size()));
    mesh.cellOf.resize(fans.size(), -1);
  }
  if (fans.empty() || fans.size() >= Most)
  {
    return mesh;
  }
  mesh.any = true;
  mesh.polyhedron = Polyhedron(corners.size() + (open ? 1 : 0), fans.size());
  std::copy(corners.begin(), corners.end(), mesh.polyhedron.vertices.begin());
  if (open)
  {
    mesh.polyhedron.vertices[corners.size()] = virtualVertex();
  }
  for (std::size_t t = 0; t < fans.size(); ++t)
  {
    Triangle& triangle = mesh.polyhedron.triangles[t];
    std::copy(fans[t].begin(), fans[t].end(), triangle.v);
    triangle.flags = 0;
    triangle.flatEdges = 0;
  }
  mesh.fault = linkTriangles(mesh.polyhedron.triangles.data(), mesh.polyhedron.triangleCount(),
    mesh.polyhedron.vertexCount());
  return mesh;
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
