// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// What is wrong on one process is an error of all, told once, of the points as a whole; nobody
// waits for ever, and the next run is none the worse for it.
#include "Twins.h"

#include "vtkErrorCode.h"
#include "vtkFFHullFilter.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPFFHullFilter.h"
#include "vtkPoints.h"
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

Twins hulls()
{
  return twins<vtkPFFHullFilter, vtkFFHullFilter>();
}

Pieces makePieces()
{
  const Pieces pieces = split(randomPoints(2000, 91), [](int i) { return i % processes(); });
  decorate(pieces);
  return pieces;
}

/// Spoils a coordinate of the piece of a process, of the last one if there are fewer.
void spoil(const Pieces& pieces, int process, vtkIdType point, double value)
{
  vtkPolyData* piece = pieces[static_cast<std::size_t>(std::min(process, processes() - 1))];
  vtkNew<vtkPoints> points;
  points->SetDataType(piece->GetPoints()->GetDataType());
  points->DeepCopy(piece->GetPoints());
  points->SetPoint(point, 0.0, value, 0.0);
  piece->SetPoints(points);
}

void testNonFinite()
{
  Twins both = hulls();
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
      spoilt.insert(std::min(process, processes() - 1));
      what += " " + std::to_string(process);
    }
    both.Run(what, pieces);
    FF_CHECK(both.Distributed->GetErrorCode() != vtkErrorCode::NoError);
    FF_CHECK_EQUAL(both.Errors->Messages.size(), std::size_t(rank() == 0));

    both.Set<vtkFFHullFilter>([](vtkFFHullFilter* hull) { hull->SetNonFinitePointsToIgnore(); });
    both.Run(what + ", ignored", pieces);
    FF_CHECK_EQUAL(both.Distributed->GetErrorCode(), vtkErrorCode::NoError);
    FF_CHECK_EQUAL(
      both.Distributed->GetNumberOfNonFinitePoints(), rank() ? 0 : vtkIdType(2 * spoilt.size()));
    both.Set<vtkFFHullFilter>([](vtkFFHullFilter* hull) { hull->SetNonFinitePointsToError(); });
    both.Run("the next run", makePieces());
  }

  // None left, on one process and on all.
  both.Set<vtkFFHullFilter>([](vtkFFHullFilter* hull) { hull->SetNonFinitePointsToIgnore(); });
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
}

/// Each block alone, and all blocks: the message names block and point.
void testNonFiniteInBlocks()
{
  Twins both = hulls();
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
    for (int mode = 0; mode < 2; ++mode)
    {
      both.Set<vtkFFHullFilter>([=](vtkFFHullFilter* hull) { hull->SetCompositeMode(mode); });
      both.Run("blocks that are not finite", leaves);
      FF_CHECK(both.Distributed->GetErrorCode() != vtkErrorCode::NoError);
      both.Set<vtkFFHullFilter>([](vtkFFHullFilter* hull) { hull->SetNonFinitePointsToIgnore(); });
      both.Run("blocks that are not finite, ignored", leaves);
      both.Set<vtkFFHullFilter>([](vtkFFHullFilter* hull) { hull->SetNonFinitePointsToError(); });
    }
  }
}

/// 2^53 + 1 and its like.
void testInexact()
{
  Twins both = hulls();
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
    Pieces pieces;
    for (int k = 0; k < processes(); ++k)
    {
      pieces.push_back(make(k, k >= bad ? wide : 1));
    }
    both.Run("wide integers", pieces);
    both.Run("integers that a double holds", { std::size_t(processes()), make(3, wide - 1) });
  }
  std::vector<Pieces> leaves{ makePieces(), {}, makePieces(), makePieces() };
  leaves[1].assign(std::size_t(processes()), make(2, wide));
  spoil(leaves[0], 0, 1, nan);
  for (int mode = 0; mode < 2; ++mode)
  {
    both.Set<vtkFFHullFilter>([=](vtkFFHullFilter* hull) { hull->SetCompositeMode(mode); });
    both.Run("first not finite, then wide", leaves);
  }
}

/// Whoever asks to abort, at whatever time: all stop, without an error.
void testAbort()
{
  if (processes() == 1) // one alone is its superclass
  {
    return;
  }
  Twins both = hulls();
  const Pieces pieces = split(randomPoints(20000, 92), [](int i) { return i % processes(); });
  const auto own = static_cast<std::size_t>(rank());
  for (const int process : { 0, 1, 4 })
  {
    for (const double mark : { 0.0, 0.3, 1.0 })
    {
      vtkNew<ProgressObserver> progress;
      progress->AbortAt = mark;
      const bool aborts = rank() == std::min(process, processes() - 1);
      const unsigned long tag =
        aborts ? both.Distributed->AddObserver(vtkCommand::ProgressEvent, progress) : 0;
      both.Fails("an abort", pieces[own], "");
      FF_CHECK(!aborts || !progress->Values.empty());
      both.Distributed->RemoveObserver(tag);
      both.Distributed->SetAbortExecute(0); // older VTKs do so at the start of a run
      both.Run("after an abort", pieces);
    }
  }
}

/// Progress goes from 0 to 1 on every process, and never back.
void testProgress()
{
  Twins both = hulls();
  vtkNew<ProgressObserver> progress;
  both.Distributed->AddObserver(vtkCommand::ProgressEvent, progress);
  both.Run("progress", makePieces());
  checkProgress(progress->Values);
  std::vector<Pieces> leaves(4);
  for (Pieces& leaf : leaves)
  {
    leaf = makePieces();
  }
  for (int mode = 0; mode < 2; ++mode)
  {
    progress->Values.clear();
    both.Set<vtkFFHullFilter>([=](vtkFFHullFilter* hull) { hull->SetCompositeMode(mode); });
    both.Run("progress of blocks", leaves);
    checkProgress(progress->Values);
  }
}

/// A block that is no point set, on one process.
void testWrongBlock()
{
  Twins both = hulls();
  std::vector<Pieces> leaves(4);
  for (Pieces& leaf : leaves)
  {
    leaf = makePieces();
  }
  for (int process = 0; process < processes(); ++process)
  {
    const auto piece = pieceOfBlocks(leaves);
    const auto whole = appendBlocks(leaves);
    vtkNew<vtkTable> table;
    whole->SetBlock(2, table);
    if (rank() == process)
    {
      piece->SetBlock(2, table);
    }
    for (int mode = 0; mode < 2; ++mode)
    {
      both.Set<vtkFFHullFilter>([=](vtkFFHullFilter* hull) { hull->SetCompositeMode(mode); });
      both.Run("a wrong block", piece, whole);
      FF_CHECK(rank() > 0 || both.Errors->Has(" is a vtkTable"));
      both.Run("after a wrong block", leaves);
    }
  }
}

/// On one process no data set, or no input at all: the others do not wait for it.
void testWrongInput()
{
  if (processes() == 1) // for the executive to say
  {
    return;
  }
  Twins both = hulls();
  const Pieces pieces = makePieces();
  vtkNew<vtkTable> table;
  for (int process = 0; process < processes(); ++process)
  {
    const bool wrong = rank() == process;
    vtkDataObject* piece = pieces[static_cast<std::size_t>(rank())];
    both.Fails("a wrong input", wrong ? table.Get() : piece, "The data is a vtkTable");
    both.Fails("no input", wrong ? nullptr : piece, "There is no input");
    both.Run("after a wrong input", pieces);
  }
}

/// One process streams, several say that they do not, on whichever it was set.
void testStreaming()
{
  Twins both = hulls();
  const Pieces pieces = makePieces();
  auto* hull = vtkFFHullFilter::SafeDownCast(both.Distributed);
  for (int process = 0; process <= processes(); ++process)
  {
    const bool streams = rank() == process || process == processes();
    hull->SetNumberOfStreamDivisions(streams ? 3 : 1);
    if (processes() == 1)
    {
      both.Run("streaming", pieces);
      continue;
    }
    both.Fails("streaming", pieces[static_cast<std::size_t>(rank())],
      "Several processes cannot stream their pieces. Set Number Of Stream Divisions to 1: each "
      "process has its piece alone in memory then.");
    hull->SetNumberOfStreamDivisions(1);
    both.Run("after streaming", pieces);
  }
}

}

void testHullErrors()
{
  testNonFinite();
  testNonFiniteInBlocks();
  testInexact();
  testAbort();
  testProgress();
  testWrongBlock();
  testWrongInput();
  testStreaming();
}
