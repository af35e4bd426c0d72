// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFConstraints.h"

#include "FFOutput.h"
#include "FFRun.h"
#include "FFSurfaceCells.h"
#include "vtkFFRegularTriangulationFilter.h"

#include <flipflop/Error.h>
#include <flipflop/PlaneFit.h>

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
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
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

std::string describe(vtkIdType cell)
{
  return "cell " + std::to_string(cell) + " of the source";
}

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

std::string toText(const double* point)
{
  return "(" + toText(point[0]) + ", " + toText(point[1]) + ", " + toText(point[2]) + ")";
}

/// NaN is the same as NaN.
bool isSame(const double* a, const double* b, int dimensions)
{
  return std::equal(a, a + dimensions, b,
    [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

bool isFlat(vtkFFPlanarAlgorithm* filter)
{
  return filter->GetProjectionPlaneMode() == vtkFFPlanarAlgorithm::XY_PLANE;
}

/// These points after those given. The run gets the id -1 for each.
vtkSmartPointer<vtkPointSet> append(vtkPointSet* given, vtkPointSet* created, FFRun& run)
{
  const auto count = static_cast<std::size_t>(given->GetNumberOfPoints());
  if (run.Ids.empty())
  {
    run.Ids.resize(count);
    std::iota(run.Ids.begin(), run.Ids.end(), vtkIdType(0));
  }
  run.Ids.resize(count + static_cast<std::size_t>(created->GetNumberOfPoints()), -1);
  return FFOutput::Append({ given, created });
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
FFConstraints::FFConstraints(vtkFFRegularTriangulationFilter* filter, vtkPolyData* source,
  vtkDataSet* input, const std::vector<vtkIdType>& given, const flipflop::Options& options)
  : FFConstraints({ filter->GetSourcePoints(), isFlat(filter) ? 2 : 3,
                    filter->GetClosedLinesAsBorders(), true, true },
      source, input, given, options)
{
}

//------------------------------------------------------------------------------
FFConstraints::FFConstraints(
  vtkPolyData* source, vtkDataSet* input, const std::vector<vtkIdType>& given, int dimensions)
  : FFConstraints(
      { vtkFFRegularTriangulationFilter::INPUT_POINTS, dimensions, false, false, false }, source,
      input, given, {})
{
}

//------------------------------------------------------------------------------
FFConstraints::FFConstraints(
  int sourcePoints, vtkPolyData* source, vtkDataSet* input, const std::vector<vtkIdType>& given)
  : FFConstraints({ sourcePoints, 2, false, true, false }, source, input, given, {})
{
}

//------------------------------------------------------------------------------
FFConstraints::FFConstraints(const SettingsType& settings, vtkPolyData* source, vtkDataSet* input,
  const std::vector<vtkIdType>& given, const flipflop::Options& options)
  : Source(source)
  , Input(input)
  , Settings(settings)
  , Given(given)
{
  for (vtkCellArray* cells : { source->GetLines(), source->GetPolys() })
  {
    const std::string fault = FFSurfaceCells::DescribeOffsets(cells, "source's cells");
    if (!fault.empty())
    {
      throw std::runtime_error(fault);
    }
  }
  const int points = settings.SourcePoints;
  this->IsOwn = points == vtkFFRegularTriangulationFilter::OWN_POINTS ||
    (points == vtkFFRegularTriangulationFilter::AUTOMATIC_POINTS && this->FindOwnPoints());
  if (settings.ClosedLinesAsBorders)
  {
    this->FindRings(options);
  }
  const vtkIdType vertices = source->GetNumberOfVerts();
  this->Take(source->GetLines(), vertices, Cells::OpenLines);
  const std::size_t lines = this->CellIds.size();
  this->Take(source->GetLines(), vertices, Cells::ClosedLines);
  this->Take(source->GetPolys(), vertices + source->GetNumberOfLines(), Cells::Polygons);
  this->Sides = static_cast<std::int64_t>(this->CellIds.size() - lines);
}

//------------------------------------------------------------------------------
bool FFConstraints::FindOwnPoints() const
{
  const vtkIdType own = this->Source->GetNumberOfPoints();
  const vtkIdType count = this->Input->GetNumberOfPoints();
  vtkNew<vtkIdList> corners;
  for (vtkCellArray* cells : { this->Source->GetLines(), this->Source->GetPolys() })
  {
    for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
    {
      cells->GetCellAtId(i, corners);
      for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
      {
        const vtkIdType point = corners->GetId(k);
        double ours[3], given[3];
        if (point < 0 || point >= own)
        {
          continue; // an error, whosever points they are
        }
        this->Source->GetPoint(point, ours);
        if (point < count)
        {
          this->Input->GetPoint(point, given);
        }
        if (point >= count || !isSame(ours, given, 3))
        {
          return true;
        }
      }
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void FFConstraints::FindRings(const flipflop::Options& options)
{
  vtkDataSet* const points = this->IsOwn ? static_cast<vtkDataSet*>(this->Source) : this->Input;
  std::vector<double> corners;
  std::vector<std::int64_t> offsets(1, 0);
  vtkIdType cell = this->Source->GetNumberOfVerts();
  vtkNew<vtkIdList> ids;
  for (vtkCellArray* cells : { this->Source->GetLines(), this->Source->GetPolys() })
  {
    for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i, ++cell)
    {
      cells->GetCellAtId(i, ids);
      for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
      {
        this->GetId(ids->GetId(k), cell); // is there
        corners.resize(corners.size() + 3);
        points->GetPoint(ids->GetId(k), corners.data() + corners.size() - 3);
      }
      offsets.push_back(static_cast<std::int64_t>(corners.size() / 3));
    }
  }
  flipflop::LineView lines;
  lines.points = flipflop::PointView(corners.data(), offsets.back());
  lines.offsets = offsets.data();
  lines.lines = this->Source->GetNumberOfLines();
  lines.polygons = this->Source->GetNumberOfPolys();
  this->Rings = flipflop::closedLines(lines, this->Settings.Dimensions, options);
}

//------------------------------------------------------------------------------
void FFConstraints::Take(vtkCellArray* cells, vtkIdType firstCell, Cells which)
{
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    cells->GetCellAtId(i, corners);
    const int ring = which == Cells::Polygons || this->Rings.empty() ? 0 : this->Rings[i];
    if (which != Cells::Polygons && (ring != 0) != (which == Cells::ClosedLines))
    {
      continue;
    }
    flipflop::eachConstraintAlong(corners->GetPointer(0), corners->GetNumberOfIds(),
      which == Cells::Polygons,
      [&](vtkIdType from, vtkIdType to)
      {
        this->Ends.push_back(this->GetId(ring < 0 ? to : from, firstCell + i));
        this->Ends.push_back(this->GetId(ring < 0 ? from : to, firstCell + i));
        this->CellIds.push_back(firstCell + i);
      });
  }
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
    throw std::runtime_error("Point " + std::to_string(point) + " of " + describe(cell) +
      " is not there: its ids are those of the input's points, of which there are " +
      std::to_string(count) + ".");
  }
  this->CheckPoint(point, cell);
  if (this->Given.empty())
  {
    return point;
  }
  const auto at = std::lower_bound(this->Given.begin(), this->Given.end(), point);
  if (at == this->Given.end() || *at != point)
  {
    throw std::runtime_error("Point " + std::to_string(point) + " of " + describe(cell) +
      " is a ghost point, which is left out. Turn off Skip Ghost Points, or take the cell away.");
  }
  return at - this->Given.begin();
}

//------------------------------------------------------------------------------
void FFConstraints::CheckOwnPoint(vtkIdType point, vtkIdType cell) const
{
  const vtkIdType own = this->Source->GetNumberOfPoints();
  if (point < 0 || point >= own)
  {
    throw std::runtime_error("Point " + std::to_string(point) + " of " + describe(cell) +
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
  double ours[3], given[3];
  this->Source->GetPoint(point, ours);
  this->Input->GetPoint(point, given);
  if (!isSame(ours, given, this->Settings.Dimensions))
  {
    throw std::runtime_error("Point " + std::to_string(point) + " of " + describe(cell) +
      " is at " + toText(ours) + ", and point " + std::to_string(point) + " of the input is at " +
      toText(given) + ". The source's cells name points of the input by id, so at these ids its " +
      std::to_string(own) + " points must be those of the input, of which there are " +
      std::to_string(this->Input->GetNumberOfPoints()) + "; or it has no points." +
      (this->Settings.TakesOwnPoints ? " If they are its own, set Source Points to Own Points."
                                     : ""));
  }
}

//------------------------------------------------------------------------------
void FFConstraints::Join(vtkFFRegularTriangulationFilter* filter, FFPlanarInput& input, FFRun& run)
{
  this->Lines.emplace(filter, run);
  if (this->IsOwn)
  {
    this->Lines->SetPoints(this->Source);
    this->Lines->ProjectAs(input);
  }
  this->OwnHeights = this->IsOwn ? this->Lines->GetSpace() : input.GetSpace();
  this->InputCount = input.GetPlane().count;
  this->Joined = flipflop::joinLines(input.GetPlane(),
    this->IsOwn ? this->Lines->GetPlane() : input.GetPlane(), this->GetWhole(), run.Options);
  if (this->GetNumberOfJoinedPoints() > 0)
  {
    const flipflop::Buffer<double>& joined = this->Joined->positions;
    flipflop::Buffer<double> positions(joined.size());
    std::copy(joined.begin(), joined.end(), positions.begin());
    input.SetPositions(std::move(positions));
    input.SetPoints(this->AppendOwnPoints(input.GetPoints(), run));
  }
}

//------------------------------------------------------------------------------
void FFConstraints::Join(const flipflop::PointView& points, const flipflop::PointView& own,
  const flipflop::Options& options)
{
  this->OwnHeights = own;
  this->InputCount = points.count;
  const flipflop::Buffer<double> finite[2] = { flipflop::positionsInXY(points, options),
    flipflop::positionsInXY(own, options) };
  const auto planeOf = [&](int which, const flipflop::PointView& space)
  {
    return finite[which].empty() ? space
                                 : flipflop::PointView(finite[which].data(), space.count, 2);
  };
  this->Joined =
    flipflop::joinLines(planeOf(0, points), planeOf(1, own), this->GetWhole(), options);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPointSet> FFConstraints::AppendOwnPoints(vtkPointSet* given, FFRun& run) const
{
  return append(given, FFOutput::SelectLike(given, this->Source, this->Joined->added), run);
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
  this->Heights = flipflop::lineHeights(points, this->OwnHeights, this->GetWhole(), *this->Joined,
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
flipflop::ConstraintView FFConstraints::GetWhole() const
{
  return { this->Ends.data(), static_cast<std::int64_t>(this->CellIds.size()), this->Sides };
}

//------------------------------------------------------------------------------
flipflop::ConstraintView FFConstraints::GetView() const
{
  return this->Pieces ? this->Pieces->view() : this->GetUnsplit();
}

//------------------------------------------------------------------------------
flipflop::ConstraintView FFConstraints::GetUnsplit() const
{
  return this->Joined ? this->Joined->view() : this->GetWhole();
}

//------------------------------------------------------------------------------
vtkIdType FFConstraints::GetNumberOfJoinedPoints() const
{
  return this->Joined ? static_cast<vtkIdType>(this->Joined->added.size()) : 0;
}

//------------------------------------------------------------------------------
vtkIdType FFConstraints::GetNumberOfNewPoints() const
{
  return this->Pieces ? static_cast<vtkIdType>(this->Pieces->newPointCount()) : 0;
}

//------------------------------------------------------------------------------
vtkIdType FFConstraints::GetCellId(std::int64_t constraint) const
{
  const auto i = static_cast<std::size_t>(constraint);
  return this->CellIds[this->Pieces ? static_cast<std::size_t>(this->Pieces->constraintOf[i]) : i];
}

//------------------------------------------------------------------------------
void FFConstraints::Split(FFPlanarInput& input, const flipflop::Options& options)
{
  const flipflop::PointView view = input.GetPlane();
  this->Pieces = flipflop::splitCrossings(view, this->GetUnsplit(), options);
  if (this->GetNumberOfNewPoints() == 0)
  {
    return;
  }
  const flipflop::Buffer<double>& added = this->Pieces->positions;
  flipflop::Buffer<double> positions(2 * static_cast<std::size_t>(view.count) + added.size());
  double* to = positions.data();
  for (std::int64_t i = 0; i < view.count; ++i)
  {
    *to++ = FFPlanarInput::NumberAt(view, i * view.stride);
    *to++ = FFPlanarInput::NumberAt(view, i * view.stride + 1);
  }
  std::copy(added.begin(), added.end(), to);
  input.SetPositions(std::move(positions));
}

//------------------------------------------------------------------------------
void FFConstraints::AppendNewPoints(FFPlanarInput& input, FFRun& run) const
{
  const vtkIdType added = this->GetNumberOfNewPoints();
  if (added == 0)
  {
    return;
  }
  vtkPointSet* const given = input.GetPoints();
  const vtkIdType count = given->GetNumberOfPoints();
  const vtkIdType joined = this->GetNumberOfJoinedPoints();
  const auto* positions = static_cast<const double*>(input.GetPlane().data);
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
    if (input.IsXYPlane())
    {
      std::copy_n(position, 2, x); // as it was triangulated
      x[2] = this->Heights->added[static_cast<std::size_t>(joined + k)];
    }
    points->SetPoint(k, x);
    created->GetPointData()->InterpolateEdge(given->GetPointData(), k, a, b, share);
  }
  input.SetPoints(append(given, created, run));
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
// What goes wrong with constraints, in words that name their cells; empty for other errors.
std::string FFConstraints::Describe(const flipflop::Error& error, const FFRun& run) const
{
  const auto cellOf = [&](std::int64_t constraint)
  { return describe(this->GetCellId(constraint)); };
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
        (this->Settings.Splits ? ", or turn on Split Crossing Constraints." : ".");
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
