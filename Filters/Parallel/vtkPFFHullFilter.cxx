// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPFFHullFilter.h"

#include "FFCudaMemory.h"
#include "FFDistributedCells.h"
#include "FFDistributedInput.h"
#include "FFDistributedPoints.h"
#include "FFHullResult.h"
#include "FFInput.h"
#include "FFOutput.h"
#include "FFPointMessage.h"
#include "FFProcesses.h"
#include "FFRun.h"

#include "vtkDataSetAttributes.h"
#include "vtkIdTypeArray.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkPFFHullFilter);

namespace
{

using Blocks = std::vector<FFDistributedInput::BlockType>;

/// Reads the points of all blocks. They are counted block by block, and in a block process by
/// process. Collective.
void readPoints(
  vtkPFFHullFilter* filter, const Blocks& blocks, FFProcesses& processes, FFInput& input)
{
  FFRun& run = processes.GetRun();
  std::vector<FFInput::PieceType> pieces;
  for (const auto& block : blocks)
  {
    pieces.insert(pieces.end(), block.Pieces.begin(), block.Pieces.end());
  }
  input.TakePieces(pieces, filter->GetSkipGhostPoints(), run);
  run.Ids.reset(); // ids count the remaining points
  run.Parts.clear();
  std::vector<vtkIdType> sizes;
  auto piece = input.GetPieces().begin();
  for (const auto& block : blocks)
  {
    const auto end = piece + static_cast<std::ptrdiff_t>(block.Pieces.size());
    sizes.push_back(std::accumulate(piece, end, vtkIdType(0),
      [](vtkIdType sum, const auto& points) { return sum + points->GetNumberOfPoints(); }));
    piece = end;
  }
  const std::vector<std::vector<vtkIdType>> all = processes.Gather(sizes);
  const bool isComposite = std::any_of(
    blocks.begin(), blocks.end(), [](const auto& block) { return block.FlatIndex > 0; });
  vtkIdType counted = 0;
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    const vtkIdType begin = counted;
    for (std::size_t process = 0; process < all.size(); ++process)
    {
      const bool isOwn = process == static_cast<std::size_t>(processes.GetRank());
      if (isOwn && blocks.size() == 1)
      {
        run.FirstId = counted; // and so on
      }
      else if (isOwn)
      {
        std::vector<vtkIdType>& ids = run.Ids ? *run.Ids : run.Ids.emplace();
        ids.resize(ids.size() + static_cast<std::size_t>(sizes[b]));
        std::iota(ids.end() - sizes[b], ids.end(), counted);
      }
      counted += all[process][b];
    }
    if (isComposite)
    {
      const std::string index = std::to_string(blocks[b].FlatIndex);
      run.Parts.push_back(
        { counted - begin, " of the block of flat index " + index, blocks[b].FlatIndex });
    }
  }
}

/// The hull of the hulls of all processes, on process 0. Collective.
/// @param first the lowest id of the process's points; VTK_ID_MAX: none
void gather(FFHullResult& hull, vtkIdType first, FFProcesses& processes)
{
  const std::vector<std::vector<vtkIdType>> firsts = processes.Gather<vtkIdType>({ first });
  FFProcesses::Messages messages;
  hull.KeepKind();
  if (processes.GetRank() > 0)
  {
    messages[0] = FFPointMessage::Pack(hull.Data);
  }
  processes.Exchange(messages);
  if (processes.GetRank() > 0)
  {
    return;
  }
  // In the order of the points: the first block with some decides on types and data, as alone.
  std::multimap<vtkIdType, vtkSmartPointer<vtkPointSet>> hulls{ { first, hull.Data } };
  for (auto& message : messages)
  {
    const vtkIdType its = firsts[static_cast<std::size_t>(message.first)][0];
    hulls.emplace(its, FFPointMessage::Unpack(std::move(message.second)));
  }
  std::vector<vtkPointSet*> sorted;
  for (const auto& [its, data] : hulls)
  {
    sorted.push_back(data);
  }
  const vtkSmartPointer<vtkPointSet> all = FFOutput::Append(sorted);
  auto* const ids =
    vtkIdTypeArray::SafeDownCast(all->GetPointData()->GetArray("vtkOriginalPointIds"));
  vtkNew<vtkIdTypeArray> order; // of several blocks, ids do not ascend from process to process
  order->SetNumberOfValues(all->GetNumberOfPoints());
  vtkIdType* const begin = order->GetPointer(0);
  std::iota(begin, begin + order->GetNumberOfValues(), vtkIdType(0));
  std::stable_sort(begin, begin + order->GetNumberOfValues(),
    [&](vtkIdType a, vtkIdType b) { return ids->GetValue(a) < ids->GetValue(b); });
  std::vector<FFHullResult> joined(1);
  std::swap(joined[0], hull);
  if (ids) // there is a point
  {
    joined[0].Data = vtkPolyData::SafeDownCast(FFOutput::Select(all, order));
  }
  else
  {
    joined[0].Data->SetPoints(all->GetPoints()); // of the type of all
  }
  hull.Join(joined, processes.GetRun());
}

/// The hull of this process's points becomes its share of the facets of all, with their points, and
/// the dimension, volume and area of the whole. Statistics are added to. Returns whether another
/// process counts each of the share's points. Collective.
std::vector<bool> distribute(FFHullResult& hull, FFProcesses& processes)
{
  // Ids count the points of these hulls, in the order of the ids that they have.
  hull.KeepKind();
  FFDistributedPoints source(processes);
  source.Count(hull.Data->GetNumberOfPoints());
  source.SetPoints(hull.Data);
  std::vector<FFDistributedCells::Point> points;
  for (vtkIdType i = 0; i < hull.Data->GetNumberOfPoints(); ++i)
  {
    FFDistributedCells::Point point;
    const double* const x = point.Position;
    hull.Data->GetPoint(i, point.Position);
    point.Id = source.GetBegin() + i;
    if (std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]))
    {
      points.push_back(point);
    }
  }
  flipflop::Options options = processes.GetRun().Options;
  options.facets = flipflop::FacetMode::Polygons; // as of each FFHullResult
  double size[2];
  flipflop::BlockResult result = FFDistributedCells::Compute(
    flipflop::BlockShape::Hull, std::move(points), options, processes, size);
  flipflop::CellComplex& cells = result.cells;
  const auto fetched = source.Fetch({ cells.pointIds.begin(), cells.pointIds.end() }, true);
  const auto duplicates = FFDistributedCells::FindDuplicates(result, processes);
  if (cells.pointIds.empty())
  {
    // One point of the kind, which is left out.
    fetched->GetPoints()->SetNumberOfPoints(0);
    fetched->GetPointData()->SetNumberOfTuples(0);
  }
  hull.Data = vtkPolyData::SafeDownCast(fetched);
  hull.Hull.dimension = cells.dimension;
  hull.Hull.volume = size[0];
  hull.Hull.area = size[1];
  hull.Hull.statistics += cells.statistics;
  FFOutput::AdoptCells(cells, hull.Data);
  return duplicates;
}

/// The hull of what this process has becomes that of what all have: on process 0; or a share on
/// each, and whether another process counts each of its points. Collective.
void join(vtkPFFHullFilter* filter, bool mayStay, vtkIdType first, FFProcesses& processes,
  FFHullResult& hull, std::optional<std::vector<bool>>& duplicates)
{
  const flipflop::Statistics& statistics = hull.Hull.statistics;
  const std::vector<vtkIdType> counts = processes.Sum({ static_cast<vtkIdType>(statistics.points),
    static_cast<vtkIdType>(statistics.nonFinite), hull.Data->GetNumberOfPoints() });
  const int mode = filter->GetResultMode();
  if (mayStay &&
    (mode == vtkPFFHullFilter::RESULT_DISTRIBUTED ||
      (mode == vtkPFFHullFilter::RESULT_AUTOMATIC && counts[2] > filter->GetGatheredPointsLimit())))
  {
    duplicates = distribute(hull, processes);
  }
  else
  {
    gather(hull, first, processes);
  }
  hull.Hull.statistics.points = counts[0];
  hull.Hull.statistics.nonFinite = counts[1];
}

/// Adds what other processes have read to this process's ids, and to the parts. Collective.
void countPieces(FFHullResult& hull, FFProcesses& processes)
{
  FFRun& run = processes.GetRun();
  using Part = std::array<vtkIdType, 2>; // number of points, and block
  std::vector<Part> own;
  for (const FFRun::PartType& part : run.Parts)
  {
    own.push_back({ part.NumberOfPoints, static_cast<vtkIdType>(part.FlatIndex) });
  }
  if (own.empty())
  {
    own.push_back({ run.FirstId, 0 });
  }
  run.Parts.clear();
  bool isComposite = false;
  vtkIdType counted = 0;
  int process = 0;
  for (const std::vector<Part>& parts : processes.Gather(own))
  {
    if (process++ == processes.GetRank())
    {
      FFOutput::Renumber(
        hull.Data->GetPointData(), [counted](vtkIdType id) { return counted + id; });
    }
    for (const Part& part : parts)
    {
      run.Parts.push_back({ part[0], {}, static_cast<unsigned int>(part[1]) });
      isComposite = isComposite || part[1] > 0;
      counted += part[0];
    }
  }
  if (!isComposite)
  {
    run.Parts.clear();
  }
}

/// The hull of the points that this process reads, a piece at a time. Collective.
void readPieces(FFHullStream& stream, FFProcesses& processes, FFHullResult& hull)
{
  // As many steps on each process: sources may work together, and what fails on one ends all.
  vtkIdType steps = 0;
  for (const std::vector<vtkIdType>& count : processes.Gather<vtkIdType>({ stream.GetCount() }))
  {
    steps = std::max(steps, count[0]);
  }
  for (int number = 0; number < steps; ++number)
  {
    if (number < stream.GetCount())
    {
      stream.TakePiece(number, hull);
    }
    processes.Agree();
  }
  countPieces(hull, processes);
}

}

//------------------------------------------------------------------------------
vtkPFFHullFilter::vtkPFFHullFilter()
{
  FFDistributedInput::Prepare(this, this->Controller);
  FFCudaMemory::AddFilter(); // of this library's copy of the engine
}

//------------------------------------------------------------------------------
vtkPFFHullFilter::~vtkPFFHullFilter()
{
  FFCudaMemory::RemoveFilter();
}

//------------------------------------------------------------------------------
int vtkPFFHullFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!FFProcesses::AreSeveral(this->Controller))
  {
    return this->Superclass::RequestData(request, inputVector, outputVector);
  }
  FFRun whole(this, this->GetTitle());
  const bool isStreamed = this->NumberOfStreamDivisions > 1;
  const auto work =
    [&](const Blocks& blocks, FFProcesses& processes, const FFBlocks::Results& results)
  {
    FFRun& run = processes.GetRun();
    std::optional<std::vector<bool>> duplicates;
    FFHullResult hull;
    vtkIdType first = processes.GetRank(); // streams are in this order
    if (isStreamed)
    {
      FFHullStream stream(this, inputVector[0]->GetInformationObject(0),
        outputVector->GetInformationObject(0), run,
        " of process " + std::to_string(processes.GetRank()));
      readPieces(stream, processes, hull);
    }
    else
    {
      FFInput input;
      readPoints(this, blocks, processes, input);
      input.TakeCoordinates();
      hull.Take(input, this->PassPointData, run);
      first = input.GetView().count > 0 ? run.GetId(0) : VTK_ID_MAX;
    }
    join(this, isStreamed || blocks.size() == 1, first, processes, hull, duplicates);
    vtkPolyData* const output = vtkPolyData::SafeDownCast(results[0]);
    if (processes.GetRank() == 0 || duplicates)
    {
      this->WriteHull(hull, output, run);
    }
    if (duplicates)
    {
      FFDistributedCells::Mark(
        output->GetPointData(), *duplicates, vtkDataSetAttributes::DUPLICATEPOINT);
    }
    processes.Agree(); // nobody has a hull that another could not write
  };
  return FFDistributedInput::Run(
    whole, this->Controller, this->IsJoined(), inputVector, outputVector, [] {}, work);
}

//------------------------------------------------------------------------------
void vtkPFFHullFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller.Get() << "\n";
  os << indent << "ResultMode: " << this->ResultMode << "\n";
  os << indent << "GatheredPointsLimit: " << this->GatheredPointsLimit << "\n";
}
VTK_ABI_NAMESPACE_END
