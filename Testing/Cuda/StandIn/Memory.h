// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The stand-in's memory: of the devices, and pinned.
///
/// A device's memory is in an address range of its own, so what is confused with the host's or
/// another device's is noticed. Each block is poisoned, ends at a page that nobody may touch, and
/// its addresses are never used again.
#ifndef flipflop_standin_Memory_h
#define flipflop_standin_Memory_h

#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>

namespace standin
{

/// Ends the program: the CUDA runtime was used wrongly, or is used in a way that the stand-in has
/// not.
[[noreturn]] void fail(const char* what);

inline void require(bool holds, const char* what)
{
  if (!holds)
  {
    fail(what);
  }
}

/// A number from the environment.
int setting(const char* name, int byDefault);

constexpr int MostDevices = 2;

/// Where the devices' memory lies: low, where ThreadSanitizer lets a program have some.
constexpr std::uint64_t DeviceBegin = 0x1000000000, DeviceEnd = 0x8000000000;

/// What a pool has of a device's memory.
struct Pool
{
  std::size_t used = 0;
  std::size_t reserved = 0; ///< with what was given back to it
};

class Memory
{
public:
  static Memory& get(int device);

  /// @param pool null: of none
  /// @return null if the device has no more
  void* take(std::size_t bytes, Pool* pool = nullptr);
  void give(void* block);
  /// Let the pool give back to the device all but so much.
  void trim(Pool& pool, std::size_t kept);
  /// Is all of it in one of the device's blocks?
  bool holds(const void* from, std::size_t bytes);
  /// Is any of it as it was when its block was taken? Words of four bytes.
  bool isUnwritten(const void* from, std::size_t bytes);

  void* takePinned(std::size_t bytes);
  /// Pinned memory that kernels reach too, at an address of the device's own.
  void* takeMapped(std::size_t bytes);
  /// @return null if it is none of that
  void* onDevice(const void* mapped);
  void givePinned(void* block);
  bool isPinned(const void* from, std::size_t bytes);

  std::size_t total() const;
  std::size_t free();
  std::size_t blocks();

private:
  explicit Memory(int device);

  std::mutex mutex;
  std::map<const char*, std::size_t> live; ///< of the device: its begin and length
  std::map<const char*, Pool*> pools;      ///< of blocks that are of one
  std::map<const char*, std::size_t> pinned;
  std::map<const char*, char*> mapped; ///< and where the device has it
  char* next;
  char* end;
  std::size_t used = 0; ///< or reserved
};

}

#endif
