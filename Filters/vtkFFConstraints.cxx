// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFConstraints.h"

#include "vtkFFOutput.h"
#include "vtkFFPlanarInput.h"
#include "vtkFFRun.h"
#include "vtkFFSurfaceCells.h"

#include <flipflop/Error.h>

#include "vtkCellArray.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

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
vtkFFConstraints::vtkFFConstraints(
  vtkPolyData* source, vtkDataSet* input, const std::vector<vtkIdType>& given, bool withHeight)
  : Source(source)
  , Input(input)
  , Dimensions(withHeight ? 3 : 2)
  , Given(given)
{
  for (vtkCellArray* cells : { source->GetLines(), source->GetPolys() })
  {
    const std::string fault = vtkFFSurfaceCells::DescribeOffsets(cells, "source's cells");
    if (!fault.empty())
    {
      throw std::runtime_error(fault);
    }
  }
  const vtkIdType vertices = source->GetNumberOfVerts();
  this->Take(source->GetLines(), vertices, false);
  const std::size_t lines = this->CellIds.size();
  this->Take(source->GetPolys(), vertices + source->GetNumberOfLines(), true);
  this->Sides = static_cast<std::int64_t>(this->CellIds.size() - lines);
}

//------------------------------------------------------------------------------
void vtkFFConstraints::Take(vtkCellArray* cells, vtkIdType firstCell, bool areClosed)
{
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    cells->GetCellAtId(i, corners);
    const vtkIdType size = corners->GetNumberOfIds();
    for (vtkIdType k = areClosed ? 0 : 1; k < size; ++k)
    {
      const vtkIdType before = corners->GetId(k > 0 ? k - 1 : size - 1);
      this->Ends.push_back(this->GetId(before, firstCell + i));
      this->Ends.push_back(this->GetId(corners->GetId(k), firstCell + i));
      this->CellIds.push_back(firstCell + i);
    }
  }
}

//------------------------------------------------------------------------------
std::int64_t vtkFFConstraints::GetId(vtkIdType point, vtkIdType cell) const
{
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
void vtkFFConstraints::CheckPoint(vtkIdType point, vtkIdType cell) const
{
  const vtkIdType own = this->Source->GetNumberOfPoints();
  if (own == 0)
  {
    return;
  }
  if (point >= own)
  {
    throw std::runtime_error("Point " + std::to_string(point) + " of " + describe(cell) +
      " is not there: the source has " + std::to_string(own) + " point(s).");
  }
  double ours[3], given[3];
  this->Source->GetPoint(point, ours);
  this->Input->GetPoint(point, given);
  const auto isSame = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
  if (!std::equal(ours, ours + this->Dimensions, given, isSame))
  {
    throw std::runtime_error("Point " + std::to_string(point) + " of " + describe(cell) +
      " is at " + toText(ours) + ", and point " + std::to_string(point) + " of the input is at " +
      toText(given) + ". The source's cells name points of the input by id, so at these ids its " +
      std::to_string(own) + " points must be those of the input, of which there are " +
      std::to_string(this->Input->GetNumberOfPoints()) + "; or it has no points.");
  }
}

//------------------------------------------------------------------------------
flipflop::ConstraintView vtkFFConstraints::GetWhole() const
{
  return { this->Ends.data(), static_cast<std::int64_t>(this->CellIds.size()), this->Sides };
}

//------------------------------------------------------------------------------
flipflop::ConstraintView vtkFFConstraints::GetView() const
{
  return this->Pieces ? this->Pieces->view() : this->GetWhole();
}

//------------------------------------------------------------------------------
vtkIdType vtkFFConstraints::GetNumberOfNewPoints() const
{
  return this->Pieces ? static_cast<vtkIdType>(this->Pieces->newPointCount()) : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkFFConstraints::GetCellId(std::int64_t constraint) const
{
  const auto i = static_cast<std::size_t>(constraint);
  return this->CellIds[this->Pieces ? static_cast<std::size_t>(this->Pieces->constraintOf[i]) : i];
}

//------------------------------------------------------------------------------
void vtkFFConstraints::Split(vtkFFPlanarInput& input, const flipflop::Options& options)
{
  const flipflop::PointView view = input.GetPlane();
  this->Pieces = flipflop::splitCrossings(view, this->GetWhole(), options);
  if (this->GetNumberOfNewPoints() == 0)
  {
    return;
  }
  const flipflop::Buffer<double>& added = this->Pieces->positions;
  flipflop::Buffer<double> positions(2 * static_cast<std::size_t>(view.count) + added.size());
  double* to = positions.data();
  for (std::int64_t i = 0; i < view.count; ++i)
  {
    *to++ = vtkFFPlanarInput::NumberAt(view, i * view.stride);
    *to++ = vtkFFPlanarInput::NumberAt(view, i * view.stride + 1);
  }
  std::copy(added.begin(), added.end(), to);
  input.SetPositions(std::move(positions));
}

//------------------------------------------------------------------------------
void vtkFFConstraints::AppendNewPoints(vtkFFPlanarInput& input, vtkFFRun& run) const
{
  const vtkIdType added = this->GetNumberOfNewPoints();
  if (added == 0)
  {
    return;
  }
  vtkPointSet* const given = input.GetPoints();
  const vtkIdType count = given->GetNumberOfPoints();
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
    const std::int64_t* const ends = this->Ends.data() + 2 * this->Pieces->crossing[crossing];
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
    }
    points->SetPoint(k, x);
    created->GetPointData()->InterpolateEdge(given->GetPointData(), k, a, b, share);
  }
  if (run.Ids.empty())
  {
    run.Ids.resize(static_cast<std::size_t>(count));
    std::iota(run.Ids.begin(), run.Ids.end(), vtkIdType(0));
  }
  run.Ids.resize(static_cast<std::size_t>(count + added), -1);
  input.SetPoints(vtkFFOutput::Append({ given, created }));
}

//------------------------------------------------------------------------------
std::string vtkFFConstraints::Describe(const flipflop::Error& error, const vtkFFRun& run) const
{
  const auto cellOf = [&](std::int64_t constraint)
  { return describe(this->GetCellId(constraint)); };
  switch (error.code())
  {
    case flipflop::ErrorCode::ConstraintPoint:
      return "Point " + std::to_string(run.GetId(static_cast<vtkIdType>(error.count()))) + " of " +
        cellOf(error.index()) + " is left out: it has a coordinate that is NaN or infinite.";
    case flipflop::ErrorCode::ConstraintsCross:
      return "An edge of " + cellOf(error.index()) + " crosses one of " + cellOf(error.count()) +
        ", and there is no point where they do. Add one to the input and to both, or turn on Split "
        "Crossing Constraints.";
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
