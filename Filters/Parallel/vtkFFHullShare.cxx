// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFHullShare.h"

#include "vtkFFBlockExchange.h"
#include "vtkFFBlockRounds.h"
#include "vtkFFDuplicates.h"
#include "vtkFFOutput.h"
#include "vtkFFPointDealing.h"
#include "vtkFFPointFetch.h"
#include "vtkFFRun.h"

#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

using Point = vtkFFPointDealing::Point;

/// The direction in which a point lies, on the faces of an octahedron that is laid out in a square.
vtkFFPointDealing::Key directionOf(const double* x, const std::array<double, 3>& middle)
{
  double d[3];
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    d[k] = 0.5 * x[k] - 0.5 * middle[k]; // the whole may overflow
    sum += std::fabs(d[k]);
  }
  if (!(sum > 0.0) || !std::isfinite(sum))
  {
    return {};
  }
  const double u = d[0] / sum;
  const double v = d[1] / sum;
  // The lower faces are folded up, outside the upper ones. 0 and -0 are one place.
  return d[2] >= 0.0 ? vtkFFPointDealing::Key{ u + 0.0, v + 0.0 }
                     : vtkFFPointDealing::Key{ (u >= 0.0 ? 1.0 : -1.0) * (1.0 - std::fabs(v)),
                         (v >= 0.0 ? 1.0 : -1.0) * (1.0 - std::fabs(u)) };
}

/// The middle of all processes' points.
std::array<double, 3> middleOf(const std::vector<Point>& points, vtkFFBlockExchange& exchange)
{
  std::array<double, 3> middle{};
  for (std::size_t k = 0; k < 3; ++k)
  {
    double low = std::numeric_limits<double>::infinity();
    double negatedHigh = low;
    for (const Point& point : points)
    {
      low = std::min(low, point.Place[k]);
      negatedHigh = std::min(negatedHigh, -point.Place[k]);
    }
    low = exchange.GetProcesses().Least(low);
    middle[k] = 0.5 * low - 0.5 * exchange.GetProcesses().Least(negatedHigh);
  }
  return middle;
}

}

//------------------------------------------------------------------------------
void vtkFFHullShare::Take(vtkPolyData* extremes, const flipflop::Options& options,
  vtkFFBlockExchange& exchange, flipflop::Hull& hull, vtkSmartPointer<vtkPolyData>& share,
  std::vector<bool>& duplicates)
{
  // Ids count the extreme points. They are in the order of the ids that these have.
  vtkFFPointFetch source(exchange);
  source.Count(extremes->GetNumberOfPoints());
  source.SetPoints(extremes);
  std::vector<Point> points;
  exchange.Do(
    [&]
    {
      vtkFFRun::Look(options);
      for (vtkIdType i = 0; i < extremes->GetNumberOfPoints(); ++i)
      {
        Point point;
        extremes->GetPoint(i, point.Place);
        point.Id = source.GetBegin() + i;
        if (std::all_of(point.Place, point.Place + 3, [](double x) { return std::isfinite(x); }))
        {
          points.push_back(point);
        }
      }
    });
  exchange.Agree();
  const std::array<double, 3> middle = middleOf(points, exchange);
  flipflop::BlockPoints dealt;
  flipflop::BlockResult result;
  vtkFFBlockRounds::Size size;
  vtkFFPointDealing::Deal(
    std::move(points), [&](const Point& point) { return directionOf(point.Place, middle); },
    exchange, dealt);
  vtkFFBlockRounds::Run(
    flipflop::BlockShape::Hull, std::move(dealt), options, exchange, result, &size);

  const std::vector<vtkIdType> ids(result.cells.pointIds.begin(), result.cells.pointIds.end());
  vtkSmartPointer<vtkPointSet> fetched;
  source.Fetch(ids, true, fetched);
  vtkFFDuplicates::FindByIds(result.cells.pointIds, result.blocks, exchange, duplicates);
  exchange.Do(
    [&]
    {
      vtkFFRun::Look(options);
      share = vtkSmartPointer<vtkPolyData>::New();
      if (ids.empty())
      {
        // One point of the kind, which is left out.
        fetched->GetPoints()->SetNumberOfPoints(0);
        fetched->GetPointData()->SetNumberOfTuples(0);
      }
      share->SetPoints(fetched->GetPoints());
      share->GetPointData()->ShallowCopy(fetched->GetPointData());
      hull.dimension = result.cells.dimension;
      hull.volume = size.Volume;
      hull.area = size.Area;
      hull.statistics += result.cells.statistics;
      vtkFFOutput::AdoptCells(result.cells, share);
    });
  exchange.Agree();
}
VTK_ABI_NAMESPACE_END
