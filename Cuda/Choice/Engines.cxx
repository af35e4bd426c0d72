// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include <flipflop/Engines.h>

#include "Choice/DeviceStatus.h"
#include "Choice/EngineDecision.h"
#include "Device/CudaBuilders.h"
#include "FlipFlop/CpuBuilder.h"
#include "Run/HullRun.h"
#include "Run/TriangulationRun.h"
#include "Support/TypedErrors.h"

#include <cstdio>
#include <memory>
#include <string>

namespace flipflop
{

namespace
{

/// @tparam Run   a GeometryRun
/// @param make   Run (): anew for each try
/// @param work   Result (Run&, PolyhedronBuilder<Model>&)
template <class Model, class Result, class Make, class Work>
Result runEngine(const EngineOptions& engine, std::int64_t pointCount, EngineReport& report,
  Make&& make, Work&& work)
{
  if (wantsCuda(engine, pointCount, hasCudaKernels(), report, cudaStatus))
  {
    try
    {
      const auto builder = withTypedErrors([] { return makeCudaBuilder<Model>(); });
      auto run = make();
      Result result = work(*run, *builder);
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
  CpuBuilder<Model> onThreads;
  return work(*make(), onThreads);
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
  return runEngine<HullGeometry, Hull>(
    engine, points.count, report, [&] { return std::make_unique<HullRun>(points, options); },
    [](HullRun& run, PolyhedronBuilder<HullGeometry>& builder)
    { return run.execute<Hull>([&](Hull& hull) { run.hullOfPoints(builder, hull); }); });
}

Triangulation regularTriangulation(const PointView& points, const WeightView& weights,
  const Options& options, const EngineOptions& engine, EngineReport& report)
{
  return withOrWithoutWeights(weights,
    [&](auto weighted)
    {
      // By its type: GCC 16 takes the name for a use of the parameter in the lambda below.
      using Run = TriangulationRun<decltype(weighted)::value>;
      using Geometry = typename Run::Geometry;
      return runEngine<Geometry, Triangulation>(
        engine, points.count, report,
        [&] { return std::make_unique<Run>(points, weights, options); },
        [](Run& run, PolyhedronBuilder<Geometry>& builder)
        {
          return run.template execute<Triangulation>(
            [&](Triangulation& result) { run.triangulate(builder, result); });
        });
    });
}

}
