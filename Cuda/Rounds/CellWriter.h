// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The finish in the executor's memory, where no sign was a tie: the host gets ids and cells only,
/// a third of the bytes that the polyhedron takes, and has no pass over them to make.
#ifndef flipflop_CellWriter_h
#define flipflop_CellWriter_h

#include "FlipFlop/FinishedCells.h"
#include "Rounds/ExecutorArray.h"
#include "Rounds/FinishKernels.h"
#include <flipflop/Error.h>

#include <cstdint>
#include <vector>

namespace flipflop
{

template <class Executor>
class CellWriter
{
public:
  template <class T>
  using Array = ExecutorArray<Executor, T>;

  /// @param spaceForKeys, spaceForThirds  arrays of which nothing is needed any more
  CellWriter(
    Executor& where, Array<std::uint64_t>& spaceForKeys, Array<std::uint32_t> (&spaceForThirds)[2])
    : executor(where)
    , keys(spaceForKeys)
    , thirds(spaceForThirds)
  {
  }

  /// @param mesh, lowest, sameAs   of the finished rounds
  /// @param counted                the counters, with no ties
  /// @param counters               in the executor's memory
  /// @param ids                    are below this
  /// @param measure                of the scaled coordinates; null: none is wanted
  /// @return whether it could: not where a vertex that went had duplicates
  bool write(const Mesh& mesh, const std::uint32_t* lowest, const std::uint32_t* sameAs,
    const Counters& counted, Counters* counters, std::uint32_t ids, const Measure* measure,
    FinishedCells& result)
  {
    const std::uint32_t t = counted.triangles;
    const std::uint32_t v = counted.vertices;
    const std::uint32_t wordCount = (ids + FinishData::WordSize - 1) / FinishData::WordSize;
    Array<std::uint64_t> words(this->executor, wordCount);
    Array<std::uint32_t> below(this->executor, wordCount);
    Array<std::uint32_t> rank(this->executor, v);
    Array<std::uint32_t> sorted(this->executor, v);
    Array<MeasureSums> sums(this->executor, FinishData::SumCount);
    this->keys.reserve(t);
    this->thirds[0].reserve(t);
    this->thirds[1].reserve(t);
    this->executor.fill(words.data(), 0, wordCount * sizeof(std::uint64_t));
    this->executor.fill(sums.data(), 0, FinishData::SumCount * sizeof(MeasureSums));

    int cornerBits = 1;
    while (cornerBits < 32 && v >> cornerBits != 0)
    {
      ++cornerBits;
    }
    const FinishData data = { mesh, lowest, sameAs, words.data(), below.data(), rank.data(),
      sorted.data(), this->keys.data(), this->thirds[0].data(), cornerBits, sums.data(), counters };
    this->executor.each(v, nullptr, MarkIds{ {}, data });
    this->executor.each(wordCount, nullptr, CountIds{ {}, data });
    this->executor.exclusiveSum(below.data(), wordCount);
    this->executor.each(v, nullptr, RankPoints{ {}, data, wordCount - 1 });
    if (measure)
    {
      this->executor.each(t, nullptr, MakeMeasuredCells{ { {}, data }, *measure });
    }
    else
    {
      this->executor.each(t, nullptr, MakeCells{ {}, data });
    }
    Counters finished;
    this->executor.toHost(&finished, counters, sizeof(finished));
    ensure(!finished.labelledAlive); // or a flip is missing
    if (finished.duplicatesGone)
    {
      return false;
    }
    Array<std::uint32_t> corners(this->executor, 3 * std::size_t(finished.cells));
    this->sortCells(finished.cells, cornerBits, corners);

    this->executor.beginPart("copy to the host");
    result.pointIds.allocate(finished.points);
    result.connectivity.allocate(3 * std::size_t(finished.cells));
    this->executor.toHostWidened(result.pointIds.data(), sorted.data(), result.pointIds.size());
    this->executor.toHostWidened(
      result.connectivity.data(), corners.data(), result.connectivity.size());
    if (measure)
    {
      this->fetchMeasures(sums, *measure, result);
    }
    return true;
  }

private:
  void sortCells(std::uint32_t count, int cornerBits, Array<std::uint32_t>& corners)
  {
    Array<std::uint64_t> other(this->executor, count);
    std::uint64_t* const keyBuffers[2] = { this->keys.data(), other.data() };
    std::uint32_t* const thirdBuffers[2] = { this->thirds[0].data(), this->thirds[1].data() };
    const int at = this->executor.sort(keyBuffers, thirdBuffers, count, 2 * cornerBits);
    this->executor.each(count, nullptr,
      WriteCells{ {}, keyBuffers[at], thirdBuffers[at], cornerBits, corners.data() });
  }

  void fetchMeasures(Array<MeasureSums>& sums, const Measure& measure, FinishedCells& result)
  {
    std::vector<MeasureSums> parts(FinishData::SumCount);
    this->executor.toHost(parts.data(), sums.data(), parts.size() * sizeof(MeasureSums));
    MeasureSums total;
    for (const MeasureSums& part : parts)
    {
      total.add(part);
    }
    Hull hull;
    hull.dimension = 3;
    measure.write(total, hull);
    result.volume = hull.volume;
    result.area = hull.area;
  }

  Executor& executor;
  Array<std::uint64_t>& keys;
  Array<std::uint32_t> (&thirds)[2];
};

}

#endif
