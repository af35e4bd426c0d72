// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// No part of a run goes on for long without a look for an abort request: here every look calls the
/// progress function, and is counted.
#include "Finish/Canonical.h"
#include "Finish/Redundant.h"
#include "FlipFlop/CpuBuilder.h"
#include "Geometry/HullLocator.h"
#include "Geometry/LiftedStart.h"
#include "Mesh/Compact.h"
#include "Query/FanMesh.h"
#include "Query/SiteLocator.h"
#include "Run/HullRun.h"
#include "Run/TriangulationRun.h"
#include "Support/Threads.h"
#include "Testing/Engine/Conformance/CompareTriangulation.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"
#include <flipflop/RegularTriangulation.h>

#include <chrono>
#include <functional>
#include <stdexcept>

namespace flipflop
{
namespace test
{

namespace
{

/// Counts the looks, and asks to stop at one of them.
struct Looks
{
  int count = 0;
  int stopAt = 0; ///< 0: never

  static bool see(double, void* context)
  {
    Looks& looks = *static_cast<Looks*>(context);
    return ++looks.count != looks.stopAt;
  }
};

using Work = std::function<void(Monitor&)>;

/// How often some work looks. It runs on this thread alone.
int looksOf(const Work& work, int stopAt, bool& aborted)
{
  Looks looks;
  looks.stopAt = stopAt;
  Options options;
  options.progress = Looks::see;
  options.progressContext = &looks;
  aborted = false;
  ArenaLoan arena(1);
  arena.execute(
    [&]
    {
      Monitor monitor(options, std::chrono::seconds(0));
      try
      {
        work(monitor);
      }
      catch (const Error& error)
      {
        EXPECT_EQ(error.code(), ErrorCode::Aborted);
        aborted = true;
      }
    });
  return looks.count;
}

/// The work looks so often at least, and stops at whichever look says so.
void expectLooks(const Work& work, std::size_t least)
{
  bool aborted = false;
  const int all = looksOf(work, 0, aborted);
  EXPECT_FALSE(aborted);
  EXPECT_GE(all, static_cast<int>(least));
  for (const int stopAt : { 1, 2, all / 2, all })
  {
    EXPECT_EQ(looksOf(work, stopAt, aborted), stopAt) << "called again after the stop";
    EXPECT_TRUE(aborted) << "stop at " << stopAt << " of " << all;
  }
}

/// How many looks so many steps make, one each StepPoll::Every.
std::size_t looksIn(std::size_t steps)
{
  return steps / StepPoll::Every;
}

/// The perturbed result of a cloud, without gaps, and all that it was built with.
template <class GivenRun>
struct Built
{
  GivenRun run;
  Polyhedron polyhedron;
  Tally tally;

  template <class Inspect, class SpanOf, class... Arguments>
  Built(Inspect&& inspect, SpanOf&& spanOf, Arguments&&... arguments)
    : run(std::forward<Arguments>(arguments)...)
  {
    using Geometry = decltype(GivenRun::geometry);
    ArenaLoan arena(1);
    arena.execute(
      [&]
      {
        inspect(this->run);
        const Span span = spanOf(this->run);
        Polyhedron start = startingTetrahedron(this->run.geometry, this->run.source, span.ids);
        Statistics statistics;
        BuildResult built = CpuBuilder<Geometry>().build(
          { this->run.geometry, this->run.source, this->run.range, false, this->run.options, 1,
            this->run.monitor, nestedSamples(this->run.source.count()) },
          std::move(start), this->tally, statistics);
        const auto* const plane = std::get_if<PlanePolyhedron>(&built);
        this->polyhedron = compact(plane ? plane->full() : std::get<Polyhedron>(std::move(built)));
      });
  }
};

Options oneThread(FacetMode facets)
{
  Options options;
  options.threads = 1;
  options.facets = facets;
  return options;
}

Built<TriangulationRun<false>> delaunay(const Cloud& cloud)
{
  return Built<TriangulationRun<false>>(
    [](TriangulationRun<false>& run)
    {
      Statistics statistics;
      run.inspect(statistics);
    },
    [](TriangulationRun<false>& run) { return run.spanOf(nullptr, run.source.count()); },
    viewOf(cloud), WeightView(), oneThread(FacetMode::Polygons));
}

Polyhedron copyOf(const Polyhedron& polyhedron)
{
  Polyhedron copy(polyhedron.vertices.size(), polyhedron.triangles.size());
  std::copy(polyhedron.vertices.begin(), polyhedron.vertices.end(), copy.vertices.begin());
  std::copy(polyhedron.triangles.begin(), polyhedron.triangles.end(), copy.triangles.begin());
  copy.pieces = polyhedron.pieces;
  return copy;
}

/// Tasks that the caller's thread still has when its progress function has thrown look, too.
TEST(Polls, NoFunctionIsCalledAgainThatHasThrown)
{
  int calls = 0;
  Options options;
  options.progress = [](double, void* count) -> bool
  {
    ++*static_cast<int*>(count);
    throw std::runtime_error("a progress function");
  };
  options.progressContext = &calls;
  Monitor monitor(options, std::chrono::seconds(0));
  EXPECT_THROW(monitor.poll(), std::runtime_error);
  EXPECT_NO_THROW(monitor.poll());
  EXPECT_EQ(calls, 1);
}

TEST(Polls, WhileAskingForALattice)
{
  const Cloud cloud = integerGrid(60);
  const PointSource source{ viewOf(cloud) };
  expectLooks([&](Monitor& monitor) { EXPECT_EQ(commonUnit(source, 1, 4, false, monitor), 1); },
    looksIn(cloud.size()));
}

TEST(Polls, WhileTheHullsLocatorIsMade)
{
  const Cloud cloud = fromFamily("shell0", 20000, 91).make();
  Built<HullRun> built(
    [](HullRun& run)
    {
      Hull hull;
      run.inspect(hull);
    },
    [](HullRun& run) {
      return findSpan(run.geometry, run.source, nullptr, run.source.count(), 3, false, run.monitor);
    },
    viewOf(cloud), oneThread(FacetMode::Triangles));
  // The cones, the planes, and the corners of a grid with 128 cells along each side of a cube.
  const Polyhedron& p = built.polyhedron;
  expectLooks(
    [&](Monitor& monitor)
    {
      const HullLocator locator(
        built.run.geometry, p.triangles.data(), p.triangleCount(), p.vertices.data(), monitor);
    },
    looksIn(2 * std::size_t(p.triangleCount()) + 6 * 129 * 129));
}

TEST(Polls, WhileTheTriangulationsLocatorIsMade)
{
  const Cloud cloud = fromWeightedFamily("uniform", 20000, 92).make();
  const Triangulation triangulation =
    regularTriangulation(viewOf(cloud), WeightView(), oneThread(FacetMode::Triangles));
  Monitor silent(Options{});
  FanMesh mesh;
  ASSERT_TRUE(mesh.link(triangulation, true, silent));
  const PointSource source(viewOf(cloud), WeightView());
  std::vector<Vertex> sites;
  for (const std::int64_t id : triangulation.pointIds)
  {
    sites.push_back(source.vertex(static_cast<std::uint32_t>(id)));
  }
  // Each position once to copy it, twice for its bounds, twice to sort it; and two cells.
  expectLooks([&](Monitor& monitor)
    { const SiteLocator locator(sites.data(), mesh, true, monitor); },
    looksIn(7 * sites.size()));
}

TEST(Polls, WhileFacetsAreJoinedAndWritten)
{
  // Every square of the grid is a facet of two triangles.
  const int side = 200;
  const Cloud cloud = squareGrid(side);
  Built<TriangulationRun<false>> built = delaunay(cloud);
  const std::size_t squares = static_cast<std::size_t>(side - 1) * (side - 1);
  const std::size_t triangles = 2 * squares;
  Polyhedron polyhedron;
  Tally tally;
  const auto start = [&]
  {
    polyhedron = copyOf(built.polyhedron);
    tally = built.tally;
  };
  // The search for flat edges looks once in 4096 triangles.
  const Work remove = [&](Monitor& monitor)
  {
    start();
    EXPECT_TRUE(
      (RedundantVertices<LiftedGeometry<false>>(built.run.geometry, polyhedron, tally, monitor)
          .remove()));
  };
  expectLooks(remove, triangles / 4096);
  Options quiet;
  Monitor silent(quiet);
  remove(silent);
  const Polyhedron marked = copyOf(polyhedron);

  CellComplex complex;
  const auto pointCount = static_cast<std::uint32_t>(cloud.size());
  const auto form = [&](Monitor& monitor, bool anyFlat)
  {
    polyhedron = copyOf(marked);
    return std::make_unique<CanonicalForm<Polyhedron>>(polyhedron, anyFlat, tally.duplicates,
      pointCount, FacetMode::Polygons, monitor, complex.pointIds);
  };
  // Three passes over the points; then one over triangles and facets' corners.
  expectLooks([&](Monitor& monitor) { form(monitor, false); }, 3 * looksIn(cloud.size()));
  expectLooks([&](Monitor& monitor) { form(monitor, true); },
    3 * looksIn(cloud.size()) + looksIn(triangles + 4 * squares));
  // Two passes over the facets.
  expectLooks([&](Monitor& monitor) { form(silent, true)->writeCells(monitor, complex); },
    3 + looksIn(2 * squares));
}

}
}
}
