// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// What is wrong on one process, or with the settings of all, is one error.
#include "Twins.h"

#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFFConstrainedDelaunayFilter.h"
#include "vtkFFPowerDiagramFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPFFDelaunayFilter.h"
#include "vtkPFFPowerDiagramFilter.h"
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
  using Diagram = vtkFFPowerDiagramFilter;
  Twins diagrams = twins<vtkPFFPowerDiagramFilter, Diagram>();
  diagrams.Set<Diagram>([](Diagram* filter) { filter->SetPowerDiagramBounds(1, 0, 0, 1); });
  diagrams.Run("no box", makePieces());
  FF_CHECK(diagrams.Distributed->GetErrorCode() != vtkErrorCode::NoError);
  diagrams.Set<Diagram>([](Diagram* filter) { filter->SetPowerDiagramBounds(0, 1, 0, 1); });
  diagrams.Run("a box", makePieces());
  FF_CHECK_EQUAL(diagrams.Distributed->GetErrorCode(), vtkErrorCode::NoError);

  // Several processes have no CUDA engine, whatever the machine has.
  Twins cuda = triangulations();
  cuda.Distributed->SetEngineToCUDA();
  if (processes() > 1)
  {
    cuda.Fails("CUDA", makePieces()[static_cast<std::size_t>(rank())],
      "The CUDA engine was asked for, but several processes triangulate together on their CPUs. "
      "Set Engine to Automatic or CPU.");
    // No process has all cells.
    Twins boundary = triangulations();
    boundary.Set<Filter>([](Filter* filter) { filter->GenerateBoundaryOn(); });
    boundary.Fails("boundary", makePieces()[static_cast<std::size_t>(rank())],
      "Several processes triangulate together, and none has all cells: Alpha Lines, Alpha Verts, "
      "Generate Alphas and Generate Boundary must be off. To have them, bring all points to one "
      "process.");
    // Nor all points.
    Twins constrained = twins<vtkPFFDelaunayFilter, vtkFFConstrainedDelaunayFilter>();
    vtkNew<vtkPolyData> source;
    vtkFFConstrainedDelaunayFilter::SafeDownCast(constrained.Distributed)->SetSourceData(source);
    constrained.Fails("constraints", makePieces()[static_cast<std::size_t>(rank())],
      "Constraints need all points on one process, and several triangulate together. Bring all "
      "points to one process, or take the source away.");
  }
}

/// Whoever asks to abort, at whatever time.
void testAbort()
{
  if (processes() == 1) // one alone is its superclass
  {
    return;
  }
  Twins both = triangulations();
  const Pieces pieces = makePieces();
  const auto own = static_cast<std::size_t>(rank());
  for (const int process : { 0, 1, 4 })
  {
    for (const double mark : { 0.0, 0.5, 0.9 })
    {
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

/// Progress goes from 0 to 1 on every process, and never back.
void testProgress()
{
  Twins both = triangulations();
  vtkNew<ProgressObserver> progress;
  both.Distributed->AddObserver(vtkCommand::ProgressEvent, progress);
  both.Run("progress", makePieces());
  checkProgress(progress->Values);
  progress->Values.clear();
  both.Run("progress of blocks", std::vector<Pieces>(4, makePieces()));
  checkProgress(progress->Values);
}

/// On one process no data set, no input at all, or another number of blocks: the others do not
/// wait.
void testWrongInput()
{
  if (processes() == 1) // for the executive to say
  {
    return;
  }
  const Pieces pieces = makePieces();
  vtkNew<vtkTable> table;
  const auto blocks = pieceOfBlocks(std::vector<Pieces>(4, pieces));
  for (const bool composite : { false, true })
  {
    vtkDataObject* piece = pieces[static_cast<std::size_t>(rank())];
    piece = composite ? blocks.Get() : piece;
    for (int process = 0; process < processes(); ++process)
    {
      for (const auto& filter :
        { vtkSmartPointer<vtkFFAlgorithm>(vtkNew<vtkPFFRegularTriangulationFilter>()),
          vtkSmartPointer<vtkFFAlgorithm>(vtkNew<vtkPFFDelaunayFilter>()),
          vtkSmartPointer<vtkFFAlgorithm>(vtkNew<vtkPFFPowerDiagramFilter>()) })
      {
        Twins both(filter, vtkNew<Filter>());
        const bool wrong = rank() == process;
        both.Fails("a wrong input", wrong ? table.Get() : piece, "The data is a vtkTable");
        both.Fails("no input", wrong ? nullptr : piece, "There is no input");
        vtkDataObject* other = pieces[0];
        other = composite ? other : blocks.Get();
        both.Fails("other blocks", wrong ? other : piece, "different numbers of blocks");
        vtkNew<ErrorObserver> warnings; // of a diagram
        filter->AddObserver(vtkCommand::WarningEvent, warnings);
        filter->SetInputDataObject(piece);
        filter->Modified();
        filter->Update();
        FF_CHECK_EQUAL(filter->GetErrorCode(), vtkErrorCode::NoError);
      }
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
  const auto whole = appendBlocks(leaves);
  vtkNew<vtkTable> table;
  whole->SetBlock(2, table);
  if (rank() == processes() - 1)
  {
    piece->SetBlock(2, table);
  }
  both.Run("a wrong block", piece, whole);
  FF_CHECK(rank() > 0 || both.Errors->Has(" of data set 3 of the composite is a vtkTable"));
  both.Run("after a wrong block", leaves);

  // In a block: the message names it.
  leaves[2].back()->GetPoints()->SetPoint(3, nan, 0.0, 0.0);
  both.Run("NaN in a block", leaves);
  FF_CHECK(rank() > 0 || both.Errors->Has("of data set 2 of the composite"));
}

}

void testTriangulationErrors()
{
  testNumbers();
  testWeights();
  testSettings();
  testAbort();
  testProgress();
  testWrongBlock();
  testWrongInput();
}
