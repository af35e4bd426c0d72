// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// The filters with a single output give that port of vtkPFFRegularTriangulationFilter, on every
// process, with its report and its errors.
#include "Twins.h"

#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPFFDelaunayFilter.h"
#include "vtkPFFPowerDiagramFilter.h"
#include "vtkPointData.h"

#include <limits>

using namespace fftest;

namespace
{

using Filter = vtkPFFRegularTriangulationFilter;

Pieces makePieces(int count, unsigned int seed)
{
  const Pieces pieces = split(randomPoints(count, seed), [](int i) { return i % processes(); });
  decorate(pieces);
  for (vtkPolyData* piece : pieces)
  {
    std::vector<double> weights;
    for (vtkIdType i = 0; i < piece->GetNumberOfPoints(); ++i)
    {
      weights.push_back(0.004 * static_cast<double>(i * i % 7));
    }
    piece->GetPointData()->AddArray(makeWeighted({}, weights)->GetPointData()->GetArray("weights"));
  }
  return pieces;
}

/// The data, on this process.
std::vector<std::pair<std::string, vtkSmartPointer<vtkDataObject>>> makeInputs()
{
  const auto mine = static_cast<std::size_t>(rank());
  std::vector<Pieces> leaves;
  for (unsigned int leaf = 0; leaf < 4; ++leaf)
  {
    leaves.push_back(makePieces(150, 110 + leaf));
  }
  leaves[2].assign(leaves[2].size(), nullptr);
  const Pieces bad = makePieces(100, 120);
  bad[0]->GetPoints()->SetPoint(3, 0, std::numeric_limits<double>::quiet_NaN(), 0);
  return { { "points", makePieces(600, 101)[mine] }, { "blocks", pieceOfBlocks(leaves) },
    { "a NaN", bad[mine] }, { "one point", makePieces(1, 102)[mine] },
    { "no point", makePieces(0, 103)[mine] }, { "points again", makePieces(300, 104)[mine] } };
}

/// The messages without the class and the address that they begin with.
std::vector<std::string> words(std::vector<std::string> messages)
{
  for (std::string& message : messages)
  {
    message.erase(0, message.find("): "));
  }
  return messages;
}

/// The filter's output is the port's of the whole filter.
void testOutput(Filter* filter, int port)
{
  FF_CHECK_EQUAL(filter->GetNumberOfOutputPorts(), 1);
  FF_CHECK(!filter->GetHiddenPointsOutput());
  FF_CHECK(!filter->GetPowerDiagramOutput());
  vtkNew<Filter> whole;
  whole->SetGeneratePowerDiagram(port == 2);
  const auto errors = ErrorObserver::Of(filter);
  const auto wholeErrors = ErrorObserver::Of(whole);
  for (Filter* either : { filter, whole.Get() })
  {
    either->SetReportAsFieldData(port == 0); // the only port of several that has it
  }
  for (const bool weighted : { false, true })
  {
    for (const auto& input : makeInputs())
    {
      for (Filter* either : { filter, whole.Get() })
      {
        useWeights(either, weighted ? "weights" : "");
        either->SetInputDataObject(input.second);
        either->Update();
      }
      FF_CHECK(isIdentical(filter->GetOutputDataObject(0), whole->GetOutputDataObject(port),
        input.first + (weighted ? ", weights" : "") + ", port " + std::to_string(port) +
          " on process " + std::to_string(rank())));
      FF_CHECK_EQUAL(filter->GetErrorCode(), whole->GetErrorCode());
      FF_CHECK_EQUAL(filter->GetDimension(), whole->GetDimension());
      FF_CHECK_EQUAL(filter->GetNumberOfHiddenPoints(), whole->GetNumberOfHiddenPoints());
      FF_CHECK(words(errors->Messages) == words(wholeErrors->Messages));
      FF_CHECK(input.first != "a NaN" || rank() > 0 || errors->Has("point 3,"));
      errors->Clear();
      wholeErrors->Clear();
    }
  }
}

/// The report is with the diagram, and with that of each block.
void testReport()
{
  const auto mine = static_cast<std::size_t>(rank());
  const Pieces points = makePieces(200, 105);
  const Pieces others = makePieces(100, 106);
  vtkNew<vtkPFFPowerDiagramFilter> filter;
  vtkNew<ErrorObserver> warnings;
  filter->AddObserver(vtkCommand::WarningEvent, warnings);
  filter->ReportAsFieldDataOn();
  filter->SetInputDataObject(points[mine]);
  filter->Update();
  const auto dimension = [](vtkDataObject* data)
  {
    vtkDataArray* array = data->GetFieldData()->GetArray("FlipFlopDimension");
    return array ? array->GetTuple1(0) : -1.0;
  };
  FF_CHECK_EQUAL(dimension(filter->GetOutputDataObject(0)), 2.0);
  filter->SetInputDataObject(pieceOfBlocks({ points, others, others, points }));
  filter->Update();
  vtkDataObject* block =
    vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetBlock(0);
  FF_CHECK_EQUAL(dimension(block), 2.0);
}

}

void testOneOutput()
{
  testOutput(vtkNew<vtkPFFDelaunayFilter>(), 0);
  testOutput(vtkNew<vtkPFFPowerDiagramFilter>(), 2);
  testReport();
}
