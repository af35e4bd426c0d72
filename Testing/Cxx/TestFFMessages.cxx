// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// The words and codes of errors that only large inputs, the device or faults cause.
// Documentation/Messages.md has the same.
#include "FFTest.h"

#include "FFRun.h"
#include "vtkFFHullFilter.h"

#include "vtkCallbackCommand.h"
#include "vtkFFErrorCode.h"
#include "vtkNew.h"

#include <flipflop/Error.h>

#include <functional>
#include <new>
#include <stdexcept>

using namespace fftest;

namespace
{

/// What is said after the work threw, after the error code.
std::string said(const std::function<void()>& work)
{
  vtkNew<vtkFFHullFilter> filter;
  const auto errors = ErrorObserver::Of(filter);
  FFRun run(filter, "A test");
  FF_CHECK(!run.Do(work));
  FF_CHECK(!run.Do([] { FF_CHECK(!"no work is done after a failure"); }));
  FF_CHECK_EQUAL(run.Finish({}), 1); // the executive would add a message
  FF_CHECK(errors->Messages.size() <= 1);
  if (errors->Messages.empty())
  {
    return std::to_string(filter->GetErrorCode());
  }
  const std::string& message = errors->Messages.front();
  const std::size_t begin = message.find("): ") + 3;
  return std::to_string(filter->GetErrorCode() - vtkErrorCode::UserError) + ": " +
    message.substr(begin, message.find_last_not_of('\n') + 1 - begin);
}

template <class... Arguments>
std::string saidOf(flipflop::ErrorCode code, Arguments... arguments)
{
  return said([=] { throw flipflop::Error(code, arguments...); });
}

void testErrorsOfTheEngine()
{
  using flipflop::ErrorCode;
  FF_CHECK_EQUAL(saidOf(ErrorCode::TooManyPoints, -1, 4294967296),
    "6: 4294967296 points are more than 32-bit indices can name.");
  FF_CHECK_EQUAL(saidOf(ErrorCode::OutOfMemory), "6: There is not enough memory for this input.");
  FF_CHECK_EQUAL(saidOf(ErrorCode::OutOfMemory, -1, 1 << 30),
    "6: There is not enough memory for this input: 1073741824 bytes were refused.");
  FF_CHECK_EQUAL(
    saidOf(ErrorCode::BadArgument), "2: The engine refuses an argument: an argument is invalid.");
  FF_CHECK_EQUAL(
    saidOf(ErrorCode::WeightCount, 4, 3), "2: There are not as many weights as points: 3 for 4.");
  FF_CHECK_EQUAL(saidOf(ErrorCode::ConstraintPoint, 2, 9),
    "5: Constraint 2 ends at point 9, which is not there or is left out.");
  FF_CHECK_EQUAL(saidOf(ErrorCode::ConstraintsCross, 2, 1),
    "5: Constraint 2 crosses constraint 1, and there is no point where they do. Add one, and end "
    "or "
    "begin both there.");
  FF_CHECK_EQUAL(saidOf(ErrorCode::PolygonsDisagree, 5, 6),
    "5: The polygons disagree about what is inside: what is on the left of a side is inside, and "
    "holes run clockwise. Reverse the polygon of constraint 5, which disagrees with that of "
    "constraint 6.");
  FF_CHECK_EQUAL(saidOf(ErrorCode::NotConvex),
    "2: The domain is no convex polygon with finite corners, counter-clockwise.");
  FF_CHECK_EQUAL(saidOf(ErrorCode::DuplicateSites, 3, 7),
    "2: The points 3 and 7 are at one position, so their cells cannot have prescribed areas.");
  FF_CHECK_EQUAL(saidOf(ErrorCode::BadArea, 3, 2),
    "2: A prescribed area is not positive and finite: first at point 3, 2 such point(s) in all.");
  FF_CHECK_EQUAL(saidOf(ErrorCode::NoDevice),
    std::string("7: The CUDA engine was asked for, but ") + vtkFFAlgorithm::GetCUDAProblem() +
      ". Set Engine to Automatic or CPU.");
  FF_CHECK_EQUAL(saidOf(ErrorCode::DeviceMemory, -1, 1000),
    "7: The CUDA device has not enough memory for this input: 1000 bytes were refused. Set Engine "
    "to "
    "Automatic or CPU.");
  FF_CHECK_EQUAL(saidOf(ErrorCode::DeviceFailed, 700),
    "7: The CUDA device failed: error 700 of the CUDA runtime. Set Engine to Automatic or CPU.");
  FF_CHECK_EQUAL(
    saidOf(ErrorCode::Internal), "9: An internal error: please report it, with the input.");
  FF_CHECK_EQUAL(saidOf(ErrorCode::Aborted), "0");
}

void testOtherExceptions()
{
  FF_CHECK_EQUAL(
    said([] { throw std::bad_alloc(); }), "6: There is not enough memory for this input.");
  FF_CHECK_EQUAL(said([] { throw std::runtime_error("What it says."); }), "2: What it says.");
  FF_CHECK_EQUAL(said([] { throw std::out_of_range("A place."); }), "9: A place.");
  FF_CHECK_EQUAL(said([] { throw 7; }), "9: The engine failed for an unknown reason.");
  FF_CHECK_EQUAL(said([] { throw FFBadSetting("Set it."); }), "1: Set it.");
  FF_CHECK_EQUAL(said([] { throw FFBadConstraint("Mend it."); }), "5: Mend it.");
}

/// While the error or a warning is reported, nothing is left of the run, nor of the one before.
void testStateAsErrorsAreReported()
{
  vtkNew<vtkFFHullFilter> filter;
  filter->SetInputData(makePoints(cubeCorners()));
  filter->Update();
  int count = 0;
  vtkNew<vtkCallbackCommand> looker;
  looker->SetClientData(&count);
  looker->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      auto* const teller = vtkFFHullFilter::SafeDownCast(caller);
      FF_CHECK(hasForgotten(teller));
      FF_CHECK_EQUAL(teller->GetErrorCode(), (unsigned long)vtkFFErrorCode::InputError);
      ++*static_cast<int*>(data);
    });
  filter->AddObserver(vtkCommand::WarningEvent, looker);
  filter->AddObserver(vtkCommand::ErrorEvent, looker);
  FFRun run(filter, "A test");
  run.Do([] { throw std::runtime_error("What it says."); });
  run.Warnings.emplace_back("Mind it.");
  run.Finish({ filter->GetOutput() });
  FF_CHECK_EQUAL(count, 2);
}

}

int TestFFMessages(int, char*[])
{
  testErrorsOfTheEngine();
  testOtherExceptions();
  testStateAsErrorsAreReported();
  return result();
}
