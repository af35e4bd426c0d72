// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFRun.h"

#include "vtkFFAlgorithm.h"
#include "vtkFFExactValues.h"
#include "vtkFFInput.h"
#include "vtkFFOutput.h"
#include "vtkFFQueryAlgorithm.h"

#include "Support/FloatingPointEnvironment.h"
#include <flipflop/CellComplex.h>
#include <flipflop/Error.h>
#include <flipflop/Weights.h>

#include "vtkAlgorithm.h"
#include "vtkCompositeDataPipeline.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iterator>
#include <new>
#include <sstream>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

std::string capitalized(std::string text)
{
  text[0] = static_cast<char>(std::toupper(text[0]));
  return text;
}

/// The sentence and the code for an error of the engine: with its {index} and {count}, its {text},
/// and {of} which data set.
struct ErrorText
{
  flipflop::ErrorCode Code;
  unsigned long Id;
  const char* Text;
};

using flipflop::ErrorCode;
constexpr ErrorText errorTexts[] = {
  { ErrorCode::TooManyPoints, vtkFFErrorCode::MemoryError,
    "{count} points are more than 32-bit indices can name." },
  { ErrorCode::OutOfMemory, vtkFFErrorCode::MemoryError,
    "There is not enough memory for this input: {count} bytes were refused." },
  { ErrorCode::BadArgument, vtkFFErrorCode::InputError, "The engine refuses an argument: {text}." },
  { ErrorCode::WeightCount, vtkFFErrorCode::InputError,
    "There are not as many weights as points: {count} for {index}." },
  { ErrorCode::BadTriangle, vtkFFErrorCode::SurfaceError,
    "A cell names a point that does not exist, or the same point twice: first at cell {index}{of}, "
    "{count} such cell(s) in all." },
  { ErrorCode::NotSimple, vtkFFErrorCode::SurfaceError,
    "A polygon crosses or touches itself, so it cannot be cut into triangles: first at cell "
    "{index}{of}, {count} such polygon(s) in all." },
  { ErrorCode::NotClosed, vtkFFErrorCode::SurfaceError,
    "The surface is not closed: first at cell {index}{of}, which has an edge that no other "
    "triangle shares; {count} such edge(s) in all." },
  { ErrorCode::NotManifold, vtkFFErrorCode::SurfaceError,
    "The surface is not a manifold: first at cell {index}{of}, which has an edge of three or more "
    "triangles, or a vertex where several fans of triangles meet; {count} such edge(s) and "
    "vertices in all." },
  { ErrorCode::NotOriented, vtkFFErrorCode::SurfaceError,
    "The surface is not oriented consistently: first at cell {index}{of}, whose neighbour runs "
    "their shared edge the same way. Generate Surface Normals (vtkPolyDataNormals) can mend that, "
    "with Consistency on." },
  { ErrorCode::NotStarShaped, vtkFFErrorCode::SurfaceError,
    "The surface is not star-shaped: the kernel point does not see the inside of cell "
    "{index}{of}; {count} such triangle(s) in all." },
  { ErrorCode::NoKernel, vtkFFErrorCode::SurfaceError,
    "The surface{of} is not star-shaped, or no point was found from which it is. If you know one, "
    "turn on Use Kernel Point, and give it as Kernel Point." },
  { ErrorCode::ConstraintPoint, vtkFFErrorCode::ConstraintError,
    "Constraint {index} ends at point {count}{of}, which is not there or is left out." },
  { ErrorCode::ConstraintsCross, vtkFFErrorCode::ConstraintError,
    "Constraint {index} crosses constraint {count}, and there is no point where they do. Add one, "
    "and end or begin both there." },
  { ErrorCode::PolygonsDisagree, vtkFFErrorCode::ConstraintError,
    "The polygons disagree about what is inside: what is on the left of a side is inside, and "
    "holes run clockwise. Reverse the polygon of constraint {index}, which disagrees with that of "
    "constraint {count}." },
  { ErrorCode::NotConvex, vtkFFErrorCode::InputError,
    "The domain is no convex polygon with finite corners, counter-clockwise." },
  { ErrorCode::DuplicateSites, vtkFFErrorCode::InputError,
    "The points {index} and {count}{of} are at one position, so their cells cannot have prescribed "
    "areas." },
  { ErrorCode::BadArea, vtkFFErrorCode::InputError,
    "A prescribed area is not positive and finite: first at point {index}{of}, {count} such "
    "point(s) in all." },
  { ErrorCode::NoDevice, vtkFFErrorCode::DeviceError,
    "The CUDA engine was asked for, but {text}. Set Engine to Automatic or CPU." },
  { ErrorCode::DeviceMemory, vtkFFErrorCode::DeviceError,
    "The CUDA device has not enough memory for this input: {count} bytes were refused. Set Engine "
    "to Automatic or CPU." },
  { ErrorCode::DeviceFailed, vtkFFErrorCode::DeviceError,
    "The CUDA device failed: error {index} of the CUDA runtime. Set Engine to Automatic or CPU." },
  { ErrorCode::Internal, vtkFFErrorCode::InternalError,
    "An internal error: please report it, with the input." },
};

/// The failure that an error of the engine is; @p of says which data set has it.
vtkFFFailure failureOf(const flipflop::Error& error, const std::string& of)
{
  vtkFFFailure failure;
  const auto* const found = std::find_if(std::begin(errorTexts), std::end(errorTexts),
    [&](const ErrorText& text) { return text.Code == error.code(); });
  if (found == std::end(errorTexts))
  {
    failure.Say(error.what());
    return failure;
  }
  const std::pair<const char*, std::string> parts[] = { { "{index}",
                                                          std::to_string(error.index()) },
    { "{count}", std::to_string(error.count()) }, { "{of}", of },
    { "{text}",
      error.code() == ErrorCode::NoDevice ? flipflop::cudaStatus().problem : error.what() } };
  std::string message = found->Text;
  for (const auto& [name, value] : parts)
  {
    const std::size_t begin = message.find(name);
    if (begin != std::string::npos)
    {
      message.replace(begin, std::strlen(name), value);
    }
  }
  failure.Say(message, found->Id);
  return failure;
}

/// What an executive keeps to itself.
struct Executive : vtkCompositeDataPipeline
{
  /// Whether it has its filter work on one data set of a composite after another.
  static bool IsIterating(vtkExecutive* executive)
  {
    auto* const composite = vtkCompositeDataPipeline::SafeDownCast(executive);
    return composite && composite->*(&Executive::InLocalLoop);
  }
};

constexpr const char* noMemory = "There is not enough memory for this input.";

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
  // The engine has the same values in the same order.
  this->Options.facets = static_cast<flipflop::FacetMode>(filter->GetFacetMode());
  this->Options.nonFinite = static_cast<flipflop::NonFinitePolicy>(filter->GetNonFinitePoints());
  this->Options.vBiased = filter->GetVBiased();
  this->Engine.choice = static_cast<flipflop::EngineChoice>(filter->GetEngine());
  // VTK_INT_MAX is as much as a panel of ParaView can say.
  this->Engine.cudaFrom = filter->GetCUDAThreshold() >= VTK_INT_MAX ? flipflop::CudaPaysNever
                                                                    : filter->GetCUDAThreshold();
  if (outputs)
  {
    this->Begin(filter);
  }
}

//------------------------------------------------------------------------------
vtkFFRun::vtkFFRun(vtkFFQueryAlgorithm* filter, const char* title, vtkInformationVector* outputs)
  : vtkFFRun(filter, title, filter->GetNumberOfThreads(), outputs,
      [filter](unsigned long code) { filter->SetErrorCode(code); })
{
  this->Options.nonFinite = static_cast<flipflop::NonFinitePolicy>(filter->GetNonFinitePoints());
  if (outputs)
  {
    this->Begin(filter);
  }
}

//------------------------------------------------------------------------------
vtkFFRun::vtkFFRun(const vtkFFRun& whole, std::size_t dataSet, std::size_t count)
  : Options(whole.Options)
  , Engine(whole.Engine)
  , Filter(whole.Filter)
  , Reporter(whole.Reporter)
  , Title(whole.Title)
  , Outputs(nullptr)
  , SetCode(whole.SetCode)
{
  this->SetDataSet(static_cast<vtkIdType>(dataSet), static_cast<vtkIdType>(count));
  this->Options.threads = 1;
  this->Options.progress = nullptr;
  this->Options.step = nullptr;
}

//------------------------------------------------------------------------------
bool vtkFFRun::FindDataSet(
  vtkAlgorithm* filter, vtkInformationVector** inputVector, vtkIdType& number, vtkIdType& count)
{
  if (Executive::IsIterating(filter->GetExecutive()))
  {
    ++number;
    return false;
  }
  number = -1;
  count = 0;
  for (int port = 0; port < filter->GetNumberOfInputPorts(); ++port)
  {
    const auto pieces = vtkFFInput::PiecesOf(vtkDataObject::GetData(inputVector[port]));
    count = std::max(count, static_cast<vtkIdType>(pieces.size()));
  }
  return true;
}

//------------------------------------------------------------------------------
template <class FilterT>
void vtkFFRun::Begin(FilterT* filter)
{
  this->SetDataSet(filter->DataSet, filter->NumberOfDataSets);
  this->Aborted = &filter->IsAborted;
  if (filter->IsAborted)
  {
    this->Failure.Kind = vtkFFFailure::Aborted; // before VTK 9.3, the executive goes on
  }
}

//------------------------------------------------------------------------------
void vtkFFRun::SetDataSet(vtkIdType number, vtkIdType count)
{
  if (number >= 0 && count > 1)
  {
    this->Block = " of data set " + std::to_string(number) + " of the composite";
  }
}

//------------------------------------------------------------------------------
bool vtkFFRun::Do(const std::function<void()>& work)
{
  vtkFFFailure& failure = this->Failure;
  if (failure)
  {
    return false;
  }
  const flipflop::DefaultFloatingPointEnvironment environment;
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
        failure.Point = this->GetId(static_cast<vtkIdType>(error.index()));
        failure.Count = static_cast<vtkIdType>(error.count());
        break;
      case flipflop::ErrorCode::Aborted:
        failure.Kind = vtkFFFailure::Aborted;
        break;
      case flipflop::ErrorCode::OutOfMemory:
        if (error.count() <= 0)
        {
          failure.Say(noMemory, vtkFFErrorCode::MemoryError);
          break;
        }
        [[fallthrough]];
      default:
        failure = failureOf(error, this->OfWhat());
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
    failure.Say(noMemory, vtkFFErrorCode::MemoryError);
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
void vtkFFRun::CheckLength(double length, const char* name, const char* zero)
{
  if (!(length >= 0.0))
  {
    std::ostringstream message;
    message << name << " is " << length << "; it must be a length, or 0 for " << zero << ".";
    throw vtkFFBadSetting(message.str());
  }
}

//------------------------------------------------------------------------------
void vtkFFRun::UseCPU(const char* reason)
{
  if (this->Engine.choice == flipflop::EngineChoice::CUDA)
  {
    throw vtkFFBadSetting(std::string("The CUDA engine was asked for, but ") + reason +
      ". Set Engine to Automatic or CPU.");
  }
  this->Report.used = flipflop::EngineChoice::CPU;
  std::snprintf(this->Report.reason, sizeof(this->Report.reason), "%s",
    this->Engine.choice == flipflop::EngineChoice::CPU ? "the CPU engine was asked for" : reason);
}

//------------------------------------------------------------------------------
void vtkFFRun::SetPart(double begin, double end)
{
  this->Part[0] = begin;
  this->Part[1] = end;
}

//------------------------------------------------------------------------------
void vtkFFRun::ForwardStep(const char* name, void* self)
{
  const auto* run = static_cast<vtkFFRun*>(self);
  const flipflop::CallersFloatingPointEnvironment observers;
  run->Filter->SetProgressText((std::string(run->Title) + ": " + name).c_str());
}

//------------------------------------------------------------------------------
bool vtkFFRun::ForwardProgress(double fraction, void* self)
{
  auto* run = static_cast<vtkFFRun*>(self);
  // The engine calls in the observers' environment.
  const flipflop::DefaultFloatingPointEnvironment environment;
  // Never back: a run that the CUDA engine gave up starts again on the CPU.
  run->Reached = std::max(run->Reached, run->Part[0] + fraction * (run->Part[1] - run->Part[0]));
  const flipflop::CallersFloatingPointEnvironment observers;
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
void vtkFFRun::NameFailure(const std::string& words)
{
  vtkFFFailure& failure = this->Failure;
  if (failure.Kind == vtkFFFailure::NonFinite)
  {
    failure.Say(this->NonFiniteWhat + " is NaN or infinite: first at " +
        this->DescribePoint(failure.Point) + ", " + std::to_string(failure.Count) +
        " such point(s) " + this->NonFiniteReach + ". " + this->NonFiniteAdvice,
      vtkFFErrorCode::NonFiniteError);
  }
  if (failure.Kind == vtkFFFailure::Other)
  {
    const bool isNamed = failure.Message.find(this->Block) != std::string::npos;
    failure.Message =
      (isNamed ? words : capitalized(this->Block.substr(4)) + ": " + words) + failure.Message;
  }
}

//------------------------------------------------------------------------------
void vtkFFRun::AddToReport(const flipflop::CellComplex& cells, vtkDataObject* output)
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
  const vtkFFFailure& failure = this->Failure;
  const bool isAborted = failure ? failure.Kind == vtkFFFailure::Aborted : this->IsAbortRequested();
  if (this->Aborted)
  {
    *this->Aborted = isAborted;
  }
  if (!failure)
  {
    return 1;
  }
  if (isAborted)
  {
    // The pipeline is to know that the output is not whole.
#if VTK_FF_HAS_CHECK_ABORT
    this->Filter->SetAbortOutput(true);
#endif
  }
  else
  {
    this->NameFailure({});
    this->SetCode(failure.Code);
    if (aloud && this->Reporter)
    {
      this->Reporter->NumberOfNonFinitePoints += failure.Count;
    }
    if (aloud)
    {
      vtkErrorWithObjectMacro(this->Filter, << failure.Message);
    }
  }
  for (int port = 0; this->Outputs && port < this->Outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkDataObject* const output = vtkDataObject::GetData(this->Outputs, port);
    if (!isAborted || !output->IsA("vtkCompositeDataSet"))
    {
      output->Initialize(); // what was done of a composite before an abort stays
    }
  }
  return 1;
}
VTK_ABI_NAMESPACE_END
