// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// check-result hull|triangulation RESULT.npz: check a result of full dimension in triangles, with
/// its certificate, exactly. It is what check_result.py does, for large data.
///
/// RESULT has the arrays that Documentation/CheckAResult.md lists, as numpy.savez writes them. Exit
/// codes: 0 right, 1 wrong (the message names what), 2 the file cannot be read.
///
/// This program shares nothing with what it checks: it uses GMP's integers alone. The head of
/// check_result.py says why its steps are enough.
#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

namespace
{

using Id = std::int64_t;
using Integer = mpz_class;
using Vector = std::array<Integer, 3>;

using Unreadable = std::runtime_error;
struct Wrong : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

template <class Fault = Wrong, class... Parts>
void require(bool holds, const Parts&... parts)
{
  if (!holds)
  {
    std::ostringstream text;
    (text << ... << parts);
    throw Fault(text.str());
  }
}

struct Array
{
  std::vector<double> reals;
  std::vector<Id> ids; ///< of integers
  std::size_t columns = 1;
};
using Case = std::map<std::string, Array>;

template <class Number, class Wide>
void append(const std::string& data, std::size_t at, std::size_t count, std::vector<Wide>& to)
{
  require<Unreadable>(at + count * sizeof(Number) <= data.size(), "an array is cut short");
  for (std::size_t i = 0; i < count; ++i)
  {
    Number number;
    std::memcpy(&number, data.data() + at + i * sizeof(Number), sizeof(Number));
    to.push_back(static_cast<Wide>(number));
  }
}

Array readArray(const std::string& data, std::size_t begin)
{
  const std::size_t size = static_cast<unsigned char>(data.at(begin + 8)) +
    256 * static_cast<std::size_t>(static_cast<unsigned char>(data.at(begin + 9)));
  const std::string header = data.substr(begin + 10, size);
  const std::string type = header.substr(header.find("'descr': '") + 10, 3);
  Array array;
  std::size_t rows = 1;
  std::sscanf(header.c_str() + header.find('(') + 1, "%zu, %zu", &rows, &array.columns);
  const std::size_t count = rows * array.columns;
  require<Unreadable>(data[begin + 6] == 1 && header.find("_order': F") != std::string::npos,
    "arrays are rows, in C's order");
  type == "<f8"     ? append<double>(data, begin + 10 + size, count, array.reals)
    : type == "<f4" ? append<float>(data, begin + 10 + size, count, array.reals)
    : type == "<i8" ? append<Id>(data, begin + 10 + size, count, array.ids)
                    : void();
  return array;
}

Case readCase(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  const std::string data{ std::istreambuf_iterator<char>(file), {} };
  const auto number = [&](std::size_t at, std::size_t bytes)
  {
    std::uint32_t value = 0;
    require<Unreadable>(at + bytes <= data.size(), "this is no .npz file");
    std::memcpy(&value, data.data() + at, bytes);
    return std::size_t(value);
  };
  require<Unreadable>(
    data.size() >= 22 && !data.compare(data.size() - 22, 4, "PK\5\6"), "this is no .npz file");
  Case arrays;
  std::size_t at = number(data.size() - 6, 4);
  for (std::size_t i = number(data.size() - 12, 2); i > 0; --i)
  {
    require<Unreadable>(number(at + 10, 2) == 0, "compressed archives are not read here");
    const std::string name = data.substr(at + 46, number(at + 28, 2));
    const std::size_t local = number(at + 42, 4);
    arrays[name.substr(0, name.rfind('.'))] =
      readArray(data, local + 30 + number(local + 26, 2) + number(local + 28, 2));
    at += 46 + number(at + 28, 2) + number(at + 30, 2) + number(at + 32, 2);
  }
  require<Unreadable>(!arrays["points"].reals.empty() && arrays["points"].columns > 1 &&
      !arrays["certificate"].ids.empty(),
    "there must be points, as rows of floating-point numbers, and a certificate");
  return arrays;
}

Vector operator-(const Vector& a, const Vector& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}
Vector cross(const Vector& u, const Vector& v)
{
  return { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] };
}
Integer dot(const Vector& u, const Vector& v)
{
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}
int turn(const Vector& a, const Vector& b, const Vector& c)
{
  return sgn(Integer((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])));
}

/// How many binary places a number has.
int placesOf(double x)
{
  int places = 0;
  for (; x != std::floor(x); x *= 2)
  {
    ++places;
  }
  return places;
}

/// x times 2^shift, of which no place remains.
Integer whole(double x, int shift)
{
  int exponent = 0;
  const Integer bits = std::ldexp(std::frexp(x, &exponent), 53);
  const int by = exponent - 53 + shift;
  return by >= 0 ? Integer(bits << by) : Integer(bits >> -by);
}

/// Coordinates as integers: multiples of one power of two. In the plane, the third is the lift
/// x^2 + y^2 - w.
struct Exact
{
  std::vector<Vector> points;
  std::vector<bool> isFinite;
  Vector apex; ///< a sum
  Id apexes = 0;

  Exact(Case& arrays, bool inPlane)
  {
    const Array& given = arrays["points"];
    const std::vector<double>& weights = arrays["weights"].reals;
    const std::vector<double>& apexGiven = arrays["apex"].reals;
    const std::size_t count = given.reals.size() / given.columns, axes = inPlane ? 2 : 3;
    require<Unreadable>(given.columns >= axes && (weights.empty() || weights.size() == count),
      "points have no z, or there are not as many weights as points");
    int shift = 0;
    const auto carry = [&shift](int places) { shift = std::max(shift, places); };
    std::for_each(apexGiven.begin(), apexGiven.end(), [&](double x) { carry(placesOf(x)); });
    for (std::size_t i = 0; i < count; ++i)
    {
      const double* const x = &given.reals[i * given.columns];
      const double weight = weights.empty() ? 0.0 : weights[i];
      this->isFinite.push_back(std::isfinite(weight) &&
        std::all_of(x, x + given.columns, [](double c) { return std::isfinite(c); }));
      if (this->isFinite[i])
      {
        std::for_each(x, x + axes, [&](double c) { carry(placesOf(c)); });
        carry((placesOf(weight) + 1) / 2);
      }
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      Vector p;
      for (std::size_t k = 0; this->isFinite[i] && k < axes; ++k)
      {
        p[k] = whole(given.reals[i * given.columns + k], shift);
      }
      if (inPlane && this->isFinite[i])
      {
        p[2] = p[0] * p[0] + p[1] * p[1] - whole(weights.empty() ? 0.0 : weights[i], 2 * shift);
      }
      this->points.push_back(p);
    }
    for (std::size_t i = 0; i < apexGiven.size(); ++i)
    {
      this->apex[i % 3] += whole(apexGiven[i], shift);
      this->apexes += i % 3 == 2;
    }
  }
};

/// Triangles. A half-edge is an index in the corners of all: from that corner to the next one.
struct Cells
{
  std::vector<Id> corner, across; ///< across: the opposite half-edge; -1: none
  std::vector<bool> isCorner;     ///< by id
  std::vector<Id> named;          ///< the certificate

  Cells(Case& arrays, const Exact& exact)
    : corner(arrays["cells"].ids)
    , isCorner(exact.points.size())
    , named(arrays["certificate"].ids)
  {
    require<Unreadable>(arrays["cells"].columns == 3 && this->corner.size() > 0 &&
        this->named.size() == exact.points.size(),
      "cells are rows of three ids, and a certificate has an entry a point");
    for (const Id id : this->corner)
    {
      require(id >= 0 && id < Id(exact.points.size()) && exact.isFinite[id], "the corner ", id,
        " is no finite point");
      this->isCorner[id] = true;
    }
    this->link();
  }

  Id count() const { return Id(this->corner.size() / 3); }
  static Id next(Id h) { return h % 3 == 2 ? h - 2 : h + 1; }
  Id to(Id h) const { return this->corner[next(h)]; }

  void link()
  {
    const Id size = Id(this->isCorner.size());
    std::unordered_map<Id, Id> from; // of both ends: the half-edge
    for (Id h = 0; h < Id(this->corner.size()); ++h)
    {
      const auto added = from.emplace(this->corner[h] * size + this->to(h), h);
      require(added.second, "the edge from ", this->corner[h], " to ", this->to(h), " is in cell ",
        added.first->second / 3, " and again in ", h / 3);
    }
    for (Id h = 0; h < Id(this->corner.size()); ++h)
    {
      const auto found = from.find(this->to(h) * size + this->corner[h]);
      this->across.push_back(found == from.end() ? -1 : found->second);
    }
  }

  /// Is a point in a cell? sign(u, v): positive on the left of the side from corner u to v.
  template <class Sign>
  bool holds(Id cell, const Sign& sign) const
  {
    const Id* const at = &this->corner[3 * cell];
    return sign(at[0], at[1]) >= 0 && sign(at[1], at[2]) >= 0 && sign(at[2], at[0]) >= 0;
  }

  /// All cells turn left, by orient(a, b, c).
  template <class Orient>
  void requireTurns(const Orient& orient) const
  {
    for (Id h = 0; h < Id(this->corner.size()); h += 3)
    {
      require(orient(this->corner[h], this->corner[h + 1], this->corner[h + 2]) > 0, "cell ", h / 3,
        " does not turn left, seen from outside");
    }
  }

  /// Each finite point that is no corner is in the cell that is named for it, and beneath(cell,
  /// id).
  template <class SignOf, class Beneath>
  void requireNamed(const Exact& exact, const SignOf& signOf, const Beneath& beneath) const
  {
    for (Id id = 0; id < Id(exact.points.size()); ++id)
    {
      if (exact.isFinite[id] && !this->isCorner[id])
      {
        const Id cell = this->named[id];
        require(cell >= 0 && cell < this->count() && this->holds(cell, signOf(id)), "point ", id,
          " is not in cell ", cell, ", which the certificate names");
        require(beneath(cell, id), "point ", id, " is on the wrong side of cell ", cell);
      }
    }
  }

  /// The height of a point above the plane of a cell: only its sign counts.
  Integer height(const std::vector<Vector>& x, Id cell, Id id) const
  {
    const Id* const at = &this->corner[3 * cell];
    return dot(cross(x[at[1]] - x[at[0]], x[at[2]] - x[at[0]]), x[id] - x[at[0]]);
  }

  /// Where two cells meet at an edge, no corner is on the wrong side of the other cell.
  void requireEdges(const std::vector<Vector>& x, int wrongSide, bool mayHaveBorder) const
  {
    for (Id h = 0; h < Id(this->corner.size()); ++h)
    {
      const Id other = this->across[h];
      require(other >= 0 || mayHaveBorder, "the edge from ", this->corner[h], " to ", this->to(h),
        " of cell ", h / 3, " has no cell on its other side");
      const Id opposite = other < 0 ? this->corner[h] : this->to(next(other));
      require(sgn(this->height(x, h / 3, opposite)) != wrongSide, "the edge from ", this->corner[h],
        " to ", this->to(h), " is wrong: corner ", opposite, ", and cell ", h / 3);
    }
  }
};

void checkHull(Case& arrays)
{
  const Exact exact(arrays, false);
  const Cells cells(arrays, exact);
  require(exact.apexes > 0, "there is no apex");
  std::vector<Vector> rays; // from the apex
  for (const Vector& p : exact.points)
  {
    const Integer n = exact.apexes;
    rays.push_back(
      { n * p[0] - exact.apex[0], n * p[1] - exact.apex[1], n * p[2] - exact.apex[2] });
  }
  const auto orient = [&](Id a, Id b, Id c) { return sgn(dot(cross(rays[a], rays[b]), rays[c])); };
  cells.requireTurns(orient);
  cells.requireEdges(rays, 1, false);
  Vector middle;
  for (int i = 0; i < 9; ++i)
  {
    middle[i % 3] += rays[cells.corner[i / 3]][i % 3];
  }
  for (Id cell = 1; cell < cells.count(); ++cell)
  {
    require(
      !cells.holds(cell, [&](Id u, Id v) { return sgn(dot(cross(rays[u], rays[v]), middle)); }),
      "the surface winds more than once: cell ", cell, " is in front of cell 0, or behind it");
  }
  cells.requireNamed(
    exact, [&](Id id) { return [&, id](Id u, Id v) { return orient(u, v, id); }; },
    [&](Id cell, Id id) { return sgn(cells.height(rays, cell, id)) <= 0; });
}

void checkTriangulation(Case& arrays)
{
  const Exact exact(arrays, true);
  const Cells cells(arrays, exact);
  const std::vector<Vector>& x = exact.points;
  const auto orient = [&](Id a, Id b, Id c) { return turn(x[a], x[b], x[c]); };
  cells.requireTurns(orient);
  cells.requireEdges(x, -1, true);
  std::map<Id, Id> after; // along the border
  for (Id h = 0; h < Id(cells.corner.size()); ++h)
  {
    require(cells.across[h] >= 0 || after.emplace(cells.corner[h], cells.to(h)).second,
      "the border has two edges from ", cells.corner[h]);
  }
  const auto precedes = [&](Id a, Id b)
  { return x[a][0] != x[b][0] ? x[a][0] < x[b][0] : x[a][1] < x[b][1]; };
  require(!after.empty(), "there is no border");
  std::size_t length = 0, least = 0;
  Id u = after.begin()->first;
  do
  {
    const Id v = after[u];
    require(after.count(v) > 0 && ++length <= after.size(), "the border is no loop at ", v);
    const int side = orient(u, v, after[v]);
    require(side > 0 || (side == 0 && precedes(u, v) == precedes(v, after[v])),
      "the border is not convex at ", v);
    least += precedes(v, u) && precedes(v, after[v]);
    u = v;
  } while (u != after.begin()->first);
  require(length == after.size() && least == 1, "the border is not one convex loop");
  cells.requireNamed(
    exact, [&](Id id) { return [&, id](Id a, Id b) { return orient(a, b, id); }; },
    [&](Id cell, Id id) { return sgn(cells.height(x, cell, id)) >= 0; });
}

}

int main(int argc, char** argv)
{
  const std::string kind = argc == 3 ? argv[1] : "", path = argc == 3 ? argv[2] : "";
  try
  {
    require<Unreadable>(kind == "hull" || kind == "triangulation", "give a kind and a file");
    Case arrays = readCase(path);
    kind == "hull" ? checkHull(arrays) : checkTriangulation(arrays);
    std::cout << path << ": right\n";
    return 0;
  }
  catch (const std::exception& error)
  {
    const bool wrong = dynamic_cast<const Wrong*>(&error);
    std::cout << path << (wrong ? ": wrong: " : ": cannot be read: ") << error.what() << '\n';
    return wrong ? 1 : 2;
  }
}
