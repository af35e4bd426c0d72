// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFRun.h"

#include "FFOutput.h"
#include "vtkFFAlgorithm.h"
#include "vtkFFQueryAlgorithm.h"

#include "Support/FloatingPointEnvironment.h"
#include <flipflop/CellComplex.h>
#include <flipflop/Error.h>

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

bool isSerial()
{
  return vtkSMPTools::GetBackend() == std::string("Sequential");
}

/// This VTK has no threads, as in Debian's ParaView; nobody chose that since the library was
/// loaded.
const bool startedSerial = isSerial();

}

//------------------------------------------------------------------------------
FFRun::FFRun(vtkAlgorithm* filter, const char* title, int threads, Publisher publish)
  : Filter(filter)
  , Title(title)
  , Publish(std::move(publish))
{
  // As vtkFFAlgorithm::SetNumberOfThreads() says; the engine takes 0 for all of the machine's.
  const bool hasNone = startedSerial && isSerial();
  this->Options.threads = threads > 0 ? threads
    : threads < 0 || hasNone          ? 0
                                      : vtkSMPTools::GetEstimatedNumberOfThreads();
  if (title)
  {
    this->Options.progress = &FFRun::ForwardProgress;
    this->Options.progressContext = this;
    this->Options.step = &FFRun::ForwardStep;
    this->Filter->SetProgressText(title);
  }
}

//------------------------------------------------------------------------------
template <class FilterT>
FFRun::Publisher FFRun::PublishTo(FilterT* filter)
{
  return [filter](const vtkFFReport& report, unsigned long code)
  {
    filter->Report = report;
    filter->ErrorCode = code; // which is no change of the filter
  };
}

//------------------------------------------------------------------------------
FFRun::FFRun(vtkFFAlgorithm* filter, const char* title)
  : FFRun(filter, title, filter->GetNumberOfThreads(), PublishTo(filter))
{
  // The engine has the same values in the same order.
  this->Options.facets = static_cast<flipflop::FacetMode>(filter->GetFacetMode());
  this->Options.nonFinite = static_cast<flipflop::NonFinitePolicy>(filter->GetNonFinitePoints());
  this->Options.vBiased = filter->GetVBiased();
  this->Engine.choice = static_cast<flipflop::EngineChoice>(filter->GetEngine());
  // VTK_INT_MAX is as much as a panel of ParaView can say.
  this->Engine.cudaFrom = filter->GetCUDAThreshold() >= VTK_INT_MAX ? flipflop::CudaPaysNever
                                                                    : filter->GetCUDAThreshold();
  this->ReportsAsFieldData = filter->GetReportAsFieldData();
}

//------------------------------------------------------------------------------
FFRun::FFRun(vtkFFQueryAlgorithm* filter, const char* title)
  : FFRun(filter, title, filter->GetNumberOfThreads(), PublishTo(filter))
{
  this->Options.nonFinite = static_cast<flipflop::NonFinitePolicy>(filter->GetNonFinitePoints());
}

//------------------------------------------------------------------------------
FFRun::FFRun(FFRun& whole, std::size_t dataSet, std::size_t count, bool isSilent)
  : Options(whole.Options)
  , Engine(whole.Engine)
  , ReportsAsFieldData(whole.ReportsAsFieldData)
  , Filter(whole.Filter)
  , Title(whole.Title)
  , Whole(&whole)
{
  if (count > 1)
  {
    this->Block = " of data set " + std::to_string(dataSet) + " of the composite";
  }
  if (isSilent)
  {
    this->Options.threads = 1;
    this->Options.progress = nullptr;
    this->Options.step = nullptr;
    return;
  }
  this->Options.progressContext = this;
  const double share = (whole.Range[1] - whole.Range[0]) / static_cast<double>(count);
  this->Range[0] = whole.Range[0] + static_cast<double>(dataSet) * share;
  this->Range[1] = whole.Range[0] + static_cast<double>(dataSet + 1) * share;
  this->SetPart(0.0, 1.0);
}

//------------------------------------------------------------------------------
bool FFRun::Do(const std::function<void()>& work)
{
  if (this->Failure)
  {
    return false;
  }
  const flipflop::DefaultFloatingPointEnvironment environment;
  try
  {
    work();
    return !this->Failure;
  }
  catch (...)
  {
    this->Failure = FFFailure::OfException([this](vtkIdType index) { return this->GetId(index); },
      [this](vtkIdType id) { return this->DescribePoint(id); }, this->OfWhat());
    return false;
  }
}

//------------------------------------------------------------------------------
vtkIdType FFRun::GetId(vtkIdType index) const
{
  return this->FirstId + (this->Ids ? (*this->Ids)[static_cast<std::size_t>(index)] : index);
}

//------------------------------------------------------------------------------
std::string FFRun::DescribePoint(vtkIdType id) const
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
std::string FFRun::OfWhat() const
{
  return this->Parts.empty()  ? this->Block
    : this->Parts.size() == 1 ? this->Parts[0].OfWhat
                              : std::string();
}

//------------------------------------------------------------------------------
void FFRun::UseCPU(const char* reason)
{
  if (this->Engine.choice == flipflop::EngineChoice::CUDA)
  {
    throw FFBadSetting(std::string("The CUDA engine was asked for, but ") + reason +
      ". Set Engine to Automatic or CPU.");
  }
  this->EngineReport.used = flipflop::EngineChoice::CPU;
  std::snprintf(this->EngineReport.reason, sizeof(this->EngineReport.reason), "%s",
    this->Engine.choice == flipflop::EngineChoice::CPU ? "the CPU engine was asked for" : reason);
}

//------------------------------------------------------------------------------
void FFRun::SetPart(double begin, double end)
{
  const double length = this->Range[1] - this->Range[0];
  this->Part[0] = this->Range[0] + begin * length;
  this->Part[1] = this->Range[0] + end * length;
}

//------------------------------------------------------------------------------
void FFRun::SetBegin(double begin)
{
  this->Range[0] += begin * (this->Range[1] - this->Range[0]);
  this->SetPart(0.0, 1.0);
}

//------------------------------------------------------------------------------
void FFRun::ForwardStep(const char* name, void* self)
{
  const auto* run = static_cast<FFRun*>(self);
  const flipflop::CallersFloatingPointEnvironment observers;
  run->Filter->SetProgressText((std::string(run->Title) + ": " + name).c_str());
}

//------------------------------------------------------------------------------
bool FFRun::ForwardProgress(double fraction, void* self)
{
  const auto* const run = static_cast<FFRun*>(self);
  FFRun* const whole = run->Whole ? run->Whole : static_cast<FFRun*>(self);
  // The engine calls in the observers' environment.
  const flipflop::DefaultFloatingPointEnvironment environment;
  // Never back: a run that the CUDA engine gave up starts again on the CPU.
  whole->Reached =
    std::max(whole->Reached, run->Part[0] + fraction * (run->Part[1] - run->Part[0]));
  const flipflop::CallersFloatingPointEnvironment observers;
  run->Filter->UpdateProgress(whole->Reached);
  return !run->IsAbortRequested();
}

//------------------------------------------------------------------------------
void FFRun::Look(const flipflop::Options& options, double share)
{
  if (options.progress && !options.progress(share, options.progressContext))
  {
    throw flipflop::Error(flipflop::ErrorCode::Aborted);
  }
}

//------------------------------------------------------------------------------
bool FFRun::IsAbortRequested() const
{
#if VTK_FF_HAS_CHECK_ABORT
  return this->Filter->CheckAbort();
#else
  return this->Filter->GetAbortExecute() != 0;
#endif
}

//------------------------------------------------------------------------------
void FFRun::NoteAbort()
{
  if (!this->Failure && this->IsAbortRequested())
  {
    this->Failure.Kind = FFFailure::Aborted;
  }
}

//------------------------------------------------------------------------------
void FFRun::NameFailure(const std::string& words)
{
  FFFailure& failure = this->Failure;
  if (failure.Kind == FFFailure::NonFinite)
  {
    failure.Say(this->NonFiniteWhat + " is NaN or infinite: first at " +
        this->DescribePoint(failure.Point) + ", " + std::to_string(failure.Count) +
        " such point(s) " + this->NonFiniteReach + ". " + this->NonFiniteAdvice,
      vtkFFErrorCode::NonFiniteError);
  }
  if (failure.Kind == FFFailure::Other)
  {
    const bool isNamed = failure.Message.find(this->Block) != std::string::npos;
    std::string begin = words;
    if (!isNamed)
    {
      begin = this->Block.substr(4) + ": " + words;
      begin[0] = static_cast<char>(std::toupper(begin[0]));
    }
    failure.Message = begin + failure.Message;
  }
}

//------------------------------------------------------------------------------
void FFRun::AddToReport(const flipflop::CellComplex& cells, vtkDataObject* output)
{
  const flipflop::Statistics& statistics = cells.statistics;
  const bool isCuda = this->EngineReport.used == flipflop::EngineChoice::CUDA;
  this->Report.Dimension = cells.dimension;
  this->Report.NumberOfInputPoints = static_cast<vtkIdType>(statistics.points);
  this->Report.NumberOfNonFinitePoints = static_cast<vtkIdType>(statistics.nonFinite);
  this->Report.EngineUsed = isCuda ? vtkFFAlgorithm::ENGINE_CUDA : vtkFFAlgorithm::ENGINE_CPU;
  this->Report.EngineReason = this->EngineReport.reason;
  if (!this->ReportsAsFieldData)
  {
    return;
  }
  vtkFieldData* const data = output->GetFieldData();
  FFOutput::AddValue(data, "FlipFlopDimension", cells.dimension);
  FFOutput::AddValue(data, "FlipFlopEngine", isCuda ? "CUDA" : "CPU");
  FFOutput::AddValue(data, "FlipFlopEngineReason", this->EngineReport.reason);
  FFOutput::AddValue(data, "FlipFlopThreads", statistics.threads);
  flipflop::Statistics::eachField(
    [&](const char* member, auto field)
    {
      std::string name = std::string("FlipFlop") + member;
      name[8] = static_cast<char>(std::toupper(name[8]));
      FFOutput::AddValue(data, name.c_str(), statistics.*field);
    });
}

//------------------------------------------------------------------------------
void FFRun::SettleReport(bool aloud)
{
  const vtkIdType count = this->Failure.Count;
  this->NameFailure({});
  if (this->Failure.Kind == FFFailure::Other)
  {
    this->Code = this->Failure.Code;
    this->Report = vtkFFReport();
    this->Report.NumberOfNonFinitePoints = aloud ? count : 0;
  }
}

//------------------------------------------------------------------------------
void FFRun::Say(bool aloud) const
{
  for (const std::string& warning : this->Warnings)
  {
    vtkWarningWithObjectMacro(this->Filter, << warning);
  }
  if (aloud && this->Failure.Kind == FFFailure::Other)
  {
    vtkErrorWithObjectMacro(this->Filter, << this->Failure.Message);
  }
}

//------------------------------------------------------------------------------
void FFRun::Add(FFRun& part, bool aloud)
{
  part.SettleReport(aloud);
  this->Report.Add(part.Report);
  this->Code = part.Code != vtkFFErrorCode::NoError ? part.Code : this->Code;
  part.Say(aloud);
}

//------------------------------------------------------------------------------
int FFRun::Finish(const std::vector<vtkDataObject*>& outputs, bool aloud)
{
  const bool isAborted = this->Failure.Kind == FFFailure::Aborted;
  const bool areComposites = !outputs.empty() && outputs[0]->IsA("vtkCompositeDataSet");
  this->SettleReport(aloud);
  if (isAborted && !areComposites) // what was done of a composite before an abort stays
  {
    this->Report = vtkFFReport();
  }
  this->Publish(this->Report, this->Code);
  if (isAborted)
  {
    // The pipeline is to know that the output is not whole.
#if VTK_FF_HAS_CHECK_ABORT
    this->Filter->SetAbortOutput(true);
#endif
  }
  for (vtkDataObject* const output : outputs)
  {
    if (this->Failure && (!isAborted || !areComposites))
    {
      output->Initialize();
    }
  }
  this->Say(aloud);
  return 1;
}
VTK_ABI_NAMESPACE_END
