// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFJointTriangulation.h"

#include "vtkFFBlockRounds.h"
#include "vtkFFDuplicates.h"
#include "vtkFFGhostCells.h"
#include "vtkFFPieces.h"
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
constexpr double taken = 0.1;
constexpr double dealt = 0.2;
constexpr double triangulated = 0.8;
constexpr double fetched = 0.95;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A point of a view, in space.
std::array<double, 3> pointAt(const flipflop::PointView& view, std::int64_t i)
{
  std::array<double, 3> point;
  for (std::size_t k = 0; k < 3; ++k)
  {
    point[k] = vtkFFPlanarInput::NumberAt(view, i * view.stride + static_cast<std::int64_t>(k));
  }
  return point;
}

}

//------------------------------------------------------------------------------
vtkFFJointTriangulation::vtkFFJointTriangulation(
  vtkFFPlanarAlgorithm* filter, vtkMultiProcessController* controller, vtkFFRun& run)
  : Filter(filter)
  , Run(run)
  , Exchange(controller, run)
  , Source(Exchange)
  , Input(filter, run)
  , Lowest(infinity)
{
  this->Bounds.fill(infinity);
  std::snprintf(run.Report.reason, sizeof(run.Report.reason), "%s",
    "several processes triangulate together on their CPUs");
}

//------------------------------------------------------------------------------
void vtkFFJointTriangulation::Do(double share, const std::function<void()>& work)
{
  this->Exchange.Do(
    [&]
    {
      this->Run.SetPart(this->Share, share);
      vtkFFRun::Look(this->Run.Options);
      work();
    });
  this->Share = share;
}

//------------------------------------------------------------------------------
void vtkFFJointTriangulation::Triangulate(const std::vector<vtkFFInput::PieceType>& pieces)
{
  this->Take(pieces);
  this->FitPlane();
  this->Deal();
  this->FindCells();
  this->LookForVerticalPlane();
}

//------------------------------------------------------------------------------
void vtkFFJointTriangulation::Take(const std::vector<vtkFFInput::PieceType>& pieces)
{
  vtkFFInput own;
  this->Do(0.0,
    [&]
    {
      if (this->Run.Engine.choice == flipflop::EngineChoice::CUDA)
      {
        throw vtkFFBadSetting("The CUDA engine was asked for, but several processes triangulate "
                              "together on their CPUs. Set Engine to Automatic or CPU.");
      }
      auto* const only = pieces.size() == 1 ? vtkDataSet::SafeDownCast(pieces[0].Data) : nullptr;
      if (only)
      {
        this->Input.FindWeights(only); // are judged as they came: see vtkFFPlanarInput::Take()
      }
      own.TakePieces(pieces, this->Filter->GetSkipGhostPoints(), this->Run);
      this->Run.Ids.clear(); // ids count the points that are left
      for (const auto& piece : own.GetPieces())
      {
        this->Own += piece->GetNumberOfPoints();
      }
    });
  this->Exchange.Agree();
  this->Source.Count(this->Own);
  this->Run.FirstId = this->Source.GetBegin();
  vtkSmartPointer<vtkPointSet> points;
  this->Do(taken / 2,
    [&]
    {
      points = vtkFFPieces::Append({ own.GetPieces().begin(), own.GetPieces().end() });
      this->Input.SetPoints(points);
    });
  this->Exchange.Agree();
  this->Source.SetPoints(points);
  this->Do(taken,
    [&]
    {
      this->Input.SetWeights(this->FindOwnWeights());
      if (this->Filter->GetProjectionPlaneMode() == vtkFFPlanarAlgorithm::BEST_FITTING_PLANE)
      {
        this->Input.MakeProjection(); // of which all processes have a part
      }
      else
      {
        this->Input.Project();
      }
    });
  this->Exchange.Agree();
}

//------------------------------------------------------------------------------
vtkDataArray* vtkFFJointTriangulation::FindOwnWeights()
{
  // They must be in the data that the points of all processes have.
  vtkPointSet* const points = this->Input.GetPoints();
  vtkDataArray* const array = this->Input.FindWeights(this->Source.GetKind());
  if (!array || points->GetNumberOfPoints() == 0)
  {
    return nullptr;
  }
  return this->Source.HasSeveralSources() ? points->GetPointData()->GetArray(array->GetName())
                                          : this->Input.FindWeights(points);
}

//------------------------------------------------------------------------------
void vtkFFJointTriangulation::FitPlane()
{
  if (this->Filter->GetProjectionPlaneMode() != vtkFFPlanarAlgorithm::BEST_FITTING_PLANE)
  {
    return;
  }
  // Rounded sums depend on the order, so the processes sum one after another.
  vtkFFProjection& projection = this->Input.GetProjection();
  const flipflop::PointView& view = this->Input.GetSpace().GetView();
  flipflop::PlaneSums sums;
  std::vector<double> passed(sizeof(sums) / sizeof(double));
  const auto passOn = [&](const std::function<void()>& add)
  {
    this->Exchange.GetProcesses().PassOn(passed,
      [&]
      {
        std::memcpy(static_cast<void*>(&sums), passed.data(), sizeof(sums));
        this->Do(taken, add);
        std::memcpy(passed.data(), &sums, sizeof(sums));
      });
    std::memcpy(static_cast<void*>(&sums), passed.data(), sizeof(sums));
  };
  flipflop::PlaneSums own;
  this->Do(taken, [&] { projection.AddExtent(view, own); });
  passOn([&] { vtkFFProjection::JoinExtent(sums, own); });
  passOn([&] { projection.AddToSum(view, sums); });
  passOn([&] { projection.AddToSpread(view, sums); });
  this->Do(taken, [&] { projection.ToPlane(view, sums); });
  this->Exchange.Agree();
}

//------------------------------------------------------------------------------
void vtkFFJointTriangulation::Deal()
{
  std::vector<vtkFFPointDealing::Point> points;
  this->Do(dealt,
    [&]
    {
      this->Weighted = this->Input.GetWeights().data != nullptr;
      const flipflop::PointView& space = this->Input.GetSpace().GetView();
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
    });
  vtkFFPointDealing::Deal(
    std::move(points),
    [](const vtkFFPointDealing::Point& point) {
      return vtkFFPointDealing::Key{ point.Place[0], point.Place[1] };
    },
    this->Exchange, this->Dealt);
}

//------------------------------------------------------------------------------
void vtkFFJointTriangulation::FindCells()
{
  // Processes without points have no weights either.
  this->Weighted = this->Exchange.GetProcesses().Sum(vtkIdType(this->Weighted)) > 0;
  this->Run.SetPart(dealt, triangulated);
  this->Share = triangulated;
  vtkFFBlockRounds::Run(
    this->Weighted ? flipflop::BlockShape::RegularTriangulation : flipflop::BlockShape::Delaunay,
    std::move(this->Dealt), this->Run.Options, this->Exchange, this->Cells);
  this->Hidden = static_cast<std::int64_t>(this->Cells.hiddenIds.size());
}

//------------------------------------------------------------------------------
void vtkFFJointTriangulation::LookForVerticalPlane()
{
  if (!this->Input.GetProjection().IsXYPlane() || this->Cells.cells.dimension != 1)
  {
    return;
  }
  // The hull of the hulls is the hull.
  vtkFFBlockExchange::Messages messages;
  this->Do(triangulated,
    [&]
    {
      const flipflop::PointView& space = this->Input.GetSpace().GetView();
      std::vector<std::array<double, 3>> points;
      this->Input.VisitPoints(
        [&](std::int64_t i, double, double, double) { points.push_back(pointAt(space, i)); });
      for (const std::int64_t corner :
        vtkFFPlanarInput::HullInSpace(points, this->Run.Options).pointIds)
      {
        vtkFFBlockExchange::Add(&points[static_cast<std::size_t>(corner)], 1, messages[0]);
      }
    });
  this->Exchange.Exchange(messages);
  this->Do(triangulated,
    [&]
    {
      std::vector<std::array<double, 3>> points;
      for (const auto& message : messages)
      {
        const auto corners = vtkFFBlockExchange::Values<std::array<double, 3>>(message.second);
        points.insert(points.end(), corners.begin(), corners.end());
      }
      if (vtkFFPlanarInput::HullInSpace(points, this->Run.Options).dimension == 2)
      {
        this->Input.WarnOfVerticalPlane();
      }
    });
  this->Exchange.Agree();
}

//------------------------------------------------------------------------------
std::array<double, 4> vtkFFJointTriangulation::FindBounds()
{
  std::array<double, 4> corners;
  for (std::size_t k = 0; k < 4; ++k)
  {
    corners[k % 2 * 2 + k / 2] =
      (k % 2 ? -1.0 : 1.0) * this->Exchange.GetProcesses().Least(this->Bounds[k]);
  }
  return corners;
}

//------------------------------------------------------------------------------
void vtkFFJointTriangulation::Execute(const std::vector<vtkFFInput::PieceType>& pieces,
  bool withGhosts, const StepsType& steps, vtkPolyData* output)
{
  this->Triangulate(pieces);
  this->Do(triangulated,
    [&]
    {
      // The places are of the cells' points alone.
      flipflop::CellComplex& cells = this->Cells.cells;
      flipflop::Buffer<std::int64_t> ids(cells.pointIds.size());
      std::iota(ids.begin(), ids.end(), std::int64_t(0));
      std::swap(ids, cells.pointIds);
      const double* const places = this->Cells.positions.data();
      const auto count = static_cast<std::int64_t>(ids.size());
      this->Dropped = steps.Drop({ places, count },
        this->Weighted ? flipflop::WeightView(places + 2, count, 3) : flipflop::WeightView(),
        cells);
      std::swap(ids, cells.pointIds);
    });
  flipflop::Triangulation triangulation;
  if (withGhosts)
  {
    this->AddGhostCells();
  }
  this->FetchCells(steps.HasHidden, triangulation);
  const CountsType counts = this->Report(triangulation);
  this->Do(1.0,
    [&]
    {
      steps.Write(this->Input, triangulation);
      vtkFFDuplicates::Mark(
        output->GetPointData(), this->Duplicates, vtkDataSetAttributes::DUPLICATEPOINT);
      if (withGhosts)
      {
        vtkFFDuplicates::Mark(
          output->GetCellData(), this->Ghosts, vtkDataSetAttributes::DUPLICATECELL);
      }
      vtkFFRun::Look(this->Run.Options, 1.0);
    });
  this->Exchange.Agree();
  this->Run.AddToReport(triangulation, output);
  steps.Report(counts.Hidden, counts.Dropped);
}

//------------------------------------------------------------------------------
void vtkFFJointTriangulation::AddGhostCells()
{
  flipflop::BlockResult all;
  vtkFFGhostCells::Add(this->Run.Options.facets, this->Cells, this->Exchange, all, this->Ghosts);
  all.hiddenIds = std::move(this->Cells.hiddenIds);
  all.cells.statistics = this->Cells.cells.statistics;
  this->Cells = std::move(all);
}

//------------------------------------------------------------------------------
void vtkFFJointTriangulation::Fetch(const std::vector<vtkIdType>& ids)
{
  vtkSmartPointer<vtkPointSet> points;
  this->Source.Fetch(ids, this->Filter->GetPassPointData(), points);
  this->Do(fetched,
    [&]
    {
      this->Input.SetPoints(points);
      this->Run.Ids = ids;
      this->Run.FirstId = 0;
    });
  this->Exchange.Agree();
}

//------------------------------------------------------------------------------
std::int64_t vtkFFJointTriangulation::IndexOf(std::int64_t id) const
{
  const std::vector<vtkIdType>& ids = this->Run.Ids;
  return std::lower_bound(ids.begin(), ids.end(), id) - ids.begin();
}

//------------------------------------------------------------------------------
void vtkFFJointTriangulation::FetchCells(bool withHidden, flipflop::Triangulation& triangulation)
{
  flipflop::CellComplex& cells = triangulation;
  std::vector<vtkIdType> ids;
  this->Do(triangulated,
    [&]
    {
      const auto& visible = this->Cells.cells.pointIds;
      if (withHidden)
      {
        triangulation.hiddenIds = std::move(this->Cells.hiddenIds);
      }
      const auto& hidden = triangulation.hiddenIds;
      std::set_union(
        visible.begin(), visible.end(), hidden.begin(), hidden.end(), std::back_inserter(ids));
    });
  vtkFFDuplicates::FindByIds(
    this->Cells.cells.pointIds, this->Cells.blocks, this->Exchange, this->Duplicates);
  this->Fetch(ids);
  this->Do(fetched,
    [&]
    {
      flipflop::Buffer<double> places(2 * ids.size());
      std::fill(places.begin(), places.end(), 0.0); // nobody asks for those of other points
      cells = std::move(this->Cells.cells);
      for (std::size_t i = 0; i < cells.pointIds.size(); ++i)
      {
        cells.pointIds[i] = this->IndexOf(cells.pointIds[i]);
        std::copy_n(this->Cells.positions.data() + 3 * i, 2, places.data() + 2 * cells.pointIds[i]);
      }
      for (std::int64_t& id : triangulation.hiddenIds)
      {
        id = this->IndexOf(id);
      }
      this->Input.GetProjection().SetPlaces(std::move(places));
    });
  this->Exchange.Agree();
}

//------------------------------------------------------------------------------
vtkFFJointTriangulation::CountsType vtkFFJointTriangulation::Report(flipflop::CellComplex& cells)
{
  vtkFFProcesses& processes = this->Exchange.GetProcesses();
  const double lowest = processes.Least(this->Lowest);
  // A sum with 0 is never -0: see vtkFFPlanarInput::SetHeight().
  this->Do(fetched,
    [&] { this->Input.GetProjection().SetHeight(std::isinf(lowest) ? 0.0 : lowest + 0.0); });
  std::vector<vtkIdType> counts{ this->Own, this->NonFinite, static_cast<vtkIdType>(this->Hidden),
    static_cast<vtkIdType>(this->Dropped) };
  const std::vector<vtkIdType> sums = processes.Sum(counts);
  counts = processes.GetRank() == 0 ? sums : counts;
  cells.statistics.points = counts[0];
  cells.statistics.nonFinite = counts[1];
  return { counts[2], counts[3] };
}
VTK_ABI_NAMESPACE_END
