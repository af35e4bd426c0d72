// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFAheadRuns.h"

#include "Support/Threads.h"
#include "vtkFFBlockWork.h"
#include <flipflop/Error.h>
#include <flipflop/Options.h>

#include <utility>

VTK_ABI_NAMESPACE_BEGIN
struct vtkFFAheadRuns::RunType
{
  vtkFFAheadRuns* Owner;
  std::unique_ptr<vtkFFBlockWork> Work;
  std::vector<vtkIdType> Places;
  std::vector<double> Progress; // the fractions it told
  flipflop::EngineReport Report;
  std::exception_ptr Thrown;
};

//------------------------------------------------------------------------------
vtkFFAheadRuns::vtkFFAheadRuns(std::function<bool()> isAbortRequested)
  : IsAbortRequested(std::move(isAbortRequested))
  , Caller(std::this_thread::get_id())
{
}

//------------------------------------------------------------------------------
vtkFFAheadRuns::~vtkFFAheadRuns() = default;

//------------------------------------------------------------------------------
bool vtkFFAheadRuns::KeepProgress(double fraction, void* context)
{
  auto* run = static_cast<RunType*>(context);
  run->Progress.push_back(fraction);
  vtkFFAheadRuns* owner = run->Owner;
  if (std::this_thread::get_id() == owner->Caller && owner->IsAbortRequested())
  {
    owner->Stop = true;
  }
  return !owner->Stop;
}

//------------------------------------------------------------------------------
flipflop::Options vtkFFAheadRuns::OptionsOf(RunType& run, const flipflop::Options& options)
{
  flipflop::Options own = options;
  own.progress = &vtkFFAheadRuns::KeepProgress;
  own.progressContext = &run;
  own.step = nullptr; // it is for one thread to tell
  return own;
}

//------------------------------------------------------------------------------
void vtkFFAheadRuns::Gather(std::unique_ptr<vtkFFBlockWork> work, const flipflop::Options& options,
  std::vector<vtkIdType>& places)
{
  this->Runs.push_back(std::make_unique<RunType>());
  RunType& run = *this->Runs.back();
  run.Owner = this;
  run.Work = std::move(work);
  try
  {
    run.Work->Gather(OptionsOf(run, options));
  }
  catch (...)
  {
    run.Thrown = std::current_exception();
  }
  run.Places = std::exchange(places, {});
}

//------------------------------------------------------------------------------
void vtkFFAheadRuns::Run(
  int threads, const flipflop::Options& options, const flipflop::EngineOptions& engine)
{
  flipflop::runSideBySide(this->Runs.size(), threads,
    [&](std::size_t i)
    {
      RunType& run = *this->Runs[i];
      if (run.Thrown)
      {
        return;
      }
      try
      {
        run.Work->Run(OptionsOf(run, options), engine, run.Report);
      }
      catch (...)
      {
        run.Thrown = std::current_exception();
      }
    });
}

//------------------------------------------------------------------------------
void vtkFFAheadRuns::WriteNext(const flipflop::Options& options, flipflop::EngineReport& report,
  std::vector<vtkIdType>& places, const std::vector<vtkPolyData*>& outputs)
{
  const std::unique_ptr<RunType> run = std::move(this->Runs[this->Next]);
  ++this->Next;
  places = std::move(run->Places);
  for (const double fraction : run->Progress)
  {
    if (options.progress && !options.progress(fraction, options.progressContext))
    {
      throw flipflop::Error(flipflop::ErrorCode::Aborted);
    }
  }
  if (run->Thrown)
  {
    std::rethrow_exception(run->Thrown);
  }
  report = run->Report;
  run->Work->Write(options, report, outputs);
}
VTK_ABI_NAMESPACE_END
