// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EngineCall.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flipflop
{
namespace fuzz
{

bool Trial::report(double fraction, void* self)
{
  Trial& trial = *static_cast<Trial*>(self);
  State_& state = trial.State;
  demand(fraction >= state.reached && fraction <= 1, "progress runs back, or out of 0 to 1");
  demand(trial.Caller == std::this_thread::get_id(), "progress is reported by another thread");
  demand(!state.stopped, "progress is reported after the stop");
  state.reached = fraction;
  if (++state.polls != trial.StopAt)
  {
    return true;
  }
  state.stopped = true;
  if (trial.Throws)
  {
    throw Thrown();
  }
  return false;
}

Trial::Trial(Bytes& bytes, int calls)
{
  constexpr int most = std::numeric_limits<int>::max();
  constexpr int least = std::numeric_limits<int>::min();
  const int threads[] = { 1, 2, 1, 2, 3, 0, -1, 5, 64, 1000, 1000000, most / 4, most, least };
  this->Drawn.threads = threads[bytes.below(14)];
  const int flags = bytes.byte();
  this->Drawn.facets = flags & 1 ? FacetMode::Polygons : FacetMode::Triangles;
  this->Drawn.nonFinite = flags & 2 ? NonFinitePolicy::Ignore : NonFinitePolicy::Error;
  this->Drawn.vBiased = (flags & 4) != 0;
  this->Plain = this->Drawn;
  this->Plain.threads = this->Drawn.threads == 1 ? 2 : 1;
  if (flags & 8)
  {
    this->StopAt = bytes.below(32);
    this->Throws = (flags & 16) != 0;
  }
  this->Watched = calls > 1 ? bytes.below(calls) : 0;
}

Options Trial::drawn() const
{
  Options options = this->Drawn;
  if (this->State.isOn)
  {
    options.progress = &Trial::report;
    options.progressContext = const_cast<Trial*>(this);
  }
  return options;
}

void Trial::demandAllowed(const Error& error, std::initializer_list<ErrorCode> allowed)
{
  demand(std::find(allowed.begin(), allowed.end(), error.code()) != allowed.end(),
    std::string("an error out of place: ") + error.what());
  demand(std::string(Error(ErrorCode::BadArgument).what()) != error.what(),
    "a bad argument without a text of its own");
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
  for (Point& p : cloud)
  {
    for (std::size_t i = from; i < to; ++i)
    {
      if (layout.floats)
      {
        // A double too large for float would be undefined; what is meant is infinity.
        const double large = std::numeric_limits<float>::max();
        p[i] = p[i] > large ? HUGE_VAL : p[i] < -large ? -HUGE_VAL : p[i];
        p[i] = static_cast<double>(static_cast<float>(p[i]));
      }
      this->Doubles.push_back(p[i]);
    }
    // None behind the last: there the memory ends.
    if (&p != &cloud.back())
    {
      this->Doubles.insert(this->Doubles.end(), static_cast<std::size_t>(layout.gap), 7.0);
    }
  }
  if (layout.floats)
  {
    this->Floats.assign(this->Doubles.begin(), this->Doubles.end());
  }
  this->Doubles.shrink_to_fit();
}

Cloud finiteOf(const Cloud& cloud)
{
  Cloud finite;
  std::copy_if(cloud.begin(), cloud.end(), std::back_inserter(finite),
    [](const Point& p)
    { return std::all_of(p.begin(), p.end(), [](double x) { return std::isfinite(x); }); });
  return finite;
}

Cloud drawQueries(Bytes& bytes, const Cloud& cloud)
{
  constexpr std::size_t Most = 24;
  constexpr std::size_t FewPoints = 40;
  // More than are answered in the order of a curve, where that is quick in wide integers, too.
  Cloud queries = drawCloud(bytes, cloud.size() <= FewPoints ? 5000 : 300);
  for (std::size_t i = 0; i < std::min(Most, cloud.size()); ++i)
  {
    const Point& a = cloud[i];
    const Point& b = cloud[bytes.byte() % cloud.size()];
    queries.push_back(a);
    queries.push_back({ a[0] / 2 + b[0] / 2, a[1] / 2 + b[1] / 2, a[2] / 2 + b[2] / 2 });
  }
  using Limits = std::numeric_limits<double>;
  for (int more = bytes.below(8); more > 0 && !cloud.empty(); --more)
  {
    Point p = cloud[bytes.byte() % cloud.size()];
    for (double& x : p)
    {
      const double steps[] = { x, Limits::max(), -Limits::max(), std::nextafter(x, Limits::max()),
        std::nextafter(x, -Limits::max()), x + std::ldexp(1.0, 9 * bytes.raw<std::int8_t>()),
        x - std::ldexp(1.0, 9 * bytes.raw<std::int8_t>()), Limits::denorm_min() };
      x = steps[bytes.below(8)];
    }
    queries.push_back(p);
  }
  return queries;
}

namespace
{

void changeOne(Bytes& bytes, Buffer<std::int64_t>& values)
{
  const std::size_t size = values.size();
  if (size == 0)
  {
    return;
  }
  const std::size_t at = bytes.raw<std::uint16_t>() % size;
  switch (bytes.below(5))
  {
    case 1:
      std::swap(values[at], values[bytes.raw<std::uint16_t>() % size]);
      break;
    case 2:
      values[at] = values[bytes.raw<std::uint16_t>() % size];
      break;
    case 3:
      values.truncate(at);
      break;
    case 4:
      values[at] = bytes.integer();
      break;
    default:
      values[at] += bytes.raw<std::int8_t>();
      break;
  }
}

}

void corrupt(Bytes& bytes, CellComplex& cells, Buffer<std::int64_t>* hidden)
{
  Buffer<std::int64_t>* const parts[] = { &cells.connectivity, &cells.pointIds, &cells.offsets,
    hidden };
  for (int times = bytes.below(3); times >= 0; --times)
  {
    switch (const int part = bytes.below(6))
    {
      case 3:
        cells.cellSize = bytes.integer();
        break;
      case 4:
        cells.dimension = static_cast<int>(bytes.integer());
        break;
      default:
        if (Buffer<std::int64_t>* const values = parts[part == 5 ? 3 : part])
        {
          changeOne(bytes, *values);
        }
        break;
    }
  }
}

}
}
