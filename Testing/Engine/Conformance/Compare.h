// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Run the engine and hold what it says to a reference, cell by cell.
#ifndef flipflop_test_Compare_h
#define flipflop_test_Compare_h

#include "Testing/Engine/References/Reference.h"
#include <flipflop/ConvexHull.h>
#include <flipflop/Validate.h>

#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace flipflop
{

/// For GoogleTest's messages.
inline void PrintTo(Fault fault, std::ostream* out)
{
  *out << describe(fault);
}
inline void PrintTo(ErrorCode code, std::ostream* out)
{
  *out << Error(code).what();
}

namespace test
{

PointView viewOf(const Cloud& cloud);
std::vector<float> floatsOf(const Cloud& cloud);
Hull clone(const Hull& hull);
/// All that a CellComplex has.
void copyCells(const CellComplex& from, CellComplex& to);

/// The cells as input ids. Indices out of range become -1.
std::vector<Cell> cellsOf(const CellComplex& complex);

/// What differs from the reference, in words; empty when nothing does.
std::string difference(
  const CellComplex& complex, const ReferenceHull& reference, FacetMode facets);

template <class T>
bool sameBits(const Buffer<T>& a, const Buffer<T>& b)
{
  return a.size() == b.size() &&
    (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

/// What differs between two results that must be equal bit for bit; empty when nothing does.
std::string bitDifference(const CellComplex& a, const CellComplex& b);
std::string bitDifference(const Hull& a, const Hull& b);

/// Identities that every run's statistics keep.
std::string statisticsFault(const CellComplex& complex, std::int64_t points);

/// Run, expecting an error: its code, and its index and count where they are not -2.
void expectError(const std::function<void()>& run, ErrorCode code, std::int64_t index = -2,
  std::int64_t count = -2);

/// Is this program slower than others by a factor of ten or more?
bool isSanitized();

/// Counts are cut under sanitizers.
int effort(int count);

/// How many random cases are tried: all nightly, a quarter else, and fewer under sanitizers.
int randomCases(int count);

/// How many points are enough for a thread, and for a part of the plane; afterwards 1, which is
/// what tests have so that few points take all paths.
class PointsPerThread
{
public:
  explicit PointsPerThread(std::int64_t count);
  ~PointsPerThread();
  PointsPerThread(const PointsPerThread&) = delete;
  PointsPerThread& operator=(const PointsPerThread&) = delete;
};

/// The numbers of threads that each cloud is tried on: 1, 2, 4; under sanitizers 1, 4.
std::vector<int> threadsTried();

}
}

#endif
