// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFAlgorithm.h"

#include "vtkFFAlgorithmInternals.h"
#include "vtkFFExactValues.h"
#include "vtkFFFailure.h"
#include "vtkFFOutput.h"
#include <flipflop/CellComplex.h>
#include <flipflop/Engines.h>
#include <flipflop/Error.h>
#include <flipflop/Options.h>

#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <new>
#include <utility>

// ParaView 5.11 carries a VTK 9.2 that has CheckAbort() already.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20230000)
#define VTK_FF_HAS_CHECK_ABORT 1
#else
#define VTK_FF_HAS_CHECK_ABORT 0
#endif

VTK_ABI_NAMESPACE_BEGIN
namespace
{

/// Empty for the block that is the whole input.
std::string ofBlock(unsigned int flatIndex)
{
  return flatIndex ? " of the block of flat index " + std::to_string(flatIndex) : std::string();
}

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
  : Filter(filter)
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
void vtkFFAlgorithm::vtkInternals::ReportError(const std::string& message)
{
  this->Filter->SetErrorCode(vtkErrorCode::UserError);
  vtkErrorWithObjectMacro(this->Filter, << message);
}

//------------------------------------------------------------------------------
void vtkFFAlgorithm::vtkInternals::ReportFailure(const vtkFFFailure& failure, bool aloud)
{
  if (failure.Kind == vtkFFFailure::None)
  {
    return;
  }
  if (failure.Kind == vtkFFFailure::Aborted)
  {
    // The pipeline is to know that the output is not whole, where another process was aborted, too:
    // all run again, or none.
#if VTK_FF_HAS_CHECK_ABORT
    this->Filter->SetAbortOutput(true);
#endif
    return;
  }
  if (!aloud)
  {
    this->Filter->SetErrorCode(vtkErrorCode::UserError);
  }
  else if (failure.Kind == vtkFFFailure::NonFinite)
  {
    this->NonFinitePointsOfFailure = failure.Count;
    this->Statistics.nonFinite = failure.Count;
    this->ReportError(this->DescribeError(
      flipflop::Error(flipflop::ErrorCode::NonFinite, failure.Place, failure.Count)));
  }
  else
  {
    this->ReportError(failure.Message);
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
  try
  {
    flipflop::Options options;
    options.threads = this->Filter->NumberOfThreads > 0
      ? this->Filter->NumberOfThreads
      : vtkSMPTools::GetEstimatedNumberOfThreads();
    options.facets = this->Filter->FacetMode == FACETS_AS_POLYGONS ? flipflop::FacetMode::Polygons
                                                                   : flipflop::FacetMode::Triangles;
    options.nonFinite = this->Filter->NonFinitePoints == NON_FINITE_IGNORE
      ? flipflop::NonFinitePolicy::Ignore
      : flipflop::NonFinitePolicy::Error;
    options.vBiased = this->Filter->VBiased;
    options.progress = &vtkInternals::ForwardProgress;
    options.progressContext = this;
    flipflop::EngineOptions engine;
    engine.choice = this->Filter->Engine == ENGINE_CUDA ? flipflop::EngineChoice::CUDA
      : this->Filter->Engine == ENGINE_CPU              ? flipflop::EngineChoice::CPU
                                                        : flipflop::EngineChoice::Automatic;
    // VTK_INT_MAX is as much as a panel of ParaView can say.
    engine.cudaFrom = this->Filter->CUDAThreshold >= VTK_INT_MAX ? flipflop::CudaPaysNever
                                                                 : this->Filter->CUDAThreshold;
    flipflop::EngineReport report;
    work(options, engine, report);
    return true;
  }
  catch (const flipflop::Error& error)
  {
    switch (error.code())
    {
      case flipflop::ErrorCode::NonFinite:
        failure.Kind = vtkFFFailure::NonFinite;
        failure.Place = this->GetPlaceOfPoint(static_cast<vtkIdType>(error.index()));
        failure.Count = static_cast<vtkIdType>(error.count());
        return false;
      case flipflop::ErrorCode::Aborted:
        failure.Kind = vtkFFFailure::Aborted;
        return false;
      default:
        failure.Say(this->DescribeError(error));
        break;
    }
  }
  catch (const vtkFFInexactValue& error)
  {
    const std::string kind = error.GetKind();
    failure.Say("A " + kind + " is a 64-bit integer that no double holds: first at " +
      this->DescribePoint(this->GetPlaceOfPoint(error.GetIndex())) +
      ". Subtract an offset from every " + kind + ": the result has the same shape.");
  }
  catch (const std::bad_alloc&)
  {
    failure.Say("There is not enough memory for this input.");
  }
  catch (const std::exception& error)
  {
    failure.Say(error.what());
  }
  catch (...)
  {
    failure.Say("The engine failed for an unknown reason.");
  }
  return false;
}

//------------------------------------------------------------------------------
void vtkFFAlgorithm::vtkInternals::SetProgressRange(double begin, double end)
{
  this->ProgressRange[0] = begin;
  this->ProgressRange[1] = end;
  this->SetProgressPart(0.0, 1.0);
  this->ProgressReached = begin;
}

//------------------------------------------------------------------------------
void vtkFFAlgorithm::vtkInternals::SetProgressPart(double begin, double end)
{
  this->ProgressPart[0] = begin;
  this->ProgressPart[1] = end;
}

//------------------------------------------------------------------------------
bool vtkFFAlgorithm::vtkInternals::ForwardProgress(double fraction, void* self)
{
  auto* internals = static_cast<vtkInternals*>(self);
  const double* range = internals->ProgressRange;
  const double* part = internals->ProgressPart;
  const double inRange = part[0] + fraction * (part[1] - part[0]);
  // Never back: a run that the CUDA engine gave up starts anew on the CPU.
  internals->ProgressReached =
    std::max(internals->ProgressReached, range[0] + inRange * (range[1] - range[0]));
  internals->Filter->UpdateProgress(internals->ProgressReached);
  return !internals->IsAbortRequested();
}

//------------------------------------------------------------------------------
bool vtkFFAlgorithm::vtkInternals::IsAbortRequested()
{
#if VTK_FF_HAS_CHECK_ABORT
  return this->Filter->CheckAbort();
#else
  return this->Filter->GetAbortExecute() != 0;
#endif
}

//------------------------------------------------------------------------------
void vtkFFAlgorithm::vtkInternals::NoteAbort(vtkFFFailure& failure)
{
  if (failure.Kind == vtkFFFailure::None && this->IsAbortRequested())
  {
    failure.Kind = vtkFFFailure::Aborted;
  }
}

//------------------------------------------------------------------------------
std::string vtkFFAlgorithm::vtkInternals::DescribePoint(vtkIdType place)
{
  for (const Block& block : this->CurrentBlocks)
  {
    if (place < block.NumberOfPoints)
    {
      return "point " + std::to_string(place) + ofBlock(block.FlatIndex);
    }
    place -= block.NumberOfPoints;
  }
  return "point " + std::to_string(place);
}

//------------------------------------------------------------------------------
std::string vtkFFAlgorithm::vtkInternals::OfBlock()
{
  return this->CurrentBlocks.size() == 1 ? ofBlock(this->CurrentBlocks[0].FlatIndex)
                                         : std::string();
}

//------------------------------------------------------------------------------
std::string vtkFFAlgorithm::vtkInternals::DescribeNonFinite(
  const std::string& what, const flipflop::Error& error)
{
  return what + " is NaN or infinite: first at " +
    this->DescribePoint(static_cast<vtkIdType>(error.index())) + ", " +
    std::to_string(error.count()) + " such point(s) in all.";
}

//------------------------------------------------------------------------------
std::string vtkFFAlgorithm::vtkInternals::DescribeError(const flipflop::Error& error)
{
  using flipflop::ErrorCode;
  const auto index = static_cast<vtkIdType>(error.index());
  const std::string count = std::to_string(error.count());
  const std::string cell = "cell " + std::to_string(index) + this->OfBlock();
  switch (error.code())
  {
    case ErrorCode::NonFinite:
      return this->DescribeNonFinite("A coordinate", error) +
        " Remove them, or have them ignored: NonFinitePoints, SetNonFinitePointsToIgnore().";
    case ErrorCode::TooManyPoints:
      return count + " points are more than 32-bit indices can name.";
    case ErrorCode::OutOfMemory:
      return "There is not enough memory for this input" +
        (error.count() > 0 ? ": " + count + " bytes were refused." : std::string("."));
    case ErrorCode::Aborted:
      return "The run was aborted.";
    case ErrorCode::BadArgument:
      return "The engine was called with an invalid argument.";
    case ErrorCode::WeightCount:
      return "There are " + count + " weights, which is not the number of points.";
    case ErrorCode::BadTriangle:
      return "A triangle names a point that does not exist, or the same point twice: first at " +
        cell + ", " + count + " such triangle(s) in all.";
    case ErrorCode::NotClosed:
      return "The surface is not closed: first at " + cell +
        ", which has an edge that no other triangle shares; " + count + " such edge(s) in all.";
    case ErrorCode::NotManifold:
      return "The surface is not a manifold: first at " + cell +
        ", which has an edge of three or more triangles, or a vertex where several fans of "
        "triangles meet; " +
        count + " such edge(s) and vertices in all.";
    case ErrorCode::NotOriented:
      return "The surface is not oriented consistently: first at " + cell +
        ", whose neighbour runs their shared edge the same way. vtkPolyDataNormals can mend that.";
    case ErrorCode::NotStarShaped:
      return "The surface is not star-shaped: the kernel point does not see the inside of " + cell +
        "; " + count + " such triangle(s) in all.";
    case ErrorCode::NoKernel:
      return "The surface" + this->OfBlock() +
        " is not star-shaped, or no point was found from which it is. Give one with "
        "SetKernelPoint().";
    case ErrorCode::NoDevice:
      return std::string("The CUDA engine was asked for, but ") + vtkFFAlgorithm::GetCUDAProblem() +
        ". Use SetEngineToAutomatic() or SetEngineToCPU().";
    case ErrorCode::DeviceMemory:
      return "The CUDA device has not enough memory for this input: " + count +
        " bytes were refused. Use SetEngineToAutomatic() or SetEngineToCPU().";
    case ErrorCode::DeviceFailed:
      return "The CUDA device failed: error " + std::to_string(index) +
        " of the CUDA runtime. Use SetEngineToAutomatic() or SetEngineToCPU().";
    case ErrorCode::Internal:
      return "An internal error: please report it, with the input.";
  }
  return error.what();
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
