// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// What cannot be done is an error that says what and where, with an empty output; the next run is
// none the worse for it.
#include "FFTest.h"

#include "vtkFFErrorCode.h"
#include "vtkFFHullFilter.h"
#include "vtkNew.h"

#include <limits>

using namespace fftest;

namespace
{

const double infinity = std::numeric_limits<double>::infinity();
const double nan = std::numeric_limits<double>::quiet_NaN();

void testNonFinite(int type)
{
  const auto good = randomPoints(1000, 31);
  for (const double value : { nan, infinity, -infinity })
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      auto points = good;
      points[123][static_cast<std::size_t>(axis)] = value;
      points[456][static_cast<std::size_t>(2 - axis)] = value;
      points[999] = { value, value, value };
      const auto input = makePoints(points, type);

      vtkNew<vtkFFHullFilter> hull;
      hull->SetInputData(input);
      for (int again = 0; again < 2; ++again) // and back
      {
        hull->SetNonFinitePointsToError();
        FF_CHECK(fails(hull, vtkFFErrorCode::NonFiniteError,
          { "A coordinate is NaN or infinite: first at point 123, 3 such point(s) in all." }));
        FF_CHECK_EQUAL(hull->GetNumberOfNonFinitePoints(), 3);

        // Left out, the others have their hull, with the ids of the whole input.
        hull->SetNonFinitePointsToIgnore();
        FF_CHECK(succeeds(hull));
        FF_CHECK_EQUAL(hull->GetNumberOfNonFinitePoints(), 3);
        FF_CHECK_EQUAL(hull->GetNumberOfInputPoints(), 1000);
        FF_CHECK(isHullOf(input, hull->GetOutput(), 3));
      }
    }
  }
}

void testNothingButNonFinite()
{
  const auto input = makePoints({ { nan, 0, 0 }, { 0, infinity, 0 } });
  vtkNew<vtkFFHullFilter> hull;
  hull->SetNonFinitePointsToIgnore();
  hull->SetInputData(input);
  FF_CHECK(succeeds(hull));
  FF_CHECK_EQUAL(hull->GetDimension(), -1);
  FF_CHECK_EQUAL(hull->GetNumberOfNonFinitePoints(), 2);
  FF_CHECK(isEmpty(hull->GetOutput()));
}

}

int TestFFHullFilterErrors(int, char*[])
{
  testNonFinite(VTK_DOUBLE);
  testNonFinite(VTK_FLOAT);
  testNothingButNonFinite();
  return result();
}
