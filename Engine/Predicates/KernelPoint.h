// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where the kernel point is: at a position that a double names, or at the exact centroid of four
/// points, which none need name (see DeterminantRow).
#ifndef flipflop_KernelPoint_h
#define flipflop_KernelPoint_h

#include "Points/Vertex.h"
#include "Predicates/ExactSigns.h"

namespace flipflop
{

/// @tparam Axes 3, or 2 for a position in the plane
template <int Axes>
class KernelPoint
{
public:
  void set(const double* point)
  {
    this->symbolic = false;
    for (int i = 0; i < Axes; ++i)
    {
      this->s[i] = point[i];
    }
  }

  void setCentroid(const Vertex* corners)
  {
    this->symbolic = true;
    for (int i = 0; i < Axes; ++i)
    {
      for (int k = 0; k < 4; ++k)
      {
        this->corner[k][i] = corners[k].x[i];
      }
      this->s[i] = (0.25 * corners[0].x[i] + 0.25 * corners[1].x[i]) +
        (0.25 * corners[2].x[i] + 0.25 * corners[3].x[i]);
    }
  }

  /// Rounded when it is symbolic.
  FF_HD const double* coordinates() const { return this->s; }
  FF_HD bool isSymbolic() const { return this->symbolic; }

  /// use (row): with the row that stands for it in a determinant.
  template <class Use>
  FF_HD int asDeterminantRow(Use&& use) const
  {
    if (this->symbolic)
    {
      return use(DeterminantRow<4>{
        { this->corner[0], this->corner[1], this->corner[2], this->corner[3] } });
    }
    return use(DeterminantRow<1>{ { this->s } });
  }

private:
  double s[Axes] = {};
  double corner[4][Axes] = {};
  bool symbolic = false;
};

}

#endif
