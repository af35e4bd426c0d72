// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What runs side by side: one algorithm behind one interface.
#ifndef flipflop_Contender_h
#define flipflop_Contender_h

#include "Coordinates.h"
#include <flipflop/Statistics.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace flipflop
{

/// What a run found; plain values, since it comes out of a process of its own.
struct Outcome
{
  std::int64_t vertices = 0;
  std::int64_t facets = 0;
  Statistics statistics; ///< ours; zeros for the others

  /// As measured where the library ran, if that was a process of its own; else -1.
  double seconds = -1;
  std::int64_t peakBytes = -1;
};

/// What an exact judge says of a result.
struct Verdict
{
  bool right = true;
  std::string text; ///< empty: it was not judged
};

class Contender
{
public:
  virtual ~Contender() = default;

  /// Bring the points into the form that the library takes. Not timed; its memory is input.
  virtual void prepare(const Coordinates& xyz) = 0;

  /// The result, complete. This alone is timed.
  virtual void run() = 0;

  /// Not timed.
  virtual Outcome outcome() const = 0;

  /// Judge the result exactly, where there is a judge for it. Not timed.
  virtual Verdict judge() const { return {}; }
};

using ContenderFactory = std::function<std::unique_ptr<Contender>()>;

}

#endif
