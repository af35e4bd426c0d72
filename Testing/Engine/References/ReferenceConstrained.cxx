// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Engine/References/ReferenceConstrained.h"

#include "Testing/Engine/References/MergedCircles.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace flipflop
{
namespace test
{

namespace
{

class BruteForce
{
public:
  BruteForce(const Cloud& points, const std::vector<Segment>& given)
    : cloud(points)
    , constraints(given)
    , space(points)
    , lowest(lowestIds(points))
  {
    for (int id = 0; id < static_cast<int>(points.size()); ++id)
    {
      if (this->lowest[static_cast<std::size_t>(id)] == id)
      {
        this->distinct.push_back(id);
      }
    }
  }

  ReferenceConstrained run()
  {
    for (std::size_t c = 0; c < this->constraints.size(); ++c)
    {
      this->addParts(static_cast<int>(c));
    }
    if (this->findCrossing())
    {
      return this->result;
    }
    for (const auto& part : this->fixed)
    {
      this->result.fixed.push_back({ { part.first.first, part.first.second }, part.second });
    }
    if (this->isFlat())
    {
      this->result.triangulation = bruteForceTriangulation(this->cloud);
      return this->result;
    }
    this->fill();
    this->flipAll();
    std::set<std::uint64_t> sides;
    for (const auto& part : this->fixed)
    {
      sides.insert(edgeKey(part.first.first, part.first.second));
      sides.insert(edgeKey(part.first.second, part.first.first));
    }
    this->result.triangulation = mergeCircles(this->cloud, this->triangles, sides);
    return this->result;
  }

private:
  using Edge = std::pair<int, int>; ///< the lower id first

  int point(std::int64_t id) const
  {
    return static_cast<int>(this->lowest[static_cast<std::size_t>(id)]);
  }

  bool isBetween(int a, int p, int b) const
  {
    const auto in = [&](std::size_t k)
    {
      const auto at = [&](int id) { return this->cloud[static_cast<std::size_t>(id)][k]; };
      return std::min(at(a), at(b)) <= at(p) && at(p) <= std::max(at(a), at(b));
    };
    return p != a && p != b && this->space.turn(a, b, p) == 0 && in(0) && in(1);
  }

  /// The points on it, in their order, from end to end.
  std::vector<int> pointsOn(int a, int b) const
  {
    std::vector<int> on = { a, b };
    for (const int p : this->distinct)
    {
      if (this->isBetween(a, p, b))
      {
        on.push_back(p);
      }
    }
    std::sort(on.begin(), on.end(),
      [this](int i, int j) {
        return this->cloud[static_cast<std::size_t>(i)] < this->cloud[static_cast<std::size_t>(j)];
      });
    return on;
  }

  bool cross(const Edge& e, const Edge& f) const
  {
    return this->space.turn(e.first, e.second, f.first) *
        this->space.turn(e.first, e.second, f.second) <
      0 &&
      this->space.turn(f.first, f.second, e.first) * this->space.turn(f.first, f.second, e.second) <
      0;
  }

  void addParts(int c)
  {
    const Segment& ends = this->constraints[static_cast<std::size_t>(c)];
    const int a = this->point(ends[0]);
    const int b = this->point(ends[1]);
    if (a == b)
    {
      return;
    }
    const std::vector<int> on = this->pointsOn(a, b);
    for (std::size_t i = 1; i < on.size(); ++i)
    {
      const Edge part = std::minmax(on[i - 1], on[i]);
      this->fixed.emplace(part, c);
      this->partsOf[c].push_back(part);
    }
  }

  bool findCrossing()
  {
    for (const auto& later : this->partsOf)
    {
      for (const auto& earlier : this->partsOf)
      {
        for (const Edge& e : later.second)
        {
          for (const Edge& f : earlier.second)
          {
            if (earlier.first < later.first && this->cross(e, f))
            {
              this->result.crossing = later.first;
              this->result.crossed = earlier.first;
              return true;
            }
          }
        }
      }
    }
    return false;
  }

  bool isFlat() const
  {
    return std::all_of(this->distinct.begin(), this->distinct.end(),
      [this](int p)
      {
        return std::all_of(this->distinct.begin(), this->distinct.end(),
          [&](int q) { return this->space.turn(this->distinct[0], p, q) == 0; });
      });
  }

  /// Edges until no more fit, and the triangles between them.
  void fill()
  {
    std::vector<Edge> edges;
    std::set<Edge> present;
    const auto add = [&](const Edge& edge)
    {
      edges.push_back(edge);
      present.insert(edge);
    };
    for (const auto& part : this->fixed)
    {
      add(part.first);
    }
    const auto& p = this->distinct;
    for (std::size_t i = 0; i < p.size(); ++i)
    {
      for (std::size_t j = i + 1; j < p.size(); ++j)
      {
        const Edge edge(p[i], p[j]);
        if (present.count(edge) == 0 && this->pointsOn(p[i], p[j]).size() == 2 &&
          std::none_of(edges.begin(), edges.end(),
            [&](const Edge& other) { return this->cross(edge, other); }))
        {
          add(edge);
        }
      }
    }
    for (const Edge& ab : edges)
    {
      for (const int c : p)
      {
        if (c > ab.second && present.count({ ab.first, c }) && present.count({ ab.second, c }))
        {
          this->addIfEmpty(ab.first, ab.second, c);
        }
      }
    }
  }

  void addIfEmpty(int a, int b, int c)
  {
    if (this->space.turn(a, b, c) < 0)
    {
      std::swap(b, c);
    }
    const auto isInside = [&](int p)
    {
      return p != a && p != b && p != c && this->space.turn(a, b, p) >= 0 &&
        this->space.turn(b, c, p) >= 0 && this->space.turn(c, a, p) >= 0;
    };
    if (this->space.turn(a, b, c) > 0 &&
      std::none_of(this->distinct.begin(), this->distinct.end(), isInside))
    {
      this->triangles.push_back({ a, b, c });
    }
  }

  void flipAll()
  {
    while (this->flipOne())
    {
    }
  }

  bool flipOne()
  {
    const Owners owners = ownersOf(this->triangles);
    for (std::size_t t = 0; t < this->triangles.size(); ++t)
    {
      for (int e = 0; e < 3; ++e)
      {
        const Triangle at = this->triangles[t];
        const int a = at[e];
        const int b = at[(e + 1) % 3];
        const int c = at[(e + 2) % 3];
        const auto twin = owners.find(edgeKey(b, a));
        if (twin == owners.end() || this->fixed.count(std::minmax(a, b)) != 0)
        {
          continue;
        }
        Triangle& other = this->triangles[static_cast<std::size_t>(twin->second)];
        const int d = other[0] + other[1] + other[2] - a - b;
        if (this->space.orient(a, b, c, d) < 0)
        {
          this->triangles[t] = { a, d, c };
          other = { d, b, c };
          return true;
        }
      }
    }
    return false;
  }

  const Cloud& cloud;
  const std::vector<Segment>& constraints;
  const LiftedSpace space;
  const std::vector<std::int64_t> lowest;
  std::vector<int> distinct;
  std::map<Edge, int> fixed; ///< and the first constraint along it
  std::map<int, std::vector<Edge>> partsOf;
  std::vector<Triangle> triangles;
  ReferenceConstrained result;
};

}

ReferenceConstrained bruteForceConstrained(
  const Cloud& cloud, const std::vector<Segment>& constraints)
{
  return BruteForce(cloud, constraints).run();
}

}
}
