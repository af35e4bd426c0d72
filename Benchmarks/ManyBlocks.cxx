// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The hulls of very many small blocks in one run of vtkFFHullFilter.
#include "Problems.h"

#include "vtkDoubleArray.h"
#include "vtkFFHullFilter.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace flipflop
{
namespace
{

class FilterOnBlocks final : public Program
{
public:
  explicit FilterOnBlocks(const Settings& settings)
    : settings(settings)
  {
  }
  void prepare(const Input& input) override
  {
    const int each = std::max(1, this->settings.parts);
    this->count = static_cast<unsigned int>(input.count() / each);
    this->blocks->SetNumberOfBlocks(this->count);
    for (unsigned int block = 0; block < this->count; ++block)
    {
      vtkNew<vtkDoubleArray> array;
      array->SetNumberOfComponents(3);
      array->SetNumberOfTuples(each);
      std::copy_n(
        input.xyz.data() + 3 * std::int64_t(block) * each, 3 * each, array->GetPointer(0));
      vtkNew<vtkPoints> points;
      points->SetData(array);
      vtkNew<vtkPolyData> data;
      data->SetPoints(points);
      this->blocks->SetBlock(block, data);
    }
    this->hull->SetNumberOfThreads(this->settings.threads);
    this->hull->SetInputData(this->blocks);
  }
  void run() override { this->hull->Update(); }
  Metrics metrics() const override
  {
    auto* const output = vtkMultiBlockDataSet::SafeDownCast(this->hull->GetOutputDataObject(0));
    vtkIdType vertices = 0;
    for (unsigned int block = 0; block < this->count; ++block)
    {
      auto* const data = vtkPolyData::SafeDownCast(output->GetBlock(block));
      vertices += data ? data->GetNumberOfPoints() : 0;
    }
    return { { "vertices", static_cast<double>(vertices) } };
  }

private:
  Settings settings;
  unsigned int count = 0;
  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<vtkFFHullFilter> hull;
};

}

std::vector<ProgramKind> filterManyHullsPrograms()
{
  return { ProgramKind::ours("flipflop-filter",
    [](const Settings& settings) { return std::make_unique<FilterOnBlocks>(settings); }) };
}

}
