// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFDistributedTriangulation.h"

#include "FFOutput.h"
#include "FFProcesses.h"
#include "FFRun.h"
#include "vtkFFPlanarAlgorithm.h"

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
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

/// What is done by when, as shares of the whole.
constexpr double isRead = 0.2;
constexpr double isTriangulated = 0.8;
constexpr double isFetched = 0.95;

constexpr double infinity = std::numeric_limits<double>::infinity();

}

//------------------------------------------------------------------------------
FFDistributedTriangulation::FFDistributedTriangulation(
  vtkFFPlanarAlgorithm* filter, FFProcesses& processes)
  : Filter(filter)
  , Processes(processes)
  , Run(processes.GetRun())
  , Source(processes)
  , Input(filter, processes.GetRun())
  , Extent(5, infinity)
  , Counts(3)
{
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
    this->FitPlane(); // all processes have a part of it
  }
  else
  {
    this->Input.Project();
  }
  std::vector<FFDistributedCells::Point> points = this->TakePoints();
  this->Extent = this->Processes.Least(this->Extent);
  // Processes without points have no weights either.
  this->Weighted = this->Processes.Sum(vtkIdType(this->Input.GetWeights().data != nullptr)) > 0;
  this->BeginStep(isTriangulated);
  this->Cells = FFDistributedCells::Compute(
    this->Weighted ? flipflop::BlockShape::RegularTriangulation : flipflop::BlockShape::Delaunay,
    std::move(points), this->Run.Options, this->Processes);
  this->Counts[2] = static_cast<vtkIdType>(this->Cells.hiddenIds.size());
  if (!this->Input.GetFittedPlane() && this->Cells.cells.dimension == 1)
  {
    this->LookForVerticalPlane();
  }
}

//------------------------------------------------------------------------------
void FFDistributedTriangulation::Read(const std::vector<FFInput::PieceType>& pieces)
{
  this->BeginStep(isRead);
  this->Run.UseCPU("several processes triangulate together on their CPUs");
  auto* const only = pieces.size() == 1 ? vtkDataSet::SafeDownCast(pieces[0].Data) : nullptr;
  if (only)
  {
    this->Input.FindWeights(only); // throws what is wrong as they came: see FFPlanarInput::Take()
  }
  FFInput own;
  own.TakePieces(pieces, this->Filter->GetSkipGhostPoints(), this->Run);
  this->Run.Ids.reset(); // ids count the remaining points
  for (const auto& piece : own.GetPieces())
  {
    this->Counts[0] += piece->GetNumberOfPoints();
  }
  this->Source.Count(this->Counts[0]);
  this->Run.FirstId = this->Source.GetBegin();
  const auto points = FFOutput::Append({ own.GetPieces().begin(), own.GetPieces().end() });
  this->Input.SetPoints(points);
  this->Source.SetPoints(points);
  this->Input.SetWeights(this->FindOwnWeights());
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
  const flipflop::Options& options = this->Run.Options;
  const flipflop::PointView& view = this->Input.GetSpace();
  std::vector<flipflop::PlaneSums> own(1);
  flipflop::PlaneSums sums;
  flipflop::addExtent(own[0], view, options);
  for (const auto& part : this->Processes.Gather(own))
  {
    flipflop::joinExtent(sums, part[0]);
  }
  // Rounded sums depend on the order, so the processes sum one after another.
  this->Processes.PassOn(sums, [&] { flipflop::addToSum(sums, view, options); });
  this->Processes.PassOn(sums, [&] { flipflop::addToSpread(sums, view, options); });
  this->Input.SetPlane(flipflop::planeOf(sums));
}

//------------------------------------------------------------------------------
std::vector<FFDistributedCells::Point> FFDistributedTriangulation::TakePoints()
{
  vtkPointSet* const own = this->Input.GetPoints();
  std::vector<FFDistributedCells::Point> points;
  points.reserve(static_cast<std::size_t>(own->GetNumberOfPoints()));
  this->Counts[1] = static_cast<vtkIdType>(this->Input.VisitPoints(
    [&](std::int64_t i, double x, double y, double weight)
    {
      points.push_back({ { x, y, weight }, this->Source.GetBegin() + i });
      const double extent[5] = { x, -x, y, -y, own->GetPoint(static_cast<vtkIdType>(i))[2] };
      std::transform(extent, extent + 5, this->Extent.begin(), this->Extent.begin(),
        [](double a, double b) { return std::min(b, a); });
    }));
  return points;
}

//------------------------------------------------------------------------------
void FFDistributedTriangulation::LookForVerticalPlane()
{
  this->Run.EndPart();
  // The hull of the hulls is the hull.
  std::vector<std::array<double, 3>> points;
  this->Input.VisitPoints(
    [&](std::int64_t i, double, double, double) {
      this->Input.GetPoints()->GetPoint(static_cast<vtkIdType>(i), points.emplace_back().data());
    });
  std::vector<std::array<double, 3>> corners;
  for (const std::int64_t corner : FFPlanarInput::HullInSpace(points, this->Run.Options).pointIds)
  {
    corners.push_back(points[static_cast<std::size_t>(corner)]);
  }
  points.clear();
  for (const auto& part : this->Processes.Gather(corners))
  {
    points.insert(points.end(), part.begin(), part.end());
  }
  if (this->Processes.GetRank() == 0 &&
    FFPlanarInput::HullInSpace(points, this->Run.Options).dimension > 1)
  {
    this->Input.WarnOfVerticalPlane();
  }
}

//------------------------------------------------------------------------------
std::array<double, 4> FFDistributedTriangulation::GetBounds() const
{
  return { this->Extent[0], this->Extent[2], -this->Extent[1], -this->Extent[3] };
}

//------------------------------------------------------------------------------
void FFDistributedTriangulation::WorkOnCells(const std::function<void(
    const flipflop::PointView&, const flipflop::WeightView&, flipflop::CellComplex&)>& work)
{
  FFPlanarInput::WorkOnBlock(this->Cells,
    [&](const flipflop::PointView& points, flipflop::CellComplex& cells)
    {
      const auto* const x = static_cast<const double*>(points.data);
      work(points,
        this->Weighted ? flipflop::WeightView(x + 2, points.count, 3) : flipflop::WeightView(),
        cells);
    });
}

//------------------------------------------------------------------------------
void FFDistributedTriangulation::AddGhostCells()
{
  this->Ghosts =
    FFDistributedCells::AddGhosts(this->Run.Options.facets, this->Cells, this->Processes);
}

//------------------------------------------------------------------------------
void FFDistributedTriangulation::Fetch(const std::vector<vtkIdType>& ids)
{
  this->BeginStep(isFetched);
  this->Input.SetPoints(this->Source.Fetch(ids, this->Filter->GetPassPointData()));
  this->Run.Ids = ids;
  this->Run.FirstId = 0;
  // A sum with 0 is never -0: see flipflop::heightBelow().
  this->Input.SetHeight(std::isinf(this->Extent[4]) ? 0.0 : this->Extent[4] + 0.0);
  this->BeginStep(1.0);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPointSet> FFDistributedTriangulation::Gather(const std::string& why)
{
  std::vector<vtkIdType> ids;
  if (this->Processes.GetRank() == 0)
  {
    ids.resize(static_cast<std::size_t>(this->Source.GetNumberOfPoints()));
    std::iota(ids.begin(), ids.end(), vtkIdType(0));
  }
  vtkSmartPointer<vtkPointSet> all = this->Source.Fetch(ids, true);
  this->Processes.Agree();
  const int sources = this->Source.GetNumberOfSources();
  if (this->Processes.GetRank() == 0 && sources > 1)
  {
    this->Run.Warnings.push_back("The points of " + std::to_string(sources) +
      " processes are gathered on one, which triangulates them alone: " + why);
  }
  this->Run.Parts.clear(); // they have their ids
  this->Run.Ids.reset();
  this->Run.FirstId = 0;
  return all;
}

//------------------------------------------------------------------------------
flipflop::Triangulation FFDistributedTriangulation::FetchCells()
{
  this->Duplicates = FFDistributedCells::FindDuplicates(this->Cells, this->Processes);
  flipflop::Triangulation triangulation;
  flipflop::CellComplex& cells = triangulation;
  cells = std::move(this->Cells.cells);
  triangulation.hiddenIds = std::move(this->Cells.hiddenIds);
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
void FFDistributedTriangulation::Report(
  flipflop::CellComplex& cells, std::optional<std::int64_t> dropped, vtkPolyData* output)
{
  std::vector<vtkIdType> counts = this->Counts;
  counts.push_back(static_cast<vtkIdType>(dropped.value_or(0)));
  const std::vector<vtkIdType> all = this->Processes.Sum(counts);
  counts = this->Processes.GetRank() == 0 ? all : counts;
  cells.statistics.points = counts[0];
  cells.statistics.nonFinite = counts[1];
  if (dropped)
  {
    dropped = counts[3];
  }
  this->Input.Report(cells, counts[2], dropped, output);
}

//------------------------------------------------------------------------------
void FFDistributedTriangulation::MarkDuplicates(vtkPolyData* output) const
{
  FFDistributedCells::Mark(
    output->GetPointData(), this->Duplicates, vtkDataSetAttributes::DUPLICATEPOINT);
  if (this->Ghosts)
  {
    FFDistributedCells::Mark(
      output->GetCellData(), *this->Ghosts, vtkDataSetAttributes::DUPLICATECELL);
  }
}
VTK_ABI_NAMESPACE_END
