// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Simulation of Simplicity on lifted points, against what it simulates: heights moved by powers of
// a small number, places by much smaller ones. And a set of points so moved has one upper hull.
#include "Testing/Engine/Predicates/LiftedCases.h"

#include <gtest/gtest.h>

#include <map>

using namespace flipflop;
using namespace flipflop::test;

namespace
{

constexpr unsigned Seed = 20260501;

using Points = std::vector<Vertex>;

/// e^(2^entry), e = 2^-40: for coordinates of a few bits the first term that does not vanish
/// outweighs all later ones.
mpq_class smallNumber(int entry)
{
  return mpq_class(1, mpz_class(1) << (40u << entry));
}

/// The lift of a point, its height moved by entry 0 to 3 by rank, its place by entries 4 to 11. The
/// virtual vertex is straight down, and not moved.
Row4 movedLift(const Vertex& v, int rank)
{
  if (v.flags & VertexVirtual)
  {
    return { 0, 0, -1, 0 };
  }
  Row4 row = rowOf(v);
  row[2] -= row[0] * row[0] + row[1] * row[1];
  row[2] += smallNumber(rank);
  row[0] += smallNumber(4 + 2 * rank);
  row[1] += smallNumber(5 + 2 * rank);
  return row;
}

/// Where the order of heights does not come in, the places' entries start at 0.
Row4 movedPlace(const Vertex& v, int rank)
{
  if (v.flags & VertexVirtual)
  {
    return { 0, 0, -1, 0 };
  }
  Row4 row = rowOf(v);
  row[0] += smallNumber(2 * rank);
  row[1] += smallNumber(1 + 2 * rank);
  row[2] = 0;
  return row;
}

enum Layout
{
  Anywhere,
  OnALine,
  AtOnePlace,
  Identical,
  LayoutCount
};

/// Tiny integers, with ids in any order.
Points tinyPoints(std::mt19937_64& random, int count, Layout layout, bool weighted, int limit = 3)
{
  std::vector<std::uint32_t> ids;
  for (int i = 0; i < count; ++i)
  {
    ids.push_back(static_cast<std::uint32_t>(10 * i + below(random, 10)));
  }
  std::shuffle(ids.begin(), ids.end(), random);
  const int dx = below(random, 3), dy = dx ? below(random, 3) : 1;
  const int weight = below(random, 3);
  Points v;
  for (const std::uint32_t id : ids)
  {
    const int t = layout == OnALine ? below(random, limit) : 1;
    const bool fixed = layout != Anywhere;
    v.push_back(
      makeVertex(fixed ? t * dx : below(random, limit), fixed ? t * dy : below(random, limit),
        layout == Identical ? weight : below(random, limit), id));
    v.back().x[2] = weighted ? v.back().x[2] : 0.0;
  }
  return v;
}

int rankIn(const Points& v, const Vertex& p)
{
  return static_cast<int>(
    std::count_if(v.begin(), v.end(), [&p](const Vertex& other) { return other.id < p.id; }));
}

/// Sign of det[b - a; c - a; p - a], moved.
int movedAbove(const Points& v)
{
  Row4 row[4];
  for (std::size_t k = 0; k < 4; ++k)
  {
    row[k] = movedLift(v[k], rankIn(v, v[k]));
  }
  return -sgn(det4<mpq_class>(row[0], row[1], row[2], row[3]));
}

template <bool Weighted>
void checkAbove(unsigned seed, int count)
{
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  int degenerate = 0;
  int flat = 0;
  for (int i = 0; i < count; ++i)
  {
    Points v = tinyPoints(random, 4, static_cast<Layout>(i % LayoutCount), Weighted);
    const LiftedGeometry<Weighted> geometry =
      liftedGeometryOf<Weighted>(v, { 0, random() % 2 != 0 });
    for (int place = 0; place < 5; ++place)
    {
      // The virtual vertex in one of the places, then nowhere.
      Points four = v;
      if (place < 4)
      {
        four[static_cast<std::size_t>(place)] = virtualVertex();
      }
      const int wanted = movedAbove(four);
      ASSERT_NE(wanted, 0);
      const auto perturbed = [&](int a, int b, int c, int p)
      {
        const auto at = [&four](int k) -> const Vertex&
        { return four[static_cast<std::size_t>(k)]; };
        return geometry.perturbedAbove(at(a), at(b), at(c), at(p));
      };
      ASSERT_EQ(perturbed(0, 1, 2, 3), wanted) << "case " << i << ", virtual " << place;
      ASSERT_EQ(perturbed(2, 1, 0, 3), -wanted) << "case " << i << ", virtual " << place;
      ASSERT_EQ(perturbed(2, 3, 0, 1), wanted) << "case " << i << ", virtual " << place;
      ASSERT_EQ(perturbed(3, 1, 2, 0), -wanted) << "case " << i << ", virtual " << place;
    }
    degenerate += geometry.above(v[0], v[1], v[2], v[3]) == 0 ? 1 : 0;
    flat += geometry.orient(v[0], v[1], v[2]) == 0 && geometry.orient(v[1], v[2], v[3]) == 0;
  }
  EXPECT_GT(degenerate, count / 2);
  EXPECT_GT(flat, count / 2);
}

/// Of three points, or two and the virtual vertex, whose kernel point s is not moved.
int movedBeneath(const Points& v, const Row4& s)
{
  Row4 row[3];
  bool isVirtual = false;
  for (std::size_t k = 0; k < 3; ++k)
  {
    row[k] = movedPlace(v[k], rankIn(v, v[k]));
    isVirtual = isVirtual || (v[k].flags & VertexVirtual);
  }
  const Row4 down = { 0, 0, -1, 0 };
  return sgn(det4<mpq_class>(row[0], row[1], row[2], isVirtual ? s : down));
}

template <bool Weighted>
void checkBeneath(unsigned seed, int count)
{
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  int ties = 0;
  for (int i = 0; i < count; ++i)
  {
    Points v = tinyPoints(random, 3, static_cast<Layout>(i % LayoutCount), Weighted);
    LiftedGeometry<Weighted> geometry = liftedGeometryOf<Weighted>(v);
    const Points corner = tinyPoints(random, 4, Anywhere, Weighted);
    Row4 s = rowOf(corner[0]);
    if (i % 3)
    {
      geometry.setKernel(corner[0].x);
    }
    else
    {
      geometry.setSymbolicKernel(corner.data());
      for (int k = 1; k < 4; ++k)
      {
        for (std::size_t axis = 0; axis < 4; ++axis)
        {
          s[axis] += rowOf(corner[static_cast<std::size_t>(k)])[axis];
        }
      }
    }
    s[2] = 0;
    for (int place = 0; place < 4; ++place)
    {
      Points three = v;
      if (place < 3)
      {
        three[static_cast<std::size_t>(place)] = virtualVertex();
      }
      const int wanted = movedBeneath(three, s);
      ASSERT_NE(wanted, 0);
      ASSERT_EQ(geometry.perturbedKernelBeneath(three[0], three[1], three[2]), wanted)
        << "case " << i << ", virtual " << place;
      ASSERT_EQ(geometry.perturbedKernelBeneath(three[1], three[0], three[2]), -wanted)
        << "case " << i << ", virtual " << place;
      ASSERT_EQ(geometry.perturbedKernelBeneath(three[1], three[2], three[0]), wanted)
        << "case " << i << ", virtual " << place;
      ties += geometry.kernelBeneath(three[0], three[1], three[2]) == 0 ? 1 : 0;
    }
  }
  EXPECT_GT(ties, count);
}

/// All triangles with nothing above them, each once.
template <bool Weighted>
std::vector<std::array<int, 3>> perturbedHull(
  const LiftedGeometry<Weighted>& geometry, const Points& v)
{
  const int count = static_cast<int>(v.size());
  const auto at = [&v](int k) -> const Vertex& { return v[static_cast<std::size_t>(k)]; };
  std::vector<std::array<int, 3>> result;
  for (int a = 0; a < count; ++a)
  {
    for (int b = a + 1; b < count; ++b)
    {
      for (int c = b + 1; c < count; ++c)
      {
        int seen[2] = { 0, 0 };
        for (int p = 0; p < count; ++p)
        {
          if (p != a && p != b && p != c)
          {
            ++seen[geometry.perturbedAbove(at(a), at(b), at(c), at(p)) > 0];
          }
        }
        if (seen[1] == 0)
        {
          result.push_back({ a, b, c });
        }
        if (seen[0] == 0)
        {
          result.push_back({ a, c, b });
        }
      }
    }
  }
  return result;
}

template <bool Weighted>
void checkHulls(unsigned seed, int count)
{
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  int hidden = 0;
  for (int i = 0; i < count; ++i)
  {
    const int n = 3 + below(random, 6);
    Points v = tinyPoints(random, n, static_cast<Layout>(i % LayoutCount), Weighted);
    LiftedGeometry<Weighted> geometry = liftedGeometryOf<Weighted>(v);
    v.push_back(virtualVertex());
    const auto hull = perturbedHull<Weighted>(geometry, v);

    std::map<std::pair<int, int>, int> edges;
    std::map<int, int> vertices;
    int virtualTriangles = 0;
    for (const std::array<int, 3>& t : hull)
    {
      int turn = 1;
      for (std::size_t k = 0; k < 3; ++k)
      {
        ++edges[{ t[k], t[(k + 1) % 3] }];
        ++vertices[t[k]];
        turn = t[k] == n ? 0 : turn;
      }
      if (turn)
      {
        // Triangles of points are counter-clockwise.
        const auto at = [&v](int k) -> const Vertex& { return v[static_cast<std::size_t>(k)]; };
        ASSERT_GT(geometry.perturbedKernelBeneath(at(t[0]), at(t[1]), at(t[2])), 0);
      }
      virtualTriangles += turn ? 0 : 1;
    }
    for (const auto& edge : edges)
    {
      const auto twin = edges.find({ edge.first.second, edge.first.first });
      ASSERT_EQ(edge.second, 1) << "case " << i;
      ASSERT_TRUE(twin != edges.end()) << "case " << i;
    }
    // One sphere.
    ASSERT_EQ(vertices.size() + hull.size(), edges.size() / 2 + 2) << "case " << i;
    ASSERT_GE(virtualTriangles, 3) << "case " << i;
    hidden += static_cast<int>(v.size() - vertices.size());
  }
  EXPECT_GT(hidden, 0);
}

/// Far beyond expansions, decided in wide integers, and by the same rules.
template <bool Weighted>
void checkWide(unsigned seed)
{
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  for (int i = 0; i < 1000; ++i)
  {
    Points v = tinyPoints(random, 4, static_cast<Layout>(i % LayoutCount), Weighted);
    Points far = v;
    far.push_back(makeVertex(1e300, 1e-300, 0, 99));
    bool wide = false;
    LiftedGeometry<Weighted> geometry = liftedGeometryOf<Weighted>(v);
    LiftedGeometry<Weighted> wideGeometry = liftedGeometryOf<Weighted>(far, {}, &wide);
    ASSERT_TRUE(wide);
    const Points corner = tinyPoints(random, 4, Anywhere, Weighted);
    geometry.setSymbolicKernel(corner.data());
    wideGeometry.setSymbolicKernel(corner.data());
    ASSERT_EQ(geometry.perturbedAbove(v[0], v[1], v[2], v[3]),
      wideGeometry.perturbedAbove(v[0], v[1], v[2], v[3]));
    ASSERT_EQ(geometry.perturbedKernelBeneath(v[0], v[1], v[2]),
      wideGeometry.perturbedKernelBeneath(v[0], v[1], v[2]));
    const Vertex down = virtualVertex();
    ASSERT_EQ(geometry.perturbedAbove(v[0], down, v[2], v[3]),
      wideGeometry.perturbedAbove(v[0], down, v[2], v[3]));
    ASSERT_EQ(geometry.perturbedKernelBeneath(v[0], v[1], down),
      wideGeometry.perturbedKernelBeneath(v[0], v[1], down));
  }
}

}

TEST(LiftedPerturbation, AboveIsTheSignOfTheMovedPoints)
{
  checkAbove<true>(Seed, 500);
  checkAbove<false>(Seed + 1, 300);
}

TEST(LiftedPerturbation, TheKernelIsNotMoved)
{
  checkBeneath<true>(Seed + 2, 1500);
  checkBeneath<false>(Seed + 3, 500);
}

TEST(LiftedPerturbation, MovedPointsHaveOneUpperHull)
{
  checkHulls<true>(Seed + 4, 3000);
  checkHulls<false>(Seed + 5, 1500);
}

TEST(LiftedPerturbation, WideIntegersFollowTheSameRules)
{
  checkWide<true>(Seed + 6);
  checkWide<false>(Seed + 7);
}
