// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// cuda-benchmark: what the CUDA engine takes beside the CPU's, where it spends it, and from how
/// many points on it pays. With --host, what the rounds do, counted on the host: no times.
#include "DeviceFloors.h"
#include "Parts.h"
#include <flipflop/Engines.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <stdexcept>

namespace
{

using namespace flipflop;

constexpr int NoDeviceStatus = 77; // as for a test that is skipped

const char* const usage =
  "usage: cuda-benchmark [OPTION]...\n"
  "  --host                count what the rounds do, on the host: rounds.csv\n"
  "  --output FOLDER       where to write floors.csv, crossover.csv, engines.csv, kernels.csv (.)\n"
  "  --parts PART,...      of floors, crossover, engines (and Qhull) and kernels (all)\n"
  "  --sizes N,N,...       ascending numbers of points (1e5,1e6,1e7; with --host 1e4,1e5,1e6)\n"
  "  --only LABEL          this point set alone\n"
  "  --device-only         engines without the CPU's and Qhull\n"
  "  --repetitions N       runs a case, where it is quick (5)\n"
  "  --max-seconds S       begin nothing new after this time (240)\n"
  "  --max-qhull-seconds S for all runs of Qhull (60)\n"
  "  --seed N              of the points (2013)\n"
  "exit status: 0, 1 for an error, 2 for bad arguments, 77 where there is no device\n";

struct Arguments
{
  Settings settings;
  double maxSeconds = 240;
};

std::vector<std::int64_t> parseSizes(const std::string& text)
{
  std::vector<std::int64_t> sizes;
  for (std::size_t at = 0; at <= text.size();)
  {
    const std::size_t comma = std::min(text.find(',', at), text.size());
    sizes.push_back(static_cast<std::int64_t>(std::stod(text.substr(at, comma - at))));
    if (sizes.back() < 4 || (sizes.size() > 1 && sizes.back() <= sizes[sizes.size() - 2]))
    {
      throw std::invalid_argument(text);
    }
    at = comma + 1;
  }
  return sizes;
}

/// @throw std::exception
Arguments parse(int argc, char** argv)
{
  Arguments arguments;
  Settings& settings = arguments.settings;
  bool sized = false;
  for (int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    if (word == "--host")
    {
      settings.host = true;
      continue;
    }
    if (word == "--device-only")
    {
      settings.deviceOnly = true;
      continue;
    }
    if (i + 1 >= argc)
    {
      throw std::invalid_argument(word);
    }
    const std::string value = argv[++i];
    if (word == "--output")
    {
      settings.folder = value;
    }
    else if (word == "--sizes")
    {
      settings.sizes = parseSizes(value);
      sized = true;
    }
    else if (word == "--parts")
    {
      settings.parts = value;
    }
    else if (word == "--only")
    {
      settings.only = value;
    }
    else if (word == "--repetitions")
    {
      settings.repetitions = std::max(1, std::stoi(value));
    }
    else if (word == "--max-seconds")
    {
      arguments.maxSeconds = std::stod(value);
    }
    else if (word == "--max-qhull-seconds")
    {
      settings.qhullSeconds = std::stod(value);
    }
    else if (word == "--seed")
    {
      settings.seed = std::stoull(value);
    }
    else
    {
      throw std::invalid_argument(word);
    }
  }
  if (settings.host && !sized)
  {
    settings.sizes = { 10000, 100000, 1000000 };
  }
  settings.facts = describeRun(argc, argv, settings.seed);
  return arguments;
}

int countOnHost(const Settings& settings)
{
  const auto runner = makeHostRunner({ HostExecutor::Order::Forwards });
  KernelRows rows(settings, *runner);
  for (const std::int64_t count : settings.sizes)
  {
    for (const Subject& subject : subjects(settings))
    {
      rows.measure(subject, Points(subject, count, settings.seed));
    }
  }
  return 0;
}

int measureOnDevice(Settings settings, const Allowance& allowance)
{
  const auto runner = makeCudaRunner();
  if (!runner)
  {
    std::printf("nothing was measured: %s\n", cudaStatus().problem);
    return NoDeviceStatus;
  }
  const Facts device = describeDevice();
  settings.facts.insert(settings.facts.end(), device.begin(), device.end());
  for (const auto& fact : settings.facts)
  {
    std::printf("%s: %s\n", fact.first.c_str(), fact.second.c_str());
  }
  if (settings.measures("floors"))
  {
    Csv floors(settings.folder, "floors", settings.facts, "floor,value,unit");
    for (const Floor& floor : deviceFloors())
    {
      floors.add({ floor.name, floor.value, floor.unit });
      std::printf("%s: %.3g %s\n", floor.name.c_str(), floor.value, floor.unit.c_str());
    }
  }
  if (settings.measures("crossover"))
  {
    measureCrossover(settings, *runner, allowance);
  }
  std::optional<EngineRows> engines;
  std::optional<KernelRows> kernels;
  if (settings.measures("engines"))
  {
    engines.emplace(settings, *runner);
  }
  if (settings.measures("kernels"))
  {
    kernels.emplace(settings, *runner);
  }
  // The largest first: they tell most, should the time not do for all.
  std::reverse(settings.sizes.begin(), settings.sizes.end());
  for (const std::int64_t count : settings.sizes)
  {
    for (const Subject& subject : subjects(settings))
    {
      if (!engines && !kernels)
      {
        continue;
      }
      if (allowance.left() > 0)
      {
        const Points points(subject, count, settings.seed);
        if (kernels)
        {
          kernels->measure(subject, points);
        }
        if (engines)
        {
          engines->measure(subject, points, allowance);
        }
      }
      else
      {
        std::printf("%-13s %9lld  skipped: the time is up\n", subject.label().c_str(),
          static_cast<long long>(count));
      }
    }
  }
  return 0;
}

}

int main(int argc, char** argv)
{
  Arguments arguments;
  try
  {
    arguments = parse(argc, argv);
  }
  catch (const std::exception&)
  {
    std::fputs(usage, stderr);
    return 2;
  }
  try
  {
    return arguments.settings.host
      ? countOnHost(arguments.settings)
      : measureOnDevice(arguments.settings, Allowance(arguments.maxSeconds));
  }
  catch (const Error& error)
  {
    std::fprintf(stderr, "cuda-benchmark: %s (index %lld, count %lld)\n", error.what(),
      static_cast<long long>(error.index()), static_cast<long long>(error.count()));
    return 1;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "cuda-benchmark: %s\n", error.what());
    return 1;
  }
}
