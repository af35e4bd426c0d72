// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Engine/Conformance/Kind.h"
#include "Support/Threads.h"
#include "Testing/Cuda/Rounds/RoundsOnHost.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flipflop
{
namespace test
{

const CellComplex& complexOf(const Result& result)
{
  return std::visit(
    [](const CellComplex& complex) -> const CellComplex& { return complex; }, result);
}

std::string difference(
  const Result& result, const ReferenceHull& reference, FacetMode facets, std::int64_t points)
{
  const auto* triangulation = std::get_if<Triangulation>(&result);
  return triangulation ? difference(*triangulation, reference, facets, points)
                       : difference(complexOf(result), reference, facets);
}

std::string bitDifference(const Result& a, const Result& b)
{
  const auto* triangulation = std::get_if<Triangulation>(&a);
  return triangulation ? bitDifference(*triangulation, std::get<Triangulation>(b))
                       : bitDifference(std::get<Hull>(a), std::get<Hull>(b));
}

std::string statisticsFault(const Result& result, std::int64_t points)
{
  const auto* triangulation = std::get_if<Triangulation>(&result);
  return triangulation ? statisticsFault(*triangulation, points)
                       : statisticsFault(complexOf(result), points);
}

Views viewsOf(const Cloud& cloud)
{
  return { viewOf(cloud), weightsOf(cloud) };
}

Validation validate(const Views& views, const Result& result, int threads)
{
  const auto* triangulation = std::get_if<Triangulation>(&result);
  return triangulation ? validate(views.points, views.weights, *triangulation, threads)
                       : validate(views.points, std::get<Hull>(result), threads);
}

Validation validate(const Cloud& cloud, const Result& result, int threads)
{
  return validate(viewsOf(cloud), result, threads);
}

const Kind convexHulls = {
  3,
  families,
  smallSpecialInputs,
  largeSpecialInputs,
  [](const Views& views, const Options& options) -> Result
  { return convexHull(views.points, options); },
  [](const Views& views, const Options& options, const HostOrder& how) -> Result
  { return hullByRounds(views.points, options, how); },
  bruteForceHull,
  cgalHull,
  kernelForHull,
};

const Kind regularTriangulations = {
  2,
  weightedFamilies,
  smallWeightedInputs,
  largeWeightedInputs,
  [](const Views& views, const Options& options) -> Result
  { return regularTriangulation(views.points, views.weights, options); },
  [](const Views& views, const Options& options, const HostOrder& how) -> Result
  { return triangulationByRounds(views.points, views.weights, options, how); },
  bruteForceTriangulation,
  cgalTriangulation,
  kernelForWeighted,
};

namespace
{

/// A cloud in every layout that has its numbers: the native one first.
class Layouts
{
public:
  struct Layout
  {
    std::string name;
    Views views;
  };

  Layouts(const Kind& kind, const Cloud& cloud)
  {
    const auto count = static_cast<std::int64_t>(cloud.size());
    const bool isPlane = kind.dimension == 2;
    const auto each = static_cast<std::size_t>(kind.dimension);
    Cloud flat = cloud;
    Cloud heights = cloud;
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
      flat[i][2] = isPlane ? 0 : cloud[i][2];
      heights[i][0] = heights[i][1] = 0;
    }
    const bool floatPoints = isFloat(flat);
    for (const Point& p : floatPoints ? cloud : Cloud())
    {
      // Nobody may look at z in the plane: there is none.
      this->Points.insert(this->Points.end(), p.begin(), p.begin() + kind.dimension);
    }
    std::vector<WeightView> weights = { weightsOf(cloud) };
    if (isPlane && isFloat(heights))
    {
      for (const Point& p : cloud)
      {
        this->Weights.push_back(static_cast<float>(p[2]));
      }
      weights.emplace_back(this->Weights.data(), count);
    }
    if (isPlane && flat == cloud)
    {
      weights.emplace_back();
    }
    for (const WeightView& of : weights)
    {
      const std::string kindOfWeights = !isPlane ? ""
        : !of.data                               ? ", no weights"
        : of.type == ScalarType::Float32         ? ", float weights"
                                                 : ", double weights";
      this->All.push_back({ "double points" + kindOfWeights, { viewOf(cloud), of } });
      if (floatPoints)
      {
        const PointView floats(this->Points.data(), count, static_cast<std::int64_t>(each));
        this->All.push_back({ "float points" + kindOfWeights, { floats, of } });
      }
    }
  }

  const std::vector<Layout>& all() const { return this->All; }

private:
  std::vector<float> Points;
  std::vector<float> Weights;
  std::vector<Layout> All;
};

/// Sums of doubles: right to many digits of the extent in ordinary ranges.
void expectMeasures(const Cloud& cloud, const ReferenceHull& reference, const Hull& hull)
{
  double extent = 0;
  for (std::size_t axis = 0; axis < 3 && !cloud.empty(); ++axis)
  {
    const auto ends = std::minmax_element(cloud.begin(), cloud.end(),
      [axis](const Point& p, const Point& q) { return p[axis] < q[axis]; });
    extent = std::max(extent, (*ends.second)[axis] - (*ends.first)[axis]);
  }
  const Measures wanted = measure(cloud, reference);
  if (extent > 1e-90 && extent < 1e90)
  {
    EXPECT_NEAR(
      hull.volume, wanted.volume, 1e-9 * wanted.volume + 1e-14 * extent * extent * extent);
    EXPECT_NEAR(hull.area, wanted.area, 1e-9 * wanted.area + 1e-14 * extent * extent);
  }
  for (const auto& [found, expected] :
    { std::pair{ hull.volume, wanted.volume }, std::pair{ hull.area, wanted.area } })
  {
    EXPECT_GE(found, 0);
    EXPECT_TRUE(!std::isinf(expected) || found == expected) << found;
  }
}

/// All runs with one mode of facets. @param first the first of them
void expectRuns(const Kind& kind, const Cloud& cloud, const Layouts& layouts,
  const ReferenceHull& reference, FacetMode facets, Result& first)
{
  const auto count = static_cast<std::int64_t>(cloud.size());
  Options options;
  options.facets = facets;
  bool isFirst = true;
  for (const int threads : threadsTried())
  {
    for (const bool vBiased : { false, true })
    {
      for (const Layouts::Layout& layout : layouts.all())
      {
        // All types in one plain run each, V-biased with one thread and with four; all together
        // for small clouds.
        const bool isNative = &layout == &layouts.all().front();
        const bool isPlain = threads == 1 && !vBiased;
        const bool isOdd = !isNative || (threads != 1 && vBiased != (threads == 4));
        if (!isPlain && isOdd && count > 40)
        {
          continue;
        }
        options.threads = threads;
        options.vBiased = vBiased;
        const PointsPerThread perThread(vBiased ? 3 * threads : threads);
        SCOPED_TRACE(std::to_string(threads) + " threads, " + (vBiased ? "V-biased, " : "") +
          layout.name + (facets == FacetMode::Polygons ? ", polygons" : ", triangles"));
        Result found;
        ASSERT_NO_THROW(found = kind.runOn(layout.views, options));
        ASSERT_EQ(difference(found, reference, facets, count), "");
        ASSERT_EQ(statisticsFault(found, count), "");
        // Hulls of few points take one thread.
        EXPECT_TRUE(kind.dimension == 3 ||
          complexOf(found).statistics.threads == threadCount(threads, count));
        if (isFirst)
        {
          isFirst = false;
          first = std::move(found);
        }
        else
        {
          ASSERT_EQ(bitDifference(found, first), "");
        }
        if (isPlain)
        {
          const Validation valid = validate(layout.views, first, isNative ? 2 : 1);
          ASSERT_TRUE(valid) << describe(valid.fault) << ", index " << valid.index;
        }
      }
    }
  }
  for (const RoundsVariant& variant : roundsVariants(count, facets))
  {
    options.threads = 1;
    options.vBiased = variant.vBiased;
    const Layouts::Layout& layout = variant.vBiased ? layouts.all().back() : layouts.all().front();
    SCOPED_TRACE("rounds " + variant.how.toString() + (variant.vBiased ? ", V-biased, " : ", ") +
      layout.name + (facets == FacetMode::Polygons ? ", polygons" : ", triangles"));
    Result found;
    ASSERT_NO_THROW(found = kind.runRounds(layout.views, options, variant.how));
    ASSERT_EQ(bitDifference(found, first), "");
    ASSERT_EQ(statisticsFault(found, count), "");
  }
}

}

void Kind::expect(const Cloud& cloud, const ReferenceHull& reference) const
{
  const Layouts layouts(*this, cloud);
  Result triangles;
  Result polygons;
  ASSERT_NO_FATAL_FAILURE(
    expectRuns(*this, cloud, layouts, reference, FacetMode::Triangles, triangles));
  ASSERT_NO_FATAL_FAILURE(
    expectRuns(*this, cloud, layouts, reference, FacetMode::Polygons, polygons));
  for (const Result* result : { &triangles, &polygons })
  {
    if (const auto* hull = std::get_if<Hull>(result))
    {
      expectMeasures(cloud, reference, *hull);
    }
  }
  // Whoever has polygons has the triangles.
  std::visit([](CellComplex& complex) { fanPolygons(complex); }, polygons);
  EXPECT_EQ(bitDifference(polygons, triangles), "");
}

std::string quickFault(
  const Kind& kind, const Cloud& cloud, const ReferenceHull& reference, const Options& options)
{
  try
  {
    const Result found = kind.run(cloud, options);
    const std::string fault =
      difference(found, reference, options.facets, static_cast<std::int64_t>(cloud.size()));
    if (!fault.empty())
    {
      return fault;
    }
    HostOrder how;
    if (drawOrder(cloud, how))
    {
      const std::string between =
        bitDifference(kind.runRounds(viewsOf(cloud), options, how), found);
      if (!between.empty())
      {
        return "rounds " + how.toString() + ": " + between;
      }
    }
    const Validation valid = validate(cloud, found, 1);
    return valid ? "" : std::string("validate: ") + describe(valid.fault);
  }
  catch (const Error& error)
  {
    return std::string("threw: ") + error.what();
  }
}

std::vector<FamilyOf> familiesOf(const Kind& kind, const std::vector<int>& counts)
{
  std::vector<const char*> names;
  for (const Family& family : kind.families())
  {
    names.push_back(family.name);
  }
  return familiesOf(kind, names, counts);
}

std::vector<FamilyOf> familiesOf(
  const Kind& kind, const std::vector<const char*>& names, const std::vector<int>& counts)
{
  std::vector<FamilyOf> all;
  for (const char* name : names)
  {
    for (int count : counts)
    {
      all.push_back({ &kind, name, count });
    }
  }
  return all;
}

std::vector<InputOf> inputsOf(const Kind& kind, const std::vector<Input>& inputs)
{
  std::vector<InputOf> all;
  for (const Input& input : inputs)
  {
    all.push_back({ &kind, input });
  }
  return all;
}

}
}
