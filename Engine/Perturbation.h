// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Simulation of Simplicity for the 3D orientation (H. Edelsbrunner, E. P. Mucke, 1990).
///
/// Coordinate j of the point with rank i (by id) is moved by e^(2^(3i + j)), e infinitesimal. The
/// perturbed determinant of the rows (x, y, z, 1) is a polynomial in e; its sign is that of the
/// first non-zero coefficient, and a coefficient is a minor: the rows and columns of the moved
/// entries are struck out. Read as bits 3i + j, the moved entries of the terms in order of size are
/// the integers 0, 1, 2, ... that strike no row or column twice. The one that strikes rows 0, 1, 2
/// leaves the constant 1, so the last row is never moved: the kernel point may stand there as it
/// is.
#ifndef flipflop_Perturbation_h
#define flipflop_Perturbation_h

#include "ExactSigns.h"
#include "HostDevice.h"

#include <cstdint>

namespace flipflop
{

namespace detail
{

struct PerturbationTerm
{
  std::int8_t rows[3];    ///< rows that remain (of 4), -1 behind the last
  std::int8_t columns[2]; ///< coordinates that remain, -1 behind the last
  std::int8_t sign;
};

struct PerturbationTable
{
  PerturbationTerm term[17] = {};
  int count = 0;
};

constexpr PerturbationTable makePerturbationTable()
{
  PerturbationTable table;
  for (int mask = 1;; ++mask)
  {
    bool rowUsed[4] = {};
    bool columnUsed[3] = {};
    bool valid = true;
    int sign = 1;
    int struck = 0;
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 3; ++column)
      {
        if (mask >> (3 * row + column) & 1)
        {
          valid = valid && !rowUsed[row] && !columnUsed[column];
          // Position of the entry in what the earlier strikes left.
          int place = row - struck;
          for (int c = 0; c < column; ++c)
          {
            place += columnUsed[c] ? 0 : 1;
          }
          sign = place % 2 ? -sign : sign;
          rowUsed[row] = true;
          columnUsed[column] = true;
          ++struck;
        }
      }
    }
    if (!valid)
    {
      continue;
    }
    PerturbationTerm& term = table.term[table.count++];
    term.rows[0] = term.rows[1] = term.rows[2] = -1;
    term.columns[0] = term.columns[1] = -1;
    term.sign = static_cast<std::int8_t>(sign);
    int n = 0;
    for (int row = 0; row < 4; ++row)
    {
      if (!rowUsed[row])
      {
        term.rows[n++] = static_cast<std::int8_t>(row);
      }
    }
    n = 0;
    for (int column = 0; column < 3; ++column)
    {
      if (!columnUsed[column])
      {
        term.columns[n++] = static_cast<std::int8_t>(column);
      }
    }
    if (struck == 3)
    {
      return table;
    }
  }
}

}

/// Sign of the perturbed det of the rows (r0, 1), (r1, 1), (r2, 1), last, whose unperturbed value
/// is zero. The rows are in ascending order of id; never zero.
template <class Signs, int Count>
FF_HD int perturbedSign(
  const double* r0, const double* r1, const double* r2, const Row<Count>& last)
{
  constexpr detail::PerturbationTable table = detail::makePerturbationTable();
  const double* rows[3] = { r0, r1, r2 };
  for (int i = 0; i < table.count; ++i)
  {
    const detail::PerturbationTerm& term = table.term[i];
    int sign = 1; // the empty minor: the last row's one
    if (term.columns[1] >= 0)
    {
      sign = Signs::orient2(
        rows[term.rows[0]], rows[term.rows[1]], last, term.columns[0], term.columns[1]);
    }
    else if (term.columns[0] >= 0)
    {
      sign = Signs::compare(rows[term.rows[0]], last, term.columns[0]);
    }
    if (sign != 0)
    {
      return term.sign * sign;
    }
  }
  return 0;
}

}

#endif
