// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Every call in one floating-point environment: writes a line for each with a digest of its bits.
/// TestFloatingPointEnvironment.py compares these lines from process to process.
///
/// EnvironmentBits <environment> <threads>
#include "Testing/Engine/Calls/EveryCall.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"

#include "Support/Threads.h"
#include <flipflop/ConvexHull.h>
#include <flipflop/RegularTriangulation.h>

#include <cfenv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <utility>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace flipflop
{
namespace test
{

namespace
{

/// The environment's control bits and status flags, as numbers.
std::pair<std::uint64_t, std::uint64_t> state()
{
#if defined(__SSE2__)
  constexpr unsigned int Flags = 0x3f;
  return { _mm_getcsr() & ~Flags, _mm_getcsr() & Flags };
#elif defined(__aarch64__)
  std::uint64_t control, status;
  __asm__ __volatile__("mrs %0, fpcr" : "=r"(control));
  __asm__ __volatile__("mrs %0, fpsr" : "=r"(status));
  return { control, status };
#else
  return { std::fegetround(), std::fetestexcept(FE_ALL_EXCEPT) };
#endif
}

void setControl([[maybe_unused]] std::uint64_t set, [[maybe_unused]] std::uint64_t cleared)
{
#if defined(__SSE2__)
  _mm_setcsr(static_cast<unsigned int>((_mm_getcsr() & ~cleared) | set));
#elif defined(__aarch64__)
  const std::uint64_t control = (state().first & ~cleared) | set;
  __asm__ __volatile__("msr fpcr, %0" : : "r"(control));
#else
  std::exit(77); // as a test that is left out
#endif
}

/// @return false: there is no such environment here
bool enter(const std::string& environment)
{
#if defined(__SSE2__)
  constexpr unsigned int Flush = 0x8040; // flush to zero, denormals are zero
  constexpr unsigned int Masks = 0x1f80;
#else
  constexpr unsigned int Flush = 1 << 24;
  constexpr unsigned int Masks = 0;
#endif
  if (environment == "flush")
  {
    setControl(Flush, 0);
  }
  else if (environment == "trap" && Masks)
  {
    std::feclearexcept(FE_ALL_EXCEPT);
    setControl(0, Masks);
  }
  else if (environment == "up" || environment == "down" || environment == "zero")
  {
    std::fesetround(environment == "up" ? FE_UPWARD
        : environment == "down"         ? FE_DOWNWARD
                                        : FE_TOWARDZERO);
  }
  else
  {
    return environment == "default";
  }
  return true;
}

constexpr double Least = std::numeric_limits<double>::denorm_min();

struct Case
{
  const char* name;
  CallInputs inputs;
};

CallInputs smaller(Cloud body, Cloud shell, Cloud sites, double unit)
{
  return { std::move(body), std::move(shell), std::move(sites), unit, 2, 8, 60 };
}

/// Coordinates and weights that are decimal fractions: ties that rounding makes and breaks.
CallInputs decimalGrids()
{
  Cloud body, sites;
  for (int i = 0; i < 10; ++i)
  {
    for (int j = 0; j < 10; ++j)
    {
      sites.push_back({ 0.1 * i, 0.1 * j, 0.01 * ((7 * i + 3 * j) % 5) });
      for (int k = 0; k < 3; ++k)
      {
        body.push_back({ 0.1 * i, 0.1 * j, 0.1 * k });
      }
    }
  }
  return smaller(body, body, sites, 1);
}

/// Points off a plane, sites off a line, and weights, by subnormal numbers.
CallInputs nearlyFlat()
{
  Cloud body = fromFamily("ball", 300, 5).make();
  Cloud sites = squareGrid(15);
  for (std::size_t i = 0; i < body.size(); ++i)
  {
    body[i][2] = static_cast<double>(i % 9) * Least;
  }
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    sites[i] = { sites[i][0] / 16, sites[i][1] / 16, static_cast<double>(i * i % 5) * Least };
  }
  return smaller(body, body, sites, 1);
}

CallInputs onALine()
{
  Cloud sites;
  for (int i = 0; i < 200; ++i)
  {
    sites.push_back({ i / 200.0, i * i % 7 * Least, 0 });
  }
  return smaller(sites, sites, sites, 1);
}

/// Nothing but subnormal numbers.
CallInputs subnormal()
{
  constexpr double Unit = 2000 * Least;
  const auto drawn = [](Cloud cloud)
  {
    for (auto& point : cloud)
    {
      for (double& x : point)
      {
        x = std::nearbyint(1000 * x) * Least;
      }
    }
    return cloud;
  };
  return smaller(drawn(fromFamily("ball", 300, 5).make()),
    drawn(fromFamily("shell0", 200, 6).make()), drawn(randomSites(300, 1e-2, 72)), Unit / 2);
}

std::uint64_t digest(const Bits& bits)
{
  std::uint64_t sum = 14695981039346656037u; // FNV-1a
  for (const char c : bits)
  {
    sum = (sum ^ static_cast<unsigned char>(c)) * 1099511628211u;
  }
  return sum;
}

bool isError(const Bits& bits)
{
  return bits.compare(0, 5, "error") == 0;
}

void write(const std::string& name, const Bits& bits)
{
  if (isError(bits))
  {
    std::printf("%s %s\n", name.c_str(), bits.c_str());
    return;
  }
  std::printf("%s %016llx\n", name.c_str(), static_cast<unsigned long long>(digest(bits)));
}

/// What a progress function sees.
struct Caller
{
  std::uint64_t control;
  bool isChanged = false;
  int reports = 0;
  int stopAt = 0;

  static bool see(double, void* self)
  {
    Caller& caller = *static_cast<Caller*>(self);
    caller.isChanged = caller.isChanged || state().first != caller.control;
    return ++caller.reports != caller.stopAt;
  }
};

Bits bitsOf(const Call& call, const Cloud& cloud, const Options& options)
{
  try
  {
    Call other = call;
    other.cloud = cloud;
    return other(options);
  }
  catch (const Error& error)
  {
    return "error " + std::to_string(static_cast<int>(error.code()));
  }
}

/// A call, the same with a progress function, stopped, and with a point that is not finite.
/// @return false: the environment was another then
bool run(const std::string& name, const Call& call, int threads, bool traps)
{
  // The caller's status flags: one is set.
  std::feclearexcept(FE_ALL_EXCEPT);
  if (!traps)
  {
    std::feraiseexcept(FE_DIVBYZERO);
  }
  const auto before = state();
  Options options;
  options.threads = threads;
  const Bits bits = bitsOf(call, call.cloud, options);
  bool isKept = state() == before;
  write(name, bits);
  for (const int stopAt : { 0, 1 })
  {
    Caller caller{ before.first };
    caller.stopAt = stopAt;
    options.progress = Caller::see;
    options.progressContext = &caller;
    const Bits watched = bitsOf(call, call.cloud, options);
    isKept = isKept && state() == before && !caller.isChanged;
    isKept = isKept && (isError(bits) || (caller.reports > 0 && isError(watched) == (stopAt > 0)));
    isKept = isKept && (stopAt || watched == bits);
  }
  Cloud bad = call.cloud;
  bad[0][0] = std::numeric_limits<double>::quiet_NaN();
  options.progress = nullptr;
  bitsOf(call, bad, options);
  return isKept && state() == before;
}

int main(const std::string& environment, int threads)
{
  pointsPerThread() = 1;
  const Case cases[] = { { "decimal", decimalGrids() }, { "flat", nearlyFlat() },
    { "line", onALine() }, { "subnormal", subnormal() } };
  const auto inherited = state().first;
  if (!enter(environment))
  {
    return 77;
  }
  // The first calls of the process, so whatever they make is made in this environment.
  Options options;
  options.threads = threads;
  for (const Case& one : cases)
  {
    const Hull hull = convexHull(viewOf(one.inputs.body), options);
    write(std::string("first hull, ") + one.name,
      Bits(reinterpret_cast<const char*>(hull.connectivity.data()), 8 * hull.connectivity.size()));
    const Triangulation cells =
      regularTriangulation(viewOf(one.inputs.sites), weightsOf(one.inputs.sites), options);
    write(std::string("first triangulation, ") + one.name,
      Bits(
        reinterpret_cast<const char*>(cells.connectivity.data()), 8 * cells.connectivity.size()));
  }
  int changed = 0;
  for (const Case& one : cases)
  {
    std::fesetround(FE_TONEAREST);
    setControl(inherited, ~std::uint64_t(0));
    const std::vector<Call> calls = callsOn(one.inputs);
    enter(environment);
    for (const Call& call : calls)
    {
      const std::string name = std::string(call.name) + ", " + one.name;
      if (!run(name, call, threads, environment == "trap"))
      {
        std::printf("%s: the environment is not the caller's\n", name.c_str());
        ++changed;
      }
    }
  }
  return changed ? 1 : 0;
}

}

}
}

int main(int count, char** arguments)
{
  return count == 3 ? flipflop::test::main(arguments[1], std::atoi(arguments[2])) : 2;
}
