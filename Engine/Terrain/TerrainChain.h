// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A terrain on one line: a chain of segments, each vertex parts one. The counterpart of
/// TerrainTriangulation.
#ifndef flipflop_TerrainChain_h
#define flipflop_TerrainChain_h

#include "Terrain/SurfacePlane.h"
#include <flipflop/ConstrainedTriangulation.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace flipflop
{

class TerrainChain
{
public:
  /// @param vertexOf of each of its points, the number in @p points
  TerrainChain(const Vertex* points, const ConstrainedTriangulation& start,
    const std::vector<std::uint32_t>& vertexOf)
    : vertices(points)
  {
    for (std::size_t i = 0; i + 1 < start.connectivity.size(); i += 2)
    {
      const std::uint32_t a = vertexOf[static_cast<std::size_t>(start.connectivity[i])];
      const std::uint32_t b = vertexOf[static_cast<std::size_t>(start.connectivity[i + 1])];
      const bool ascends = this->isBefore(a, b);
      this->segments.push_back(ascends ? Segment{ a, b } : Segment{ b, a });
    }
  }

  std::size_t cellCount() const { return this->segments.size(); }

  SurfaceCorners corners(std::uint32_t cell) const
  {
    const Segment& segment = this->segments[cell];
    return { this->vertices + segment.from, this->vertices + segment.to, nullptr };
  }

  static bool isCell(std::uint32_t) { return true; }
  static void findSpokes() {}
  template <class Also>
  static void bringNear(const std::vector<std::uint32_t>&, const Also&)
  {
  }

  void insert(std::uint32_t v, std::uint32_t cell)
  {
    const auto fresh = static_cast<std::uint32_t>(this->segments.size());
    this->segments.push_back({ v, this->segments[cell].to });
    this->segments[cell].to = v;
    this->middle = v;
    this->old.assign(1, cell);
    this->made = { cell, fresh };
  }

  const std::vector<std::uint32_t>& replaced() const { return this->old; }
  const std::vector<std::uint32_t>& parts() const { return this->made; }

  void findParts(const std::vector<std::uint32_t>& some, std::vector<std::uint32_t>& part) const
  {
    part.clear();
    for (const std::uint32_t p : some)
    {
      part.push_back(this->isBefore(p, this->middle) ? 0 : 1);
    }
  }

  std::int64_t checkCount() const { return 0; }
  std::int64_t exactCalls() const { return 0; }

private:
  struct Segment
  {
    std::uint32_t from, to;
  };

  bool isBefore(std::uint32_t a, std::uint32_t b) const
  {
    const double* const p = this->vertices[a].x;
    const double* const q = this->vertices[b].x;
    return p[0] != q[0] ? p[0] < q[0] : p[1] < q[1];
  }

  const Vertex* vertices;
  std::vector<Segment> segments; ///< each from its lower position to the upper one
  std::uint32_t middle = 0;      ///< the last vertex inserted
  std::vector<std::uint32_t> old, made;
};

}

#endif
