// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The choice between engines: the report says which one ran and why, and the result never tells.
#include "CompareTriangulation.h"
#include "Engines.h"
#include "InputsWeighted.h"

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

TEST(Engines, TheCpuWhereItIsAskedFor)
{
  expectCpuResult(chosen(EngineChoice::CPU), EngineChoice::CPU);
}

TEST(Engines, AutomaticTakesTheCpuWhileNoMeasurementTellsOtherwise)
{
  expectCpuResult(EngineOptions(), EngineChoice::CPU);
  expectCpuResult(chosen(EngineChoice::Automatic, 1000000), EngineChoice::CPU);
}

TEST(Engines, StatusSaysWhatIsThere)
{
  const CudaStatus& status = cudaStatus();
  EXPECT_EQ(&status, &cudaStatus()) << "looks once";
  EXPECT_TRUE(status.built || !status.present);
  EXPECT_EQ(status.present, status.device[0] != '\0');
  EXPECT_EQ(status.present, status.problem[0] == '\0');
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
    int errors = 0;
    try
    {
      convexHull(viewOf(cloud), Options(), engine, report);
    }
    catch (const Error& error)
    {
      errors += error.code() == ErrorCode::NoDevice ? 1 : 0;
    }
    EXPECT_STRNE(report.reason, "");
    for (const WeightView& weights : { weightsOf(cloud), WeightView() })
    {
      try
      {
        regularTriangulation(viewOf(cloud), weights, Options(), engine, report);
      }
      catch (const Error& error)
      {
        errors += error.code() == ErrorCode::NoDevice ? 1 : 0;
      }
    }
    EXPECT_EQ(errors, 3);
  }
}

TEST(Engines, ErrorsOfTheInputAreTheSame)
{
  Cloud cloud = integerGrid(3);
  cloud[5][1] = std::numeric_limits<double>::infinity();
  for (EngineChoice choice : { EngineChoice::Automatic, EngineChoice::CPU })
  {
    EngineReport report;
    try
    {
      convexHull(viewOf(cloud), Options(), chosen(choice, 0), report);
      ADD_FAILURE() << "no error";
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.code(), ErrorCode::NonFinite);
      EXPECT_EQ(error.index(), 5);
    }
  }
}

}
}
}
