// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The rounds of ffHull and ffRT (paper, sections 3.2 and 4): written once, over an executor and a
/// geometry.
///
///   grow()      GrowthKernels.h, until no point remains
///   flip()      FlipKernels.h, until no triangle is active
///   finish()    CellWriter.h: the result in canonical form, to the host; or, where there are ties,
///   compact()   CompactKernels.h: the polyhedron, to the host
///
/// A round costs no wait: kernels take their counts from the executor's memory (Counters.h), and
/// the host is a round ahead. It hands out round r knowing what round r - 2 left, which bounds how
/// much memory round r can need; so a stage ends with a round that has nothing to do. It also reads
/// whether a filter left anything open: only then are exact kernels launched.
#ifndef flipflop_Rounds_h
#define flipflop_Rounds_h

#include "FlipFlop/PolyhedronBuilder.h"
#include "Mesh/Polyhedron.h"
#include "Rounds/CellWriter.h"
#include "Rounds/CompactKernels.h"
#include "Rounds/ExecutorArray.h"
#include "Rounds/FlipKernels.h"
#include "Rounds/GrowthKernels.h"
#include "Rounds/OrderKernels.h"
#include "Rounds/RoundReport.h"
#include "Support/Monitor.h"
#include "Support/Stopwatch.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

namespace flipflop
{

template <class Executor, class Geometry>
class Rounds
{
public:
  /// @param watcher may be null
  Rounds(Executor& where, const BuildTask<Geometry>& task, const RoundObserver* watcher = nullptr)
    : executor(where)
    , geometry(task.geometry)
    , source(task.source)
    , range(task.range)
    , checkFinite(task.checkFinite)
    , vBiased(task.options.vBiased)
    , measured(task.measured)
    , scaleExponent(task.scaleExponent)
    , monitor(task.monitor)
    , observer(watcher)
    , counters(where, 1)
    , triangles(where)
    , vertices(where)
    , keys(where)
    , lowest(where)
    , sameAs(where)
    , offsets(where)
    , lists{ Array<std::uint32_t>(where), Array<std::uint32_t>(where) }
    , undecided(where)
    , unlocated(where)
  {
  }

  /// From a tetrahedron around the geometry's kernel point to a star-shaped polyhedron that no
  /// point is outside of.
  /// @param points as the executor reads them
  void grow(const Polyhedron& start, const PointSource& points)
  {
    const std::uint32_t count = this->source.count();
    this->monitor.stage(0.1, 0.5, count, "growing");
    this->executor.beginPart("grow");
    Array<PointAlive> live[2] = { Array<PointAlive>(this->executor, count),
      Array<PointAlive>(this->executor, count) };
    Array<double> x(this->executor);
    Array<std::uint32_t> ids(this->executor);
    this->unlocated.reserve(count);
    this->begin(start);

    Counters* const c = this->counters.data();
    GrowthData<Geometry> data = { this->geometry, points, this->checkFinite, {}, nullptr, nullptr,
      { nullptr, nullptr }, { live[0].data(), live[1].data() }, {}, nullptr, this->unlocated.data(),
      c };
    this->share(data);
    this->executor.each(count, nullptr, Associate<Geometry>{ {}, data });
    Counters first = this->now();
    bool located[Ahead + 2] = { first.unlocated != 0 }; ///< by round, in turns: all are
    if (located[0])
    {
      this->executor.each(count, &c->unlocated, LocateExact<Geometry>{ { {}, data }, 0 });
      first = this->now();
    }
    this->observe(RoundReport::Stage::Associate, 0, located[0]);

    std::uint32_t aliveBefore = count;
    bool ordered = false;
    std::uint32_t allCandidates = 0; ///< the last round that made all triangles candidates
    for (std::uint32_t round = 1;; ++round)
    {
      const std::uint32_t known = round > 1 + Ahead ? round - 1 - Ahead : 0;
      const RoundRecord then = known > 0 ? this->recorded(known)
                                         : RoundRecord{ first.triangles, first.vertices,
                                             first.live[0], first.candidates, 0, first.unlocated };
      const std::uint32_t alive =
        then.live + (located[known % std::size(located)] ? 0 : then.undecided);
      this->monitor.advance(aliveBefore - alive);
      aliveBefore = alive;
      if (alive == 0)
      {
        break;
      }
      Bounds before(then, alive);
      for (std::uint32_t r = known + 1; r < round; ++r)
      {
        before = before.afterRound(r == allCandidates);
      }
      // Of those that were left open in this round, the triangles are candidates anyway.
      const bool locates = then.undecided != 0;
      const bool allLocated = located[(round - 1) % std::size(located)];
      located[round % std::size(located)] = locates;
      allCandidates = locates && !allLocated ? round : allCandidates;
      if (!ordered && then.triangles >= OrderedFrom && alive >= count / 4)
      {
        x.reserve(3 * std::size_t(alive));
        ids.reserve(alive);
        this->orderLive(data, (round & 1) ^ 1, alive, allLocated, { x.data(), ids.data() });
        ordered = true;
      }
      const Bounds after = before.afterRound(round == allCandidates);
      this->reserveFor(round, before, after);
      this->share(data);
      this->growthRound(data, round, before, allLocated);
      if (locates)
      {
        this->executor.each(count, &c->unlocated, LocateExact<Geometry>{ { {}, data }, round & 1 });
      }
      if (round == allCandidates)
      {
        this->executor.each(static_cast<std::uint32_t>(after.triangles), &c->triangles,
          MakeAllCandidates<Geometry>{ {}, data, (round & 1) ^ 1 });
      }
      this->growthRoundCount = round;
      this->observe(RoundReport::Stage::Grow, round, locates);
    }
    this->offsets.clear();
    this->unlocated.clear();
  }

  /// Algorithm 1.
  void flip()
  {
    const Counters counted = this->now();
    ensure(!counted.strayed);
    const std::uint32_t t = counted.triangles;
    const std::uint32_t v = counted.vertices;
    this->monitor.stage(0.5, 0.85, t, "flipping");
    this->executor.beginPart("flip");
    Array<std::uint32_t> moved(this->executor, 4 * std::size_t(t));
    Array<std::uint32_t> flipped(this->executor, t);
    Array<std::uint32_t> queued(this->executor, t);
    Array<Proposal> proposals(this->executor, t);
    Array<Proposal> flips(this->executor, t);
    this->lists[0].reserve(t);
    this->lists[1].reserve(t);
    this->undecided.reserve(t);
    this->sameAs.reserve(3 * std::size_t(v));
    this->executor.fill(this->sameAs.data(), 0xFF, 3 * std::size_t(v) * sizeof(std::uint32_t));
    this->executor.fill(this->keys.data(), 0xFF, t * sizeof(std::uint64_t));
    this->executor.fill(flipped.data(), 0, t * sizeof(std::uint32_t));

    const FlipData<Geometry> data = { this->geometry, this->mesh(), this->keys.data(), moved.data(),
      flipped.data(), queued.data(), this->sameAs.data(),
      { this->lists[0].data(), this->lists[1].data() }, proposals.data(), flips.data(),
      this->undecided.data(), this->counters.data(), this->vBiased };
    this->executor.each(t, nullptr, WakeAll<Geometry>{ {}, data, t });

    std::uint32_t first = 1;                             ///< the round that records begin with
    bool exact = counted.exactCalls + counted.ties != 0; ///< may there be work for it?
    std::uint32_t activeBefore = t;
    for (std::uint32_t round = 1;; ++round)
    {
      if (round > first + Ahead)
      {
        const std::uint32_t known = round - 1 - Ahead;
        const RoundRecord& then = this->recorded(known);
        const std::uint32_t active = then.active;
        exact = then.undecided != 0;
        this->monitor.advance(active < activeBefore ? activeBefore - active : 0);
        activeBefore = active;
        if (active == 0)
        {
          break;
        }
        // Digests are of each round: who watches gets them all.
        if (!this->observer && !exact && active <= TailMost)
        {
          this->executor.together(FlipTail<Geometry>{ data, round, 2 * TailMost });
          const Counters after = this->now();
          round = first = after.tailRound;
          this->flipRoundCount = round;
          if (after.active[round & 1] == 0)
          {
            break;
          }
          if (after.tailChecked)
          {
            this->endFlipRound(data, round, t, true);
            continue;
          }
        }
      }
      this->flipRound(data, round, t, exact);
      this->flipRoundCount = round;
      this->observe(RoundReport::Stage::Flip, round);
    }
  }

  /// The result in canonical form, where no sign was a tie.
  /// @return whether it could; else, compact()
  bool finish(FinishedCells& result, Tally& tally)
  {
    const Counters counted = this->now();
    if (counted.ties != 0)
    {
      return false;
    }
    this->monitor.stage(0.9, 1.0, 1, "finishing");
    this->executor.beginPart("finish");
    const Measure measure(this->range, this->scaleExponent);
    CellWriter<Executor> writer(this->executor, this->keys, this->lists);
    if (!writer.write(this->mesh(), this->lowest.data(), this->sameAs.data(), counted,
          this->counters.data(), this->source.count(), this->measured ? &measure : nullptr, result))
    {
      return false;
    }
    addTo(tally, counted);
    return true;
  }

  /// The polyhedron without gaps, on the host.
  Polyhedron compact(Tally& tally)
  {
    this->executor.beginPart("compact");
    const Counters before = this->now();
    const std::uint32_t t = before.triangles;
    const std::uint32_t v = before.vertices;
    Array<std::uint32_t> triangleNumbers(this->executor, std::size_t(t) + 1);
    Array<std::uint32_t> vertexNumbers(this->executor, std::size_t(v) + 1);
    this->executor.each(
      t + 1, nullptr, MarkTriangles{ {}, this->mesh(), t, triangleNumbers.data() });
    this->executor.each(v + 1, nullptr, MarkVertices{ {}, this->mesh(), v, vertexNumbers.data() });
    this->executor.exclusiveSum(triangleNumbers.data(), t + 1);
    this->executor.exclusiveSum(vertexNumbers.data(), v + 1);
    Array<std::uint32_t> list(this->executor, v);
    this->executor.each(v, nullptr,
      ListDuplicates{ {}, this->mesh(), this->lowest.data(), this->sameAs.data(), list.data(),
        this->counters.data() });
    std::uint32_t triangleCount;
    std::uint32_t vertexCount;
    this->executor.toHost(&triangleCount, triangleNumbers.data() + t, sizeof(triangleCount));
    this->executor.toHost(&vertexCount, vertexNumbers.data() + v, sizeof(vertexCount));
    const Counters counted = this->now();

    Polyhedron result(vertexCount, triangleCount);
    {
      Array<Triangle> gathered(this->executor, triangleCount);
      this->executor.each(t, nullptr,
        GatherTriangles{
          {}, this->mesh(), triangleNumbers.data(), vertexNumbers.data(), gathered.data() });
      this->download(result.triangles, gathered);
    }
    {
      Array<Vertex> gathered(this->executor, vertexCount);
      this->executor.each(
        v, nullptr, GatherVertices{ {}, this->mesh(), vertexNumbers.data(), gathered.data() });
      this->download(result.vertices, gathered);
    }
    if (counted.duplicates)
    {
      const std::size_t count = GatherDuplicates::Pairs * std::size_t(counted.duplicates);
      Array<Duplicate> gathered(this->executor, count);
      this->executor.each(counted.duplicates, nullptr,
        GatherDuplicates{ {}, this->mesh(), this->lowest.data(), this->sameAs.data(), list.data(),
          gathered.data() });
      Buffer<Duplicate> pairs(count);
      this->download(pairs, gathered);
      std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(tally.duplicates),
        [](const Duplicate& d) { return d.first != d.second; });
    }
    addTo(tally, counted);
    return result;
  }

  std::uint32_t growthRounds() const { return this->growthRoundCount; }
  std::uint32_t flipRounds() const { return this->flipRoundCount; }

private:
  template <class T>
  using Array = ExecutorArray<Executor, T>;

  /// How many rounds the host is ahead of the last record that it has read.
  static constexpr std::uint32_t Ahead = 1;
  static_assert(Ahead + 1 <= Executor::Records, "a record is read before it is written again");

  /// Rounds of so few active triangles are left to one block of threads.
  static constexpr std::uint32_t TailMost = 1 << 10;

  /// If a quarter of the points is alive when there are so many triangles, most of them will be for
  /// long: their list is put in order, once. Of a solid's points next to none are alive by then.
  static constexpr std::uint32_t OrderedFrom = 1 << 6;

  /// No more than this is there.
  struct Bounds
  {
    explicit Bounds(const RoundRecord& known, std::uint32_t pointsAlive)
      : triangles(known.triangles)
      , vertices(known.vertices)
      , candidates(known.candidates)
      , alive(pointsAlive)
      , allVertices(vertices + alive)
    {
    }

    /// A round inserts a point into each candidate that has one, and makes three of it. In all
    /// there are no more vertices than points alive.
    /// @param allCandidates the round makes all triangles candidates
    Bounds afterRound(bool allCandidates) const
    {
      Bounds result = *this;
      const std::uint64_t inserted =
        std::min({ this->candidates, this->alive, this->allVertices - this->vertices });
      result.triangles += 2 * inserted;
      result.vertices += inserted;
      result.candidates =
        allCandidates ? result.triangles : 3 * std::min(this->candidates, this->alive);
      return result;
    }

    std::uint64_t triangles, vertices, candidates, alive, allVertices;
  };

  Mesh mesh()
  {
    Mesh result;
    result.triangles = this->triangles.data();
    result.vertices = this->vertices.data();
    return result;
  }

  void begin(const Polyhedron& start)
  {
    constexpr std::size_t FirstCapacity = 1 << 10; // so that the first rounds need not grow
    const std::uint32_t t = start.triangleCount();
    const std::uint32_t v = start.vertexCount();
    this->triangles.reserve(FirstCapacity);
    this->vertices.reserve(FirstCapacity);
    this->keys.reserve(FirstCapacity);
    this->lowest.reserve(FirstCapacity);
    this->lists[0].reserve(FirstCapacity);
    this->lists[1].reserve(FirstCapacity);
    this->offsets.reserve(FirstCapacity);

    std::vector<std::uint32_t> all(t);
    std::iota(all.begin(), all.end(), std::uint32_t(0));
    std::vector<std::uint32_t> ids(v);
    std::transform(start.vertices.begin(), start.vertices.end(), ids.begin(),
      [](const Vertex& vertex) { return vertex.id; });
    Counters first;
    first.triangles = t;
    first.vertices = v;
    first.candidates = t;
    this->executor.fromHost(this->triangles.data(), start.triangles.data(), t * sizeof(Triangle));
    this->executor.fromHost(this->vertices.data(), start.vertices.data(), v * sizeof(Vertex));
    this->executor.fromHost(this->lowest.data(), ids.data(), v * sizeof(std::uint32_t));
    this->executor.fromHost(this->lists[1].data(), all.data(), t * sizeof(std::uint32_t));
    this->executor.fromHost(this->counters.data(), &first, sizeof(first));
    this->executor.fill(this->keys.data(), 0, t * sizeof(std::uint64_t));
  }

  /// Have space for what a round can add.
  void reserveFor(std::uint32_t round, const Bounds& before, const Bounds& after)
  {
    if (4 * after.triangles >= NoIndex)
    {
      throw Error(ErrorCode::TooManyPoints, -1, static_cast<std::int64_t>(after.vertices));
    }
    const Counters* const c = this->counters.data();
    this->triangles.grow(after.triangles, before.triangles, &c->triangles);
    this->keys.grow(after.triangles, before.triangles, &c->triangles);
    this->vertices.grow(after.vertices, before.vertices, &c->vertices);
    this->lowest.grow(after.vertices, before.vertices, &c->vertices);
    this->offsets.reserve(before.candidates + 1);
    this->lists[(round & 1) ^ 1].reserve(after.candidates);
  }

  /// Bring the points alive into an order in which neighbours are neighbours in space.
  /// @param turn       of the list
  /// @param most       points, those that were left open among them
  /// @param allLocated there are none of these
  /// @param to         space for them
  void orderLive(GrowthData<Geometry>& data, std::uint32_t turn, std::uint32_t most,
    bool allLocated, const OrderedPoints& to)
  {
    Array<std::uint64_t> codes[2] = { Array<std::uint64_t>(this->executor, most),
      Array<std::uint64_t>(this->executor, most) };
    Array<std::uint32_t> from[2] = { Array<std::uint32_t>(this->executor, most),
      Array<std::uint32_t>(this->executor, most) };
    std::uint64_t* const keys[2] = { codes[0].data(), codes[1].data() };
    std::uint32_t* const values[2] = { from[0].data(), from[1].data() };
    const MortonGrid grid(this->range, this->source.isWeighted() ? 2 : 3);
    this->executor.each(
      most, nullptr, KeyLive<Geometry>{ {}, data, turn, grid, keys[0], values[0] });
    const int at = this->executor.sort(keys, values, most, KeyLive<Geometry>::KeyBits);
    this->executor.each(
      most, &data.counters->live[turn], GatherLive<Geometry>{ {}, data, turn, values[at], to });
    if (!allLocated)
    {
      this->executor.each(
        most, &data.counters->unlocated, GatherUnlocated<Geometry>{ {}, data, turn, to });
    }
    std::swap(data.live[0], data.live[1]);
    data.ordered = to;
  }

  /// Where the arrays are now.
  void share(GrowthData<Geometry>& data)
  {
    data.mesh = this->mesh();
    data.furthest = this->keys.data();
    data.lowest = this->lowest.data();
    data.candidates[0] = this->lists[0].data();
    data.candidates[1] = this->lists[1].data();
    data.offsets = this->offsets.data();
  }

  /// @param allLocated see LinkSplits
  void growthRound(
    const GrowthData<Geometry>& data, std::uint32_t round, const Bounds& before, bool allLocated)
  {
    Counters* const c = data.counters;
    const auto candidates = static_cast<std::uint32_t>(before.candidates);
    const auto alive = static_cast<std::uint32_t>(before.alive);
    const std::uint32_t turn = (round & 1) ^ 1;
    this->executor.each(candidates + 1, nullptr,
      Mark{ {}, data.candidates[round & 1], data.furthest, data.offsets, c, turn,
        this->recordOf(round - 1) });
    this->record(round - 1);
    this->executor.exclusiveSum(data.offsets, candidates + 1);
    this->executor.each(candidates, &c->candidates, Insert<Geometry>{ {}, data, round });
    this->executor.each(
      candidates, &c->candidates, LinkSplits<Geometry>{ {}, data, round, allLocated });
    this->executor.each(
      alive, &c->live[turn], Relocate<Geometry>{ {}, data, round, data.offsets + candidates });
  }

  void flipRound(
    const FlipData<Geometry>& data, std::uint32_t round, std::uint32_t most, bool exact)
  {
    this->executor.each(most, &data.counters->active[round & 1],
      Check<Geometry>{ { {}, data, round }, this->recordOf(round - 1) });
    this->record(round - 1);
    this->endFlipRound(data, round, most, exact);
  }

  /// All of a round but for Check.
  void endFlipRound(
    const FlipData<Geometry>& data, std::uint32_t round, std::uint32_t most, bool exact)
  {
    Counters* const c = data.counters;
    const std::uint32_t turn = round & 1;
    if (exact)
    {
      this->executor.each(most, &c->undecided[turn], CheckExact<Geometry>{ { {}, data }, round });
    }
    this->executor.each(most, &c->active[turn], Resolve<Geometry>{ { {}, data, round } });
    this->executor.each(most, &c->flips[turn], Publish<Geometry>{ { {}, data, round } });
    this->executor.each(most, &c->flips[turn], Relink<Geometry>{ { {}, data, round } });
  }

  static int slotOf(std::uint32_t round) { return static_cast<int>(round % Executor::Records); }
  /// Where the next round's first kernel writes what @p round has left.
  RoundRecord* recordOf(std::uint32_t round) { return this->executor.recordAt(slotOf(round)); }
  /// That kernel is launched.
  void record(std::uint32_t round) { this->executor.record(slotOf(round)); }
  const RoundRecord& recorded(std::uint32_t round)
  {
    return this->executor.recorded(slotOf(round));
  }
  /// Waits.
  Counters now()
  {
    Counters counted;
    this->executor.toHost(&counted, this->counters.data(), sizeof(counted));
    return counted;
  }

  template <class T>
  void download(Buffer<T>& to, Array<T>& from)
  {
    this->executor.toHost(to.data(), from.data(), to.size() * sizeof(T));
  }

  /// @param allLocated points that were left open are in the list of those alive
  void observe(RoundReport::Stage stage, std::uint32_t round, bool allLocated = true)
  {
    if (!this->observer)
    {
      return;
    }
    const Counters c = this->now();
    Buffer<Triangle> t(c.triangles);
    Buffer<Vertex> v(c.vertices);
    this->download(t, this->triangles);
    this->download(v, this->vertices);
    const bool flipping = stage == RoundReport::Stage::Flip;
    const std::uint32_t alive = c.live[round & 1] + (allLocated ? 0 : c.unlocated);
    (*this->observer)({ stage, round, flipping ? c.active[(round & 1) ^ 1] : alive, c.triangles,
      c.vertices, flipping ? c.flips[round & 1] : c.inserted, c.labelled + c.round.labelled,
      hashOf(t.data(), c.triangles, v.data(), c.vertices) });
  }

  static void addTo(Tally& tally, const Counters& counted)
  {
    const auto signedOf = [](std::uint64_t n) { return static_cast<std::int64_t>(n); };
    Statistics& s = tally.statistics;
    s.insertions += signedOf(counted.insertions);
    s.edgeChecks += signedOf(counted.edgeChecks);
    s.exactCalls += signedOf(counted.exactCalls);
    s.flips22 += signedOf(counted.flips22);
    s.flips31 += signedOf(counted.flips31);
    s.flipsD += signedOf(counted.flipsD);
    s.flipsV += signedOf(counted.flips22 + counted.flips31 - counted.flipsD);
    s.labelled += signedOf(counted.labelled);
    tally.ties += signedOf(counted.ties);
  }

  Executor& executor;
  const Geometry geometry;
  const PointSource& source;
  const CoordinateRange& range;
  const bool checkFinite;
  const bool vBiased;
  const bool measured;
  const int scaleExponent;
  Monitor& monitor;
  const RoundObserver* const observer;

  Array<Counters> counters;
  Array<Triangle> triangles;
  Array<Vertex> vertices;
  Array<std::uint64_t> keys;     ///< by triangle: of the furthest point; then votes
  Array<std::uint32_t> lowest;   ///< by vertex
  Array<std::uint32_t> sameAs;   ///< three by vertex
  Array<std::uint32_t> offsets;  ///< by candidate
  Array<std::uint32_t> lists[2]; ///< candidates, then active triangles
  Array<std::uint32_t> undecided;
  Array<PointAlive> unlocated;
  std::uint32_t growthRoundCount = 0;
  std::uint32_t flipRoundCount = 0;
};

}

#endif
