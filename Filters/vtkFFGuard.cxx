// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFGuard.h"

#include "vtkFFExactValues.h"
#include "vtkFFFailure.h"
#include "vtkFFWeightSource.h"
#include <flipflop/Engines.h>
#include <flipflop/Error.h>
#include <flipflop/Options.h>

#include "vtkAlgorithm.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cstring>
#include <exception>
#include <new>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkFFGuard::vtkFFGuard(vtkAlgorithm* algorithm)
  : Algorithm(algorithm)
{
}

//------------------------------------------------------------------------------
vtkFFGuard::~vtkFFGuard() = default;

//------------------------------------------------------------------------------
flipflop::Options vtkFFGuard::MakeOptions(int threads)
{
  flipflop::Options options;
  options.threads = threads > 0 ? threads : this->GetDefaultNumberOfThreads();
  options.progress = &vtkFFGuard::ForwardProgress;
  options.progressContext = this;
  options.step = &vtkFFGuard::ForwardStep;
  return options;
}

//------------------------------------------------------------------------------
int vtkFFGuard::GetDefaultNumberOfThreads()
{
  // The engine's threads are oneTBB's, whatever VTK's are.
  const char* backend = vtkSMPTools::GetBackend();
  const bool hasThreads = backend && std::strcmp(backend, "Sequential") != 0;
  return hasThreads ? vtkSMPTools::GetEstimatedNumberOfThreads() : 0;
}

//------------------------------------------------------------------------------
bool vtkFFGuard::Try(const std::function<void()>& work, vtkFFFailure& failure)
{
  try
  {
    work();
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
  catch (const vtkFFBadWeight& error)
  {
    failure.Say(std::string(error.what()) + ": first at " +
      this->DescribePoint(this->GetPlaceOfPoint(error.GetIndex())) + ". " + error.GetAdvice());
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
void vtkFFGuard::ReportError(const std::string& message)
{
  this->SetErrorCode(vtkErrorCode::UserError);
  vtkErrorWithObjectMacro(this->Algorithm, << message);
}

//------------------------------------------------------------------------------
void vtkFFGuard::ReportFailure(const vtkFFFailure& failure, bool aloud)
{
  if (failure.Kind == vtkFFFailure::None)
  {
    return;
  }
  if (failure.Kind == vtkFFFailure::Aborted)
  {
    this->MarkAborted();
    return;
  }
  if (!aloud)
  {
    this->SetErrorCode(vtkErrorCode::UserError);
    return;
  }
  this->NoteNonFinite(failure.Count);
  this->ReportError(this->DescribeFailure(failure));
}

//------------------------------------------------------------------------------
std::string vtkFFGuard::DescribeFailure(const vtkFFFailure& failure)
{
  return failure.Kind == vtkFFFailure::NonFinite
    ? this->DescribeError(
        flipflop::Error(flipflop::ErrorCode::NonFinite, failure.Place, failure.Count))
    : failure.Message;
}

//------------------------------------------------------------------------------
void vtkFFGuard::SetProgressRange(double begin, double end)
{
  this->ProgressRange[0] = begin;
  this->ProgressRange[1] = end;
  this->SetProgressPart(0.0, 1.0);
  this->SetProgressTitle(this->GetProgressTitle());
  this->ProgressReached = begin;
}

//------------------------------------------------------------------------------
void vtkFFGuard::SetProgressTitle(const char* title)
{
  this->ProgressTitle = title;
  this->Algorithm->SetProgressText(title);
}

//------------------------------------------------------------------------------
void vtkFFGuard::SetProgressPart(double begin, double end)
{
  this->ProgressPart[0] = begin;
  this->ProgressPart[1] = end;
}

//------------------------------------------------------------------------------
void vtkFFGuard::ForwardStep(const char* name, void* self)
{
  auto* guard = static_cast<vtkFFGuard*>(self);
  const char* title = guard->ProgressTitle ? guard->ProgressTitle : guard->GetProgressTitle();
  const std::string text = std::string(title) + ": " + name;
  guard->Algorithm->SetProgressText(text.c_str());
}

//------------------------------------------------------------------------------
bool vtkFFGuard::ForwardProgress(double fraction, void* self)
{
  auto* guard = static_cast<vtkFFGuard*>(self);
  const double* range = guard->ProgressRange;
  const double* part = guard->ProgressPart;
  const double inRange = part[0] + fraction * (part[1] - part[0]);
  // Never back: a run that the CUDA engine gave up starts anew on the CPU.
  guard->ProgressReached =
    std::max(guard->ProgressReached, range[0] + inRange * (range[1] - range[0]));
  guard->Algorithm->UpdateProgress(guard->ProgressReached);
  return !guard->IsAbortRequested();
}

//------------------------------------------------------------------------------
void vtkFFGuard::Look(const flipflop::Options& options, double share)
{
  if (options.progress && !options.progress(share, options.progressContext))
  {
    throw flipflop::Error(flipflop::ErrorCode::Aborted);
  }
}

//------------------------------------------------------------------------------
bool vtkFFGuard::IsAbortRequested()
{
#if VTK_FF_HAS_CHECK_ABORT
  return this->Algorithm->CheckAbort();
#else
  return this->Algorithm->GetAbortExecute() != 0;
#endif
}

//------------------------------------------------------------------------------
void vtkFFGuard::NoteAbort(vtkFFFailure& failure)
{
  if (failure.Kind == vtkFFFailure::None && this->IsAbortRequested())
  {
    failure.Kind = vtkFFFailure::Aborted;
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkFFGuard::GetPlaceOfPoint(vtkIdType index)
{
  return index;
}

//------------------------------------------------------------------------------
std::string vtkFFGuard::DescribePoint(vtkIdType place)
{
  return "point " + std::to_string(place) + this->OfBlock();
}

//------------------------------------------------------------------------------
std::string vtkFFGuard::OfBlock()
{
  return {};
}

//------------------------------------------------------------------------------
std::string vtkFFGuard::OfBlockAt(unsigned int flatIndex)
{
  return flatIndex ? " of the block of flat index " + std::to_string(flatIndex) : std::string();
}

//------------------------------------------------------------------------------
void vtkFFGuard::NoteNonFinite(vtkIdType) {}

//------------------------------------------------------------------------------
std::string vtkFFGuard::DescribeNonFinite(const std::string& what, const flipflop::Error& error)
{
  return what + " is NaN or infinite: first at " +
    this->DescribePoint(static_cast<vtkIdType>(error.index())) + ", " +
    std::to_string(error.count()) + " such point(s) " + this->GetReachOfCount() + ".";
}

//------------------------------------------------------------------------------
std::string vtkFFGuard::DescribeError(const flipflop::Error& error)
{
  using flipflop::ErrorCode;
  const auto index = static_cast<vtkIdType>(error.index());
  const std::string count = std::to_string(error.count());
  const std::string cell = "cell " + std::to_string(index) + this->OfBlock();
  switch (error.code())
  {
    case ErrorCode::NonFinite:
      return this->DescribeNonFinite("A coordinate", error) +
        " Remove them, or set Non Finite Points to Ignore.";
    case ErrorCode::TooManyPoints:
      return count + " points are more than 32-bit indices can name.";
    case ErrorCode::OutOfMemory:
      return "There is not enough memory for this input" +
        (error.count() > 0 ? ": " + count + " bytes were refused." : std::string("."));
    case ErrorCode::Aborted: // is reported by the empty output alone
      break;
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
      return "The surface" + this->OfBlock() +
        " is not star-shaped, or no point was found from which it is. If you know one, turn on "
        "Use Kernel Point, and give it as Kernel Point.";
    case ErrorCode::ConstraintPoint:
      return "Constraint " + std::to_string(index) + " ends at point " + count + this->OfBlock() +
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
      return "The points " + std::to_string(index) + " and " + count + this->OfBlock() +
        " are at one place, so their cells cannot have prescribed areas.";
    case ErrorCode::BadArea:
      return "A prescribed area is not positive and finite: first at point " +
        std::to_string(index) + this->OfBlock() + ", " + count + " such point(s) in all.";
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

//------------------------------------------------------------------------------
std::string vtkFFGuard::List(const std::vector<std::string>& names)
{
  std::string text = names[0];
  for (std::size_t i = 1; i < names.size(); ++i)
  {
    text += (i + 1 < names.size() ? ", " : " or ") + names[i];
  }
  return text;
}

//------------------------------------------------------------------------------
void vtkFFGuard::ForgetExtents(vtkInformationVector* outputs)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    outputs->GetInformationObject(port)->Remove(
      vtkStreamingDemandDrivenPipeline::COMBINED_UPDATE_EXTENT());
  }
}
VTK_ABI_NAMESPACE_END
