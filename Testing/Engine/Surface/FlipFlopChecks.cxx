// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Engine/Surface/FlipFlopChecks.h"

#include <map>
#include <stdexcept>

namespace flipflop
{
namespace test
{

namespace
{

using Edge = std::pair<int, int>;

/// A triangulated surface by its directed edges: which vertex lies opposite.
class FlipMesh
{
public:
  FlipMesh(const Surface& surface, const double* kernel)
    : Points(surface.points)
    , Kernel(static_cast<int>(surface.points.size()))
    , Space((this->Points.push_back({ kernel[0], kernel[1], kernel[2] }), this->Points))
  {
    for (const Corners& t : surface.triangles)
    {
      this->add(static_cast<int>(t[0]), static_cast<int>(t[1]), static_cast<int>(t[2]));
    }
  }

  void add(int a, int b, int c)
  {
    for (const auto& e : { std::array<int, 3>{ a, b, c }, { b, c, a }, { c, a, b } })
    {
      this->Opposite[{ e[0], e[1] }] = e[2];
    }
  }
  void remove(int a, int b, int c)
  {
    for (const Edge& e : { Edge{ a, b }, Edge{ b, c }, Edge{ c, a } })
    {
      this->Opposite.erase(e);
    }
  }

  std::vector<Edge> edges() const
  {
    std::vector<Edge> all;
    for (const auto& item : this->Opposite)
    {
      if (item.first.first < item.first.second)
      {
        all.push_back(item.first);
      }
    }
    return all;
  }

  bool has(int a, int b) const { return this->Opposite.count({ a, b }) > 0; }
  int opposite(int a, int b) const { return this->Opposite.at({ a, b }); }

  /// The kernel is strictly beneath a triangle abc, outward as all are.
  bool seen(int a, int b, int c) const { return this->Space.orient(a, b, c, this->Kernel) < 0; }

  bool reflex(int a, int b) const
  {
    return this->Space.orient(a, b, this->opposite(a, b), this->opposite(b, a)) > 0;
  }

  /// Edge ab with the link c, d may become cd: both new triangles are seen from inside.
  bool canTurn(int a, int b) const
  {
    const int c = this->opposite(a, b);
    const int d = this->opposite(b, a);
    return !this->has(c, d) && this->seen(c, a, d) && this->seen(d, b, c);
  }
  void turn(int a, int b)
  {
    const int c = this->opposite(a, b);
    const int d = this->opposite(b, a);
    this->remove(a, b, c);
    this->remove(b, a, d);
    this->add(c, a, d);
    this->add(d, b, c);
  }

  /// Vertex a has three triangles only: ab, ac, ad.
  bool isDegree3(int a, int b) const
  {
    const int c = this->opposite(a, b);
    const int d = this->opposite(b, a);
    return this->has(c, d) && this->opposite(a, c) == d;
  }
  void removeDegree3(int a, int b)
  {
    const int c = this->opposite(a, b);
    const int d = this->opposite(b, a);
    this->remove(a, b, c);
    this->remove(b, a, d);
    this->remove(a, c, d);
    this->add(b, c, d);
  }

  std::vector<Corners> triangles() const
  {
    std::vector<Corners> all;
    for (const auto& item : this->Opposite)
    {
      const int a = item.first.first;
      const int b = item.first.second;
      if (a < b && a < item.second)
      {
        all.push_back({ a, b, item.second });
      }
    }
    return all;
  }

private:
  Cloud Points;
  int Kernel;
  FilteredSpace Space;
  std::map<Edge, int> Opposite;
};

}

ReferenceHull hullOfUsed(const Surface& surface)
{
  std::vector<char> used(surface.points.size());
  for (const Corners& t : surface.triangles)
  {
    for (std::int64_t v : t)
    {
      used[static_cast<std::size_t>(v)] = 1;
    }
  }
  Cloud cloud;
  std::vector<std::int64_t> names;
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    if (used[i])
    {
      cloud.push_back(surface.points[i]);
      names.push_back(static_cast<std::int64_t>(i));
    }
  }
  const Scale scale = commonScale(cloud);
  const bool extreme = scale.bits > 400 || std::abs(scale.exponent) > 500;
  ReferenceHull hull = cloud.size() <= 25
    ? bruteForceHull(cloud)
    : cgalHull(cloud, extreme ? CgalKernel::Rational : CgalKernel::Lazy);
  // Names ascend, so the canonical order stays.
  for (std::int64_t& id : hull.ids)
  {
    id = names[id];
  }
  for (Cell& cell : hull.cells)
  {
    for (std::int64_t& id : cell)
    {
      id = names[id];
    }
  }
  return hull;
}

Hull expectFlipFlop(const Surface& surface, const double* kernel)
{
  const ReferenceHull wanted = hullOfUsed(surface);
  const Surface inward = reversed(surface);
  const bool single = isFloat(surface.points);
  const std::vector<float> floats = single ? floatsOf(surface.points) : std::vector<float>();
  const std::int64_t count = static_cast<std::int64_t>(surface.points.size());
  Hull first[2];
  EXPECT_EQ(wanted.dimension, 3);
  for (FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
  {
    Hull& one = first[facets == FacetMode::Polygons];
    for (int threads : threadsTried())
    {
      // The bits of a number name the other choices.
      for (int choice = 0; choice < 16; ++choice)
      {
        const bool vBiased = choice & 1;
        const bool turned = choice & 2;
        const bool search = choice & 4;
        if ((choice & 8) && !single)
        {
          continue;
        }
        Options options;
        options.threads = threads;
        options.facets = facets;
        options.vBiased = vBiased;
        const PointView view =
          choice & 8 ? PointView(floats.data(), count) : viewOf(surface.points);
        std::string fault;
        Hull hull;
        try
        {
          hull = convexify(
            view, turned ? inward.view() : surface.view(), search ? nullptr : kernel, options);
          fault = difference(hull, wanted, facets);
          const Statistics& s = hull.statistics;
          if (fault.empty() && s.flips22 + s.flips31 != s.flipsV + s.flipsD)
          {
            fault = "flips by kind and flips by criterion differ in sum";
          }
          if (fault.empty() && threads == 1 && choice == 0)
          {
            one = std::move(hull);
          }
          else if (fault.empty())
          {
            fault = bitDifference(hull, one);
          }
        }
        catch (const Error& error)
        {
          fault = std::string("threw: ") + error.what();
        }
        EXPECT_EQ(fault, "") << threads << " threads, "
                             << (facets == FacetMode::Polygons ? "polygons" : "triangles")
                             << (vBiased ? ", V-biased" : "") << (turned ? ", turned inward" : "")
                             << (search ? ", kernel to be found" : "")
                             << (choice & 8 ? ", float" : "");
        if (!fault.empty())
        {
          return std::move(first[0]);
        }
      }
    }
  }
  return std::move(first[0]);
}

std::vector<std::int64_t> unseen(const Surface& surface, const double* kernel)
{
  Cloud points = surface.points;
  points.push_back({ kernel[0], kernel[1], kernel[2] });
  const FilteredSpace space(points);
  std::vector<std::int64_t> result;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const Corners& c = surface.triangles[t];
    if (space.orient(static_cast<int>(c[0]), static_cast<int>(c[1]), static_cast<int>(c[2]),
          static_cast<int>(points.size()) - 1) >= 0)
    {
      result.push_back(static_cast<std::int64_t>(t));
    }
  }
  return result;
}

bool seesAll(const Surface& surface, const double* kernel)
{
  return unseen(surface, kernel).empty();
}

bool findKernel(const Surface& surface, double* kernel)
{
  using Rational = mpq_class;
  std::vector<std::array<Rational, 4>> planes; // n.x < d inside
  for (const Corners& t : surface.triangles)
  {
    std::array<Rational, 3> u;
    std::array<Rational, 3> v;
    for (int c = 0; c < 3; ++c)
    {
      u[c] = Rational(surface.points[t[1]][c]) - Rational(surface.points[t[0]][c]);
      v[c] = Rational(surface.points[t[2]][c]) - Rational(surface.points[t[0]][c]);
    }
    std::array<Rational, 4> plane;
    plane[3] = 0;
    for (int c = 0; c < 3; ++c)
    {
      const int a = (c + 1) % 3;
      const int b = (c + 2) % 3;
      plane[c] = u[a] * v[b] - u[b] * v[a];
      plane[3] += plane[c] * Rational(surface.points[t[0]][c]);
    }
    planes.push_back(plane);
  }
  // Corners of the closed kernel; their mean is inside its interior if it has one.
  std::array<Rational, 3> sum;
  int corners = 0;
  const std::size_t n = planes.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    for (std::size_t j = i + 1; j < n; ++j)
    {
      for (std::size_t k = j + 1; k < n; ++k)
      {
        const auto& p = planes[i];
        const auto& q = planes[j];
        const auto& r = planes[k];
        const auto det = [&](int a, int b, int c)
        {
          return Rational(p[a] * (q[b] * r[c] - q[c] * r[b]) - p[b] * (q[a] * r[c] - q[c] * r[a]) +
            p[c] * (q[a] * r[b] - q[b] * r[a]));
        };
        const Rational d = det(0, 1, 2);
        if (d == 0)
        {
          continue;
        }
        const std::array<Rational, 3> x = { Rational(det(3, 1, 2) / d), Rational(det(0, 3, 2) / d),
          Rational(det(0, 1, 3) / d) };
        bool inside = true;
        for (const auto& plane : planes)
        {
          inside = inside && plane[0] * x[0] + plane[1] * x[1] + plane[2] * x[2] <= plane[3];
        }
        if (inside)
        {
          ++corners;
          for (int c = 0; c < 3; ++c)
          {
            sum[c] += x[c];
          }
        }
      }
    }
  }
  for (const auto& plane : planes)
  {
    if (corners == 0 ||
      plane[0] * sum[0] + plane[1] * sum[1] + plane[2] * sum[2] >= plane[3] * corners)
    {
      return false;
    }
  }
  for (int c = 0; c < 3; ++c)
  {
    kernel[c] = Rational(sum[c] / corners).get_d();
  }
  if (!seesAll(surface, kernel))
  {
    throw std::runtime_error("the kernel is too small for this test");
  }
  return true;
}

Surface scrambled(Surface surface, const double* kernel, int times, std::uint64_t seed)
{
  FlipMesh mesh(surface, kernel);
  Random random(seed);
  for (int round = 0; round < times;)
  {
    std::vector<Edge> edges = mesh.edges();
    random.shuffle(edges);
    for (const Edge& e : edges)
    {
      ++round;
      if (round < times && mesh.has(e.first, e.second) && mesh.canTurn(e.first, e.second))
      {
        mesh.turn(e.first, e.second);
      }
    }
  }
  surface.triangles = mesh.triangles();
  return surface;
}

VFlips flipByVAlone(const Surface& surface, const double* kernel, std::uint64_t seed)
{
  FlipMesh mesh(surface, kernel);
  Random random(seed);
  VFlips result;
  bool again = true;
  while (again)
  {
    again = false;
    result.reflex = 0;
    std::vector<Edge> edges = mesh.edges();
    random.shuffle(edges);
    for (const Edge& e : edges)
    {
      const int a = e.first;
      const int b = e.second;
      if (!mesh.has(a, b) || !mesh.reflex(a, b))
      {
        continue;
      }
      ++result.reflex;
      if (mesh.isDegree3(a, b))
      {
        mesh.removeDegree3(a, b);
      }
      else if (mesh.isDegree3(b, a))
      {
        mesh.removeDegree3(b, a);
      }
      else if (mesh.canTurn(a, b))
      {
        mesh.turn(a, b);
      }
      else
      {
        continue;
      }
      ++result.flips;
      again = true;
    }
  }
  return result;
}

std::optional<ErrorCode> codeOf(const Surface& surface, const double* kernel)
{
  try
  {
    convexify(viewOf(surface.points), surface.view(), kernel);
    return std::nullopt;
  }
  catch (const Error& error)
  {
    return error.code();
  }
}

}
}
