// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFConstraints.h"

#include "FFExactValues.h"
#include "FFInput.h"
#include "FFOutput.h"
#include "FFPlanarInput.h"
#include "FFRun.h"
#include "FFSurfaceCells.h"
#include "vtkFFAlgorithm.h"

#include <flipflop/ClosedLines.h>
#include <flipflop/Error.h>

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iomanip>
#include <numeric>
#include <sstream>
#include <stdexcept>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

/// With as few digits as tell it.
std::string toText(double number)
{
  std::ostringstream text;
  for (int digits = 6; digits <= 17; ++digits)
  {
    text.str("");
    text << std::setprecision(digits) << number;
    if (std::strtod(text.str().c_str(), nullptr) == number)
    {
      break;
    }
  }
  return text.str();
}

std::string positionOf(vtkPointSet* data, vtkIdType i)
{
  double point[3];
  data->GetPoint(i, point);
  return "(" + toText(point[0]) + ", " + toText(point[1]) + ", " + toText(point[2]) + ")";
}

/// Whether a point of both has the same coordinates. NaN is the same as NaN.
bool isSame(vtkPointSet* a, vtkPointSet* b, vtkIdType point, int dimensions)
{
  double p[3], q[3];
  a->GetPoint(point, p);
  b->GetPoint(point, q);
  return std::equal(p, p + dimensions, q,
    [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

/// How far q is on the way from a to b, which is not 0: rounded, from 0 to 1.
double shareOf(const double* a, const double* b, const double* q)
{
  // By halves, which do not overflow; where they lose bits, so does the share.
  const auto along = [&](const double* p, int axis) { return 0.5 * p[axis] - 0.5 * a[axis]; };
  const int axis = std::abs(along(b, 0)) < std::abs(along(b, 1)) ? 1 : 0;
  const double whole = along(b, axis);
  return whole == 0.0 ? 0.5 : std::clamp(along(q, axis) / whole, 0.0, 1.0);
}

}

//------------------------------------------------------------------------------
FFConstraints::FFConstraints(const SettingsType& settings, vtkPolyData* source, vtkPointSet* input,
  const std::optional<std::vector<vtkIdType>>& given, const flipflop::Options& options)
  : Settings(settings)
  , Source(source)
  , Input(input)
  , Given(given)
{
  FFInput::CheckPoints(source, std::string(" of the ") + settings.Owner);
  for (vtkCellArray* cells : { source->GetLines(), source->GetPolys() })
  {
    const std::string fault =
      FFSurfaceCells::DescribeOffsets(cells, std::string(settings.Owner) + "'s cells");
    if (!fault.empty())
    {
      throw std::runtime_error(fault);
    }
  }
  this->IsOwn = settings.SourcePoints == vtkFFAlgorithm::OWN_POINTS ||
    (settings.SourcePoints == vtkFFAlgorithm::AUTOMATIC_POINTS && this->FindOwnPoints());
  if (settings.ClosedLinesAsBorders)
  {
    this->FindRings(options);
  }
  this->Take(false);
  const std::size_t lines = this->CellIds.size();
  this->Take(true);
  this->Sides = static_cast<std::int64_t>(this->CellIds.size() - lines);
}

//------------------------------------------------------------------------------
void FFConstraints::EachCell(const CellVisitor& visit) const
{
  vtkIdType cell = this->Source->GetNumberOfVerts();
  vtkNew<vtkIdList> corners;
  for (vtkCellArray* cells : { this->Source->GetLines(), this->Source->GetPolys() })
  {
    for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i, ++cell)
    {
      cells->GetCellAtId(i, corners);
      visit(cell, cells == this->Source->GetPolys(), corners);
    }
  }
}

//------------------------------------------------------------------------------
bool FFConstraints::FindOwnPoints() const
{
  const vtkIdType own = this->Source->GetNumberOfPoints();
  const vtkIdType count = this->Input->GetNumberOfPoints();
  bool isOwn = false;
  this->EachCell(
    [&](vtkIdType, bool, vtkIdList* corners)
    {
      for (vtkIdType k = 0; !isOwn && k < corners->GetNumberOfIds(); ++k)
      {
        const vtkIdType point = corners->GetId(k);
        const bool isThere = point >= 0 && point < own; // else an error, whosever points they are
        isOwn = isThere && (point >= count || !isSame(this->Source, this->Input, point, 3));
      }
    });
  return isOwn;
}

//------------------------------------------------------------------------------
void FFConstraints::FindRings(const flipflop::Options& options)
{
  vtkPointSet* const points = this->IsOwn ? this->Source : this->Input;
  std::vector<double> corners;
  std::vector<std::int64_t> offsets(1, 0);
  this->EachCell(
    [&](vtkIdType cell, bool, vtkIdList* ids)
    {
      for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
      {
        this->GetId(ids->GetId(k), cell); // is there
        corners.resize(corners.size() + 3);
        points->GetPoint(ids->GetId(k), corners.data() + corners.size() - 3);
      }
      offsets.push_back(static_cast<std::int64_t>(corners.size() / 3));
    });
  flipflop::LineView lines;
  lines.points = flipflop::PointView(corners.data(), offsets.back());
  lines.offsets = offsets.data();
  lines.lines = this->Source->GetNumberOfLines();
  lines.polygons = this->Source->GetNumberOfPolys();
  this->Rings = flipflop::closedLines(lines, this->Settings.Dimensions, options);
}

//------------------------------------------------------------------------------
void FFConstraints::Take(bool asSides)
{
  const vtkIdType first = this->Source->GetNumberOfVerts();
  this->EachCell(
    [&](vtkIdType cell, bool isPolygon, vtkIdList* corners)
    {
      const int ring = isPolygon || this->Rings.empty() ? 0 : this->Rings[cell - first];
      if (asSides == (isPolygon || ring != 0))
      {
        flipflop::eachConstraintAlong(corners->GetPointer(0), corners->GetNumberOfIds(), isPolygon,
          [&](vtkIdType from, vtkIdType to)
          {
            this->Ends.push_back(this->GetId(ring < 0 ? to : from, cell));
            this->Ends.push_back(this->GetId(ring < 0 ? from : to, cell));
            this->CellIds.push_back(cell);
          });
      }
    });
}

//------------------------------------------------------------------------------
std::int64_t FFConstraints::GetId(vtkIdType point, vtkIdType cell) const
{
  if (this->IsOwn)
  {
    this->CheckOwnPoint(point, cell);
    return point;
  }
  const vtkIdType count = this->Input->GetNumberOfPoints();
  if (point < 0 || point >= count)
  {
    throw std::runtime_error("Point " + std::to_string(point) + " of " + this->Describe(cell) +
      " is not there: its ids are those of the input's points, of which there are " +
      std::to_string(count) + ".");
  }
  this->CheckPoint(point, cell);
  if (!this->Given)
  {
    return point;
  }
  const auto at = std::lower_bound(this->Given->begin(), this->Given->end(), point);
  if (at == this->Given->end() || *at != point)
  {
    throw std::runtime_error("Point " + std::to_string(point) + " of " + this->Describe(cell) +
      " is a ghost point, which is left out. Turn off Skip Ghost Points, or take the cell away.");
  }
  return at - this->Given->begin();
}

//------------------------------------------------------------------------------
void FFConstraints::CheckOwnPoint(vtkIdType point, vtkIdType cell) const
{
  const vtkIdType own = this->Source->GetNumberOfPoints();
  if (point < 0 || point >= own)
  {
    throw std::runtime_error("Point " + std::to_string(point) + " of " + this->Describe(cell) +
      " is not there: the source has " + std::to_string(own) + " point(s).");
  }
}

//------------------------------------------------------------------------------
void FFConstraints::CheckPoint(vtkIdType point, vtkIdType cell) const
{
  const vtkIdType own = this->Source->GetNumberOfPoints();
  if (own == 0)
  {
    return;
  }
  this->CheckOwnPoint(point, cell);
  if (!isSame(this->Source, this->Input, point, this->Settings.Dimensions))
  {
    throw std::runtime_error("Point " + std::to_string(point) + " of " + this->Describe(cell) +
      " is at " + positionOf(this->Source, point) + ", and point " + std::to_string(point) +
      " of the input is at " + positionOf(this->Input, point) +
      ". The source's cells name points of the input by id, so at these ids its " +
      std::to_string(own) + " points must be those of the input, of which there are " +
      std::to_string(this->Input->GetNumberOfPoints()) + "; or it has no points." +
      (this->Settings.HasSourcePoints ? " If they are its own, set Source Points to Own Points."
                                      : ""));
  }
}

//------------------------------------------------------------------------------
const flipflop::JoinedLines& FFConstraints::Join(const flipflop::PointView& points,
  const flipflop::PointView& own, const flipflop::PointView& space,
  const flipflop::Options& options)
{
  this->OwnSpace = space;
  this->InputCount = points.count;
  this->Joined = flipflop::joinLines(points, own, this->GetWhole(), options);
  return *this->Joined;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPointSet> FFConstraints::AppendJoinedPoints(vtkPointSet* given, FFRun& run) const
{
  const flipflop::Buffer<std::int64_t>& added = this->Joined->added;
  if (added.empty())
  {
    return given;
  }
  return Append(given, FFOutput::SelectLike(given, this->Source, added), run);
}

//------------------------------------------------------------------------------
vtkIdType FFConstraints::FindHeights(flipflop::PointView points,
  const flipflop::ConstrainedTriangulation& triangulation, const flipflop::Options& options)
{
  if (!this->Joined)
  {
    return 0;
  }
  points.count = this->InputCount;
  const flipflop::SplitConstraints unsplit;
  this->Heights = flipflop::lineHeights(points, this->OwnSpace, this->GetWhole(), *this->Joined,
    this->Pieces ? *this->Pieces : unsplit, triangulation, options);
  return static_cast<vtkIdType>(this->Heights->differing);
}

//------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkDataArray>> FFConstraints::MarkPoints(
  const flipflop::Buffer<std::int64_t>& ids) const
{
  if (!this->Joined)
  {
    return {};
  }
  const auto count = static_cast<vtkIdType>(ids.size());
  const auto crossings = static_cast<std::int64_t>(this->Joined->positions.size() / 2);
  const std::int64_t ofLines = crossings - this->GetNumberOfJoinedPoints();
  auto origins = vtkSmartPointer<vtkUnsignedCharArray>::New();
  origins->SetName("PointOrigin");
  origins->SetNumberOfValues(count);
  auto ranges = vtkSmartPointer<vtkDoubleArray>::New();
  ranges->SetName("HeightRange");
  ranges->SetNumberOfComponents(2);
  ranges->SetNumberOfTuples(this->Heights ? count : 0);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const std::int64_t id = ids[static_cast<std::size_t>(i)];
    origins->SetValue(i, static_cast<unsigned char>(id >= crossings ? 2 : id >= ofLines ? 1 : 0));
    if (this->Heights)
    {
      ranges->SetTypedTuple(i, this->Heights->ranges.data() + 2 * id);
    }
  }
  if (!this->Heights)
  {
    return { origins };
  }
  return { origins, ranges };
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPointSet> FFConstraints::Append(
  vtkPointSet* given, vtkPointSet* created, FFRun& run)
{
  const auto count = static_cast<std::size_t>(given->GetNumberOfPoints());
  if (!run.Ids)
  {
    run.Ids.emplace(count);
    std::iota(run.Ids->begin(), run.Ids->end(), vtkIdType(0));
  }
  run.Ids->resize(count + static_cast<std::size_t>(created->GetNumberOfPoints()), -1);
  return FFOutput::Append({ given, created });
}

//------------------------------------------------------------------------------
void FFConstraints::WriteEdges(const flipflop::ConstrainedTriangulation& triangulation,
  vtkPolyData* cells, vtkPolyData* output) const
{
  flipflop::CellComplex edges;
  edges.dimension = 1;
  edges.cellSize = 2;
  edges.connectivity.allocate(triangulation.fixedEdges.size());
  std::copy(
    triangulation.fixedEdges.begin(), triangulation.fixedEdges.end(), edges.connectivity.begin());
  output->SetPoints(cells->GetPoints());
  output->GetPointData()->ShallowCopy(cells->GetPointData());
  FFOutput::AdoptCells(edges, output);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("ConstraintCellIds");
  for (const std::int64_t constraint : triangulation.constraintOf)
  {
    ids->InsertNextValue(this->GetCellId(constraint));
  }
  output->GetCellData()->AddArray(ids);
}

//------------------------------------------------------------------------------
vtkIdType FFConstraints::GetCellId(std::int64_t constraint) const
{
  if (constraint < 0)
  {
    return -1;
  }
  const auto i = static_cast<std::size_t>(constraint);
  return this->CellIds[this->Pieces ? static_cast<std::size_t>(this->Pieces->constraintOf[i]) : i];
}

//------------------------------------------------------------------------------
flipflop::Buffer<double> FFConstraints::Split(
  const flipflop::PointView& points, const flipflop::Options& options)
{
  this->Pieces = flipflop::splitCrossings(points, this->GetUnsplit(), options);
  flipflop::Buffer<double> positions;
  const flipflop::Buffer<double>& added = this->Pieces->positions;
  if (!added.empty())
  {
    positions.allocate(2 * static_cast<std::size_t>(points.count) + added.size());
    double* to = positions.data();
    for (std::int64_t i = 0; i < points.count; ++i)
    {
      *to++ = FFNumberAt(points, i * points.stride);
      *to++ = FFNumberAt(points, i * points.stride + 1);
    }
    std::copy(added.begin(), added.end(), to);
  }
  return positions;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPointSet> FFConstraints::AppendNewPoints(
  vtkPointSet* given, const double* positions, bool isXY, bool isHeight, FFRun& run) const
{
  const vtkIdType added = this->GetNumberOfNewPoints();
  const vtkIdType count = given->GetNumberOfPoints();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(added);
  vtkNew<vtkPolyData> created;
  created->SetPoints(points);
  created->GetPointData()->InterpolateAllocate(given->GetPointData(), added);
  for (vtkIdType k = 0; k < added; ++k)
  {
    const auto crossing =
      static_cast<std::size_t>(this->Pieces->offsets[static_cast<std::size_t>(k)]);
    const std::int64_t* const ends = this->GetUnsplit().ends + 2 * this->Pieces->crossing[crossing];
    const auto a = static_cast<vtkIdType>(ends[0]);
    const auto b = static_cast<vtkIdType>(ends[1]);
    const double* const position = positions + 2 * (count + k);
    const double share = shareOf(positions + 2 * a, positions + 2 * b, position);
    double x[3], y[3];
    given->GetPoint(a, x);
    given->GetPoint(b, y);
    for (int i = 0; i < 3; ++i)
    {
      x[i] = (1.0 - share) * x[i] + share * y[i];
    }
    std::copy_n(position, isXY ? 2 : 0, x); // as it was triangulated
    x[2] = isHeight ? this->GetNewHeight(k) : x[2];
    points->SetPoint(k, x);
    created->GetPointData()->InterpolateEdge(given->GetPointData(), k, a, b, share);
  }
  return Append(given, created, run);
}

//------------------------------------------------------------------------------
void FFConstraints::Do(const std::optional<FFConstraints>& constraints, const FFRun& run,
  const std::function<void()>& work)
{
  try
  {
    work();
  }
  catch (const flipflop::Error& error)
  {
    const std::string text = constraints ? constraints->Describe(error, run) : std::string();
    if (text.empty())
    {
      throw;
    }
    throw FFBadConstraint(text);
  }
  catch (const FFInexactValue& error) // what was given is known to be exact
  {
    throw std::runtime_error(
      error.Describe("point " + std::to_string(error.GetIndex()) + " of the source"));
  }
}

//------------------------------------------------------------------------------
void FFConstraints::AddToFieldData(const vtkFFReport& report, vtkFieldData* data)
{
  const std::int64_t split = report.NumberOfSplitPoints;
  const std::int64_t added = report.NumberOfAddedPoints;
  const std::int64_t differing = report.NumberOfHeightDifferences;
  FFOutput::AddValue(data, "FlipFlopSplitPoints", split);
  FFOutput::AddValue(data, "FlipFlopAddedPoints", added);
  FFOutput::AddValue(data, "FlipFlopHeightDifferences", differing);
}

//------------------------------------------------------------------------------
vtkPolyData* FFConstraints::SourceOf(vtkInformationVector** inputVector, const FFRun& run)
{
  vtkDataObject* const source = vtkDataObject::GetData(inputVector[1]);
  if (source && run.IsInComposite())
  {
    throw FFBadSetting("The source's lines are for one data set, and an input is a composite. "
                       "Take one data set, merge them, or take the source away.");
  }
  if (source && !vtkPolyData::SafeDownCast(source))
  {
    throw std::runtime_error(std::string("The source is a ") + source->GetClassName() +
      ". It must be a vtkPolyData, whose lines and polygons are edges of the triangulation.");
  }
  return vtkPolyData::SafeDownCast(source);
}

//------------------------------------------------------------------------------
std::string FFConstraints::Describe(vtkIdType cell) const
{
  return "cell " + std::to_string(cell) + " of the " + this->Settings.Owner;
}

//------------------------------------------------------------------------------
// What goes wrong with constraints, in words that name their cells; empty for other errors.
std::string FFConstraints::Describe(const flipflop::Error& error, const FFRun& run) const
{
  const auto cellOf = [&](std::int64_t constraint)
  { return this->Describe(this->GetCellId(constraint)); };
  switch (error.code())
  {
    case flipflop::ErrorCode::ConstraintPoint:
      return "Point " +
        std::to_string(this->IsOwn ? static_cast<vtkIdType>(error.count())
                                   : run.GetId(static_cast<vtkIdType>(error.count()))) +
        " of " + cellOf(error.index()) +
        " is left out: it has a coordinate that is NaN or infinite.";
    case flipflop::ErrorCode::ConstraintsCross:
      return "An edge of " + cellOf(error.index()) + " crosses one of " + cellOf(error.count()) +
        ", and there is no point where they do. Add one to " +
        (this->IsOwn ? "both" : "the input and to both") +
        (this->Settings.CanSplit ? ", or turn on Split Crossing Constraints." : ".");
    case flipflop::ErrorCode::PolygonsDisagree:
    {
      const std::string wrong = cellOf(error.index());
      const std::string right = cellOf(error.count());
      const std::string rule = "The polygons disagree about what is inside: what is on the left of "
                               "a side is inside, and holes run clockwise. ";
      return wrong == right ? rule + "The sides of " + wrong +
          " disagree with each other, as where a polygon crosses itself. Set Polygon Rule to "
          "Even-Odd."
                            : rule + "Reverse " + wrong + ", which disagrees with " + right +
          ", or set Polygon Rule to Even-Odd.";
    }
    default:
      return {};
  }
}
VTK_ABI_NAMESPACE_END
