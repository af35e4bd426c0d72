// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The hulls of very many small blocks in one run of the filter, by the number of threads.
///
///     many-blocks [blocks = 16000] [points of each = 8]
#include "vtkDoubleArray.h"
#include "vtkFFHullFilter.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

int main(int argc, char** argv)
{
  const int count = argc > 1 ? std::atoi(argv[1]) : 16000;
  const int size = argc > 2 ? std::atoi(argv[2]) : 8;
  if (count < 1 || size < 1)
  {
    std::fprintf(stderr, "usage: %s [blocks, 1 or more] [points of each, 1 or more]\n", argv[0]);
    return EXIT_FAILURE;
  }
  std::mt19937_64 random(1);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetNumberOfBlocks(static_cast<unsigned int>(count));
  for (int block = 0; block < count; ++block)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (int i = 0; i < size; ++i)
    {
      double x[3];
      for (double& coordinate : x)
      {
        coordinate = 0x1p-53 * static_cast<double>(random() >> 11);
      }
      points->InsertNextPoint(x);
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    blocks->SetBlock(static_cast<unsigned int>(block), data);
  }

  std::printf("%d blocks of %d points: seconds in each of five rounds\n", count, size);
  const std::vector<int> threads{ 1, 2, 4, 0 };
  std::vector<std::vector<double>> seconds(threads.size());
  for (int round = 0; round < 5; ++round)
  {
    for (std::size_t k = 0; k < threads.size(); ++k)
    {
      vtkNew<vtkFFHullFilter> hull;
      hull->SetNumberOfThreads(threads[k]);
      hull->SetInputData(blocks);
      const auto begin = std::chrono::steady_clock::now();
      hull->Update();
      const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
      seconds[k].push_back(passed.count());
    }
  }
  for (std::size_t k = 0; k < threads.size(); ++k)
  {
    std::printf(threads[k] ? "%7d thread(s)" : "default threads  ", threads[k]);
    for (const double s : seconds[k])
    {
      std::printf(" %8.4f", s);
    }
    std::sort(seconds[k].begin(), seconds[k].end());
    std::printf("  median %8.4f\n", seconds[k][2]);
  }
  return EXIT_SUCCESS;
}
