// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Streamed runs: pieces come from a callable, and blocks go to another. Records are bytes here.
#include "Calls.h"
#include "Results.h"
#include "Views.h"

#include <flipflop/BlockRun.h>
#include <flipflop/StreamedRun.h>

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/filesystem.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace nb = nanobind;
using namespace nb::literals;

namespace flipflop
{

namespace
{

using Positions = nb::ndarray<const double, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;
using Bytes = nb::ndarray<const std::uint8_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

/// What @p read returns of a piece: positions, and the records' bytes.
StreamPiece pieceOf(const nb::object& read, std::int64_t number)
{
  const nb::gil_scoped_acquire held;
  const nb::object given = read(number);
  const auto positions = nb::cast<Positions>(given[0]);
  const auto records = nb::cast<Bytes>(given[1]);
  StreamPiece piece;
  piece.positions.allocate(positions.size());
  std::copy_n(positions.data(), positions.size(), piece.positions.data());
  const auto* const bytes = reinterpret_cast<const char*>(records.data());
  piece.records.assign(bytes, bytes + records.size());
  return piece;
}

/// By name what a block has; offsets of its cells in any case.
nb::dict fieldsOf(StreamedBlock&& block)
{
  CellComplex& cells = block.result.cells;
  const std::size_t count = cells.pointIds.size();
  nb::dict found;
  found["dimension"] = cells.dimension;
  found["offsets"] = arrayOf(cellOffsets(cells));
  found["connectivity"] = arrayOf(std::move(cells.connectivity));
  found["ids"] = arrayOf(std::move(cells.pointIds));
  found["positions"] = arrayOf(std::move(block.result.positions), { count, 3 });
  found["blocks"] = arrayOf(std::move(block.result.blocks));
  found["hidden"] = arrayOf(std::move(block.result.hiddenIds));
  const auto records = std::make_shared<const std::vector<char>>(std::move(block.records));
  const auto* const bytes = reinterpret_cast<const std::uint8_t*>(records->data());
  found["records"] = arrayOf(bytes, { records->size() }, records);
  return found;
}

/// The run's report, by name.
/// @param read  called with the number of a piece; see pieceOf()
/// @param write called with the number of a block, and fieldsOf() it
nb::dict streamed(int shape, std::int64_t pieces, const std::filesystem::path& folder,
  std::int64_t memory, std::int64_t blockPoints, std::size_t recordSize, const nb::object& read,
  const nb::object& write, const Settings& settings)
{
  StreamSettings chosen;
  chosen.shape = static_cast<BlockShape>(shape);
  chosen.folder = folder;
  chosen.memory = memory;
  chosen.blockPoints = blockPoints;
  chosen.recordSize = recordSize;
  const StreamReport report = settings.run(
    [&](const Options& options)
    {
      chosen.options = options;
      return streamedRun(
        chosen, pieces, [&](std::int64_t piece) { return pieceOf(read, piece); },
        [&](StreamedBlock&& block)
        {
          const nb::gil_scoped_acquire held;
          const std::int64_t number = block.number;
          write(number, fieldsOf(std::move(block)));
        });
    });
  nb::dict found;
  found["points"] = report.points;
  found["non_finite"] = report.nonFinite;
  found["hidden"] = report.hidden;
  found["cells"] = report.cells;
  found["blocks"] = report.blocks;
  found["dimension"] = report.dimension;
  found["volume"] = report.volume;
  found["area"] = report.area;
  found["points_received"] = report.pointsReceived;
  found["bytes_written"] = report.bytesWritten;
  found["bytes_read"] = report.bytesRead;
  return found;
}

/// Files' errors are OSError, with the number and the file's name.
void translateFileErrors(const std::exception_ptr& thrown, void*)
{
  try
  {
    std::rethrow_exception(thrown);
  }
  catch (const std::filesystem::filesystem_error& error)
  {
    const int number = error.code().default_error_condition().value();
    const nb::object made =
      nb::module_::import_("vtkflipflop._errors").attr("of_file")(number, error.path1());
    PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(made.ptr())), made.ptr());
  }
}

}

void bindStream(nb::module_& module)
{
  nb::register_exception_translator(&translateFileErrors);
  module.def("stream", &streamed, "shape"_a, "pieces"_a, "folder"_a, "memory"_a, "block_points"_a,
    "record_size"_a, "read"_a, "write"_a, "settings"_a);
}

}
