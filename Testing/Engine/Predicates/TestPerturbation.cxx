// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Simulation of Simplicity against what it simulates: points really moved by powers of a small
// number, in space and lifted, in expansions and in wide integers.
#include "Testing/Engine/Predicates/LiftedCases.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace flipflop;
using namespace flipflop::test;

namespace
{

constexpr unsigned Seed = 20260201;

using Points = std::vector<Vertex>;

/// e^(2^entry), e = 2^-40: for coordinates of a few bits the first term that does not vanish
/// outweighs all later ones.
mpq_class smallNumber(int entry)
{
  return mpq_class(1, mpz_class(1) << (40u << entry));
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
Points tinyPoints(std::mt19937_64& random, int count, Layout layout, int limit = 3)
{
  std::vector<std::uint32_t> ids;
  for (int i = 0; i < count; ++i)
  {
    ids.push_back(static_cast<std::uint32_t>(10 * i + below(random, 10)));
  }
  std::shuffle(ids.begin(), ids.end(), random);
  const int dx = below(random, 3), dy = dx ? below(random, 3) : 1;
  const int z = below(random, 3);
  Points v;
  for (const std::uint32_t id : ids)
  {
    const int t = layout == OnALine ? below(random, limit) : 1;
    const bool fixed = layout != Anywhere;
    v.push_back(makeVertex(fixed ? t * dx : below(random, limit),
      fixed ? t * dy : below(random, limit), layout == Identical ? z : below(random, limit), id));
  }
  return v;
}

/// So far apart that signs are decided in wide integers.
const Vertex tooFar = makeVertex(1e300, 1e-300, 0, 99);

struct Space
{
  using Geometry = HullGeometry;
  static constexpr int VirtualPlaces = 0; ///< in which the virtual vertex may be

  static Geometry geometryOf(const Points& v, bool wide)
  {
    Points all = v;
    all.resize(v.size() + (wide ? 1 : 0), tooFar);
    Geometry geometry = test::geometryOf(all);
    EXPECT_EQ(geometry.isWide(), wide);
    return geometry;
  }
  /// Coordinate j is moved by entry 3 rank + j.
  static Row4 moved(const Vertex& v, int rank)
  {
    Row4 row = rowOf(v);
    for (int j = 0; j < 3; ++j)
    {
      row[static_cast<std::size_t>(j)] += smallNumber(3 * rank + j);
    }
    return row;
  }
  static Row4 movedPlace(const Vertex& v, int rank) { return moved(v, rank); }
  static Row4 kernelRow(const Row4& s, bool) { return s; }
};

template <bool Weighted>
struct Lifts
{
  using Geometry = LiftedGeometry<Weighted>;
  static constexpr int VirtualPlaces = 4;

  static Geometry geometryOf(Points& v, bool wide)
  {
    for (Vertex& p : v)
    {
      p.x[2] = Weighted ? p.x[2] : 0.0;
    }
    Points all = v;
    all.resize(v.size() + (wide ? 1 : 0), tooFar);
    bool isWide = false;
    Geometry geometry = liftedGeometryOf<Weighted>(all, {}, &isWide);
    EXPECT_EQ(isWide, wide);
    return geometry;
  }
  /// The height is moved by entry 0 to 3 by rank, the place by entries 4 to 11. The virtual vertex
  /// is straight down, and not moved.
  static Row4 moved(const Vertex& v, int rank)
  {
    Row4 row = movedFrom(v, 4 + 2 * rank);
    if (row[3] != 0)
    {
      row[2] = rowOf(v)[2] - rowOf(v)[0] * rowOf(v)[0] - rowOf(v)[1] * rowOf(v)[1];
      row[2] += smallNumber(rank);
    }
    return row;
  }
  /// Where the order of heights does not come in, the places' entries start at 0.
  static Row4 movedPlace(const Vertex& v, int rank) { return movedFrom(v, 2 * rank); }
  /// Straight down, too, but above the virtual vertex.
  static Row4 kernelRow(const Row4& s, bool isVirtual)
  {
    return isVirtual ? Row4{ s[0], s[1], 0, s[3] } : Row4{ 0, 0, -1, 0 };
  }

private:
  static Row4 movedFrom(const Vertex& v, int entry)
  {
    if (v.flags & VertexVirtual)
    {
      return { 0, 0, -1, 0 };
    }
    Row4 row = rowOf(v);
    row[0] += smallNumber(entry);
    row[1] += smallNumber(entry + 1);
    row[2] = 0;
    return row;
  }
};

int rankIn(const Points& v, const Vertex& p)
{
  return static_cast<int>(
    std::count_if(v.begin(), v.end(), [&p](const Vertex& other) { return other.id < p.id; }));
}

template <class Of>
class Perturbation : public ::testing::Test
{
};
using Spaces = ::testing::Types<Space, Lifts<true>, Lifts<false>>;
TYPED_TEST_SUITE(Perturbation, Spaces);

TYPED_TEST(Perturbation, AboveIsTheSignOfTheMovedPoints)
{
  SCOPED_TRACE(Seed);
  std::mt19937_64 random(Seed);
  int degenerate = 0;
  for (int i = 0; i < 500; ++i)
  {
    Points v = tinyPoints(random, 4, static_cast<Layout>(i % LayoutCount), 1 + i % 3);
    const auto geometry = TypeParam::geometryOf(v, i % 5 == 0);
    for (int place = 0; place <= TypeParam::VirtualPlaces; ++place)
    {
      // The virtual vertex in one of the places, then nowhere.
      Points four = v;
      if (place < TypeParam::VirtualPlaces)
      {
        four[static_cast<std::size_t>(place)] = virtualVertex();
      }
      Row4 row[4];
      for (std::size_t k = 0; k < 4; ++k)
      {
        row[k] = TypeParam::moved(four[k], rankIn(four, four[k]));
      }
      const int wanted = -sgn(det4<mpq_class>(row[0], row[1], row[2], row[3]));
      ASSERT_NE(wanted, 0);
      const auto perturbed = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t p)
      { return geometry.perturbedAbove(four[a], four[b], four[c], four[p]); };
      ASSERT_EQ(perturbed(0, 1, 2, 3), wanted) << "case " << i << ", virtual " << place;
      ASSERT_EQ(perturbed(2, 1, 0, 3), -wanted) << "case " << i << ", virtual " << place;
      ASSERT_EQ(perturbed(2, 3, 0, 1), wanted) << "case " << i << ", virtual " << place;
      ASSERT_EQ(perturbed(3, 1, 2, 0), -wanted) << "case " << i << ", virtual " << place;
    }
    degenerate += geometry.above(v[0], v[1], v[2], v[3]) == 0 ? 1 : 0;
  }
  EXPECT_GT(degenerate, 250);
}

/// Neither given as a point, nor as the centroid of four.
TYPED_TEST(Perturbation, TheKernelIsNotMoved)
{
  SCOPED_TRACE(Seed + 1);
  std::mt19937_64 random(Seed + 1);
  int ties = 0;
  for (int i = 0; i < 1500; ++i)
  {
    Points v = tinyPoints(random, 3, static_cast<Layout>(i % LayoutCount), 1 + i % 3);
    auto geometry = TypeParam::geometryOf(v, i % 5 == 0);
    const Points corner = tinyPoints(random, 4, Anywhere);
    Row4 s = rowOf(corner[0]);
    if (i % 3)
    {
      geometry.setKernel(corner[0].x);
    }
    else
    {
      geometry.setSymbolicKernel(corner.data());
      for (std::size_t k = 1; k < 4; ++k)
      {
        for (std::size_t axis = 0; axis < 4; ++axis)
        {
          s[axis] += rowOf(corner[k])[axis];
        }
      }
    }
    const int places = std::min(TypeParam::VirtualPlaces, 3);
    for (int place = 0; place <= places; ++place)
    {
      Points three = v;
      if (place < places)
      {
        three[static_cast<std::size_t>(place)] = virtualVertex();
      }
      Row4 row[3];
      for (std::size_t k = 0; k < 3; ++k)
      {
        row[k] = TypeParam::movedPlace(three[k], rankIn(three, three[k]));
      }
      const int wanted =
        sgn(det4<mpq_class>(row[0], row[1], row[2], TypeParam::kernelRow(s, place < places)));
      ASSERT_NE(wanted, 0);
      const auto perturbed = [&](std::size_t a, std::size_t b, std::size_t c)
      { return geometry.perturbedKernelBeneath(three[a], three[b], three[c]); };
      ASSERT_EQ(perturbed(0, 1, 2), wanted) << "case " << i << ", virtual " << place;
      ASSERT_EQ(perturbed(1, 0, 2), -wanted) << "case " << i << ", virtual " << place;
      ASSERT_EQ(perturbed(1, 2, 0), wanted) << "case " << i << ", virtual " << place;
      ties += geometry.kernelBeneath(three[0], three[1], three[2]) == 0 ? 1 : 0;
    }
  }
  EXPECT_GT(ties, 500);
}

}
