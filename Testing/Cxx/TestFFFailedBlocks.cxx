// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Composites with blocks at fault: these have no result, the others have theirs, and one error of
// bounded length says which.
#include "FFTest.h"

#include "vtkAlgorithm.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkErrorCode.h"
#include "vtkFFConvexifyFilter.h"
#include "vtkFFHullFilter.h"
#include "vtkFFPointInterpolator2D.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkFFSelectEnclosedPoints.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPoints.h"
#include "vtkTable.h"
#include "vtkTypeInt64Array.h"

#include <functional>
#include <limits>
#include <set>
#include <string>
#include <vector>

using namespace fftest;

namespace
{

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

using Filter = vtkSmartPointer<vtkAlgorithm>;

/// Makes a filter, to be given its first input.
using Maker = std::function<Filter()>;

vtkSmartPointer<vtkPolyData> makeBlock(int k)
{
  const int count = 4 + k % 30;
  return makeWeighted(randomPoints(count, static_cast<unsigned int>(k)),
    std::vector<double>(static_cast<std::size_t>(count), 0.01 * (k % 3)));
}

/// With so many points that are not finite, from point 3 on.
vtkSmartPointer<vtkPolyData> makeNotFinite(int count = 1)
{
  const auto block = makeBlock(20);
  for (int i = 0; i < count; ++i)
  {
    block->GetPoints()->SetPoint(3 + i, 0.5, nan, 0.0);
  }
  return block;
}

/// Block k has the flat index k + 1.
vtkSmartPointer<vtkMultiBlockDataSet> makeBlocks(
  int count, const std::function<vtkSmartPointer<vtkPolyData>(int)>& make)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (int k = 0; k < count; ++k)
  {
    blocks->SetBlock(static_cast<unsigned int>(k), make(k));
  }
  return blocks;
}

template <class FilterT>
Maker onThreads(int threads, const std::function<void(FilterT*)>& choose = {})
{
  return [=]
  {
    const auto filter = vtkSmartPointer<FilterT>::New();
    filter->SetNumberOfThreads(threads);
    if (choose)
    {
      choose(filter);
    }
    return Filter(filter);
  };
}

void chooseSurface(vtkFFSelectEnclosedPoints* filter)
{
  filter->SetSurfaceData(makePoints(cubeCorners()));
}

void chooseSource(vtkFFPointInterpolator2D* filter)
{
  filter->SetSourceData(makePoints(cubeCorners()));
}

/// All filters that take blocks of points.
std::vector<Maker> makersOfPoints()
{
  std::vector<Maker> makers;
  for (const int threads : { 1, 2, 4 })
  {
    makers.push_back(onThreads<vtkFFHullFilter>(threads));
    makers.push_back(onThreads<vtkFFRegularTriangulationFilter>(
      threads, [](vtkFFRegularTriangulationFilter* filter) { useWeights(filter); }));
  }
  makers.push_back(onThreads<vtkFFRegularTriangulationFilter>(2,
    [](vtkFFRegularTriangulationFilter* filter)
    {
      useWeights(filter);
      filter->GeneratePowerDiagramOn();
    }));
  makers.push_back(onThreads<vtkFFSelectEnclosedPoints>(2, chooseSurface));
  makers.push_back(onThreads<vtkFFPointInterpolator2D>(2, chooseSource));
  return makers;
}

/// The leaves of the output at the places of the input's blocks, by flat index.
void eachLeaf(vtkDataObjectTree* input, vtkDataObject* output,
  const std::function<void(unsigned int, vtkDataObject*, vtkDataObject*)>& visit)
{
  auto* tree = vtkDataObjectTree::SafeDownCast(output);
  FF_CHECK(tree != nullptr);
  vtkSmartPointer<vtkDataObjectTreeIterator> leaves;
  leaves.TakeReference(input->NewTreeIterator());
  for (leaves->InitTraversal(); tree && !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
  {
    visit(leaves->GetCurrentFlatIndex(), leaves->GetCurrentDataObject(), tree->GetDataSet(leaves));
  }
}

/// The run gives one error, with these parts. Blocks of these flat indices have no result, the
/// others have on each port what they have alone, and what is downstream runs with that.
void checkRun(const Maker& make, vtkMultiBlockDataSet* blocks, const std::set<unsigned int>& bad,
  const std::vector<std::string>& parts)
{
  const Filter filter = make();
  const auto errors = ErrorObserver::Of(filter);
  filter->SetInputDataObject(blocks);
  vtkNew<vtkFFHullFilter> behind;
  behind->SetCompositeModeToAllBlocks();
  behind->SetInputConnection(filter->GetOutputPort());
  const auto errorsBehind = ErrorObserver::Of(behind);
  behind->Update();
  FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
  FF_CHECK_EQUAL(errors->FailedRequests, 0);
  for (const std::string& part : parts)
  {
    if (!errors->Has(part))
    {
      std::cerr << filter->GetClassName() << ": no \"" << part << "\" in "
                << (errors->Messages.empty() ? "no error" : errors->Messages[0]) << "\n";
      ++failures();
    }
  }
  FF_CHECK(filter->GetErrorCode() != vtkErrorCode::NoError);
  FF_CHECK(errorsBehind->Messages.empty());
  FF_CHECK(behind->GetNumberOfInputPoints() > 0);
  vtkIdType points = 0;
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    eachLeaf(blocks, filter->GetOutputDataObject(port),
      [&](unsigned int flatIndex, vtkDataObject* leaf, vtkDataObject* result)
      {
        if (bad.count(flatIndex))
        {
          FF_CHECK(result == nullptr);
          return;
        }
        const Filter alone = make();
        alone->SetInputDataObject(leaf);
        alone->Update();
        FF_CHECK(isIdentical(result, alone->GetOutputDataObject(port),
          std::string(filter->GetClassName()) + ", block " + std::to_string(flatIndex)));
        points += port == 0 ? leaf->GetNumberOfElements(vtkDataObject::POINT) : 0;
      });
  }
  if (auto* ran = vtkFFAlgorithm::SafeDownCast(filter))
  {
    FF_CHECK_EQUAL(ran->GetNumberOfInputPoints(), points);
  }
}

/// One number in one of 199 blocks.
void testOneOfMany()
{
  const auto blocks =
    makeBlocks(199, [](int k) { return k == 90 ? makeNotFinite(2) : makeBlock(k); });
  for (const Maker& make : makersOfPoints())
  {
    checkRun(make, blocks, { 91 },
      { "first at point 3 of the block of flat index 91, 2 such point(s) in all.",
        " The block of flat index 91 has no result; the 198 others have theirs." });
  }
  for (const int threads : { 1, 4 })
  {
    vtkNew<vtkFFHullFilter> hull;
    const auto errors = ErrorObserver::Of(hull);
    hull->SetNumberOfThreads(threads);
    hull->SetInputData(blocks);
    hull->Update();
    FF_CHECK_EQUAL(hull->GetNumberOfNonFinitePoints(), 2);
    FF_CHECK(hull->GetVolume() > 0.0);
  }
}

/// Of several blocks at fault, in different ways, the first is described and all are named.
void testSeveral()
{
  const auto blocks = makeBlocks(130, makeBlock);
  vtkNew<vtkTypeInt64Array> wide;
  wide->SetNumberOfComponents(3);
  wide->SetNumberOfTuples(4);
  wide->Fill(0.0);
  wide->SetValue(4, (vtkTypeInt64(1) << 53) + 1);
  vtkNew<vtkTypeInt64Array> pairs;
  pairs->SetNumberOfComponents(3);
  pairs->SetNumberOfTuples(4);
  const auto flat = makePoints(pairs);
  pairs->SetNumberOfComponents(2);
  vtkNew<vtkImageData> vast;
  vast->SetDimensions(1 << 20, 1 << 20, 2);
  vtkNew<vtkTable> table;
  blocks->SetBlock(10, table);
  blocks->SetBlock(20, flat);
  blocks->SetBlock(30, vast);
  blocks->SetBlock(40, makePoints(wide));
  blocks->SetBlock(50, makeNotFinite());
  blocks->SetBlock(129, makeNotFinite());
  for (const Maker& make : makersOfPoints())
  {
    checkRun(make, blocks, { 11, 21, 31, 41, 51, 130 },
      { "The block of flat index 11 is a vtkTable.",
        " The blocks of flat indices 11, 21, 31, 41, 51 and 130 have no results; the 124 others "
        "have "
        "theirs." });
  }
  // Also before the ones that went well, and in any order.
  checkRun(onThreads<vtkFFHullFilter>(4),
    makeBlocks(40, [](int k) { return k == 0 ? makeNotFinite() : makeBlock(k); }), { 1 },
    { "first at point 3 of the block of flat index 1,", "the 39 others have theirs." });
}

/// The error does not grow with the number of blocks at fault.
void testMany()
{
  std::set<unsigned int> bad;
  const auto blocks = makeBlocks(1000,
    [&](int k)
    {
      if (k % 3 == 0)
      {
        bad.insert(static_cast<unsigned int>(k + 1));
      }
      return k % 3 == 0 ? makeNotFinite() : makeBlock(k);
    });
  vtkNew<vtkFFHullFilter> hull;
  const auto errors = ErrorObserver::Of(hull);
  hull->SetInputData(blocks);
  hull->Update();
  FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
  FF_CHECK(errors->Has(
    " The blocks of flat indices 1, 4, 7, 10, 13, 16, 19, 22 and 326 more have no results; "
    "the 666 others have theirs."));
  FF_CHECK(errors->Messages[0].size() < 600);
  FF_CHECK_EQUAL(hull->GetNumberOfNonFinitePoints(), 334);
}

/// Where no block has a result, the run has failed.
void testAll()
{
  for (const Maker& make : makersOfPoints())
  {
    for (const int count : { 1, 20 })
    {
      const Filter filter = make();
      const auto errors = ErrorObserver::Of(filter);
      filter->SetInputDataObject(makeBlocks(count, [](int) { return makeNotFinite(); }));
      filter->Update();
      FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
      FF_CHECK_EQUAL(errors->FailedRequests, 1);
      FF_CHECK(errors->Has("first at point 3 of the block of flat index 1, 1 such"));
      FF_CHECK(count == 1 || errors->Has(" None of the 20 blocks has a result."));
      for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
      {
        FF_CHECK_EQUAL(filter->GetOutputDataObject(port)->GetNumberOfElements(vtkDataObject::POINT),
          vtkIdType(0));
      }
      if (auto* ran = vtkFFAlgorithm::SafeDownCast(filter))
      {
        FF_CHECK(hasForgotten(ran));
        FF_CHECK_EQUAL(ran->GetNumberOfNonFinitePoints(), vtkIdType(count));
      }
    }
  }
}

void testConvexify()
{
  const auto cube = makeVoxels({ { 0, 0, 0 } });
  const auto open = makeSurface(cubeCorners(), { { 0, 1, 3 } });
  const auto u = makeVoxels({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 0, 1, 0 }, { 2, 1, 0 } });
  vtkNew<vtkMultiBlockDataSet> blocks;
  unsigned int k = 0;
  for (const auto& block : { cube, open, u, makePoints(cubeCorners()), makeNotFinite(), cube })
  {
    blocks->SetBlock(k++, block);
  }
  checkRun(onThreads<vtkFFConvexifyFilter>(2), blocks, { 2, 3, 4, 5 },
    { "The surface is not closed: first at cell 0 of the block of flat index 2",
      " The blocks of flat indices 2, 3, 4 and 5 have no results; the 2 others have theirs." });
}

/// The partitions of a data set are pieces of one block. Of a collection, the other data sets have
/// their results; of questions at points, the other partitions.
void testPartitions()
{
  const auto parts = [](int bad)
  {
    auto set = vtkSmartPointer<vtkPartitionedDataSet>::New();
    for (int k = 0; k < 3; ++k)
    {
      set->SetPartition(static_cast<unsigned int>(k), k == bad ? makeNotFinite() : makeBlock(k));
    }
    return set;
  };
  vtkNew<vtkPartitionedDataSetCollection> collection;
  for (unsigned int k = 0; k < 5; ++k)
  {
    collection->SetPartitionedDataSet(k, parts(k == 3 ? 1 : -1));
  }
  vtkNew<vtkFFHullFilter> hull;
  const auto errors = ErrorObserver::Of(hull);
  hull->SetInputData(collection);
  hull->Update();
  FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
  FF_CHECK_EQUAL(errors->FailedRequests, 0);
  FF_CHECK(errors->Has("first at point 7 of the block of flat index 13, 1 such"));
  FF_CHECK(errors->Has(" The block of flat index 13 has no result; the 4 others have theirs."));
  auto* output = vtkPartitionedDataSetCollection::SafeDownCast(hull->GetOutputDataObject(0));
  FF_CHECK(output && output->GetNumberOfPartitionedDataSets() == 5);
  for (unsigned int k = 0; output && k < 5; ++k)
  {
    FF_CHECK_EQUAL(output->GetPartition(k, 0) == nullptr, k == 3);
  }

  vtkNew<vtkFFSelectEnclosedPoints> select;
  const auto selectErrors = ErrorObserver::Of(select);
  chooseSurface(select);
  select->SetInputData(collection);
  select->Update();
  FF_CHECK_EQUAL(selectErrors->Messages.size(), std::size_t(1));
  FF_CHECK(selectErrors->Has("first at point 3 of the block of flat index 15, 1 such"));
  auto* selected = vtkPartitionedDataSetCollection::SafeDownCast(select->GetOutput());
  FF_CHECK(selected && selected->GetPartition(3, 1) == nullptr);
  FF_CHECK(selected && selected->GetPartition(3, 0) != nullptr);
  FF_CHECK(selected && selected->GetPartition(3, 2) != nullptr);

  // A whole input of that kind is one block, and has no result then.
  errors->Clear();
  hull->SetInputData(parts(2));
  hull->Update();
  FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
  FF_CHECK_EQUAL(errors->FailedRequests, 1);
  FF_CHECK(errors->Has("first at point 12, 1 such point(s) in all."));
  FF_CHECK(!errors->Has("no result"));
  FF_CHECK(hasForgotten(hull));
}

/// What all blocks share is at fault for all of them.
void testShared()
{
  const auto blocks = makeBlocks(5, [](int k) { return k == 2 ? makeNotFinite() : makeBlock(k); });
  vtkNew<vtkFFHullFilter> hull;
  const auto errors = ErrorObserver::Of(hull);
  hull->SetCompositeModeToAllBlocks();
  hull->SetInputData(blocks);
  hull->Update();
  FF_CHECK_EQUAL(errors->FailedRequests, 1);
  FF_CHECK(errors->Has("first at point 3 of the block of flat index 3"));
  FF_CHECK(hasForgotten(hull));

  vtkNew<vtkFFSelectEnclosedPoints> select;
  const auto selectErrors = ErrorObserver::Of(select);
  select->SetInputData(makeBlocks(3, makeBlock));
  select->SetSurfaceData(blocks);
  select->Update();
  FF_CHECK_EQUAL(selectErrors->FailedRequests, 1);
  FF_CHECK(selectErrors->Has("first at point 3 of the block of flat index 3 of the surface"));
  FF_CHECK_EQUAL(select->GetOutput()->GetNumberOfElements(vtkDataObject::POINT), vtkIdType(0));
}

/// An abort after a block at fault leaves nothing, and is no error.
void testAbort()
{
  const auto blocks = makeBlocks(40, [](int k) { return k == 1 ? makeNotFinite() : makeBlock(k); });
  for (const Maker& make : makersOfPoints())
  {
    const Filter filter = make();
    const auto errors = ErrorObserver::Of(filter);
    vtkNew<ProgressObserver> progress;
    progress->AbortAt = 0.8;
    filter->AddObserver(vtkCommand::ProgressEvent, progress);
    filter->SetInputDataObject(blocks);
    filter->Update();
    FF_CHECK(errors->Messages.empty());
    FF_CHECK_EQUAL(errors->FailedRequests, 0);
    FF_CHECK_EQUAL(filter->GetErrorCode(), vtkErrorCode::NoError);
    FF_CHECK_EQUAL(
      filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT), vtkIdType(0));
  }
}

}

int TestFFFailedBlocks(int, char*[])
{
  testOneOfMany();
  testSeveral();
  testMany();
  testAll();
  testConvexify();
  testPartitions();
  testShared();
  testAbort();
  return result();
}
