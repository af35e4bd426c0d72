// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Blocks in pieces: a hull of each block, and one of all, wherever the pieces are.
#include "DistributedVersusSerial.h"

#include "vtkDoubleArray.h"
#include "vtkFFHullFilter.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPFFHullFilter.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"

using namespace fftest;

namespace
{

constexpr int modes[] = { vtkFFHullFilter::HULL_OF_EACH_BLOCK,
  vtkFFHullFilter::HULL_OF_ALL_BLOCKS };

/// Four leaves side by side, each dealt out to all processes.
std::vector<Pieces> makeLeaves(int type = VTK_DOUBLE)
{
  std::vector<Pieces> leaves;
  for (unsigned int leaf = 0; leaf < 4; ++leaf)
  {
    auto points = randomPoints(200 + 50 * static_cast<int>(leaf), 81 + leaf);
    for (Point& p : points)
    {
      p[0] += 1.5 * leaf;
    }
    leaves.push_back(split(
      points, [=](int i) { return (i + static_cast<int>(leaf)) % processes(); }, type));
    decorate(leaves.back());
  }
  return leaves;
}

void runAll(const std::string& what, const std::vector<Pieces>& leaves)
{
  DistributedVersusSerial both = compare<vtkPFFHullFilter, vtkFFHullFilter>();
  for (const int mode : modes)
  {
    for (const bool report : { false, true })
    {
      both.Set<vtkFFHullFilter>(
        [=](vtkFFHullFilter* filter)
        {
          filter->SetCompositeMode(mode);
          filter->SetReportAsFieldData(report);
          filter->SetVisiblePointIds(report);
        });
      both.Run(what + (mode ? ", all blocks" : ", each block"), leaves);
    }
  }
}

void testBlocks()
{
  runAll("blocks", makeLeaves());
  runAll("blocks of floats", makeLeaves(VTK_FLOAT));

  // What is not there, or has no point: somewhere, on process 0, on all but one, everywhere.
  auto leaves = makeLeaves();
  const auto last = static_cast<std::size_t>(processes() - 1);
  leaves[0][0] = nullptr;
  leaves[1][last] = nullptr;
  leaves[2][0] = vtkSmartPointer<vtkPolyData>::New();
  for (std::size_t k = 0; k < last; ++k)
  {
    leaves[3][k] = nullptr;
  }
  runAll("missing pieces", leaves);
  leaves[1].assign(leaves[1].size(), nullptr);
  runAll("a missing block", leaves);
  leaves[0].assign(leaves[0].size(), vtkSmartPointer<vtkPolyData>::New());
  runAll("a block without points", leaves);
  for (Pieces& pieces : leaves)
  {
    pieces.assign(pieces.size(), nullptr);
  }
  runAll("nothing at all", leaves);
}

/// Blocks of different types and data: of all blocks, what all have.
void testUnlikeBlocks()
{
  auto leaves = makeLeaves(VTK_FLOAT);
  leaves[2] = split(randomPoints(300, 85), byTurns);
  decorate(leaves[2]);
  for (vtkPolyData* piece : leaves[1])
  {
    piece->GetPointData()->RemoveArray("wide");
  }
  runAll("unlike blocks", leaves);
}

/// A block's own field data stays where process 0 has the block.
void testFieldData()
{
  const auto leaves = makeLeaves();
  vtkNew<vtkDoubleArray> time;
  time->SetName("time");
  time->InsertNextValue(4.5);
  const auto piece = pieceOfBlocks(leaves);
  const auto whole = appendBlocks(leaves);
  for (vtkMultiBlockDataSet* blocks : { piece.Get(), whole.Get() })
  {
    blocks->GetBlock(0)->GetFieldData()->AddArray(time);
  }
  DistributedVersusSerial both = compare<vtkPFFHullFilter, vtkFFHullFilter>();
  both.Set<vtkFFHullFilter>([](vtkFFHullFilter* filter) { filter->SetReportAsFieldData(true); });
  both.Run("field data of a block", piece, whole);
  if (rank() == 0)
  {
    auto* output =
      vtkMultiBlockDataSet::SafeDownCast(both.Distributed->GetOutputDataObject(0))->GetBlock(0);
    FF_CHECK(output->GetFieldData()->HasArray("time"));
    FF_CHECK(output->GetFieldData()->HasArray("FlipFlopVolume"));
  }
}

/// Where processes have other blocks, each block has no one hull; all blocks have.
void testStructures()
{
  const auto leaves = makeLeaves();
  const auto own = static_cast<std::size_t>(rank());
  vtkNew<vtkMultiBlockDataSet> piece;
  vtkNew<vtkMultiBlockDataSet> whole;
  const int last = processes() - 1;
  piece->SetNumberOfBlocks(rank() == last ? 3 : 2); // flat indices 1, 2 and 3
  piece->SetBlock(0, leaves[0][own]);
  piece->SetBlock(1, leaves[1][own]);
  whole->SetBlock(0, append(leaves[0]));
  whole->SetBlock(1, append(leaves[1]));
  whole->SetBlock(2, leaves[2][static_cast<std::size_t>(last)]);
  if (rank() == last)
  {
    piece->SetBlock(2, leaves[2][own]);
  }
  DistributedVersusSerial both = compare<vtkPFFHullFilter, vtkFFHullFilter>();
  if (processes() > 1) // one alone is like itself
  {
    both.Fails(
      "another structure", piece, "Processes have different numbers of blocks: process 0 has");
    vtkDataObject* other = rank() == 0 ? leaves[0][0].Get() : static_cast<vtkDataObject*>(piece);
    both.Fails(
      "no composite on one", other, "Processes have different numbers of blocks: process 0 has");
  }
  both.Set<vtkFFHullFilter>(
    [](vtkFFHullFilter* filter) { filter->SetCompositeMode(vtkFFHullFilter::HULL_OF_ALL_BLOCKS); });
  both.Run("all blocks of another structure", piece, whole);
  both.Set<vtkFFHullFilter>(
    [](vtkFFHullFilter* filter) { filter->SetCompositeMode(vtkFFHullFilter::HULL_OF_EACH_BLOCK); });
  both.Run("the same structure afterwards", leaves);
}

/// Each process has partitions of its own: the usual way of the newer composites.
void testPartitions()
{
  const auto leaves = makeLeaves();
  vtkNew<vtkPartitionedDataSetCollection> piece;
  vtkNew<vtkPartitionedDataSetCollection> whole;
  for (unsigned int k = 0; k < 2; ++k)
  {
    vtkNew<vtkPartitionedDataSet> parts;
    parts->SetPartition(0, leaves[k][static_cast<std::size_t>(rank())]);
    piece->SetPartitionedDataSet(k, parts);
    vtkNew<vtkPartitionedDataSet> wholeParts;
    wholeParts->SetPartition(0, append(leaves[k]));
    whole->SetPartitionedDataSet(k, wholeParts);
  }
  DistributedVersusSerial both = compare<vtkPFFHullFilter, vtkFFHullFilter>();
  for (const int mode : modes)
  {
    both.Set<vtkFFHullFilter>([=](vtkFFHullFilter* filter) { filter->SetCompositeMode(mode); });
    both.Run("partitions", piece, whole);
  }
}

}

void testHullComposite()
{
  testBlocks();
  testUnlikeBlocks();
  testFieldData();
  testStructures();
  testPartitions();
}
