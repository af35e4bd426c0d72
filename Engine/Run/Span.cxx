// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Run/Span.h"

#include "Geometry/HullGeometry.h"
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
      for (int i = 0; i < 3; ++i)
      {
        this->edge[this->span.dimension][i] = bestVertex.x[i] - this->corner[0].x[i];
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
        return this->geometry.above(this->corner[0], this->corner[1], this->corner[2], p) != 0;
    }
  }

  /// Some measure of how far p is from the span; overflow and underflow only make it a worse one.
  double distance(const Vertex& p) const
  {
    const double u[3] = { p.x[0] - this->corner[0].x[0], p.x[1] - this->corner[0].x[1],
      p.x[2] - this->corner[0].x[2] };
    const double* const v = this->edge[1];
    const double* const w = this->edge[2];
    switch (this->span.dimension)
    {
      case -1:
        return -p.x[0];
      case 0:
        return largestOf(u[0], u[1], u[2]);
      case 1:
        return largestOf(
          u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
      default:
        return std::fabs(u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
          u[2] * (v[0] * w[1] - v[1] * w[0]));
    }
  }

  const HullGeometry& geometry;
  const PointSource& source;
  int most;
  bool checkFinite;
  Monitor& monitor;
  Vertex corner[4] = {};
  double edge[4][3] = {}; ///< from the first corner
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
