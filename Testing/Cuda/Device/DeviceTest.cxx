// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// flipflop-device-test: is what the CUDA engine does on this machine's device right?
///
/// Every round on the device must leave what it leaves on the host, every result must be the CPU
/// engine's bit for bit and valid, and nothing that goes wrong may leave anything behind. With
/// --host, the host takes the device's place, in every order of a kernel's items.
#include "Checks.h"
#include <flipflop/Engines.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>

namespace
{

using namespace flipflop;

constexpr int NoDeviceStatus = 77; // as for a test that is skipped

const char* const usage =
  "usage: flipflop-device-test [--host] [--small] [--only BEGINNING] [--list]\n"
  "  --host            the host in the device's place, in every order\n"
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

  const auto reference = makeHostRunner({ HostExecutor::Order::Forwards });
  if (arguments.host)
  {
    bool right = true;
    for (const test::HostOrder& order : test::allOrders())
    {
      std::printf("on the host, %s\n", order.toString().c_str());
      const auto subject = makeHostRunner(order);
      right = runAll(chosen, { *subject, *reference }) && right;
      // What is not about rounds is the same in each.
      chosen.erase(std::remove_if(chosen.begin(), chosen.end(),
                     [](const test::Check& check) { return check.name.rfind("rounds/", 0) != 0; }),
        chosen.end());
    }
    return right ? 0 : 1;
  }
  const auto subject = makeCudaRunner();
  if (!subject)
  {
    std::printf("nothing was tested: %s\n", cudaStatus().problem);
    return NoDeviceStatus;
  }
  std::printf("%s\n", cudaStatus().device);
  return runAll(chosen, { *subject, *reference }) ? 0 : 1;
}
