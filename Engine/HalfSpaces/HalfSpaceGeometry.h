// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The geometry of half-spaces, a model of the concept in GeometryConcept.h: their dual points,
/// seen from the origin, which is the dual of the plane at infinity.
///
/// No dual point is computed for a sign. The orientation of four is the determinant of their rows
/// over the product of their depths, which are positive; that of three and the origin is the
/// determinant of their normals. A vertex's coordinates are its dual point rounded, a different one
/// for each half-space: they serve orders and duplicates alone.
///
/// Ties are broken by Simulation of Simplicity: every number of a row is moved, those of lower ids
/// more (Perturbation.h). The origin stays inside, for depths are positive.
#ifndef flipflop_HalfSpaceGeometry_h
#define flipflop_HalfSpaceGeometry_h

#include "HalfSpaces/HalfSpaceRow.h"
#include "Points/Vector3.h"
#include "Points/Vertex.h"
#include "Predicates/Perturbation.h"
#include "Predicates/PredicateSteps.h"

#include <cstdint>

namespace flipflop
{

class HalfSpaceGeometry : public PredicateSteps<HalfSpaceGeometry>
{
public:
  static constexpr bool AllExtreme = false;

  HalfSpaceGeometry() = default;

  /// @param table by id; it must outlive this
  explicit HalfSpaceGeometry(const HalfSpaceRow* table)
    : rows(table)
  {
  }

  bool filterAbove(
    const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p, int& sign) const
  {
    const HalfSpaceRow* const row[4] = { this->rowOf(a), this->rowOf(b), this->rowOf(c),
      this->rowOf(p) };
    // det[b - a; c - a; p - a] = -det of the rows (a, 1), (b, 1), (c, 1), (p, 1), along the ones.
    return BoundedArithmetic<double>::sign(row[0]->depth * normalsMinor(row[1], row[2], row[3]) -
        row[1]->depth * normalsMinor(row[0], row[2], row[3]) +
        row[2]->depth * normalsMinor(row[0], row[1], row[3]) -
        row[3]->depth * normalsMinor(row[0], row[1], row[2]),
      sign);
  }

  bool filterKernelBeneath(const Vertex& a, const Vertex& b, const Vertex& c, int& sign) const
  {
    const HalfSpaceRow* const row[3] = { this->rowOf(a), this->rowOf(b), this->rowOf(c) };
    return BoundedArithmetic<double>::sign(normalsMinor(row[0], row[1], row[2]), sign);
  }

  int exactAbove(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p) const
  {
    ++this->counts.exact;
    const HalfSpaceRow* const row[4] = { this->rowOf(a), this->rowOf(b), this->rowOf(c),
      this->rowOf(p) };
    return -exactDeterminantSign<4>(row, RowColumns);
  }

  int exactKernelBeneath(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    ++this->counts.exact;
    const HalfSpaceRow* const row[3] = { this->rowOf(a), this->rowOf(b), this->rowOf(c) };
    return exactDeterminantSign<3>(row, RowColumns);
  }

  int tieAbove(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p) const
  {
    const Vertex* corner[4] = { &a, &b, &c, &p };
    return -this->tie<4>(corner);
  }

  int tieKernelBeneath(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    const Vertex* corner[3] = { &a, &b, &c };
    return this->tie<3>(corner);
  }

  /// The perturbation decides.
  bool mayAppearOn(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p) const
  {
    return this->perturbedAbove(a, b, c, p) > 0;
  }

  /// Do the dual points lie on a line? Do all minors of their rows vanish?
  bool collinear(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    const HalfSpaceRow* const row[3] = { this->rowOf(a), this->rowOf(b), this->rowOf(c) };
    for (int omitted = 0; omitted < 4; ++omitted)
    {
      const int columns[3] = { omitted > 0 ? 0 : 1, omitted > 1 ? 1 : 2, omitted > 2 ? 2 : 3 };
      if (exactDeterminantSign<3>(row, columns) != 0)
      {
        return false;
      }
    }
    return true;
  }

private:
  /// The determinant of three normals.
  static Bounded<double> normalsMinor(
    const HalfSpaceRow* a, const HalfSpaceRow* b, const HalfSpaceRow* c)
  {
    return { dot(cross(a->number, b->number), c->number),
      DeterminantError * a->size * b->size * c->size };
  }

  const HalfSpaceRow* rowOf(const Vertex& v) const { return this->rows + v.id; }

  /// The sign of the perturbed determinant of rows, whose unperturbed value is zero. Never zero.
  template <int Size>
  int tie(const Vertex* (&corner)[Size]) const
  {
    const int sign = sortById(corner);
    const HalfSpaceRow* row[Size];
    for (int i = 0; i < Size; ++i)
    {
      row[i] = this->rowOf(*corner[i]);
    }
    bool isStruck[Size] = {};
    return sign * firstMinor<Size, Size>(row, isStruck, Size - 1, 1);
  }

  /// The first term that is not zero: the number of column j in the row of rank i is moved by
  /// e^(2^(4i + j)). In terms of ascending size a row of higher rank changes last: of each row no
  /// number is struck, or one from the first column on.
  /// @tparam Left     rows and columns that are not struck
  /// @param row       those before @p rank, and what remains of the others behind them
  /// @param rank      the row to be decided
  /// @param sign      of the numbers that are struck
  template <int Size, int Left>
  static int firstMinor(const HalfSpaceRow* const* row, bool (&isStruck)[Size], int rank, int sign)
  {
    if (rank < 0)
    {
      int columns[Left > 0 ? Left : 1];
      for (int column = 0, n = 0; column < Size; ++column)
      {
        if (!isStruck[column])
        {
          columns[n++] = column;
        }
      }
      return sign * exactDeterminantSign<Left>(row, columns);
    }
    const int kept = firstMinor<Size, Left>(row, isStruck, rank - 1, sign);
    if (kept != 0)
    {
      return kept;
    }
    if constexpr (Left > 0)
    {
      const HalfSpaceRow* rest[Left > 1 ? Left - 1 : 1];
      for (int i = 0; i < Left - 1; ++i)
      {
        rest[i] = row[i < rank ? i : i + 1];
      }
      for (int column = 0, index = rank; column < Size; ++column)
      {
        if (!isStruck[column])
        {
          isStruck[column] = true;
          const int found =
            firstMinor<Size, Left - 1>(rest, isStruck, rank - 1, index++ % 2 ? -sign : sign);
          isStruck[column] = false;
          if (found != 0)
          {
            return found;
          }
        }
      }
    }
    return 0;
  }

  const HalfSpaceRow* rows = nullptr;
};

}

#endif
