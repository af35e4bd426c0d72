// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// flipflop-device-test: is what the CUDA engine does on this machine's device right?
///
/// Every round on the device must leave what it leaves on the host, every result must be the CPU
/// engine's bit for bit and valid, and nothing that goes wrong may leave anything behind. With
/// --host, host threads take the device's place.
#include "Checks.h"
#include <flipflop/Engines.h>

#include <chrono>
#include <cstdio>
#include <cstring>

namespace
{

using namespace flipflop;

constexpr int NoDeviceStatus = 77; // as for a test that is skipped

const char* const usage =
  "usage: flipflop-device-test [--host] [--small] [--only BEGINNING] [--list]\n"
  "  --host            host threads in the device's place\n"
  "  --small           small inputs only, for compute-sanitizer\n"
  "  --only BEGINNING  the checks whose names begin so\n"
  "  --list            name the checks\n"
  "exit status: 0, 1 where a check failed, 2 for bad arguments, 77 where there is no device\n";

struct Arguments
{
  bool host = false;
  bool small = false;
  bool list = false;
  std::string only;
};

bool parse(int argc, char** argv, Arguments& arguments)
{
  for (int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    if (word == "--host")
    {
      arguments.host = true;
    }
    else if (word == "--small")
    {
      arguments.small = true;
    }
    else if (word == "--list")
    {
      arguments.list = true;
    }
    else if (word == "--only" && i + 1 < argc)
    {
      arguments.only = argv[++i];
    }
    else
    {
      return false;
    }
  }
  return true;
}

/// @return whether all is well
bool runAll(const std::vector<test::Check>& checks, const test::Sides& sides)
{
  int failed = 0;
  for (const test::Check& check : checks)
  {
    const auto begin = std::chrono::steady_clock::now();
    std::string problem;
    try
    {
      check.run(sides);
    }
    catch (const Error& error)
    {
      problem = std::string(": ") + error.what() + " (index " + std::to_string(error.index()) +
        ", count " + std::to_string(error.count()) + ")";
      ++failed;
    }
    catch (const std::exception& error)
    {
      problem = std::string(": ") + error.what();
      ++failed;
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    std::printf("%-6s %-36s %8.3f s%s\n", problem.empty() ? "ok" : "FAILED", check.name.c_str(),
      seconds.count(), problem.c_str());
    std::fflush(stdout);
  }
  std::printf("%d of %d checks failed\n", failed, static_cast<int>(checks.size()));
  return failed == 0;
}

}

int main(int argc, char** argv)
{
  Arguments arguments;
  if (!parse(argc, argv, arguments))
  {
    std::fputs(usage, stderr);
    return 2;
  }

  std::vector<test::Check> all;
  test::addMemoryChecks(all);
  test::addRoundChecks(all);
  test::addChoiceChecks(all);
  std::vector<test::Check> chosen;
  for (test::Check& check : all)
  {
    if ((check.small || !arguments.small) && check.name.rfind(arguments.only, 0) == 0)
    {
      chosen.push_back(std::move(check));
    }
  }
  if (arguments.list)
  {
    for (const test::Check& check : chosen)
    {
      std::puts(check.name.c_str());
    }
    return 0;
  }
  if (chosen.empty())
  {
    std::fputs("no check has such a name\n", stderr);
    return 2;
  }

  using Order = HostExecutor::Order;
  const auto reference = makeHostRunner({ Order::Forwards });
  const auto subject = arguments.host ? makeHostRunner({ Order::Threads, 1, 3 }) : makeCudaRunner();
  if (!subject)
  {
    std::printf("nothing was tested: %s\n", cudaStatus().problem);
    return NoDeviceStatus;
  }
  std::printf("%s\n", arguments.host ? "on host threads" : cudaStatus().device);
  return runAll(chosen, { *subject, *reference }) ? 0 : 1;
}
