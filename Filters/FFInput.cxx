// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFInput.h"

#include "FFExactValues.h"
#include "FFOutput.h"
#include "FFRun.h"

#include "Support/FloatingPointEnvironment.h"
#include <flipflop/Buffer.h>

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <stdexcept>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

vtkDataArray* coordinatesOf(vtkPointSet* piece)
{
  return piece->GetPoints() ? piece->GetPoints()->GetData() : nullptr;
}

constexpr std::int64_t mostPoints = 4294967294; // what an engine takes

/// How many points a grid has.
std::int64_t countOf(const int* dimensions)
{
  if (*std::min_element(dimensions, dimensions + 3) <= 0)
  {
    return 0;
  }
  const std::int64_t layer = static_cast<std::int64_t>(dimensions[0]) * dimensions[1];
  if (layer > mostPoints / dimensions[2])
  {
    constexpr std::int64_t limit = std::numeric_limits<std::int64_t>::max();
    throw flipflop::Error(flipflop::ErrorCode::TooManyPoints, -1,
      layer > limit / dimensions[2] ? limit : layer * dimensions[2]);
  }
  return layer * dimensions[2];
}

/// So many points of a grid, each by @p position(i, xyz), on all threads.
template <class ArrayT, class Position>
vtkSmartPointer<vtkPoints> layOut(std::int64_t count, const Position& position)
{
  using Value = typename ArrayT::ValueType;
  flipflop::Buffer<Value> values(3 * static_cast<std::size_t>(count));
  vtkSMPTools::For(0, static_cast<vtkIdType>(count), 1 << 14,
    [&](vtkIdType begin, vtkIdType end)
    {
      const flipflop::DefaultFloatingPointEnvironment environment; // VTK's threads have their own
      double xyz[3];
      for (vtkIdType i = begin; i < end; ++i)
      {
        position(i, xyz);
        std::transform(xyz, xyz + 3, values.data() + 3 * i,
          [](double value) { return static_cast<Value>(value); });
      }
    });
  vtkNew<ArrayT> array;
  array->SetNumberOfComponents(3);
  if (count > 0)
  {
    array->SetArray(values.release(), static_cast<vtkIdType>(3 * count), 0,
      vtkAbstractArray::VTK_DATA_ARRAY_ALIGNED_FREE);
  }
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(array);
  return points;
}

/// Checks a grid's coordinates along x, y or z.
void checkCoordinates(vtkDataArray* array, int count, char axis, const std::string& ofWhat)
{
  const std::string along = std::string(1, axis) + " coordinate";
  if (!array || array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() < count)
  {
    throw std::runtime_error("The vtkRectilinearGrid" + ofWhat + " has " +
      std::to_string(array ? array->GetNumberOfTuples() : 0) + " " + along + "(s) of " +
      std::to_string(array ? array->GetNumberOfComponents() : 0) + " component(s) and needs " +
      std::to_string(count) + " of 1.");
  }
  try
  {
    flipflop::Buffer<double> values(static_cast<std::size_t>(array->GetNumberOfTuples()));
    FFExactValues::Copy<1>(array, "coordinate", 0, values.data());
  }
  catch (const FFInexactValue& error)
  {
    throw std::runtime_error("The " + along + " " + std::to_string(error.GetIndex()) +
      " of the vtkRectilinearGrid" + ofWhat +
      " is a 64-bit integer that no double holds. Subtract an offset from all: the result has the "
      "same shape.");
  }
}

/// GetPoint() of an image has other bits in VTK 9.6 than before.
vtkSmartPointer<vtkPoints> layOut(vtkImageData* image)
{
  int extent[6];
  int dimensions[3];
  image->GetExtent(extent);
  image->GetDimensions(dimensions);
  return layOut<vtkDoubleArray>(countOf(dimensions),
    [&](vtkIdType id, double* xyz)
    {
      const vtkIdType row = id / dimensions[0];
      image->TransformIndexToPhysicalPoint(extent[0] + static_cast<int>(id % dimensions[0]),
        extent[2] + static_cast<int>(row % dimensions[1]),
        extent[4] + static_cast<int>(row / dimensions[1]), xyz);
    });
}

vtkSmartPointer<vtkPoints> layOut(vtkRectilinearGrid* grid, const std::string& ofWhat)
{
  int dimensions[3];
  grid->GetDimensions(dimensions);
  const std::int64_t count = countOf(dimensions);
  if (count == 0)
  {
    return vtkSmartPointer<vtkPoints>::New();
  }
  vtkDataArray* const arrays[3] = { grid->GetXCoordinates(), grid->GetYCoordinates(),
    grid->GetZCoordinates() };
  for (int axis = 0; axis < 3; ++axis)
  {
    checkCoordinates(arrays[axis], dimensions[axis], "xyz"[axis], ofWhat);
  }
  grid->GetPoint(0); // newer VTK makes what it needs in the first call
  const auto position = [&](vtkIdType id, double* xyz) { grid->GetPoint(id, xyz); };
  return std::all_of(
           arrays, arrays + 3, [](auto* array) { return array->GetDataType() == VTK_FLOAT; })
    ? layOut<vtkFloatArray>(count, position)
    : layOut<vtkDoubleArray>(count, position);
}

/// The points that are no ghosts; null: all.
vtkSmartPointer<vtkIdTypeArray> idsWithoutGhosts(vtkPointSet* piece)
{
  vtkUnsignedCharArray* marks = piece->GetPointGhostArray();
  const vtkIdType count = piece->GetNumberOfPoints();
  if (!marks || count == 0)
  {
    return nullptr;
  }
  if (marks->GetNumberOfValues() != count)
  {
    throw std::runtime_error(std::string("The point array ") +
      vtkDataSetAttributes::GhostArrayName() + " has " +
      std::to_string(marks->GetNumberOfValues()) + " value(s) for " + std::to_string(count) +
      " point(s). Mend or remove it, or turn off Skip Ghost Points.");
  }
  constexpr int ghost = vtkDataSetAttributes::DUPLICATEPOINT | vtkDataSetAttributes::HIDDENPOINT;
  auto ids = vtkSmartPointer<vtkIdTypeArray>::New();
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (!(marks->GetValue(i) & ghost))
    {
      ids->InsertNextValue(i);
    }
  }
  return ids->GetNumberOfValues() < count ? ids : nullptr;
}

}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPointSet> FFInput::PointsOf(vtkDataObject* data, const std::string& ofWhat)
{
  if (auto* points = vtkPointSet::SafeDownCast(data))
  {
    return points;
  }
  auto* image = vtkImageData::SafeDownCast(data);
  auto* grid = vtkRectilinearGrid::SafeDownCast(data);
  if (!image && !grid)
  {
    throw std::runtime_error("The data" + ofWhat + " is a " + data->GetClassName() +
      ". It must be a vtkDataSet, or a composite of these.");
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(image ? layOut(image) : layOut(grid, ofWhat));
  result->GetPointData()->ShallowCopy(vtkDataSet::SafeDownCast(data)->GetPointData());
  FFOutput::PassFieldData(data, result);
  return result;
}

//------------------------------------------------------------------------------
void FFInput::RequestAll(vtkInformation* input)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (!input)
  {
    return;
  }
  input->Remove(Pipeline::UPDATE_EXTENT());
  if (input->Has(Pipeline::WHOLE_EXTENT()))
  {
    input->Set(Pipeline::UPDATE_EXTENT(), input->Get(Pipeline::WHOLE_EXTENT()), 6);
  }
  input->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
  input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
  input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
}

//------------------------------------------------------------------------------
vtkIdType FFInput::Take(
  const std::vector<PieceType>& pieces, bool skipGhosts, FFRun& run, const std::string& ofInput)
{
  const vtkIdType count = this->TakePieces(pieces, skipGhosts, run, ofInput);
  this->TakeCoordinates();
  return count;
}

//------------------------------------------------------------------------------
vtkIdType FFInput::TakePieces(
  const std::vector<PieceType>& pieces, bool skipGhosts, FFRun& run, const std::string& ofInput)
{
  vtkIdType count = 0;
  for (const PieceType& piece : pieces)
  {
    const std::string ofWhat = piece.FlatIndex > 0
      ? " of the block of flat index " + std::to_string(piece.FlatIndex) + ofInput
      : ofInput.empty() ? run.OfWhat()
                        : ofInput;
    this->Pieces.push_back(PointsOf(piece.Data, ofWhat));
    vtkPointSet* const points = this->Pieces.back();
    vtkDataArray* const array = coordinatesOf(points);
    if (array && array->GetNumberOfComponents() != 3)
    {
      throw std::runtime_error("The points" + ofWhat + " have " +
        std::to_string(array->GetNumberOfComponents()) + " coordinates each; a point has 3.");
    }
    count += points->GetNumberOfPoints();
    if (piece.FlatIndex > 0 || !ofInput.empty())
    {
      run.Parts.push_back({ points->GetNumberOfPoints(), ofWhat, piece.FlatIndex });
    }
  }
  if (skipGhosts)
  {
    run.Ids = this->SkipGhosts();
  }
  return count;
}

//------------------------------------------------------------------------------
void FFInput::TakeCoordinates()
{
  std::vector<vtkDataArray*> arrays;
  for (vtkPointSet* piece : this->Pieces)
  {
    arrays.push_back(coordinatesOf(piece));
  }
  this->Points.emplace(arrays);
}

//------------------------------------------------------------------------------
std::vector<FFOutput::Source> FFInput::GetPointData() const
{
  std::vector<FFOutput::Source> data;
  for (vtkPointSet* piece : this->Pieces)
  {
    data.push_back({ piece->GetPointData(), piece->GetNumberOfPoints() });
  }
  return data;
}
//------------------------------------------------------------------------------
std::vector<vtkIdType> FFInput::SkipGhosts()
{
  std::vector<vtkSmartPointer<vtkIdTypeArray>> remaining;
  std::transform(
    this->Pieces.begin(), this->Pieces.end(), std::back_inserter(remaining), idsWithoutGhosts);
  std::vector<vtkIdType> ids;
  if (std::none_of(remaining.begin(), remaining.end(), [](auto& array) { return array.Get(); }))
  {
    return ids;
  }
  vtkIdType begin = 0;
  for (std::size_t k = 0; k < remaining.size(); ++k)
  {
    const vtkIdType size = this->Pieces[k]->GetNumberOfPoints();
    vtkIdTypeArray* const own = remaining[k];
    const vtkIdType count = own ? own->GetNumberOfValues() : size;
    for (vtkIdType i = 0; i < count; ++i)
    {
      ids.push_back(begin + (own ? own->GetValue(i) : i));
    }
    if (own)
    {
      this->Pieces[k] = FFOutput::Select(this->Pieces[k], own);
    }
    begin += size;
  }
  return ids;
}
VTK_ABI_NAMESPACE_END
