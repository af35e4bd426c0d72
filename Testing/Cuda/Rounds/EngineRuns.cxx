// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Cuda/Rounds/EngineRuns.h"

#include "Run/HullRun.h"
#include "Run/TriangulationRun.h"
#include <flipflop/Error.h>

#include <algorithm>
#include <sstream>
#include <type_traits>

namespace flipflop
{
namespace test
{

namespace
{

template <bool Weighted>
Triangulation triangulate(PolyhedronBuilder<LiftedGeometry<Weighted>>& engine,
  const PointView& points, const WeightView& weights, const Options& options)
{
  TriangulationRun<Weighted> run(points, weights, options);
  return run.compute(engine);
}

std::string toString(const RoundReport& report)
{
  const char* const stages[] = { "associate", "grow", "flip" };
  std::ostringstream out;
  out << stages[static_cast<int>(report.stage)] << " " << report.round << ": " << report.items
      << " items, " << report.triangles << " triangles, " << report.vertices << " vertices, "
      << report.changes << " changes, " << report.labelled << " labelled, mesh " << std::hex
      << report.mesh;
  return out.str();
}

}

Hull hullBy(
  PolyhedronBuilder<HullGeometry>& engine, const PointView& points, const Options& options)
{
  HullRun run(points, options);
  return run.compute(engine);
}

Triangulation triangulationBy(PolyhedronBuilder<LiftedGeometry<true>>& engine,
  const PointView& points, const WeightView& weights, const Options& options)
{
  return triangulate(engine, points, weights, options);
}

Triangulation triangulationBy(
  PolyhedronBuilder<LiftedGeometry<false>>& engine, const PointView& points, const Options& options)
{
  return triangulate(engine, points, WeightView(), options);
}

int codeOf(const std::function<void()>& work)
{
  try
  {
    work();
  }
  catch (const Error& error)
  {
    return static_cast<int>(error.code());
  }
  return -1;
}

std::string reportDifference(const std::vector<RoundReport>& a, const std::vector<RoundReport>& b)
{
  for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i)
  {
    if (i >= a.size() || i >= b.size() || !(a[i] == b[i]))
    {
      return (i < a.size() ? toString(a[i]) : std::string("the end")) + " for " +
        (i < b.size() ? toString(b[i]) : std::string("the end"));
    }
  }
  return "";
}

std::string countDifference(const Statistics& a, const Statistics& b)
{
  std::string difference;
  Statistics::eachField(
    [&](const char* name, auto field)
    {
      // Times differ.
      if (std::is_integral_v<std::decay_t<decltype(a.*field)>> && a.*field != b.*field)
      {
        difference += name + (": " + std::to_string(a.*field)) + " for " + std::to_string(b.*field);
      }
    });
  return difference;
}

}
}
