// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What users read where no CUDA device is found.
#include "Device/MissingDevice.h"

#include <flipflop/Engines.h>

#include <gtest/gtest.h>

#if defined(__linux__)
#include <dlfcn.h>
#endif

#include <string>

namespace flipflop
{
namespace test
{

namespace
{

std::string words(int driver, int needed)
{
  char text[256];
  describeMissingDevice(driver, needed, text, sizeof(text));
  return text;
}

TEST(MissingDevice, NamesWhatIsMissing)
{
  EXPECT_EQ(words(0, 13000), "there is no NVIDIA driver");
  EXPECT_EQ(words(0, 0), "there is no NVIDIA driver");
  EXPECT_EQ(words(12040, 13000),
    "the NVIDIA driver is for CUDA 12.4; this build needs a driver for CUDA 13.0");
  EXPECT_EQ(words(13000, 0), "the NVIDIA driver finds no CUDA device");
}

#if defined(__linux__)
TEST(MissingDevice, ADriverIsMissingWhereItsLibraryIs)
{
  if (void* library = dlopen("libcuda.so.1", RTLD_LAZY))
  {
    dlclose(library);
    GTEST_SKIP() << "there is a driver";
  }
  EXPECT_FALSE(cudaStatus().present);
  EXPECT_STREQ(cudaStatus().problem,
    cudaStatus().built ? "there is no NVIDIA driver" : "this build has no CUDA engine");
}
#endif

}

}
}
