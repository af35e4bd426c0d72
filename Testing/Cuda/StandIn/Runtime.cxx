// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A stand-in for the CUDA runtime, for machines without a device: the calls that the CUDA engine
/// and its device test make, on threads and memory of the host. The program is linked with this in
/// cudart's place, from nvcc's own objects; so CudaExecutor.cu runs as it is.
///
/// What a device would do wrong in silence ends the program here: a launch or a copy out of bounds,
/// memory of the host where the device's should be, memory given back twice or not at all, a stream
/// of another device than the current one. So does what a host application would be disturbed by:
/// the default stream, streams that wait for it, a limit or a flag set for the whole device.
#include "Launch.h"
#include "Memory.h"
#include "Stream.h"

#include "Device/DeviceLists.h"

#include <cuda_runtime.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstring>
#include <memory>
#include <new>
#include <utility>
#include <vector>

using standin::Memory;
using standin::require;

struct CUmemPoolHandle_st
{
  int device = 0;
  standin::Pool pool;
};

namespace
{

thread_local cudaError_t lastError = cudaSuccess;
thread_local int currentDevice = 0;

/// Of the current device.
Memory& memoryHere()
{
  return Memory::get(currentDevice);
}
/// Pinned memory is everybody's.
Memory& hostMemory()
{
  return Memory::get(0);
}
/// The device that has it; -1: none.
int ownerOf(const void* memory)
{
  for (int device = 0; device < standin::MostDevices; ++device)
  {
    if (Memory::get(device).holds(memory, 1))
    {
      return device;
    }
  }
  return -1;
}

cudaError_t result(cudaError_t error)
{
  if (error != cudaSuccess)
  {
    lastError = error;
  }
  return error;
}

cudaError_t allocation(void** memory, void* block)
{
  *memory = block;
  return result(block ? cudaSuccess : cudaErrorMemoryAllocation);
}

/// Copies of words that nothing had been written to: harmless, but compute-sanitizer calls them
/// errors.
std::atomic<long> unwrittenCopies{ 0 };

void noteUnwritten(const void* from, std::size_t bytes)
{
  if (hostMemory().isUnwritten(from, bytes))
  {
    ++unwrittenCopies;
  }
}

CUstream_st& streamOf(cudaStream_t stream)
{
  require(stream != nullptr, "the default stream is used, which waits for others");
  require(stream->device == currentDevice, "a stream of another device than the current one");
  return *stream;
}

struct Configuration
{
  dim3 blocks;
  dim3 threads;
  std::size_t shared = 0;
  cudaStream_t stream = nullptr;
};
thread_local Configuration configuration;

}

// ---- What nvcc's code calls by itself
// ------------------------------------------------------------------------------

extern "C"
{
  void** __cudaRegisterFatBinary(void*)
  {
    static void* handle = nullptr;
    return &handle;
  }
  void __cudaRegisterFatBinaryEnd(void**) {}
  void __cudaUnregisterFatBinary(void**) {}
  void __cudaRegisterVar(void**, char*, char*, const char*, int, std::size_t, int, int) {}
  void __cudaRegisterFunction(
    void**, const char* function, char*, const char* name, int, uint3*, uint3*, dim3*, dim3*, int*)
  {
    standin::registerKernel(function, name);
  }
  unsigned __cudaPushCallConfiguration(
    dim3 blocks, dim3 threads, std::size_t shared, CUstream_st* stream)
  {
    configuration = { blocks, threads, shared, stream };
    return 0;
  }
  cudaError_t __cudaPopCallConfiguration(
    dim3* blocks, dim3* threads, std::size_t* shared, void* stream)
  {
    *blocks = configuration.blocks;
    *threads = configuration.threads;
    *shared = configuration.shared;
    *static_cast<cudaStream_t*>(stream) = configuration.stream;
    return cudaSuccess;
  }
  cudaError_t __cudaGetKernel(cudaKernel_t* kernel, const void* function)
  {
    *kernel = reinterpret_cast<cudaKernel_t>(const_cast<void*>(function));
    return cudaSuccess;
  }
  cudaError_t __cudaLaunchKernel(cudaKernel_t kernel, dim3 blocks, dim3 threads, void** arguments,
    std::size_t, cudaStream_t stream)
  {
    require(blocks.y == 1 && blocks.z == 1 && threads.y == 1 && threads.z == 1,
      "a launch of more than one dimension");
    standin::launch(kernel, blocks.x, threads.x, arguments, streamOf(stream));
    return cudaSuccess;
  }
}

// ---- The device
// ------------------------------------------------------------------------------------------------------

cudaError_t cudaGetDeviceCount(int* count)
{
  *count = standin::MostDevices;
  return cudaSuccess;
}
cudaError_t cudaGetDevice(int* device)
{
  *device = currentDevice;
  return cudaSuccess;
}
cudaError_t cudaSetDevice(int device)
{
  if (device < 0 || device >= standin::MostDevices)
  {
    return result(cudaErrorInvalidDevice);
  }
  currentDevice = device;
  return cudaSuccess;
}
cudaError_t cudaDeviceGetLimit(std::size_t* value, cudaLimit)
{
  *value = 1024;
  return cudaSuccess;
}
cudaError_t cudaDeviceSetLimit(cudaLimit, std::size_t)
{
  standin::fail("a limit is set for the whole device");
}
cudaError_t cudaSetDeviceFlags(unsigned)
{
  standin::fail("flags are set for the whole device");
}
cudaError_t cudaGetDeviceProperties(cudaDeviceProp* properties, int)
{
  std::memset(properties, 0, sizeof(*properties));
  std::snprintf(properties->name, sizeof(properties->name), "a stand-in on the host's threads");
  properties->major = 9;
  return cudaSuccess;
}
cudaError_t cudaDeviceGetAttribute(int* value, cudaDeviceAttr attribute, int)
{
  switch (attribute)
  {
    case cudaDevAttrMultiProcessorCount:
      *value = standin::setting("STANDIN_MULTIPROCESSORS", 1);
      return cudaSuccess;
    case cudaDevAttrMemoryPoolsSupported:
      *value = 1;
      return cudaSuccess;
    default:
      standin::fail("an attribute of the device that it does not know");
  }
}
cudaError_t cudaFuncGetAttributes(cudaFuncAttributes* attributes, const void*)
{
  std::memset(attributes, 0, sizeof(*attributes));
  return cudaSuccess;
}
cudaError_t cudaDriverGetVersion(int* version)
{
  *version = CUDART_VERSION;
  return cudaSuccess;
}
cudaError_t cudaRuntimeGetVersion(int* version)
{
  *version = CUDART_VERSION;
  return cudaSuccess;
}
cudaError_t cudaGetLastError()
{
  const cudaError_t error = lastError;
  lastError = cudaSuccess;
  return error;
}
cudaError_t cudaPeekAtLastError()
{
  return lastError;
}
const char* cudaGetErrorString(cudaError_t)
{
  return "an error of the stand-in";
}
cudaError_t cudaDeviceSynchronize()
{
  return cudaSuccess; // nothing is given to the default stream but what is done at once
}
cudaError_t cudaDeviceReset()
{
  for (int device = 0; device < standin::MostDevices; ++device)
  {
    Memory& memory = Memory::get(device);
    require(memory.blocks() == 0 && memory.free() == memory.total(), "memory of a device is left");
  }
  std::printf("the stand-in: %ld launches, %ld copies of memory that nobody wrote\n",
    standin::launches(), unwrittenCopies.load());
  return cudaSuccess;
}

// ---- Streams and events
// ------------------------------------------------------------------------------------------------

cudaError_t cudaStreamCreateWithFlags(cudaStream_t* stream, unsigned flags)
{
  require(flags == cudaStreamNonBlocking, "a stream that waits for the default stream");
  *stream = new CUstream_st(currentDevice);
  return cudaSuccess;
}
cudaError_t cudaStreamDestroy(cudaStream_t stream)
{
  delete stream;
  return cudaSuccess;
}
cudaError_t cudaStreamSynchronize(cudaStream_t stream)
{
  streamOf(stream).wait();
  return cudaSuccess;
}
cudaError_t cudaEventCreate(cudaEvent_t* event)
{
  *event = new CUevent_st;
  return cudaSuccess;
}
cudaError_t cudaEventCreateWithFlags(cudaEvent_t* event, unsigned)
{
  return cudaEventCreate(event);
}
cudaError_t cudaEventDestroy(cudaEvent_t event)
{
  delete event;
  return cudaSuccess;
}
cudaError_t cudaEventRecord(cudaEvent_t event, cudaStream_t stream)
{
  event->record(streamOf(stream));
  return cudaSuccess;
}
cudaError_t cudaEventSynchronize(cudaEvent_t event)
{
  event->wait();
  return cudaSuccess;
}
cudaError_t cudaEventElapsedTime(float* milliseconds, cudaEvent_t, cudaEvent_t)
{
  *milliseconds = 1; // no time of a stand-in is a figure
  return cudaSuccess;
}

// ---- Memory
// ----------------------------------------------------------------------------------------------------------

cudaError_t cudaMallocHost(void** memory, std::size_t bytes)
{
  return allocation(memory, hostMemory().takePinned(bytes));
}
cudaError_t cudaHostAlloc(void** memory, std::size_t bytes, unsigned flags)
{
  require(flags == cudaHostAllocMapped, "pinned memory of a kind that it does not know");
  return allocation(memory, hostMemory().takeMapped(bytes));
}
cudaError_t cudaHostGetDevicePointer(void** pointer, void* memory, unsigned)
{
  *pointer = hostMemory().onDevice(memory);
  return result(*pointer ? cudaSuccess : cudaErrorInvalidValue);
}
cudaError_t cudaFreeHost(void* memory)
{
  hostMemory().givePinned(memory);
  return cudaSuccess;
}
cudaError_t cudaMalloc(void** memory, std::size_t bytes)
{
  return allocation(memory, memoryHere().take(bytes));
}
cudaError_t cudaFree(void* memory)
{
  if (memory)
  {
    const int owner = ownerOf(memory);
    require(owner >= 0, "memory is given back that is no device's");
    Memory::get(owner).give(memory);
  }
  return cudaSuccess;
}
cudaError_t cudaMallocFromPoolAsync(
  void** memory, std::size_t bytes, cudaMemPool_t pool, cudaStream_t stream)
{
  require(streamOf(stream).device == pool->device, "a pool of another device than the stream's");
  return allocation(memory, memoryHere().take(bytes, &pool->pool));
}
cudaError_t cudaFreeAsync(void* memory, cudaStream_t stream)
{
  require(memoryHere().holds(memory, 1), "memory is given back that is not the device's");
  streamOf(stream).give([memory, from = &memoryHere()] { from->give(memory); });
  return cudaSuccess;
}
cudaError_t cudaMemPoolCreate(cudaMemPool_t* pool, const cudaMemPoolProps* properties)
{
  *pool = new CUmemPoolHandle_st;
  (*pool)->device = properties->location.id;
  return cudaSuccess;
}
cudaError_t cudaMemPoolDestroy(cudaMemPool_t pool)
{
  require(pool->pool.used == 0, "a pool goes whose memory is in use");
  Memory::get(pool->device).trim(pool->pool, 0);
  delete pool;
  return cudaSuccess;
}
cudaError_t cudaMemPoolSetAttribute(cudaMemPool_t, cudaMemPoolAttr, void*)
{
  return cudaSuccess;
}
cudaError_t cudaMemPoolTrimTo(cudaMemPool_t pool, std::size_t kept)
{
  Memory::get(pool->device).trim(pool->pool, kept);
  return cudaSuccess;
}
cudaError_t cudaMemGetInfo(std::size_t* free, std::size_t* total)
{
  *free = memoryHere().free();
  *total = memoryHere().total();
  return cudaSuccess;
}
cudaError_t cudaPointerGetAttributes(cudaPointerAttributes* attributes, const void* memory)
{
  std::memset(attributes, 0, sizeof(*attributes));
  attributes->device = ownerOf(memory);
  attributes->type = attributes->device >= 0 ? cudaMemoryTypeDevice : cudaMemoryTypeUnregistered;
  return cudaSuccess;
}

// ---- Copies
// ------------------------------------------------------------------------------------------------------------

cudaError_t cudaMemcpy(void* to, const void* from, std::size_t bytes, cudaMemcpyKind)
{
  std::memcpy(to, from, bytes); // of the default stream, which our streams do not wait for
  return cudaSuccess;
}
cudaError_t cudaMemsetAsync(void* to, int byte, std::size_t bytes, cudaStream_t stream)
{
  require(bytes == 0 || memoryHere().holds(to, bytes), "memory is filled out of bounds");
  streamOf(stream).give([=] { std::memset(to, byte, bytes); });
  return cudaSuccess;
}
cudaError_t cudaMemcpyAsync(
  void* to, const void* from, std::size_t bytes, cudaMemcpyKind kind, cudaStream_t stream)
{
  Memory& memory = memoryHere();
  CUstream_st& queue = streamOf(stream);
  if (bytes == 0)
  {
    return cudaSuccess;
  }
  if (kind == cudaMemcpyHostToDevice)
  {
    require(memory.holds(to, bytes) && ownerOf(from) < 0, "a copy to the device");
    if (hostMemory().isPinned(from, bytes))
    {
      queue.give([=] { std::memcpy(to, from, bytes); });
    }
    else // it is taken at once, and copied later
    {
      const auto* const begin = static_cast<const char*>(from);
      queue.give([to, own = std::vector<char>(begin, begin + bytes)]
        { std::memcpy(to, own.data(), own.size()); });
    }
    return cudaSuccess;
  }
  require(memory.holds(from, bytes), "a copy from the device");
  const auto copy = [=]
  {
    noteUnwritten(from, bytes);
    std::memcpy(to, from, bytes);
  };
  if (kind == cudaMemcpyDeviceToDevice)
  {
    require(memory.holds(to, bytes), "a copy on the device");
    queue.give(copy);
    return cudaSuccess;
  }
  require(kind == cudaMemcpyDeviceToHost && ownerOf(to) < 0, "a copy to the host");
  queue.give(copy);
  if (!hostMemory().isPinned(to, bytes)) // it is waited for
  {
    queue.wait();
  }
  return cudaSuccess;
}

// ---- In CUB's place
// ------------------------------------------------------------------------------------------------------

namespace flipflop
{

cudaError_t exclusivePrefixSum(
  void* scratch, std::size_t& bytes, std::uint32_t* values, std::uint32_t n, cudaStream_t stream)
{
  if (!scratch)
  {
    bytes = 1;
    return cudaSuccess;
  }
  require(memoryHere().holds(values, n * sizeof(std::uint32_t)), "a prefix sum out of bounds");
  require(memoryHere().holds(scratch, bytes), "the scratch memory of a prefix sum");
  streamOf(stream).give(
    [values, n]
    {
      std::uint32_t sum = 0;
      for (std::uint32_t i = 0; i < n; ++i)
      {
        const std::uint32_t value = values[i];
        values[i] = sum;
        sum += value;
      }
    });
  return cudaSuccess;
}

/// Like CUB's it leaves the result in either buffer, as the number of passes has it, and spoils the
/// other.
cudaError_t sortPairs(void* scratch, std::size_t& bytes, std::uint64_t* const* keys,
  std::uint32_t* const* values, std::uint32_t n, int bits, int& at, cudaStream_t stream)
{
  if (!scratch)
  {
    bytes = 1;
    return cudaSuccess;
  }
  Memory& memory = memoryHere();
  for (int i = 0; i < 2; ++i)
  {
    require(memory.holds(keys[i], n * sizeof(std::uint64_t)), "keys out of bounds");
    require(memory.holds(values[i], n * sizeof(std::uint32_t)), "values out of bounds");
  }
  require(memory.holds(scratch, bytes), "the scratch memory of a sort");
  require(bits > 0 && bits <= 64, "the bits of a sort");
  at = (bits + 7) / 8 & 1;
  streamOf(stream).give(
    [=, fromKeys = keys[0], fromValues = values[0], toKeys = keys[at], toValues = values[at],
      spoiltKeys = keys[at ^ 1], spoiltValues = values[at ^ 1]]
    {
      std::vector<std::pair<std::uint64_t, std::uint32_t>> pairs(n);
      for (std::uint32_t i = 0; i < n; ++i)
      {
        require(bits == 64 || fromKeys[i] >> bits == 0, "a key has more bits than it should");
        pairs[i] = { fromKeys[i], fromValues[i] };
      }
      std::stable_sort(
        pairs.begin(), pairs.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
      for (std::uint32_t i = 0; i < n; ++i)
      {
        spoiltKeys[i] = ~std::uint64_t(0);
        spoiltValues[i] = ~std::uint32_t(0);
        toKeys[i] = pairs[i].first;
        toValues[i] = pairs[i].second;
      }
    });
  return cudaSuccess;
}

}
