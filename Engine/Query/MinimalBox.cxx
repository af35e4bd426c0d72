// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Query/MinimalBox.h"

#include "Points/Vector3.h"
#include "Predicates/ErrorBounds.h"
#include "Query/FacetPlane.h"
#include "Query/LeastRectangle.h"
#include "Query/UnitFrame.h"
#include "Support/Parallel.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace flipflop
{

namespace
{

/// Three axes at right angles, and the volume of the box along them, in units of 2^-1000: that of a
/// thin hull may be less than any double.
struct Candidate
{
  Vector3 axis[3];
  double volume = HUGE_VAL;
};

/// @return false where the vector is too short to have a direction
bool normalise(Vector3& v)
{
  const double length = lengthOf(v);
  for (int i = 0; i < 3 && length > 1e-12; ++i)
  {
    v[i] /= length;
  }
  return length > 1e-12;
}

/// Two axes next to a given one.
void complete(const Vector3& axis, Vector3& second, Vector3& third)
{
  int least = 0;
  for (int i = 1; i < 3; ++i)
  {
    least = std::fabs(axis[i]) < std::fabs(axis[least]) ? i : least;
  }
  Vector3 unit = { { 0, 0, 0 } };
  unit[least] = 1;
  second = cross(axis, unit);
  normalise(second);
  third = cross(axis, second);
}

/// Make the first two axes orthonormal again, and the third their product.
void square(Vector3* axis)
{
  normalise(axis[0]);
  const double along = dot(axis[0], axis[1]);
  for (int i = 0; i < 3; ++i)
  {
    axis[1][i] -= along * axis[0][i];
  }
  normalise(axis[1]);
  axis[2] = cross(axis[0], axis[1]);
  normalise(axis[2]);
}

/// How far points reach along an axis.
struct Reach
{
  double low = HUGE_VAL;
  double high = -HUGE_VAL;

  void add(double along)
  {
    this->low = std::min(this->low, along);
    this->high = std::max(this->high, along);
  }
};

class BoxSearch
{
public:
  BoxSearch(const PreparedHull& hull, const UnitFrame& frame, Monitor& monitor)
    : hull(hull)
    , frame(frame)
    , monitor(monitor)
  {
  }

  Candidate search()
  {
    this->choosePoints();
    std::vector<Vector3> directions = this->facetNormals();
    std::vector<Vector3> edges;
    if (directions.size() < FewNormals)
    {
      edges = this->edgeDirections();
      directions.insert(directions.end(), edges.begin(), edges.end());
      spread(100, directions);
    }
    std::vector<Candidate> found(directions.size());
    this->monitor.stage(0.1, 0.6, static_cast<std::int64_t>(directions.size()));
    eachChunk(directions.size(), 16,
      [&](std::size_t begin, std::size_t end, std::size_t)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          found[i] = this->around(this->points, directions[i]);
        }
        this->monitor.advance(static_cast<std::int64_t>(end - begin));
      });
    this->tryPairs(edges, found);

    const auto less = [](const Candidate& a, const Candidate& b) { return a.volume < b.volume; };
    std::stable_sort(found.begin(), found.end(), less);
    found.resize(std::min<std::size_t>(found.size(), 16));
    this->monitor.stage(0.8, 0.9, 1);
    eachTask(
      found.size(), [&](std::size_t i) { found[i] = this->byTurns(this->points, found[i]); });

    // So far among some of the corners, where they are many.
    const std::vector<Vector3> all = this->allPoints();
    Candidate best = straight(all);
    for (Candidate& candidate : found)
    {
      candidate.volume = volumeOf(all, candidate);
    }
    const Candidate other = this->byTurns(all, *std::min_element(found.begin(), found.end(), less));
    return other.volume < best.volume ? other : best;
  }

private:
  static constexpr std::size_t ManyPoints = 2000;
  static constexpr std::size_t ManyDirections = 1000;
  /// Where normals are fewer, edges and directions all around find smaller boxes: by 0.03 % on
  /// average, by 2 % at most. Where they are more, nothing is found but the time is doubled.
  static constexpr std::size_t FewNormals = 128;
  /// Up to so many, pairs take some 10 ms.
  static constexpr std::size_t FewEdges = 64;

  using Points = std::vector<Vector3>;

  Points allPoints() const
  {
    Points all(this->hull.size());
    for (std::uint32_t i = 0; i < this->hull.size(); ++i)
    {
      std::copy(this->frame.at(i), this->frame.at(i) + 3, all[i].x);
    }
    return all;
  }

  /// All corners, or where they are many, those that are extreme in directions all around.
  void choosePoints()
  {
    this->points = this->allPoints();
    if (this->points.size() <= ManyPoints)
    {
      return;
    }
    std::vector<Vector3> directions;
    spread(ManyPoints, directions);
    std::vector<std::uint32_t> chosen;
    const DirectionMap& map = this->hull.directions(this->monitor);
    for (const Vector3& d : directions)
    {
      chosen.push_back(map.farthest(d.x));
    }
    std::sort(chosen.begin(), chosen.end());
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    Points some;
    for (const std::uint32_t i : chosen)
    {
      some.push_back(this->points[i]);
    }
    this->points.swap(some);
  }

  /// Directions all around, evenly: points of a spiral on the sphere.
  static void spread(std::size_t count, std::vector<Vector3>& directions)
  {
    // Each is turned from the one before by the golden angle.
    constexpr double Cosine = -0.7373688780783197;
    constexpr double Sine = 0.6754902942615238;
    double x = 1;
    double y = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
      const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(count);
      const double r = std::sqrt(1 - z * z);
      directions.push_back({ { r * x, r * y, z } });
      const double next = Cosine * x - Sine * y;
      y = Sine * x + Cosine * y;
      x = next;
    }
  }

  std::vector<Vector3> facetNormals() const
  {
    std::vector<Vector3> normals;
    const Buffer<Triangle>& triangles = this->hull.polyhedron().triangles;
    const std::size_t step = chunkCount(triangles.size(), ManyDirections);
    for (std::size_t t = 0; t < triangles.size(); t += step)
    {
      const std::uint32_t* const v = triangles[t].v;
      const FacetPlane plane(
        this->hull.corner(v[0]).x, this->hull.corner(v[1]).x, this->hull.corner(v[2]).x);
      normals.push_back({ { plane.normal[0], plane.normal[1], plane.normal[2] } });
    }
    return normals;
  }

  std::vector<Vector3> edgeDirections() const
  {
    std::vector<Vector3> edges;
    for (const Triangle& triangle : this->hull.polyhedron().triangles)
    {
      for (int e = 0; e < 3; ++e)
      {
        const std::uint32_t a = triangle.v[e];
        const std::uint32_t b = triangle.v[nextCorner(e)];
        Vector3 edge = subtract(this->frame.at(b), this->frame.at(a));
        if (a < b && normalise(edge))
        {
          edges.push_back(edge);
        }
      }
    }
    return edges;
  }

  static double volumeOf(const Points& points, const Candidate& candidate)
  {
    double volume = 0x1p1000;
    for (const Vector3& axis : candidate.axis)
    {
      Reach reach;
      for (const Vector3& p : points)
      {
        reach.add(dot(axis, p));
      }
      volume *= reach.high - reach.low;
    }
    return volume;
  }

  static Candidate straight(const Points& points)
  {
    Candidate result = { { { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } } };
    result.volume = volumeOf(points, result);
    return result;
  }

  /// The least box with an axis along a unit vector.
  static Candidate around(const Points& points, const Vector3& axis)
  {
    Vector3 u, v;
    complete(axis, u, v);
    std::vector<PlanePoint> shadow;
    shadow.reserve(points.size());
    for (const Vector3& p : points)
    {
      shadow.push_back({ dot(u, p), dot(v, p) });
    }
    const Rectangle rectangle = leastRectangle(shadow);
    Candidate result;
    for (int i = 0; i < 3; ++i)
    {
      result.axis[0][i] = axis[i];
      result.axis[1][i] = rectangle.along[0] * u[i] + rectangle.along[1] * v[i];
    }
    square(result.axis);
    result.volume = volumeOf(points, result);
    return result;
  }

  Candidate byTurns(const Points& points, const Candidate& from) const
  {
    constexpr int MostTurns = 60;
    Candidate best = from;
    best.volume = volumeOf(points, best);
    int kept = 0; // turns without a gain
    for (int turn = 0; turn < MostTurns && kept < 3; ++turn)
    {
      this->monitor.poll();
      const Candidate next = around(points, best.axis[turn % 3]);
      const bool better = next.volume < best.volume * (1 - 1e-12);
      kept = better ? 0 : kept + 1;
      best = better ? next : best;
    }
    return best;
  }

  /// Boxes with two sides, next to each other, along an edge each: turned about the first edge.
  void tryPairs(const std::vector<Vector3>& edges, std::vector<Candidate>& found) const
  {
    if (edges.size() < 2 || edges.size() > FewEdges)
    {
      return;
    }
    const std::size_t first = found.size();
    const std::size_t count = edges.size() - 1;
    found.resize(first + count, straight(this->points));
    this->monitor.stage(0.6, 0.8, static_cast<std::int64_t>(count));
    eachTask(count,
      [&](std::size_t i)
      {
        Candidate& best = found[first + i];
        for (std::size_t j = i + 1; j < edges.size(); ++j)
        {
          const Candidate candidate = this->aboutPair(edges[i], edges[j], 1.1 * best.volume);
          best = candidate.volume < best.volume ? candidate : best;
        }
        this->monitor.advance(1);
      });
  }

  /// @param promising the volume from which on it is not worth a closer look
  Candidate aboutPair(const Vector3& along, const Vector3& other, double promising) const
  {
    constexpr int Turns = 24;
    Vector3 u, v;
    complete(along, u, v);
    // A way around half the circle, from 0 to 2, by fractions: a quarter takes 1. (The last bits of
    // sines are not the same everywhere.)
    const auto at = [&](double way)
    {
      const double around = way - 2 * std::floor(way / 2);
      const double t = around < 1 ? around : around - 1;
      const double c = (1 - t * t) / (1 + t * t);
      const double s = 2 * t / (1 + t * t);
      const double x = around < 1 ? c : -s;
      const double y = around < 1 ? s : c;
      Candidate result;
      for (int i = 0; i < 3; ++i)
      {
        result.axis[0][i] = x * u[i] + y * v[i];
      }
      result.axis[1] = cross(other, result.axis[0]);
      if (normalise(result.axis[1]))
      {
        square(result.axis);
        result.volume = volumeOf(this->points, result);
      }
      return result;
    };
    Candidate best;
    double where = 0;
    for (int i = 0; i < Turns; ++i)
    {
      const Candidate next = at(2.0 * i / Turns);
      where = next.volume < best.volume ? 2.0 * i / Turns : where;
      best = next.volume < best.volume ? next : best;
    }
    // Closer and closer around the best.
    double step = 2.0 / Turns;
    for (int i = 0; i < 50 && best.volume < promising; ++i)
    {
      const Candidate less = at(where - step);
      const Candidate more = at(where + step);
      const Candidate& next = less.volume < more.volume ? less : more;
      if (next.volume < best.volume)
      {
        where += less.volume < more.volume ? -step : step;
        best = next;
      }
      else
      {
        step /= 2;
      }
    }
    return best;
  }

  const PreparedHull& hull;
  const UnitFrame& frame;
  Monitor& monitor;
  Points points;
};

/// No box around the hull is smaller: neither than the hull, nor than three times a tetrahedron in
/// it. (A tetrahedron in a box, or in any parallelepiped, has its greatest volume at four corners:
/// a third.) The rounded sums are lowered by more than they can be off.
double leastVolume(const PreparedHull& hull)
{
  const UnitFrame frame(&hull.corner(0), hull.size(), true);
  double sum = 0;
  double largest = 0;
  const Polyhedron& solid = hull.polyhedron();
  for (const Triangle& triangle : solid.triangles)
  {
    sum += dot(cross(frame.at(triangle.v[0]), frame.at(triangle.v[1])), frame.at(triangle.v[2]));
  }
  // From a corner on: the farthest from it, from the line of the two, from the plane of the three.
  std::uint32_t four[4] = { 0, 0, 0, 0 };
  const auto farthest = [&](auto&& measure)
  {
    std::uint32_t found = 0;
    double most = -1;
    for (std::uint32_t i = 0; i < hull.size(); ++i)
    {
      const double size = measure(subtract(frame.at(i), frame.at(four[0])));
      found = size > most ? i : found;
      most = std::max(most, size);
    }
    largest = most;
    return found;
  };
  four[1] = farthest([](const Vector3& v) { return dot(v, v); });
  const Vector3 edge = subtract(frame.at(four[1]), frame.at(four[0]));
  four[2] = farthest(
    [&](const Vector3& v)
    {
      const Vector3 turn = cross(edge, v);
      return dot(turn, turn);
    });
  const Vector3 normal = cross(edge, subtract(frame.at(four[2]), frame.at(four[0])));
  four[3] = farthest([&](const Vector3& v) { return std::fabs(dot(normal, v)); });
  const double byHull = sum / 6 - VolumeSlack * static_cast<double>(solid.triangles.size());
  int exponent = -3 * hull.scaleExponent();
  for (int i = 0; i < 3; ++i)
  {
    exponent += frame.lengthExponent(i);
  }
  return std::ldexp(std::max(0.0, std::max(byHull, largest / 2 - 10 * VolumeSlack)), exponent);
}

/// The axes for a hull below dimension 3, where the least box is no matter of search. In the plane,
/// the third one is z.
Candidate flatAxes(const PreparedHull& hull, const UnitFrame& frame)
{
  Candidate result = { { { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 0, 0, 1 } } } };
  if (hull.dimension() == 1)
  {
    result.axis[0] = subtract(frame.at(1), frame.at(0));
    normalise(result.axis[0]);
    if (hull.isInPlane())
    {
      result.axis[1] = cross(result.axis[2], result.axis[0]);
    }
    else
    {
      complete(result.axis[0], result.axis[1], result.axis[2]);
    }
    square(result.axis);
  }
  if (hull.dimension() == 2)
  {
    const std::vector<std::uint32_t>& ring = hull.ring();
    const FacetPlane plane(hull.corner(ring[0]).x, hull.corner(ring[1]).x, hull.corner(ring[2]).x);
    const Vector3 normal = { { plane.normal[0], plane.normal[1], plane.normal[2] } };
    Vector3 u, v;
    complete(normal, u, v);
    std::vector<PlanePoint> points;
    for (std::uint32_t i = 0; i < hull.size(); ++i)
    {
      points.push_back({ dot(u, frame.at(i)), dot(v, frame.at(i)) });
    }
    const Rectangle rectangle = leastRectangle(points);
    for (int i = 0; i < 3; ++i)
    {
      result.axis[0][i] = rectangle.along[0] * u[i] + rectangle.along[1] * v[i];
    }
    result.axis[1] = cross(normal, result.axis[0]);
    square(result.axis);
  }
  return result;
}

/// Of lengths in units of 2^unit, also where the product of their numbers is no double.
double productOf(const double* length, int count, int unit)
{
  double product = 1;
  int exponent = count * unit;
  for (int i = 0; i < count; ++i)
  {
    int own = 0;
    product *= std::frexp(length[i], &own);
    exponent += own;
  }
  return std::ldexp(product, exponent);
}

}

OrientedBox minimalBoxOf(const PreparedHull& hull, Monitor& monitor)
{
  const UnitFrame frame(&hull.corner(0), hull.size());
  const bool solid = hull.dimension() == 3;
  const Candidate found = solid ? BoxSearch(hull, frame, monitor).search() : flatAxes(hull, frame);
  double length[3], middle[3];
  int order[3] = { 0, 1, 2 };
  for (int k = 0; k < 3; ++k)
  {
    Reach reach;
    for (std::uint32_t i = 0; i < hull.size(); ++i)
    {
      reach.add(dot(found.axis[k], frame.at(i)));
    }
    length[k] = k < hull.dimension() ? reach.high - reach.low : 0.0;
    middle[k] = 0.5 * reach.low + 0.5 * reach.high;
  }
  std::stable_sort(order, order + 3, [&](int a, int b) { return length[a] > length[b]; });

  OrientedBox box;
  const int unit = frame.lengthExponent(0) - hull.scaleExponent();
  for (int i = 0; i < 3; ++i)
  {
    box.lengths[i] = std::ldexp(length[order[i]], unit);
    std::copy_n(found.axis[order[i]].x, 3, box.axes[i]);
    const double x =
      middle[0] * found.axis[0][i] + middle[1] * found.axis[1][i] + middle[2] * found.axis[2][i];
    box.center[i] = frame.toCorners(x, i, hull.scaleExponent());
  }
  // In the plane the third axis stays as it is.
  const bool leftHanded = (order[1] - order[0] + 3) % 3 == 2;
  for (double& x : box.axes[hull.isInPlane() ? 1 : 2])
  {
    x = leftHanded ? 0.0 - x : x;
  }
  if (hull.isInPlane())
  {
    box.volume = productOf(length, 2, unit);
    box.lowerBound = box.volume;
    return box;
  }
  box.volume = solid ? productOf(length, 3, unit) : 0.0;
  box.lowerBound = solid ? std::min(leastVolume(hull), box.volume) : 0.0;
  return box;
}

}
