// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Memory.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace standin
{

namespace
{

constexpr std::size_t Page = 4096;
/// Two of it are a NaN as a double; one is no index.
constexpr std::uint32_t Poison = 0xFFFA5A5A;
/// Of a longer block only the first so many bytes are poisoned: the rest would take too long.
constexpr std::size_t MostPoisoned = std::size_t(64) << 20;

std::size_t wholePages(std::size_t bytes)
{
  return (bytes + Page - 1) / Page * Page;
}

void poison(void* at, std::size_t bytes)
{
  auto* word = static_cast<std::uint32_t*>(at);
  for (std::size_t i = 0; i < bytes / sizeof(Poison); ++i)
  {
    word[i] = Poison;
  }
}

/// Does one of the blocks have all of it?
bool contain(const std::map<const char*, std::size_t>& blocks, const void* from, std::size_t bytes)
{
  const auto* at = static_cast<const char*>(from);
  auto block = blocks.upper_bound(at);
  if (block == blocks.begin())
  {
    return false;
  }
  --block;
  return at + bytes <= block->first + block->second;
}

}

void fail(const char* what)
{
  std::fprintf(stderr, "The stand-in for CUDA: %s\n", what);
  std::abort();
}

int setting(const char* name, int byDefault)
{
  const char* const text = std::getenv(name);
  return text ? std::atoi(text) : byDefault;
}

Memory::Memory(int device)
{
  constexpr std::uint64_t each = (DeviceEnd - DeviceBegin) / MostDevices;
  this->next = reinterpret_cast<char*>(DeviceBegin) + static_cast<std::uint64_t>(device) * each;
  this->end = this->next + each;
}

Memory& Memory::get(int device)
{
  // For good: what is released last is released late.
  static Memory* const memories[MostDevices] = { new Memory(0), new Memory(1) };
  return *memories[device];
}

void* Memory::take(std::size_t bytes, Pool* pool)
{
  const std::lock_guard<std::mutex> lock(this->mutex);
  const std::size_t had = pool ? std::min(bytes, pool->reserved - pool->used) : 0;
  if (bytes - had > this->total() - this->used)
  {
    return nullptr;
  }
  this->used += bytes - had;
  if (pool)
  {
    pool->used += bytes;
    pool->reserved += bytes - had;
  }
  const std::size_t mapped = wholePages(bytes);
  char* const begin = this->next;
  this->next += mapped + Page; // the page behind it stays out of reach
  require(this->next < this->end, "no addresses are left");
  void* const got = mmap(begin, mapped, PROT_READ | PROT_WRITE,
    MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED | MAP_NORESERVE, -1, 0);
  require(got == begin, "there is no memory for the device");
  poison(begin, mapped < MostPoisoned ? mapped : MostPoisoned);
  // As far back as the alignment of CUB and of 32-byte sectors allows.
  char* const block = begin + (mapped - bytes) / 32 * 32;
  this->live[block] = bytes;
  if (pool)
  {
    this->pools[block] = pool;
  }
  return block;
}

void Memory::give(void* block)
{
  const std::lock_guard<std::mutex> lock(this->mutex);
  const auto found = this->live.find(static_cast<char*>(block));
  require(found != this->live.end(), "memory is given back that was not taken");
  char* const begin = static_cast<char*>(block) - reinterpret_cast<std::uintptr_t>(block) % Page;
  const std::size_t mapped =
    wholePages(found->second + static_cast<std::size_t>(static_cast<char*>(block) - begin));
  void* const got =
    mmap(begin, mapped, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED | MAP_NORESERVE, -1, 0);
  require(got == begin, "memory cannot be given back");
  const auto pool = this->pools.find(static_cast<char*>(block));
  if (pool == this->pools.end())
  {
    this->used -= found->second;
  }
  else
  {
    pool->second->used -= found->second; // it stays reserved
    this->pools.erase(pool);
  }
  this->live.erase(found);
}

void Memory::trim(Pool& pool, std::size_t kept)
{
  const std::lock_guard<std::mutex> lock(this->mutex);
  const std::size_t rest = std::max(pool.used, std::min(pool.reserved, kept));
  this->used -= pool.reserved - rest;
  pool.reserved = rest;
}

bool Memory::holds(const void* from, std::size_t bytes)
{
  const std::lock_guard<std::mutex> lock(this->mutex);
  return contain(this->live, from, bytes);
}

bool Memory::isUnwritten(const void* from, std::size_t bytes)
{
  const char* at = static_cast<const char*>(from);
  for (std::size_t i = 0; i + sizeof(Poison) <= bytes; i += sizeof(Poison))
  {
    if (std::memcmp(at + i, &Poison, sizeof(Poison)) == 0)
    {
      return true;
    }
  }
  return false;
}

void* Memory::takePinned(std::size_t bytes)
{
  void* const block = std::aligned_alloc(Page, wholePages(bytes));
  require(block != nullptr, "there is no memory for a pinned buffer");
  poison(block, wholePages(bytes));
  const std::lock_guard<std::mutex> lock(this->mutex);
  this->pinned[static_cast<char*>(block)] = bytes;
  return block;
}

void* Memory::takeMapped(std::size_t bytes)
{
  const std::lock_guard<std::mutex> lock(this->mutex);
  const std::size_t size = wholePages(bytes);
  const int file = memfd_create("mapped", 0);
  require(file >= 0 && ftruncate(file, static_cast<off_t>(size)) == 0, "no memory to map");
  void* const host = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  void* const device =
    mmap(this->next, size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_FIXED_NOREPLACE, file, 0);
  close(file);
  require(host != MAP_FAILED && device == this->next, "memory cannot be mapped twice");
  this->next += size + Page;
  poison(host, size);
  this->mapped[static_cast<char*>(host)] = static_cast<char*>(device);
  this->pinned[static_cast<char*>(host)] = bytes;
  return host;
}

void* Memory::onDevice(const void* host)
{
  const std::lock_guard<std::mutex> lock(this->mutex);
  const auto found = this->mapped.find(static_cast<const char*>(host));
  return found == this->mapped.end() ? nullptr : found->second;
}

void Memory::givePinned(void* block)
{
  if (block)
  {
    const std::lock_guard<std::mutex> lock(this->mutex);
    const auto twice = this->mapped.find(static_cast<char*>(block));
    if (twice != this->mapped.end())
    {
      const std::size_t size = wholePages(this->pinned.at(static_cast<char*>(block)));
      munmap(twice->second, size);
      munmap(block, size);
      this->pinned.erase(static_cast<char*>(block));
      this->mapped.erase(twice);
      return;
    }
    require(this->pinned.erase(static_cast<char*>(block)) == 1,
      "a pinned buffer is given back that was not taken");
    std::free(block);
  }
}

bool Memory::isPinned(const void* from, std::size_t bytes)
{
  const std::lock_guard<std::mutex> lock(this->mutex);
  return contain(this->pinned, from, bytes);
}

std::size_t Memory::total() const
{
  static const auto mebibytes = static_cast<std::size_t>(setting("STANDIN_MEBIBYTES", 8192));
  return mebibytes << 20;
}

std::size_t Memory::free()
{
  const std::lock_guard<std::mutex> lock(this->mutex);
  return this->total() - this->used;
}

std::size_t Memory::blocks()
{
  const std::lock_guard<std::mutex> lock(this->mutex);
  return this->live.size();
}

}
