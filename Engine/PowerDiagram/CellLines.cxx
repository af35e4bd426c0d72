// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PowerDiagram/CellLines.h"

#include "PowerDiagram/SiteRange.h"
#include "Predicates/ErrorBounds.h"

#include <cmath>

namespace flipflop
{

namespace
{

template <class Arithmetic>
struct LineNumbers
{
  using Number = typename Arithmetic::Number;

  Number n[2];
  Number c;

  LineNumbers(const Arithmetic& k, const PowerSite& site, const CellLine& line)
    : LineNumbers(
        line.other ? LineNumbers(k, site, *line.other) : LineNumbers(k, site, line.from, line.to))
  {
  }

  LineNumbers(const Arithmetic& k, const PowerSite& site, const PowerSite& other)
    : n{ k.difference(other.x[0], site.x[0]), k.difference(other.x[1], site.x[1]) }
    , c(n[0] * n[0] + n[1] * n[1] - k.difference(other.weight, site.weight, 2))
  {
  }

private:
  LineNumbers(const Arithmetic& k, const PowerSite& site, const double* from, const double* to)
    : n{ k.difference(to[1], from[1]), k.difference(from[0], to[0]) }
    , c(n[0] * k.difference(from[0], site.x[0]) + n[1] * k.difference(from[1], site.x[1]))
  {
    this->c = this->c + this->c;
  }
};

/// Two lines' meeting: twice the position, times the denominator, which is positive.
template <class Arithmetic>
struct Meeting
{
  using Number = typename Arithmetic::Number;
  using Line = LineNumbers<Arithmetic>;

  Number position[2];
  Number denominator;

  Meeting(const Line& a, const Line& b)
    : position{ a.c * b.n[1] - b.c * a.n[1], b.c * a.n[0] - a.c * b.n[0] }
    , denominator(a.n[0] * b.n[1] - a.n[1] * b.n[0])
  {
  }
};

template <class Arithmetic, class LineTo>
bool meeting(
  const Arithmetic& k, const PowerSite& site, const LineTo& a, const LineTo& b, double* result)
{
  using Line = LineNumbers<Arithmetic>;
  const Meeting<Arithmetic> found(Line(k, site, a), Line(k, site, b));
  const auto twice = found.denominator + found.denominator;
  return k.positive(twice) && k.round(site.x[0], found.position[0], twice, result[0]) &&
    k.round(site.x[1], found.position[1], twice, result[1]);
}

/// Positive where they ascend.
int orderOf(double a, double b)
{
  return (a < b) - (b < a);
}

/// Nearly all centers come of this.
FF_FLATTEN bool quickCenter(
  const PowerSite& site, const PowerSite& b, const PowerSite& c, double* position)
{
  return meeting(BoundedArithmetic<>(), site, b, c, position);
}

void addLine(ExponentRange& range, const CellLine& line)
{
  if (line.other)
  {
    addSite(range, *line.other);
    return;
  }
  for (int k = 0; k < 2; ++k)
  {
    range.add(line.from[k]);
    range.add(line.to[k]);
  }
}

template <class... Lines>
ExponentRange rangeOfLines(const PowerSite& site, const Lines&... lines)
{
  ExponentRange range;
  addSite(range, site);
  (addLine(range, lines), ...);
  return range;
}

/// In integers.
void meetingExactly(const PowerSite& site, const CellLine& a, const CellLine& b, double* position)
{
  decide(rangeOfLines(site, a, b), [&](const auto& k) { return meeting(k, site, a, b, position); });
}

/// Where a line of equal power has the value @p at on an axis: the other coordinate.
template <class Arithmetic>
bool crossing(const Arithmetic& k, const PowerSite& site, const PowerSite& other, int axis,
  double at, double& result)
{
  const LineNumbers<Arithmetic> line(k, site, other);
  const auto along = line.n[axis] * k.difference(at, site.x[axis]);
  const auto& across = line.n[1 - axis];
  return k.round(site.x[1 - axis], line.c - (along + along), across + across, result);
}

/// Nearly all corners on a box's border come of this.
FF_FLATTEN bool quickCrossing(
  const PowerSite& site, const PowerSite& other, int axis, double at, double& result)
{
  return crossing(BoundedArithmetic<>(), site, other, axis, at, result);
}

/// The meeting with a line along an axis, as sides of boxes are: one coordinate is given.
/// @return false: that line has none
bool meetingAlongAxis(
  const PowerSite& site, const CellLine& line, const PowerSite& other, double* position)
{
  const int axis = line.other    ? 2
    : line.from[0] == line.to[0] ? 0
    : line.from[1] == line.to[1] ? 1
                                 : 2;
  if (axis == 2)
  {
    return false;
  }
  const double at = line.from[axis];
  double& across = position[1 - axis];
  position[axis] = at;
  if (!quickCrossing(site, other, axis, at, across))
  {
    decide(rangeOfLines(site, lineTo(other), line),
      [&](const auto& k) { return crossing(k, site, other, axis, at, across); });
  }
  return true;
}

}

void meetingOf(const PowerSite& site, const CellLine& a, const CellLine& b, double* position)
{
  const bool isFound = (a.other && meetingAlongAxis(site, b, *a.other, position)) ||
    (b.other && meetingAlongAxis(site, a, *b.other, position)) ||
    meeting(BoundedArithmetic<>(), site, a, b, position);
  if (!isFound)
  {
    meetingExactly(site, a, b, position);
  }
  position[0] += 0.0; // -0 is 0
  position[1] += 0.0;
}

void centerOf(const PowerSite& site, const PowerSite& b, const PowerSite& c, double* position)
{
  if (!quickCenter(site, b, c, position))
  {
    meetingExactly(site, lineTo(b), lineTo(c), position);
  }
  position[0] += 0.0; // -0 is 0
  position[1] += 0.0;
}

int sideOfMeeting(
  const PowerSite& site, const CellLine& a, const CellLine& b, const CellLine& third)
{
  return exactSign(
    [&](const auto& k, int& sign)
    {
      using Arithmetic = std::decay_t<decltype(k)>;
      using Line = LineNumbers<Arithmetic>;
      const Meeting<Arithmetic> found(Line(k, site, a), Line(k, site, b));
      const Line cut(k, site, third);
      return k.sign(
        cut.c * found.denominator - cut.n[0] * found.position[0] - cut.n[1] * found.position[1],
        sign);
    },
    [&] { return rangeOfLines(site, a, b, third); });
}

CellCutter::CellCutter(const PowerSite& site, const PowerSite& other)
  : center(site)
  , own(lineTo(other))
  , normal{ 2 * (other.x[0] - site.x[0]), 2 * (other.x[1] - site.x[1]) }
  , level(0.25 * (normal[0] * normal[0] + normal[1] * normal[1]) - (other.weight - site.weight))
  , levelSize(0.25 * (normal[0] * normal[0] + normal[1] * normal[1]) + std::fabs(other.weight) +
      std::fabs(site.weight))
{
}

int CellCutter::signOfRounded(const double* x) const
{
  double sum = this->level;
  double size = this->levelSize;
  for (int k = 0; k < 2; ++k)
  {
    const double way = x[k] - this->center.x[k];
    sum -= this->normal[k] * way;
    // The position itself is off by half a unit, and that by no less than of the least normal
    // number.
    size += std::fabs(this->normal[k]) * (std::fabs(way) + std::fabs(x[k]) + 0x1p-1022);
  }
  const double error = CutError * size;
  // What underflows is less by far; what overflows or is NaN is not certain.
  const bool isCertain = error > CutFloor && error < 0x1p1000 && std::fabs(sum) > error;
  return isCertain ? (sum > 0 ? 1 : -1) : 0;
}

int CellCutter::rise(const CellLine& edge) const
{
  // An edge's way is its normal, turned to the left; this is its product with the line's normal.
  const double* const x = this->center.x;
  const int right =
    edge.other ? orderOf(edge.other->x[1], x[1]) : orderOf(edge.from[0], edge.to[0]);
  const int up = edge.other ? orderOf(x[0], edge.other->x[0]) : orderOf(edge.from[1], edge.to[1]);
  const int alongX = right * orderOf(x[0], this->own.other->x[0]);
  const int alongY = up * orderOf(x[1], this->own.other->x[1]);
  if (alongX * alongY >= 0)
  {
    return alongX != 0 ? alongX : alongY;
  }
  return exactSign(
    [&](const auto& k, int& sign)
    {
      using Line = LineNumbers<std::decay_t<decltype(k)>>;
      const Line along(k, this->center, edge);
      const Line cut(k, this->center, this->own);
      return k.sign(cut.n[1] * along.n[0] - cut.n[0] * along.n[1], sign);
    },
    [&] { return rangeOfLines(this->center, edge, this->own); });
}

}
