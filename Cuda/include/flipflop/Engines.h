// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Hulls and triangulations by a chosen engine: the CPU's, or CUDA's where this build and this
/// machine have it. The result is the same bit for bit.
#ifndef flipflop_Engines_h
#define flipflop_Engines_h

#include <flipflop/ConvexHull.h>
#include <flipflop/RegularTriangulation.h>

#include <cstdint>

namespace flipflop
{

/// Which engine is to do the work, or did it.
enum class EngineChoice
{
  Automatic, ///< CUDA where there is a device and the input is large enough to pay, else CPU
  CPU,       ///< on this machine's cores
  CUDA       ///< or an error
};

/// From how many points on the CUDA engine pays is for measurements to tell; there are none yet.
constexpr std::int64_t CudaPaysNever = INT64_MAX;

/// How the engine is chosen.
struct EngineOptions
{
  EngineChoice choice = EngineChoice::Automatic; ///< what the caller asks for

  /// Automatic takes the CUDA engine from so many points on.
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
  bool present = false;   ///< and there is a device that can run them
  char device[256] = "";  ///< its name
  char problem[256] = ""; ///< why there is none
};

/// Looks at the device that is current for the thread: once at each, and again where it only failed
/// for now. The look takes up to a second, and memory of the device.
/// @return valid until the thread's next call
const CudaStatus& cudaStatus();

/// Give back to the device the memory that is kept for the next run: at most an eighth of the
/// device's for each of the last two runs that ran at once.
void releaseCudaMemory();

/// As convexHull(points, options), by the engine that is chosen.
/// @param points  any number of them up to 2^32 - 2
/// @param options see Options
/// @param engine  what the choice goes by
/// @param report  gets which engine it was, and why
/// @return the same hull, bit for bit, whichever engine it was
/// @throw Error   the same; NoDevice, DeviceMemory, DeviceFailed where CUDA is chosen
///                (Automatic leaves such a run to the CPU)
Hull convexHull(const PointView& points, const Options& options, const EngineOptions& engine,
  EngineReport& report);

/// As regularTriangulation(points, weights, options), by the engine that is chosen.
/// @param points  any number of them up to 2^32 - 2
/// @param weights one for each point, or without data
/// @param options see Options
/// @param engine  what the choice goes by
/// @param report  gets which engine it was, and why
/// @return the same triangulation, bit for bit, whichever engine it was
/// @throw Error   the same, and as convexHull
Triangulation regularTriangulation(const PointView& points, const WeightView& weights,
  const Options& options, const EngineOptions& engine, EngineReport& report);

}

#endif
