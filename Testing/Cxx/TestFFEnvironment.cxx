// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Outputs do not depend on the floating-point environment of the thread that updates a filter, and
// observers of progress have that environment.
#include "FFPlanar.h"

#include "vtkFFHullFilter.h"
#include "vtkFFPointInterpolator2D.h"
#include "vtkFFPowerDiagramFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkFFSelectEnclosedPoints.h"
#include "vtkImageData.h"
#include "vtkTransform.h"

#include <cfenv>
#include <functional>
#include <limits>
#include <memory>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

using namespace fftest;

namespace
{

constexpr int flush = -1; // no rounding mode has this number

/// While it lives, this thread rounds so, or flushes subnormal numbers to zero.
class Environment
{
public:
  explicit Environment(int rounding)
  {
    std::fegetenv(&this->Before);
    if (rounding != flush)
    {
      std::fesetround(rounding);
    }
#if defined(__SSE2__)
    else
    {
      _mm_setcsr(_mm_getcsr() | 0x8040);
    }
#endif
  }
  Environment(const Environment&) = delete;
  void operator=(const Environment&) = delete;
  ~Environment()
  {
    std::fesetenv(&this->Before);
  }

  /// A third, rounded as this thread rounds; less if the least double is zero to it.
  static double Sample()
  {
    volatile double one = 1.0, three = 3.0, least = std::numeric_limits<double>::denorm_min();
    return one / three - (least > 0.0 ? 0.0 : 1.0);
  }

private:
  std::fenv_t Before;
};

/// What observers of progress find.
class SampleObserver : public vtkCommand
{
public:
  static SampleObserver* New() { return new SampleObserver; }
  vtkTypeMacro(SampleObserver, vtkCommand);
  void Execute(vtkObject*, unsigned long, void*) override
  {
    this->Samples.push_back(Environment::Sample());
  }
  std::vector<double> Samples;
};

struct Case
{
  const char* Name;
  std::function<vtkSmartPointer<vtkAlgorithm>()> Make;
};

template <class FilterT>
vtkSmartPointer<FilterT> make(vtkDataObject* input, const char* weights = nullptr)
{
  auto filter = vtkSmartPointer<FilterT>::New();
  filter->SetNumberOfThreads(2);
  filter->SetInputDataObject(input);
  if (weights)
  {
    useWeights(filter, weights);
  }
  return filter;
}

/// A grid of decimal fractions, with such weights, at heights that are subnormal.
vtkSmartPointer<vtkPolyData> decimalGrid()
{
  constexpr int side = 100;
  std::vector<Point> points;
  std::vector<double> weights;
  for (int i = 0; i < side * side; ++i)
  {
    const int x = i % side, y = i / side;
    points.push_back({ 0.1 * x, 0.1 * y, (x * y % 7) * std::numeric_limits<double>::denorm_min() });
    weights.push_back(0.01 * ((7 * x + 3 * y) % 5));
  }
  return makeWeighted(points, weights);
}

vtkSmartPointer<vtkImageData> image()
{
  auto data = vtkSmartPointer<vtkImageData>::New();
  data->SetDimensions(70, 60, 5);
  data->SetSpacing(0.1, 0.1, 5e-324);
  data->SetOrigin(0.7, 0.3, 0.0);
  return data;
}

std::vector<Case> cases()
{
  const auto grid = decimalGrid();
  const auto tilted = randomWeighted(9000, 4);
  const auto planar = [=](auto filter)
  {
    filter->SetProjectionPlaneMode(vtkFFPlanarAlgorithm::BEST_FITTING_PLANE);
    filter->SetGenerateCellMeasures(true);
    return filter;
  };
  return {
    { "hull", [=] { return make<vtkFFHullFilter>(grid); } },
    { "hull of an image", [=] { return make<vtkFFHullFilter>(image()); } },
    { "triangulation", [=] { return make<vtkFFRegularTriangulationFilter>(grid, "weights"); } },
    { "triangulation in a plane",
      [=] { return planar(make<vtkFFRegularTriangulationFilter>(tilted, "weights")); } },
    { "triangulation by a transform",
      [=]
      {
        auto filter = make<vtkFFRegularTriangulationFilter>(tilted);
        vtkNew<vtkTransform> turn;
        turn->RotateX(30.0);
        turn->RotateY(40.0);
        filter->SetProjectionPlaneMode(vtkFFPlanarAlgorithm::TRANSFORM_PLANE);
        filter->SetTransform(turn);
        return filter;
      } },
    { "diagram", [=] { return planar(make<vtkFFPowerDiagramFilter>(tilted, "weights")); } },
    { "values",
      [=]
      {
        auto filter = make<vtkFFPointInterpolator2D>(image());
        filter->SetSourceData(grid);
        return filter;
      } },
    { "sides",
      [=]
      {
        auto filter = make<vtkFFSelectEnclosedPoints>(grid);
        filter->SetSurfaceData(makeVoxels({ { 0, 0, 0 }, { 1, 0, 0 } }));
        filter->SetGenerateDistances(true);
        return filter;
      } },
  };
}

}

int TestFFEnvironment(int, char*[])
{
  int differing = 0, runs = 0;
  for (const Case& one : cases())
  {
    auto wanted = one.Make();
    wanted->Update();
    FF_CHECK(wanted->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT) > 0);
    for (const int rounding : { flush, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO })
    {
      const std::string name = std::string(one.Name) + ", " + std::to_string(rounding);
      auto found = one.Make();
      vtkNew<SampleObserver> observer;
      found->AddObserver(vtkCommand::ProgressEvent, observer);
      double before = 0.0, after = 0.0;
      {
        const Environment environment(rounding);
        before = Environment::Sample();
        found->Update();
        after = Environment::Sample();
      }
      FF_CHECK_EQUAL(after, before);
      FF_CHECK(observer->Samples.size() > 1);
      for (const double sample : observer->Samples)
      {
        FF_CHECK_EQUAL(sample, before);
      }
      ++runs;
      differing +=
        !isIdentical(found->GetOutputDataObject(0), wanted->GetOutputDataObject(0), name);
    }
  }
  std::cout << differing << " of " << runs << " runs differ\n";
  FF_CHECK_EQUAL(differing, 0);
  return result();
}
