// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The engine's results as Python's objects: their arrays are the engine's memory, which lives as
/// long as one of them.
#ifndef flipflop_Results_h
#define flipflop_Results_h

#include "Views.h"

#include <flipflop/CellComplex.h>
#include <flipflop/Neighbors.h>
#include <flipflop/Statistics.h>
#include <flipflop/Validate.h>

#include <nanobind/nanobind.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

namespace flipflop
{

/// A result that Python's objects share: alone, or as a part of a batch.
template <class Result>
struct Handle
{
  std::shared_ptr<const Result> result;
};

template <class Result>
Handle<Result> handleOf(Result&& result)
{
  return { std::make_shared<const Result>(std::move(result)) };
}

/// All counts and times by their names in Statistics.h.
inline nanobind::dict dictOf(const Statistics& statistics)
{
  nanobind::dict found;
  Statistics::eachField([&](const char* name, auto field) { found[name] = statistics.*field; });
  found["threads"] = statistics.threads;
  return found;
}

/// Corners, which are indices in pointIds, as ids of the caller's points.
inline Buffer<std::int64_t> idsOf(const CellComplex& cells, const Buffer<std::int64_t>& corners)
{
  Buffer<std::int64_t> ids(corners.size());
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    ids[i] = cells.pointIds[static_cast<std::size_t>(corners[i])];
  }
  return ids;
}

/// Where each cell begins, and the end of the last one.
inline Buffer<std::int64_t> cellOffsets(const CellComplex& cells)
{
  Buffer<std::int64_t> offsets(static_cast<std::size_t>(cells.cellCount()) + 1);
  for (std::size_t i = 0; i < offsets.size(); ++i)
  {
    offsets[i] =
      cells.offsets.empty() && !cells.cellSize ? 0 : cells.cellBegin(static_cast<std::int64_t>(i));
  }
  return offsets;
}

inline Buffer<std::int64_t> copyOf(const Buffer<std::int64_t>& from)
{
  Buffer<std::int64_t> to(from.size());
  std::copy(from.begin(), from.end(), to.begin());
  return to;
}

/// A copy of the cells alone.
template <class Result>
Result cellsOf(const Result& given)
{
  Result copy;
  copy.dimension = given.dimension;
  copy.pointIds = copyOf(given.pointIds);
  copy.connectivity = copyOf(given.connectivity);
  copy.offsets = copyOf(given.offsets);
  copy.cellSize = given.cellSize;
  return copy;
}

/// A copy, its polygons as fans of triangles.
template <class Result>
Result fansOf(const Result& given)
{
  Result fans = cellsOf(given);
  fanPolygons(fans);
  return fans;
}

/// What check() finds, with the interpreter free.
template <class Check>
nanobind::tuple checkedBy(const Check& check)
{
  Validation found;
  {
    const nanobind::gil_scoped_release free;
    found = check();
  }
  return nanobind::make_tuple(static_cast<int>(found.fault), describe(found.fault), found.index);
}

/// What hulls and triangulations have in common.
template <class Result>
nanobind::class_<Handle<Result>> bindCells(nanobind::module_& module, const char* name)
{
  using Self = const Handle<Result>&;
  return nanobind::class_<Handle<Result>>(module, name)
    .def_prop_ro("dimension", [](Self self) { return self.result->dimension; })
    .def_prop_ro("cell_count", [](Self self) { return self.result->cellCount(); })
    .def_prop_ro("cell_size", [](Self self) { return self.result->cellSize; })
    .def_prop_ro("statistics", [](Self self) { return dictOf(self.result->statistics); })
    .def("vertices", [](Self self) { return arrayOf(self.result->pointIds, self.result); })
    .def("offsets", [](Self self) { return arrayOf(cellOffsets(*self.result)); })
    // Of the corners of all cells: indices in vertices(), not ids.
    .def("connectivity", [](Self self) { return arrayOf(self.result->connectivity, self.result); })
    .def(
      "corners", [](Self self) { return arrayOf(idsOf(*self.result, self.result->connectivity)); })
    .def("triangles",
      [](Self self)
      {
        const bool areTriangles = self.result->dimension < 2 || self.result->cellSize == 3;
        return areTriangles ? self : handleOf(fansOf(*self.result));
      })
    .def("neighbors", [](Self self) { return arrayOf(cellNeighbors(*self.result)); });
}

}

#endif
