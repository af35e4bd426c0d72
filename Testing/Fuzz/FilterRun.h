// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// One run of a filter: who aborts it, and what must hold of its errors and outputs.
#ifndef flipflop_fuzz_FilterRun_h
#define flipflop_fuzz_FilterRun_h

#include "Bytes.h"
#include "Demand.h"

#include "FFTest.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkDataObjectTree.h"
#include "vtkErrorCode.h"

#include <algorithm>
#include <string>

namespace flipflop
{
namespace fuzz
{

/// Aborts at one of its filter's reports.
class Aborter : public vtkCommand
{
public:
  static Aborter* New() { return new Aborter; }
  vtkTypeMacro(Aborter, vtkCommand);

  /// For the next run: never, or at one of the first reports.
  void draw(Bytes& bytes)
  {
    this->Reports = 0;
    this->Aborted = false;
    this->AbortAt = bytes.oneOf(4) ? bytes.below(24) : 0;
  }

  void Execute(vtkObject* caller, unsigned long, void* data) override
  {
    const double fraction = *static_cast<double*>(data);
    demand(fraction >= 0 && fraction <= 1, "progress out of 0 to 1");
    if (++this->Reports == this->AbortAt)
    {
      this->Aborted = true;
      vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
    }
  }

  int AbortAt = 0; // from 1 on; 0: never
  int Reports = 0;
  bool Aborted = false;
};

inline bool isNothing(vtkDataObject* data)
{
  return !data ||
    (data->GetNumberOfElements(vtkDataObject::POINT) == 0 &&
      data->GetNumberOfElements(vtkDataObject::CELL) == 0);
}

/// An error is reported in all ways. It leaves no output, unless the input is a composite, some of
/// whose blocks have results: then the update goes on.
/// @return whether the run failed
inline bool demandTold(vtkAlgorithm* filter, const fftest::ErrorObserver* errors)
{
  const auto isError = [](const std::string& message)
  { return message.compare(0, 8, "Warning:") != 0; };
  const auto count = std::count_if(errors->Messages.begin(), errors->Messages.end(), isError);
  const bool failed = errors->FailedRequests > 0;
  demand(count <= 1 && errors->FailedRequests <= count, "the pipeline was told otherwise");
  if (count > 0)
  {
    demand(filter->GetErrorCode() != vtkErrorCode::NoError,
      "an error without an error code: " + errors->Messages.front());
    demand(failed || vtkDataObjectTree::SafeDownCast(filter->GetOutputDataObject(0)),
      "an error that the pipeline was not told of: " + errors->Messages.front());
  }
  else
  {
    demand(filter->GetErrorCode() == vtkErrorCode::NoError, "an error code without words");
  }
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    demand(!failed || isNothing(filter->GetOutputDataObject(port)),
      "an output beside an error: " + (failed ? errors->Messages.front() : ""));
  }
  return failed;
}

/// Runs of a filter that answers questions at points, one or several after each other.
/// @param given data to run with; null: some is drawn
void queryFilters(Bytes& bytes, vtkDataObject* given, int mostPoints);

}
}

#endif
