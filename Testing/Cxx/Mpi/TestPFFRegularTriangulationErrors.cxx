// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// What is wrong on one process, or with the settings of all, is one error.
#include "Twins.h"

#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPFFRegularTriangulationFilter.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTable.h"

#include <algorithm>
#include <limits>

using namespace fftest;

namespace
{

using Filter = vtkFFRegularTriangulationFilter;

const double nan = std::numeric_limits<double>::quiet_NaN();

Twins triangulations()
{
  Twins both = twins<vtkPFFRegularTriangulationFilter, Filter>();
  both.Set<Filter>([](Filter* filter) { useWeights(filter); });
  return both;
}

Pieces makePieces()
{
  Pieces pieces = split(randomPoints(500, 111), [](int i) { return i % processes(); });
  decorate(pieces);
  for (vtkPolyData* piece : pieces)
  {
    vtkNew<vtkDoubleArray> weights;
    weights->SetName("weights");
    weights->SetNumberOfTuples(piece->GetNumberOfPoints());
    weights->Fill(0.0);
    piece->GetPointData()->AddArray(weights);
  }
  return pieces;
}

/// Fails on all, and does its work the next time.
void refuses(Twins& both, const std::string& what, const Pieces& pieces, const std::string& part)
{
  both.Run(what, pieces);
  FF_CHECK(both.Distributed->GetErrorCode() != vtkErrorCode::NoError);
  FF_CHECK(rank() > 0 || both.Errors->Has(part));
  both.Run("after " + what, makePieces());
  FF_CHECK_EQUAL(both.Distributed->GetErrorCode(), vtkErrorCode::NoError);
}

void testNumbers()
{
  Twins both = triangulations();
  const auto last = static_cast<std::size_t>(processes() - 1);
  const auto place = std::to_string(
    append(makePieces())->GetNumberOfPoints() - makePieces()[last]->GetNumberOfPoints() + 11);

  Pieces pieces = makePieces();
  pieces[last]->GetPoints()->SetPoint(11, 0.0, nan, 0.0);
  refuses(both, "NaN on the last", pieces, "point " + place + ", 1 such");
  both.Set<Filter>([](Filter* filter) { filter->SetNonFinitePointsToIgnore(); });
  both.Run("NaN ignored", pieces);
  both.Set<Filter>([](Filter* filter) { filter->SetNonFinitePointsToError(); });

  pieces = makePieces();
  pieces[last]->GetPointData()->GetArray("weights")->SetTuple1(11, nan);
  refuses(both, "a weight that is NaN", pieces, "point " + place + ", 1 such");
}

void testWeights()
{
  Twins both = triangulations();
  Pieces pieces = makePieces();
  for (vtkPolyData* piece : pieces)
  {
    piece->GetPointData()->RemoveArray("weights");
  }
  refuses(both, "weights missing on all", pieces, "missing from the input's point data");
  pieces = makePieces();
  pieces.back()->GetPointData()->RemoveArray("weights");
  refuses(both, "weights missing on one", pieces, "missing from the input's point data");

  // Only one process has points, so that none are appended.
  const auto points = randomPoints(50, 112);
  for (const int owner : { 0, processes() - 1 })
  {
    for (const vtkIdType count : { 49, 51 })
    {
      pieces = split(points, [=](int) { return owner; });
      vtkNew<vtkDoubleArray> weights;
      weights->SetName("weights");
      weights->SetNumberOfTuples(count);
      weights->Fill(0.0);
      pieces[static_cast<std::size_t>(owner)]->GetPointData()->AddArray(weights);
      refuses(both, "weights of another number", pieces,
        "has " + std::to_string(count) + " value(s) for 50 point(s)");
    }
  }
}

/// One process speaks for all, though all have the same settings.
void testSettings()
{
  Twins both = triangulations();
  both.Set<Filter>([](Filter* filter) { filter->SetProjectionPlaneModeToTransform(); });
  both.Run("no transform", makePieces());
  FF_CHECK(both.Distributed->GetErrorCode() != vtkErrorCode::NoError);
  both.Set<Filter>(
    [](Filter* filter)
    {
      filter->SetProjectionPlaneModeToXYPlane();
      filter->GeneratePowerDiagramOn();
      filter->SetPowerDiagramBoxModeToBounds();
      filter->SetPowerDiagramBounds(1, 0, 0, 1);
    });
  both.Run("no box", makePieces());
  FF_CHECK(both.Distributed->GetErrorCode() != vtkErrorCode::NoError);
  both.Set<Filter>([](Filter* filter) { filter->SetPowerDiagramBounds(0, 1, 0, 1); });
  both.Run("a box", makePieces());
  FF_CHECK_EQUAL(both.Distributed->GetErrorCode(), vtkErrorCode::NoError);
}

/// Process 0 at any time, the others before it begins.
void testAbort()
{
  Twins both = triangulations();
  const Pieces pieces = makePieces();
  const auto own = static_cast<std::size_t>(rank());
  for (const int process : { 0, 1, 4 })
  {
    for (const double mark : { 0.0, 0.5 })
    {
      if (process > 0 && mark > 0.0)
      {
        continue;
      }
      vtkNew<ProgressObserver> progress;
      progress->AbortAt = mark;
      const unsigned long tag = rank() == std::min(process, processes() - 1)
        ? both.Distributed->AddObserver(vtkCommand::ProgressEvent, progress)
        : 0;
      both.Fails("an abort", pieces[own], "");
      both.Distributed->RemoveObserver(tag);
      both.Distributed->SetAbortExecute(0); // older VTKs do so at the start of a run
      both.Run("after an abort", pieces);
    }
  }
}

void testWrongBlock()
{
  Twins both = triangulations();
  std::vector<Pieces> leaves(4);
  for (Pieces& leaf : leaves)
  {
    leaf = makePieces();
  }
  const auto piece = pieceOfBlocks(leaves);
  if (rank() == processes() - 1)
  {
    vtkNew<vtkTable> table;
    piece->SetBlock(2, table);
  }
  both.Fails("a wrong block", piece, "flat index 5 is a vtkTable");
  both.Run("after a wrong block", leaves);

  // In a block: the message names it.
  leaves[2].back()->GetPoints()->SetPoint(3, nan, 0.0, 0.0);
  both.Run("NaN in a block", leaves);
  FF_CHECK(rank() > 0 || both.Errors->Has("of the block of flat index 4"));
}

}

void testTriangulationErrors()
{
  testNumbers();
  testWeights();
  testSettings();
  testAbort();
  testWrongBlock();
}
