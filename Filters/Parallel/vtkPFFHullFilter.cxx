// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPFFHullFilter.h"

#include "FFDistributedCells.h"
#include "FFDistributedInput.h"
#include "FFDistributedPoints.h"
#include "FFHullResult.h"
#include "FFInput.h"
#include "FFOutput.h"
#include "FFPointMessage.h"
#include "FFPointRedistribution.h"
#include "FFProcesses.h"
#include "FFRun.h"

#include <flipflop/Engines.h>

#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkPFFHullFilter);
vtkCxxSetObjectMacro(vtkPFFHullFilter, Controller, vtkMultiProcessController);

namespace
{

using Blocks = std::vector<FFDistributedInput::BlockType>;
using Point = FFPointRedistribution::Point;

/// Reads the points of all blocks. They are counted block by block, and in a block process by
/// process. Returns the first id of each block's points here. Collective.
std::vector<vtkIdType> readPoints(vtkPFFHullFilter* filter, const Blocks& blocks,
  FFProcesses& processes, std::vector<FFInput>& inputs)
{
  FFRun& run = processes.GetRun();
  bool isComposite = false;
  std::vector<vtkIdType> sizes;
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    inputs[b].TakePieces(blocks[b].Pieces, filter->GetSkipGhostPoints(), run);
    isComposite = isComposite || blocks[b].FlatIndex > 0;
    sizes.push_back(0);
    for (const auto& piece : inputs[b].GetPieces())
    {
      sizes.back() += piece->GetNumberOfPoints();
    }
  }
  run.Ids.clear(); // ids count the remaining points
  run.Parts.clear();
  const std::vector<std::vector<vtkIdType>> all = processes.Gather(sizes);
  const auto rank = static_cast<std::size_t>(processes.GetRank());
  std::vector<vtkIdType> begins;
  vtkIdType counted = 0;
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    const vtkIdType begin = counted;
    for (std::size_t process = 0; process < all.size(); ++process)
    {
      if (process == rank)
      {
        begins.push_back(counted);
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
  return begins;
}

/// The hulls of all processes become that of process 0: joined in pairs, along a binary tree.
/// Collective.
void gather(FFHullResult& hull, FFProcesses& processes)
{
  // Neighbours, then neighbours' neighbours. The lower one of a pair goes on.
  const int rank = processes.GetRank();
  for (int step = 1; step < processes.GetCount(); step *= 2)
  {
    const int remainder = rank % (2 * step);
    FFProcesses::Messages messages;
    hull.KeepKind();
    if (remainder == step)
    {
      messages[rank - step] = FFPointMessage::Pack(hull.Data);
    }
    processes.Exchange(messages);
    if (remainder == 0 && rank + step < processes.GetCount())
    {
      std::vector<FFHullResult> pair(2);
      std::swap(pair[0], hull);
      pair[1].Data = FFPointMessage::Unpack(messages[rank + step]);
      hull.Join(pair, processes.GetRun());
    }
  }
}

/// The direction in which a point lies, by the octahedral map: the faces of an octahedron, laid out
/// in a square.
FFPointRedistribution::Key directionOf(const double* x, const std::array<double, 3>& middle)
{
  double d[3];
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    d[k] = 0.5 * x[k] - 0.5 * middle[k]; // the whole may overflow
    sum += std::fabs(d[k]);
  }
  if (!(sum > 0.0) || !std::isfinite(sum))
  {
    return {};
  }
  const double u = d[0] / sum;
  const double v = d[1] / sum;
  // The lower faces are folded up, outside the upper ones. 0 and -0 are one position.
  return d[2] >= 0.0 ? FFPointRedistribution::Key{ u + 0.0, v + 0.0 }
                     : FFPointRedistribution::Key{ (u >= 0.0 ? 1.0 : -1.0) * (1.0 - std::fabs(v)),
                         (v >= 0.0 ? 1.0 : -1.0) * (1.0 - std::fabs(u)) };
}

/// The middle of the box of all processes' points.
std::array<double, 3> middleOf(const std::vector<Point>& points, FFProcesses& processes)
{
  std::vector<double> box(6, std::numeric_limits<double>::infinity()); // least x, y, z; of -x, ...
  for (const Point& point : points)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      box[k] = std::min(box[k], point.Position[k]);
      box[k + 3] = std::min(box[k + 3], -point.Position[k]);
    }
  }
  box = processes.Least(box);
  std::array<double, 3> middle;
  for (std::size_t k = 0; k < 3; ++k)
  {
    middle[k] = 0.5 * box[k] - 0.5 * box[k + 3];
  }
  return middle;
}

/// The finite ones of points whose ids begin there.
std::vector<Point> finitePoints(vtkPointSet* data, vtkIdType begin)
{
  std::vector<Point> points;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    Point point;
    data->GetPoint(i, point.Position);
    point.Id = begin + i;
    if (std::all_of(point.Position, point.Position + 3, [](double x) { return std::isfinite(x); }))
    {
      points.push_back(point);
    }
  }
  return points;
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
  std::vector<Point> points = finitePoints(hull.Data, source.GetBegin());
  const std::array<double, 3> middle = middleOf(points, processes);
  flipflop::BlockPoints block = FFPointRedistribution::Run(
    std::move(points), [&](const Point& point) { return directionOf(point.Position, middle); },
    processes);
  flipflop::Options options = processes.GetRun().Options;
  options.facets = flipflop::FacetMode::Polygons; // as of each FFHullResult
  double size[2];
  flipflop::BlockResult result = FFDistributedCells::Compute(
    flipflop::BlockShape::Hull, std::move(block), options, processes, size);

  flipflop::CellComplex& cells = result.cells;
  const auto fetched = source.Fetch({ cells.pointIds.begin(), cells.pointIds.end() }, true);
  const auto duplicates =
    FFDistributedCells::FindDuplicates(cells.pointIds, result.blocks, processes);
  if (cells.pointIds.empty())
  {
    // One point of the kind, which is left out.
    fetched->GetPoints()->SetNumberOfPoints(0);
    fetched->GetPointData()->SetNumberOfTuples(0);
  }
  hull.Data = vtkSmartPointer<vtkPolyData>::New();
  hull.Data->SetPoints(fetched->GetPoints());
  hull.Data->GetPointData()->ShallowCopy(fetched->GetPointData());
  hull.Hull.dimension = cells.dimension;
  hull.Hull.volume = size[0];
  hull.Hull.area = size[1];
  hull.Hull.statistics += cells.statistics;
  FFOutput::AdoptCells(cells, hull.Data);
  return duplicates;
}

/// Whether each process keeps a share of a hull, of which it has its piece's. Collective.
bool staysDistributed(vtkPFFHullFilter* filter, const FFHullResult& hull, FFProcesses& processes)
{
  const vtkIdType points = processes.Sum(hull.Data->GetNumberOfPoints());
  const int mode = filter->GetResultMode();
  return mode == vtkPFFHullFilter::RESULT_DISTRIBUTED ||
    (mode == vtkPFFHullFilter::RESULT_AUTOMATIC && points > filter->GetGatheredPointsLimit());
}

/// The hull of what this process has becomes that of what all have: on process 0; or a share on
/// each, and whether another process counts each of its points. Collective.
void join(vtkPFFHullFilter* filter, bool mayStay, FFProcesses& processes, FFHullResult& hull,
  std::optional<std::vector<bool>>& duplicates)
{
  const flipflop::Statistics& statistics = hull.Hull.statistics;
  const std::vector<vtkIdType> counts = processes.Sum(
    { static_cast<vtkIdType>(statistics.points), static_cast<vtkIdType>(statistics.nonFinite) });
  if (mayStay && staysDistributed(filter, hull, processes))
  {
    duplicates = distribute(hull, processes);
  }
  else
  {
    gather(hull, processes);
  }
  hull.Hull.statistics.points = counts[0];
  hull.Hull.statistics.nonFinite = counts[1];
}

/// The hull of each block's points. Collective.
std::vector<FFHullResult> hullsOf(vtkPFFHullFilter* filter, const Blocks& blocks,
  FFProcesses& processes, std::optional<std::vector<bool>>& duplicates)
{
  FFRun& run = processes.GetRun();
  const std::size_t count = blocks.size();
  std::vector<FFInput> inputs(count);
  const std::vector<vtkIdType> begins = readPoints(filter, blocks, processes, inputs);

  // Points that are not finite are counted to the last block before they are an error.
  std::vector<FFHullResult> hulls(count);
  FFFailure failure;
  for (std::size_t b = 0; b < count && failure.Kind <= FFFailure::NonFinite; ++b)
  {
    run.SetPart(static_cast<double>(b) / static_cast<double>(count),
      static_cast<double>(b + 1) / static_cast<double>(count));
    run.FirstId = begins[b];
    run.Failure = FFFailure();
    processes.Do(
      [&]
      {
        inputs[b].TakeCoordinates();
        hulls[b].Take(inputs[b], filter->GetPassPointData(), run);
        join(filter, count == 1, processes, hulls[b], duplicates);
      });
    failure.Add(run.Failure);
  }
  run.Failure = failure;
  if (failure)
  {
    throw FFSharedFailure();
  }
  return hulls;
}

/// Adds what other processes have read to this process's ids, and to the parts. Collective.
void countPieces(FFHullResult& hull, FFProcesses& processes)
{
  FFRun& run = processes.GetRun();
  std::vector<vtkIdType> own; // numbers of points, and blocks
  for (const FFRun::PartType& part : run.Parts)
  {
    own.insert(own.end(), { part.NumberOfPoints, static_cast<vtkIdType>(part.FlatIndex) });
  }
  if (own.empty())
  {
    own = { run.FirstId, 0 };
  }
  const std::vector<std::vector<vtkIdType>> all = processes.Gather(own);
  const auto rank = static_cast<std::size_t>(processes.GetRank());
  run.Parts.clear();
  bool isComposite = false;
  vtkIdType counted = 0;
  for (std::size_t process = 0; process < all.size(); ++process)
  {
    if (process == rank)
    {
      FFOutput::Renumber(
        hull.Data->GetPointData(), [counted](vtkIdType id) { return counted + id; });
    }
    for (std::size_t k = 0; k < all[process].size(); k += 2)
    {
      const auto block = static_cast<unsigned int>(all[process][k + 1]);
      run.Parts.push_back({ all[process][k], {}, block });
      isComposite = isComposite || block > 0;
      counted += all[process][k];
    }
  }
  if (!isComposite)
  {
    run.Parts.clear();
  }
}

/// The hull of the points that all processes read, a piece at a time. Collective.
FFHullResult hullOf(vtkPFFHullFilter* filter, FFHullStream& stream, FFProcesses& processes,
  std::optional<std::vector<bool>>& duplicates)
{
  // As many steps on each process: sources may work together, and what fails on one ends all.
  FFHullResult hull;
  const vtkIdType steps = -processes.Least(std::vector<vtkIdType>{ -stream.GetCount() })[0];
  for (int number = 0; number < steps; ++number)
  {
    if (number < stream.GetCount())
    {
      stream.TakePiece(number, hull);
    }
    processes.Agree();
  }
  countPieces(hull, processes);
  join(filter, true, processes, hull, duplicates);
  return hull;
}

}

//------------------------------------------------------------------------------
vtkPFFHullFilter::vtkPFFHullFilter()
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

//------------------------------------------------------------------------------
vtkPFFHullFilter::~vtkPFFHullFilter()
{
  this->SetController(nullptr);
  flipflop::releaseCudaMemory(); // of this library's copy of the engine
}

//------------------------------------------------------------------------------
int vtkPFFHullFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(
    vtkAlgorithm::INPUT_IS_OPTIONAL(), 1); // where a process has none, the others would wait
  return this->Superclass::FillInputPortInformation(port, info);
}

//------------------------------------------------------------------------------
int vtkPFFHullFilter::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!FFProcesses::AreSeveral(this->Controller))
  {
    return this->Superclass::RequestData(request, inputVector, outputVector);
  }
  FFRun all(this, this->GetTitle());
  const bool isStreamed = this->NumberOfStreamDivisions > 1;
  const auto work =
    [&](const Blocks& blocks, FFProcesses& processes, const FFBlocks::Results& results)
  {
    FFRun& run = processes.GetRun();
    std::optional<std::vector<bool>> duplicates;
    std::vector<FFHullResult> hulls;
    if (isStreamed)
    {
      FFHullStream stream(this, inputVector[0]->GetInformationObject(0),
        outputVector->GetInformationObject(0), run,
        " of process " + std::to_string(processes.GetRank()));
      hulls.push_back(hullOf(this, stream, processes, duplicates));
    }
    else
    {
      hulls = hullsOf(this, blocks, processes, duplicates);
    }
    const bool hasHull = processes.GetRank() == 0 || duplicates;
    FFHullResult whole;
    vtkPolyData* const output = vtkPolyData::SafeDownCast(results[0]);
    if (hasHull)
    {
      if (hulls.size() == 1)
      {
        std::swap(whole, hulls[0]);
      }
      else
      {
        whole.Join(hulls, run);
      }
      this->WriteHull(whole, output, run);
      if (duplicates)
      {
        FFDistributedCells::Mark(
          output->GetPointData(), *duplicates, vtkDataSetAttributes::DUPLICATEPOINT);
      }
    }
    processes.Agree(); // nobody has a hull that another could not write
  };
  return FFDistributedInput::Run(
    all, this->Controller, this->IsJoined(), inputVector, outputVector, [] {}, work);
}

//------------------------------------------------------------------------------
void vtkPFFHullFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller << "\n";
  os << indent << "ResultMode: " << this->ResultMode << "\n";
  os << indent << "GatheredPointsLimit: " << this->GatheredPointsLimit << "\n";
}
VTK_ABI_NAMESPACE_END
