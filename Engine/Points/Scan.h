// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The scan of the input: ranges, non-finite points, a common unit.
#ifndef flipflop_Scan_h
#define flipflop_Scan_h

#include "Points/CoordinateRange.h"
#include "Points/PointSource.h"
#include "Support/Monitor.h"

#include <cstdint>
#include <mutex>

namespace flipflop
{

struct ScanResult
{
  CoordinateRange range = CoordinateRange::empty(); ///< of the finite points
  std::int64_t nonFinite = 0;                       ///< how many have a NaN or infinite coordinate
  std::int64_t firstNonFinite = -1;                 ///< the first of them
  std::int64_t firstFinite = -1;                    ///< the first other point
};

/// A scan of points in parts, by any threads.
class ScanSum
{
public:
  /// Add the points from @p begin on, before @p end. They are not scaled.
  void add(const PointSource& source, std::uint32_t begin, std::uint32_t end);

  /// Of all that were added.
  ScanResult result() const;

private:
  std::mutex mutex;
  ScanResult sum;
};

/// Scans all points first. An engine may copy them meanwhile: then the input is read once.
class PointScanner
{
public:
  virtual ~PointScanner() = default;

  /// One parallel pass over unscaled points.
  virtual ScanResult scan(const PointSource& source, Monitor& monitor);
};

/// The largest power of two from @p least to @p most of which all coordinates are multiples,
/// weights of its square; 0: there is none.
double commonUnit(
  const PointSource& source, double least, double most, bool checkFinite, Monitor& monitor);

}

#endif
