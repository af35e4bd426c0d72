// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Run/Span.h"

#include "Geometry/HullGeometry.h"
#include "Points/Vector3.h"
#include "Predicates/FixedSigns.h"
#include "Support/Parallel.h"

#include <cmath>

namespace flipflop
{

namespace
{

constexpr std::uint32_t PollEvery = 1 << 16;

/// Looks for points ever farther from what is spanned so far. Distances are rounded and only choose
/// among candidates; independence is exact.
class SpanSearch
{
public:
  SpanSearch(const HullGeometry& geometry, const PointSource& source, int most, bool checkFinite,
    Monitor& monitor)
    : geometry(geometry)
    , source(source)
    , most(most)
    , checkFinite(checkFinite)
    , monitor(monitor)
  {
  }

  Span span;

  /// Extend the span by points among @p ids (null: all).
  void extend(const std::uint32_t* ids, std::uint32_t count)
  {
    while (this->span.dimension < this->most && this->extendOnce(ids, count))
    {
    }
  }

private:
  bool extendOnce(const std::uint32_t* ids, std::uint32_t count)
  {
    bool found = false;
    double best = -1;
    Vertex bestVertex{};
    for (std::uint32_t i = 0; i < count; ++i)
    {
      const Vertex p = this->source.vertex(ids ? ids[i] : i);
      if ((i & (PollEvery - 1)) == 0)
      {
        this->monitor.poll();
      }
      if (this->checkFinite && !isFinite(p.x))
      {
        continue;
      }
      const double far = this->distance(p);
      if ((!found || far > best) && this->isIndependent(p))
      {
        found = true;
        best = far;
        bestVertex = p;
      }
    }
    if (found)
    {
      ++this->span.dimension;
      this->span.ids[this->span.dimension] = bestVertex.id;
      this->corner[this->span.dimension] = bestVertex;
      this->edge[this->span.dimension] = subtract(bestVertex.x, this->corner[0].x);
      if (this->span.dimension == 2)
      {
        this->plane = FixedPlane(this->corner[0].x, this->corner[1].x, this->corner[2].x);
      }
    }
    return found;
  }

  bool isIndependent(const Vertex& p) const
  {
    for (int k = 0; k <= this->span.dimension; ++k)
    {
      if (this->corner[k].id == p.id)
      {
        return false; // as exact arithmetic would find out
      }
    }
    switch (this->span.dimension)
    {
      case -1:
        return true;
      case 0:
        return !samePosition(this->corner[0], p);
      case 1:
        return !this->geometry.collinear(this->corner[0], this->corner[1], p);
      default:
        return !this->plane.contains(p.x) &&
          this->geometry.above(this->corner[0], this->corner[1], this->corner[2], p) != 0;
    }
  }

  /// Some measure of how far p is from the span; overflow and underflow only make it a worse one.
  double distance(const Vertex& p) const
  {
    const Vector3 u = subtract(p.x, this->corner[0].x);
    switch (this->span.dimension)
    {
      case -1:
        return -p.x[0];
      case 0:
        return largestOf(u[0], u[1], u[2]);
      case 1:
      {
        const Vector3 n = cross(u, this->edge[1]);
        return largestOf(n[0], n[1], n[2]);
      }
      default:
        return std::fabs(dot(u, cross(this->edge[1], this->edge[2])));
    }
  }

  const HullGeometry& geometry;
  const PointSource& source;
  int most;
  bool checkFinite;
  Monitor& monitor;
  Vertex corner[4] = {};
  Vector3 edge[4] = {}; ///< from the first corner
  FixedPlane plane;     ///< of the first three
};

}

Span findSpan(const HullGeometry& geometry, const PointSource& source, const std::uint32_t* ids,
  std::uint32_t count, int most, bool checkFinite, Monitor& monitor)
{
  SpanSearch search(geometry, source, most, checkFinite, monitor);
  // A few, evenly spread, nearly always span what all do.
  constexpr std::uint32_t Few = 64;
  if (count > 2 * Few)
  {
    std::uint32_t some[Few];
    for (std::uint32_t i = 0; i < Few; ++i)
    {
      const std::uint32_t at = partBegin(count, Few, i);
      some[i] = ids ? ids[at] : at;
    }
    search.extend(some, Few);
  }
  search.extend(ids, count);
  if (search.span.dimension < most && ids)
  {
    search.extend(nullptr, source.count());
  }
  return search.span;
}

Span findSpan(const HullGeometry& geometry, const PointSource& source, const Samples& samples,
  int most, bool checkFinite, Monitor& monitor)
{
  const std::uint32_t* const ids = samples.empty() ? nullptr : samples.back().data();
  const std::size_t count = samples.empty() ? source.count() : samples.back().size();
  return findSpan(
    geometry, source, ids, static_cast<std::uint32_t>(count), most, checkFinite, monitor);
}

}
