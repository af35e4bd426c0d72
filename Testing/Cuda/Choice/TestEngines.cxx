// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The choice between engines: the report says which one ran and why, and the result never tells.
#include "Choice/DeviceStatus.h"
#include "Choice/EngineDecision.h"
#include "Testing/Cuda/Rounds/EngineRuns.h"
#include "Testing/Engine/Conformance/CompareTriangulation.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"

#include <atomic>
#include <cstdio>
#include <thread>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

EngineOptions chosen(EngineChoice choice, std::int64_t cudaFrom = CudaPaysNever)
{
  EngineOptions options;
  options.choice = choice;
  options.cudaFrom = cudaFrom;
  return options;
}

/// Some clouds of every dimension.
std::vector<Cloud> clouds()
{
  return { {}, { { 1, 2, 3 } }, { { 0, 0, 0 }, { 1, 1, 1 } }, integerGrid(3),
    fromFamily("shell1e2", 500, 101).make(), fromWeightedFamily("uniform", 300, 102).make() };
}

/// The run by an engine, beside the CPU's.
void expectCpuResult(const EngineOptions& engine, EngineChoice used)
{
  for (const Cloud& cloud : clouds())
  {
    EngineReport report;
    const Hull hull = convexHull(viewOf(cloud), Options(), engine, report);
    EXPECT_EQ(bitDifference(hull, convexHull(viewOf(cloud))), "");
    EXPECT_EQ(report.used, used);
    EXPECT_STRNE(report.reason, "");
    for (const WeightView& weights : { weightsOf(cloud), WeightView() })
    {
      EngineReport second;
      const Triangulation found =
        regularTriangulation(viewOf(cloud), weights, Options(), engine, second);
      EXPECT_EQ(bitDifference(found, regularTriangulation(viewOf(cloud), weights)), "");
      EXPECT_EQ(second.used, used);
      EXPECT_STRNE(second.reason, "");
    }
  }
}

TEST(Engines, AutomaticTakesTheCpuWhileNoMeasurementTellsOtherwise)
{
  expectCpuResult(chosen(EngineChoice::CPU), EngineChoice::CPU);
  expectCpuResult(EngineOptions(), EngineChoice::CPU);
  expectCpuResult(chosen(EngineChoice::Automatic, 1000000), EngineChoice::CPU);
}

TEST(Engines, StatusSaysWhatIsThere)
{
  const CudaStatus& status = cudaStatus();
  EXPECT_TRUE(status.built || !status.present);
  EXPECT_EQ(status.present, status.device[0] != '\0');
  EXPECT_EQ(status.present, status.problem[0] == '\0');
}

/// What wantsCuda says of a build with kernels, and how often it looks at the device.
struct Decision
{
  bool wanted = false;
  int looks = 0;
  EngineReport report;
};

Decision decide(const EngineOptions& engine, std::int64_t points, bool present)
{
  CudaStatus status;
  status.built = true;
  status.present = present;
  std::snprintf(status.device, sizeof(status.device), "%s", present ? "a device" : "");
  std::snprintf(status.problem, sizeof(status.problem), "%s", present ? "" : "a problem");
  Decision decision;
  decision.wanted = wantsCuda(engine, points, true, decision.report,
    [&]() -> const CudaStatus&
    {
      ++decision.looks;
      return status;
    });
  EXPECT_EQ(decision.report.used, decision.wanted ? EngineChoice::CUDA : EngineChoice::CPU);
  return decision;
}

TEST(Engines, TheDeviceIsLookedAtLast)
{
  for (const bool present : { false, true })
  {
    EXPECT_EQ(decide(chosen(EngineChoice::CPU), 1000, present).looks, 0);
    EXPECT_EQ(decide(EngineOptions(), INT64_MAX - 1, present).looks, 0);
    const Decision few = decide(chosen(EngineChoice::Automatic, 1000), 999, present);
    EXPECT_EQ(few.looks, 0);
    EXPECT_FALSE(few.wanted);
    EXPECT_STREQ(few.report.reason, "there are too few points for the CUDA engine to pay");
    const Decision enough = decide(chosen(EngineChoice::Automatic, 1000), 1000, present);
    EXPECT_EQ(enough.looks, 1);
    EXPECT_EQ(enough.wanted, present);
  }
  EXPECT_STREQ(decide(chosen(EngineChoice::Automatic, 0), 0, false).report.reason, "a problem");
  EXPECT_STREQ(decide(chosen(EngineChoice::Automatic, 0), 0, true).report.reason,
    "there is a device, and enough points: a device");
  EXPECT_STREQ(decide(chosen(EngineChoice::CUDA), 0, true).report.reason,
    "the CUDA engine was asked for: a device");
  EXPECT_THROW(decide(chosen(EngineChoice::CUDA), 0, false), Error);
}

/// A look that finds as it is told, and counts.
struct Look
{
  bool present = true;
  bool lasting = true;
  int looks = 0;

  const CudaStatus& at(DeviceStatus& devices, int device)
  {
    return devices.of(device,
      [this, device]
      {
        ++this->looks;
        DeviceFinding found;
        found.status.present = this->present;
        found.lasting = this->lasting;
        std::snprintf(found.status.device, sizeof(found.status.device), "device %d", device);
        return found;
      });
  }
};

TEST(Engines, EachDeviceIsLookedAtOnce)
{
  DeviceStatus devices;
  Look look;
  const CudaStatus& first = look.at(devices, 0);
  EXPECT_STREQ(first.device, "device 0");
  EXPECT_STREQ(look.at(devices, 1).device, "device 1");
  for (int again = 0; again < 3; ++again)
  {
    EXPECT_EQ(&look.at(devices, 0), &first) << "what was returned stays";
    EXPECT_STREQ(look.at(devices, 1).device, "device 1");
  }
  EXPECT_EQ(look.looks, 2);
  std::vector<std::thread> threads;
  std::atomic<int> wrong{ 0 };
  for (int i = 0; i < 4; ++i)
  {
    threads.emplace_back([&] { wrong += look.at(devices, 2).present ? 0 : 1; });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(look.looks, 3);
}

TEST(Engines, AFailureThatPassesIsLookedAtAgain)
{
  DeviceStatus devices;
  Look look;
  look.present = look.lasting = false;
  EXPECT_FALSE(look.at(devices, 0).present);
  EXPECT_FALSE(look.at(devices, 0).present);
  EXPECT_EQ(look.looks, 2);
  look.present = look.lasting = true;
  EXPECT_TRUE(look.at(devices, 0).present);
  EXPECT_TRUE(look.at(devices, 0).present);
  EXPECT_EQ(look.looks, 3);
  // One that lasts is not.
  look.present = false;
  EXPECT_FALSE(look.at(devices, 1).present);
  EXPECT_FALSE(look.at(devices, 1).present);
  EXPECT_EQ(look.looks, 4);
  // A device whose number was not to be had is not taken for all such.
  look.present = true;
  EXPECT_TRUE(look.at(devices, -1).present);
  EXPECT_TRUE(look.at(devices, -1).present);
  EXPECT_EQ(look.looks, 6);
}

TEST(Engines, AutomaticWithoutADeviceTakesTheCpu)
{
  if (cudaStatus().present)
  {
    GTEST_SKIP() << "there is a device: " << cudaStatus().device;
  }
  expectCpuResult(chosen(EngineChoice::Automatic, 0), EngineChoice::CPU);
  EngineReport report;
  convexHull(viewOf(integerGrid(2)), Options(), chosen(EngineChoice::Automatic, 0), report);
  EXPECT_STREQ(report.reason, cudaStatus().problem);
}

TEST(Engines, CudaWithoutADeviceIsAnError)
{
  if (cudaStatus().present)
  {
    GTEST_SKIP() << "there is a device: " << cudaStatus().device;
  }
  for (const Cloud& cloud : clouds())
  {
    const EngineOptions engine = chosen(EngineChoice::CUDA);
    EngineReport report;
    const PointView points = viewOf(cloud);
    const int noDevice = static_cast<int>(ErrorCode::NoDevice);
    EXPECT_EQ(codeOf([&] { convexHull(points, Options(), engine, report); }), noDevice);
    EXPECT_STRNE(report.reason, "");
    EXPECT_EQ(
      codeOf([&] { regularTriangulation(points, weightsOf(cloud), Options(), engine, report); }),
      noDevice);
  }
}

TEST(Engines, ErrorsOfTheInputAreTheSame)
{
  Cloud cloud = integerGrid(3);
  cloud[5][1] = std::numeric_limits<double>::infinity();
  for (EngineChoice choice : { EngineChoice::Automatic, EngineChoice::CPU })
  {
    EngineReport report;
    expectError([&] { convexHull(viewOf(cloud), Options(), chosen(choice, 0), report); },
      ErrorCode::NonFinite, 5);
  }
}

}
}
}
