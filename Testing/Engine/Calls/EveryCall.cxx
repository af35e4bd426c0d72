// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Engine/Calls/EveryCall.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"
#include "Testing/Engine/Inputs/Surfaces.h"

#include "Points/PointSource.h"

#include <flipflop/Batch.h>
#include <flipflop/Certificate.h>
#include <flipflop/Convexify.h>
#include <flipflop/EdgeLengths.h>
#include <flipflop/EditableTriangulation.h>
#include <flipflop/FurthestSite.h>
#include <flipflop/Measures.h>
#include <flipflop/Neighbors.h>
#include <flipflop/TriangulationQueries.h>

#include <array>
#include <memory>

namespace flipflop
{
namespace test
{

namespace
{

template <class Result>
Bits bitsOfAll(const Batch<Result>& batch)
{
  Bits bits;
  for (const Result& result : batch.results)
  {
    bits += bitsOf(result);
  }
  for (const SetError& fault : batch.errors)
  {
    throw Error(fault.error);
  }
  return bits;
}

/// So many numbers, and what a call writes into them.
template <class T, class Write>
Bits bitsWritten(std::size_t count, const Write& write)
{
  std::vector<T> values(count);
  write(values.data());
  return bitsOf(values);
}

template <class T>
std::size_t sizeOf(const T& value)
{
  return static_cast<std::size_t>(value);
}

using Box = std::array<double, 4>;

/// What diagrams fill.
Box boxOf(double unit)
{
  return { 0.1 * unit, 0.9 * unit, 0.2 * unit, 0.7 * unit };
}

Cloud scaled(Cloud cloud, double unit)
{
  for (auto& point : cloud)
  {
    for (double& x : point)
    {
      x *= unit;
    }
  }
  return cloud;
}

struct Table
{
  std::vector<Call> calls;

  /// @param run (points, weights, options) -> Bits
  template <class Run>
  void add(const char* name, const Cloud& cloud, bool planar, bool weighted,
    NonFinitePoint nonFinite, const Run& run)
  {
    this->calls.push_back({ name, cloud, planar, weighted, nonFinite, run });
  }
};

using Points = const PointView&;
using Weights = const WeightView&;

void addRuns(Table& table, const CallInputs& given)
{
  const Cloud& body = given.body;
  const Cloud& sites = given.sites;
  const Box box = boxOf(given.unit);
  const NonFinitePoint refused = NonFinitePoint::IsRefused;
  table.add("convexHull", body, false, false, refused,
    [](Points points, Weights, const Options& options)
    { return bitsOf(convexHull(points, options)); });
  table.add("regularTriangulation", sites, true, true, refused,
    [](Points points, Weights weights, const Options& options)
    { return bitsOf(regularTriangulation(points, weights, options)); });
  table.add("furthestSiteTriangulation", sites, true, false, refused,
    [](Points points, Weights, const Options& options)
    { return bitsOf(furthestSiteTriangulation(points, options)); });
  // One set of none and one of all, so that the point at fault has the same number.
  const auto batchOf = [](Points points, const auto& run)
  {
    const std::int64_t offsets[] = { 0, 0, std::max<std::int64_t>(points.count, 0) };
    SetView sets;
    sets.offsets = offsets;
    sets.count = 2;
    return bitsOfAll(run(sets));
  };
  table.add("convexHulls", body, false, false, refused,
    [=](Points points, Weights, const Options& options)
    {
      return batchOf(
        points, [&](const SetView& sets) { return convexHulls(points, sets, options); });
    });
  table.add("regularTriangulations", sites, true, true, refused,
    [=](Points points, Weights weights, const Options& options)
    {
      return batchOf(points,
        [&](const SetView& sets) { return regularTriangulations(points, sets, weights, options); });
    });
  const auto surface = std::make_shared<Surface>(perturbedIcosphere(given.levels, 0.05, 64));
  table.add("convexify", scaled(roundedToFloat(surface->points), given.unit), false, false, refused,
    [=](Points points, Weights, const Options& options)
    { return bitsOf(convexify(points, surface->view(), nullptr, options)); });
  // The lines of a grid and its diagonals: they meet at its points.
  const int side = given.side;
  using Segment = std::array<std::int64_t, 2>;
  const auto lines = std::make_shared<std::vector<Segment>>();
  for (std::int64_t i = 0; i < side; ++i)
  {
    lines->push_back({ side * i, side * i + side - 1 });
    lines->push_back({ i, side * (side - 1) + i });
    lines->push_back({ i, side * (side - 1 - i) + side - 1 });
  }
  table.add("constrainedTriangulation", scaled(squareGrid(side), given.unit), true, false, refused,
    [=](Points points, Weights, const Options& options)
    {
      const ConstraintView constraints((*lines)[0].data(), 3 * side);
      return bitsOf(constrainedTriangulation(points, constraints, options));
    });
  const auto chords = std::make_shared<std::vector<Segment>>();
  const auto chordCount = static_cast<std::int64_t>(sites.size() / 15);
  for (std::int64_t i = 0; i < chordCount; ++i)
  {
    chords->push_back({ 5 * i, 5 * i / 2 });
  }
  table.add("splitCrossings", sites, true, false, refused,
    [=](Points points, Weights, const Options& options)
    {
      return bitsOf(
        splitCrossings(points, ConstraintView((*chords)[0].data(), chordCount), options));
    });
  // Every other line ends at points that are there.
  const auto ends = std::make_shared<Cloud>(sites.begin(), sites.begin() + 2 * chordCount);
  for (std::size_t i = 0; i < ends->size(); i += 4)
  {
    (*ends)[i][0] += 0.001 * given.unit;
  }
  const auto pairs = std::make_shared<std::vector<Segment>>();
  for (std::int64_t i = 0; i < chordCount; ++i)
  {
    pairs->push_back({ 2 * i, 2 * i + 1 });
  }
  table.add("joinLines", sites, true, false, refused,
    [=](Points points, Weights, const Options& options)
    {
      return bitsOf(
        joinLines(points, viewOf(*ends), ConstraintView((*pairs)[0].data(), chordCount), options));
    });
  table.add("centroidalCells", sites, true, true, refused,
    [=](Points points, Weights weights, const Options& options)
    { return bitsOf(centroidalCells(points, weights, box.data(), 2, 0, options)); });
  table.add("prescribedAreas", sites, true, false, refused,
    [=](Points points, Weights, const Options& options)
    { return bitsOf(prescribedAreas(points, WeightView(), box.data(), 1e-6, 2, options)); });
  table.add("refinedMesh", sites, true, false, refused,
    [](Points points, Weights, const Options& options)
    {
      RefinementOptions refinement;
      refinement.maxPoints = 2000;
      return bitsOf(refinedMesh(points, ConstraintView(), refinement, options));
    });
  // Borders that touch a sphere about the origin, or are far from it.
  table.add("halfSpaceIntersection", body, false, false, refused,
    [unit = given.unit](Points points, Weights, const Options& options)
    {
      requireValid(points, 3);
      const PointSource source(points);
      std::vector<double> rows;
      for (std::uint32_t id = 0; id < source.count(); ++id)
      {
        const Vertex v = source.vertex(id);
        rows.insert(rows.end(), { v.x[0], v.x[1], v.x[2], -unit });
      }
      return bitsOf(halfSpaceIntersection({ rows.data(), points.count, 3 }, nullptr, options));
    });
  table.add("terrainMesh", body, false, false, refused,
    [](Points points, Weights, const Options& options)
    {
      const std::int64_t line[] = { 0, 1 };
      return bitsOf(
        terrainMesh(points, WeightView(), ConstraintView(line, 1), { 0.3, 1000 }, options));
    });
  table.add("EditableTriangulation", sites, true, true, refused,
    [](Points points, Weights weights, const Options& options)
    {
      EditableTriangulation edited(points, weights, options);
      const std::int64_t some[] = { 3, 1, 4, 15 };
      Options quiet;
      quiet.threads = options.threads;
      edited.remove(some, 4, quiet);
      edited.insert(points, weights, quiet);
      return bitsOf(edited.snapshot(quiet));
    });
  table.add("fitPlane", body, false, false, NonFinitePoint::IsLeftOut,
    [](Points points, Weights, const Options& options)
    { return bitsOf(fitPlane(points, options)); });
  const FittedPlane plane = fitPlane(viewOf(body));
  table.add("positionsInPlane", body, false, false, NonFinitePoint::IsLeftOut,
    [=](Points points, Weights, const Options& options)
    { return bitsOf(positionsInPlane(points, plane, options)); });
  table.add("positionsInXY", body, false, false, NonFinitePoint::IsLeftOut,
    [](const PointView& points, const WeightView&, const Options& options)
    { return bitsOf(positionsInXY(points, options)); });
}

void addQueriesOfHulls(Table& table, const Cloud& body)
{
  const NonFinitePoint refused = NonFinitePoint::IsRefused;
  const auto hull = std::make_shared<Hull>(convexHull(viewOf(body)));
  const auto queries = std::make_shared<HullQueries>(viewOf(body), *hull);
  table.add("HullQueries", body, false, false, NonFinitePoint::IsBadArgument,
    [=](Points points, Weights, const Options& options)
    { return bitsOf(HullQueries(points, *hull, options).diameter()); });
  const auto add = [&](const char* name, auto value, auto ask)
  {
    using Value = decltype(value);
    table.add(name, body, false, false, refused,
      [=](Points points, Weights, const Options& options)
      {
        return bitsWritten<Value>(sizeOf(std::max<std::int64_t>(points.count, 0) % 100000),
          [&](Value* values) { ask(*queries, points, values, options); });
      });
  };
  add("contains", std::int8_t(0),
    [](const HullQueries& of, Points points, std::int8_t* values, const Options& o)
    { of.contains(points, values, o); });
  add("support", std::int64_t(0),
    [](const HullQueries& of, Points points, std::int64_t* values, const Options& o)
    { of.support(points, values, o); });
  add("distance", 0.0,
    [](const HullQueries& of, Points points, double* values, const Options& o)
    { of.distance(points, values, o); });
  const NonFinitePoint unread = NonFinitePoint::IsNotRead;
  table.add("diameter", body, false, false, unread,
    [=](Points, Weights, const Options& options) { return bitsOf(queries->diameter(options)); });
  table.add("minimalBox", body, false, false, unread,
    [=](Points, Weights, const Options& options) { return bitsOf(queries->minimalBox(options)); });
  table.add("facetPlanes", body, false, false, NonFinitePoint::IsBadArgument,
    [=](Points points, Weights, const Options& options)
    { return bitsOf(facetPlanes(points, *hull, options)); });
  table.add("certificateOfAHull", body, false, false, refused,
    [=](Points points, Weights, const Options& options)
    {
      const Certificate found = certificate(points, *hull, options);
      return bitsOf(found.cells) + bitsOf(found.apex);
    });
  table.add("cellNeighbors", body, false, false, unread,
    [=](Points, Weights, const Options& options) { return bitsOf(cellNeighbors(*hull, options)); });
}

void addQueriesOfTriangulations(Table& table, const CallInputs& inputs)
{
  const Cloud& sites = inputs.sites;
  const Box box = boxOf(inputs.unit);
  const NonFinitePoint refused = NonFinitePoint::IsRefused;
  const NonFinitePoint bad = NonFinitePoint::IsBadArgument;
  const NonFinitePoint unread = NonFinitePoint::IsNotRead;
  Options polygons;
  polygons.facets = FacetMode::Polygons;
  const auto found = std::make_shared<Triangulation>(
    regularTriangulation(viewOf(sites), weightsOf(sites), polygons));
  const auto queries =
    std::make_shared<TriangulationQueries>(viewOf(sites), weightsOf(sites), *found);
  const auto given = std::make_shared<Cloud>(sites);
  table.add("TriangulationQueries", sites, true, true, bad,
    [=](Points points, Weights weights, const Options& options)
    {
      std::int64_t id = -2;
      TriangulationQueries(points, weights, *found, options)
        .nearest(PointView(box.data(), 1, 2), &id);
      return bitsOf(&id, 1);
    });
  const auto half = std::make_shared<std::vector<std::uint8_t>>(sizeOf(found->cellCount()), 1);
  std::fill_n(half->begin(), half->size() / 2, std::uint8_t(0));
  table.add("TriangulationQueriesOfSomeCells", sites, true, true, bad,
    [=](Points points, Weights weights, const Options& options)
    {
      std::int64_t cells[] = { -2, -2 };
      TriangulationQueries(points, weights, *found, half->data(), options)
        .locate(PointView(box.data(), 2, 2), cells);
      return bitsOf(cells, 2);
    });
  const auto add = [&](const char* name, auto value, auto ask)
  {
    using Value = decltype(value);
    table.add(name, sites, true, false, refused,
      [=](Points points, Weights, const Options& options)
      {
        return bitsWritten<Value>(sizeOf(std::max<std::int64_t>(points.count, 0) % 100000),
          [&](Value* values) { ask(*queries, points, values, options); });
      });
  };
  add("locate", std::int64_t(0),
    [](const TriangulationQueries& of, Points points, std::int64_t* values, const Options& o)
    { of.locate(points, values, o); });
  add("nearest", std::int64_t(0),
    [](const TriangulationQueries& of, Points points, std::int64_t* values, const Options& o)
    { of.nearest(points, values, o); });
  add("interpolateLinear", 0.0,
    [given](const TriangulationQueries& of, Points points, double* values, const Options& o)
    { of.interpolateLinear(given->data()->data(), 1, points, values, o); });
  add("interpolateNatural", 0.0,
    [given](const TriangulationQueries& of, Points points, double* values, const Options& o)
    { of.interpolateNatural(given->data()->data(), 1, points, values, o); });
  add("interpolateCloughTocher", 0.0,
    [given](const TriangulationQueries& of, Points points, double* values, const Options& o)
    { of.interpolateCloughTocher(given->data()->data(), 1, points, values, o); });
  table.add("siteGradients", sites, true, false, unread,
    [=](Points, Weights, const Options& options)
    {
      return bitsWritten<double>(2 * given->size(),
        [&](double* gradients)
        { queries->siteGradients(given->data()->data(), 1, gradients, options); });
    });
  const double step = box[0] / 15;
  table.add("interpolateImage", sites, true, false, unread,
    [=](Points, Weights, const Options& options)
    {
      const ImageGrid grid{ { -step, box[1] }, { step, -step }, { 150, 150 }, { 0, 0 } };
      return bitsWritten<double>(150 * 150,
        [&](double* pixels)
        {
          queries->interpolateImage(Interpolation::Linear, given->data()->data(), 1, grid,
            ImageView(pixels), -1.0, options);
        });
    });
  table.add("certificateOfATriangulation", sites, true, true, bad,
    [=](Points points, Weights weights, const Options& options)
    { return bitsOf(certificate(points, weights, *found, options).cells); });
  table.add("powerDiagram", sites, true, true, bad,
    [=](Points points, Weights weights, const Options& options)
    { return bitsOf(powerDiagram(points, weights, *found, box.data(), options)); });
  const double unit = inputs.unit;
  const std::array<double, 8> polygon{ 0.1 * unit, 0, 0.9 * unit, 0.2 * unit, 0.7 * unit,
    0.8 * unit, 0.2 * unit, 0.9 * unit };
  table.add("powerDiagramInAPolygon", sites, true, true, bad,
    [=](Points points, Weights weights, const Options& options)
    {
      return bitsOf(
        powerDiagram(points, weights, *found, ConvexDomain(polygon.data(), 4), options));
    });
  table.add("alphaComplex", sites, true, true, bad,
    [=](Points points, Weights weights, const Options& options)
    { return bitsOf(alphaComplex(points, weights, *found, 0.01, true, options)); });
  const std::size_t cells = sizeOf(found->cellCount());
  table.add("cellAlphas", sites, true, true, bad,
    [=](Points points, Weights weights, const Options& options)
    {
      return bitsWritten<double>(
        cells, [&](double* alphas) { cellAlphas(points, weights, *found, alphas, options); });
    });
  const double limit = 0.02 * unit;
  table.add("cellsWithinEdgeLength", sites, true, false, bad,
    [=](Points points, Weights, const Options& options)
    {
      return bitsWritten<std::uint8_t>(cells,
        [&](std::uint8_t* within)
        { cellsWithinEdgeLength(points, *found, limit, within, options); });
    });
  table.add("cellMeasures", sites, true, false, bad,
    [=](Points points, Weights, const Options& options)
    {
      return bitsWritten<double>(3 * cells,
        [&](double* values) { cellMeasures(points, *found, values, values + cells, options); });
    });
  table.add("facetCenters", sites, true, true, bad,
    [=](Points points, Weights weights, const Options& options)
    {
      return bitsWritten<double>(2 * cells,
        [&](double* centers) { facetCenters(points, weights, *found, centers, options); });
    });
  const auto diagram = std::make_shared<PowerDiagram>(
    powerDiagram(viewOf(sites), weightsOf(sites), *found, box.data()));
  const std::size_t regions = diagram->siteIds.size();
  table.add("cellMeasuresOfADiagram", sites, true, false, unread,
    [=](Points, Weights, const Options& options)
    {
      return bitsWritten<double>(3 * regions,
        [&](double* values) { cellMeasures(*diagram, values, values + regions, options); });
    });
  table.add("cellBoundary", sites, true, false, unread,
    [=](Points, Weights, const Options& options) { return bitsOf(cellBoundary(*found, options)); });
  const std::int64_t square[] = { 0, 1, 1, 2, 2, 0 };
  const auto inside = std::make_shared<ConstrainedTriangulation>(
    constrainedTriangulation(viewOf(sites), ConstraintView(square, 3, 3)));
  table.add("certificateOfAConstrainedTriangulation", sites, true, false, bad,
    [=](Points points, Weights, const Options& options)
    { return bitsOf(certificate(points, *inside, options).cells); });
  table.add("cellsInside", sites, true, false, unread,
    [=](Points, Weights, const Options& options)
    {
      return bitsWritten<std::uint8_t>(sizeOf(inside->cellCount()),
        [&](std::uint8_t* kept) { cellsInside(*inside, kept, options); });
    });
}

void addPolygons(Table& table, const CallInputs& given)
{
  // A comb: one polygon of so many corners that it is cut in steps.
  const auto corners = std::make_shared<std::vector<std::int64_t>>();
  Cloud teeth = { { 9000, -1, 0 }, { 0, -1, 0 } };
  for (int i = 0; i < given.teeth; ++i)
  {
    teeth.push_back({ { double(i), i % 2 ? 5.0 : 0.0, 0 } });
  }
  for (std::size_t i = 0; i < teeth.size(); ++i)
  {
    corners->push_back(static_cast<std::int64_t>(i));
  }
  const auto offsets = std::make_shared<std::vector<std::int64_t>>(
    std::vector<std::int64_t>{ 0, static_cast<std::int64_t>(teeth.size()) });
  table.add("triangulatePolygons", scaled(teeth, given.unit), false, false,
    NonFinitePoint::IsLeftOut,
    [=](Points points, Weights, const Options& options)
    {
      PolygonView view;
      view.corners = corners->data();
      view.offsets = offsets->data();
      view.count = 1;
      return bitsOf(triangulatePolygons(points, view, options));
    });
}

}

WeightView Call::weights() const
{
  return this->weighted ? weightsOf(this->cloud) : WeightView();
}

Bits Call::operator()(const Options& options) const
{
  return this->run(viewOf(this->cloud), this->weights(), options);
}

namespace
{

CallInputs usualInputs()
{
  return { roundedToFloat(fromFamily("ball", 4500, 5).make()),
    roundedToFloat(fromFamily("shell0", 2100, 6).make()),
    roundedToFloat(randomSites(4500, 1e-4, 72)) };
}

}

std::vector<Call> callsOn(const CallInputs& inputs)
{
  Table table;
  addRuns(table, inputs);
  addQueriesOfHulls(table, inputs.shell);
  addQueriesOfTriangulations(table, inputs);
  addPolygons(table, inputs);
  return table.calls;
}

const std::vector<Call>& everyCall()
{
  static const std::vector<Call> calls = callsOn(usualInputs());
  return calls;
}

std::vector<CallOnCells> everyCallOnCells()
{
  return {
    { "cellBoundary", [](const Cloud&, const Triangulation& cells) { cellBoundary(cells); } },
    { "cellMeasures",
      [](const Cloud& sites, const Triangulation& cells)
      { cellMeasures(viewOf(sites), cells, nullptr, nullptr); } },
    { "facetCenters",
      [](const Cloud& sites, const Triangulation& cells)
      {
        std::vector<double> centers(2 * cells.connectivity.size());
        facetCenters(viewOf(sites), weightsOf(sites), cells, centers.data());
      } },
    { "cellsWithinEdgeLength",
      [](const Cloud& sites, const Triangulation& cells)
      {
        std::uint8_t within[100];
        cellsWithinEdgeLength(viewOf(sites), cells, 1, within);
      } },
    { "cellAlphas",
      [](const Cloud& sites, const Triangulation& cells)
      {
        double alphas[100];
        cellAlphas(viewOf(sites), WeightView(), cells, alphas);
      } },
    { "alphaComplex",
      [](const Cloud& sites, const Triangulation& cells)
      { alphaComplex(viewOf(sites), WeightView(), cells, 1, true); } },
    { "powerDiagram",
      [](const Cloud& sites, const Triangulation& cells)
      { powerDiagram(viewOf(sites), WeightView(), cells, boxOf(1).data()); } },
    { "TriangulationQueries",
      [](const Cloud& sites, const Triangulation& cells)
      { TriangulationQueries(viewOf(sites), WeightView(), cells); } },
    { "certificate",
      [](const Cloud& sites, const Triangulation& cells)
      { certificate(viewOf(sites), WeightView(), cells); } },
  };
}

}
}
