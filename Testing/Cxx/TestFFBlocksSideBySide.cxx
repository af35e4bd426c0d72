// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Composites of hundreds of small blocks, whose runs are side by side where there are threads: what
// users see is what they would see of one after another.
#include "FFTest.h"

#include "vtkAlgorithm.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFFHullFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <limits>
#include <string>
#include <vector>

using namespace fftest;

namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

vtkSmartPointer<vtkPolyData> weighted(int count, unsigned int seed, int type = VTK_DOUBLE)
{
  std::vector<double> weights;
  for (int i = 0; i < count; ++i)
  {
    weights.push_back(0.01 * (i % 5));
  }
  return makeWeighted(randomPoints(count, seed), weights, type);
}

/// Of many kinds, null and empty ones among them. Some are too large to be run beside others.
vtkSmartPointer<vtkPolyData> makeBlock(unsigned int k)
{
  if (k % 97 == 50)
  {
    return weighted(9000, k);
  }
  switch (k % 12)
  {
    case 3:
      return nullptr;
    case 5:
      return vtkSmartPointer<vtkPolyData>::New();
    case 7:
      return makeWeighted(cubeCorners(), std::vector<double>(8, 1.0));
    case 8:
      return makeWeighted(std::vector<Point>(4, Point{ 1.0, 2.0, 3.0 }), { 0.0, 1.0, 2.0, 3.0 });
    case 9:
      return weighted(10, k, VTK_FLOAT);
    case 10:
    {
      auto block = weighted(12, k);
      vtkNew<vtkUnsignedCharArray> ghosts;
      ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
      for (int i = 0; i < 12; ++i)
      {
        ghosts->InsertNextValue(i % 3 == 0 ? vtkDataSetAttributes::DUPLICATEPOINT : 0);
      }
      block->GetPointData()->AddArray(ghosts);
      return block;
    }
    default:
      return weighted(1 + static_cast<int>(k * k % 61), k);
  }
}

/// Block k has the flat index k + 1.
vtkSmartPointer<vtkMultiBlockDataSet> makeBlocks(unsigned int count)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetNumberOfBlocks(count);
  for (unsigned int k = 0; k < count; ++k)
  {
    blocks->SetBlock(k, makeBlock(k));
  }
  return blocks;
}

vtkSmartPointer<vtkPolyData> notFinite()
{
  auto block = weighted(20, 1);
  block->GetPoints()->SetPoint(4, 0.0, infinity, 0.0);
  block->GetPoints()->SetPoint(7, 0.0, infinity, 0.0);
  return block;
}

/// What is noticed before the engine runs.
vtkSmartPointer<vtkPolyData> notExact()
{
  vtkNew<vtkTypeInt64Array> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(5);
  coordinates->Fill(0.0);
  coordinates->SetValue(6, (vtkTypeInt64(1) << 53) + 1);
  const auto block = makePoints(coordinates);
  vtkNew<vtkDoubleArray> weights;
  weights->SetName("weights");
  weights->SetNumberOfTuples(5);
  weights->Fill(0.0);
  block->GetPointData()->AddArray(weights);
  return block;
}

void choose(vtkFFHullFilter*) {}

void choose(vtkFFRegularTriangulationFilter* filter)
{
  useWeights(filter);
}

std::vector<double> reportOf(vtkFFAlgorithm* ran)
{
  std::vector<double> report;
  for (const vtkIdType count : { ran->GetNumberOfInputPoints(), ran->GetNumberOfNonFinitePoints(),
         ran->GetNumberOfCulledPoints(), ran->GetNumberOfInsertions(), ran->GetNumberOfFlips22(),
         ran->GetNumberOfFlips31(), ran->GetNumberOfFlipsByVolume(),
         ran->GetNumberOfFlipsByDegree(), ran->GetNumberOfLabelledVertices(),
         ran->GetNumberOfEdgeChecks(), ran->GetNumberOfExactPredicates() })
  {
    report.push_back(static_cast<double>(count));
  }
  if (auto* hull = vtkFFHullFilter::SafeDownCast(ran))
  {
    report.push_back(hull->GetVolume());
    report.push_back(hull->GetArea());
  }
  if (auto* triangulation = vtkFFRegularTriangulationFilter::SafeDownCast(ran))
  {
    report.push_back(static_cast<double>(triangulation->GetNumberOfHiddenPoints()));
  }
  return report;
}

/// Outputs and sums are those of each block alone.
template <class FilterT>
void testResults()
{
  const unsigned int count = 300;
  const auto blocks = makeBlocks(count);
  std::vector<vtkSmartPointer<FilterT>> alone(count);
  std::vector<double> sums;
  for (unsigned int k = 0; k < count; ++k)
  {
    if (!blocks->GetBlock(k))
    {
      continue;
    }
    alone[k] = vtkSmartPointer<FilterT>::New();
    choose(alone[k]);
    alone[k]->SetNumberOfThreads(1);
    alone[k]->ReportAsFieldDataOn();
    alone[k]->SetInputDataObject(blocks->GetBlock(k));
    alone[k]->Update();
    const auto report = reportOf(alone[k]);
    sums.resize(report.size());
    for (std::size_t i = 0; i < report.size(); ++i)
    {
      sums[i] += report[i];
    }
  }

  for (const int threads : { 1, 2, 4 })
  {
    vtkNew<FilterT> filter;
    choose(filter);
    const auto errors = ErrorObserver::Of(filter);
    vtkNew<ProgressObserver> progress;
    filter->AddObserver(vtkCommand::ProgressEvent, progress);
    filter->SetNumberOfThreads(threads);
    filter->ReportAsFieldDataOn();
    filter->SetInputData(blocks);
    filter->Update();
    FF_CHECK(errors->Messages.empty());
    checkProgress(progress->Values);
    FF_CHECK(progress->Values.size() > 2 * count); // each block tells of its own stages
    FF_CHECK(reportOf(filter) == sums);
    for (unsigned int k = 0; k < count; ++k)
    {
      for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
      {
        auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(port));
        FF_CHECK(isIdentical(output->GetBlock(k),
          alone[k] ? alone[k]->GetOutputDataObject(port) : nullptr, "block " + std::to_string(k)));
      }
    }
  }
}

/// Of several blocks that are at fault, the first one is described, whatever is noticed first.
template <class FilterT>
void testFailures()
{
  struct Case
  {
    vtkSmartPointer<vtkPolyData> First;
    vtkSmartPointer<vtkPolyData> Second;
    std::string Part;
  };
  const std::vector<Case> cases{
    { notFinite(), notExact(), "first at point 4 of the block of flat index 91, 2 such" },
    { notExact(), notFinite(), "first at point 2 of the block of flat index 91" },
    { notFinite(), notFinite(), "first at point 4 of the block of flat index 91, 2 such" },
  };
  for (const Case& bad : cases)
  {
    const auto blocks = makeBlocks(130);
    blocks->SetBlock(90, bad.First);
    blocks->SetBlock(100, bad.Second);
    for (const int threads : { 1, 2, 4 })
    {
      vtkNew<FilterT> filter;
      choose(filter);
      const auto errors = ErrorObserver::Of(filter);
      filter->SetNumberOfThreads(threads);
      filter->SetInputData(blocks);
      filter->Update();
      FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
      FF_CHECK(errors->Has(bad.Part));
      FF_CHECK(errors->Has(" The blocks of flat indices 91 and 101 have no results; "));
      FF_CHECK(filter->GetErrorCode() != vtkErrorCode::NoError);

      // The filter is as good as new.
      errors->Clear();
      filter->SetInputData(makeBlocks(20));
      filter->Update();
      FF_CHECK(errors->Messages.empty() && filter->GetNumberOfInputPoints() > 0);
    }
  }
}

/// Weights are judged in their block's turn, too.
void testMissingWeights()
{
  const auto blocks = makeBlocks(130);
  blocks->SetBlock(90, makePoints(cubeCorners()));
  blocks->SetBlock(100, notFinite());
  blocks->SetBlock(80, nullptr);
  for (const int threads : { 1, 2, 4 })
  {
    vtkNew<vtkFFRegularTriangulationFilter> filter;
    useWeights(filter);
    const auto errors = ErrorObserver::Of(filter);
    filter->SetNumberOfThreads(threads);
    filter->SetInputData(blocks);
    filter->Update();
    FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
    FF_CHECK(errors->Has("\"weights\" of the block of flat index 91 is missing"));
    FF_CHECK(errors->Has(" The blocks of flat indices 91 and 101 have no results; "));
  }
}

/// Asks the filter to stop when it tells of its progress for the n-th time.
class AbortObserver : public vtkCommand
{
public:
  static AbortObserver* New() { return new AbortObserver; }
  vtkTypeMacro(AbortObserver, vtkCommand);

  void Execute(vtkObject* caller, unsigned long, void*) override
  {
    if (++this->Told == this->AbortAt)
    {
      vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
    }
  }

  int Told = 0;
  int AbortAt = 0;
};

/// At every poll, an abort leaves nothing, and is no error.
template <class FilterT>
void testAborts()
{
  const auto blocks = makeBlocks(48);
  for (const int threads : { 1, 4 })
  {
    vtkNew<FilterT> filter;
    choose(filter);
    const auto errors = ErrorObserver::Of(filter);
    vtkNew<AbortObserver> observer;
    filter->AddObserver(vtkCommand::ProgressEvent, observer);
    filter->SetNumberOfThreads(threads);
    filter->SetInputData(blocks);
    // From within a run on: before, the pipeline itself tells of progress in some versions.
    int polls = 0;
    for (int at = 2;; ++at)
    {
      observer->Told = 0;
      observer->AbortAt = at;
      filter->SetAbortExecute(0);
      filter->Modified();
      filter->Update();
      if (observer->Told < at || filter->GetNumberOfInputPoints() > 0)
      {
        break; // it came to its end
      }
      ++polls;
      FF_CHECK(observer->Told <= at + 1); // the executive's last word may come after
      FF_CHECK(errors->Messages.empty());
      FF_CHECK_EQUAL(filter->GetErrorCode(), vtkErrorCode::NoError);
      FF_CHECK(hasForgotten(filter));
    }
    FF_CHECK(polls > 100);
    observer->AbortAt = 0; // on threads, how often a run tells of its progress varies
    filter->SetAbortExecute(0);
    filter->Modified();
    filter->Update();
    FF_CHECK(errors->Messages.empty() && filter->GetNumberOfInputPoints() > 0);
  }
}

template <class FilterT>
void testAll()
{
  testResults<FilterT>();
  testFailures<FilterT>();
  testAborts<FilterT>();
}

}

int TestFFBlocksSideBySide(int, char*[])
{
  testAll<vtkFFHullFilter>();
  testAll<vtkFFRegularTriangulationFilter>();
  testMissingWeights();
  return result();
}
