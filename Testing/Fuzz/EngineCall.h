// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// One input's calls of the engine: their options, who watches one of them, points in memory, and
/// what may come out.
#ifndef flipflop_fuzz_EngineCall_h
#define flipflop_fuzz_EngineCall_h

#include "Clouds.h"
#include "Demand.h"

#include "Testing/Engine/Calls/Bits.h"

#include <flipflop/Error.h>
#include <flipflop/Options.h>
#include <flipflop/PointView.h>

#include <initializer_list>
#include <optional>
#include <thread>
#include <variant>
#include <vector>

namespace flipflop
{

/// A hull or a triangulation.
inline std::string bitsOf(const std::variant<Hull, Triangulation>& result)
{
  return std::visit([](const auto& one) { return test::bitsOf(one); }, result);
}

namespace fuzz
{

using test::bitsOf;

/// What a progress function may throw; nothing promises that it comes out as it is.
struct Thrown
{
};

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

  PointView points() const { return this->view<PointView>(); }
  WeightView weights() const { return this->view<WeightView>(); }

private:
  template <class View>
  View view() const
  {
    return this->Form.floats ? View(this->Floats.data(), this->Count, this->Stride)
                             : View(this->Doubles.data(), this->Count, this->Stride);
  }

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

  bool is(ErrorCode code) const { return this->error && this->error->code() == code; }
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

/// Calls of any options. One of them is watched, and may be stopped at one of its polls; each is
/// made again on another number of threads, and must give the same bits.
class Trial
{
public:
  /// @param calls of which one is watched
  explicit Trial(Bytes& bytes, int calls = 1);
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;

  /// As drawn, with nobody to watch and on another number of threads.
  const Options& plain() const { return this->Plain; }
  FacetMode facets() const { return this->Plain.facets; }

  /// The outcome with nobody to watch.
  /// @param number  of the call: is it the watched one?
  /// @param allowed errors
  /// @param call    result (const Options&); bitsOf(result) is compared
  template <class Call>
  auto run(int number, std::initializer_list<ErrorCode> allowed, const Call& call)
    -> Outcome<decltype(call(Options()))>
  {
    this->State = State_();
    this->State.isOn = number == this->Watched && this->StopAt > 0;
    const auto first = attempt([&] { return call(this->drawn()); });
    const bool stopped = this->State.stopped;
    this->State.isOn = false;
    auto other = attempt([&] { return call(this->Plain); });
    demand(!other.thrown && (!first.thrown || stopped),
      "the progress function's exception without a throw");
    if (stopped)
    {
      demand(!first.result, "a run that was stopped gave a result");
      demand(this->Throws || first.is(ErrorCode::Aborted),
        "a run that was stopped ended in another way");
    }
    else
    {
      demand(first.result.has_value() == other.result.has_value() &&
          (!first.error || other.is(first.error->code())),
        "an error depends on the number of threads");
      demand(!first.result || bitsOf(*first.result) == bitsOf(*other.result),
        "a result depends on the number of threads");
    }
    if (other.error)
    {
      demandAllowed(*other.error, allowed);
    }
    return other;
  }

  /// The same; NonFinite exactly where the policy and the points ask for it, with the first and the
  /// count.
  template <class Call>
  auto run(int number, const NonFinite& found, std::initializer_list<ErrorCode> allowed,
    const Call& call) -> Outcome<decltype(call(Options()))>
  {
    auto outcome = this->run(number, allowed, call);
    const bool expected = this->Plain.nonFinite == NonFinitePolicy::Error && found.count > 0;
    demand(outcome.is(ErrorCode::NonFinite) == expected,
      "NonFinite where all are finite, or none where one is not");
    demand(
      !expected || (outcome.error->index() == found.first && outcome.error->count() == found.count),
      "NonFinite names the wrong point or count");
    return outcome;
  }

  /// A number for each of so many, which the call writes. @param write void (T*, const Options&)
  template <class T, class Write>
  std::vector<T> write(int number, std::size_t count, const NonFinite& found, const Write& write)
  {
    auto outcome = this->run(number, found, { ErrorCode::NonFinite },
      [&](const Options& options)
      {
        std::vector<T> values(count);
        write(values.data(), options); // null where nothing is asked, as empty vectors have it
        return values;
      });
    return outcome.result ? *outcome.result : std::vector<T>();
  }

private:
  /// What the watch has seen.
  struct State_
  {
    bool isOn = false;
    bool stopped = false;
    int polls = 0;
    double reached = 0;
  };

  static bool report(double fraction, void* self);
  static void demandAllowed(const Error& error, std::initializer_list<ErrorCode> allowed);
  Options drawn() const;

  Options Drawn;
  Options Plain;
  int Watched = 0;
  int StopAt = 0;
  bool Throws = false;
  std::thread::id Caller = std::this_thread::get_id();
  State_ State;
};

/// No words: there is no fault.
inline void demandNone(const std::string& fault)
{
  demand(fault.empty(), fault);
}

/// Of the points those whose coordinates are all finite.
Cloud finiteOf(const Cloud& cloud);

/// Any points, then some of the cloud's, the middles between two of these, and what is far beyond
/// them or beside them along an axis.
Cloud drawQueries(Bytes& bytes, const Cloud& cloud);

/// Change one number in some of a result's parts.
/// @param hidden a triangulation's; null: a hull's
void corrupt(Bytes& bytes, CellComplex& cells, Buffer<std::int64_t>* hidden);

}
}

#endif
