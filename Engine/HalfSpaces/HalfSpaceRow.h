// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Half-spaces as rows of numbers, and determinants of rows.
///
/// A half-space is normal . x <= bound. From an interior point c its depth is
/// bound - normal . c > 0, and its dual point normal / depth. Depths instead of bounds in the last
/// column change no determinant of four rows: they differ by a combination of the other columns.
/// So exact signs use bounds, the caller's numbers; rounded ones use depths, which do not cancel
/// where c is far from the origin.
#ifndef flipflop_HalfSpaceRow_h
#define flipflop_HalfSpaceRow_h

#include "Predicates/RoundedFractions.h"

#include <cstdint>

namespace flipflop
{

struct HalfSpaceRow
{
  double number[4]; ///< the normal, of which the largest is from 1 to 2 where that is exact; bound
  double size;      ///< the largest number of the normal; infinite beyond the filter's range
  Bounded<double> depth;
  Bounded<DoubleDouble> farDepth; ///< the same in double-double
};

/// Is the normal zero? Then all positions are inside, or none: there is no border.
inline bool hasNoNormal(const double* row)
{
  return row[0] == 0 && row[1] == 0 && row[2] == 0;
}

/// An entry of a row, in an arithmetic. The last column is the depth, or the bound.
/// @{
inline Bounded<double> entryOf(
  const BoundedArithmetic<double>& k, const HalfSpaceRow& row, int column)
{
  return column < 3 ? k.difference(row.number[column], 0.0) : row.depth;
}
inline Bounded<DoubleDouble> entryOf(
  const BoundedArithmetic<>& k, const HalfSpaceRow& row, int column)
{
  return column < 3 ? k.difference(row.number[column], 0.0) : row.farDepth;
}
template <class Integer>
Integer entryOf(const IntegerArithmetic<Integer>& k, const HalfSpaceRow& row, int column)
{
  return k.difference(row.number[column], 0.0);
}
/// @}

/// The determinant of rows in some columns: along its last row.
template <int Size, class Arithmetic>
auto determinant(const Arithmetic& k, const HalfSpaceRow* const* rows, const int* columns)
{
  if constexpr (Size == 0)
  {
    return k.whole(1);
  }
  else if constexpr (Size == 1)
  {
    return entryOf(k, *rows[0], columns[0]);
  }
  else
  {
    auto sum = k.whole(0);
    for (int j = 0; j < Size; ++j)
    {
      int others[Size - 1];
      for (int i = 0; i < Size - 1; ++i)
      {
        others[i] = columns[i < j ? i : i + 1];
      }
      const auto term =
        entryOf(k, *rows[Size - 1], columns[j]) * determinant<Size - 1>(k, rows, others);
      sum = (Size - 1 + j) % 2 ? sum - term : sum + term;
    }
    return sum;
  }
}

/// Is a column all zeros? So are those of half-spaces of the plane.
template <int Size>
bool hasZeroColumn(const HalfSpaceRow* const* rows, const int* columns)
{
  for (int j = 0; j < Size; ++j)
  {
    bool isZero = true;
    for (int i = 0; i < Size; ++i)
    {
      isZero = isZero && rows[i]->number[columns[j]] == 0;
    }
    if (isZero)
    {
      return true;
    }
  }
  return false;
}

/// Its sign; false where an arithmetic cannot decide.
template <int Size, class Arithmetic>
bool determinantSign(
  const Arithmetic& k, const HalfSpaceRow* const* rows, const int* columns, int& sign)
{
  return k.sign(determinant<Size>(k, rows, columns), sign);
}

/// Its sign, exactly.
template <int Size>
int exactDeterminantSign(const HalfSpaceRow* const* rows, const int* columns)
{
  if (hasZeroColumn<Size>(rows, columns))
  {
    return 0;
  }
  return exactSign([&](const auto& k, int& sign)
    { return determinantSign<Size>(k, rows, columns, sign); },
    [&]
    {
      ExponentRange range;
      for (int i = 0; i < Size; ++i)
      {
        for (int j = 0; j < Size; ++j)
        {
          range.add(rows[i]->number[columns[j]]);
        }
      }
      return range;
    });
}

constexpr int RowColumns[4] = { 0, 1, 2, 3 };

/// bound - normal . c, of degree two.
template <class Arithmetic>
auto depthAt(const Arithmetic& k, const double* row, const double* c)
{
  auto depth = k.difference(row[3], 0.0, 2);
  for (int i = 0; i < 3; ++i)
  {
    depth = depth - k.difference(row[i], 0.0) * k.difference(c[i], 0.0);
  }
  return depth;
}

/// Of lengths that are multiples of 2 to its exponent, bounds are of its square.
inline ExponentRange rangeAt(const double* row, const double* c)
{
  ExponentRange range;
  range.add(1.0);
  for (int i = 0; i < 4; ++i)
  {
    range.add(row[i]);
    range.add(i < 3 ? c[i] : 0.0);
  }
  return range;
}

/// The sign of the depth at c, exactly: positive inside.
inline int depthSign(const double* row, const double* c)
{
  return exactSign([&](const auto& k, int& sign) { return k.sign(depthAt(k, row, c), sign); },
    [&] { return rangeAt(row, c); });
}

}

#endif
