// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFDistributedTriangulation.h"

#include "FFDistributedCells.h"
#include "FFOutput.h"
#include "FFPointRedistribution.h"
#include "FFProcesses.h"
#include "FFRun.h"
#include "vtkFFPlanarAlgorithm.h"

#include <flipflop/Engines.h>
#include <flipflop/PlaneFit.h>

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

/// What is done by when, as shares of the whole.
constexpr double isRead = 0.1;
constexpr double isRedistributed = 0.2;
constexpr double isTriangulated = 0.8;
constexpr double isFetched = 0.95;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A point of a view, in space.
std::array<double, 3> pointAt(const flipflop::PointView& view, std::int64_t i)
{
  std::array<double, 3> point;
  for (std::size_t k = 0; k < 3; ++k)
  {
    point[k] = FFPlanarInput::NumberAt(view, i * view.stride + static_cast<std::int64_t>(k));
  }
  return point;
}

}

//------------------------------------------------------------------------------
FFDistributedTriangulation::FFDistributedTriangulation(
  vtkFFPlanarAlgorithm* filter, FFProcesses& processes)
  : Filter(filter)
  , Processes(processes)
  , Run(processes.GetRun())
  , Source(processes)
  , Input(filter, processes.GetRun())
  , Lowest(infinity)
  , Bounds(4, infinity)
{
  std::snprintf(this->Run.EngineReport.reason, sizeof(this->Run.EngineReport.reason), "%s",
    "several processes triangulate together on their CPUs");
}

//------------------------------------------------------------------------------
void FFDistributedTriangulation::BeginStep(double end)
{
  this->Run.SetPart(this->Begin, end);
  this->Begin = end;
  FFRun::Look(this->Run.Options);
}

//------------------------------------------------------------------------------
void FFDistributedTriangulation::Compute(const std::vector<FFInput::PieceType>& pieces)
{
  this->Read(pieces);
  if (this->Filter->GetProjectionPlaneMode() == vtkFFPlanarAlgorithm::BEST_FITTING_PLANE)
  {
    this->FitPlane();
  }
  flipflop::BlockPoints block = this->Redistribute();
  this->BeginStep(isTriangulated);
  // Processes without points have no weights either.
  this->Weighted = this->Processes.Sum(vtkIdType(this->Weighted)) > 0;
  this->Cells = FFDistributedCells::Compute(
    this->Weighted ? flipflop::BlockShape::RegularTriangulation : flipflop::BlockShape::Delaunay,
    std::move(block), this->Run.Options, this->Processes);
  this->Hidden = static_cast<std::int64_t>(this->Cells.hiddenIds.size());
  if (!this->Input.GetFittedPlane() && this->Cells.cells.dimension == 1)
  {
    this->LookForVerticalPlane();
  }
}

//------------------------------------------------------------------------------
void FFDistributedTriangulation::Read(const std::vector<FFInput::PieceType>& pieces)
{
  this->BeginStep(isRead);
  if (this->Run.Engine.choice == flipflop::EngineChoice::CUDA)
  {
    throw FFBadSetting("The CUDA engine was asked for, but several processes triangulate "
                       "together on their CPUs. Set Engine to Automatic or CPU.");
  }
  auto* const only = pieces.size() == 1 ? vtkDataSet::SafeDownCast(pieces[0].Data) : nullptr;
  if (only)
  {
    this->Input.FindWeights(only); // throws what is wrong as they came: see FFPlanarInput::Take()
  }
  FFInput own;
  own.TakePieces(pieces, this->Filter->GetSkipGhostPoints(), this->Run);
  this->Run.Ids.clear(); // ids count the remaining points
  for (const auto& piece : own.GetPieces())
  {
    this->Own += piece->GetNumberOfPoints();
  }
  this->Source.Count(this->Own);
  this->Run.FirstId = this->Source.GetBegin();
  const auto points = FFOutput::Append({ own.GetPieces().begin(), own.GetPieces().end() });
  this->Input.SetPoints(points);
  this->Source.SetPoints(points);
  this->Input.SetWeights(this->FindOwnWeights());
  // Of a plane that fits, all processes have a part.
  if (this->Filter->GetProjectionPlaneMode() != vtkFFPlanarAlgorithm::BEST_FITTING_PLANE)
  {
    this->Input.Project();
  }
}

//------------------------------------------------------------------------------
vtkDataArray* FFDistributedTriangulation::FindOwnWeights()
{
  // They must be in the data that the points of all processes have.
  vtkPointSet* const points = this->Input.GetPoints();
  vtkDataArray* const array = this->Input.FindWeights(this->Source.GetKind());
  if (!array || points->GetNumberOfPoints() == 0)
  {
    return nullptr;
  }
  return this->Source.GetNumberOfSources() > 1 ? points->GetPointData()->GetArray(array->GetName())
                                               : this->Input.FindWeights(points);
}

//------------------------------------------------------------------------------
void FFDistributedTriangulation::FitPlane()
{
  // Rounded sums depend on the order, so the processes sum one after another.
  const flipflop::Options& options = this->Run.Options;
  const flipflop::PointView& view = this->Input.GetSpace();
  flipflop::PlaneSums sums;
  flipflop::PlaneSums own;
  std::vector<double> passed(sizeof(sums) / sizeof(double));
  const auto read = [&] { std::memcpy(static_cast<void*>(&sums), passed.data(), sizeof(sums)); };
  const auto passOn = [&](const std::function<void()>& add)
  {
    this->Processes.PassOn(passed,
      [&]
      {
        read();
        add();
        std::memcpy(passed.data(), &sums, sizeof(sums));
      });
    read();
  };
  flipflop::addExtent(own, view, options);
  passOn([&] { flipflop::joinExtent(sums, own); });
  passOn([&] { flipflop::addToSum(sums, view, options); });
  passOn([&] { flipflop::addToSpread(sums, view, options); });
  this->Input.SetPlane(flipflop::planeOf(sums));
}

//------------------------------------------------------------------------------
flipflop::BlockPoints FFDistributedTriangulation::Redistribute()
{
  using Point = FFPointRedistribution::Point;
  this->BeginStep(isRedistributed);
  this->Weighted = this->Input.GetWeights().data != nullptr;
  const flipflop::PointView& space = this->Input.GetSpace();
  std::vector<Point> points;
  points.reserve(static_cast<std::size_t>(space.count));
  this->NonFinite = this->Input.VisitPoints(
    [&](std::int64_t i, double x, double y, double weight)
    {
      points.push_back({ { x, y, weight }, this->Source.GetBegin() + i });
      const double bounds[4] = { x, -x, y, -y };
      for (std::size_t k = 0; k < 4; ++k)
      {
        this->Bounds[k] = std::min(this->Bounds[k], bounds[k]);
      }
      this->Lowest = std::min(this->Lowest, pointAt(space, i)[2]);
    });
  return FFPointRedistribution::Run(
    std::move(points),
    [](const Point& point) {
      return FFPointRedistribution::Key{ point.Position[0], point.Position[1] };
    },
    this->Processes);
}

//------------------------------------------------------------------------------
void FFDistributedTriangulation::LookForVerticalPlane()
{
  // The hull of the hulls is the hull. Process 0 has it.
  using Points = std::vector<std::array<double, 3>>;
  Points points;
  this->Input.VisitPoints([&](std::int64_t i, double, double, double)
    { points.push_back(pointAt(this->Input.GetSpace(), i)); });
  FFProcesses::Messages messages;
  for (const std::int64_t corner : FFPlanarInput::HullInSpace(points, this->Run.Options).pointIds)
  {
    FFProcesses::Append(&points[static_cast<std::size_t>(corner)], 1, messages[0]);
  }
  this->Processes.Exchange(messages);
  points.clear();
  for (const auto& message : messages)
  {
    const auto corners = FFProcesses::ValuesOf<Points::value_type>(message.second);
    points.insert(points.end(), corners.begin(), corners.end());
  }
  if (FFPlanarInput::HullInSpace(points, this->Run.Options).dimension > 1)
  {
    this->Input.WarnOfVerticalPlane();
  }
}

//------------------------------------------------------------------------------
std::array<double, 4> FFDistributedTriangulation::FindBounds()
{
  const std::vector<double> all = this->Processes.Least(this->Bounds);
  return { all[0], all[2], -all[1], -all[3] };
}

//------------------------------------------------------------------------------
void FFDistributedTriangulation::DropCells(const std::function<std::int64_t(
    const flipflop::PointView&, const flipflop::WeightView&, flipflop::CellComplex&)>& drop)
{
  // The positions are of the cells' points alone.
  flipflop::CellComplex& cells = this->Cells.cells;
  flipflop::Buffer<std::int64_t> ids(cells.pointIds.size());
  std::iota(ids.begin(), ids.end(), std::int64_t(0));
  std::swap(ids, cells.pointIds);
  const double* const positions = this->Cells.positions.data();
  const auto count = static_cast<std::int64_t>(ids.size());
  this->Dropped = drop({ positions, count },
    this->Weighted ? flipflop::WeightView(positions + 2, count, 3) : flipflop::WeightView(), cells);
  std::swap(ids, cells.pointIds);
}

//------------------------------------------------------------------------------
void FFDistributedTriangulation::AddGhostCells()
{
  flipflop::BlockResult all = FFDistributedCells::AddGhosts(
    this->Run.Options.facets, this->Cells, this->Processes, this->Ghosts);
  all.hiddenIds = std::move(this->Cells.hiddenIds);
  all.cells.statistics = this->Cells.cells.statistics;
  this->Cells = std::move(all);
  this->HasGhosts = true;
}

//------------------------------------------------------------------------------
void FFDistributedTriangulation::Fetch(const std::vector<vtkIdType>& ids)
{
  this->BeginStep(isFetched);
  this->Input.SetPoints(this->Source.Fetch(ids, this->Filter->GetPassPointData()));
  this->Run.Ids = ids;
  this->Run.FirstId = 0;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPointSet> FFDistributedTriangulation::Gather()
{
  std::vector<vtkIdType> ids;
  if (this->Processes.GetRank() == 0)
  {
    ids.resize(static_cast<std::size_t>(this->Source.GetNumberOfPoints()));
    std::iota(ids.begin(), ids.end(), vtkIdType(0));
  }
  return this->Source.Fetch(ids, true);
}

//------------------------------------------------------------------------------
flipflop::Triangulation FFDistributedTriangulation::FetchCells(bool withHidden)
{
  this->Duplicates = FFDistributedCells::FindDuplicates(
    this->Cells.cells.pointIds, this->Cells.blocks, this->Processes);
  flipflop::Triangulation triangulation;
  flipflop::CellComplex& cells = triangulation;
  cells = std::move(this->Cells.cells);
  if (withHidden)
  {
    triangulation.hiddenIds = std::move(this->Cells.hiddenIds);
  }
  std::vector<vtkIdType> ids;
  std::set_union(cells.pointIds.begin(), cells.pointIds.end(), triangulation.hiddenIds.begin(),
    triangulation.hiddenIds.end(), std::back_inserter(ids));
  this->Fetch(ids);
  const auto indexOf = [&](std::int64_t id)
  { return std::lower_bound(ids.begin(), ids.end(), id) - ids.begin(); };
  flipflop::Buffer<double> positions(2 * ids.size());
  std::fill(positions.begin(), positions.end(), 0.0); // those of other points are not in use
  for (std::size_t i = 0; i < cells.pointIds.size(); ++i)
  {
    cells.pointIds[i] = indexOf(cells.pointIds[i]);
    std::copy_n(this->Cells.positions.data() + 3 * i, 2, positions.data() + 2 * cells.pointIds[i]);
  }
  for (std::int64_t& id : triangulation.hiddenIds)
  {
    id = indexOf(id);
  }
  this->Input.SetPositions(std::move(positions));
  return triangulation;
}

//------------------------------------------------------------------------------
FFDistributedTriangulation::CountsType FFDistributedTriangulation::Report(
  flipflop::CellComplex& cells)
{
  const double lowest = this->Processes.Least(std::vector<double>{ this->Lowest })[0];
  // A sum with 0 is never -0: see flipflop::heightBelow().
  this->Input.SetHeight(std::isinf(lowest) ? 0.0 : lowest + 0.0);
  const std::vector<vtkIdType> own{ this->Own, this->NonFinite,
    static_cast<vtkIdType>(this->Hidden), static_cast<vtkIdType>(this->Dropped) };
  const std::vector<vtkIdType> all = this->Processes.Sum(own);
  const std::vector<vtkIdType>& counts = this->Processes.GetRank() == 0 ? all : own;
  cells.statistics.points = counts[0];
  cells.statistics.nonFinite = counts[1];
  this->BeginStep(1.0);
  return { counts[2], counts[3] };
}

//------------------------------------------------------------------------------
void FFDistributedTriangulation::MarkDuplicates(vtkPolyData* output) const
{
  FFDistributedCells::Mark(
    output->GetPointData(), this->Duplicates, vtkDataSetAttributes::DUPLICATEPOINT);
  if (this->HasGhosts)
  {
    FFDistributedCells::Mark(
      output->GetCellData(), this->Ghosts, vtkDataSetAttributes::DUPLICATECELL);
  }
}
VTK_ABI_NAMESPACE_END
