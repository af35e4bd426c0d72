// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PowerDiagram/PolygonClipper.h"

#include "Geometry/ConvexPolygon.h"
#include "Predicates/PlaneOrientation.h"

#include <cmath>
#include <limits>

namespace flipflop
{

namespace
{

std::int64_t sideLine(std::size_t side)
{
  return -1 - static_cast<std::int64_t>(side);
}

const double* cornerOf(const std::vector<double>& polygon, std::size_t i)
{
  return polygon.data() + 2 * i % polygon.size();
}

bool holds(const std::vector<double>& polygon, const double* x)
{
  return fanTriangleOf(polygon.size() / 2,
           [&](std::size_t i, std::size_t j)
           { return planeOrientation(cornerOf(polygon, i), cornerOf(polygon, j), x); }) != 0;
}

}

bool surelyHolds(const std::vector<double>& polygon, const double* x)
{
  constexpr double Infinite = std::numeric_limits<double>::infinity();
  for (int corner = 0; corner < 4; ++corner)
  {
    const double around[2] = { std::nextafter(x[0], corner % 2 ? Infinite : -Infinite),
      std::nextafter(x[1], corner / 2 ? Infinite : -Infinite) };
    if (!std::isfinite(around[0]) || !std::isfinite(around[1]) || !holds(polygon, around))
    {
      return false;
    }
  }
  return true;
}

void PolygonClipper::clip(
  std::uint32_t site, const std::vector<std::uint32_t>& others, CellPolygon& cell)
{
  this->neighbours = &others;
  this->begin();
  for (std::size_t i = 0; i < others.size() && this->at != NoIndex; ++i)
  {
    this->cut(this->sites[site], static_cast<std::int64_t>(i));
  }
  this->write(cell);
}

void PolygonClipper::begin()
{
  const auto count = static_cast<Index>(this->polygon.size() / 2);
  this->nodes.resize(count);
  for (Index i = 0; i < count; ++i)
  {
    const double* const x = cornerOf(this->polygon, i);
    // -0 is 0
    this->nodes[i] = { { x[0] + 0.0, x[1] + 0.0 }, sideLine(i), i ? i - 1 : count - 1,
      i + 1 < count ? i + 1 : 0 };
  }
  this->at = 0;
}

CellLine PolygonClipper::lineOf(std::int64_t line) const
{
  if (line >= 0)
  {
    return { &this->sites[(*this->neighbours)[static_cast<std::size_t>(line)]], nullptr, nullptr };
  }
  const auto side = static_cast<std::size_t>(-1 - line);
  return { nullptr, cornerOf(this->polygon, side), cornerOf(this->polygon, side + 1) };
}

int PolygonClipper::sign(const CellCutter& cutter, Index corner) const
{
  const int quick = cutter.signOfRounded(this->nodes[corner].x);
  return quick != 0 ? quick
                    : cutter.sign(this->lineBefore(corner), this->lineOf(this->nodes[corner].line));
}

/// Uphill: a convex polygon has no other top.
PolygonClipper::Index PolygonClipper::farthest(const CellCutter& cutter) const
{
  Index corner = this->at;
  const auto rise = [&](Index from) { return cutter.rise(this->lineOf(this->nodes[from].line)); };
  if (rise(corner) > 0)
  {
    do
    {
      corner = this->nodes[corner].after;
    } while (rise(corner) > 0);
    return corner;
  }
  while (rise(this->nodes[corner].before) < 0)
  {
    corner = this->nodes[corner].before;
  }
  return corner;
}

/// Both ways from a corner beyond the line to the first that are not.
PolygonClipper::Kept PolygonClipper::keptBy(const CellCutter& cutter, Index beyond) const
{
  Kept kept;
  Index first = beyond;
  int signOfFirst = -1;
  do
  {
    first = this->nodes[first].after;
    if (first == beyond)
    {
      return kept;
    }
    signOfFirst = this->sign(cutter, first);
  } while (signOfFirst < 0);
  Index last = beyond;
  int signOfLast = -1;
  do
  {
    last = this->nodes[last].before;
    signOfLast = this->sign(cutter, last);
  } while (signOfLast < 0);
  // A corner or an edge on the line, and nothing within.
  const bool isFlat =
    signOfFirst == 0 && signOfLast == 0 && (first == last || this->nodes[first].after == last);
  return isFlat ? kept : Kept{ first, last, signOfFirst, signOfLast };
}

void PolygonClipper::cut(const PowerSite& site, std::int64_t line)
{
  const CellCutter cutter(site, *this->lineOf(line).other);
  const Index top = this->farthest(cutter);
  if (this->sign(cutter, top) >= 0)
  {
    this->at = top;
    return;
  }
  const Kept kept = this->keptBy(cutter, top);
  this->at = kept.first;
  if (kept.first == NoIndex)
  {
    return;
  }
  Index last = kept.last;
  if (kept.signOfLast > 0)
  {
    last = this->add(site, this->nodes[last].line, line);
    this->link(kept.last, last);
  }
  this->nodes[last].line = line;
  if (kept.signOfFirst > 0)
  {
    const std::int64_t edge = this->nodes[this->nodes[kept.first].before].line;
    this->at = this->add(site, line, edge);
    this->link(this->at, kept.first);
  }
  this->link(last, this->at);
}

PolygonClipper::Index PolygonClipper::add(
  const PowerSite& site, std::int64_t before, std::int64_t line)
{
  Node node = { { 0, 0 }, line, NoIndex, NoIndex };
  meetingOf(site, this->lineOf(before), this->lineOf(line), node.x);
  this->nodes.push_back(node);
  return static_cast<Index>(this->nodes.size() - 1);
}

void PolygonClipper::link(Index a, Index b)
{
  this->nodes[a].after = b;
  this->nodes[b].before = a;
}

void PolygonClipper::write(CellPolygon& cell) const
{
  cell.clear();
  if (this->at == NoIndex)
  {
    return;
  }
  // From the first neighbour's edge, else from the polygon's first corner.
  const auto rank = [this](Index corner)
  {
    const std::int64_t line = this->nodes[corner].line;
    return line >= 0 ? line : static_cast<std::int64_t>(NoIndex) - line;
  };
  Index start = this->at;
  for (Index i = this->nodes[this->at].after; i != this->at; i = this->nodes[i].after)
  {
    start = rank(i) < rank(start) ? i : start;
  }
  Index i = start;
  do
  {
    const Node& node = this->nodes[i];
    cell.push_back(finiteCorner(node.x[0], node.x[1], node.line));
    i = node.after;
  } while (i != start);
}

}
