// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EngineCall.h"

#include <limits>

namespace flipflop
{
namespace fuzz
{

bool Watch::report(double fraction, void* self)
{
  Watch& watch = *static_cast<Watch*>(self);
  demand(fraction >= watch.reached && fraction <= 1, "progress runs back, or out of 0 to 1");
  demand(watch.caller == std::this_thread::get_id(), "progress is told by another thread");
  demand(!watch.stopped, "progress is told after the stop");
  watch.reached = fraction;
  if (++watch.polls != watch.stopAt)
  {
    return true;
  }
  watch.stopped = true;
  if (watch.throws)
  {
    throw Thrown();
  }
  return false;
}

Options drawOptions(Bytes& bytes, Watch& watch)
{
  Options options;
  constexpr int most = std::numeric_limits<int>::max();
  constexpr int least = std::numeric_limits<int>::min();
  const int threads[] = { 1, 2, 1, 2, 3, 0, -1, 5, 64, 1000, 1000000, most / 4, most, least };
  options.threads = threads[bytes.below(14)];
  const int flags = bytes.byte();
  options.facets = flags & 1 ? FacetMode::Polygons : FacetMode::Triangles;
  options.nonFinite = flags & 2 ? NonFinitePolicy::Ignore : NonFinitePolicy::Error;
  options.vBiased = (flags & 4) != 0;
  if (flags & 8)
  {
    watch.stopAt = bytes.below(32);
    watch.throws = (flags & 16) != 0;
    watch.caller = std::this_thread::get_id();
    options.progress = &Watch::report;
    options.progressContext = &watch;
  }
  return options;
}

Options unwatched(const Options& options)
{
  Options other = options;
  other.threads = options.threads == 1 ? 2 : 1;
  other.progress = nullptr;
  other.progressContext = nullptr;
  return other;
}

Layout drawLayout(Bytes& bytes)
{
  const int form = bytes.byte();
  return { form % 4 == 3, form / 4 % 8 };
}

Scalars::Scalars(Cloud& cloud, std::size_t from, std::size_t to, const Layout& layout)
  : Count(static_cast<std::int64_t>(cloud.size()))
  , Stride(static_cast<std::int64_t>(to - from) + layout.gap)
  , Form(layout)
{
  const auto gap = static_cast<std::size_t>(layout.gap);
  for (Point& p : cloud)
  {
    for (std::size_t i = from; i < to; ++i)
    {
      if (layout.floats)
      {
        // A double too large for float would be undefined; what is meant is infinity.
        const double large = std::numeric_limits<float>::max();
        const double infinity = std::numeric_limits<double>::infinity();
        p[i] = p[i] > large ? infinity : p[i] < -large ? -infinity : p[i];
        this->Floats.push_back(static_cast<float>(p[i]));
        p[i] = static_cast<double>(this->Floats.back());
      }
      else
      {
        this->Doubles.push_back(p[i]);
      }
    }
    // None behind the last: there the memory ends.
    if (&p != &cloud.back())
    {
      this->Floats.insert(this->Floats.end(), layout.floats ? gap : 0, 7.0f);
      this->Doubles.insert(this->Doubles.end(), layout.floats ? 0 : gap, 7.0);
    }
  }
  this->Floats.shrink_to_fit();
  this->Doubles.shrink_to_fit();
}

PointView Scalars::points() const
{
  return this->Form.floats ? PointView(this->Floats.data(), this->Count, this->Stride)
                           : PointView(this->Doubles.data(), this->Count, this->Stride);
}

WeightView Scalars::weights() const
{
  return this->Form.floats ? WeightView(this->Floats.data(), this->Count, this->Stride)
                           : WeightView(this->Doubles.data(), this->Count, this->Stride);
}

}
}
