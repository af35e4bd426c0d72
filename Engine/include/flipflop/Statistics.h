// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What a run did, in the paper's terms (section 5).
#ifndef flipflop_Statistics_h
#define flipflop_Statistics_h

#include <algorithm>
#include <cstdint>

namespace flipflop
{

/// Counts and seconds of a run, or sums over several runs. Documentation/Statistics.md explains how
/// to read them.
struct Statistics
{
  std::int64_t points = 0;     ///< points given
  std::int64_t nonFinite = 0;  ///< points omitted because a coordinate is NaN or infinite
  std::int64_t culled = 0;     ///< points found inside without being associated to a triangle
  std::int64_t insertions = 0; ///< vertices inserted (1-3 flips), all samples
  std::int64_t moves = 0;      ///< how often a point moved, to a child cone or by a walk's step
  std::int64_t flips22 = 0;    ///< 2-2 flips
  std::int64_t flips31 = 0;    ///< 3-1 flips
  std::int64_t flipsV = 0;     ///< flips by the V-criterion (flips22 + flips31 = flipsV + flipsD)
  std::int64_t flipsD = 0;     ///< flips by the D-criterion
  std::int64_t labelled = 0;   ///< vertices labelled non-extreme
  std::int64_t redundant = 0;  ///< vertices removed from true facets and edges, and duplicates
  std::int64_t edgeChecks = 0; ///< edges examined by Algorithm 1
  std::int64_t exactCalls = 0; ///< predicates that the floating-point filter left undecided

  double secondsScan = 0;   ///< wall time: ranges, non-finite points, first tetrahedron
  double secondsLocate = 0; ///< wall time: culling, associating points to triangles
  double secondsGrow = 0;   ///< summed over threads: Algorithm 2
  double secondsFlip = 0; ///< summed over threads: Algorithm 1; wall time of parts and their merges
  double secondsCompact = 0; ///< wall time, CUDA engine: removing gaps, and copying to the host
  double secondsFinish = 0;  ///< wall time: true facets, canonical order
  double secondsTotal = 0;   ///< wall time of the whole run
  int threads = 0;           ///< threads that the run was given

  /// Calls use(name, member) for each count and each time, but not for threads. This is the one
  /// list: code that adds up, compares or writes all figures goes by it.
  template <class Use>
  static void eachField(Use&& use)
  {
    use("points", &Statistics::points);
    use("nonFinite", &Statistics::nonFinite);
    use("culled", &Statistics::culled);
    use("insertions", &Statistics::insertions);
    use("moves", &Statistics::moves);
    use("flips22", &Statistics::flips22);
    use("flips31", &Statistics::flips31);
    use("flipsV", &Statistics::flipsV);
    use("flipsD", &Statistics::flipsD);
    use("labelled", &Statistics::labelled);
    use("redundant", &Statistics::redundant);
    use("edgeChecks", &Statistics::edgeChecks);
    use("exactCalls", &Statistics::exactCalls);
    use("secondsScan", &Statistics::secondsScan);
    use("secondsLocate", &Statistics::secondsLocate);
    use("secondsGrow", &Statistics::secondsGrow);
    use("secondsFlip", &Statistics::secondsFlip);
    use("secondsCompact", &Statistics::secondsCompact);
    use("secondsFinish", &Statistics::secondsFinish);
    use("secondsTotal", &Statistics::secondsTotal);
  }

  /// Adds the figures of another run; threads becomes the larger number.
  Statistics& operator+=(const Statistics& other)
  {
    eachField([&](const char*, auto field) { this->*field += other.*field; });
    this->threads = std::max(this->threads, other.threads);
    return *this;
  }
};

}

#endif
