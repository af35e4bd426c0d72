// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Points/CornerPoints.h"

#include "Support/Parallel.h"
#include "Support/VectorClones.h"

#include <algorithm>
#include <cmath>
#include <mutex>

namespace flipflop
{

namespace
{

constexpr int Block = 256;
constexpr int Corners = 8;

/// Accumulators of their own, so that a loop over them fills vector registers.
constexpr int Slots = 8;

/// How far a point lies towards the first four corners; the others are opposite to them.
inline void sumsOf(double x, double y, double z, double* sum)
{
  sum[0] = (x + y) + z;
  sum[1] = (x + y) - z;
  sum[2] = (x - y) + z;
  sum[3] = (x - y) - z;
}

/// The furthest of a block.
FF_VECTOR_CLONES
void furthestOf(const double* x, const double* y, const double* z, double* furthest)
{
  double most[Corners][Slots];
  for (auto& slots : most)
  {
    for (double& slot : slots)
    {
      slot = -HUGE_VAL;
    }
  }
  for (int i = 0; i < Block; i += Slots)
  {
    for (int k = 0; k < Slots; ++k)
    {
      double sum[4];
      sumsOf(x[i + k], y[i + k], z[i + k], sum);
      for (int c = 0; c < 4; ++c)
      {
        most[c][k] = sum[c] > most[c][k] ? sum[c] : most[c][k];
        most[c + 4][k] = -sum[c] > most[c + 4][k] ? -sum[c] : most[c + 4][k];
      }
    }
  }
  for (int c = 0; c < Corners; ++c)
  {
    furthest[c] = *std::max_element(most[c], most[c] + Slots);
  }
}

/// Points of a block axis by axis, the last one again up to its end.
struct Points
{
  Points(const PointSource& source, std::uint32_t begin)
    : count(static_cast<int>(std::min<std::uint32_t>(Block, source.count() - begin)))
  {
    source.load(begin, this->count, this->x, this->y, this->z);
    for (int i = this->count; i < Block; ++i)
    {
      this->x[i] = this->x[i - 1];
      this->y[i] = this->y[i - 1];
      this->z[i] = this->z[i - 1];
    }
  }

  double x[Block], y[Block], z[Block];
  int count;
};

/// The furthest point towards a corner, and the first block that has one.
struct Furthest
{
  double value = -HUGE_VAL;
  std::uint32_t block = 0;

  void add(double other, std::uint32_t at)
  {
    if (other > this->value || (other == this->value && at < this->block))
    {
      *this = { other, at };
    }
  }
};

}

std::vector<std::uint32_t> cornerPoints(const PointSource& source, Monitor& monitor)
{
  constexpr std::size_t PointsPerTask = std::size_t(1) << 16;
  std::mutex mutex;
  Furthest furthest[Corners];
  eachChunk(source.count(), PointsPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t)
    {
      Furthest own[Corners];
      double values[Corners];
      for (std::size_t at = begin; at < end; at += Block)
      {
        const Points points(source, static_cast<std::uint32_t>(at));
        furthestOf(points.x, points.y, points.z, values);
        for (int c = 0; c < Corners; ++c)
        {
          own[c].add(values[c], static_cast<std::uint32_t>(at));
        }
      }
      monitor.poll();
      const std::lock_guard<std::mutex> lock(mutex);
      for (int c = 0; c < Corners; ++c)
      {
        furthest[c].add(own[c].value, own[c].block);
      }
    });
  std::vector<std::uint32_t> ids;
  for (int c = 0; c < Corners; ++c)
  {
    const Points points(source, furthest[c].block);
    int i = -1;
    double sum[4];
    do
    {
      ++i;
      sumsOf(points.x[i], points.y[i], points.z[i], sum);
    } while ((c < 4 ? sum[c] : -sum[c - 4]) != furthest[c].value);
    ids.push_back(furthest[c].block + static_cast<std::uint32_t>(i));
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

}
