// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Checks.h"

#include "DeviceInputs.h"
#include "Testing/Cuda/Rounds/EngineRuns.h"
#include <flipflop/Engines.h>
#include <flipflop/Validate.h>

#include <cstring>
#include <set>

namespace flipflop
{
namespace test
{

namespace
{

template <class T>
bool same(const Buffer<T>& a, const Buffer<T>& b)
{
  return a.size() == b.size() &&
    (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

void requireSame(const std::string& what, const RunResult& found, const RunResult& wanted)
{
  const std::string text = difference(found, wanted);
  require(text.empty(), what + ": other " + text);
}

/// The subject's rounds are the reference's, and its result is the CPU engine's and sound.
void checkRounds(const Sides& sides, const RunInput& input, const Options& options)
{
  const RunResult wanted = runOnCpu(input, options);
  RunWatch watch;
  watch.reports = true;
  RunSeen seen;
  RunSeen known;
  const RunResult found = sides.subject.run(input, options, watch, &seen);
  const RunResult reference = sides.reference.run(input, options, watch, &known);
  const std::string text = reportDifference(seen.reports, known.reports);
  require(text.empty(), "other rounds: " + text);
  requireSame("watched", found, wanted);
  const std::string counts =
    countDifference(found.cells().statistics, reference.cells().statistics);
  require(counts.empty(), "other counts: " + counts);
  // Unwatched, no round waits for the host: kernels follow each other closely, and the last rounds
  // are one launch. It ends at once for the exact kernel, which rounds of their own wait for.
  RunSeen alone;
  const RunResult unwatched = sides.subject.run(input, options, RunWatch(), &alone);
  requireSame("unwatched", unwatched, wanted);
  const std::string apart =
    countDifference(unwatched.cells().statistics, reference.cells().statistics);
  require(
    apart.empty() || alone.launches.count("check, exact"), "other counts unwatched: " + apart);
  const Validation validation = input.plane
    ? validate(input.points, input.weights, found.triangulation)
    : validate(input.points, found.hull);
  require(static_cast<bool>(validation),
    std::string("not valid: ") + describe(validation.fault) + ", at " +
      std::to_string(validation.index));
}

/// The mesh's hash is no constant: rounds with a change have hashes of their own.
void checkDigests(const Sides& sides)
{
  RunWatch watch;
  watch.reports = true;
  std::set<std::uint64_t> meshes;
  std::size_t changes = 0;
  for (const char* family : { "ball", "shell0", "cube" })
  {
    RunSeen seen;
    sides.subject.run(drawn(family, false, 200).view(), Options(), watch, &seen);
    std::uint64_t labelled = 0;
    for (const RoundReport& report : seen.reports)
    {
      const bool first = report.stage == RoundReport::Stage::Associate;
      changes += first || report.changes != 0 || report.labelled != labelled ? 1 : 0;
      labelled = report.labelled;
      meshes.insert(report.mesh);
    }
  }
  require(changes > 20 && meshes.size() == changes, "rounds with a change have one digest");
}

/// The public functions, by the chosen engine.
RunResult runBy(
  const RunInput& input, const Options& options, const EngineOptions& engine, EngineReport& report)
{
  RunResult result;
  result.plane = input.plane;
  if (input.plane)
  {
    result.triangulation =
      regularTriangulation(input.points, input.weights, options, engine, report);
  }
  else
  {
    result.hull = convexHull(input.points, options, engine, report);
  }
  return result;
}

/// The public functions come to the CPU engine's result, by CUDA where there is work for it.
void checkChoice(const InputMaker& maker)
{
  const DeviceInput drawn = maker.make();
  const RunInput input = drawn.view();
  Options options;
  options.nonFinite = NonFinitePolicy::Ignore;
  const RunResult wanted = runOnCpu(input, options);
  const bool spans = wanted.cells().dimension == (input.plane ? 2 : 3);
  for (const EngineChoice choice : { EngineChoice::CUDA, EngineChoice::Automatic })
  {
    EngineOptions engine;
    engine.choice = choice;
    engine.cudaFrom = 0;
    EngineReport report;
    RunResult found;
    const int code = codeOf([&] { found = runBy(input, options, engine, report); });
    require(report.reason[0] != 0, "no reason is given");
    if (!cudaStatus().present && choice == EngineChoice::CUDA)
    {
      require(code == static_cast<int>(ErrorCode::NoDevice), "not the error NoDevice");
      continue;
    }
    require(code == -1, "error " + std::to_string(code));
    requireSame("by the chosen engine", found, wanted);
    const bool onDevice = cudaStatus().present && spans && !maker.wide;
    require((report.used == EngineChoice::CUDA) == onDevice,
      std::string("the wrong engine: ") + report.reason);
    require(
      !maker.wide || !cudaStatus().present || std::strstr(report.reason, "integers of any size"),
      std::string("a wide range is not the reason: ") + report.reason);
  }
}

}

std::string difference(const RunResult& a, const RunResult& b)
{
  const CellComplex& x = a.cells();
  const CellComplex& y = b.cells();
  const bool sameMeasures = std::memcmp(&a.hull.volume, &b.hull.volume, sizeof(double)) == 0 &&
    std::memcmp(&a.hull.area, &b.hull.area, sizeof(double)) == 0;
  return x.dimension != y.dimension                               ? "dimension"
    : !same(x.pointIds, y.pointIds)                               ? "points"
    : x.cellSize != y.cellSize                                    ? "size of cells"
    : !same(x.offsets, y.offsets)                                 ? "cells"
    : !same(x.connectivity, y.connectivity)                       ? "corners"
    : !same(a.triangulation.hiddenIds, b.triangulation.hiddenIds) ? "hidden points"
    : !sameMeasures                                               ? "volume or area"
                                                                  : "";
}

void addRoundChecks(std::vector<Check>& checks)
{
  checks.push_back({ "digests", true, checkDigests });
  bool odd = false;
  for (const InputMaker& maker : deviceInputs())
  {
    if (maker.wide)
    {
      continue; // integers of any size are the CPU's
    }
    odd = !odd;
    checks.push_back({ "rounds/" + maker.name, maker.small,
      [maker, odd](const Sides& sides)
      {
        const DeviceInput drawn = maker.make();
        Options options;
        options.vBiased = odd;
        options.facets = odd ? FacetMode::Polygons : FacetMode::Triangles;
        options.nonFinite = maker.nonFinite ? NonFinitePolicy::Ignore : NonFinitePolicy::Error;
        checkRounds(sides, drawn.view(), options);
        if (drawn.xyz.size() < 3 * 2000)
        {
          options.vBiased = !odd;
          options.facets = odd ? FacetMode::Triangles : FacetMode::Polygons;
          checkRounds(sides, drawn.view(), options);
        }
      } });
  }

  const struct
  {
    const char* label;
    bool plane;
    std::int64_t count;
  } again[] = { { "shell0", false, 30000 }, { "ball", false, 300000 },
    { "duplicates", false, 50000 }, { "uniformHeavy", true, 100000 }, { "grid", true, 10000 } };
  for (const auto& one : again)
  {
    checks.push_back({ std::string("again/") + (one.plane ? "plane-" : "") + one.label, false,
      [one](const Sides& sides)
      {
        const DeviceInput drawn = test::drawn(one.label, one.plane, one.count);
        const RunResult wanted = runOnCpu(drawn.view(), Options());
        std::vector<RoundReport> first;
        for (int i = 0; i < 10; ++i)
        {
          RunWatch watch;
          watch.reports = i < 3;
          RunSeen seen;
          requireSame("run " + std::to_string(i + 1),
            sides.subject.run(drawn.view(), Options(), watch, &seen), wanted);
          if (watch.reports)
          {
            first = i == 0 ? seen.reports : first;
            const std::string text = reportDifference(seen.reports, first);
            require(text.empty(), "run " + std::to_string(i + 1) + ": other rounds: " + text);
          }
        }
      } });
  }
}

void addChoiceChecks(std::vector<Check>& checks)
{
  for (const InputMaker& maker : deviceInputs())
  {
    if (maker.small || maker.wide)
    {
      checks.push_back(
        { "choice/" + maker.name, false, [maker](const Sides&) { checkChoice(maker); } });
    }
  }
}

}
}
