// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Why there is no device, for users: the CUDA runtime's own words for a machine without a driver
/// are that its "driver version is insufficient".
#ifndef flipflop_MissingDevice_h
#define flipflop_MissingDevice_h

#include <cstddef>
#include <cstdio>

namespace flipflop
{

/// @param driver what CUDA the driver has, as cudaDriverGetVersion returns it (12040 is 12.4); 0:
/// there
///               is no driver
/// @param needed the CUDA that is needed and that the driver has not; 0: the driver is new enough
/// @param text   what is written
inline void describeMissingDevice(int driver, int needed, char* text, std::size_t size)
{
  if (driver == 0)
  {
    std::snprintf(text, size, "there is no NVIDIA driver");
  }
  else if (needed > 0)
  {
    std::snprintf(text, size,
      "the NVIDIA driver is for CUDA %d.%d; this build needs a driver for CUDA %d.%d",
      driver / 1000, driver % 1000 / 10, needed / 1000, needed % 1000 / 10);
  }
  else
  {
    std::snprintf(text, size, "the NVIDIA driver finds no CUDA device");
  }
}

}

#endif
