// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The status of each device, so that each is checked once: a check makes a context, which takes up
/// to a second and memory of the device.
#ifndef flipflop_DeviceStatus_h
#define flipflop_DeviceStatus_h

#include "Device/CudaBuilders.h"

#include <map>
#include <mutex>

namespace flipflop
{

class DeviceStatus
{
public:
  /// @param device the number of the device, or -1 where there is none
  /// @param check  DeviceFinding (): check it. What does not last is not kept: a device that is
  ///               busy now may be free for the next call
  /// @return valid until the thread's next call
  template <class Check>
  const CudaStatus& of(int device, Check&& check)
  {
    const std::lock_guard<std::mutex> lock(this->mutex);
    const auto known = this->lasting.find(device);
    if (known != this->lasting.end())
    {
      return known->second;
    }
    const DeviceFinding found = check();
    if (found.lasting && (device >= 0 || !found.status.present))
    {
      return this->lasting.emplace(device, found.status).first->second;
    }
    static thread_local CudaStatus passing;
    passing = found.status;
    return passing;
  }

private:
  std::mutex mutex;
  std::map<int, CudaStatus> lasting;
};

}

#endif
