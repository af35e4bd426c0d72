// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Device/CudaBuilders.h"

#include "Device/CudaExecutor.h"
#include "Device/MissingDevice.h"
#include "FlipFlop/CpuBuilder.h"
#include "Geometry/HullCones.h"
#include "Geometry/HullLocator.h"
#include "Geometry/HullStart.h"
#include "Geometry/LiftedStart.h"
#include "Rounds/RoundsBuilder.h"

#include <cstdio>

namespace flipflop
{

namespace
{

template <class Geometry>
class DeviceBuilder : public CudaBuilder<Geometry>
{
public:
  ScanResult scan(const PointSource& source, Monitor& monitor) override
  {
    return this->rounds.scan(source, monitor);
  }

  BuildResult build(const BuildTask<Geometry>& task, Polyhedron&& start, Tally& tally,
    Statistics& statistics) override
  {
    if (task.geometry.isWide())
    {
      // Integers of any size are the host's.
      return CpuBuilder<Geometry>().build(task, std::move(start), tally, statistics);
    }
    BuildResult result = this->rounds.build(task, std::move(start), tally, statistics);
    this->ran = true;
    return result;
  }

private:
  CudaExecutor executor;
  RoundsBuilder<CudaExecutor, Geometry> rounds{ this->executor };
};

}

bool hasCudaKernels()
{
  return true;
}

int currentCudaDevice()
{
  int device = -1;
  if (cudaGetDevice(&device) != cudaSuccess)
  {
    cudaGetLastError();
    return -1;
  }
  return device;
}

void copyFromDevice(void* to, const void* from, std::size_t bytes)
{
  if (currentCudaDevice() < 0)
  {
    throw Error(ErrorCode::NoDevice);
  }
  if (bytes)
  {
    requireCuda(cudaMemcpy(to, from, bytes, cudaMemcpyDefault));
  }
}

DeviceFinding findCudaDevice()
{
  DeviceFinding found;
  CudaStatus& status = found.status;
  status.built = true;
  const auto fail = [&found](const char* what, cudaError_t error)
  {
    cudaGetLastError();
    std::snprintf(found.status.problem, sizeof(found.status.problem), "%s: %s", what,
      cudaGetErrorString(error));
    found.status.device[0] = '\0';
    // A device that is busy, or short of memory, may work in the next call.
    found.lasting = error == cudaErrorNoDevice || error == cudaErrorInsufficientDriver ||
      error == cudaErrorNoKernelImageForDevice || error == cudaErrorInvalidDeviceFunction ||
      error == cudaErrorNotSupported;
    return found;
  };
  int count = 0;
  cudaError_t error = cudaGetDeviceCount(&count);
  if (error == cudaErrorNoDevice || error == cudaErrorInsufficientDriver)
  {
    int driver = 0;
    int needed = 0;
    cudaDriverGetVersion(&driver);
    cudaRuntimeGetVersion(&needed);
    fail("", error);
    describeMissingDevice(driver, error == cudaErrorInsufficientDriver ? needed : 0, status.problem,
      sizeof(status.problem));
    return found;
  }
  if (error != cudaSuccess)
  {
    return fail("the CUDA devices do not answer", error);
  }
  int device = 0;
  cudaDeviceProp properties;
  error = cudaGetDevice(&device);
  error = error == cudaSuccess ? cudaGetDeviceProperties(&properties, device) : error;
  if (error != cudaSuccess)
  {
    return fail("the CUDA device does not answer", error);
  }
  std::snprintf(status.device, sizeof(status.device), "%s", properties.name);
  // Is there code for it? Asking for a kernel's attributes loads it.
  cudaFuncAttributes attributes;
  error = cudaFuncGetAttributes(&attributes, runKernel<Mark>);
  if (error != cudaSuccess)
  {
    return fail("this build has no code for the CUDA device", error);
  }
  int pools = 0;
  error = cudaDeviceGetAttribute(&pools, cudaDevAttrMemoryPoolsSupported, device);
  if (error != cudaSuccess || !pools)
  {
    return fail(
      "the CUDA device has no memory pools", error != cudaSuccess ? error : cudaErrorNotSupported);
  }
  status.present = true;
  return found;
}

template <class Geometry>
std::unique_ptr<CudaBuilder<Geometry>> makeCudaBuilder()
{
  return std::make_unique<DeviceBuilder<Geometry>>();
}

template std::unique_ptr<CudaBuilder<HullGeometry>> makeCudaBuilder();
template std::unique_ptr<CudaBuilder<LiftedGeometry<true>>> makeCudaBuilder();
template std::unique_ptr<CudaBuilder<LiftedGeometry<false>>> makeCudaBuilder();

}
