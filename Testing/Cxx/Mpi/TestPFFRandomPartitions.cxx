// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Few points at few places, dealt out at random: many small ties of every kind.
#include "DistributedVersusSerial.h"

#include "vtkDoubleArray.h"
#include "vtkFFHullFilter.h"
#include "vtkFFPowerDiagramFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkPFFHullFilter.h"
#include "vtkPFFPowerDiagramFilter.h"
#include "vtkPFFRegularTriangulationFilter.h"
#include "vtkPointData.h"

#include <algorithm>
#include <random>

using namespace fftest;

namespace
{

constexpr unsigned int partitions = 300;

/// Everything a case needs, from its seed alone.
Pieces makeCase(unsigned int seed)
{
  std::mt19937_64 generator(seed);
  const auto below = [&](unsigned int end)
  { return static_cast<int>(generator() % static_cast<std::uint64_t>(end)); };
  const unsigned int side = 1 + static_cast<unsigned int>(below(4));
  std::vector<Point> points(static_cast<std::size_t>(below(40)));
  for (Point& p : points)
  {
    // Tenths are rounded: nearly, but not quite in a plane or on a line.
    p = { 0.1 * below(side), 0.1 * below(side), below(3) ? 0.1 * below(side) : 0.0 };
  }
  std::vector<int> owners(points.size());
  const auto end = 1 + static_cast<unsigned int>(below(static_cast<unsigned int>(processes())));
  for (int& owner : owners)
  {
    owner = below(end);
  }
  return split(
    points, [&](int i) { return owners[static_cast<std::size_t>(i)]; },
    below(2) ? VTK_DOUBLE : VTK_FLOAT);
}

void addWeights(const Pieces& pieces, unsigned int seed)
{
  std::mt19937_64 generator(seed);
  for (vtkPolyData* piece : pieces)
  {
    vtkNew<vtkDoubleArray> weights;
    weights->SetName("weights");
    for (vtkIdType i = 0; i < piece->GetNumberOfPoints(); ++i)
    {
      weights->InsertNextValue(0.01 * static_cast<double>(generator() % 3));
    }
    piece->GetPointData()->AddArray(weights);
  }
}

}

void testRandomPartitions()
{
  DistributedVersusSerial hulls = compare<vtkPFFHullFilter, vtkFFHullFilter>();
  DistributedVersusSerial triangulations =
    compare<vtkPFFRegularTriangulationFilter, vtkFFRegularTriangulationFilter>();
  DistributedVersusSerial diagrams = compare<vtkPFFPowerDiagramFilter, vtkFFPowerDiagramFilter>();
  for (DistributedVersusSerial* both : { &triangulations, &diagrams })
  {
    both->Set<vtkFFPlanarAlgorithm>(
      [](vtkFFPlanarAlgorithm* filter)
      {
        useWeights(filter);
        filter->SetNumberOfThreads(1);
      });
  }
  const auto hasPoints = [](vtkPolyData* piece) { return piece->GetNumberOfPoints() > 0; };
  for (unsigned int seed = 1; seed <= partitions; ++seed)
  {
    const Pieces pieces = makeCase(seed);
    addWeights(pieces, seed);
    hulls.Set<vtkFFHullFilter>(
      [&](vtkFFHullFilter* filter)
      {
        filter->SetNumberOfThreads(1);
        filter->SetFacetMode(static_cast<int>(seed % 2));
      });
    hulls.Run("hull of seed " + std::to_string(seed), pieces);
    if (seed % 3 == 0)
    {
      triangulations.Run("triangulation of seed " + std::to_string(seed), pieces);
    }
    else if (std::count_if(pieces.begin(), pieces.end(), hasPoints) > 1)
    {
      // Without a warning, since nothing has to be gathered, one process alone mends broken cells.
      diagrams.Run("power diagram of seed " + std::to_string(seed), pieces);
    }
  }
}
