// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFConstraints.h"

#include "vtkFFSurfaceCells.h"

#include "vtkCellArray.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iomanip>
#include <sstream>
#include <stdexcept>

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

}

//------------------------------------------------------------------------------
vtkFFConstraints::vtkFFConstraints(
  vtkPolyData* source, vtkDataSet* input, const std::vector<vtkIdType>& places, bool withHeight)
  : Source(source)
  , Input(input)
  , Dimensions(withHeight ? 3 : 2)
  , Places(places)
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
  if (this->Places.empty())
  {
    return point;
  }
  const auto place = std::lower_bound(this->Places.begin(), this->Places.end(), point);
  if (place == this->Places.end() || *place != point)
  {
    throw std::runtime_error("Point " + std::to_string(point) + " of " + describe(cell) +
      " is a ghost point, which is left out. Turn off Skip Ghost Points, or take the cell away.");
  }
  return place - this->Places.begin();
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
flipflop::ConstraintView vtkFFConstraints::GetView() const
{
  return { this->Ends.data(), static_cast<std::int64_t>(this->CellIds.size()), this->Sides };
}

//------------------------------------------------------------------------------
std::string vtkFFConstraints::DescribeCell(std::int64_t constraint) const
{
  return describe(this->GetCellId(constraint));
}
VTK_ABI_NAMESPACE_END
