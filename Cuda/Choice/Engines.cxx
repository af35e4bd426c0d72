// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include <flipflop/Engines.h>

#include "Choice/DeviceStatus.h"
#include "Choice/EngineDecision.h"
#include "Device/CudaBuilders.h"
#include "FlipFlop/CpuBuilder.h"
#include "Run/HullRun.h"
#include "Run/TriangulationRun.h"
#include "Support/EngineCall.h"

#include <cstdio>
#include <memory>
#include <string>

namespace flipflop
{

namespace
{

/// @param makeRun std::unique_ptr<HullRun or TriangulationRun> (): called for each engine tried
template <class Geometry, class MakeRun>
auto runEngine(
  const EngineOptions& engine, std::int64_t pointCount, EngineReport& report, MakeRun&& makeRun)
{
  if (wantsCuda(engine, pointCount, hasCudaKernels(), report, cudaStatus))
  {
    try
    {
      const auto builder = makeCudaBuilder<Geometry>();
      const auto run = makeRun();
      auto result = run->compute(*builder);
      if (!builder->ran)
      {
        setReason(report, EngineChoice::CPU,
          run->arithmetic.wide
            ? "the coordinates' range needs integers of any size, which are the CPU's"
            : "the points span too little for an engine to have work");
      }
      return result;
    }
    catch (const Error& error)
    {
      // The rounds count too many points from bounds, a little earlier than the CPU does.
      const bool device = error.code() == ErrorCode::DeviceMemory ||
        error.code() == ErrorCode::DeviceFailed || error.code() == ErrorCode::NoDevice ||
        error.code() == ErrorCode::TooManyPoints;
      if (!device || engine.choice == EngineChoice::CUDA)
      {
        throw;
      }
      char number[32] = "";
      if (error.code() == ErrorCode::DeviceFailed)
      {
        std::snprintf(number, sizeof(number), " (CUDA error %d)", static_cast<int>(error.index()));
      }
      setReason(report, EngineChoice::CPU,
        ("the CUDA engine gave up: " + std::string(error.what())).c_str(), number);
    }
  }
  CpuBuilder<Geometry> onThreads;
  return makeRun()->compute(onThreads);
}

}

const CudaStatus& cudaStatus()
{
  static DeviceStatus devices;
  return devices.of(currentCudaDevice(), findCudaDevice);
}

Hull convexHull(const PointView& points, const Options& options, const EngineOptions& engine,
  EngineReport& report)
{
  return engineCall(
    [&]
    {
      return runEngine<HullGeometry>(
        engine, points.count, report, [&] { return std::make_unique<HullRun>(points, options); });
    });
}

Triangulation regularTriangulation(const PointView& points, const WeightView& weights,
  const Options& options, const EngineOptions& engine, EngineReport& report)
{
  return engineCall(
    [&]
    {
      return withOrWithoutWeights(points, weights,
        [&](auto weighted, const WeightView& thatMatter)
        {
          // By its type: GCC 16 takes the name for a use of the parameter in the lambda below.
          using Run = TriangulationRun<decltype(weighted)::value>;
          return runEngine<typename Run::Geometry>(engine, points.count, report,
            [&] { return std::make_unique<Run>(points, thatMatter, options); });
        });
    });
}

}
