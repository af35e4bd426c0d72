// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPFFRegularTriangulationWork.h"

#include "vtkFFBlockRounds.h"
#include "vtkFFGhostCells.h"
#include "vtkFFMessage.h"

#include <flipflop/PlaneFit.h>

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

/// What is done by when, as shares of the whole.
constexpr double taken = 0.1;
constexpr double dealt = 0.2;
constexpr double triangulated = 0.8;
constexpr double fetched = 0.95;

const char* const reasonForCpu = "several processes triangulate together on their CPUs";

/// A point of a view, in space.
std::array<double, 3> pointAt(const flipflop::PointView& view, std::int64_t i)
{
  std::array<double, 3> point;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const std::int64_t place = i * view.stride + static_cast<std::int64_t>(k);
    point[k] = view.type == flipflop::ScalarType::Float32
      ? static_cast<const float*>(view.data)[place]
      : static_cast<const double*>(view.data)[place];
  }
  return point;
}

/// Sets a mark where it is told, in an array of marks that may be there already.
void mark(vtkDataSetAttributes* data, const std::vector<bool>& where, int ghost)
{
  const char* name = vtkDataSetAttributes::GhostArrayName();
  vtkSmartPointer<vtkUnsignedCharArray> marks =
    vtkUnsignedCharArray::SafeDownCast(data->GetAbstractArray(name));
  if (!marks)
  {
    marks = vtkSmartPointer<vtkUnsignedCharArray>::New();
    marks->SetName(name);
    marks->SetNumberOfValues(static_cast<vtkIdType>(where.size()));
    marks->FillValue(0);
    data->AddArray(marks);
  }
  for (std::size_t i = 0; i < where.size(); ++i)
  {
    const auto place = static_cast<vtkIdType>(i);
    const int others = marks->GetValue(place) & ~ghost;
    marks->SetValue(place, static_cast<unsigned char>(where[i] ? others | ghost : others));
  }
}

}

//------------------------------------------------------------------------------
vtkPFFRegularTriangulationFilter::vtkInternals::DistributedWork::DistributedWork(
  vtkInternals* internals, const Block& block)
  : Work(internals, block)
  , Parallel(internals)
  , Settings(internals->GetDistributedFilter())
  , Exchange(internals->GetController(), *internals)
  , Source(Exchange)
  , Lowest(std::numeric_limits<double>::infinity())
{
  this->Bounds.fill(std::numeric_limits<double>::infinity());
}

//------------------------------------------------------------------------------
void vtkPFFRegularTriangulationFilter::vtkInternals::DistributedWork::Execute(
  const std::vector<vtkPolyData*>& outputs, vtkFFFailure& failure)
{
  vtkFFFailure none;
  this->Parallel->TryEngine(
    [&](const flipflop::Options& options, const flipflop::EngineOptions& engine,
      flipflop::EngineReport&)
    {
      this->Options = options;
      this->Choice = engine;
    },
    none);
  const bool found = this->Take() && this->FitPlane() && this->Deal() && this->FindCells() &&
    this->MakeDiagram() && this->TrimCells() && this->LookForVerticalPlane() && this->Fetch();
  if (found)
  {
    this->Write(outputs);
    this->Exchange.IsWell();
  }
  failure = this->Exchange.GetFailure();
}

//------------------------------------------------------------------------------
void vtkPFFRegularTriangulationFilter::vtkInternals::DistributedWork::Do(
  double share, const std::function<void()>& work)
{
  this->Exchange.Do(
    [&]
    {
      this->Parallel->SetProgressPart(this->Share, share);
      vtkFFGuard::Look(this->Options);
      work();
    });
  this->Share = share;
}

//------------------------------------------------------------------------------
bool vtkPFFRegularTriangulationFilter::vtkInternals::DistributedWork::Take()
{
  this->Do(0.0,
    [&]
    {
      if (this->Choice.choice == flipflop::EngineChoice::CUDA)
      {
        throw std::runtime_error("The CUDA engine was asked for, but several processes triangulate "
                                 "together on their CPUs. Set Engine to Automatic or CPU.");
      }
      this->Own = this->TakePoints();
      this->Parallel->PlacesOfPoints.clear(); // ids count the points that are left
    });
  if (!this->Exchange.IsWell())
  {
    return false;
  }
  this->Source.Count(this->Own);
  this->Parallel->PlaceOfPiece = this->Source.GetBegin();
  this->Parallel->CurrentBlocks[0].NumberOfPoints = this->Source.GetNumberOfPoints();
  this->Do(taken / 2, [&] { this->JoinPoints(); });
  if (!this->Source.SetPoints(this->Input))
  {
    return false;
  }
  this->Do(taken,
    [&]
    {
      this->TakeWeights(this->FindOwnWeights());
      this->Projection.emplace(this->Options);
      if (this->Settings->ProjectionPlaneMode != BEST_FITTING_PLANE)
      {
        this->Parallel->Project(*this->Points, *this->Projection);
      }
    });
  return this->Exchange.IsWell();
}

//------------------------------------------------------------------------------
vtkDataArray* vtkPFFRegularTriangulationFilter::vtkInternals::DistributedWork::FindOwnWeights()
{
  // They must be in the data that the points of all processes have.
  vtkDataArray* array = this->Parallel->FindWeights(this->Source.GetKind());
  if (!array || this->Input->GetNumberOfPoints() == 0)
  {
    return nullptr;
  }
  return this->Source.HasSeveralSources() ? this->Input->GetPointData()->GetArray(array->GetName())
                                          : this->Parallel->FindWeights(this->Input);
}

//------------------------------------------------------------------------------
bool vtkPFFRegularTriangulationFilter::vtkInternals::DistributedWork::FitPlane()
{
  if (this->Settings->ProjectionPlaneMode != BEST_FITTING_PLANE)
  {
    return true;
  }
  // Rounded sums depend on the order, so the processes sum one after another.
  const flipflop::PointView& view = this->Points->GetView();
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
  this->Do(taken, [&] { this->Projection->AddExtent(view, own); });
  passOn([&] { vtkFFProjection::JoinExtent(sums, own); });
  passOn([&] { this->Projection->AddToSum(view, sums); });
  passOn([&] { this->Projection->AddToSpread(view, sums); });
  this->Do(taken, [&] { this->Projection->ToPlane(view, sums); });
  return this->Exchange.IsWell();
}

//------------------------------------------------------------------------------
bool vtkPFFRegularTriangulationFilter::vtkInternals::DistributedWork::Deal()
{
  std::vector<vtkFFPointDealing::Point> points;
  this->Do(dealt,
    [&]
    {
      this->Weighted = this->Weights->GetView().data != nullptr;
      const flipflop::PointView& space = this->Points->GetView();
      const bool needsHeight = this->NeedsHeight();
      points.reserve(static_cast<std::size_t>(space.count));
      this->NonFinite = this->VisitPoints(this->Options,
        [&](std::int64_t i, double x, double y, double weight)
        {
          points.push_back({ { x, y, weight }, this->Source.GetBegin() + i });
          const double bounds[4] = { x, -x, y, -y };
          for (std::size_t k = 0; k < 4; ++k)
          {
            this->Bounds[k] = std::min(this->Bounds[k], bounds[k]);
          }
          if (needsHeight)
          {
            this->Lowest = std::min(this->Lowest, pointAt(space, i)[2]);
          }
        });
    });
  return vtkFFPointDealing::Deal(
    std::move(points),
    [](const vtkFFPointDealing::Point& point) {
      return vtkFFPointDealing::Key{ point.Place[0], point.Place[1] };
    },
    this->Exchange, this->Dealt);
}

//------------------------------------------------------------------------------
bool vtkPFFRegularTriangulationFilter::vtkInternals::DistributedWork::FindCells()
{
  // Processes without points have no weights either.
  this->Weighted = this->Exchange.GetProcesses().Sum(vtkIdType(this->Weighted)) > 0;
  this->Parallel->SetProgressPart(dealt, triangulated);
  this->Share = triangulated;
  flipflop::Options options = this->Options;
  if (this->Settings->GeneratePowerDiagram)
  {
    options.facets = flipflop::FacetMode::Polygons; // points of one power circle meet in one corner
  }
  return vtkFFBlockRounds::Run(
    this->Weighted ? flipflop::BlockShape::RegularTriangulation : flipflop::BlockShape::Delaunay,
    std::move(this->Dealt), options, [&] { vtkFFGuard::Look(this->Options); }, this->Exchange,
    this->Result);
}

//------------------------------------------------------------------------------
bool vtkPFFRegularTriangulationFilter::vtkInternals::DistributedWork::MakeDiagram()
{
  if (!this->Settings->GeneratePowerDiagram || this->Result.cells.dimension < 0)
  {
    return true;
  }
  vtkFFProcesses& processes = this->Exchange.GetProcesses();
  double corners[4]; // of the box of all points
  for (std::size_t k = 0; k < 4; ++k)
  {
    corners[k % 2 * 2 + k / 2] = (k % 2 ? -1.0 : 1.0) * processes.Least(this->Bounds[k]);
  }
  flipflop::BlockResult around;
  std::vector<bool> ghosts;
  if (!vtkFFGhostCells::Add(
        flipflop::FacetMode::Polygons, this->Result, this->Exchange, around, ghosts))
  {
    return false;
  }
  this->Do(triangulated,
    [&]
    {
      flipflop::Triangulation ends;
      ends.pointIds.allocate(2);
      std::iota(ends.pointIds.begin(), ends.pointIds.end(), std::int64_t(0));
      const std::array<double, 4> box = this->FindBox({ corners, 2, 2 }, ends);
      this->Broken = !MakePowerCells(
        around, this->Weighted, processes.GetRank(), box, this->Options, this->Diagram);
      FanFacets(this->Result.cells, this->Options);
    });
  if (!this->Exchange.IsWell())
  {
    return false;
  }
  this->Broken = processes.Sum(vtkIdType(this->Broken)) > 0;
  return !this->Broken;
}

//------------------------------------------------------------------------------
bool vtkPFFRegularTriangulationFilter::vtkInternals::DistributedWork::TrimCells()
{
  this->Do(triangulated,
    [&]
    {
      this->Hidden = static_cast<std::int64_t>(this->Result.hiddenIds.size());
      // The places are of the cells' points alone.
      flipflop::CellComplex& cells = this->Result.cells;
      flipflop::Buffer<std::int64_t> ids(cells.pointIds.size());
      std::iota(ids.begin(), ids.end(), std::int64_t(0));
      std::swap(ids, cells.pointIds);
      const double* const places = this->Result.places.data();
      const auto count = static_cast<std::int64_t>(ids.size());
      this->Dropped = this->DropCells({ places, count },
        this->Weighted ? flipflop::WeightView(places + 2, count, 3) : flipflop::WeightView(),
        this->Options, cells);
      std::swap(ids, cells.pointIds);
    });
  if (!this->Settings->GenerateGhostCells)
  {
    return this->Exchange.IsWell();
  }
  flipflop::BlockResult all;
  if (!vtkFFGhostCells::Add(
        this->Options.facets, this->Result, this->Exchange, all, this->GhostCells))
  {
    return false;
  }
  all.hiddenIds = std::move(this->Result.hiddenIds);
  all.cells.statistics = this->Result.cells.statistics;
  this->Result = std::move(all);
  return true;
}

//------------------------------------------------------------------------------
bool vtkPFFRegularTriangulationFilter::vtkInternals::DistributedWork::LookForVerticalPlane()
{
  if (!this->Projection->IsXYPlane() || this->Result.cells.dimension != 1)
  {
    return true;
  }
  // The hull of the hulls is the hull.
  vtkFFBlockExchange::Messages messages;
  this->Do(triangulated,
    [&]
    {
      const flipflop::PointView& space = this->Points->GetView();
      std::vector<std::array<double, 3>> points;
      this->VisitPoints(this->Options,
        [&](std::int64_t i, double, double, double) { points.push_back(pointAt(space, i)); });
      for (const std::int64_t corner : HullInSpace(points, this->Options).pointIds)
      {
        vtkFFMessage::Add(&points[static_cast<std::size_t>(corner)], 1, messages[0]);
      }
    });
  if (!this->Exchange.Exchange(messages))
  {
    return false;
  }
  this->Do(triangulated,
    [&]
    {
      std::vector<std::array<double, 3>> points;
      for (const auto& message : messages)
      {
        const auto corners = vtkFFMessage::Values<std::array<double, 3>>(message.second);
        points.insert(points.end(), corners.begin(), corners.end());
      }
      if (HullInSpace(points, this->Options).dimension == 2)
      {
        this->Parallel->WarnOfVerticalPlane();
      }
    });
  return this->Exchange.IsWell();
}

//------------------------------------------------------------------------------
bool vtkPFFRegularTriangulationFilter::vtkInternals::DistributedWork::Fetch()
{
  std::vector<vtkIdType> ids;
  this->Do(triangulated,
    [&]
    {
      const auto& inCells = this->Result.cells.pointIds;
      const auto& hidden = this->Result.hiddenIds;
      const auto& sites = this->Diagram.siteIds; // their facets may all be others'
      std::vector<vtkIdType> visible;
      std::set_union(
        inCells.begin(), inCells.end(), sites.begin(), sites.end(), std::back_inserter(visible));
      std::set_union(
        visible.begin(), visible.end(), hidden.begin(), hidden.end(), std::back_inserter(ids));
    });
  vtkSmartPointer<vtkPointSet> points;
  if (!this->Source.Fetch(ids, this->Settings->PassPointData, points))
  {
    return false;
  }
  this->Do(fetched, [&] { this->TakeResult(ids, points); });
  return this->Exchange.IsWell();
}

//------------------------------------------------------------------------------
void vtkPFFRegularTriangulationFilter::vtkInternals::DistributedWork::TakeResult(
  const std::vector<vtkIdType>& ids, vtkPointSet* points)
{
  this->SetInput(points);
  const auto placeOf = [&](std::int64_t id)
  { return std::lower_bound(ids.begin(), ids.end(), id) - ids.begin(); };
  flipflop::Buffer<double> places(2 * ids.size());
  std::fill(places.begin(), places.end(), 0.0); // nobody asks for those of other points
  flipflop::CellComplex& cells = this->Triangulation;
  cells = std::move(this->Result.cells);
  for (std::size_t i = 0; i < cells.pointIds.size(); ++i)
  {
    cells.pointIds[i] = placeOf(cells.pointIds[i]);
    std::copy_n(this->Result.places.data() + 3 * i, 2, places.data() + 2 * cells.pointIds[i]);
  }
  this->Triangulation.hiddenIds = std::move(this->Result.hiddenIds);
  for (auto* others : { &this->Triangulation.hiddenIds, &this->Diagram.siteIds })
  {
    for (std::int64_t& id : *others)
    {
      id = placeOf(id);
    }
  }
  this->Projection->SetPlaces(std::move(places));
  this->Parallel->PlacesOfPoints = ids;
}

//------------------------------------------------------------------------------
void vtkPFFRegularTriangulationFilter::vtkInternals::DistributedWork::Write(
  const std::vector<vtkPolyData*>& outputs)
{
  vtkFFProcesses& processes = this->Exchange.GetProcesses();
  const int own = processes.GetRank();
  const double lowest = processes.Least(this->Lowest);
  std::vector<vtkIdType> counts{ this->Own, this->NonFinite, static_cast<vtkIdType>(this->Hidden),
    static_cast<vtkIdType>(this->Dropped) };
  const std::vector<vtkIdType> sums = processes.Sum(counts);
  // Each process reports its share, and the first one all.
  counts = own == 0 ? sums : counts;
  this->Do(1.0,
    [&]
    {
      // A sum with 0 is never -0: see the plain filter's height.
      this->Projection->SetHeight(std::isinf(lowest) ? 0.0 : lowest + 0.0);
      flipflop::EngineReport report;
      std::snprintf(report.reason, sizeof(report.reason), "%s", reasonForCpu);
      this->Triangulation.statistics.points = counts[0];
      this->Triangulation.statistics.nonFinite = counts[1];
      if (this->Settings->GeneratePowerDiagram)
      {
        this->WritePowerDiagram(this->Diagram, this->Options, outputs[2]);
      }
      this->WriteCells(this->Options, outputs);
      if (this->Settings->GenerateGhostCells)
      {
        std::vector<bool> ghostPoints;
        for (const std::int32_t block : this->Result.blocks)
        {
          ghostPoints.push_back(block != own);
        }
        mark(outputs[0]->GetPointData(), ghostPoints, vtkDataSetAttributes::DUPLICATEPOINT);
        mark(outputs[0]->GetCellData(), this->GhostCells, vtkDataSetAttributes::DUPLICATECELL);
      }
      this->Report(report, counts[2], counts[3], outputs[0]);
      this->Options.progress(1.0, this->Options.progressContext);
    });
}
VTK_ABI_NAMESPACE_END
