// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Hulls and triangulations by a chosen engine: the CPU engine, or the CUDA engine if this build
/// and this machine have it. The result is the same bit for bit.
#ifndef flipflop_Engines_h
#define flipflop_Engines_h

#include <flipflop/ConvexHull.h>
#include <flipflop/RegularTriangulation.h>

#include <cstddef>
#include <cstdint>

namespace flipflop
{

/// Which engine is to run, or ran.
enum class EngineChoice
{
  Automatic, ///< CUDA if there is a device and the input is large enough, otherwise CPU
  CPU,       ///< on this machine's cores
  CUDA       ///< an error if there is no device for it
};

/// The default threshold: never CUDA. The crossover has not been measured.
constexpr std::int64_t CudaPaysNever = INT64_MAX;

/// How the engine is chosen.
struct EngineOptions
{
  EngineChoice choice = EngineChoice::Automatic; ///< what the caller requests

  /// Automatic uses the CUDA engine for this many points or more.
  std::int64_t cudaFrom = CudaPaysNever;
};

/// Which engine ran, and why that one.
struct EngineReport
{
  EngineChoice used = EngineChoice::CPU; ///< CPU or CUDA
  char reason[512] = "";                 ///< a clause without a full stop
};

/// What this build and this machine have for the CUDA engine.
struct CudaStatus
{
  bool built = false;     ///< this build has kernels for a device
  bool present = false;   ///< there is also a device that can run them
  char device[256] = "";  ///< the device's name
  char problem[256] = ""; ///< why there is none
};

/// Checks the thread's current device: once for each device, and again if the device failed only
/// temporarily. The check takes up to a second, and uses memory of the device.
/// @return valid until the thread's next call
const CudaStatus& cudaStatus();

/// Release the memory of the device that is kept for the next run: at most an eighth of the
/// device's memory for each of the last two runs that ran at once.
void releaseCudaMemory();

/// Copies from the memory of the thread's current device, after what was given to the device's
/// default stream before.
/// @param to    space for that many bytes
/// @param from  on the device
/// @param bytes how many
/// @throw Error NoDevice, DeviceFailed
void copyFromDevice(void* to, const void* from, std::size_t bytes);

/// convexHull(points, options), by the chosen engine.
/// @param points  any number up to 2^32 - 2
/// @param options see Options
/// @param engine  how the engine is chosen
/// @param report  receives which engine ran, and why
/// @return the same hull, bit for bit, for either engine
/// @throw Error   the errors of convexHull; NoDevice, DeviceMemory, DeviceFailed if CUDA is chosen
///                (with Automatic, the CPU does such a run)
Hull convexHull(const PointView& points, const Options& options, const EngineOptions& engine,
  EngineReport& report);

/// regularTriangulation(points, weights, options), by the chosen engine.
/// @param points  any number up to 2^32 - 2
/// @param weights one for each point, or none
/// @param options see Options
/// @param engine  how the engine is chosen
/// @param report  receives which engine ran, and why
/// @return the same triangulation, bit for bit, for either engine
/// @throw Error   the errors of regularTriangulation, and the CUDA errors of convexHull
Triangulation regularTriangulation(const PointView& points, const WeightView& weights,
  const Options& options, const EngineOptions& engine, EngineReport& report);

}

#endif
