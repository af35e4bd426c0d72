// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The host executor, counting what a run would ask of a device: launches, waits, bytes copied, and
/// how many 32-byte sectors of triangles and vertices the warps of the two busiest kernels gather.
/// Counts of this kind need no device, and are the same wherever they are made.
#ifndef flipflop_CountingExecutor_h
#define flipflop_CountingExecutor_h

#include "Rounds/FlipKernels.h"
#include "Rounds/GrowthKernels.h"
#include "Rounds/HostExecutor.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace flipflop
{

/// What the warps of a kernel's launches gather. A triangle or a vertex is a sector.
struct Gathered
{
  std::int64_t items = 0;
  std::int64_t sectors = 0; ///< different ones, summed over warps

  double bytesPerItem() const
  {
    return this->items
      ? 32.0 * static_cast<double>(this->sectors) / static_cast<double>(this->items)
      : 0;
  }
};

class CountingExecutor : public HostExecutor
{
public:
  std::int64_t launches = 0;
  std::int64_t waits = 0;
  std::int64_t bytesSent = 0;
  std::int64_t bytesFetched = 0;
  Gathered relocate;
  Gathered check;

  template <class K>
  void each(std::uint32_t most, const std::uint32_t* count, const K& kernel)
  {
    this->launches += most ? 1 : 0;
    this->look(kernel, count ? std::min(most, *count) : most);
    HostExecutor::each(most, count, kernel);
  }
  void exclusiveSum(std::uint32_t* values, std::uint32_t n)
  {
    this->launches += 2; // CUB's: one sets up, one sums
    HostExecutor::exclusiveSum(values, n);
  }
  template <class See>
  bool bring(const PointSource& points, Residence& residence, const See& see)
  {
    const std::size_t each = points.isOfFloats() ? sizeof(float) : sizeof(double);
    this->bytesSent += std::int64_t(points.count()) *
      static_cast<std::int64_t>(static_cast<std::size_t>(points.scalarsEach()) * each);
    ++this->waits;
    return HostExecutor::bring(points, residence, see);
  }
  void fromHost(void* to, const void* from, std::size_t bytes)
  {
    this->bytesSent += static_cast<std::int64_t>(bytes);
    ++this->waits;
    HostExecutor::fromHost(to, from, bytes);
  }
  void toHost(void* to, const void* from, std::size_t bytes)
  {
    this->bytesFetched += static_cast<std::int64_t>(bytes);
    ++this->waits;
    HostExecutor::toHost(to, from, bytes);
  }
  int sort(std::uint64_t* const* keys, std::uint32_t* const* values, std::uint32_t n, int bits)
  {
    this->launches += 2 + (bits + 7) / 8; // CUB's: histogram, sums, and one a pass
    return HostExecutor::sort(keys, values, n, bits);
  }
  void toHostWidened(std::int64_t* to, const std::uint32_t* from, std::size_t n)
  {
    this->bytesFetched += static_cast<std::int64_t>(n * sizeof(std::uint32_t));
    ++this->waits;
    HostExecutor::toHostWidened(to, from, n);
  }
  const RoundRecord& recorded(int slot)
  {
    ++this->waits;
    return HostExecutor::recorded(slot);
  }

private:
  static constexpr std::uint32_t WarpSize = 32;
  static constexpr std::uint64_t OfVertices = std::uint64_t(1) << 32;

  template <class K>
  void look(const K&, std::uint32_t)
  {
  }

  /// @param touch void (i): add what item i gathers to `touched`
  template <class Touch>
  void gather(Gathered& gathered, std::uint32_t items, const Touch& touch)
  {
    gathered.items += items;
    for (std::uint32_t begin = 0; begin < items; begin += WarpSize)
    {
      this->touched.clear();
      for (std::uint32_t i = begin; i < std::min(items, begin + WarpSize); ++i)
      {
        touch(i);
      }
      std::sort(this->touched.begin(), this->touched.end());
      gathered.sectors +=
        std::unique(this->touched.begin(), this->touched.end()) - this->touched.begin();
    }
  }
  void touchTriangle(std::uint32_t t) { this->touched.push_back(t); }
  void touchVertex(std::uint32_t v) { this->touched.push_back(OfVertices | v); }

  template <class Geometry>
  void look(const Relocate<Geometry>& kernel, std::uint32_t items)
  {
    const GrowthData<Geometry>& data = kernel.data;
    const Triangle* const triangles = data.mesh.triangles;
    const PointAlive* const live = data.live[(kernel.round & 1) ^ 1];
    this->gather(this->relocate, items,
      [&](std::uint32_t i)
      {
        const std::uint32_t t = live[i].triangle;
        const std::uint32_t next = triangleOf(triangles[t].twin[1]);
        this->touchTriangle(t);
        this->touchTriangle(next);
        for (const std::uint32_t v : triangles[t].v)
        {
          this->touchVertex(v);
        }
        this->touchVertex(triangles[next].v[1]);
      });
  }

  template <class Geometry>
  void look(const Check<Geometry>& kernel, std::uint32_t items)
  {
    const Mesh& mesh = kernel.data().mesh;
    const std::uint32_t* const active = kernel.data().active[kernel.round & 1];
    this->gather(this->check, items,
      [&](std::uint32_t i)
      {
        const Triangle& triangle = mesh.triangles[active[i]];
        this->touchTriangle(active[i]);
        for (int e = 0; e < 3 && !(triangle.flags & TriangleDead); ++e)
        {
          const std::uint32_t twin = triangle.twin[e];
          this->touchTriangle(triangleOf(twin));
          this->touchVertex(triangle.v[e]);
          this->touchVertex(mesh.origin(previousHalfEdge(twin)));
        }
      });
  }

  std::vector<std::uint64_t> touched;
};

}

#endif
