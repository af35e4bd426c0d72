// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// What is wrong on one process, or with the settings of all, is an error of all, told once, of the
// points as a whole; nobody waits for ever, and the next run is none the worse for it.
#include "DistributedVersusSerial.h"

#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFFErrorCode.h"
#include "vtkFFHullFilter.h"
#include "vtkFFPowerDiagramFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkOverlappingAMR.h"
#include "vtkPFFHullFilter.h"
#include "vtkPFFPowerDiagramFilter.h"
#include "vtkPFFRegularTriangulationFilter.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSocketController.h"
#include "vtkTable.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

using namespace fftest;

namespace
{

const double nan = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

using Triangulation = vtkFFRegularTriangulationFilter;

std::vector<DistributedVersusSerial> makeComparisons()
{
  std::vector<DistributedVersusSerial> all;
  all.push_back(compare<vtkPFFHullFilter, vtkFFHullFilter>());
  all.push_back(compare<vtkPFFHullFilter, vtkFFHullFilter>());
  all.back().Set<vtkFFHullFilter>(
    [](auto* hull) { hull->SetCompositeMode(vtkFFHullFilter::HULL_OF_ALL_BLOCKS); });
  all.push_back(compare<vtkPFFRegularTriangulationFilter, Triangulation>());
  all.push_back(compare<vtkPFFPowerDiagramFilter, vtkFFPowerDiagramFilter>());
  return all;
}

bool joinsBlocks(const DistributedVersusSerial& both)
{
  auto* hull = vtkFFHullFilter::SafeDownCast(both.Distributed);
  return hull && hull->GetCompositeMode() == vtkFFHullFilter::HULL_OF_ALL_BLOCKS;
}

Pieces makePieces()
{
  const Pieces pieces = split(randomPoints(600, 91), byTurns);
  decorate(pieces);
  for (vtkPolyData* piece : pieces)
  {
    const std::vector<double> weights(static_cast<std::size_t>(piece->GetNumberOfPoints()), 0.0);
    piece->GetPointData()->AddArray(makeWeighted({}, weights)->GetPointData()->GetArray("weights"));
  }
  return pieces;
}

vtkDataObject* ownOf(const Pieces& pieces)
{
  return pieces[static_cast<std::size_t>(rank())];
}

/// The process, or the last one if there are fewer.
int atMostLast(int process)
{
  return std::min(process, processes() - 1);
}

void spoil(const Pieces& pieces, int process, vtkIdType point, double value)
{
  pieces[static_cast<std::size_t>(atMostLast(process))]->GetPoints()->SetPoint(
    point, 0.0, value, 0.0);
}

/// Fails on all, and does its work the next time.
void refuses(DistributedVersusSerial& both, const std::string& what, const Pieces& pieces,
  const std::string& part)
{
  both.Run(what, pieces);
  FF_CHECK(both.Distributed->GetErrorCode() != vtkErrorCode::NoError);
  FF_CHECK_EQUAL(both.Errors->Messages.size(), std::size_t(rank() == 0));
  FF_CHECK(rank() > 0 || both.Errors->Has(part));
  both.Run("after " + what, makePieces());
  FF_CHECK_EQUAL(both.Distributed->GetErrorCode(), vtkErrorCode::NoError);
}

void testNonFinite(DistributedVersusSerial& both)
{
  const auto ignore = [&](bool ignores)
  { both.Set<vtkFFAlgorithm>([=](auto* filter) { filter->SetNonFinitePoints(ignores); }); };
  const std::vector<std::vector<std::pair<int, double>>> faults{ { { 1, nan } },
    { { 0, infinity } }, { { 4, -infinity } }, { { 1, nan }, { 2, infinity } },
    { { 3, nan }, { 0, nan } } };
  for (const auto& fault : faults)
  {
    const Pieces pieces = makePieces();
    std::string what = "not finite on";
    std::set<int> spoilt;
    for (const auto& [process, value] : fault)
    {
      spoil(pieces, process, 17, value);
      spoil(pieces, process, 5, value);
      spoilt.insert(atMostLast(process));
      what += " " + std::to_string(process);
    }
    refuses(both, what, pieces, std::to_string(2 * spoilt.size()) + " such point(s)");
    ignore(true);
    both.Run(what + ", ignored", pieces);
    FF_CHECK_EQUAL(both.Distributed->GetErrorCode(), vtkErrorCode::NoError);
    ignore(false);
  }

  // None left, on one process and on all.
  ignore(true);
  Pieces pieces = split(
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, [](int) { return processes() - 1; });
  decorate(pieces);
  if (processes() > 1)
  {
    pieces[0] = makePoints({ { nan, 0, 0 }, { 0, 0, infinity } });
    decorate(pieces);
  }
  both.Run("one piece not finite at all", pieces);
  pieces.assign(pieces.size(), makePoints({ { nan, 0, 0 }, { 0, 0, infinity } }));
  both.Run("nothing finite", pieces);
  ignore(false);
}

/// The messages name block and point: of each block at fault, or of all blocks.
void testBlocks(DistributedVersusSerial& both)
{
  for (const auto& [first, second] : { std::pair<int, int>{ 1, 3 }, { 2, 2 }, { 0, 1 } })
  {
    std::vector<Pieces> leaves;
    for (int leaf = 0; leaf < 4; ++leaf)
    {
      leaves.push_back(makePieces());
    }
    spoil(leaves[static_cast<std::size_t>(first)], 1, 7, nan);
    spoil(leaves[static_cast<std::size_t>(second)], 0, 9, nan);
    spoil(leaves[static_cast<std::size_t>(second)], 2, 9, infinity);
    both.Run("blocks that are not finite", leaves);
    FF_CHECK(both.Distributed->GetErrorCode() != vtkErrorCode::NoError);
    FF_CHECK(rank() > 0 ||
      both.Errors->Has((joinsBlocks(both) ? "of the block of flat index "
                                          : "of data set " + std::to_string(second))));
  }
  const std::vector<Pieces> leaves(4, makePieces());
  vtkNew<vtkTable> table;
  both.Distributed->SetProgressShiftScale(0.5, 0.5); // the caller's
  both.Run("with a shift and a scale", leaves);
  FF_CHECK(processes() == 1 || both.Distributed->GetProgressScale() == 0.5);
  both.Distributed->SetProgressShiftScale(0.0, 1.0);
  for (int process = 0; process < processes(); ++process)
  {
    const auto piece = pieceOfBlocks(leaves);
    const auto whole = appendBlocks(leaves);
    whole->SetBlock(2, table);
    if (rank() == process)
    {
      piece->SetBlock(2, table);
    }
    both.Run("a wrong block", piece, whole);
    FF_CHECK(rank() > 0 || both.Errors->Has("is a vtkTable"));
    both.Run("after a wrong block", leaves);
  }
}

/// 2^53 + 1 and its like.
void testInexact(DistributedVersusSerial& both)
{
  const auto make = [](int number, vtkTypeInt64 value)
  {
    vtkNew<vtkTypeInt64Array> array;
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(20);
    for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
    {
      array->SetValue(i, (i * i + 7 * number) % 31);
    }
    array->SetValue(31, value); // of point 10
    return makePoints(array);
  };
  const vtkTypeInt64 wide = (vtkTypeInt64(1) << 53) + 1;
  for (const int bad : { 1, 0, 2 })
  {
    const int first = atMostLast(bad);
    both.Fails("wide integers", make(rank(), rank() >= first ? wide : 1),
      "is a 64-bit integer that no double holds: first at point " +
        std::to_string(20 * first + 10));
    both.Run("integers that a double holds", { std::size_t(processes()), make(3, wide - 1) });
  }
}

/// Progress goes from 0 to 1 on every process, and never back.
void testProgress(DistributedVersusSerial& both)
{
  vtkNew<ProgressObserver> progress;
  const unsigned long tag = both.Distributed->AddObserver(vtkCommand::ProgressEvent, progress);
  both.Run("progress", makePieces());
  checkProgress(progress->Values);
  progress->Values.clear();
  both.Run("progress of blocks", std::vector<Pieces>(4, makePieces()));
  checkProgress(progress->Values);
  both.Distributed->RemoveObserver(tag);
}

/// On one process no data set, no input at all, or another number of blocks: the others do not
/// wait.
void testWrongInput(DistributedVersusSerial& both)
{
  const Pieces pieces = makePieces();
  vtkNew<vtkTable> table;
  vtkNew<vtkOverlappingAMR> amr;
  const auto blocks = pieceOfBlocks(std::vector<Pieces>(4, pieces));
  vtkNew<vtkMultiBlockDataSet> block; // a single one
  block->SetBlock(0, ownOf(pieces));
  for (const bool composite : { false, true })
  {
    vtkDataObject* const piece = composite ? blocks.Get() : ownOf(pieces);
    vtkDataObject* const other = composite ? ownOf(pieces) : blocks.Get();
    vtkDataObject* const single = composite ? block.Get() : ownOf(pieces);
    vtkDataObject* const otherSingle = composite ? ownOf(pieces) : block.Get();
    for (int process = 0; process < processes(); ++process)
    {
      const bool wrong = rank() == process;
      both.Fails("a wrong input", wrong ? table.Get() : piece, "The data is a vtkTable");
      if (processes() > 1)
      {
        both.Fails("an AMR", wrong ? amr.Get() : piece,
          "The data is a vtkOverlappingAMR, which several processes do not take. Convert it to a "
          "vtkMultiBlockDataSet.");
      }
      both.Fails("no input", wrong ? nullptr : piece, "There is no input. Set one.");
      if (!joinsBlocks(both))
      {
        both.Fails("other blocks", wrong ? other : piece, "different numbers of blocks");
        both.Fails("a composite on some", wrong ? otherSingle : single,
          "The input is a composite on some processes, and not on others. Give all a composite "
          "of the same structure, or none.");
      }
      both.Run("after a wrong input", pieces);
      FF_CHECK_EQUAL(both.Distributed->GetErrorCode(), vtkErrorCode::NoError);
    }
  }
}

void testWeights()
{
  DistributedVersusSerial both = compare<vtkPFFRegularTriangulationFilter, Triangulation>();
  both.Set<Triangulation>([](auto* filter) { useWeights(filter); });
  const auto last = static_cast<std::size_t>(processes() - 1);
  const auto place = std::to_string(
    append(makePieces())->GetNumberOfPoints() - makePieces()[last]->GetNumberOfPoints() + 11);
  Pieces pieces = makePieces();
  pieces[last]->GetPointData()->GetArray("weights")->SetTuple1(11, nan);
  refuses(both, "a weight that is NaN", pieces, "point " + place + ", 1 such");
  for (vtkPolyData* piece : pieces)
  {
    piece->GetPointData()->RemoveArray("weights");
  }
  refuses(both, "weights missing on all", pieces, "missing from the input's point data");

  // Only one process has points, so that none are appended.
  const auto points = randomPoints(50, 112);
  for (const int owner : { 0, processes() - 1 })
  {
    pieces = split(points, [=](int) { return owner; });
    vtkNew<vtkDoubleArray> weights;
    weights->SetName("weights");
    weights->SetNumberOfTuples(51);
    weights->Fill(0.0);
    pieces[static_cast<std::size_t>(owner)]->GetPointData()->AddArray(weights);
    refuses(both, "weights of another number", pieces, "has 51 value(s) for 50 point(s)");
  }
}

/// What several processes cannot do, and what to do instead; on whichever it was set.
void testSeveral()
{
  const Pieces pieces = makePieces();
  DistributedVersusSerial cuda = compare<vtkPFFRegularTriangulationFilter, Triangulation>();
  cuda.Distributed->SetEngine(vtkFFAlgorithm::ENGINE_CUDA);
  cuda.Fails("CUDA", ownOf(pieces),
    "The CUDA engine was asked for, but several processes triangulate together on their CPUs. "
    "Set Engine to Automatic or CPU.");
  DistributedVersusSerial box = compare<vtkPFFPowerDiagramFilter, vtkFFPowerDiagramFilter>();
  vtkFFPowerDiagramFilter::SafeDownCast(box.Distributed)->SetPowerDiagramBounds(1, 0, 0, 1);
  box.Fails("no box", ownOf(pieces), "(xmin, xmax, ymin, ymax)");
  DistributedVersusSerial lengths[] = { compare<vtkPFFRegularTriangulationFilter, Triangulation>(),
    compare<vtkPFFRegularTriangulationFilter, Triangulation>() };
  Triangulation::SafeDownCast(lengths[0].Distributed)->SetAlpha(-1.0);
  lengths[0].Fails("alpha", ownOf(pieces), "Alpha is -1; it must be a length");
  Triangulation::SafeDownCast(lengths[1].Distributed)->SetMaximumEdgeLength(nan);
  lengths[1].Fails("length", ownOf(pieces), "Maximum Edge Length is nan; it must be a length");
  DistributedVersusSerial bounded = compare<vtkPFFRegularTriangulationFilter, Triangulation>();
  auto* const triangulation = Triangulation::SafeDownCast(bounded.Distributed);
  for (int process = 0; process <= processes(); ++process)
  {
    triangulation->SetGenerateBoundary(rank() == process || process == processes());
    bounded.Fails("boundary", ownOf(pieces),
      "Several processes triangulate together, and none has all cells: Alpha Lines, Alpha Verts, "
      "Generate Alphas and Generate Boundary must be off. To have them, bring all points to one "
      "process.");
    triangulation->SetGenerateBoundary(false);
    bounded.Run("after a boundary", pieces);
  }
  DistributedVersusSerial constrained = compare<vtkPFFRegularTriangulationFilter, Triangulation>();
  vtkNew<vtkPolyData> source;
  Triangulation::SafeDownCast(constrained.Distributed)->SetSourceData(source);
  constrained.Fails("constraints", ownOf(pieces),
    "Constraints need all points on one process, and several triangulate together. Bring all "
    "points to one process, or take the source away.");
}

/// Processes that are not of MPI cannot exchange messages: the two of a socket.
template <class FilterT>
void testController()
{
  if (rank() > 0)
  {
    return;
  }
  vtkNew<vtkSocketController> controller;
  vtkNew<FilterT> filter;
  const auto errors = ErrorObserver::Of(filter);
  filter->SetController(controller);
  filter->SetInputDataObject(makePieces()[0]);
  filter->Update();
  FF_CHECK_EQUAL(filter->GetErrorCode(), static_cast<unsigned long>(vtkFFErrorCode::ProcessError));
  FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
  FF_CHECK(errors->Has("Several processes work together by MPI, and the controller is a "
                       "vtkSocketController. Set a vtkMPIController, or none."));
}

}

void testErrors()
{
  std::vector<DistributedVersusSerial> all = makeComparisons();
  for (DistributedVersusSerial& both : all)
  {
    testNonFinite(both);
    testBlocks(both);
    testInexact(both);
    testProgress(both);
    if (processes() > 1) // one alone is its superclass
    {
      testWrongInput(both);
    }
  }
  testWeights();
  testController<vtkPFFHullFilter>();
  testController<vtkPFFRegularTriangulationFilter>();
  if (processes() > 1)
  {
    testSeveral();
  }
}
