// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Hulls by parts of 1 to 100 points: after the last merge, the mesh is closed, each twin's twin is
/// the half-edge, every edge is convex by perturbed signs, the kernel point sees every triangle,
/// and, of up to a thousand, no point is above. The finish does not look at all of that, so a right
/// result is no proof.
#include "FlipFlop/Part.h"
#include "FlipFlop/PartsBuilder.h"
#include "Geometry/HullStart.h"
#include "Points/Samples.h"
#include "Run/HullRun.h"
#include "Support/Threads.h"
#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/Conformance/RandomCases.h"
#include "Testing/Engine/Inputs/InputsInUse.h"

#include <algorithm>
#include <string>
#include <vector>

namespace flipflop
{
namespace test
{

namespace
{

/// What HullRun does until a builder is called.
class PartsRunner : public HullRun
{
public:
  using HullRun::HullRun;

  /// @return what is wrong with the hull of all points; empty: nothing, or there are no parts
  std::string fault(bool& anyParts)
  {
    Hull hull;
    if (!this->inspect(hull))
    {
      return "no finite point";
    }
    const Samples samples = nestedSamples(this->source.count());
    const Span span =
      findSpan(this->geometry, this->source, samples, 3, this->checkFinite, this->monitor);
    if (span.dimension < 3)
    {
      return "";
    }
    const Polyhedron start = startingTetrahedron(this->geometry, this->source, span.ids);
    anyParts = partsPay(this->geometry, this->source.count());
    if (!anyParts)
    {
      return "";
    }
    PointSubset all;
    all.count = this->source.count();
    Tally tally;
    const auto task = this->task(samples);
    Polyhedron whole = hullByParts(task, all, start.pointIds(),
      octahedralMapOf(this->geometry, start), 0, 1, this->out, tally, hull.statistics);
    anyParts = whole.vertexCount() > 0;
    return anyParts ? this->faultOf(whole) : "";
  }

private:
  std::string faultOf(Polyhedron& whole) const
  {
    const Mesh mesh = whole.mesh();
    const auto vertex = [&](std::uint32_t v) { return mesh.vertices[v]; };
    std::string result;
    std::int64_t triangles = 0;
    std::vector<std::uint32_t> touched(whole.vertexCount());
    for (const Piece& piece : whole.pieces)
    {
      for (std::uint32_t t = piece.begin; t < piece.end; ++t)
      {
        if (mesh.isDead(t))
        {
          continue;
        }
        ++triangles;
        const std::uint32_t* const v = mesh.triangles[t].v;
        if (this->geometry.perturbedKernelBeneath(vertex(v[0]), vertex(v[1]), vertex(v[2])) <= 0)
        {
          result = "not star-shaped";
        }
        for (int e = 0; e < 3; ++e)
        {
          touched[v[e]] = 1;
          const std::uint32_t h = halfEdge(t, e);
          const std::uint32_t g = mesh.twin(h);
          if (mesh.isDead(triangleOf(g)) || mesh.twin(g) != h ||
            mesh.origin(g) != mesh.origin(nextHalfEdge(h)))
          {
            return "a twin is wrong";
          }
          if (this->geometry.perturbedAbove(vertex(v[0]), vertex(v[1]), vertex(v[2]),
                vertex(mesh.origin(previousHalfEdge(g)))) > 0)
          {
            result = "a reflex edge";
          }
        }
      }
    }
    constexpr std::uint32_t Few = 1000; // each of their planes is compared with each point
    if (whole.vertexCount() <= Few && this->anyIsAbove(whole))
    {
      result = "a point is above";
    }
    std::int64_t vertices = 0;
    for (std::uint32_t v = 0; v < whole.vertexCount(); ++v)
    {
      const bool isAlive = (vertex(v).flags & VertexAlive) != 0;
      vertices += isAlive ? 1 : 0;
      if (isAlive != (touched[v] != 0))
      {
        result = "a vertex without triangles, or a dead one with some";
      }
    }
    return triangles != 2 * vertices - 4 ? "not closed" : result;
  }

  /// Is a point that is no vertex strictly outside? Those that parts left out may be.
  bool anyIsAbove(Polyhedron& whole) const
  {
    const Mesh mesh = whole.mesh();
    for (std::uint32_t v = 0; v < whole.vertexCount(); ++v)
    {
      const Vertex& p = mesh.vertices[v];
      if ((p.flags & VertexAlive) != 0 || v == VirtualSlot ||
        std::binary_search(this->out.begin(), this->out.end(), p.id))
      {
        continue;
      }
      for (const Piece& piece : whole.pieces)
      {
        for (std::uint32_t t = piece.begin; t < piece.end; ++t)
        {
          const std::uint32_t* const corner = mesh.triangles[t].v;
          if (!mesh.isDead(t) &&
            this->geometry.above(
              mesh.vertices[corner[0]], mesh.vertices[corner[1]], mesh.vertices[corner[2]], p) > 0)
          {
            return true;
          }
        }
      }
    }
    return false;
  }

  std::vector<std::uint32_t> out;
};

}

TEST(HullByParts, IsClosedAndConvex)
{
  int withParts = 0;
  int cases = 0;
  for (const char* name : { "shell0", "shell1e4", "shell1e2", "pancake", "ecef-tile", "knot",
         "cylinder", "helix", "twenty-turns", "cone", "paraboloid", "voxels", "far15", "boxFaces",
         "smallIntegers", "clustered", "doubled", "wall", "skewPlane" })
  {
    for (const int count : { 60, 400, 3000 })
    {
      for (const int perThread : { 1, 2, 3, 10, 50 })
      {
        for (std::uint64_t seed = 1; seed <= 6; ++seed)
        {
          const PointsPerThread parts(perThread);
          const Cloud cloud = makeCloud(name, false, count, seed);
          Options options;
          options.vBiased = seed % 2 == 0;
          PartsRunner run(viewOf(cloud), options);
          bool anyParts = false;
          ASSERT_EQ(run.fault(anyParts), "")
            << name << ", " << count << " points, seed " << seed << ", " << perThread;
          withParts += anyParts ? 1 : 0;
          ++cases;
        }
      }
    }
  }
  EXPECT_GT(withParts, cases / 2);
}

/// Small integers: most signs are ties, and many points are hidden.
TEST(HullByParts, IsClosedAndConvexAmongTies)
{
  const std::int64_t first = fromEnvironment("FLIPFLOP_TEST_SEED", 0);
  const std::int64_t count = fromEnvironment("FLIPFLOP_TEST_CASES", 2000);
  int withParts = 0;
  for (std::int64_t seed = first; seed < first + count; ++seed)
  {
    Random random(static_cast<std::uint64_t>(seed) + 1);
    const PointsPerThread parts(random.integer(1, 5));
    const int half = random.integer(1, 9);
    Cloud cloud;
    for (int i = random.integer(12, 300); i > 0; --i)
    {
      cloud.push_back({ double(random.integer(-half, half)), double(random.integer(-half, half)),
        double(random.integer(-half, half)) });
    }
    PartsRunner run(viewOf(cloud), Options());
    bool anyParts = false;
    ASSERT_EQ(run.fault(anyParts), "") << "seed " << seed << "\n" << toString(cloud);
    withParts += anyParts ? 1 : 0;
  }
  EXPECT_GT(withParts, count / 4);
}

/// Lines, planes, and few points, in many orders.
TEST(HullByParts, IsClosedAndConvexOnSpecialInputs)
{
  for (const Input& input : smallSpecialInputs())
  {
    Cloud cloud = input.make();
    for (int turn = 0; turn < 40 && cloud.size() > 4; ++turn)
    {
      for (const int perThread : { 1, 2, 4 })
      {
        const PointsPerThread parts(perThread);
        PartsRunner run(viewOf(cloud), Options());
        bool anyParts = false;
        std::string fault = "";
        EXPECT_NO_THROW(fault = run.fault(anyParts)) << input.name << "\n" << toString(cloud);
        EXPECT_EQ(fault, "") << input.name << "\n" << toString(cloud);
      }
      std::rotate(cloud.begin(), cloud.begin() + 1, cloud.end());
      if (turn % 3 == 0)
      {
        std::swap(cloud[0], cloud[cloud.size() / 2]);
      }
    }
  }
}

}
}
