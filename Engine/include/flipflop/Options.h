// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The choices of a caller, and how to watch and stop a long run.
#ifndef flipflop_Options_h
#define flipflop_Options_h

namespace flipflop
{

/// How a facet of three or more corners is given.
enum class FacetMode
{
  Triangles, ///< a fan from the facet's lowest id
  Polygons   ///< one cell a facet
};

/// What to do with a point that has a NaN or infinite coordinate.
enum class NonFinitePolicy
{
  Error, ///< throw ErrorCode::NonFinite
  Ignore ///< leave it out, and count it in Statistics::nonFinite
};

/// How polygons define what is inside.
enum class PolygonRule
{
  EvenOdd,  ///< what an odd number of their sides parts from the outside; no direction counts
  Direction ///< what is on the left of their sides: holes run clockwise
};

/// Called with the progress of the run (0 to 1), on the calling thread only, in the caller's
/// floating-point environment. Returns false to stop the run, which then throws
/// ErrorCode::Aborted.
using ProgressFunction = bool (*)(double fraction, void* context);

/// Called with the name of each step of the run that begins ("locating", "growing and flipping"),
/// on the calling thread only, before the progress function. A run may come back to a step.
using StepFunction = void (*)(const char* name, void* context);

/// The choices of one run.
struct Options
{
  int threads = 0; ///< 1 or more; 0: as many as the machine has. The output never depends on it.
  FacetMode facets = FacetMode::Triangles;            ///< how facets are given
  NonFinitePolicy nonFinite = NonFinitePolicy::Error; ///< what NaN and infinity lead to
  PolygonRule polygons = PolygonRule::EvenOdd; ///< how polygons define the inside: cellsInside
  /// The V-biased Flip-Flop (paper, end of section 2.3): vertices are labelled only if no other
  /// flip remains. The output is the same. Without it, a label may cause very many flips.
  bool vBiased = true;
  ProgressFunction progress = nullptr; ///< null: no progress reports, and no way to stop the run
  void* progressContext = nullptr;     ///< passed to progress and step unchanged
  StepFunction step = nullptr;         ///< null: no names
};

}

#endif
