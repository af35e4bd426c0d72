// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Device/CudaExecutor.h"

#include "Device/DeviceLists.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <cstring>
#include <mutex>

namespace flipflop
{

namespace
{

/// A piece of a large copy: long enough to pay, short enough to stay in the processor's cache.
constexpr std::size_t PieceBytes = std::size_t(4) << 20;

}

void requireCuda(cudaError_t error, std::int64_t bytes)
{
  if (error == cudaSuccess)
  {
    return;
  }
  cudaGetLastError(); // or the next call would report it again
  if (error == cudaErrorMemoryAllocation)
  {
    throw Error(ErrorCode::DeviceMemory, -1, bytes);
  }
  throw Error(ErrorCode::DeviceFailed, static_cast<std::int64_t>(error));
}

struct CudaSession
{
  int device = 0;
  cudaStream_t stream = nullptr;
  cudaMemPool_t pool = nullptr;
  std::size_t keptBytes = 0;             ///< of the pool, between runs
  void* piece[2] = { nullptr, nullptr }; ///< pinned
  cudaEvent_t pieceDone[2] = { nullptr, nullptr };
  RoundRecord* records = nullptr;         ///< pinned
  RoundRecord* recordsOnDevice = nullptr; ///< the same memory
  cudaEvent_t recordDone[CudaExecutor::Records] = {};
  cudaEvent_t timing[2] = { nullptr, nullptr };

  CudaSession()
  {
    try
    {
      requireCuda(cudaGetDevice(&this->device));
      requireCuda(cudaStreamCreateWithFlags(&this->stream, cudaStreamNonBlocking));
      cudaMemPoolProps properties;
      std::memset(&properties, 0, sizeof(properties));
      properties.allocType = cudaMemAllocationTypePinned; // CUDA's word for device memory, too
      properties.handleTypes = cudaMemHandleTypeNone;
      properties.location.type = cudaMemLocationTypeDevice;
      properties.location.id = this->device;
      requireCuda(cudaMemPoolCreate(&this->pool, &properties));
      // All that a run gives back is there for it again; what stays after it, trim() bounds.
      std::uint64_t keepAll = UINT64_MAX;
      requireCuda(cudaMemPoolSetAttribute(this->pool, cudaMemPoolAttrReleaseThreshold, &keepAll));
      std::size_t free = 0;
      std::size_t total = 0;
      requireCuda(cudaMemGetInfo(&free, &total));
      this->keptBytes = total / 8;
      for (int i = 0; i < 2; ++i)
      {
        requireCuda(cudaMallocHost(&this->piece[i], PieceBytes));
        requireCuda(cudaEventCreateWithFlags(&this->pieceDone[i], cudaEventDisableTiming));
        requireCuda(cudaEventCreate(&this->timing[i]));
      }
      void* memory = nullptr;
      requireCuda(
        cudaHostAlloc(&memory, CudaExecutor::Records * sizeof(RoundRecord), cudaHostAllocMapped));
      this->records = static_cast<RoundRecord*>(memory);
      requireCuda(cudaHostGetDevicePointer(&memory, this->records, 0));
      this->recordsOnDevice = static_cast<RoundRecord*>(memory);
      for (cudaEvent_t& event : this->recordDone)
      {
        requireCuda(cudaEventCreateWithFlags(&event, cudaEventDisableTiming));
      }
    }
    catch (...)
    {
      this->close();
      throw;
    }
  }
  CudaSession(const CudaSession&) = delete;
  CudaSession& operator=(const CudaSession&) = delete;
  ~CudaSession() { this->close(); }

  /// Give back what the pool holds beyond what is kept between runs. @return whether that worked.
  bool trim() { return cudaMemPoolTrimTo(this->pool, this->keptBytes) == cudaSuccess; }

private:
  void close() noexcept
  {
    const auto drop = [](cudaEvent_t event)
    {
      if (event)
      {
        cudaEventDestroy(event);
      }
    };
    for (int i = 0; i < 2; ++i)
    {
      drop(this->pieceDone[i]);
      drop(this->timing[i]);
      cudaFreeHost(this->piece[i]);
    }
    for (const cudaEvent_t event : this->recordDone)
    {
      drop(event);
    }
    cudaFreeHost(this->records);
    if (this->stream)
    {
      cudaStreamDestroy(this->stream);
    }
    if (this->pool)
    {
      cudaMemPoolDestroy(this->pool);
    }
    cudaGetLastError();
  }
};

namespace
{

/// Sessions that no run uses now.
struct IdleSessions
{
  /// Of one device; as many runs at once find all that they need.
  static constexpr std::ptrdiff_t MostIdle = 2;

  std::mutex mutex;
  std::vector<std::unique_ptr<CudaSession>> sessions;

  /// Never destroyed: at the process's end the driver may be gone first.
  static IdleSessions& get()
  {
    static auto* const idle = new IdleSessions;
    return *idle;
  }

  /// Where there are enough, or for want of memory, it is closed instead.
  void keep(std::unique_ptr<CudaSession> session) noexcept
  {
    try
    {
      const std::lock_guard<std::mutex> lock(this->mutex);
      const auto same = [&session](const std::unique_ptr<CudaSession>& other)
      { return other->device == session->device; };
      if (std::count_if(this->sessions.begin(), this->sessions.end(), same) < MostIdle)
      {
        this->sessions.push_back(std::move(session));
      }
    }
    catch (const std::exception&)
    {
    }
  }

  std::unique_ptr<CudaSession> acquire()
  {
    int device = 0;
    requireCuda(cudaGetDevice(&device));
    {
      const std::lock_guard<std::mutex> lock(this->mutex);
      for (std::unique_ptr<CudaSession>& session : this->sessions)
      {
        if (session->device == device)
        {
          std::swap(session, this->sessions.back());
          std::unique_ptr<CudaSession> found = std::move(this->sessions.back());
          this->sessions.pop_back();
          return found;
        }
      }
    }
    return std::make_unique<CudaSession>();
  }
};

}

void releaseCudaMemory()
{
  IdleSessions& idle = IdleSessions::get();
  const std::lock_guard<std::mutex> lock(idle.mutex);
  idle.sessions.clear();
}

CudaExecutor::CudaExecutor()
  : session(IdleSessions::get().acquire())
  , stream(session->stream)
{
  cudaGetLastError(); // another's error is not to be taken for one of ours
  int count = 1;
  requireCuda(
    cudaDeviceGetAttribute(&count, cudaDevAttrMultiProcessorCount, this->session->device));
  this->multiprocessors = static_cast<std::uint32_t>(count);
}

CudaExecutor::~CudaExecutor()
{
  this->release(this->scratch, this->scratchBytes);
  for (const auto& part : this->parts)
  {
    cudaEventDestroy(part.second);
  }
  // What a broken stream is good for is not known: it is not kept.
  if (cudaStreamSynchronize(this->stream) == cudaSuccess && this->session->trim())
  {
    IdleSessions::get().keep(std::move(this->session));
  }
  else
  {
    cudaGetLastError();
  }
}

void* CudaExecutor::allocate(std::size_t bytes)
{
  const auto acquire = [&](void** memory)
  {
    return cudaMallocFromPoolAsync(
      memory, std::max<std::size_t>(bytes, 1), this->session->pool, this->stream);
  };
  void* memory = nullptr;
  cudaError_t error = acquire(&memory);
  if (error == cudaErrorMemoryAllocation)
  {
    // What is kept for later runs, and what this one has given back, may be enough.
    cudaGetLastError();
    releaseCudaMemory();
    requireCuda(cudaStreamSynchronize(this->stream));
    requireCuda(cudaMemPoolTrimTo(this->session->pool, 0));
    error = acquire(&memory);
  }
  requireCuda(error, static_cast<std::int64_t>(bytes));
  this->bytesNow += static_cast<std::int64_t>(bytes);
  this->bytesMost = std::max(this->bytesMost, this->bytesNow);
  return memory;
}

void CudaExecutor::release(void* memory, std::size_t bytes) noexcept
{
  if (memory)
  {
    this->bytesNow -= static_cast<std::int64_t>(bytes);
    if (cudaFreeAsync(memory, this->stream) != cudaSuccess)
    {
      cudaGetLastError();
    }
  }
}

void CudaExecutor::fill(void* to, int byte, std::size_t bytes)
{
  requireCuda(cudaMemsetAsync(to, byte, bytes, this->stream));
}

void CudaExecutor::fromHost(void* to, const void* from, std::size_t bytes)
{
  for (std::size_t done = 0; done < bytes; done += PieceBytes)
  {
    const std::size_t size = std::min(PieceBytes, bytes - done);
    std::memcpy(this->session->piece[0], static_cast<const char*>(from) + done, size);
    requireCuda(cudaMemcpyAsync(static_cast<char*>(to) + done, this->session->piece[0], size,
      cudaMemcpyHostToDevice, this->stream));
    requireCuda(cudaEventRecord(this->session->pieceDone[0], this->stream));
    requireCuda(cudaEventSynchronize(this->session->pieceDone[0]));
  }
}

template <class Unpack>
void CudaExecutor::fetch(const void* from, std::size_t bytes, const Unpack& unpack)
{
  const Timing timing = this->before();
  const std::size_t pieces = (bytes + PieceBytes - 1) / PieceBytes;
  const auto sizeOf = [&](std::size_t i) { return std::min(PieceBytes, bytes - i * PieceBytes); };
  const auto fetch = [&](std::size_t i)
  {
    requireCuda(
      cudaMemcpyAsync(this->session->piece[i & 1], static_cast<const char*>(from) + i * PieceBytes,
        sizeOf(i), cudaMemcpyDeviceToHost, this->stream));
    requireCuda(cudaEventRecord(this->session->pieceDone[i & 1], this->stream));
  };
  for (std::size_t i = 0; i < pieces; ++i)
  {
    if (i == 0)
    {
      fetch(0);
    }
    if (i + 1 < pieces)
    {
      fetch(i + 1);
    }
    requireCuda(cudaEventSynchronize(this->session->pieceDone[i & 1]));
    // By several threads: the pages of a new array are made by those that write to them first.
    const auto* const piece = static_cast<const char*>(this->session->piece[i & 1]);
    eachChunk(sizeOf(i), std::size_t(1) << 17,
      [&](std::size_t begin, std::size_t end, std::size_t)
      { unpack(i * PieceBytes + begin, piece + begin, end - begin); });
  }
  this->after(timing, "to the host", nullptr, 1, static_cast<std::int64_t>(bytes));
}

void CudaExecutor::toHost(void* to, const void* from, std::size_t bytes)
{
  this->fetch(from, bytes,
    [to](std::size_t at, const char* packed, std::size_t size)
    { std::memcpy(static_cast<char*>(to) + at, packed, size); });
}

void CudaExecutor::toHostWidened(std::int64_t* to, const std::uint32_t* from, std::size_t n)
{
  this->fetch(from, n * sizeof(std::uint32_t),
    [to](std::size_t at, const char* packed, std::size_t size)
    {
      const auto* const values = reinterpret_cast<const std::uint32_t*>(packed);
      std::copy(values, values + size / sizeof(std::uint32_t), to + at / sizeof(std::uint32_t));
    });
}

void CudaExecutor::finish()
{
  requireCuda(cudaStreamSynchronize(this->stream));
}

template <class Work>
void CudaExecutor::withScratch(
  const char* name, std::uint32_t items, std::int64_t bytesPerItem, const Work& work)
{
  std::size_t bytes = 0;
  requireCuda(work(nullptr, bytes));
  if (bytes > this->scratchBytes)
  {
    this->release(this->scratch, this->scratchBytes);
    this->scratch = nullptr;
    this->scratchBytes = 0;
    this->scratch = this->allocate(2 * bytes);
    this->scratchBytes = 2 * bytes;
  }
  const Timing timing = this->before();
  bytes = this->scratchBytes;
  requireCuda(work(this->scratch, bytes));
  this->after(timing, name, nullptr, items, bytesPerItem);
}

void CudaExecutor::exclusiveSum(std::uint32_t* values, std::uint32_t n)
{
  this->withScratch("prefix sum", n, 2 * sizeof(std::uint32_t),
    [&](void* memory, std::size_t& bytes)
    { return exclusivePrefixSum(memory, bytes, values, n, this->stream); });
}

int CudaExecutor::sort(
  std::uint64_t* const* keys, std::uint32_t* const* values, std::uint32_t n, int bits)
{
  // Eight bits a pass, in which all is read and written once; the keys once more.
  const int passes = (bits + 7) / 8;
  const std::int64_t bytesEach = 2 * sizeof(std::uint64_t) + 2 * sizeof(std::uint32_t);
  int at = 0;
  this->withScratch("sort", n, passes * bytesEach + 8,
    [&](void* memory, std::size_t& bytes)
    { return sortPairs(memory, bytes, keys, values, n, bits, at, this->stream); });
  return at;
}

namespace
{

/// Can kernels on the current device read that memory?
bool isReadable(const void* memory)
{
  int device = 0;
  requireCuda(cudaGetDevice(&device));
  cudaPointerAttributes attributes;
  if (cudaPointerGetAttributes(&attributes, memory) != cudaSuccess)
  {
    cudaGetLastError();
    return false;
  }
  return attributes.type == cudaMemoryTypeManaged ||
    (attributes.type == cudaMemoryTypeDevice && attributes.device == device);
}

}

bool CudaExecutor::bring(const PointSource& points, Residence& residence,
  const std::function<void(std::uint32_t begin, std::uint32_t end)>& see)
{
  if (points.isOnDevice(isReadable))
  {
    return false;
  }
  const std::uint32_t count = points.count();
  const auto each = static_cast<std::size_t>(points.scalarsEach());
  const std::size_t bytesEach = each * (points.isOfFloats() ? sizeof(float) : sizeof(double));
  residence.clear();
  residence.memory = this->allocate(std::size_t(count) * bytesEach);
  residence.bytes = std::size_t(count) * bytesEach;
  const Timing timing = this->before();
  const std::uint64_t pieceCount = PieceBytes / bytesEach;
  std::uint32_t piece = 0;
  for (std::uint64_t begin = 0; begin < count; begin += pieceCount, ++piece)
  {
    const std::uint64_t end = std::min<std::uint64_t>(count, begin + pieceCount);
    const cudaEvent_t done = this->session->pieceDone[piece & 1];
    if (piece >= 2)
    {
      requireCuda(cudaEventSynchronize(done));
    }
    void* const packed = this->session->piece[piece & 1];
    eachChunk(end - begin, std::size_t(1) << 13,
      [&](std::size_t first, std::size_t last, std::size_t)
      {
        const auto from = static_cast<std::uint32_t>(begin + first);
        const auto to = static_cast<std::uint32_t>(begin + last);
        if (points.isOfFloats())
        {
          points.copyScalars(from, to, static_cast<float*>(packed) + each * first);
        }
        else
        {
          points.copyScalars(from, to, static_cast<double*>(packed) + each * first);
        }
        see(from, to);
      });
    requireCuda(cudaMemcpyAsync(static_cast<char*>(residence.memory) + begin * bytesEach, packed,
      (end - begin) * bytesEach, cudaMemcpyHostToDevice, this->stream));
    requireCuda(cudaEventRecord(done, this->stream));
  }
  // The pieces are free again for the next copy.
  for (const cudaEvent_t done : this->session->pieceDone)
  {
    requireCuda(cudaEventSynchronize(done));
  }
  this->after(timing, "from the host", nullptr, 1, static_cast<std::int64_t>(residence.bytes));
  return true;
}

PointSource CudaExecutor::resident(const PointSource& points, const Residence& residence)
{
  return residence.memory ? points.withScalars(residence.memory,
                              points.isOfFloats() ? ScalarType::Float32 : ScalarType::Float64)
                          : points.onDevice();
}

void CudaExecutor::Residence::clear() noexcept
{
  this->executor.release(this->memory, this->bytes);
  this->memory = nullptr;
}

RoundRecord* CudaExecutor::recordAt(int slot)
{
  return &this->session->recordsOnDevice[slot];
}

void CudaExecutor::record(int slot)
{
  requireCuda(cudaEventRecord(this->session->recordDone[slot], this->stream));
}

const RoundRecord& CudaExecutor::recorded(int slot)
{
  requireCuda(cudaEventSynchronize(this->session->recordDone[slot]));
  return this->session->records[slot];
}

void CudaExecutor::beginPart(const char* name)
{
  if (this->measuringParts)
  {
    cudaEvent_t event = nullptr;
    requireCuda(cudaEventCreate(&event));
    this->parts.emplace_back(name, event);
    requireCuda(cudaEventRecord(event, this->stream));
  }
}

std::map<std::string, double> CudaExecutor::partSeconds()
{
  this->finish();
  std::map<std::string, double> seconds;
  for (std::size_t i = 1; i < this->parts.size(); ++i)
  {
    float milliseconds = 0;
    requireCuda(
      cudaEventElapsedTime(&milliseconds, this->parts[i - 1].second, this->parts[i].second));
    if (this->parts[i - 1].first)
    {
      seconds[this->parts[i - 1].first] += 1e-3 * milliseconds;
    }
  }
  return seconds;
}

CudaExecutor::Timing CudaExecutor::before()
{
  Timing timing;
  if (this->measuring)
  {
    timing = { this->session->timing[0], this->session->timing[1] };
    requireCuda(cudaEventRecord(timing.begin, this->stream));
  }
  return timing;
}

void CudaExecutor::after(const Timing& timing, const char* name, const std::uint32_t* count,
  std::uint32_t most, std::int64_t bytesPerItem)
{
  KernelTally& tally = this->kernels.of(name);
  ++tally.launches;
  if (!this->measuring)
  {
    return;
  }
  requireCuda(cudaEventRecord(timing.end, this->stream));
  std::uint32_t items = most;
  if (count)
  {
    std::uint32_t counted = 0;
    requireCuda(
      cudaMemcpyAsync(&counted, count, sizeof(counted), cudaMemcpyDeviceToHost, this->stream));
    requireCuda(cudaStreamSynchronize(this->stream));
    items = std::min(most, counted);
  }
  requireCuda(cudaEventSynchronize(timing.end));
  float milliseconds = 0;
  requireCuda(cudaEventElapsedTime(&milliseconds, timing.begin, timing.end));
  tally.items += items;
  tally.bytes += items * bytesPerItem;
  tally.seconds += 1e-3 * milliseconds;
}

}
