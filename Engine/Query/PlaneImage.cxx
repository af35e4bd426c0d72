// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Query/PlaneImage.h"

#include "Query/ImageScan.h"
#include "Query/TaskValues.h"
#include "Run/QueryRun.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <vector>

namespace flipflop
{

namespace
{

void requireGrid(const ImageGrid& grid, std::int64_t components)
{
  constexpr std::int64_t Most = std::int64_t(1) << 60;
  constexpr std::int64_t MostIndex = std::int64_t(1) << 52; // a double is any
  if (grid.size[0] < 1 || grid.size[1] < 1)
  {
    throw badArgument("an image must have 1 or more columns, and 1 or more rows");
  }
  if (grid.size[0] >= Most / components / grid.size[1])
  {
    throw badArgument("an image must have less than 2^60 numbers");
  }
  for (int axis = 0; axis < 2; ++axis)
  {
    const std::int64_t first = grid.firstIndex[axis];
    if (first < -MostIndex || first > MostIndex || grid.size[axis] > MostIndex - first)
    {
      throw badArgument("the indices of an image must be from -2^52 to 2^52");
    }
    // Between the first and the last position are all others.
    if (!std::isfinite(grid.origin[axis]) || !std::isfinite(grid.spacing[axis]) ||
      !std::isfinite(pixelPosition(grid, axis, 0)) ||
      !std::isfinite(pixelPosition(grid, axis, grid.size[axis] - 1)))
    {
      throw badArgument("an image's origin, spacing and pixels must be finite");
    }
  }
}

template <class T>
class PlaneImage
{
public:
  PlaneImage(const PreparedTriangulation& triangulation, const InterpolationTask& toDo,
    const ImageGrid& pixels, T* result, Monitor& monitorToUse)
    : prepared(triangulation)
    , task(toDo)
    , grid(pixels)
    , results(result)
    , monitor(monitorToUse)
  {
  }

  void make()
  {
    if (this->prepared.dimension == 2)
    {
      const PixelAxis columns(this->grid, 0, this->prepared.sites);
      const PixelAxis rows(this->grid, 1, this->prepared.sites);
      if (columns.fits() && rows.fits())
      {
        this->fill();
        if (columns.size() > 0 && rows.size() > 0)
        {
          this->makeByTriangles(columns, rows);
        }
        return;
      }
    }
    this->makeByPixels();
  }

private:
  std::int64_t pixelCount() const { return this->grid.size[0] * this->grid.size[1]; }

  void fill()
  {
    constexpr std::size_t NumbersPerTask = 1 << 18;
    const auto numbers = static_cast<std::size_t>(this->pixelCount() * this->task.components);
    this->monitor.stage(0.0, 0.05, static_cast<std::int64_t>(numbers), "filling");
    eachChunk(numbers, NumbersPerTask,
      [&](std::size_t begin, std::size_t end, std::size_t)
      {
        std::fill(this->results + begin, this->results + end, static_cast<T>(this->task.fill));
        this->monitor.advance(static_cast<std::int64_t>(end - begin));
      });
  }

  /// Each triangle finds its pixels. Those of many pixels are left for later, when their rows are
  /// shared out.
  void makeByTriangles(const PixelAxis& columns, const PixelAxis& rows)
  {
    constexpr std::size_t TrianglesPerTask = 1 << 12;
    constexpr std::size_t FewTriangles = 256;
    constexpr std::size_t Parts = 64;
    std::vector<std::uint32_t> large;
    std::mutex mutex;
    const std::size_t count = this->prepared.mesh.triangles.size();
    this->monitor.stage(0.05, 0.8, static_cast<std::int64_t>(count), "scanning triangles");
    eachChunk(count, TrianglesPerTask,
      [&](std::size_t begin, std::size_t end, std::size_t)
      {
        Task scan(*this, columns, rows);
        std::vector<std::uint32_t> later;
        for (auto t = static_cast<std::uint32_t>(begin); t < end; ++t)
        {
          const auto range = scan.pixels.rowsOf(t);
          if (scan.pixels.isLarge(t, range.second - range.first))
          {
            later.push_back(t);
            continue;
          }
          scan.addRows(t, range.first, range.second);
        }
        scan.values.finish();
        const std::lock_guard<std::mutex> lock(mutex);
        large.insert(large.end(), later.begin(), later.end());
        this->monitor.advance(static_cast<std::int64_t>(end - begin));
      });
    const std::size_t parts = large.size() > FewTriangles ? 1 : Parts;
    this->monitor.stage(0.8, 1.0, static_cast<std::int64_t>(large.size() * parts));
    eachTask(large.size() * parts,
      [&](std::size_t i)
      {
        Task scan(*this, columns, rows);
        const std::uint32_t t = large[i / parts];
        const auto range = scan.pixels.rowsOf(t);
        const std::int64_t height = range.second - range.first;
        const auto part = static_cast<std::int64_t>(i % parts);
        const auto of = static_cast<std::int64_t>(parts);
        scan.addRows(t, range.first + height * part / of, range.first + height * (part + 1) / of);
        scan.values.finish();
        this->monitor.advance(1);
      });
  }

  struct Task
  {
    Task(PlaneImage& image, const PixelAxis& imageColumns, const PixelAxis& imageRows)
      : pixels(image.prepared, imageColumns, imageRows, image.monitor)
      , values(image.prepared, image.task, image.results)
      , columns(imageColumns)
      , rows(imageRows)
      , width(image.grid.size[0])
    {
    }

    void addRows(std::uint32_t t, std::int64_t rowBegin, std::int64_t rowEnd)
    {
      this->pixels.eachPixel(t, rowBegin, rowEnd,
        [&](std::int64_t column, std::int64_t row, const auto& space, const MeshLocation& location)
        {
          const double position[] = { this->columns.position(column), this->rows.position(row) };
          this->values.addAt(this->rows.number(row) * this->width + this->columns.number(column),
            position, space, location);
        });
    }

    ImageScan pixels;
    PlaneInterpolator<T> values;
    const PixelAxis& columns;
    const PixelAxis& rows;
    std::int64_t width;
  };

  /// Each pixel finds its triangle.
  void makeByPixels()
  {
    constexpr std::size_t PixelsPerTask = 1 << 12;
    this->monitor.stage(0.0, 1.0, this->pixelCount(), "locating pixels");
    eachChunk(static_cast<std::size_t>(this->pixelCount()), PixelsPerTask,
      [&](std::size_t begin, std::size_t end, std::size_t)
      {
        PlaneInterpolator<T> values(this->prepared, this->task, this->results);
        for (auto i = static_cast<std::int64_t>(begin); i < static_cast<std::int64_t>(end); ++i)
        {
          const double position[] = { pixelPosition(this->grid, 0, i % this->grid.size[0]),
            pixelPosition(this->grid, 1, i / this->grid.size[0]) };
          values(i, position);
        }
        values.finish();
        this->monitor.advance(static_cast<std::int64_t>(end - begin));
      });
  }

  const PreparedTriangulation& prepared;
  const InterpolationTask& task;
  const ImageGrid& grid;
  T* const results;
  Monitor& monitor;
};

}

void interpolatePixels(const PreparedTriangulation& prepared, const InterpolationTask& task,
  const ImageGrid& grid, const ImageView& result, const Options& options)
{
  requireGrid(grid, task.components);
  if (!result.data)
  {
    throw badArgument("there must be room for an image: a null pointer was given");
  }
  const auto items = static_cast<std::size_t>(grid.size[0] * grid.size[1]);
  runOver(std::max(items, prepared.mesh.triangles.size()), options,
    [&](Monitor& monitor)
    {
      TaskValues values;
      InterpolationTask ready = task;
      values.prepare(prepared, static_cast<std::int64_t>(items), ready, monitor);
      if (result.type == ScalarType::Float32)
      {
        PlaneImage<float>(prepared, ready, grid, static_cast<float*>(result.data), monitor).make();
        return;
      }
      PlaneImage<double>(prepared, ready, grid, static_cast<double*>(result.data), monitor).make();
    });
}

}
