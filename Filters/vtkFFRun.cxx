// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFRun.h"

#include "vtkFFAlgorithm.h"
#include "vtkFFExactValues.h"
#include "vtkFFOutput.h"
#include "vtkFFQueryAlgorithm.h"

#include <flipflop/CellComplex.h>
#include <flipflop/Error.h>
#include <flipflop/Weights.h>

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <exception>
#include <new>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

std::string capitalized(std::string text)
{
  text[0] = static_cast<char>(std::toupper(text[0]));
  return text;
}

/// What an error of the engine is about.
unsigned long codeOf(flipflop::ErrorCode code)
{
  using flipflop::ErrorCode;
  switch (code)
  {
    case ErrorCode::NonFinite:
      return vtkFFErrorCode::NonFiniteError;
    case ErrorCode::TooManyPoints:
    case ErrorCode::OutOfMemory:
      return vtkFFErrorCode::MemoryError;
    case ErrorCode::BadTriangle:
    case ErrorCode::NotSimple:
    case ErrorCode::NotClosed:
    case ErrorCode::NotManifold:
    case ErrorCode::NotOriented:
    case ErrorCode::NotStarShaped:
    case ErrorCode::NoKernel:
      return vtkFFErrorCode::SurfaceError;
    case ErrorCode::ConstraintPoint:
    case ErrorCode::ConstraintsCross:
    case ErrorCode::PolygonsDisagree:
      return vtkFFErrorCode::ConstraintError;
    case ErrorCode::NoDevice:
    case ErrorCode::DeviceMemory:
    case ErrorCode::DeviceFailed:
      return vtkFFErrorCode::DeviceError;
    case ErrorCode::Internal:
      return vtkFFErrorCode::InternalError;
    default:
      return vtkFFErrorCode::InputError;
  }
}

/// As vtkFFAlgorithm::SetNumberOfThreads() says; the engine takes 0 for all of the machine's.
int threadsOf(int threads)
{
  return threads > 0 ? threads : threads < 0 ? 0 : vtkSMPTools::GetEstimatedNumberOfThreads();
}

}

//------------------------------------------------------------------------------
vtkFFRun::vtkFFRun(vtkAlgorithm* filter, const char* title, int threads,
  vtkInformationVector* outputs, std::function<void(unsigned long)> setCode)
  : Filter(filter)
  , Title(title)
  , Outputs(outputs)
  , SetCode(std::move(setCode))
{
  for (int port = 0; outputs && port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    // The executive passed the input's field data.
    vtkFFOutput::RemoveReport(vtkDataObject::GetData(outputs, port)->GetFieldData());
  }
  this->Options.threads = threadsOf(threads);
  this->Options.progress = &vtkFFRun::ForwardProgress;
  this->Options.progressContext = this;
  this->Options.step = &vtkFFRun::ForwardStep;
  filter->SetProgressText(title);
}

//------------------------------------------------------------------------------
vtkFFRun::vtkFFRun(vtkFFAlgorithm* filter, const char* title, vtkInformationVector* outputs)
  : vtkFFRun(filter, title, filter->GetNumberOfThreads(), outputs,
      [filter](unsigned long code) { filter->SetErrorCode(code); })
{
  this->Reporter = filter;
  this->Options.facets = filter->GetFacetMode() == vtkFFAlgorithm::FACETS_AS_POLYGONS
    ? flipflop::FacetMode::Polygons
    : flipflop::FacetMode::Triangles;
  this->Options.nonFinite = filter->GetNonFinitePoints() == vtkFFAlgorithm::NON_FINITE_IGNORE
    ? flipflop::NonFinitePolicy::Ignore
    : flipflop::NonFinitePolicy::Error;
  this->Options.vBiased = filter->GetVBiased();
  const int engine = filter->GetEngine();
  this->Engine.choice = engine == vtkFFAlgorithm::ENGINE_CUDA ? flipflop::EngineChoice::CUDA
    : engine == vtkFFAlgorithm::ENGINE_CPU                    ? flipflop::EngineChoice::CPU
                                                              : flipflop::EngineChoice::Automatic;
  // VTK_INT_MAX is as much as a panel of ParaView can say.
  this->Engine.cudaFrom = filter->GetCUDAThreshold() >= VTK_INT_MAX ? flipflop::CudaPaysNever
                                                                    : filter->GetCUDAThreshold();
  if (outputs && !this->Begin(filter->LastBlock, filter->IsAborted))
  {
    filter->EngineUsed = vtkFFAlgorithm::ENGINE_NONE;
    filter->EngineReason = "no engine has run";
    filter->Dimension = -1;
    filter->NumberOfInputPoints = 0;
    filter->NumberOfNonFinitePoints = 0;
    filter->ForgetReport();
  }
}

//------------------------------------------------------------------------------
vtkFFRun::vtkFFRun(vtkFFQueryAlgorithm* filter, const char* title, vtkInformationVector* outputs)
  : vtkFFRun(filter, title, filter->GetNumberOfThreads(), outputs,
      [filter](unsigned long code) { filter->SetErrorCode(code); })
{
  this->Options.nonFinite = filter->GetNonFinitePoints() == vtkFFQueryAlgorithm::NON_FINITE_IGNORE
    ? flipflop::NonFinitePolicy::Ignore
    : flipflop::NonFinitePolicy::Error;
  if (outputs && !this->Begin(filter->LastBlock, filter->IsAborted))
  {
    filter->Dimension = -1;
    filter->IsSecondAtFault = false;
  }
}

//------------------------------------------------------------------------------
bool vtkFFRun::Begin(vtkIdType& lastBlock, bool& isAborted)
{
  // The executive runs a filter data set by data set on a composite: of n, the progress of number k
  // is from k/n on.
  const double scale = this->Filter->GetProgressScale();
  const vtkIdType block = std::llround(this->Filter->GetProgressShift() / scale);
  const bool isNext = block > 0 && (block == lastBlock || block == lastBlock + 1);
  lastBlock = block;
  if (scale < 1.0 && (isNext || block == 0))
  {
    this->Block = " of data set " + std::to_string(block) + " of the composite";
  }
  this->Aborted = &isAborted;
  if (!isNext)
  {
    isAborted = false;
    this->SetCode(vtkFFErrorCode::NoError);
  }
  else if (isAborted)
  {
    this->Failure.Kind = vtkFFFailure::Aborted; // before VTK 9.3, the executive goes on
  }
  return isNext;
}

//------------------------------------------------------------------------------
bool vtkFFRun::Do(const std::function<void()>& work)
{
  return !this->Failure && this->Try(work, this->Failure);
}

//------------------------------------------------------------------------------
bool vtkFFRun::Try(const std::function<void()>& work, vtkFFFailure& failure)
{
  try
  {
    work();
    return true;
  }
  catch (const flipflop::BadWeight& error)
  {
    failure.Say(capitalized(error.what()) + ": first at " +
      this->DescribePoint(this->GetId(static_cast<vtkIdType>(error.index()))) +
      (error.fault() == flipflop::BadWeight::Fault::NegativeRadius
          ? ". Radii are lengths. If the array has weights, which may be negative, set Weight Mode "
            "to Weights."
          : ". Use another unit of length, or a smaller factor."));
  }
  catch (const flipflop::Error& error)
  {
    switch (error.code())
    {
      case flipflop::ErrorCode::NonFinite:
        failure.Kind = vtkFFFailure::NonFinite;
        failure.Place = this->GetId(static_cast<vtkIdType>(error.index()));
        failure.Count = static_cast<vtkIdType>(error.count());
        break;
      case flipflop::ErrorCode::Aborted:
        failure.Kind = vtkFFFailure::Aborted;
        break;
      default:
        failure.Say(this->DescribeError(error), codeOf(error.code()));
        break;
    }
  }
  catch (const vtkFFInexactValue& error)
  {
    const std::string kind = error.GetKind();
    failure.Say("A " + kind + " is a 64-bit integer that no double holds: first at " +
      this->DescribePoint(this->GetId(error.GetIndex())) +
      // Other disks have other radii, but weights may be shifted.
      (kind == "radius"
          ? ". Round the radii to doubles."
          : ". Subtract an offset from every " + kind + ": the result has the same shape."));
  }
  catch (const vtkFFBadSetting& error)
  {
    failure.Say(error.what(), vtkFFErrorCode::SettingError);
  }
  catch (const vtkFFBadConstraint& error)
  {
    failure.Say(error.what(), vtkFFErrorCode::ConstraintError);
  }
  catch (const std::bad_alloc&)
  {
    failure.Say("There is not enough memory for this input.", vtkFFErrorCode::MemoryError);
  }
  catch (const std::exception& error)
  {
    failure.Say(error.what());
  }
  catch (...)
  {
    failure.Say("The engine failed for an unknown reason.", vtkFFErrorCode::InternalError);
  }
  return false;
}

//------------------------------------------------------------------------------
std::string vtkFFRun::Describe(const vtkFFFailure& failure) const
{
  return failure.Kind == vtkFFFailure::NonFinite
    ? this->NonFiniteWhat + " is NaN or infinite: first at " + this->DescribePoint(failure.Place) +
      ", " + std::to_string(failure.Count) + " such point(s) " + this->NonFiniteReach + ". " +
      this->NonFiniteAdvice
    : failure.Message;
}

//------------------------------------------------------------------------------
unsigned long vtkFFRun::CodeOf(const vtkFFFailure& failure)
{
  switch (failure.Kind)
  {
    case vtkFFFailure::NonFinite:
      return vtkFFErrorCode::NonFiniteError;
    case vtkFFFailure::Other:
      return failure.Code;
    default:
      return vtkFFErrorCode::NoError;
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkFFRun::GetId(vtkIdType index) const
{
  return this->FirstId + (this->Ids.empty() ? index : this->Ids[static_cast<std::size_t>(index)]);
}

//------------------------------------------------------------------------------
std::string vtkFFRun::DescribePoint(vtkIdType id) const
{
  vtkIdType begin = 0;
  for (const PartType& part : this->Parts)
  {
    if (id < begin + part.NumberOfPoints)
    {
      return "point " + std::to_string(id - begin) + part.OfWhat;
    }
    begin += part.NumberOfPoints;
  }
  return "point " + std::to_string(id - begin) + this->Block;
}

//------------------------------------------------------------------------------
std::string vtkFFRun::OfWhat() const
{
  return this->Parts.empty()  ? this->Block
    : this->Parts.size() == 1 ? this->Parts[0].OfWhat
                              : std::string();
}

//------------------------------------------------------------------------------
void vtkFFRun::SetPart(double begin, double end)
{
  this->Part[0] = begin;
  this->Part[1] = end;
}

//------------------------------------------------------------------------------
void vtkFFRun::SetTitle(const char* title)
{
  this->Title = title;
  this->Filter->SetProgressText(title);
}

//------------------------------------------------------------------------------
void vtkFFRun::ForwardStep(const char* name, void* self)
{
  const auto* run = static_cast<vtkFFRun*>(self);
  run->Filter->SetProgressText((std::string(run->Title) + ": " + name).c_str());
}

//------------------------------------------------------------------------------
bool vtkFFRun::ForwardProgress(double fraction, void* self)
{
  auto* run = static_cast<vtkFFRun*>(self);
  // Never back: a run that the CUDA engine gave up starts again on the CPU.
  run->Reached = std::max(run->Reached, run->Part[0] + fraction * (run->Part[1] - run->Part[0]));
  run->Filter->UpdateProgress(run->Reached);
  return !run->IsAbortRequested();
}

//------------------------------------------------------------------------------
void vtkFFRun::Look(const flipflop::Options& options, double share)
{
  if (options.progress && !options.progress(share, options.progressContext))
  {
    throw flipflop::Error(flipflop::ErrorCode::Aborted);
  }
}

//------------------------------------------------------------------------------
bool vtkFFRun::IsAbortRequested() const
{
#if VTK_FF_HAS_CHECK_ABORT
  return this->Filter->CheckAbort();
#else
  return this->Filter->GetAbortExecute() != 0;
#endif
}

//------------------------------------------------------------------------------
void vtkFFRun::NoteAbort()
{
  if (!this->Failure && this->IsAbortRequested())
  {
    this->Failure.Kind = vtkFFFailure::Aborted;
  }
}

//------------------------------------------------------------------------------
void vtkFFRun::AddToReport(const flipflop::CellComplex& cells, vtkPolyData* output)
{
  vtkFFAlgorithm* const filter = this->Reporter;
  const flipflop::Statistics& statistics = cells.statistics;
  const bool isCuda = this->Report.used == flipflop::EngineChoice::CUDA;
  const int used = isCuda ? vtkFFAlgorithm::ENGINE_CUDA : vtkFFAlgorithm::ENGINE_CPU;
  filter->Dimension = std::max(filter->Dimension, cells.dimension);
  filter->NumberOfInputPoints += static_cast<vtkIdType>(statistics.points);
  filter->NumberOfNonFinitePoints += static_cast<vtkIdType>(statistics.nonFinite);
  if (used >= filter->EngineUsed)
  {
    filter->EngineUsed = used;
    filter->EngineReason = this->Report.reason;
  }
  if (!filter->GetReportAsFieldData())
  {
    return;
  }
  vtkFieldData* const data = output->GetFieldData();
  vtkFFOutput::AddValue(data, "FlipFlopDimension", cells.dimension);
  vtkFFOutput::AddValue(data, "FlipFlopEngine", isCuda ? "CUDA" : "CPU");
  vtkFFOutput::AddValue(data, "FlipFlopEngineReason", this->Report.reason);
  vtkFFOutput::AddValue(data, "FlipFlopThreads", statistics.threads);
  flipflop::Statistics::eachField(
    [&](const char* member, auto field)
    {
      std::string name = std::string("FlipFlop") + member;
      name[8] = static_cast<char>(std::toupper(name[8]));
      vtkFFOutput::AddValue(data, name.c_str(), statistics.*field);
    });
}

//------------------------------------------------------------------------------
int vtkFFRun::Finish(bool aloud)
{
  if (!this->Failure)
  {
    if (this->Aborted)
    {
      *this->Aborted = this->IsAbortRequested();
    }
    return 1;
  }
  if (this->Failure.Kind == vtkFFFailure::Aborted)
  {
    if (this->Aborted)
    {
      *this->Aborted = true;
    }
    // The pipeline is to know that the output is not whole.
#if VTK_FF_HAS_CHECK_ABORT
    this->Filter->SetAbortOutput(true);
#endif
  }
  else
  {
    this->SetCode(CodeOf(this->Failure));
    if (aloud && this->Reporter)
    {
      this->Reporter->NumberOfNonFinitePoints += this->Failure.Count;
    }
    if (aloud)
    {
      vtkErrorWithObjectMacro(this->Filter, << this->Describe(this->Failure));
    }
  }
  for (int port = 0; this->Outputs && port < this->Outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkDataObject::GetData(this->Outputs, port)->Initialize();
  }
  return 1;
}

//------------------------------------------------------------------------------
std::string vtkFFRun::DescribeError(const flipflop::Error& error) const
{
  using flipflop::ErrorCode;
  const auto index = static_cast<vtkIdType>(error.index());
  const std::string count = std::to_string(error.count());
  const std::string cell = "cell " + std::to_string(index) + this->OfWhat();
  switch (error.code())
  {
    case ErrorCode::NonFinite: // is described by what the filter calls its numbers
    case ErrorCode::Aborted:   // is reported by the empty output alone
      break;
    case ErrorCode::TooManyPoints:
      return count + " points are more than 32-bit indices can name.";
    case ErrorCode::OutOfMemory:
      return "There is not enough memory for this input" +
        (error.count() > 0 ? ": " + count + " bytes were refused." : std::string("."));
    case ErrorCode::BadArgument:
      return "The engine refuses an argument: " + std::string(error.what()) + '.';
    case ErrorCode::WeightCount:
      return "There are not as many weights as points: " + count + " for " + std::to_string(index) +
        ".";
    case ErrorCode::BadTriangle:
      return "A cell names a point that does not exist, or the same point twice: first at " + cell +
        ", " + count + " such cell(s) in all.";
    case ErrorCode::NotSimple:
      return "A polygon crosses or touches itself, so it cannot be cut into triangles: first at " +
        cell + ", " + count + " such polygon(s) in all.";
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
        ", whose neighbour runs their shared edge the same way. Generate Surface "
        "Normals (vtkPolyDataNormals) can mend that, with Consistency on.";
    case ErrorCode::NotStarShaped:
      return "The surface is not star-shaped: the kernel point does not see the inside of " + cell +
        "; " + count + " such triangle(s) in all.";
    case ErrorCode::NoKernel:
      return "The surface" + this->OfWhat() +
        " is not star-shaped, or no point was found from which it is. If you know one, turn on "
        "Use Kernel Point, and give it as Kernel Point.";
    case ErrorCode::ConstraintPoint:
      return "Constraint " + std::to_string(index) + " ends at point " + count + this->OfWhat() +
        ", which is not there or is left out.";
    case ErrorCode::ConstraintsCross:
      return "Constraint " + std::to_string(index) + " crosses constraint " + count +
        ", and there is no point where they do. Add one, and end or begin both there.";
    case ErrorCode::PolygonsDisagree:
      return "The polygons disagree about what is inside: what is on the left of a side is inside, "
             "and holes run clockwise. Reverse the polygon of constraint " +
        std::to_string(index) + ", which disagrees with that of constraint " + count + ".";
    case ErrorCode::NotConvex:
      return "The domain is no convex polygon with finite corners, counter-clockwise.";
    case ErrorCode::DuplicateSites:
      return "The points " + std::to_string(index) + " and " + count + this->OfWhat() +
        " are at one place, so their cells cannot have prescribed areas.";
    case ErrorCode::BadArea:
      return "A prescribed area is not positive and finite: first at point " +
        std::to_string(index) + this->OfWhat() + ", " + count + " such point(s) in all.";
    case ErrorCode::NoDevice:
      return std::string("The CUDA engine was asked for, but ") + flipflop::cudaStatus().problem +
        ". Set Engine to Automatic or CPU.";
    case ErrorCode::DeviceMemory:
      return "The CUDA device has not enough memory for this input: " + count +
        " bytes were refused. Set Engine to Automatic or CPU.";
    case ErrorCode::DeviceFailed:
      return "The CUDA device failed: error " + std::to_string(index) +
        " of the CUDA runtime. Set Engine to Automatic or CPU.";
    case ErrorCode::Internal:
      return "An internal error: please report it, with the input.";
  }
  return error.what();
}
VTK_ABI_NAMESPACE_END
