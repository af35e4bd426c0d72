// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFAlgorithm.h"

#include "vtkFFAlgorithmInternals.h"
#include "vtkFFFailure.h"
#include "vtkFFOutput.h"
#include <flipflop/CellComplex.h>
#include <flipflop/Engines.h>
#include <flipflop/Options.h>

#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <atomic>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

/// Of all classes: with the last, what is kept for the next run goes.
std::atomic<int> filterCount{ 0 };

}

//------------------------------------------------------------------------------
vtkFFAlgorithm::vtkFFAlgorithm()
  : Engine(ENGINE_AUTOMATIC)
  , CUDAThreshold(VTK_ID_MAX)
  , NumberOfThreads(0)
  , FacetMode(FACETS_AS_TRIANGLES)
  , NonFinitePoints(NON_FINITE_ERROR)
  , SkipGhostPoints(true)
  , PassPointData(true)
  , VisiblePointIds(false)
  , ReportAsFieldData(false)
  , VBiased(true)
{
  ++filterCount;
}

//------------------------------------------------------------------------------
vtkFFAlgorithm::~vtkFFAlgorithm()
{
  if (--filterCount == 0)
  {
    flipflop::releaseCudaMemory();
  }
}

//------------------------------------------------------------------------------
// The figures that a run reports, from its statistics s. This list is the only one.
// clang-format off
#define FF_FIGURES(figure)                                            \
  figure(vtkIdType, NumberOfInputPoints, s.points)                    \
  figure(vtkIdType, NumberOfNonFinitePoints, s.nonFinite)             \
  figure(vtkIdType, NumberOfCulledPoints, s.culled)                   \
  figure(vtkIdType, NumberOfInsertions, s.insertions)                 \
  figure(vtkIdType, NumberOfPointMoves, s.moves)                      \
  figure(vtkIdType, NumberOfFlips22, s.flips22)                       \
  figure(vtkIdType, NumberOfFlips31, s.flips31)                       \
  figure(vtkIdType, NumberOfFlipsByVolume, s.flipsV)                  \
  figure(vtkIdType, NumberOfFlipsByDegree, s.flipsD)                  \
  figure(vtkIdType, NumberOfLabelledVertices, s.labelled)             \
  figure(vtkIdType, NumberOfRedundantVertices, s.redundant)           \
  figure(vtkIdType, NumberOfEdgeChecks, s.edgeChecks)                 \
  figure(vtkIdType, NumberOfExactPredicates, s.exactCalls)            \
  figure(int, NumberOfThreadsUsed, s.threads)                         \
  figure(double, SecondsToScan, s.secondsScan)                        \
  figure(double, SecondsToLocate, s.secondsLocate + s.secondsCompact) \
  figure(double, SecondsToGrow, s.secondsGrow)                        \
  figure(double, SecondsToFlip, s.secondsFlip)                        \
  figure(double, SecondsToFinish, s.secondsFinish)                    \
  figure(double, SecondsTotal, s.secondsTotal)
// clang-format on

#define FF_GET(type, name, value)                                                                  \
  type vtkFFAlgorithm::Get##name()                                                                 \
  {                                                                                                \
    const flipflop::Statistics& s = this->Internals->GetStatistics();                              \
    return static_cast<type>(value);                                                               \
  }
FF_FIGURES(FF_GET)
#undef FF_GET

//------------------------------------------------------------------------------
void vtkFFAlgorithm::SetInternals(std::unique_ptr<vtkInternals> internals)
{
  this->Internals = std::move(internals);
  this->Internals->ResetReport();
}

//------------------------------------------------------------------------------
vtkFFAlgorithm::vtkInternals::vtkInternals(vtkFFAlgorithm* filter)
  : vtkFFGuard(filter)
  , Filter(filter)
{
}

//------------------------------------------------------------------------------
vtkFFAlgorithm::vtkInternals::~vtkInternals() = default;

//------------------------------------------------------------------------------
void vtkFFAlgorithm::vtkInternals::ResetReport()
{
  this->Filter->SetErrorCode(vtkErrorCode::NoError);
  this->Filter->EngineUsed = ENGINE_NONE;
  this->EngineReason = "no engine has run";
  this->Filter->Dimension = -1;

  this->Statistics = flipflop::Statistics();
  this->NonFinitePointsOfFailure = 0;
  this->SetProgressRange(0.0, 1.0);
}

//------------------------------------------------------------------------------
void vtkFFAlgorithm::vtkInternals::ReduceReportToFailure()
{
  const unsigned long code = this->Filter->GetErrorCode();
  const vtkIdType nonFinite = this->NonFinitePointsOfFailure;
  this->ResetReport();
  this->Filter->SetErrorCode(code);
  this->Statistics.nonFinite = nonFinite;
}

//------------------------------------------------------------------------------
void vtkFFAlgorithm::vtkInternals::AddToReport(
  const flipflop::CellComplex& cells, const flipflop::EngineReport& engine, vtkPolyData* output)
{
  this->Filter->Dimension = std::max(this->Filter->Dimension, cells.dimension);
  const int used = engine.used == flipflop::EngineChoice::CUDA ? ENGINE_CUDA : ENGINE_CPU;
  if (used >= this->Filter->EngineUsed)
  {
    this->Filter->EngineUsed = used;
    this->EngineReason = engine.reason;
  }

  const flipflop::Statistics& statistics = cells.statistics;
  this->Statistics += statistics;
  if (this->Filter->ReportAsFieldData)
  {
    vtkFieldData* data = output->GetFieldData();
    vtkFFOutput::AddValue(data, "FlipFlopDimension", cells.dimension);
    vtkFFOutput::AddValue(data, "FlipFlopInputPoints", statistics.points);
    vtkFFOutput::AddValue(data, "FlipFlopNonFinitePoints", statistics.nonFinite);
    vtkFFOutput::AddValue(data, "FlipFlopEngine", used == ENGINE_CUDA ? "CUDA" : "CPU");
    vtkFFOutput::AddValue(data, "FlipFlopEngineReason", engine.reason);
    vtkFFOutput::AddValue(data, "FlipFlopThreads", statistics.threads);
    vtkFFOutput::AddValue(data, "FlipFlopSeconds", statistics.secondsTotal);
  }
}

//------------------------------------------------------------------------------
bool vtkFFAlgorithm::vtkInternals::RunEngine(const EngineWork& work)
{
  vtkFFFailure failure;
  const bool done = this->TryEngine(work, failure);
  this->ReportFailure(failure);
  return done;
}

//------------------------------------------------------------------------------
bool vtkFFAlgorithm::vtkInternals::TryEngine(const EngineWork& work, vtkFFFailure& failure)
{
  const auto guarded = [&]()
  {
    flipflop::Options options = this->MakeOptions(this->Filter->NumberOfThreads);
    options.facets = this->Filter->FacetMode == FACETS_AS_POLYGONS ? flipflop::FacetMode::Polygons
                                                                   : flipflop::FacetMode::Triangles;
    options.nonFinite = this->Filter->NonFinitePoints == NON_FINITE_IGNORE
      ? flipflop::NonFinitePolicy::Ignore
      : flipflop::NonFinitePolicy::Error;
    options.vBiased = this->Filter->VBiased;
    flipflop::EngineOptions engine;
    engine.choice = this->Filter->Engine == ENGINE_CUDA ? flipflop::EngineChoice::CUDA
      : this->Filter->Engine == ENGINE_CPU              ? flipflop::EngineChoice::CPU
                                                        : flipflop::EngineChoice::Automatic;
    // VTK_INT_MAX is as much as a panel of ParaView can say.
    engine.cudaFrom = this->Filter->CUDAThreshold >= VTK_INT_MAX ? flipflop::CudaPaysNever
                                                                 : this->Filter->CUDAThreshold;
    flipflop::EngineReport report;
    work(options, engine, report);
  };
  return this->Try(guarded, failure);
}

//------------------------------------------------------------------------------
void vtkFFAlgorithm::vtkInternals::SetErrorCode(unsigned long code)
{
  this->Filter->SetErrorCode(code);
}

//------------------------------------------------------------------------------
void vtkFFAlgorithm::vtkInternals::MarkAborted()
{
  // The pipeline is to know that the output is not whole, where another process was aborted, too:
  // all run again, or none.
#if VTK_FF_HAS_CHECK_ABORT
  this->Filter->SetAbortOutput(true);
#endif
}

//------------------------------------------------------------------------------
void vtkFFAlgorithm::vtkInternals::NoteNonFinite(vtkIdType count)
{
  this->NonFinitePointsOfFailure = count;
  this->Statistics.nonFinite += count;
}

//------------------------------------------------------------------------------
std::string vtkFFAlgorithm::vtkInternals::DescribePoint(vtkIdType place)
{
  for (const Block& block : this->CurrentBlocks)
  {
    if (place < block.NumberOfPoints)
    {
      return "point " + std::to_string(place) + vtkFFGuard::OfBlockAt(block.FlatIndex);
    }
    place -= block.NumberOfPoints;
  }
  return "point " + std::to_string(place);
}

//------------------------------------------------------------------------------
std::string vtkFFAlgorithm::vtkInternals::OfBlock()
{
  return this->CurrentBlocks.size() == 1 ? vtkFFGuard::OfBlockAt(this->CurrentBlocks[0].FlatIndex)
                                         : std::string();
}

//------------------------------------------------------------------------------
bool vtkFFAlgorithm::IsCUDAAvailable()
{
  return flipflop::cudaStatus().present;
}

//------------------------------------------------------------------------------
const char* vtkFFAlgorithm::GetCUDADeviceName()
{
  return flipflop::cudaStatus().device;
}

//------------------------------------------------------------------------------
const char* vtkFFAlgorithm::GetCUDAProblem()
{
  return flipflop::cudaStatus().problem;
}

//------------------------------------------------------------------------------
const char* vtkFFAlgorithm::GetEngineAsString()
{
  return this->Engine == ENGINE_CUDA ? "CUDA" : this->Engine == ENGINE_CPU ? "CPU" : "Automatic";
}

//------------------------------------------------------------------------------
const char* vtkFFAlgorithm::GetEngineUsedAsString()
{
  return this->EngineUsed == ENGINE_CUDA ? "CUDA" : this->EngineUsed == ENGINE_CPU ? "CPU" : "None";
}

//------------------------------------------------------------------------------
const char* vtkFFAlgorithm::GetEngineReason()
{
  return this->Internals->GetEngineReason();
}

//------------------------------------------------------------------------------
const char* vtkFFAlgorithm::GetFacetModeAsString()
{
  return this->FacetMode == FACETS_AS_POLYGONS ? "Polygons" : "Triangles";
}

//------------------------------------------------------------------------------
const char* vtkFFAlgorithm::GetNonFinitePointsAsString()
{
  return this->NonFinitePoints == NON_FINITE_IGNORE ? "Ignore" : "Error";
}

//------------------------------------------------------------------------------
void vtkFFAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);

  const auto onOff = [](bool flag) { return flag ? "On" : "Off"; };
  os << indent << "Engine: " << this->GetEngineAsString() << "\n";
  os << indent << "CUDAThreshold: " << this->CUDAThreshold << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "FacetMode: " << this->GetFacetModeAsString() << "\n";
  os << indent << "NonFinitePoints: " << this->GetNonFinitePointsAsString() << "\n";
  os << indent << "SkipGhostPoints: " << onOff(this->SkipGhostPoints) << "\n";
  os << indent << "PassPointData: " << onOff(this->PassPointData) << "\n";
  os << indent << "VisiblePointIds: " << onOff(this->VisiblePointIds) << "\n";
  os << indent << "ReportAsFieldData: " << onOff(this->ReportAsFieldData) << "\n";
  os << indent << "VBiased: " << onOff(this->VBiased) << "\n";
  os << indent << "EngineUsed: " << this->GetEngineUsedAsString() << "\n";
  os << indent << "EngineReason: " << this->GetEngineReason() << "\n";
  os << indent << "Dimension: " << this->Dimension << "\n";
#define FF_PRINT(type, name, value) os << indent << #name ": " << this->Get##name() << "\n";
  FF_FIGURES(FF_PRINT)
#undef FF_PRINT
}
VTK_ABI_NAMESPACE_END
