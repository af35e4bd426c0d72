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
#include "vtkDataSet.h"
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

/// Whether what an abort has left need not be the whole output: nothing, or of a composite the data
/// sets that were done before.
inline bool isCutShort(const Aborter* abort, vtkDataObject* output)
{
  return abort->Aborted && (isNothing(output) || output->IsA("vtkCompositeDataSet"));
}

/// Whether the run failed, for some data set at least. One data set has one message at most; the
/// code tells, and there is no output. Of an input whose type a filter does not take, its executive
/// speaks.
inline bool demandTold(
  vtkAlgorithm* filter, vtkDataObject* input, const fftest::ErrorObserver* errors)
{
  const auto isError = [](const std::string& message)
  { return message.compare(0, 8, "Warning:") != 0; };
  const auto count = std::count_if(errors->Messages.begin(), errors->Messages.end(), isError);
  if (count == 0)
  {
    demand(filter->GetErrorCode() == vtkErrorCode::NoError, "an error code without words");
    return false;
  }
  const std::string& first =
    *std::find_if(errors->Messages.begin(), errors->Messages.end(), isError);
  demand(first.find("returned failure") == std::string::npos, "more than the filter's own words");
  if (vtkDataSet::SafeDownCast(input))
  {
    demand(count == 1, "several messages: " + first);
    demand(filter->GetErrorCode() != vtkErrorCode::NoError, "an error without a code: " + first);
    for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
    {
      demand(isNothing(filter->GetOutputDataObject(port)), "an output beside an error: " + first);
    }
  }
  return true;
}

}
}

#endif
