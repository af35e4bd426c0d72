// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The plane by parts: how points are cut, and what the merged mesh is before the finish. Parts are
/// as small as they can be, where merges take all edges of a side, and of ordinary size.
#include "FlipFlop/PartTree.h"
#include "FlipFlop/PartsBuilder.h"
#include "FlipFlop/PlanePart.h"
#include "Run/TriangulationRun.h"
#include "Support/Threads.h"
#include "Testing/Engine/Conformance/CompareTriangulation.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"
#include <flipflop/Validate.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace flipflop
{
namespace test
{

namespace
{

/// The builder of the plane, with a look at what it makes: a closed, convex mesh. Without weights,
/// its triangles have area, and its flat edges are marked, and no others; with weights, it is
/// strictly convex by perturbed signs.
template <bool Weighted>
class WatchedBuilder : public PolyhedronBuilder<LiftedGeometry<Weighted>>
{
public:
  using Plane = LiftedGeometry<Weighted>;

  Polyhedron build(
    const BuildTask<Plane>& task, Polyhedron&& start, Tally& tally, Statistics& statistics) override
  {
    Polyhedron made = PartsBuilder<Weighted>::build(task, std::move(start), tally, statistics);
    const auto look = [&](auto& surface)
    {
      surface.eachTriangle([&, mesh = surface.mesh()](std::uint32_t t, std::size_t)
        { this->look(task.geometry, mesh, t); });
    };
    if constexpr (Weighted)
    {
      look(made);
    }
    else
    {
      look(*task.plane);
    }
    return made;
  }

private:
  void look(const Plane& shared, const PartMesh<Weighted>& mesh, std::uint32_t t)
  {
    const Plane geometry = shared; // counts its own signs
    const std::uint32_t* const v = mesh.triangles[t].v;
    bool isVirtual = false;
    for (int e = 0; e < 3; ++e)
    {
      const std::uint32_t h = halfEdge(t, e);
      const std::uint32_t twin = mesh.twin(h);
      ASSERT_EQ(mesh.twin(twin), h);
      ASSERT_FALSE(mesh.isDead(triangleOf(twin)));
      ASSERT_EQ(mesh.origin(twin), mesh.origin(nextHalfEdge(h)));
      ASSERT_TRUE(mesh.vertices[v[e]].flags & VertexAlive);
      isVirtual = isVirtual || (mesh.vertices[v[e]].flags & VertexVirtual);
    }
    const Vertex a = mesh.vertex(v[0]);
    const Vertex b = mesh.vertex(v[1]);
    const Vertex c = mesh.vertex(v[2]);
    if (!isVirtual)
    {
      ASSERT_GT(Weighted ? geometry.perturbedKernelBeneath(a, b, c) : geometry.orient(a, b, c), 0);
    }
    for (int e = 0; e < 3; ++e)
    {
      const std::uint32_t twin = mesh.twin(halfEdge(t, e));
      const Vertex d = mesh.vertex(mesh.origin(previousHalfEdge(twin)));
      const int sign = Weighted ? geometry.perturbedAbove(a, b, c, d) : geometry.above(a, b, c, d);
      ASSERT_LE(sign, 0);
      if (Weighted)
      {
        ASSERT_NE(sign, 0);
      }
      else if (!isVirtual && !(d.flags & VertexVirtual))
      {
        ASSERT_EQ(mesh.marks(t) >> e & 1, sign == 0 ? 1u : 0u);
      }
    }
  }
};

/// Triangulate, with the mesh looked at, by parts of @p points each at most.
template <bool Weighted>
Triangulation triangulateWatched(const Cloud& cloud, std::int64_t points, int threads)
{
  Options options;
  options.threads = threads;
  TriangulationRun<Weighted> run(
    viewOf(cloud), Weighted ? weightsOf(cloud) : WeightView(), options);
  WatchedBuilder<Weighted> engine;
  pointsPerThread() = (points + 1) / 2;
  Triangulation result = run.compute(engine);
  pointsPerThread() = 1;
  return result;
}

/// By one part, which is right, and by many: the same, and the same work on several threads.
template <bool Weighted>
void expectRight(const Cloud& cloud)
{
  const Triangulation one =
    triangulateWatched<Weighted>(cloud, static_cast<std::int64_t>(cloud.size()), 1);
  const Validation valid = validate(viewOf(cloud), Weighted ? weightsOf(cloud) : WeightView(), one);
  ASSERT_TRUE(valid) << describe(valid.fault) << ", index " << valid.index;
  for (const std::int64_t points : { 2, 4, 6, 10, 20, 200 })
  {
    EXPECT_EQ(bitDifference(triangulateWatched<Weighted>(cloud, points, 1), one), "")
      << "parts of " << points;
  }
  const Triangulation shared = triangulateWatched<Weighted>(cloud, 4, 3);
  EXPECT_EQ(bitDifference(shared, one), "");
  const Triangulation alone = triangulateWatched<Weighted>(cloud, 4, 1);
  Statistics::eachField(
    [&](const char* name, auto field)
    {
      if (name != std::strstr(name, "seconds"))
      {
        EXPECT_EQ(shared.statistics.*field, alone.statistics.*field) << name;
      }
    });
}

class PartsFamily : public ::testing::TestWithParam<const char*>
{
protected:
  template <bool Weighted>
  static void expectMerges()
  {
    for (int count = 3; count <= effort(400); count += 1 + count / 4)
    {
      for (std::uint64_t seed = 1; seed <= 3; ++seed)
      {
        SCOPED_TRACE("count " + std::to_string(count) + " seed " + std::to_string(seed));
        expectRight<Weighted>(fromWeightedFamily(GetParam(), count, seed).make());
      }
    }
  }

  template <bool Weighted>
  static void expectLargeMerges()
  {
    const Cloud cloud = fromWeightedFamily(GetParam(), effort(3000), 7).make();
    const Triangulation one =
      triangulateWatched<Weighted>(cloud, static_cast<std::int64_t>(cloud.size()), 1);
    EXPECT_EQ(bitDifference(triangulateWatched<Weighted>(cloud, 200, 4), one), "");
  }
};

TEST_P(PartsFamily, MergeToTheSameTriangulation)
{
  expectMerges<false>();
}

TEST_P(PartsFamily, MergeWithWeights)
{
  expectMerges<true>();
}

TEST_P(PartsFamily, OfOrdinarySizeMerge)
{
  expectLargeMerges<false>();
}

TEST_P(PartsFamily, OfOrdinarySizeMergeWithWeights)
{
  expectLargeMerges<true>();
}

std::vector<const char*> names()
{
  std::vector<const char*> all;
  for (const Family& family : weightedFamilies())
  {
    all.push_back(family.name);
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Parts, PartsFamily, ::testing::ValuesIn(names()),
  [](const auto& given) { return std::string(given.param); });

TEST(Parts, SmallIntegersMerge)
{
  // Ties everywhere: collinear parts, cocircular seams, duplicates, single points.
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(effort(600)); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const int side = random.integer(1, 9);
    const Cloud cloud = smallIntegerSites(random.integer(3, 60), 0, side, 0, 0, random);
    expectRight<false>(cloud);
  }
}

TEST(Parts, SmallIntegersMergeWithWeights)
{
  // Ties, and hidden vertices everywhere: whole sides of parts are.
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(effort(2000)); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const int side = random.integer(1, 12);
    const int weight = random.integer(0, 1) ? random.integer(0, 4) : random.integer(0, side * side);
    expectRight<true>(smallIntegerSites(random.integer(3, 60), 0, side, -weight, weight, random));
  }
}

TEST(Parts, FewVisiblePointsMerge)
{
  // Weights of all sizes, not in one place: few points hide many, also across the parts.
  for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(effort(2000)); ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const double heaviest = std::ldexp(1.0, random.integer(-9, 2));
    const int rare = random.integer(1, 20);
    Cloud cloud;
    for (int left = random.integer(3, 120); left > 0; --left)
    {
      const double x = random.uniform();
      const double y = random.uniform();
      const bool isHeavy = random.integer(1, rare) == 1;
      cloud.push_back({ x, y, (isHeavy ? heaviest : heaviest / 64) * random.uniform() });
    }
    expectRight<true>(cloud);
  }
}

TEST(Parts, TheLowestIdStandsForTheVertexThatAMergeHides)
{
  // In a part of ten, both of two duplicates are vertices, for others are at their place; the merge
  // hides that of the lower id.
  const Cloud cloud = { { 2, 3, -15 }, { 3, 3, 5 }, { 3, 0, -13 }, { 0, 3, -22 }, { 3, 0, -13 },
    { 0, 0, 21 }, { 4, 4, -28 }, { 1, 2, -28 }, { 1, 4, 20 }, { 3, 3, 19 }, { 1, 1, 19 },
    { 4, 2, 27 }, { 2, 3, -15 }, { 1, 1, 3 }, { 3, 3, 19 }, { 0, 4, -13 }, { 4, 3, -29 },
    { 1, 1, 3 }, { 0, 4, -13 }, { 1, 0, -31 }, { 2, 3, -4 }, { 3, 3, 5 }, { 3, 3, -17 },
    { 3, 3, 19 } };
  expectRight<true>(cloud);
}

/// What a node's halves are separated by, and what its parts hold.
class TreeLook
{
public:
  explicit TreeLook(const PartTree<PlaneVertex>& treeToLookAt, std::uint32_t mostPoints)
    : tree(treeToLookAt)
    , most(mostPoints)
  {
  }

  void look(std::uint32_t index)
  {
    const PartNode& node = this->tree.nodes[index];
    ASSERT_LT(node.begin, node.end);
    if (node.left == 0)
    {
      const PlaneVertex* const first = this->tree.vertices.begin() + node.begin;
      const bool onePosition = std::all_of(first, this->tree.vertices.begin() + node.end,
        [first](const PlaneVertex& p) { return p.x[0] == first->x[0] && p.x[1] == first->x[1]; });
      EXPECT_TRUE(onePosition || node.end - node.begin <= this->most);
      ++this->parts;
      return;
    }
    const PartNode& left = this->tree.nodes[node.left];
    const PartNode& right = this->tree.nodes[node.right];
    ASSERT_EQ(left.begin, node.begin);
    ASSERT_EQ(left.end, right.begin);
    ASSERT_EQ(right.end, node.end);
    bool separated = false;
    for (int axis = 0; axis < 2; ++axis)
    {
      separated = separated || this->high(left, axis) < this->low(right, axis) ||
        this->high(right, axis) < this->low(left, axis);
    }
    EXPECT_TRUE(separated);
    this->look(node.left);
    this->look(node.right);
  }

  int parts = 0;

private:
  double low(const PartNode& node, int axis) const
  {
    double least = this->tree.vertices[node.begin].x[axis];
    for (std::uint32_t i = node.begin; i < node.end; ++i)
    {
      least = std::min(least, this->tree.vertices[i].x[axis]);
    }
    return least;
  }
  double high(const PartNode& node, int axis) const
  {
    double most = this->tree.vertices[node.begin].x[axis];
    for (std::uint32_t i = node.begin; i < node.end; ++i)
    {
      most = std::max(most, this->tree.vertices[i].x[axis]);
    }
    return most;
  }

  const PartTree<PlaneVertex>& tree;
  const std::uint32_t most;
};

/// Points of a family, cut.
PartTree<PlaneVertex> cutFamily(const Cloud& cloud, std::uint32_t most)
{
  Options options;
  Monitor monitor(options);
  PointSubset subset;
  subset.count = static_cast<std::uint32_t>(cloud.size());
  CoordinateRange box{};
  for (int axis = 0; axis < 2; ++axis)
  {
    const auto ends = std::minmax_element(cloud.begin(), cloud.end(),
      [axis](const auto& p, const auto& q) { return p[axis] < q[axis]; });
    box.low[axis] = (*ends.first)[axis];
    box.high[axis] = (*ends.second)[axis];
  }
  return cutIntoParts<PlaneVertex>(
    PointSource(viewOf(cloud), WeightView()), subset, box, most, monitor);
}

TEST(PartTree, ALineSeparatesTheHalvesOfEachNode)
{
  for (const char* family :
    { "uniform", "grid", "clusters", "circle", "smallIntegers", "doubled", "lineAlongX" })
  {
    SCOPED_TRACE(family);
    const Cloud cloud = fromWeightedFamily(family, 3000, 7).make();
    for (const std::uint32_t most : { 1u, 3u, 50u, 5000u })
    {
      const PartTree<PlaneVertex> tree = cutFamily(cloud, most);
      std::vector<std::uint32_t> ids;
      for (std::size_t i = 1; i < tree.vertices.size(); ++i)
      {
        ids.push_back(tree.vertices[i].id);
      }
      std::sort(ids.begin(), ids.end());
      ASSERT_EQ(ids.size(), cloud.size());
      EXPECT_EQ(std::unique(ids.begin(), ids.end()), ids.end());
      TreeLook look(tree, most);
      look.look(0);
      EXPECT_EQ(look.parts == 1, most >= cloud.size());
    }
  }
}

TEST(PartTree, PartsAlongCurvesAreLarger)
{
  const auto largest = [](const char* family)
  {
    const PartTree<PlaneVertex> tree = cutFamily(fromWeightedFamily(family, 8000, 7).make(), 500);
    std::uint32_t most = 0;
    for (const PartNode& node : tree.nodes)
    {
      most = std::max(most, node.left == 0 ? node.end - node.begin : 0);
    }
    return most;
  };
  EXPECT_LE(largest("uniform"), 500u);
  EXPECT_LE(largest("grid"), 500u);
  EXPECT_GT(largest("circle"), 500u);
  EXPECT_LE(largest("circle"), 2000u);
}

}
}
}
