// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// An executor that runs the device's code on the host: what nvcc made of the kernels, translated
/// from PTX to C++ (ptx_to_cxx.py), thread by thread as a launch would have them.
#ifndef flipflop_test_PtxExecutor_h
#define flipflop_test_PtxExecutor_h

#include "Rounds/HostExecutor.h"
#include "Testing/Cuda/Ptx/DeviceCode.h"

#include <cxxabi.h>

#include <cstdint>
#include <cstdlib>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <typeinfo>

namespace flipflop
{
namespace test
{

class PtxExecutor : public HostExecutor
{
public:
  /// @param blockNumber, threadNumber of a launch
  PtxExecutor(unsigned blockNumber, unsigned threadNumber)
    : blocks(blockNumber)
    , threads(threadNumber)
  {
  }

  template <class K>
  void each(std::uint32_t most, const std::uint32_t* count, const K& kernel)
  {
    this->log(most, count, kernel);
    const ptx::Kernel code = find(typeid(K), K::LeastBlocks > 0 ? "runBoundedKernel" : "runKernel");
    const void* const parameters[3] = { &kernel, &count, &most };
    ptx::Launch launch = { 0, this->blocks, 0, this->threads };
    for (launch.blockIndex = 0; launch.blockIndex < launch.blockCount; ++launch.blockIndex)
    {
      for (launch.threadIndex = 0; launch.threadIndex < launch.threadCount; ++launch.threadIndex)
      {
        code(parameters, launch);
      }
    }
  }

private:
  /// The launch template's instance for this kernel, by its name.
  static ptx::Kernel find(const std::type_info& type, const char* launch)
  {
    const std::unique_ptr<char, void (*)(void*)> demangled(
      abi::__cxa_demangle(type.name(), nullptr, nullptr, nullptr), &std::free);
    const std::string kernel = demangled.get();
    const std::string name = "void flipflop::" + std::string(launch) + "<" + kernel +
      (kernel.back() == '>' ? " >(" : ">(") + kernel + ", unsigned int const*, unsigned int)";
    const ptx::Kernel code = ptx::find(name.c_str());
    if (!code)
    {
      throw std::runtime_error("the device code has no " + name);
    }
    return code;
  }

  unsigned blocks;
  unsigned threads;
};

}
}

#endif
