// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What a caller may choose, and how a long run is watched and stopped.
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

/// Told how far the run is (0 to 1), on the calling thread only; returns false to stop the run,
/// which then throws ErrorCode::Aborted.
using ProgressFunction = bool (*)(double fraction, void* context);

/// The choices of one run.
struct Options
{
  int threads = 0; ///< 1 or more; 0: as many as the machine has. The output never depends on it.
  FacetMode facets = FacetMode::Triangles;            ///< how facets are given
  NonFinitePolicy nonFinite = NonFinitePolicy::Error; ///< what NaN and infinity lead to
  /// The V-biased Flip-Flop (paper, end of section 2.3): vertices are labelled only where no other
  /// flip is left. The same output; without it a label may set off very many flips.
  bool vBiased = true;
  ProgressFunction progress = nullptr; ///< null: nobody is told, and nobody can stop the run
  void* progressContext = nullptr;     ///< handed to progress as it is
};

}

#endif
