// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// However points are projected, the work asks on its way whether to go on, and stops when told to.
#include "FFPlanar.h"

#include "vtkFFProjection.h"
#include <flipflop/Error.h>
#include <flipflop/Options.h>

#include "vtkFFRegularTriangulationFilter.h"
#include "vtkObjectFactory.h"
#include "vtkTransform.h"

#include <functional>
#include <vector>

using namespace fftest;

namespace
{

constexpr int pointCount = 300000;

/// Counts how often it is asked, and says no at one of the calls.
struct Watch
{
  int Calls = 0;
  int StopAt = 0;

  flipflop::Options GetOptions()
  {
    flipflop::Options options;
    options.progress = [](double fraction, void* self)
    {
      FF_CHECK_EQUAL(fraction, 0.0);
      auto* watch = static_cast<Watch*>(self);
      return ++watch->Calls != watch->StopAt;
    };
    options.progressContext = this;
    return options;
  }
};

/// The work is stopped at each of its calls, of which there are so many at least.
void testStops(int least, const std::function<void(vtkFFProjection&)>& work)
{
  Watch watch;
  vtkFFProjection whole(watch.GetOptions());
  work(whole);
  const int calls = watch.Calls;
  FF_CHECK(calls >= least);
  for (int stopAt = 1; stopAt <= calls; ++stopAt)
  {
    Watch stopping{ 0, stopAt };
    vtkFFProjection projection(stopping.GetOptions());
    bool stopped = false;
    try
    {
      work(projection);
    }
    catch (const flipflop::Error& error)
    {
      stopped = error.code() == flipflop::ErrorCode::Aborted;
    }
    FF_CHECK(stopped);
    FF_CHECK_EQUAL(stopping.Calls, stopAt);
  }
}

void testEachProjection()
{
  std::vector<double> coordinates;
  for (const Point& p : randomPoints(pointCount, 81))
  {
    coordinates.insert(coordinates.end(), p.begin(), p.end());
  }
  const flipflop::PointView points(coordinates.data(), pointCount);
  testStops(1, [&](vtkFFProjection& projection) { projection.ToXY(points); });
  // The centre, the mean and the spread are each a pass over all points.
  testStops(13, [&](vtkFFProjection& projection) { projection.ToBestFittingPlane(points); });
  vtkNew<vtkTransform> transform;
  testStops(4, [&](vtkFFProjection& projection) { projection.ByTransform(points, transform); });
}

/// A transform during which somebody asks the filter to stop.
class StoppingTransform : public vtkTransform
{
public:
  static StoppingTransform* New();
  vtkTypeMacro(StoppingTransform, vtkTransform);

  using vtkTransform::InternalTransformPoint;
  void InternalTransformPoint(const double in[3], double out[3]) override
  {
    this->Superclass::InternalTransformPoint(in, out);
    if (++this->Calls == 1000)
    {
      this->Filter->SetAbortExecute(1);
    }
  }

  vtkFFRegularTriangulationFilter* Filter = nullptr;
  int Calls = 0;
};
vtkStandardNewMacro(StoppingTransform);

void testFilterStops()
{
  Watched<vtkFFRegularTriangulationFilter> run(makePoints(randomPoints(pointCount, 82)));
  vtkNew<StoppingTransform> transform;
  transform->Filter = run.Get();
  run->SetTransform(transform);
  FF_CHECK(isEmpty(run.Run()));
  FF_CHECK(transform->Calls >= 1000);
  FF_CHECK(transform->Calls < pointCount);
}

}

int TestFFProjection(int, char*[])
{
  testEachProjection();
  testFilterStops();
  return result();
}
