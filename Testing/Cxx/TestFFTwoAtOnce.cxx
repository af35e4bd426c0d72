// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Two filters with one input are updated by two threads at once, and give what one gives alone. VTK
// has no threads of its own here: ThreadSanitizer does not know oneTBB (Scripts/nightly.sh).
#include "FFTest.h"

#include "vtkFFHullFilter.h"
#include "vtkFFPointsToImage.h"
#include "vtkFFPowerDiagramFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"

#include <thread>
#include <vector>

using namespace fftest;

namespace
{

using Filters = std::vector<vtkSmartPointer<vtkAlgorithm>>;

/// One of each kind, on data that shares all with what was given.
Filters filtersOf(vtkDataObject* data)
{
  Filters filters{ vtkSmartPointer<vtkFFHullFilter>::New(),
    vtkSmartPointer<vtkFFRegularTriangulationFilter>::New(),
    vtkSmartPointer<vtkFFPowerDiagramFilter>::New(), vtkSmartPointer<vtkFFPointsToImage>::New() };
  for (const auto& filter : filters)
  {
    vtkSmartPointer<vtkDataObject> own;
    own.TakeReference(data->NewInstance());
    own->ShallowCopy(data);
    filter->SetInputDataObject(own);
  }
  return filters;
}

void testPairs(vtkDataObject* data)
{
  const Filters alone = filtersOf(data);
  for (const auto& filter : alone)
  {
    filter->Update();
  }
  for (std::size_t i = 0; i < 2 * alone.size(); ++i)
  {
    const std::size_t first = i / 2;
    const std::size_t second = (first + i % 2) % alone.size(); // its own kind, then the next
    const Filters one = filtersOf(data);
    const Filters other = filtersOf(data);
    std::thread thread([&] { other[second]->Update(); });
    one[first]->Update();
    thread.join();
    FF_CHECK(isIdentical(
      one[first]->GetOutputDataObject(0), alone[first]->GetOutputDataObject(0), "the one"));
    FF_CHECK(isIdentical(
      other[second]->GetOutputDataObject(0), alone[second]->GetOutputDataObject(0), "the other"));
  }
}

}

int TestFFTwoAtOnce(int, char*[])
{
  const std::string backend = vtkSMPTools::GetBackend();
  vtkSMPTools::SetBackend("Sequential");
  const auto cloud = makePoints(randomPoints(20000, 1));
  cloud->GetBounds(); // which VTK keeps with the points
  testPairs(cloud);
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int i = 0; i < 300; ++i)
  {
    const auto block = makePoints(randomPoints(50, i));
    block->GetBounds();
    blocks->SetBlock(i, block);
  }
  testPairs(blocks);
  vtkSMPTools::SetBackend(backend.c_str());
  return failures();
}
