// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A power diagram is the same bits on any number of threads, and so is what it refuses. The inputs
/// have several tasks' worth of sites.
#include "Testing/Engine/Conformance/CompareTriangulation.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"
#include "Testing/Engine/PowerDiagram/PowerPolygons.h"

#include <flipflop/PowerDiagram.h>
#include <flipflop/RegularTriangulation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

const int Count = isSanitized() ? 9000 : 20000;

Triangulation triangulate(const Cloud& sites)
{
  Options options;
  options.facets = FacetMode::Polygons;
  return regularTriangulation(viewOf(sites), weightsOf(sites), options);
}

PowerDiagram diagramOf(
  const Cloud& sites, const Triangulation& triangulation, const double* box, int threads)
{
  Options options;
  options.threads = threads;
  return powerDiagram(viewOf(sites), weightsOf(sites), triangulation, box, options);
}

/// @return the diagram on one thread
PowerDiagram expectSameBits(const Cloud& sites, const double* box)
{
  const Triangulation triangulation = triangulate(sites);
  PowerDiagram alone = diagramOf(sites, triangulation, box, 1);
  for (const int threads : threadsTried())
  {
    SCOPED_TRACE(std::to_string(threads) + " threads");
    const PowerDiagram found = diagramOf(sites, triangulation, box, threads);
    EXPECT_EQ(bitDifference(found, alone), "");
  }
  return alone;
}

/// Corners are numbered in the order in which cells first use them.
void expectFirstUses(const PowerDiagram& diagram)
{
  std::int64_t next = 0;
  for (const std::int64_t corner : diagram.connectivity)
  {
    ASSERT_LE(corner, next);
    next += corner == next ? 1 : 0;
  }
  EXPECT_EQ(2 * static_cast<std::size_t>(next), diagram.corners.size());
}

TEST(PowerDiagramThreads, OfSitesAtRandom)
{
  // Some are hidden; the box cuts many cells, and leaves most of them out.
  const double box[] = { 0.3, 0.7, 0.4, 0.6 };
  for (const double weight : { 0.0, 1.0 / Count })
  {
    const PowerDiagram diagram = expectSameBits(randomSites(Count, weight, 71), box);
    EXPECT_GT(static_cast<int>(diagram.siteIds.size()), Count / 20);
    EXPECT_LT(static_cast<int>(diagram.siteIds.size()), Count / 10);
    expectFirstUses(diagram);
  }
}

TEST(PowerDiagramThreads, OfAGrid)
{
  Cloud sites;
  for (int i = 0; i < Count; ++i)
  {
    sites.push_back({ i % 200 / 4.0, i / 200 / 4.0, 0.0 });
  }
  // Its lower border goes through corners of cells, whose positions so come of facets and the box.
  const double box[] = { -1, 60, 0.125, 60 };
  const PowerDiagram diagram = expectSameBits(sites, box);
  EXPECT_EQ(static_cast<int>(diagram.siteIds.size()), Count - 200);
  EXPECT_EQ(static_cast<int>(diagram.corners.size() / 2), 201 * (Count / 200));
  expectFirstUses(diagram);
}

TEST(PowerDiagramThreads, OfFacetsOfAnySize)
{
  // A grid with holes, around which facets have up to eight corners and more.
  Random random(73);
  Cloud sites;
  for (int i = 0; i < Count; ++i)
  {
    if (random.integer(0, 2) > 0)
    {
      sites.push_back({ i % 190 / 4.0, i / 190 / 4.0, 0.0 });
    }
  }
  const Triangulation triangulation = triangulate(sites);
  std::set<std::int64_t> lengths;
  for (std::int64_t c = 0; c < triangulation.cellCount(); ++c)
  {
    lengths.insert(triangulation.cellBegin(c + 1) - triangulation.cellBegin(c));
  }
  EXPECT_GT(lengths.size(), 2u);
  const double box[] = { 0, 40, 0, 20 };
  expectFirstUses(expectSameBits(sites, box));
}

TEST(PowerDiagramThreads, OfSitesOnALine)
{
  Cloud sites;
  for (int i = 0; i < Count; ++i)
  {
    sites.push_back({ i / 4.0, i / 8.0, 0.0 });
  }
  const double box[] = { 0, 40, -1, 20 };
  expectFirstUses(expectSameBits(sites, box));
}

TEST(PowerDiagramThreads, OfCentersThatRoundToOne)
{
  // Around each of many places, a ring of sites almost on a circle.
  Random random(72);
  Cloud sites;
  for (int i = 0; i < Count; ++i)
  {
    const double angle = random.uniform(0, 6.28);
    const double place = 10 + 3 * (i % 100);
    sites.push_back({ place + std::cos(angle), place + std::sin(angle), 0.0 });
  }
  const double box[] = { 0, 400, 0, 400 };
  const Triangulation triangulation = triangulate(sites);
  const PowerDiagram diagram = expectSameBits(sites, box);
  EXPECT_LT(diagram.corners.size() / 2, static_cast<std::size_t>(triangulation.cellCount()));
  expectFirstUses(diagram);
}

TEST(PowerDiagramThreads, TheFirstFaultIsTold)
{
  const Cloud sites = randomSites(Count, 0.0, 71);
  const double box[] = { 0, 1, 0, 1 };
  for (const std::int64_t from : { Count / 4, Count / 3, Count / 2 })
  {
    // Two facets are there twice, so no ring closes at their corners.
    Triangulation triangulation = triangulate(sites);
    ASSERT_EQ(triangulation.cellSize, 3);
    std::vector<std::int64_t> corners(
      triangulation.connectivity.begin(), triangulation.connectivity.end());
    const auto facetFrom = [&](std::int64_t lowest)
    {
      std::size_t at = 0;
      while (triangulation.connectivity[at] < lowest)
      {
        at += 3;
      }
      return triangulation.connectivity.begin() + at;
    };
    for (const std::int64_t lowest : { std::int64_t(Count / 5 * 4), from })
    {
      corners.insert(corners.end(), facetFrom(lowest), facetFrom(lowest) + 3);
    }
    const std::int64_t first = triangulation.pointIds[corners[corners.size() - 3]];
    triangulation.connectivity.allocate(corners.size());
    std::copy(corners.begin(), corners.end(), triangulation.connectivity.begin());
    for (const int threads : { 1, 2, 4, 4, 4, 4 })
    {
      try
      {
        diagramOf(sites, triangulation, box, threads);
        ADD_FAILURE() << "no error";
      }
      catch (const Error& error)
      {
        EXPECT_EQ(error.code(), ErrorCode::BadArgument);
        EXPECT_EQ(error.index(), first);
      }
    }
  }
}

}
}
}
