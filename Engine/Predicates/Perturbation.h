// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Simulation of Simplicity (SoS) for orientations (H. Edelsbrunner, E. P. Mucke, 1990).
///
/// Every coordinate of every point is moved by a power of e, infinitesimal, each so much smaller
/// than the one before that it counts for less than any product of those. The perturbed determinant
/// of the rows (coordinates, 1) is a polynomial in e; its sign is that of the first non-zero
/// coefficient, and a coefficient is a minor: the rows and columns of the moved entries are struck
/// out. With the moved entries numbered by size, and read as bits, the terms in order of size are
/// the integers 0, 1, 2, ... that strike no row or column twice. The term that strikes all columns
/// is constant; no later one is needed. Where it leaves the last row, that row need not be moved at
/// all: the kernel point may stand there as it is.
///
/// Which coordinate is moved more than which is an Order's choice; rows are ranked by id.
#ifndef flipflop_Perturbation_h
#define flipflop_Perturbation_h

#include "Points/Vertex.h"
#include "Predicates/ExactSigns.h"
#include "Support/HostDevice.h"

#include <cstdint>

namespace flipflop
{

/// Points in space: coordinate j of rank i is moved by e^(2^(3i + j)).
struct MovedByPoint
{
  static constexpr int Columns = 3;
  static constexpr int row(int entry) { return entry / 3; }
  static constexpr int column(int entry) { return entry % 3; }
};

/// Points in the plane: coordinate j of rank i by e^(2^(2i + j)).
struct MovedInPlane
{
  static constexpr int Columns = 2;
  static constexpr int row(int entry) { return entry / 2; }
  static constexpr int column(int entry) { return entry % 2; }
};

/// Lifted points, in the order of the moves: the heights of all four rows first (entries 0 to 3),
/// each by rank; then the positions, as in MovedInPlane. A height's minor is an orientation in the
/// plane. So a tie of four points no three of which are collinear is decided by one such
/// orientation.
struct MovedByHeight
{
  static constexpr int Columns = 3;
  static constexpr int row(int entry) { return entry < 4 ? entry : MovedInPlane::row(entry - 4); }
  static constexpr int column(int entry) { return entry < 4 ? 2 : MovedInPlane::column(entry - 4); }
};

namespace detail
{

struct PerturbationTerm
{
  std::int8_t rows[3];    ///< rows that remain, -1 behind the last
  std::int8_t columns[2]; ///< coordinates that remain, -1 behind the last
  std::int8_t sign;
};

struct PerturbationTable
{
  PerturbationTerm term[20] = {};
  int count = 0;
};

template <class Order>
constexpr PerturbationTable makePerturbationTable()
{
  constexpr int Size = Order::Columns + 1;
  PerturbationTable table;
  for (int mask = 1;; ++mask)
  {
    bool struckRow[Size] = {};
    bool struckColumn[Size] = {};
    int columnOf[Size] = {};
    int struck = 0;
    bool valid = true;
    for (int entry = 0; mask >> entry; ++entry)
    {
      if (mask >> entry & 1)
      {
        const int row = Order::row(entry);
        const int column = Order::column(entry);
        valid = valid && !struckRow[row] && !struckColumn[column];
        struckRow[row] = true;
        struckColumn[column] = true;
        columnOf[row] = column;
        ++struck;
      }
    }
    if (!valid)
    {
      continue;
    }
    PerturbationTerm& term = table.term[table.count++];
    term.rows[0] = term.rows[1] = term.rows[2] = -1;
    term.columns[0] = term.columns[1] = -1;
    // Strike row by row; an entry's position counts in what the earlier strikes left.
    bool left[Size] = {};
    int sign = 1;
    int above = 0;
    int n = 0;
    for (int row = 0; row < Size; ++row)
    {
      if (!struckRow[row])
      {
        term.rows[n++] = static_cast<std::int8_t>(row);
        continue;
      }
      int index = row - above++;
      for (int c = 0; c < columnOf[row]; ++c)
      {
        index += left[c] ? 0 : 1;
      }
      left[columnOf[row]] = true;
      sign = index % 2 ? -sign : sign;
    }
    n = 0;
    for (int column = 0; column < Order::Columns; ++column)
    {
      if (!struckColumn[column])
      {
        term.columns[n++] = static_cast<std::int8_t>(column);
      }
    }
    term.sign = static_cast<std::int8_t>(sign);
    if (struck == Order::Columns)
    {
      return table;
    }
  }
}

/// The minor of one term. @p last is the determinant's last row, and remains unless it is struck.
template <class Signs, int Count>
FF_HD FF_OUTLINED int minorSign(
  const PerturbationTerm& term, const double* const* rows, const DeterminantRow<Count>& last)
{
  if (term.columns[1] >= 0)
  {
    return Signs::orient2(
      rows[term.rows[0]], rows[term.rows[1]], last, term.columns[0], term.columns[1]);
  }
  if (term.columns[0] >= 0)
  {
    return Signs::compare(rows[term.rows[0]], last, term.columns[0]);
  }
  return 1; // the empty minor: a row's one
}

}

/// Sort rows by id; -1 when that takes an odd number of exchanges, else 1.
template <int Count>
FF_HD int sortById(const Vertex* (&row)[Count])
{
  int sign = 1;
  for (int end = Count - 1; end > 0; --end)
  {
    for (int i = 0; i < end; ++i)
    {
      if (row[i]->id > row[i + 1]->id)
      {
        const Vertex* other = row[i];
        row[i] = row[i + 1];
        row[i + 1] = other;
        sign = -sign;
      }
    }
  }
  return sign;
}

/// The term that decides most ties of "above": the vertex of lowest id is moved most, in the first
/// coordinate (lifted: in its height). Its row and that column are struck out, so the tie's sign is
/// @p sign times the orientation of the three others in the two other coordinates. Where that is
/// zero, a later term decides.
struct FirstTerm
{
  const Vertex* rest[3];
  int sign;
};

FF_HD inline FirstTerm firstTermOf(
  const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p)
{
  const bool inFront = (a.id < b.id ? a.id : b.id) < (c.id < p.id ? c.id : p.id);
  if (inFront)
  {
    return a.id < b.id ? FirstTerm{ { &b, &c, &p }, -1 } : FirstTerm{ { &a, &c, &p }, 1 };
  }
  return c.id < p.id ? FirstTerm{ { &a, &b, &p }, -1 } : FirstTerm{ { &a, &b, &c }, 1 };
}

/// Sign of the perturbed determinant of the rows (r, 1) and last, whose unperturbed value is zero.
/// Never zero.
/// @tparam Order Columns + 1 rows
/// @param rows   all but the last, in ascending order of id
template <class Signs, class Order, int Count>
FF_HD FF_OUTLINED int perturbedSign(const double* const* rows, const DeterminantRow<Count>& last)
{
  constexpr detail::PerturbationTable table = detail::makePerturbationTable<Order>();
  constexpr int Last = Order::Columns;
  for (int i = 0; i < table.count; ++i)
  {
    const detail::PerturbationTerm& term = table.term[i];
    const int remaining = term.columns[1] >= 0 ? 3 : (term.columns[0] >= 0 ? 2 : 1);
    const int lowest = term.rows[remaining - 1];
    const int sign = lowest == Last
      ? detail::minorSign<Signs>(term, rows, last)
      : detail::minorSign<Signs>(term, rows, DeterminantRow<1>{ { rows[lowest] } });
    if (sign != 0)
    {
      return term.sign * sign;
    }
  }
  return 0;
}

}

#endif
