// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What every call takes: its choices, and its points.
#ifndef flipflop_Calls_h
#define flipflop_Calls_h

#include "Views.h"
#include "Watch.h"

#include <flipflop/ConvexDomain.h>
#include <flipflop/Engines.h>
#include <flipflop/Options.h>

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace flipflop
{

/// The choices that every call has.
struct Settings
{
  int threads = 0;
  bool polygons = false;
  bool ignoreNonFinite = false;
  int engine = 0;
  nanobind::object progress;

  /// From so many points on a device is used, where the engine is chosen automatically.
  std::int64_t cudaFrom = CudaPaysNever;
  bool vBiased = true;

  /// Of the last call: which engine it used, and why.
  mutable EngineReport report;

  /// Where a device has the points and the weights, too; 0: nowhere.
  std::uintptr_t pointsMemory = 0;
  std::uintptr_t weightsMemory = 0;

  Options options() const
  {
    Options options;
    options.threads = this->threads;
    options.facets = this->polygons ? FacetMode::Polygons : FacetMode::Triangles;
    options.nonFinite = this->ignoreNonFinite ? NonFinitePolicy::Ignore : NonFinitePolicy::Error;
    options.vBiased = this->vBiased;
    return options;
  }

  /// Does the work with these choices, watched, and the interpreter free.
  template <class Work>
  auto run(Work&& work) const
  {
    return Watch(this->progress).run(this->options(), std::forward<Work>(work));
  }

  EngineOptions engineOptions() const
  {
    EngineOptions chosen;
    chosen.choice = static_cast<EngineChoice>(this->engine);
    chosen.cudaFrom = this->cudaFrom;
    return chosen;
  }
};

/// Points in space: rows of two coordinates get a z of zero.
class SpacePoints
{
public:
  /// @param memory where a device has the rows, too; 0: nowhere
  explicit SpacePoints(const InputArray& array, std::uintptr_t memory = 0)
    : View(pointView(array, 2))
  {
    this->View.deviceData = deviceMemory(memory);
    if (array.shape(1) == 2)
    {
      this->View.type == ScalarType::Float32 ? this->widen(this->Singles)
                                             : this->widen(this->Doubles);
    }
  }

  const PointView& view() const { return this->View; }

private:
  template <class T>
  void widen(Buffer<T>& copy)
  {
    const T* from = static_cast<const T*>(this->View.data);
    copy.allocate(3 * static_cast<std::size_t>(this->View.count));
    for (std::int64_t i = 0; i < this->View.count; ++i)
    {
      T* const to = copy.data() + 3 * i;
      std::copy_n(from + i * this->View.stride, 2, to);
      to[2] = 0;
    }
    this->View = PointView(copy.data(), this->View.count);
  }

  PointView View;
  Buffer<float> Singles;
  Buffer<double> Doubles;
};

/// A domain: 4 numbers, or rows of x and y.
using DomainArray = nanobind::ndarray<const double, nanobind::c_contig, nanobind::device::cpu>;

/// @throw nanobind::type_error of any other shape
inline ConvexDomain domainOf(const DomainArray& array)
{
  if (array.ndim() == 1 && array.shape(0) == 4)
  {
    return ConvexDomain(array.data());
  }
  if (array.ndim() != 2 || array.shape(1) != 2 || array.shape(0) < 3)
  {
    throw nanobind::type_error("a domain is 4 numbers, or three rows or more of two");
  }
  return ConvexDomain(array.data(), static_cast<std::int64_t>(array.shape(0)));
}

/// The methods of results that are queries at positions.
void bindQueries(nanobind::module_& module);

/// Constrained triangulations, alpha complexes, and borders.
void bindComplexes(nanobind::module_& module);

/// Terrain meshes.
void bindTerrain(nanobind::module_& module);
void bindRefine(nanobind::module_& module);

/// Intersections of half-spaces.
void bindHalfSpaces(nanobind::module_& module);

/// Triangulations that are edited.
void bindEdits(nanobind::module_& module);

/// Streamed runs.
void bindStream(nanobind::module_& module);

/// Centroidal cells and prescribed areas.
void bindTransport(nanobind::module_& module);

}

#endif
