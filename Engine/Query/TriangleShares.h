// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The shares of corners at many positions strictly inside triangles, computed side by side.
///
/// The area opposite a corner is a cross product of differences from the position, which are exact
/// in double-double; so is the product but for its last bits, see plane-values. A position that it
/// does not serve (an area is small against its terms, or far from 1) is reported.
#ifndef flipflop_TriangleShares_h
#define flipflop_TriangleShares_h

#include <cstdint>

namespace flipflop
{

class TriangleShares
{
public:
  static constexpr int Capacity = 128;

  int size() const { return this->count; }
  bool isFull() const { return this->count == Capacity; }
  void clear() { this->count = 0; }

  /// @param a, b, c x and y of the corners, counter-clockwise; @p p of the position
  void add(const double* a, const double* b, const double* c, const double* p)
  {
    const double* const from[] = { a, b, c, p };
    for (int k = 0; k < 4; ++k)
    {
      this->given[2 * k][this->count] = from[k][0];
      this->given[2 * k + 1][this->count] = from[k][1];
    }
    ++this->count;
  }

  /// Of all that were added.
  void compute();

  /// Is the result of one right?
  bool isDone(int i) const { return this->done[i] > 0; }
  /// Off by three units of 2^-53 at most, of itself.
  double share(int i, int corner) const { return this->shares[corner][i]; }
  /// Of the position.
  double coordinate(int i, int axis) const { return this->given[6 + axis][i]; }

private:
  double given[8][Capacity] = {}; ///< x and y of a, b, c and p
  double shares[3][Capacity];
  double done[Capacity];
  int count = 0;
};

}

#endif
