// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The stand-in's launches: nvcc's PTX as C++ (Testing/Cuda/Ptx), run by several threads at once
/// over the launch's blocks in a random order.
#ifndef flipflop_standin_Launch_h
#define flipflop_standin_Launch_h

struct CUstream_st;

namespace standin
{

/// A __global__ function: its address on the host stands for the kernel of that name.
void registerKernel(const void* function, const char* mangledName);

/// Run it in the stream's order. @param arguments each points at one; they are copied
void launch(
  const void* function, unsigned blocks, unsigned threads, void** arguments, CUstream_st& stream);

/// How many launches there were.
long launches();

}

#endif
