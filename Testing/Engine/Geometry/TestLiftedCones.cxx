// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// The test prepared for one cone keeps what it promises: heights are off by less than their bounds
// wherever a point of the cone may be. Bounds that are too small are wrong results, so the points
// are moved about to come as close to them as they can.
#include "Geometry/LiftedCones.h"
#include "Testing/Engine/Predicates/LiftedCases.h"

#include <gtest/gtest.h>

#include <array>
#include <iostream>

using namespace flipflop;
using namespace flipflop::test;

namespace
{

constexpr unsigned Seed = 20260401;

enum Kind
{
  Plain,
  Thin,      ///< almost flat triangles
  FarAway,   ///< at 1e8
  Small,     ///< of size 1e-8
  Mixed,     ///< every coordinate of a size of its own
  Stretched, ///< narrow in one coordinate
  Decimals,  ///< on a grid of thousandths
  SmallGrid, ///< ties of all sorts
  Tiny,      ///< where products are about to underflow
  Great,     ///< where they are about to overflow, beside ordinary ones
  KindCount
};

/// The points of one test. Corner @ref virtualCorner of the three is the virtual vertex; then the
/// kernel point is inside the base triangle.
struct Scene
{
  std::array<Vertex, 8> v; ///< corners a, b, c; the apex; a point; the base triangle
  int virtualCorner = 3;   ///< 3: none
  bool symbolic = false;
  bool spread = false; ///< there are points far away
};

/// Largest error, as a share of the bound; and what was seen.
struct Ratios
{
  double plane = 0;
  int planes = 0;
  int unbounded = 0;

  void add(const Ratios& other)
  {
    this->plane = std::max(this->plane, other.plane);
    this->planes += other.planes;
    this->unbounded += other.unbounded;
  }
};

std::ostream& operator<<(std::ostream& out, const Ratios& r)
{
  return out << "largest error, as a share of its bound: planes " << r.plane << " of " << r.planes
             << ", without a bound " << r.unbounded;
}

double shareOf(double value, const mpq_class& exact, double bound)
{
  return mpq_class(abs(mpq_class(value) - exact) / mpq_class(bound)).get_d();
}

/// A place in a triangle off its middle.
void kernelIn(const Vertex* base, double* s)
{
  for (int i = 0; i < 2; ++i)
  {
    s[i] = 0.3718281828 * base[0].x[i] + 0.3414213562 * base[1].x[i] + 0.286750461 * base[2].x[i];
  }
}

template <bool Weighted>
class Prepared
{
public:
  using Geometry = LiftedGeometry<Weighted>;

  explicit Prepared(const Scene& scene)
    : points(scene.v.begin(), scene.v.begin() + (scene.virtualCorner < 3 ? 8 : 5))
    , range(pointsInRange(scene))
    , geometry(liftedGeometryOf<Weighted>(range))
    , exact(range)
  {
    // Scaled as the range is.
    const std::size_t count = this->points.size();
    std::copy(this->range.begin(), this->range.begin() + static_cast<std::ptrdiff_t>(count),
      this->points.begin());
    if (scene.virtualCorner < 3)
    {
      this->points[static_cast<std::size_t>(scene.virtualCorner)] = virtualVertex();
      this->setKernel(scene.symbolic);
    }
  }

  /// The checks for the cone of the corners; false when it holds not both the apex and the point.
  bool check(Ratios& ratios) const
  {
    const std::vector<Vertex>& v = this->points;
    if (!this->inCone(v[0], v[1], v[2], v[3]) || !this->inCone(v[0], v[1], v[2], v[4]))
    {
      return false;
    }
    this->checkPlane(v[3], ratios);
    this->checkPlane(v[4], ratios);
    return true;
  }

private:
  static std::vector<Vertex> pointsInRange(const Scene& scene)
  {
    // The virtual corner's place stands for no point: any other's will do.
    std::vector<Vertex> result(
      scene.v.begin(), scene.v.begin() + (scene.virtualCorner < 3 ? 8 : 5));
    if (scene.virtualCorner < 3)
    {
      result[static_cast<std::size_t>(scene.virtualCorner)] = scene.v[3];
    }
    if (scene.spread)
    {
      result.push_back(makeVertex(1, -1, Weighted ? 2 : 0, 8));
    }
    return result;
  }

  void setKernel(bool symbolic)
  {
    const Vertex* base = &this->points[5];
    double s[2];
    kernelIn(base, s);
    const Vertex place = makeVertex(s[0], s[1], 0, 9);
    this->exact.setKernel(s);
    const int turn = this->exact.orient(base[0], base[1], base[2]);
    bool inside = turn != 0;
    for (int i = 0; i < 3; ++i)
    {
      inside = inside && this->exact.orient(base[i], base[(i + 1) % 3], place) == turn;
    }
    if (inside && !symbolic)
    {
      this->geometry.setKernel(s);
      return;
    }
    const Vertex corners[4] = { base[0], base[1], base[2], base[0] };
    this->geometry.setSymbolicKernel(corners);
    this->exact.setSymbolicKernel(corners);
    this->kernelInside = turn != 0;
  }

  /// As the engine decides it, by perturbation: so cones may be flat, and points on their sides.
  bool inCone(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p) const
  {
    return this->kernelInside && this->isInside(a, b, c) && this->isInside(a, b, p) &&
      this->isInside(b, c, p) && this->isInside(c, a, p);
  }

  bool isInside(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    const bool inside = this->geometry.perturbedBeneathKernel(a, b, c) > 0;
    const int sign = this->exact.beneathKernel(a, b, c);
    EXPECT_TRUE(inside ? sign >= 0 : sign <= 0);
    return inside;
  }

  void checkPlane(const Vertex& p, Ratios& ratios) const
  {
    const std::vector<Vertex>& v = this->points;
    const LiftedPlane<Weighted> plane(this->geometry, v[0], v[1], v[2]);
    const mpq_class height = this->exact.height(v[0], v[1], v[2], p);
    expectHeight(
      plane.height(p.x), height, plane.error(), ratios.plane, ratios.planes, ratios.unbounded);
  }

  static void expectHeight(double height, const mpq_class& exact, double error, double& largest,
    int& count, int& unbounded)
  {
    ASSERT_FALSE(error <= 0) << "bounds are never tight";
    if (error <= std::numeric_limits<double>::max())
    {
      const double share = shareOf(height, exact, error);
      ASSERT_LT(share, 1.0);
      largest = std::max(largest, share);
      ++count;
      return;
    }
    ASSERT_EQ(error, HUGE_VAL);
    ++unbounded;
  }

  std::vector<Vertex> points;
  std::vector<Vertex> range;
  Geometry geometry;
  ExactLift exact;
  bool kernelInside = true;
};

double coordinate(std::mt19937_64& random, Kind kind, int axis)
{
  const double x = uniform(random);
  switch (kind)
  {
    case FarAway:
      return 1e8 + x * (random() % 2 ? 1 : 1e-6);
    case Small:
      return x * 1e-8;
    case Mixed:
      return std::ldexp(x, -below(random, 40));
    case Stretched:
      return axis == 0 ? x : 0.3 + x * 1e-7;
    case Decimals:
      return below(random, 2000) / 1000.0;
    case SmallGrid:
      return below(random, 4);
    case Tiny:
      return std::ldexp(x, -100 - below(random, 8));
    case Great:
      return std::ldexp(x, axis + below(random, 234));
    default:
      return x;
  }
}

/// A weight for a point: none in particular, large, or such that the point is about as high as the
/// weighted mean of others.
double weightOf(std::mt19937_64& random, double size, const Vertex& p, const Vertex* others,
  const double* share, int count)
{
  if (random() % 2)
  {
    const double factor[4] = { 0.0, 1.0, 1e4, 1e10 };
    return uniform(random) * size * size * factor[random() % 4];
  }
  double weight = p.x[0] * p.x[0] + p.x[1] * p.x[1];
  for (int i = 0; i < count; ++i)
  {
    const double* x = others[i].x;
    weight += share[i] * (x[2] - x[0] * x[0] - x[1] * x[1]);
  }
  return weight;
}

/// p of shares of the corners; some shares are zero.
Vertex mixture(std::mt19937_64& random, const Vertex* corners, std::uint32_t id, double size,
  bool weighted, double stretch = 1.0, const double* from = nullptr)
{
  double share[3];
  double sum = 0;
  for (double& s : share)
  {
    s = random() % 5 ? uniform(random) : 0.0;
    s = random() % 4 ? std::fabs(s) : s * s * s * s;
    sum += s;
  }
  Vertex p = makeVertex(0, 0, 0, id);
  for (int axis = 0; axis < 2; ++axis)
  {
    for (int i = 0; i < 3; ++i)
    {
      share[i] = sum > 0 ? share[i] : i == 0;
      p.x[axis] += share[i] / (sum > 0 ? sum : 1) * corners[i].x[axis];
    }
    if (from)
    {
      p.x[axis] = from[axis] + stretch * (p.x[axis] - from[axis]);
    }
    p.x[axis] = nudged(p.x[axis], random, 2);
  }
  for (double& s : share)
  {
    s /= sum > 0 ? sum : 1;
  }
  p.x[2] = weighted ? weightOf(random, size, p, corners, share, 3) : 0.0;
  return p;
}

Scene makeScene(std::mt19937_64& random, Kind kind, bool weighted, bool withVirtual)
{
  Scene scene;
  const double size = kind == Small ? 1e-8 : kind == Tiny ? 0x1p-104 : kind == Great ? 1e69 : 1.0;
  for (std::uint32_t i = 0; i < 8; ++i)
  {
    Vertex& v = scene.v[i];
    v = makeVertex(coordinate(random, kind, 0), coordinate(random, kind, 1), 0, i);
    v.x[2] = weighted ? weightOf(random, size, v, nullptr, nullptr, 0) : 0.0;
  }
  if (kind == Thin)
  {
    const Vertex line[3] = { scene.v[0], scene.v[1], scene.v[random() % 2] };
    scene.v[2] = mixture(random, line, 2, size, weighted);
  }
  if (kind == Tiny)
  {
    // With points far away, of sizes from where bounds hold to where they do not.
    const int limit[3] = { 40, 240, 970 };
    const int exponent = -below(random, limit[random() % 3]);
    for (Vertex& v : scene.v)
    {
      v.x[0] = std::ldexp(v.x[0], exponent);
      v.x[1] = std::ldexp(v.x[1], exponent);
      v.x[2] = std::ldexp(v.x[2], 2 * exponent);
    }
  }
  scene.spread = kind == Tiny || random() % 4 == 0;
  if (withVirtual)
  {
    scene.virtualCorner = below(random, 3);
    scene.symbolic = random() % 3 == 0;
    // Both points beyond the edge, seen from the middle of the base triangle.
    const Vertex* base = &scene.v[5];
    double s[2];
    kernelIn(base, s);
    Vertex& first = scene.v[static_cast<std::size_t>((scene.virtualCorner + 1) % 3)];
    Vertex& second = scene.v[static_cast<std::size_t>((scene.virtualCorner + 2) % 3)];
    const double turn =
      (first.x[0] - s[0]) * (second.x[1] - s[1]) - (first.x[1] - s[1]) * (second.x[0] - s[0]);
    if (turn > 0)
    {
      // Triangles are counter-clockwise, so the border's edges turned around are not.
      std::swap(first.x, second.x);
    }
    const Vertex edge[3] = { first, second, first };
    const double stretch[3] = { 1.0, 1 + std::fabs(uniform(random)), 30.0 };
    scene.v[3] = mixture(random, edge, 3, size, weighted, stretch[random() % 3], s);
    scene.v[4] = mixture(random, edge, 4, size, weighted, stretch[random() % 3], s);
    if (random() % 3 == 0)
    {
      // On the line from the kernel point through the apex, or next to it.
      if (scene.symbolic)
      {
        for (int i = 0; i < 2; ++i)
        {
          s[i] = 0.5 * base[0].x[i] + 0.25 * base[1].x[i] + 0.25 * base[2].x[i];
        }
      }
      const Vertex line[3] = { scene.v[3], scene.v[3], scene.v[3] };
      scene.v[4] = mixture(random, line, 4, size, weighted, stretch[random() % 3], s);
    }
    return scene;
  }
  const double turn = (scene.v[1].x[0] - scene.v[0].x[0]) * (scene.v[2].x[1] - scene.v[0].x[1]) -
    (scene.v[1].x[1] - scene.v[0].x[1]) * (scene.v[2].x[0] - scene.v[0].x[0]);
  if (turn < 0)
  {
    std::swap(scene.v[1].x, scene.v[2].x);
  }
  scene.v[3] = mixture(random, scene.v.data(), 3, size, weighted);
  if (random() % 4 == 0)
  {
    // On a line through the apex, or next to it.
    const Vertex line[3] = { scene.v[3], scene.v[random() % 3], scene.v[3] };
    scene.v[4] = mixture(random, line, 4, size, weighted);
  }
  else
  {
    scene.v[4] = mixture(random, scene.v.data(), 4, size, weighted);
  }
  return scene;
}

template <bool Weighted>
void checkRandom(bool withVirtual, unsigned seed, int count)
{
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  Ratios all;
  int valid = 0;
  for (int i = 0; i < count; ++i)
  {
    const Scene scene = makeScene(random, static_cast<Kind>(i % KindCount), Weighted, withVirtual);
    valid += Prepared<Weighted>(scene).check(all) ? 1 : 0;
    ASSERT_FALSE(testing::Test::HasFatalFailure()) << "case " << i;
  }
  std::cout << "seed " << seed << ": " << valid << " cones; " << all << '\n';
  EXPECT_GT(valid, count / 3);
  EXPECT_GT(all.planes, count / 4);
  EXPECT_GT(all.unbounded, 0);
}

/// Change a few coordinates: by a few units in the last place, or by much.
Scene mutated(const Scene& scene, std::mt19937_64& random)
{
  Scene result = scene;
  for (int k = 1 + below(random, 3); k > 0; --k)
  {
    Vertex& v = result.v[random() % (scene.virtualCorner < 3 ? 8 : 5)];
    double& x = v.x[random() % 3];
    if (x != 0)
    {
      const double step = std::ldexp(uniform(random), std::ilogb(x) - below(random, 54));
      x += step;
    }
  }
  return result;
}

/// Climb towards larger shares of the bound.
template <bool Weighted>
void climb(bool withVirtual, unsigned seed, int starts, int steps)
{
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  Ratios all;
  for (int start = 0; start < starts; ++start)
  {
    const auto kind = static_cast<Kind>(start % KindCount);
    Scene best = makeScene(random, kind, Weighted, withVirtual);
    double most = -1;
    for (int step = 0; step < steps; ++step)
    {
      const Scene next =
        most < 0 ? makeScene(random, kind, Weighted, withVirtual) : mutated(best, random);
      Ratios ratios;
      if (!Prepared<Weighted>(next).check(ratios))
      {
        continue;
      }
      ASSERT_FALSE(testing::Test::HasFatalFailure()) << "start " << start << ", step " << step;
      all.add(ratios);
      if (ratios.plane >= most)
      {
        most = ratios.plane;
        best = next;
      }
    }
  }
  std::cout << "seed " << seed << ": " << all << '\n';
  EXPECT_GT(all.plane, 0);
}

}

TEST(LiftedCones, ErrorsHold)
{
  checkRandom<true>(false, Seed, 9000);
  checkRandom<false>(false, Seed + 1, 9000);
}

TEST(LiftedCones, ErrorsHoldBeyondTheBorder)
{
  checkRandom<true>(true, Seed + 2, 9000);
  checkRandom<false>(true, Seed + 3, 9000);
}

TEST(LiftedCones, ErrorsHoldHoweverPointsAreMoved)
{
  climb<true>(false, Seed + 4, 40, 200);
  climb<false>(false, Seed + 5, 40, 200);
}

TEST(LiftedCones, ErrorsHoldHoweverPointsBeyondTheBorderAreMoved)
{
  climb<true>(true, Seed + 6, 40, 200);
  climb<false>(true, Seed + 7, 40, 200);
}
