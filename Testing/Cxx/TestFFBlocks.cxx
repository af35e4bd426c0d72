// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Composite input of the filters that have no way of their own with it: each block's result is the
// one that it has alone, on every port; errors name the block. (For hulls, see their own test.)
#include "FFTest.h"

#include "vtkErrorCode.h"
#include "vtkFFConvexifyFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStructuredGrid.h"
#include "vtkTable.h"

#include <limits>

using namespace fftest;

namespace
{

/// Leaves of flat indices 1, 3, 5 and 6: one nested beside a missing one (4), and one without
/// points.
vtkSmartPointer<vtkMultiBlockDataSet> makeBlocks(
  vtkDataObject* first, vtkDataObject* nested, vtkDataObject* last)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  vtkNew<vtkMultiBlockDataSet> inner;
  vtkNew<vtkPolyData> empty;
  inner->SetNumberOfBlocks(2);
  inner->SetBlock(0, nested);
  blocks->SetBlock(0, first);
  blocks->SetBlock(1, inner);
  blocks->SetBlock(2, empty);
  blocks->SetBlock(3, last);
  return blocks;
}

/// The leaf of a flat index as makeBlocks() lays them out.
vtkDataObject* leaf(vtkDataObject* composite, int flatIndex)
{
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(composite);
  auto* inner = blocks ? vtkMultiBlockDataSet::SafeDownCast(blocks->GetBlock(1)) : nullptr;
  if (!inner || blocks->GetNumberOfBlocks() != 4 || inner->GetNumberOfBlocks() != 2)
  {
    std::cerr << "the output has another structure\n";
    ++failures();
    return nullptr;
  }
  return flatIndex == 1 ? blocks->GetBlock(0)
    : flatIndex == 3    ? inner->GetBlock(0)
    : flatIndex == 4    ? inner->GetBlock(1)
    : flatIndex == 5    ? blocks->GetBlock(2)
                        : blocks->GetBlock(3);
}

/// Runs the filter for blocks, and for each alone. Adds up with @p sum what it reports of each.
template <class FilterT, class Sum>
void checkBlocks(FilterT* filter, vtkDataObject* blocks, Sum&& sum)
{
  const auto errors = ErrorObserver::Of(filter);
  vtkNew<ProgressObserver> progress;
  const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, progress);
  filter->SetInputDataObject(blocks);
  filter->Update();
  FF_CHECK(errors->Messages.empty());
  checkProgress(progress->Values);
  filter->RemoveObserver(tag);
  std::vector<vtkSmartPointer<vtkDataObject>> outputs;
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    outputs.emplace_back(filter->GetOutputDataObject(port));
    FF_CHECK(leaf(outputs.back(), 4) == nullptr);
  }
  const int dimension = filter->GetDimension();
  const auto whole = sum(filter);

  auto parts = decltype(whole){};
  for (const int flatIndex : { 1, 3, 5, 6 })
  {
    vtkNew<FilterT> alone;
    alone->SetFacetMode(filter->GetFacetMode());
    if (auto* triangulation = vtkFFRegularTriangulationFilter::SafeDownCast(alone))
    {
      useWeights(triangulation);
      triangulation->GeneratePowerDiagramOn();
    }
    alone->SetInputDataObject(leaf(blocks, flatIndex));
    alone->Update();
    for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
    {
      FF_CHECK(isIdentical(leaf(outputs[static_cast<std::size_t>(port)], flatIndex),
        alone->GetOutputDataObject(port), "block " + std::to_string(flatIndex)));
    }
    const auto part = sum(alone.Get());
    for (std::size_t i = 0; i < part.size(); ++i)
    {
      parts[i] += part[i];
    }
    FF_CHECK(alone->GetDimension() <= dimension);
  }
  FF_CHECK(whole == parts);
  FF_CHECK(whole[0] > 0.0 && whole[1] > 0.0);
}

/// Gives one error that has the part, and goes on: TestFFFailedBlocks compares the other blocks.
void refuses(vtkFFAlgorithm* filter, vtkDataObject* input, const std::string& part)
{
  const auto errors = ErrorObserver::Of(filter);
  filter->SetInputDataObject(input);
  filter->Update();
  FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
  FF_CHECK(errors->Has(part));
  FF_CHECK(filter->GetErrorCode() != vtkErrorCode::NoError);
  FF_CHECK_EQUAL(errors->FailedRequests, 0);
  filter->RemoveObserver(errors);
}

vtkSmartPointer<vtkPolyData> weightedPoints(int count)
{
  std::vector<double> weights;
  for (int i = 0; i < count; ++i)
  {
    weights.push_back(0.01 * (i % 5));
  }
  return makeWeighted(randomPoints(count, 63), weights);
}

void testTriangulation()
{
  vtkNew<vtkFFRegularTriangulationFilter> filter;
  useWeights(filter);
  filter->GeneratePowerDiagramOn();
  const auto input = makeBlocks(weightedPoints(3000), weightedPoints(500), weightedPoints(2000));
  for (int mode = 0; mode < 2; ++mode)
  {
    filter->SetFacetMode(mode);
    checkBlocks(filter.Get(), input,
      [](vtkFFRegularTriangulationFilter* ran)
      {
        return std::array<double, 2>{ double(ran->GetNumberOfInputPoints()),
          double(ran->GetNumberOfHiddenPoints()) };
      });
  }

  // An abort after the first block leaves nothing of it either.
  const auto errors = ErrorObserver::Of(filter);
  vtkNew<ProgressObserver> progress;
  progress->AbortAt = 0.7;
  const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, progress);
  filter->Modified();
  filter->Update();
  FF_CHECK(progress->StoppedOnTheWay() && errors->Messages.empty());
  FF_CHECK_EQUAL(filter->GetErrorCode(), vtkErrorCode::NoError);
  FF_CHECK(hasForgotten(filter));
  filter->RemoveObserver(tag);
  filter->RemoveObserver(errors);
  filter->SetAbortExecute(0);

  vtkNew<vtkTable> table;
  refuses(filter, makeBlocks(weightedPoints(9), weightedPoints(9), table),
    "block of flat index 6 is a vtkTable. It must be a vtkPointSet, vtkImageData or "
    "vtkRectilinearGrid.");
  const auto bad = weightedPoints(9);
  bad->GetPoints()->SetPoint(4, 0.0, std::numeric_limits<double>::infinity(), 0.0);
  refuses(filter, makeBlocks(weightedPoints(9), bad, weightedPoints(9)),
    "point 4 of the block of flat index 3");
  refuses(filter, makeBlocks(weightedPoints(9), makePoints(cubeCorners()), weightedPoints(9)),
    "\"weights\" of the block of flat index 3 is missing");
  filter->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  refuses(filter, makeBlocks(nullptr, nullptr, makePoints(cubeCorners())),
    "array of the block of flat index 6, the point data's active Scalars");
}

void testConvexify()
{
  vtkNew<vtkFFConvexifyFilter> convexify;
  const auto corner = makeVoxels({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } });
  const auto cube = makeVoxels({ { 0, 0, 0 } });
  const auto sum = [](vtkFFConvexifyFilter* ran) {
    return std::array<double, 2>{ double(ran->GetNumberOfInputPoints()), ran->GetVolume() };
  };
  const auto input = makeBlocks(corner, cube, corner);
  for (int mode = 0; mode < 2; ++mode)
  {
    convexify->SetFacetMode(mode);
    checkBlocks(convexify.Get(), input, sum);
  }

  // Points are not enough: its cells must be a surface's.
  vtkNew<vtkStructuredGrid> grid;
  refuses(convexify, makeBlocks(cube, grid, cube),
    "block of flat index 3 is a vtkStructuredGrid. It must be a vtkPolyData.");
  const auto edge = makeSurface(cubeCorners(), { { 0, 1 } });
  refuses(convexify, makeBlocks(cube, cube, edge),
    "cell 0 of the block of flat index 6 is a polygon of 2");
  const auto open = makeSurface(cubeCorners(), { { 0, 1, 3 } });
  refuses(convexify, makeBlocks(cube, open, cube), "cell 0 of the block of flat index 3");
  const auto u = makeVoxels({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 0, 1, 0 }, { 2, 1, 0 } });
  refuses(convexify, makeBlocks(cube, cube, u), "surface of the block of flat index 6 is not star");
}

}

int TestFFBlocks(int, char*[])
{
  testTriangulation();
  testConvexify();
  return result();
}
