// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFInput.h"

#include "FFRun.h"

#include "Support/FloatingPointEnvironment.h"
#include <flipflop/Buffer.h>
#include <flipflop/Error.h>

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationExecutivePortKey.h"
#include "vtkInformationIntegerKey.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTrivialProducer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <set>
#include <stdexcept>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

/// How many points a grid has: no more than an engine takes.
std::int64_t countOf(const int* dimensions)
{
  if (*std::min_element(dimensions, dimensions + 3) <= 0)
  {
    return 0;
  }
  constexpr std::int64_t limit = std::numeric_limits<std::int64_t>::max();
  const std::int64_t layer = static_cast<std::int64_t>(dimensions[0]) * dimensions[1];
  const std::int64_t count = layer > limit / dimensions[2] ? limit : layer * dimensions[2];
  if (count > 4294967294)
  {
    throw flipflop::Error(flipflop::ErrorCode::TooManyPoints, -1, count);
  }
  return count;
}

/// The points of a grid, each by @p position(index along each axis, xyz), on all threads.
template <class ArrayT, class Position>
vtkSmartPointer<vtkPoints> layOut(const int* dimensions, const Position& position)
{
  using Value = typename ArrayT::ValueType;
  const auto count = static_cast<vtkIdType>(countOf(dimensions));
  flipflop::Buffer<Value> values(3 * static_cast<std::size_t>(count));
  vtkSMPTools::For(0, count, 1 << 14,
    [&](vtkIdType begin, vtkIdType end)
    {
      const flipflop::DefaultFloatingPointEnvironment environment; // VTK's threads have their own
      double xyz[3];
      for (vtkIdType i = begin; i < end; ++i)
      {
        const vtkIdType row = i / dimensions[0];
        const int at[3] = { static_cast<int>(i % dimensions[0]),
          static_cast<int>(row % dimensions[1]), static_cast<int>(row / dimensions[1]) };
        position(at, xyz);
        std::transform(xyz, xyz + 3, values.data() + 3 * i,
          [](double value) { return static_cast<Value>(value); });
      }
    });
  vtkNew<ArrayT> array;
  array->SetNumberOfComponents(3);
  if (count > 0)
  {
    array->SetArray(values.release(), 3 * count, 0, ArrayT::VTK_DATA_ARRAY_ALIGNED_FREE);
  }
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(array);
  return points;
}

/// GetPoint() of an image has other bits in VTK 9.6 than before.
vtkSmartPointer<vtkPoints> layOut(vtkImageData* image)
{
  const int* const extent = image->GetExtent();
  return layOut<vtkDoubleArray>(image->GetDimensions(),
    [&](const int* at, double* xyz)
    {
      image->TransformIndexToPhysicalPoint(
        extent[0] + at[0], extent[2] + at[1], extent[4] + at[2], xyz);
    });
}

/// Reads a grid's coordinates along x, y or z.
void readAxis(vtkDataArray* array, int count, char axis, const std::string& ofWhat,
  std::optional<FFWeightSource>& values)
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
    values.emplace(array, flipflop::WeightRule(), "coordinate");
  }
  catch (const FFInexactValue& error)
  {
    throw std::runtime_error("The " + along + " " + std::to_string(error.GetIndex()) +
      " of the vtkRectilinearGrid" + ofWhat +
      " is a 64-bit integer that no double holds. Subtract an offset from all: the result has the "
      "same shape.");
  }
}

vtkSmartPointer<vtkPoints> layOut(vtkRectilinearGrid* grid, const std::string& ofWhat)
{
  const int* const dimensions = grid->GetDimensions();
  if (countOf(dimensions) == 0)
  {
    return vtkSmartPointer<vtkPoints>::New();
  }
  vtkDataArray* const arrays[3] = { grid->GetXCoordinates(), grid->GetYCoordinates(),
    grid->GetZCoordinates() };
  std::optional<FFWeightSource> values[3];
  bool areFloats = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    readAxis(arrays[axis], dimensions[axis], "xyz"[axis], ofWhat, values[axis]);
    areFloats = areFloats && arrays[axis]->GetDataType() == VTK_FLOAT;
  }
  const auto position = [&](const int* at, double* xyz)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      xyz[axis] = FFNumberAt(values[axis]->GetView(), at[axis]);
    }
  };
  return areFloats ? layOut<vtkFloatArray>(dimensions, position)
                   : layOut<vtkDoubleArray>(dimensions, position);
}

/// The points that are no duplicates of another piece's, and not hidden; null: all.
vtkSmartPointer<vtkIdTypeArray> idsWithoutGhosts(vtkPointSet* piece, const std::string& ofWhat)
{
  vtkUnsignedCharArray* const marks = piece->GetPointGhostArray();
  const vtkIdType count = piece->GetNumberOfPoints();
  if (!marks || count == 0)
  {
    return nullptr;
  }
  if (marks->GetNumberOfValues() != count)
  {
    throw std::runtime_error(std::string("The point array ") +
      vtkDataSetAttributes::GhostArrayName() + ofWhat + " has " +
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

/// Leaves out the ghosts among the pieces' points. Returns the ids of the others among all points;
/// none, if all remain.
/// @param names how errors name the pieces
std::optional<std::vector<vtkIdType>> skipGhosts(
  std::vector<vtkSmartPointer<vtkPointSet>>& pieces, const std::vector<std::string>& names)
{
  std::optional<std::vector<vtkIdType>> ids;
  vtkIdType begin = 0;
  for (std::size_t k = 0; k < pieces.size(); ++k)
  {
    vtkSmartPointer<vtkPointSet>& piece = pieces[k];
    const vtkIdType size = piece->GetNumberOfPoints();
    const auto own = idsWithoutGhosts(piece, names[k]);
    if (own && !ids)
    {
      ids.emplace(static_cast<std::size_t>(begin));
      std::iota(ids->begin(), ids->end(), vtkIdType(0));
    }
    for (vtkIdType i = 0; ids && i < (own ? own->GetNumberOfValues() : size); ++i)
    {
      ids->push_back(begin + (own ? own->GetValue(i) : i));
    }
    piece = own ? FFOutput::Select(piece, own) : piece;
    begin += size;
  }
  return ids;
}

/// Whether some algorithm that the data of this information comes from is such a one.
using Test = std::function<bool(vtkAlgorithm* algorithm, vtkInformation* output)>;
bool anyUpstream(vtkInformation* info, const Test& isSuch, std::set<vtkExecutive*>& visited)
{
  vtkExecutive* producer = nullptr;
  int port = 0;
  if (info)
  {
    vtkExecutive::PRODUCER()->Get(info, producer, port);
  }
  if (!producer || !visited.insert(producer).second)
  {
    return false;
  }
  vtkAlgorithm* const algorithm = producer->GetAlgorithm();
  bool isFound = isSuch(algorithm, info);
  for (int i = 0; i < algorithm->GetNumberOfInputPorts(); ++i)
  {
    for (int k = 0; !isFound && k < algorithm->GetNumberOfInputConnections(i); ++k)
    {
      isFound = anyUpstream(producer->GetInputInformation(i, k), isSuch, visited);
    }
  }
  return isFound;
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
  if (!input)
  {
    return;
  }
  input->Remove(Pipeline::UPDATE_EXTENT());
  if (input->Has(Pipeline::WHOLE_EXTENT()))
  {
    input->Set(Pipeline::UPDATE_EXTENT(), input->Get(Pipeline::WHOLE_EXTENT()), 6);
  }
  FFInputPieces::Request(input, 0, 1);
  input->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
}

//------------------------------------------------------------------------------
std::string FFInput::NameOf(const PieceType& piece, const FFRun& run, const std::string& ofInput)
{
  return piece.IsBlock ? " of the block of flat index " + std::to_string(piece.FlatIndex) + ofInput
    : ofInput.empty()  ? run.OfWhat()
                       : ofInput;
}

//------------------------------------------------------------------------------
void FFInput::CheckPoints(vtkPointSet* points, const std::string& ofWhat)
{
  const int size =
    points->GetPoints() ? points->GetPoints()->GetData()->GetNumberOfComponents() : 3;
  if (size != 3)
  {
    throw std::runtime_error("The points" + ofWhat + " have " + std::to_string(size) +
      " coordinates each; a point has 3.");
  }
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
vtkIdType FFInput::TakePieces(const std::vector<PieceType>& pieces, bool areGhostsSkipped,
  FFRun& run, const std::string& ofInput)
{
  std::vector<std::string> names;
  vtkIdType count = 0;
  for (const PieceType& piece : pieces)
  {
    const std::string& ofWhat = names.emplace_back(NameOf(piece, run, ofInput));
    this->Pieces.push_back(PointsOf(piece.Data, ofWhat));
    vtkPointSet* const points = this->Pieces.back();
    CheckPoints(points, ofWhat);
    count += points->GetNumberOfPoints();
    if (piece.IsBlock || !ofInput.empty())
    {
      run.Parts.push_back({ points->GetNumberOfPoints(), ofWhat, piece.FlatIndex });
    }
  }
  if (areGhostsSkipped)
  {
    run.Ids = skipGhosts(this->Pieces, names);
  }
  return count;
}

//------------------------------------------------------------------------------
void FFInput::TakeCoordinates()
{
  this->Points.emplace(std::vector<vtkPointSet*>(this->Pieces.begin(), this->Pieces.end()));
}

//------------------------------------------------------------------------------
std::vector<FFOutput::Source> FFInput::GetPointData() const
{
  return FFOutput::DataOf({ this->Pieces.begin(), this->Pieces.end() });
}

//------------------------------------------------------------------------------
int FFInputPieces::Count(vtkInformation* input, int wanted)
{
  // The executive asks sources that cannot deliver pieces for the first alone, and leaves that in
  // place of the others. What was set as data says that it can, and gives all for each piece.
  const auto canDeliver = [](vtkAlgorithm* algorithm, vtkInformation* output)
  {
    return algorithm->GetTotalNumberOfInputConnections() == 0 &&
      !vtkTrivialProducer::SafeDownCast(algorithm) &&
      (output->Get(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST()) ||
        output->Get(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT()));
  };
  std::set<vtkExecutive*> visited;
  return anyUpstream(input, canDeliver, visited) ? wanted : 1;
}

//------------------------------------------------------------------------------
void FFInputPieces::Request(vtkInformation* input, int piece, int count)
{
  input->Set(Pipeline::UPDATE_PIECE_NUMBER(), piece);
  input->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), count);
}

//------------------------------------------------------------------------------
vtkDataObject* FFInputPieces::Take(vtkInformation* input, bool isThere)
{
  vtkExecutive* producer = nullptr;
  int port = 0;
  if (!isThere && input)
  {
    vtkExecutive::PRODUCER()->Get(input, producer, port);
  }
  if (producer)
  {
    const flipflop::CallersFloatingPointEnvironment upstream;
    isThere = producer->Update(port);
  }
  return Check(input, isThere);
}

//------------------------------------------------------------------------------
vtkDataObject* FFInputPieces::Check(vtkInformation* input, bool isThere)
{
#if VTK_FF_HAS_CHECK_ABORT
  if (input && input->Get(vtkAlgorithm::ABORTED()))
  {
    throw flipflop::Error(flipflop::ErrorCode::Aborted);
  }
#endif
  vtkDataObject* const piece = isThere ? vtkDataObject::GetData(input) : nullptr;
  if (!piece)
  {
    // VTK takes an algorithm that failed for one that is up to date, without data, until it is
    // modified.
    const auto forgetFailure = [](vtkAlgorithm* algorithm, vtkInformation*)
    {
      algorithm->Modified();
      return false;
    };
    std::set<vtkExecutive*> visited;
    anyUpstream(input, forgetFailure, visited);
    throw std::runtime_error("The input did not deliver it. Its own error says why.");
  }
  return piece;
}

//------------------------------------------------------------------------------
std::string FFInputPieces::Describe(int piece, int count, const std::string& ofProcess)
{
  return "Piece " + std::to_string(piece + 1) + " of " + std::to_string(count) + ofProcess + ": ";
}
VTK_ABI_NAMESPACE_END
