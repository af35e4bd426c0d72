// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The lines that bound a power cell, where two of them meet, and on which side of a third that is:
/// exact at any scale.
///
/// A line is 2 n.x = c for positions x relative to the cell's site, and the cell has 2 n.x <= c.
/// Two lines that turn left, D = n1 x n2 > 0, meet at (c1 n2y - c2 n1y, c2 n1x - c1 n2x) / 2D. That
/// position is within a third line where
///
///     | n1x n1y c1 |
///     | n2x n2y c2 |
///     | n3x n3y c3 |
///
/// is positive.
///
/// A coordinate is first taken in double-double with a running error bound; where that leaves two
/// doubles to choose from (halfway between them, often on grids, or at zero), it is taken in
/// integers. So equal corners get equal bits whichever lines they are taken from, and rounding,
/// being monotone, keeps the order of corners along each axis.
#ifndef flipflop_CellLines_h
#define flipflop_CellLines_h

#include "PowerDiagram/PowerSite.h"

namespace flipflop
{

/// The line of equal power to a cell's site and another, or the line through two positions.
struct CellLine
{
  const PowerSite* other; ///< null: through two positions
  const double* from;     ///< with the cell on the left of the way from one to the other
  const double* to;
};

/// Of equal power to a site.
inline CellLine lineTo(const PowerSite& other)
{
  return { &other, nullptr, nullptr };
}

/// Where two lines of the cell of @p site meet, each coordinate rounded to nearest; one beyond the
/// doubles is infinite with its sign. They turn left.
void meetingOf(const PowerSite& site, const CellLine& a, const CellLine& b, double* position);

/// The same for two lines of equal power: the point of equal power to three sites.
/// @throw Error BadArgument where these do not turn left
void centerOf(const PowerSite& site, const PowerSite& b, const PowerSite& c, double* position);

/// Of two lines of the cell of @p site, which turn left, the meeting is within a third line: 1, on
/// it: 0, beyond: -1.
int sideOfMeeting(
  const PowerSite& site, const CellLine& a, const CellLine& b, const CellLine& third);

/// A line of equal power that cuts the cell of a site.
class CellCutter
{
public:
  CellCutter(const PowerSite& site, const PowerSite& other);

  /// Is a position certainly within the line: 1, or beyond: -1? Else 0.
  /// @param x the position, each coordinate rounded to nearest
  int signOfRounded(const double* x) const;

  /// The meeting of two lines, which turn left, is within the line: 1, on it: 0, beyond: -1.
  int sign(const CellLine& a, const CellLine& b) const
  {
    return sideOfMeeting(this->center, a, b, this->own);
  }

  /// Does the way along an edge, counter-clockwise, come nearer to what is beyond: 1, or leave it:
  /// -1? 0: neither.
  int rise(const CellLine& edge) const;

private:
  const PowerSite& center;
  const CellLine own;
  double normal[2]; ///< rounded, twice the way to the other site
  double level;
  double levelSize; ///< of what the level is summed from
};

}

#endif
