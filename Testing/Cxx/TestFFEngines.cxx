// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// The choice of the engine: which one ran and why is reported, and the output does not depend on
// it. Where there is no device, asking for one is an error.
#include "FFCases.h"
#include "FFPlanar.h"
#include "FFTest.h"

#include "vtkFFErrorCode.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"

#include <cstring>
#include <string>

using namespace fftest;

namespace
{

/// The filter runs, on the engine, for the reason.
void check(vtkFFAlgorithm* filter, int used, const std::string& reason = "")
{
  FF_CHECK(succeeds(filter));
  FF_CHECK_EQUAL(filter->GetEngineUsed(), used);
  FF_CHECK_EQUAL(std::string(filter->GetEngineUsedAsString()),
    used == vtkFFAlgorithm::ENGINE_CUDA ? "CUDA" : "CPU");
  FF_CHECK(strlen(filter->GetEngineReason()) > 0);
  const std::string found = filter->GetEngineReason();
  FF_CHECK_EQUAL(found.find(reason) != std::string::npos ? reason : found, reason);
}

/// No result, so no engine.
void checkFails(vtkFFAlgorithm* filter, unsigned long code, const std::vector<std::string>& parts)
{
  FF_CHECK(fails(filter, code, parts));
  FF_CHECK_EQUAL(filter->GetEngineUsed(), int(vtkFFAlgorithm::ENGINE_NONE));
  FF_CHECK_EQUAL(std::string(filter->GetEngineUsedAsString()), "None");
  FF_CHECK(strlen(filter->GetEngineReason()) > 0);
}

void testStatus()
{
  const bool available = vtkFFAlgorithm::IsCUDAAvailable();
  FF_CHECK_EQUAL(strlen(vtkFFAlgorithm::GetCUDADeviceName()) > 0, available);
  FF_CHECK_EQUAL(strlen(vtkFFAlgorithm::GetCUDAProblem()) > 0, !available);
}

/// A filter that has a choice.
void testChoice(vtkFFAlgorithm* filter)
{
  constexpr int cpu = vtkFFAlgorithm::ENGINE_CPU;
  constexpr int cuda = vtkFFAlgorithm::ENGINE_CUDA;
  const bool available = vtkFFAlgorithm::IsCUDAAvailable();
  filter->SetInputDataObject(randomWeighted(3000, 71));
  FF_CHECK_EQUAL(filter->GetEngine(), int(vtkFFAlgorithm::ENGINE_AUTOMATIC));
  FF_CHECK_EQUAL(filter->GetCUDAThreshold(), VTK_ID_MAX);
  check(filter, cpu);
  filter->SetEngine(vtkFFAlgorithm::ENGINE_CPU);
  check(filter, cpu, "asked for");
  vtkSmartPointer<vtkDataObject> reference;
  reference.TakeReference(filter->GetOutputDataObject(0)->NewInstance());
  reference->DeepCopy(filter->GetOutputDataObject(0));
  filter->SetEngine(vtkFFAlgorithm::ENGINE_AUTOMATIC);
  for (const vtkIdType threshold : { 3001, 3000, 0 })
  {
    filter->SetCUDAThreshold(threshold);
    const bool isCuda = available && threshold <= 3000;
    check(filter, isCuda ? cuda : cpu,
      isCuda                ? vtkFFAlgorithm::GetCUDADeviceName()
        : threshold <= 3000 ? vtkFFAlgorithm::GetCUDAProblem()
                            : "");
    FF_CHECK(isIdentical(filter->GetOutputDataObject(0), reference, "automatic"));
  }
  filter->SetEngine(vtkFFAlgorithm::ENGINE_CUDA);
  if (available)
  {
    check(filter, cuda, vtkFFAlgorithm::GetCUDADeviceName());
    FF_CHECK(isIdentical(filter->GetOutputDataObject(0), reference, "CUDA"));
  }
  else
  {
    checkFails(filter, vtkFFErrorCode::DeviceError,
      { "The CUDA engine was asked for, but ", vtkFFAlgorithm::GetCUDAProblem(),
        "Set Engine to Automatic or CPU" });
  }
  filter->SetEngine(vtkFFAlgorithm::ENGINE_AUTOMATIC); // none the worse for it
  check(filter, available ? cuda : cpu);
}

/// One that has none.
void testNoChoice(vtkFFAlgorithm* filter, const std::string& reason)
{
  filter->SetInputDataObject(makeVoxels({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }));
  filter->SetCUDAThreshold(0);
  check(filter, vtkFFAlgorithm::ENGINE_CPU, reason);
  filter->SetEngine(vtkFFAlgorithm::ENGINE_CUDA);
  if (filter->IsA("vtkFFConvexifyFilter")) // takes no other
  {
    FF_CHECK_EQUAL(filter->GetEngine(), int(vtkFFAlgorithm::ENGINE_CPU));
  }
  else
  {
    checkFails(
      filter, vtkFFErrorCode::SettingError, { "The CUDA engine was asked for, but " + reason });
    filter->SetEngine(vtkFFAlgorithm::ENGINE_CPU);
  }
  check(filter, vtkFFAlgorithm::ENGINE_CPU, "asked for");
}

void testSettings()
{
  vtkNew<vtkFFHullFilter> hull;
  const vtkMTimeType before = hull->GetMTime();
  hull->SetCUDAThreshold(1000);
  FF_CHECK(hull->GetMTime() > before);
  hull->SetCUDAThreshold(-5);
  FF_CHECK_EQUAL(hull->GetCUDAThreshold(), 0);
  hull->SetEngine(99);
  FF_CHECK_EQUAL(hull->GetEngine(), int(vtkFFAlgorithm::ENGINE_CUDA));
  hull->SetEngine(-99);
  FF_CHECK_EQUAL(hull->GetEngine(), int(vtkFFAlgorithm::ENGINE_AUTOMATIC));
}

/// All in a plane: there is nothing for an engine to do.
void testFlat()
{
  auto flat = randomPoints(500, 73);
  for (Point& p : flat)
  {
    p[2] = 0.5;
  }
  vtkNew<vtkFFHullFilter> hull;
  hull->SetInputData(makePoints(flat));
  if (vtkFFAlgorithm::IsCUDAAvailable())
  {
    hull->SetEngine(vtkFFAlgorithm::ENGINE_CUDA);
    check(hull, vtkFFAlgorithm::ENGINE_CPU, "span too little");
  }
}

/// CUDA if any block used it, and then because of such a block, whatever the order.
void testBlocks()
{
  for (const int first : { 100, 2000 })
  {
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(0, makePoints(randomPoints(first, 74)));
    blocks->SetBlock(1, makePoints(randomPoints(2100 - first, 75)));
    vtkNew<vtkFFHullFilter> hull;
    hull->SetInputDataObject(blocks);
    hull->SetCUDAThreshold(1000);
    // Without one, it is the last block's reason. The device is checked only for enough points, if
    // the build has an engine for one.
    const std::string problem = vtkFFAlgorithm::GetCUDAProblem();
    const bool neverChecks = problem.find("this build has no CUDA engine") != std::string::npos;
    const bool available = vtkFFAlgorithm::IsCUDAAvailable();
    check(hull, available ? vtkFFAlgorithm::ENGINE_CUDA : vtkFFAlgorithm::ENGINE_CPU,
      available                       ? vtkFFAlgorithm::GetCUDADeviceName()
        : first == 100 || neverChecks ? problem
                                      : "too few points");
  }
}

}

int TestFFEngines(int, char*[])
{
  testStatus();
  for (const FilterCase& of : filterCases())
  {
    const auto filter = of.New();
    if (!of.TakesSurface && !filter->IsA("vtkFFTerrainMeshFilter"))
    {
      testChoice(filter);
    }
  }
  testNoChoice(vtkNew<vtkFFConvexifyFilter>(), "this filter runs on the CPU");
  vtkNew<vtkFFRegularTriangulationFilter> constrained;
  constrained->SetSourceData(makeConstraints({ { 0, 1 } }));
  testNoChoice(constrained, "constraints are the CPU's");
  testNoChoice(vtkNew<vtkFFTerrainMeshFilter>(), "terrain meshes are the CPU's");
  testSettings();
  testFlat();
  testBlocks();
  return result();
}
