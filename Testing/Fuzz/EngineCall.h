// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// One call of the engine: its options, who watches it, its points in memory, and what may come
/// out.
#ifndef flipflop_fuzz_EngineCall_h
#define flipflop_fuzz_EngineCall_h

#include "Clouds.h"
#include "Demand.h"

#include <flipflop/Error.h>
#include <flipflop/Options.h>
#include <flipflop/PointView.h>

#include <optional>
#include <thread>
#include <vector>

namespace flipflop
{
namespace fuzz
{

/// What a progress function may throw; nothing promises that it comes out as it is.
struct Thrown
{
};

/// Watches a run, and stops it at one of its polls.
struct Watch
{
  int stopAt = 0;           ///< the poll, from 1 on; 0: none
  bool throws = false;      ///< instead of returning false
  bool stopped = false;     ///< it came to that
  int polls = 0;            ///< seen
  double reached = 0;       ///< the last fraction
  std::thread::id caller{}; ///< nobody else may report

  static bool report(double fraction, void* self);
};

/// Options of any kind, the watch's function among them.
Options drawOptions(Bytes& bytes, Watch& watch);

/// How scalars lie in memory.
struct Layout
{
  bool floats = false;
  std::int64_t gap = 0; ///< scalars between one point's and the next's
};
Layout drawLayout(Bytes& bytes);

/// Scalars in memory that ends where they end.
class Scalars
{
public:
  /// The coordinates @p from to @p to - 1 of every point. What float rounds is rounded in the
  /// cloud.
  Scalars(Cloud& cloud, std::size_t from, std::size_t to, const Layout& layout);

  PointView points() const;
  WeightView weights() const;

private:
  std::int64_t Count;
  std::int64_t Stride;
  Layout Form;
  std::vector<float> Floats;
  std::vector<double> Doubles;
};

/// What a call came to.
template <class Result>
struct Outcome
{
  std::optional<Result> result;
  std::optional<Error> error;
  bool thrown = false; ///< what the progress function threw came out
};

/// Anything else that is thrown ends the process.
template <class Work>
auto attempt(const Work& work) -> Outcome<decltype(work())>
{
  Outcome<decltype(work())> outcome;
  try
  {
    outcome.result.emplace(work());
  }
  catch (const Error& error)
  {
    outcome.error = error;
  }
  catch (const Thrown&)
  {
    outcome.thrown = true;
  }
  return outcome;
}

/// A result, unless an error that is allowed, or the watch stopped the run.
template <class Result>
void expectOutcome(
  const Outcome<Result>& outcome, const Watch& watch, std::initializer_list<ErrorCode> allowed)
{
  if (watch.stopped)
  {
    demand(!outcome.result, "a run that was stopped gave a result");
    demand(watch.throws || (outcome.error && outcome.error->code() == ErrorCode::Aborted),
      "a run that was stopped ended in another way");
    return;
  }
  demand(!outcome.thrown, "the progress function's exception without a throw");
  if (outcome.error)
  {
    bool known = false;
    for (const ErrorCode code : allowed)
    {
      known = known || code == outcome.error->code();
    }
    demand(known, std::string("an error out of place: ") + outcome.error->what());
    demand(std::string(Error(ErrorCode::BadArgument).what()) != outcome.error->what(),
      "a bad argument without a text of its own");
  }
}

/// NonFinite exactly where the policy and the points ask for it, with the first and the count.
template <class Result>
void expectNonFinite(const Outcome<Result>& outcome, const Watch& watch, const Options& options,
  const NonFinite& found)
{
  if (watch.stopped)
  {
    return;
  }
  const bool expected = options.nonFinite == NonFinitePolicy::Error && found.count > 0;
  const bool refused = outcome.error && outcome.error->code() == ErrorCode::NonFinite;
  demand(refused == expected, "NonFinite where all are finite, or none where one is not");
  demand(
    !refused || (outcome.error->index() == found.first && outcome.error->count() == found.count),
    "NonFinite names the wrong point or count");
}

/// The same on another number of threads, and with nobody to watch.
Options unwatched(const Options& options);

}
}

#endif
