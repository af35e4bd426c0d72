// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which engine is to run, and why: what costs nothing is checked first, the device last.
#ifndef flipflop_EngineDecision_h
#define flipflop_EngineDecision_h

#include <flipflop/Engines.h>

#include <cstdint>
#include <cstdio>

namespace flipflop
{

inline void setReason(
  EngineReport& report, EngineChoice used, const char* reason, const char* more = "")
{
  report.used = used;
  std::snprintf(report.reason, sizeof(report.reason), "%.250s%.250s", reason, more);
}

/// Does the choice come to CUDA? Says why, if not.
/// @param hasKernels this build has kernels for a device
/// @param status     const CudaStatus& (): checks the device. Called only if nothing else speaks
///                   against it
/// @throw Error NoDevice
template <class Status>
bool wantsCuda(const EngineOptions& engine, std::int64_t pointCount, bool hasKernels,
  EngineReport& report, Status&& status)
{
  if (engine.choice == EngineChoice::CPU)
  {
    setReason(report, EngineChoice::CPU, "the CPU engine was asked for");
    return false;
  }
  const bool automatic = engine.choice == EngineChoice::Automatic;
  if (automatic && hasKernels && engine.cudaFrom == CudaPaysNever)
  {
    setReason(report, EngineChoice::CPU,
      "no measurement tells yet from how many points on the CUDA engine pays");
    return false;
  }
  if (automatic && hasKernels && pointCount < engine.cudaFrom)
  {
    setReason(report, EngineChoice::CPU, "there are too few points for the CUDA engine to pay");
    return false;
  }
  const CudaStatus& found = status();
  if (!found.present)
  {
    setReason(report, EngineChoice::CPU, found.problem);
    if (!automatic)
    {
      throw Error(ErrorCode::NoDevice);
    }
    return false;
  }
  setReason(report, EngineChoice::CUDA,
    automatic ? "there is a device, and enough points: " : "the CUDA engine was asked for: ",
    found.device);
  return true;
}

}

#endif
