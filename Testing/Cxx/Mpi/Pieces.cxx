// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Data in pieces, and as it is whole.
#include "DistributedVersusSerial.h"
#include "FFOutput.h"

#include "vtkBitArray.h"
#include "vtkCharArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkLongLongArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace fftest
{

//------------------------------------------------------------------------------
int byTurns(int i)
{
  return i % processes();
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, Owner>> dealings(std::size_t count)
{
  const int last = processes() - 1;
  const int size = static_cast<int>(count) / processes() + 1;
  return { { "by turns", byTurns }, { "in runs", [=](int i) { return i / size; } },
    { "to the first", [](int) { return 0; } }, { "to the last", [=](int) { return last; } },
    { "not to the first", [=](int i) { return last == 0 ? 0 : 1 + i % last; } },
    { "to first and last", [=](int i) { return i % 3 == 1 ? last : 0; } } };
}

//------------------------------------------------------------------------------
Pieces split(const std::vector<Point>& points, const Owner& owner, int type, int count)
{
  std::vector<std::vector<Point>> parts(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    parts.at(static_cast<std::size_t>(owner(static_cast<int>(i)))).push_back(points[i]);
  }
  Pieces pieces;
  for (const auto& part : parts)
  {
    pieces.push_back(makePoints(part, type));
  }
  return pieces;
}

namespace
{

/// One array for a piece of so many points.
template <class ArrayT>
vtkSmartPointer<ArrayT> makeArray(const char* name, vtkIdType count, int components = 1)
{
  auto array = vtkSmartPointer<ArrayT>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(count);
  return array;
}

void decorate(vtkPolyData* piece, int number)
{
  const vtkIdType count = piece->GetNumberOfPoints();
  const auto scalars = makeArray<vtkDoubleArray>("temperature", count);
  const auto vectors = makeArray<vtkFloatArray>("velocity", count, 3);
  const auto wides = makeArray<vtkIdTypeArray>("wide", count);
  const auto names = makeArray<vtkStringArray>("names", count);
  const auto chars = makeArray<vtkCharArray>("chars", count);
  const auto longs = makeArray<vtkLongLongArray>("longs", count, 2);
  const auto bits = makeArray<vtkBitArray>("bits", count);
  const auto globals = makeArray<vtkIdTypeArray>("global", count);
  vectors->SetComponentName(0, "u");
  vectors->SetComponentName(2, "w");
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double value = 1000.0 * number + 1.0 / (3.0 + static_cast<double>(i));
    scalars->SetValue(i, i % 3 == 1 ? std::numeric_limits<double>::quiet_NaN() : value);
    vectors->SetTuple3(i, value, -value, 0.5);
    wides->SetValue(i, (vtkIdType(number + 1) << 40) + i);
    // Texts of several lines, with every byte in them, and empty ones.
    names->SetValue(i,
      i % 4 == 3 ? std::string() : "<piece>\n" + std::to_string(number) + '\0' + std::to_string(i));
    chars->SetValue(i, static_cast<char>(i % 100 - 50));
    longs->SetTypedComponent(i, 1, (1LL << 60) + 7 * i + number);
    longs->SetTypedComponent(i, 0, -i);
    bits->SetValue(i, (i + number) % 3 == 0);
    globals->SetValue(i, 1000000 * number + i);
  }
  vtkPointData* data = piece->GetPointData();
  data->AddArray(wides);
  data->SetScalars(scalars);
  data->AddArray(names);
  data->SetVectors(vectors);
  data->AddArray(chars);
  data->AddArray(longs);
  data->AddArray(bits);
  data->SetGlobalIds(globals);
}

}

//------------------------------------------------------------------------------
void decorate(const Pieces& pieces)
{
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    decorate(pieces[i], static_cast<int>(i));
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> append(const Pieces& pieces)
{
  std::vector<vtkPointSet*> there;
  std::copy_if(pieces.begin(), pieces.end(), std::back_inserter(there),
    [](vtkPolyData* piece) { return piece != nullptr; });
  return vtkPolyData::SafeDownCast(FFOutput::Append(there));
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkMultiBlockDataSet> makeBlocks(const Pieces& leaves)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  vtkNew<vtkMultiBlockDataSet> nested;
  blocks->SetNumberOfBlocks(3);
  nested->SetNumberOfBlocks(2);
  blocks->SetBlock(0, leaves.at(0));
  nested->SetBlock(0, leaves.at(1));
  nested->SetBlock(1, leaves.at(2));
  blocks->SetBlock(1, nested);
  blocks->SetBlock(2, leaves.at(3));
  return blocks;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkMultiBlockDataSet> appendBlocks(const std::vector<Pieces>& leaves)
{
  Pieces whole;
  for (const Pieces& pieces : leaves)
  {
    Pieces there;
    std::copy_if(pieces.begin(), pieces.end(), std::back_inserter(there),
      [](vtkPolyData* piece) { return piece != nullptr; });
    whole.push_back(there.empty() ? nullptr : append(there));
  }
  return makeBlocks(whole);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkMultiBlockDataSet> pieceOfBlocks(const std::vector<Pieces>& leaves)
{
  Pieces own;
  for (const Pieces& pieces : leaves)
  {
    own.push_back(pieces.at(static_cast<std::size_t>(rank())));
  }
  return makeBlocks(own);
}

}
