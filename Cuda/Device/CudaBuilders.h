// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What Engines.cxx needs of a device. Two sources offer it: CudaBuilders.cu, and CudaAbsent.cxx
/// where there is no CUDA compiler.
#ifndef flipflop_CudaBuilders_h
#define flipflop_CudaBuilders_h

#include "FlipFlop/PolyhedronBuilder.h"
#include "Geometry/HullGeometry.h"
#include "Geometry/LiftedGeometry.h"
#include <flipflop/Engines.h>

#include <cstdio>
#include <memory>

namespace flipflop
{

/// What a check of a device has found.
struct DeviceFinding
{
  CudaStatus status;
  bool lasting = true; ///< another check would find the same
};

/// Has this build kernels for a device? Asks none.
bool hasCudaKernels();

/// The device that is current for the thread, -1 where there is none. Makes no context.
int currentCudaDevice();

/// Check that device.
DeviceFinding findCudaDevice();

/// The rounds on the present device.
template <class Geometry>
class CudaBuilder : public PolyhedronBuilder<Geometry>
{
public:
  bool ran = false; ///< a device has built the last polyhedron
};

/// @throw Error DeviceMemory, DeviceFailed; NoDevice where the build has no kernels
template <class Geometry>
std::unique_ptr<CudaBuilder<Geometry>> makeCudaBuilder();

}

#endif
