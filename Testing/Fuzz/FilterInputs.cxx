// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FilterInputs.h"
#include "Clouds.h"
#include "DrawSurface.h"
#include "FilterArrays.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkTable.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <limits>

namespace flipflop
{
namespace fuzz
{

namespace
{

vtkSmartPointer<vtkPoints> makePoints(Bytes& bytes, const Cloud& cloud)
{
  const auto count = static_cast<vtkIdType>(cloud.size());
  const auto array = drawDataArray(bytes, 3, count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      setComponent(array, i, k, cloud[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)]);
    }
  }
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(array);
  return points;
}

/// Cells of these corners, in 32 or 64 bits, with more corners behind the last cell's.
template <class ArrayT>
vtkSmartPointer<vtkCellArray> storeCells(
  Bytes& bytes, const std::vector<std::vector<std::int64_t>>& cells)
{
  using Value = typename ArrayT::ValueType;
  vtkNew<ArrayT> offsets;
  vtkNew<ArrayT> corners;
  offsets->InsertNextValue(0);
  for (const auto& cell : cells)
  {
    for (const std::int64_t corner : cell)
    {
      corners->InsertNextValue(static_cast<Value>(corner));
    }
    offsets->InsertNextValue(static_cast<Value>(corners->GetNumberOfValues()));
  }
  for (int more = bytes.oneOf(4) ? bytes.byte() : 0; more > 0; --more)
  {
    corners->InsertNextValue(0);
  }
  corners->Squeeze();
  auto result = vtkSmartPointer<vtkCellArray>::New();
  result->SetData(offsets.Get(), corners.Get());
  return result;
}

vtkSmartPointer<vtkCellArray> makeCells(
  Bytes& bytes, const std::vector<std::vector<std::int64_t>>& cells)
{
  return bytes.flag() ? storeCells<vtkTypeInt32Array>(bytes, cells)
                      : storeCells<vtkTypeInt64Array>(bytes, cells);
}

/// Cells of any sizes over points that are there.
vtkSmartPointer<vtkCellArray> drawCells(Bytes& bytes, vtkIdType points)
{
  std::vector<std::vector<std::int64_t>> cells;
  for (int n = bytes.below(4); n > 0 && points > 0; --n)
  {
    cells.emplace_back();
    for (int size = bytes.below(6); size > 0; --size)
    {
      cells.back().push_back(bytes.byte() % points);
    }
  }
  return makeCells(bytes, cells);
}

vtkSmartPointer<vtkPolyData> drawSurfaceData(Bytes& bytes, int most)
{
  const test::Surface surface = drawSurface(bytes, most);
  std::vector<std::vector<std::int64_t>> cells;
  for (const test::Corners& triangle : surface.triangles)
  {
    cells.emplace_back(triangle.begin(), triangle.end());
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(makePoints(bytes, surface.points));
  data->SetPolys(makeCells(bytes, cells));
  return data;
}

vtkSmartPointer<vtkPolyData> drawPolyData(Bytes& bytes, int most)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  const int kinds = bytes.byte();
  if (kinds & 16)
  {
    return data; // without points, without arrays of cells
  }
  const Cloud cloud = drawCloud(bytes, most);
  data->SetPoints(makePoints(bytes, cloud));
  const auto points = static_cast<vtkIdType>(cloud.size());
  if (kinds & 1)
  {
    data->SetVerts(drawCells(bytes, points));
  }
  if (kinds & 2)
  {
    data->SetLines(drawCells(bytes, points));
  }
  if (kinds & 4)
  {
    data->SetPolys(drawCells(bytes, points));
  }
  if (kinds & 8)
  {
    data->SetStrips(drawCells(bytes, points));
  }
  return data;
}

vtkSmartPointer<vtkDataObject> drawOtherPoints(Bytes& bytes, int kind, int most)
{
  const Cloud cloud = drawCloud(bytes, most);
  const auto points = makePoints(bytes, cloud);
  const int count = static_cast<int>(cloud.size());
  if (kind == 0)
  {
    auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
    grid->SetPoints(points);
    for (vtkIdType i = 0; i < std::min(count, 3); ++i)
    {
      grid->InsertNextCell(VTK_VERTEX, 1, &i);
    }
    return grid;
  }
  if (kind == 1)
  {
    auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
    grid->SetDimensions(count, 1, 1);
    grid->SetPoints(points);
    return grid;
  }
  auto set = vtkSmartPointer<vtkPointSet>::New();
  set->SetPoints(points);
  return set;
}

vtkSmartPointer<vtkDataObject> drawImplicitPoints(Bytes& bytes, bool image)
{
  int dimensions[3];
  for (int& d : dimensions)
  {
    d = bytes.below(5);
  }
  if (image)
  {
    auto data = vtkSmartPointer<vtkImageData>::New();
    data->SetDimensions(dimensions);
    data->SetOrigin(bytes.number(), 0, 0);
    data->SetSpacing(1, bytes.flag() ? 1 : bytes.number(), 0.1);
    return data;
  }
  auto data = vtkSmartPointer<vtkRectilinearGrid>::New();
  data->SetDimensions(dimensions);
  vtkSmartPointer<vtkDataArray> axes[3];
  for (int k = 0; k < 3; ++k)
  {
    axes[k] = drawDataArray(bytes, 1, dimensions[k]);
    for (vtkIdType i = 0; i < dimensions[k]; ++i)
    {
      setComponent(axes[k], i, 0, static_cast<double>(i) + 0.1 * bytes.below(4));
    }
  }
  data->SetXCoordinates(axes[0]);
  data->SetYCoordinates(axes[1]);
  data->SetZCoordinates(axes[2]);
  return data;
}

/// Arrays of right and of wrong lengths, ghosts among them, some of them active.
void drawPointData(Bytes& bytes, vtkDataSet* data)
{
  vtkPointData* pointData = data->GetPointData();
  const vtkIdType points = data->GetNumberOfPoints();
  for (int n = bytes.below(4); n > 0; --n)
  {
    const int wrong = bytes.oneOf(8) ? bytes.raw<std::int8_t>() : 0;
    const vtkIdType tuples = std::max<vtkIdType>(0, points + wrong);
    if (bytes.oneOf(4))
    {
      vtkNew<vtkUnsignedCharArray> ghosts;
      ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
      for (vtkIdType i = 0; i < tuples; ++i)
      {
        ghosts->InsertNextValue(static_cast<unsigned char>(bytes.byte() & 3));
      }
      pointData->AddArray(ghosts);
      continue;
    }
    const auto array = drawAnyArray(bytes, tuples);
    array->SetName(drawArrayName(bytes));
    const int index = pointData->AddArray(array);
    if (bytes.oneOf(3))
    {
      pointData->SetActiveAttribute(index, bytes.below(vtkDataSetAttributes::NUM_ATTRIBUTES));
    }
  }
}

vtkSmartPointer<vtkDataObject> drawLeaf(Bytes& bytes, int most)
{
  vtkSmartPointer<vtkDataObject> leaf;
  const int kind = bytes.below(16);
  switch (kind)
  {
    case 8:
    case 9:
    case 10:
      leaf = drawOtherPoints(bytes, kind - 8, most);
      break;
    case 11:
    case 12:
      leaf = drawImplicitPoints(bytes, kind == 11);
      break;
    case 13:
      return vtkSmartPointer<vtkTable>::New();
    case 5:
    case 6:
    case 7:
    case 14:
      leaf = drawSurfaceData(bytes, most);
      break;
    default:
      leaf = drawPolyData(bytes, most);
      break;
  }
  drawPointData(bytes, vtkDataSet::SafeDownCast(leaf));
  if (bytes.oneOf(4))
  {
    const auto array = drawAnyArray(bytes, 1);
    array->SetName(bytes.flag() ? "FlipFlopDimension" : "field");
    leaf->GetFieldData()->AddArray(array);
  }
  return leaf;
}

/// Many small blocks, of which some are at fault: with a NaN, or of a wrong type.
vtkSmartPointer<vtkMultiBlockDataSet> drawFaultyBlocks(Bytes& bytes)
{
  constexpr int MostPointsOfBlock = 40;
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  const int count = 2 + bytes.below(19);
  for (int i = 0; i < count; ++i)
  {
    vtkSmartPointer<vtkDataObject> block = drawPolyData(bytes, MostPointsOfBlock);
    vtkPoints* points = vtkPointSet::SafeDownCast(block)->GetPoints();
    const int fault = bytes.below(8);
    if (fault == 0)
    {
      block = vtkSmartPointer<vtkTable>::New();
    }
    else if (fault <= 2 && points && points->GetNumberOfPoints() > 0)
    {
      points->SetPoint(bytes.below(static_cast<int>(points->GetNumberOfPoints())),
        std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
    }
    blocks->SetBlock(static_cast<unsigned int>(i), block);
  }
  return blocks;
}

/// @param depth composites that may still be nested
vtkSmartPointer<vtkDataObject> drawTree(Bytes& bytes, int most, int depth)
{
  const int kind = depth > 0 ? bytes.below(9) : 0;
  if (kind < 5)
  {
    return drawLeaf(bytes, most);
  }
  if (kind == 8)
  {
    return drawFaultyBlocks(bytes);
  }
  const auto count = static_cast<unsigned int>(bytes.below(4));
  if (kind == 5)
  {
    auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    blocks->SetNumberOfBlocks(count);
    for (unsigned int i = 0; i < count; ++i)
    {
      blocks->SetBlock(i, bytes.oneOf(4) ? nullptr : drawTree(bytes, most, depth - 1));
    }
    return blocks;
  }
  if (kind == 6)
  {
    auto partitions = vtkSmartPointer<vtkPartitionedDataSet>::New();
    partitions->SetNumberOfPartitions(count);
    for (unsigned int i = 0; i < count; ++i)
    {
      partitions->SetPartition(i, bytes.oneOf(4) ? nullptr : drawLeaf(bytes, most));
    }
    return partitions;
  }
  auto collection = vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
  collection->SetNumberOfPartitionedDataSets(count);
  for (unsigned int i = 0; i < count; ++i)
  {
    for (unsigned int k = 0, parts = static_cast<unsigned int>(bytes.below(3)); k < parts; ++k)
    {
      collection->SetPartition(i, k, bytes.oneOf(4) ? nullptr : drawLeaf(bytes, most));
    }
  }
  return collection;
}

}

vtkSmartPointer<vtkDataObject> drawDataObject(Bytes& bytes, int most)
{
  return drawTree(bytes, most, 2);
}

const char* drawArrayName(Bytes& bytes)
{
  static const char* const names[] = { "weights", "weights", "weights", "other", "",
    "vtkOriginalPointIds", "OriginalPointIds", nullptr, "Normals", "BlockIndex", "None" };
  return names[bytes.below(11)];
}

}
}
