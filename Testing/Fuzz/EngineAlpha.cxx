// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "EngineCalls.h"
#include "EngineQueries.h"

#include "Testing/Engine/Alpha/AlphaByForce.h"
#include <flipflop/AlphaComplex.h>
#include <flipflop/CellBoundary.h>
#include <flipflop/EdgeLengths.h>

#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace flipflop
{
namespace fuzz
{

namespace
{

using Side = std::pair<std::int64_t, std::int64_t>;

/// Up to so many sites, brute force in rationals is quick.
constexpr std::size_t FewPoints = 12;
constexpr double Infinite = std::numeric_limits<double>::infinity();

/// use (corner, next corner) for each side of a cell, indices into pointIds.
template <class Use>
void eachSide(const CellComplex& cells, std::int64_t cell, const Use& use)
{
  const std::int64_t end = cells.cellBegin(cell + 1);
  for (std::int64_t k = cells.cellBegin(cell); k < end; ++k)
  {
    const std::int64_t next = k + 1 < end ? k + 1 : cells.cellBegin(cell);
    use(cells.connectivity[static_cast<std::size_t>(k)],
      cells.connectivity[static_cast<std::size_t>(next)]);
  }
}

/// The edges and points beside the cells are at none of them, and are told in order.
void demandSingular(const AlphaComplex& complex, const CellComplex& cells, double alpha)
{
  std::set<Side> taken;
  std::set<Side> known;
  std::set<std::int64_t> ends;
  for (std::int64_t c = 0; c < cells.cellCount(); ++c)
  {
    const bool isIn = complex.cells[static_cast<std::size_t>(c)] != 0;
    eachSide(cells, c,
      [&](std::int64_t a, std::int64_t b)
      {
        (isIn ? taken : known).insert(std::minmax(a, b));
        if (isIn)
        {
          ends.insert(a);
        }
      });
  }
  const std::size_t edges = complex.edgeAlphas.size();
  demand(complex.edges.size() == 2 * edges, "half an edge");
  Side last{ -1, -1 };
  for (std::size_t i = 0; i < edges; ++i)
  {
    const Side edge{ complex.edges[2 * i], complex.edges[2 * i + 1] };
    demand(edge.first < edge.second && last < edge, "edges do not ascend");
    demand(taken.count(edge) == 0, "a singular edge is a side of a cell that is in");
    demand(known.count(edge) == 1, "a singular edge is none of the triangulation");
    demand(complex.edgeAlphas[i] <= alpha, "a singular edge beyond alpha");
    ends.insert({ edge.first, edge.second });
    last = edge;
  }
  demand(complex.vertices.size() == complex.vertexAlphas.size(), "a point without its number");
  for (std::size_t i = 0; i < complex.vertices.size(); ++i)
  {
    const std::int64_t v = complex.vertices[i];
    demand(v >= 0 && v < static_cast<std::int64_t>(cells.pointIds.size()), "no such point");
    demand(i == 0 || complex.vertices[i - 1] < v, "singular points do not ascend");
    demand(ends.count(v) == 0, "a singular point is in a cell or edge");
    demand(complex.vertexAlphas[i] <= alpha, "a singular point beyond alpha");
  }
}

void demandByForce(
  const AlphaComplex& complex, const Triangulation& triangulation, const Cloud& sites, double alpha)
{
  const test::AlphaByForce expected = test::alphaByForce(sites, triangulation, alpha);
  const auto id = [&](std::int64_t v)
  { return triangulation.pointIds[static_cast<std::size_t>(v)]; };
  std::vector<Side> edges;
  for (std::size_t i = 0; i < complex.edges.size(); i += 2)
  {
    edges.emplace_back(id(complex.edges[i]), id(complex.edges[i + 1]));
  }
  std::vector<std::int64_t> vertices;
  for (const std::int64_t v : complex.vertices)
  {
    vertices.push_back(id(v));
  }
  demand(std::equal(complex.cells.begin(), complex.cells.end(), expected.cells.begin(),
           expected.cells.end()),
    "not the cells of brute force");
  demand(edges == expected.edges, "not the edges of brute force");
  demand(vertices == expected.vertices, "not the points of brute force");
}

/// All that a border promises.
void demandRings(const CellBoundary& boundary, const CellComplex& cells)
{
  std::set<Side> sides;
  for (std::int64_t c = 0; cells.dimension == 2 && c < cells.cellCount(); ++c)
  {
    eachSide(cells, c, [&](std::int64_t a, std::int64_t b) { sides.emplace(a, b); });
  }
  std::set<Side> border;
  for (const Side& side : sides)
  {
    if (sides.count({ side.second, side.first }) == 0)
    {
      border.insert(side);
    }
  }
  const auto& offsets = boundary.offsets;
  demand(!offsets.empty() && offsets[0] == 0 &&
      offsets[offsets.size() - 1] == static_cast<std::int64_t>(boundary.connectivity.size()),
    "offsets of rings do not begin at 0, or do not end with the corners");
  std::vector<std::int64_t> last;
  for (std::size_t i = 0; i + 1 < offsets.size(); ++i)
  {
    demand(offsets[i + 1] >= offsets[i] + 3, "a ring of less than three corners");
    const std::vector<std::int64_t> ring(
      boundary.connectivity.begin() + offsets[i], boundary.connectivity.begin() + offsets[i + 1]);
    demand(std::set<std::int64_t>(ring.begin(), ring.end()).size() == ring.size(),
      "a ring passes a corner twice");
    demand(
      *std::min_element(ring.begin(), ring.end()) == ring[0], "a ring starts at another corner");
    demand(last < ring, "rings do not ascend");
    for (std::size_t k = 0; k < ring.size(); ++k)
    {
      demand(border.erase({ ring[k], ring[(k + 1) % ring.size()] }) == 1,
        "a ring along what is no border, or twice");
    }
    last = ring;
  }
  demand(border.empty(), "a side at the border is in no ring");
}

/// @param isRight a triangulation, with or without all of its cells
void judgeBoundary(
  const CellComplex& cells, const Options& options, const Watch& watch, bool isRight)
{
  const auto outcome = attempt([&] { return cellBoundary(cells, options); });
  expectOutcome(outcome, watch, { ErrorCode::BadArgument });
  demand(outcome.result || watch.stopped || !isRight, "cells of a triangulation are refused");
  if (!outcome.result)
  {
    return;
  }
  demandRings(*outcome.result, cells);
  const CellBoundary other = cellBoundary(cells, unwatched(options));
  demand(std::equal(other.connectivity.begin(), other.connectivity.end(),
           outcome.result->connectivity.begin(), outcome.result->connectivity.end()),
    "a border depends on the number of threads");
}

}

void fuzzAlpha(Bytes& bytes)
{
  Watch watch;
  const Options options = drawOptions(bytes, watch);
  const int kind = bytes.below(3); // of the call that is watched
  const bool isBroken = bytes.oneOf(3);
  const bool isSingular = !bytes.oneOf(4);
  Cloud drawn = drawCloud(bytes, 300);
  drawWeights(bytes, drawn);
  Cloud sites;
  std::copy_if(drawn.begin(), drawn.end(), std::back_inserter(sites),
    [](const Point& p)
    { return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]); });
  const PointView points = test::viewOf(sites);
  const WeightView weights = test::weightsOf(sites);
  Options making = unwatched(options);
  making.facets = options.facets;
  Triangulation triangulation = regularTriangulation(points, weights, making);
  if (isBroken)
  {
    corrupt(bytes, triangulation, &triangulation.hiddenIds);
  }
  const auto of = [&](int call) { return call == kind ? options : unwatched(options); };
  const Watch none;
  const auto watchOf = [&](int call) -> const Watch& { return call == kind ? watch : none; };

  const auto cells = static_cast<std::size_t>(std::max<std::int64_t>(0, triangulation.cellCount()));
  const auto alphasOn = [&](const Options& chosen)
  {
    return attempt(
      [&]
      {
        std::vector<double> alphas(cells);
        cellAlphas(points, weights, triangulation, alphas.data(), chosen);
        return alphas;
      });
  };
  const auto told = alphasOn(of(0));
  expectOutcome(told, watchOf(0), { ErrorCode::BadArgument });
  const auto alphas = alphasOn(unwatched(of(0)));
  expectOutcome(alphas, Watch(), { ErrorCode::BadArgument });
  demand(alphas.result || isBroken, "a triangulation has no alphas");
  demand(!told.result || sameBits(*told.result, *alphas.result),
    "an alpha depends on the number of threads");

  // A cell's, or the next below, or any.
  const int choice = bytes.below(4);
  double alpha = bytes.number();
  if (choice < 2 && alphas.result && cells > 0)
  {
    alpha = (*alphas.result)[bytes.raw<std::uint16_t>() % cells];
    alpha = choice == 1 ? std::nextafter(alpha, -Infinite) : alpha;
  }
  const auto complex =
    attempt([&] { return alphaComplex(points, weights, triangulation, alpha, isSingular, of(1)); });
  expectOutcome(complex, watchOf(1), { ErrorCode::BadArgument });
  demand(complex.result || watchOf(1).stopped || isBroken || std::isnan(alpha),
    "a triangulation and a length are refused");
  demand(!complex.result || !std::isnan(alpha), "NaN is no length");
  judgeBoundary(triangulation, of(2), watchOf(2), !isBroken);
  if (!complex.result || isBroken)
  {
    return;
  }
  demand(complex.result->cells.size() == cells, "not an answer for each cell");
  for (std::size_t c = 0; c < cells; ++c)
  {
    demand((complex.result->cells[c] != 0) == ((*alphas.result)[c] <= alpha),
      "a cell is in beyond its number, or out within it");
  }
  demand(complex.result->cellCount ==
      std::count(complex.result->cells.begin(), complex.result->cells.end(), 1),
    "the count of cells is wrong");
  demandSingular(*complex.result, triangulation, alpha);
  demand(isSingular || (complex.result->edges.empty() && complex.result->vertices.empty()),
    "edges and points that nobody asked for");
  if (isSingular && sites.size() <= FewPoints && std::isfinite(alpha))
  {
    demandByForce(*complex.result, triangulation, sites, alpha);
  }
  keepCells(triangulation, complex.result->cells.data());
  judgeBoundary(triangulation, unwatched(options), Watch(), true);
}

}
}
