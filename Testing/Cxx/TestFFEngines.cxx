// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// The choice of the engine: which one ran and why is told, and the output never tells. Where there
// is no device, asking for one is an error.
#include "FFTest.h"

#include <flipflop/Error.h>

#include "vtkErrorCode.h"
#include "vtkFFConvexifyFilter.h"
#include "vtkFFHullInternals.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"

#include <cstring>
#include <limits>
#include <string>

using namespace fftest;

namespace
{

/// False says that a part of the test is skipped.
bool hasDevice(const char* test)
{
  if (!vtkFFAlgorithm::IsCUDAAvailable())
  {
    std::cout << test << ": skipped, " << vtkFFAlgorithm::GetCUDAProblem() << "\n";
    return false;
  }
  return true;
}

bool hasNoDevice(const char* test)
{
  if (vtkFFAlgorithm::IsCUDAAvailable())
  {
    std::cout << test << ": skipped, there is a device: " << vtkFFAlgorithm::GetCUDADeviceName()
              << "\n";
    return false;
  }
  return true;
}

void checkEngine(vtkFFAlgorithm* filter, int used, const std::string& reason = "")
{
  FF_CHECK_EQUAL(filter->GetErrorCode(), vtkErrorCode::NoError);
  FF_CHECK_EQUAL(filter->GetEngineUsed(), used);
  FF_CHECK(strlen(filter->GetEngineReason()) > 0);
  if (std::string(filter->GetEngineReason()).find(reason) == std::string::npos)
  {
    std::cerr << "not because " << reason << ": " << filter->GetEngineReason() << "\n";
    ++failures();
  }
}

vtkSmartPointer<vtkPolyData> copyOf(vtkPolyData* output)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(output);
  return copy;
}

/// The kinds of work that have a choice: hulls, and triangulations without weights and with.
const char* const Works[] = { "hull", "Delaunay", "regular" };

struct Filter
{
  vtkSmartPointer<vtkFFAlgorithm> Algorithm;
  vtkSmartPointer<ErrorObserver> Errors;
};

Filter makeFilter(const std::string& work, vtkPolyData* input)
{
  Filter filter;
  if (work == "hull")
  {
    filter.Algorithm = vtkSmartPointer<vtkFFHullFilter>::New();
  }
  else
  {
    auto triangulation = vtkSmartPointer<vtkFFRegularTriangulationFilter>::New();
    if (work == "regular")
    {
      useWeights(triangulation);
    }
    filter.Algorithm = triangulation;
  }
  filter.Algorithm->SetInputDataObject(input);
  filter.Errors = ErrorObserver::Of(filter.Algorithm);
  return filter;
}

vtkSmartPointer<vtkPolyData> makeInput(int count)
{
  std::vector<double> weights;
  for (const Point& p : randomPoints(count, 72))
  {
    weights.push_back(0.01 * p[0]);
  }
  return makeWeighted(randomPoints(count, 71), weights);
}

/// The outputs of the CPU engine.
std::vector<vtkSmartPointer<vtkPolyData>> cpuOutputs(const Filter& filter)
{
  filter.Algorithm->SetEngineToCPU();
  filter.Algorithm->Update();
  checkEngine(filter.Algorithm, vtkFFAlgorithm::ENGINE_CPU, "asked for");
  std::vector<vtkSmartPointer<vtkPolyData>> outputs;
  for (int port = 0; port < filter.Algorithm->GetNumberOfOutputPorts(); ++port)
  {
    outputs.push_back(copyOf(filter.Algorithm->GetOutput(port)));
  }
  FF_CHECK(outputs[0]->GetNumberOfPolys() > 0);
  return outputs;
}

void checkOutputs(const Filter& filter, const std::vector<vtkSmartPointer<vtkPolyData>>& reference)
{
  FF_CHECK(filter.Errors->Messages.empty());
  for (int port = 0; port < filter.Algorithm->GetNumberOfOutputPorts(); ++port)
  {
    vtkPolyData* found = filter.Algorithm->GetOutput(port);
    vtkPolyData* expected = reference[static_cast<std::size_t>(port)];
    FF_CHECK((isEmpty(found) && isEmpty(expected)) || isSame(found, expected));
  }
}

void testStatus()
{
  const bool available = vtkFFAlgorithm::IsCUDAAvailable();
  FF_CHECK_EQUAL(strlen(vtkFFAlgorithm::GetCUDADeviceName()) > 0, available);
  FF_CHECK_EQUAL(strlen(vtkFFAlgorithm::GetCUDAProblem()) > 0, !available);
}

/// Automatic is the CPU while no threshold says otherwise, and below the threshold.
void testAutomatic()
{
  for (const char* work : Works)
  {
    const Filter filter = makeFilter(work, makeInput(3000));
    FF_CHECK_EQUAL(filter.Algorithm->GetEngine(), int(vtkFFAlgorithm::ENGINE_AUTOMATIC));
    FF_CHECK_EQUAL(filter.Algorithm->GetCUDAThreshold(), VTK_ID_MAX);
    const auto reference = cpuOutputs(filter);
    filter.Algorithm->SetEngineToAutomatic();
    filter.Algorithm->Update();
    checkEngine(filter.Algorithm, vtkFFAlgorithm::ENGINE_CPU);
    checkOutputs(filter, reference);
    filter.Algorithm->SetCUDAThreshold(3001);
    filter.Algorithm->Update();
    checkEngine(filter.Algorithm, vtkFFAlgorithm::ENGINE_CPU);
    checkOutputs(filter, reference);
  }
}

void testThreshold()
{
  const Filter filter = makeFilter("hull", makeInput(100));
  filter.Algorithm->Update();
  const vtkMTimeType before = filter.Algorithm->GetMTime();
  filter.Algorithm->SetCUDAThreshold(1000);
  FF_CHECK(filter.Algorithm->GetMTime() > before);
  filter.Algorithm->SetCUDAThreshold(-5);
  FF_CHECK_EQUAL(filter.Algorithm->GetCUDAThreshold(), 0);
}

void testWithoutDevice()
{
  if (!hasNoDevice("testWithoutDevice"))
  {
    return;
  }
  for (const char* work : Works)
  {
    const Filter filter = makeFilter(work, makeInput(3000));
    const auto reference = cpuOutputs(filter);
    filter.Algorithm->SetEngineToAutomatic();
    filter.Algorithm->SetCUDAThreshold(0);
    filter.Algorithm->Update();
    checkEngine(filter.Algorithm, vtkFFAlgorithm::ENGINE_CPU, vtkFFAlgorithm::GetCUDAProblem());
    checkOutputs(filter, reference);

    filter.Algorithm->SetEngineToCUDA();
    filter.Algorithm->Update();
    FF_CHECK_EQUAL(filter.Errors->Messages.size(), std::size_t(1));
    FF_CHECK(filter.Errors->Has("The CUDA engine was asked for, but "));
    FF_CHECK(filter.Errors->Has(vtkFFAlgorithm::GetCUDAProblem()));
    FF_CHECK(filter.Errors->Has("Set Engine to Automatic or CPU"));
    FF_CHECK(filter.Algorithm->GetErrorCode() != vtkErrorCode::NoError);
    FF_CHECK_EQUAL(filter.Algorithm->GetEngineUsed(), int(vtkFFAlgorithm::ENGINE_NONE));
    FF_CHECK(strlen(filter.Algorithm->GetEngineReason()) > 0);
    FF_CHECK_EQUAL(filter.Algorithm->GetDimension(), -1);
    FF_CHECK_EQUAL(filter.Algorithm->GetNumberOfInputPoints(), 0);
    for (int port = 0; port < filter.Algorithm->GetNumberOfOutputPorts(); ++port)
    {
      FF_CHECK(isEmpty(filter.Algorithm->GetOutput(port)));
    }

    // None the worse for it.
    filter.Errors->Clear();
    filter.Algorithm->SetEngineToAutomatic();
    filter.Algorithm->Update();
    checkEngine(filter.Algorithm, vtkFFAlgorithm::ENGINE_CPU);
    checkOutputs(filter, reference);
  }
}

void testWithDevice()
{
  if (!hasDevice("testWithDevice"))
  {
    return;
  }
  for (const char* work : Works)
  {
    const Filter filter = makeFilter(work, makeInput(3000));
    const auto reference = cpuOutputs(filter);
    filter.Algorithm->SetEngineToCUDA();
    filter.Algorithm->Update();
    checkEngine(filter.Algorithm, vtkFFAlgorithm::ENGINE_CUDA, vtkFFAlgorithm::GetCUDADeviceName());
    FF_CHECK(!strcmp(filter.Algorithm->GetEngineUsedAsString(), "CUDA"));
    checkOutputs(filter, reference);
    FF_CHECK_EQUAL(filter.Algorithm->GetNumberOfInputPoints(), 3000);
    FF_CHECK(filter.Algorithm->GetNumberOfInsertions() > 0);
    FF_CHECK_EQUAL(filter.Algorithm->GetNumberOfFlips22() + filter.Algorithm->GetNumberOfFlips31(),
      filter.Algorithm->GetNumberOfFlipsByVolume() + filter.Algorithm->GetNumberOfFlipsByDegree());

    filter.Algorithm->SetEngineToAutomatic();
    filter.Algorithm->SetCUDAThreshold(3000);
    filter.Algorithm->Update();
    checkEngine(filter.Algorithm, vtkFFAlgorithm::ENGINE_CUDA, vtkFFAlgorithm::GetCUDADeviceName());
    checkOutputs(filter, reference);
    filter.Algorithm->SetCUDAThreshold(3001);
    filter.Algorithm->Update();
    checkEngine(filter.Algorithm, vtkFFAlgorithm::ENGINE_CPU, "too few");
    checkOutputs(filter, reference);
  }

  // All in a plane: there is nothing for an engine to do.
  auto flat = randomPoints(500, 73);
  for (Point& p : flat)
  {
    p[2] = 0.5;
  }
  const Filter hull = makeFilter("hull", makePoints(flat));
  const auto reference = cpuOutputs(hull);
  hull.Algorithm->SetEngineToCUDA();
  hull.Algorithm->Update();
  checkEngine(hull.Algorithm, vtkFFAlgorithm::ENGINE_CPU, "span too little");
  checkOutputs(hull, reference);
}

/// CUDA if any block used it, and then because of such a block, whatever the order.
void testBlocks()
{
  for (const int first : { 100, 2000 })
  {
    const auto one = makePoints(randomPoints(first, 74));
    const auto two = makePoints(randomPoints(2100 - first, 75));
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(0, one);
    blocks->SetBlock(1, two);
    vtkNew<vtkFFHullFilter> hull;
    hull->SetInputDataObject(blocks);
    hull->SetCUDAThreshold(1000);
    hull->Update();
    if (hasDevice("testBlocks"))
    {
      checkEngine(hull, vtkFFAlgorithm::ENGINE_CUDA, vtkFFAlgorithm::GetCUDADeviceName());
    }
    else
    {
      // What is told is the last block's reason: the device is looked at only for enough points,
      // if the build has an engine for one.
      const std::string problem = vtkFFAlgorithm::GetCUDAProblem();
      const bool neverLooks = problem.find("this build has no CUDA engine") != std::string::npos;
      checkEngine(
        hull, vtkFFAlgorithm::ENGINE_CPU, first == 100 || neverLooks ? problem : "too few points");
    }
    auto* output = vtkMultiBlockDataSet::SafeDownCast(hull->GetOutputDataObject(0));
    FF_CHECK(isHullOf(one, vtkPolyData::SafeDownCast(output->GetBlock(0)), 3));
    FF_CHECK(isHullOf(two, vtkPolyData::SafeDownCast(output->GetBlock(1)), 3));
  }
}

void testConvexify()
{
  vtkNew<vtkFFConvexifyFilter> convexify;
  const auto errors = ErrorObserver::Of(convexify);
  convexify->SetInputData(makeVoxels({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }));
  convexify->SetCUDAThreshold(0);
  convexify->Update();
  checkEngine(convexify, vtkFFAlgorithm::ENGINE_CPU, "this filter runs on the CPU");
  const auto reference = copyOf(convexify->GetOutput());
  FF_CHECK(reference->GetNumberOfPolys() > 0);

  convexify->SetEngineToCUDA();
  convexify->Update();
  FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
  FF_CHECK(errors->Has("The CUDA engine was asked for, but this filter runs on the CPU"));
  FF_CHECK(convexify->GetErrorCode() != vtkErrorCode::NoError);
  FF_CHECK_EQUAL(convexify->GetEngineUsed(), int(vtkFFAlgorithm::ENGINE_NONE));
  FF_CHECK(isEmpty(convexify->GetOutput()));

  convexify->SetEngineToCPU();
  convexify->Update();
  FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
  checkEngine(convexify, vtkFFAlgorithm::ENGINE_CPU, "asked for");
  FF_CHECK(isSame(convexify->GetOutput(), reference));
}

/// A run that fails gives no result, so it names no engine.
void testFailure()
{
  auto points = randomPoints(50, 76);
  points[7][1] = std::numeric_limits<double>::infinity();
  for (const char* work : Works)
  {
    const Filter filter =
      makeFilter(work, makeWeighted(points, std::vector<double>(points.size(), 0.0)));
    filter.Algorithm->SetCUDAThreshold(0);
    filter.Algorithm->Update();
    FF_CHECK_EQUAL(filter.Errors->Messages.size(), std::size_t(1));
    FF_CHECK(filter.Errors->Has("point 7,"));
    FF_CHECK_EQUAL(filter.Algorithm->GetEngineUsed(), int(vtkFFAlgorithm::ENGINE_NONE));
    FF_CHECK(!strcmp(filter.Algorithm->GetEngineUsedAsString(), "None"));
    FF_CHECK(strlen(filter.Algorithm->GetEngineReason()) > 0);
  }
}

}

int TestFFEngines(int, char*[])
{
  testStatus();
  testAutomatic();
  testThreshold();
  testWithoutDevice();
  testWithDevice();
  testBlocks();
  testConvexify();
  testFailure();
  return result();
}
