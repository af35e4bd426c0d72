// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Natural neighbour coordinates (R. Sibson, 1981), also of weighted points: insert the query; the
/// share of a site is the area that the query's power cell takes from the site's.
///
/// Which triangles the query would remove (the region) is decided by exact signs. What it takes
/// from a site a is a convex polygon: from the center of the query and the edge by which the region
/// begins at a, over the power centers of a's triangles in the region, to the center of the query
/// and the edge by which it ends. Centers may be far away, and the polygon thin, so no center is
/// computed. The sides of the polygon are perpendicular to the edges at a, and each is a known
/// multiple of its edge:
///
///   from a triangle t to the next one across an edge: -I(t, d) / (A(t) A(next)), d the corner of
///     the next one opposite the edge
///   to or from the query's center beyond an edge ab:  I(t, q) / (A(t) A(a, b, q))
///
/// (half of that), where I is how high a point is above t, times A, and A is twice the area. For
/// along the axis of ab, which all these centers are on, the power of a third point changes against
/// that of a and b by twice its distance from ab for each step. All these multiples are positive,
/// so they lose no bits. The polygon's area is the sum of the crosses of its sides: these are of
/// one sign, but each is a difference, small where edges are nearly parallel (thin triangles). So
/// it is compared with its terms.
///
/// Why the shares reproduce linear functions, whatever the weights: the least power to the sites,
/// less that to the query, is zero around the query's cell, so its gradient has the integral zero
/// over the cell. On what comes from site a, that gradient is 2 (q - a).
#include "Query/NaturalShares.h"

#include "Query/PlaneValues.h"
#include "Query/TriangleSet.h"

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace flipflop
{

namespace
{

/// Of what a memory has of a triangle, the number after those of its three edges.
constexpr int Area = 3;

/// What of triangles does not depend on the query, from query to query: the sides of polygons at
/// their edges, and their areas. One task has one for each kind of number.
template <class Number>
class TriangleMemory
{
public:
  /// What compute() returns or has returned, as long as no other triangle has taken its place.
  /// @param isRight bool (): is what was computed worth keeping?
  template <class Compute, class IsRight>
  Number recall(std::uint32_t t, int which, const Compute& compute, const IsRight& isRight)
  {
    if (this->slots.empty())
    {
      this->slots.resize(Size);
    }
    Slot& slot = this->slots[t % Size];
    if (slot.triangle != t)
    {
      slot.triangle = t;
      slot.known = 0;
    }
    if (!(slot.known >> which & 1))
    {
      slot.numbers[which] = compute();
      slot.known |= (isRight() ? 1 : 0) << which;
    }
    return slot.numbers[which];
  }

private:
  static constexpr std::uint32_t Size = 1 << 10;

  struct Slot
  {
    std::uint32_t triangle = NoIndex;
    int known = 0; ///< a bit for each number
    Number numbers[4];
  };

  std::vector<Slot> slots;
};

/// For numbers that are not worth remembering.
struct NoMemory
{
  template <class Compute, class IsRight>
  auto recall(std::uint32_t, int, const Compute& compute, const IsRight&)
  {
    return compute();
  }
};

/// The areas that a query takes.
template <class Space, class Values, class Memory>
class StolenAreas
{
public:
  using Number = typename Values::Number;
  using Size = typename Values::Size;
  using Pair = typename Values::Pair;

  /// @param triangles of the region, not empty
  StolenAreas(const FanMesh& fans, const TriangleSet& triangles, const Space& querySpace, Values& v,
    Memory& toRecall)
    : mesh(fans)
    , region(triangles)
    , space(querySpace)
    , values(v)
    , memory(toRecall)
  {
    this->measured.reserve(this->region.size());
    for (std::size_t i = 0; i < this->region.size(); ++i)
    {
      const std::uint32_t* corners = this->mesh.triangles[this->region[i]].v;
      const Vertex a = this->space.site(corners[0]);
      const Vertex b = this->space.site(corners[1]);
      const Vertex c = this->space.site(corners[2]);
      this->measured.push_back(
        { this->recall(this->region[i], Area, [&] { return this->values.area(a.x, b.x, c.x); }),
          this->values.heightAbove(a.x, b.x, c.x, this->space.query.x), {}, 0 });
    }
    if (!this->values.isVague())
    {
      this->measureSides();
    }
  }

  /// @param shares is left as it is where the areas are nothing, or beyond the numbers' range
  /// @return false there
  bool share(NaturalMeasure wanted, PlaneShares& shares)
  {
    if (this->values.isVague())
    {
      return false;
    }
    this->measure = wanted;
    this->addFromBorder();
    if (wanted == NaturalMeasure::Area)
    {
      this->addHidden();
    }
    Number all = this->values.number(0.0);
    for (const Part& part : this->parts)
    {
      this->values.checkSum(part.area, part.terms);
      all = all + part.area;
    }
    if (!this->values.isPositive(all))
    {
      return false;
    }
    shares.clear();
    for (const Part& part : this->parts)
    {
      shares.push_back({ part.site, std::max(0.0, toDouble(part.area / all)) });
    }
    return true;
  }

private:
  /// Of a triangle of the region.
  struct Measured
  {
    Number area;    ///< twice
    Number height;  ///< of the query, times that
    Number side[3]; ///< by half-edge: how many times it the polygons' side is
    int seen;       ///< bit i: its corner i has been counted
  };

  struct Part
  {
    std::uint32_t site;
    Number area; ///< eight times; or what is measured in its stead
    Size terms;  ///< the sum of the sizes of what it is a sum of
  };

  template <class Compute>
  Number recall(std::uint32_t t, int which, const Compute& compute)
  {
    return this->memory.recall(t, which, compute, [this] { return !this->values.isVague(); });
  }

  /// Those of an inner edge are the same from both its triangles.
  void measureSides()
  {
    for (std::size_t i = 0; i < this->region.size(); ++i)
    {
      Measured& m = this->measured[i];
      for (int corner = 0; corner < 3; ++corner)
      {
        const std::uint32_t h = halfEdge(this->region[i], corner);
        const std::uint32_t next = this->across(h);
        if (next == NoIndex)
        {
          const Vertex a = this->space.site(this->mesh.origin(h));
          const Vertex b = this->space.site(this->mesh.origin(nextHalfEdge(h)));
          m.side[corner] = m.height / (m.area * this->values.area(a.x, b.x, this->space.query.x));
        }
        else if (next > i)
        {
          // From the same side for all queries.
          Measured& other = this->measured[next];
          const std::uint32_t twin = this->mesh.twin(h);
          const std::uint32_t from = std::min(h, twin);
          m.side[corner] = other.side[cornerOf(twin)] = this->recall(triangleOf(from),
            cornerOf(from), [&] { return this->depthBeyond(from) / (m.area * other.area); });
        }
      }
    }
  }

  /// From the sites at the region's border.
  void addFromBorder()
  {
    this->parts.reserve(this->region.size() + 2);
    for (std::size_t i = 0; i < this->region.size(); ++i)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        const std::uint32_t h = halfEdge(this->region[i], corner);
        if (this->across(h) == NoIndex)
        {
          this->begin(h);
          this->addSide(this->measured[i].side[corner], this->mesh.origin(nextHalfEdge(h)));
          this->addRing(h);
          if (this->measure == NaturalMeasure::SideLength)
          {
            this->measureLastSide();
          }
        }
      }
    }
  }

  /// From the sites that the query hides: all that they have.
  void addHidden()
  {
    for (std::size_t i = 0; i < this->region.size(); ++i)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        if (!(this->measured[i].seen >> corner & 1))
        {
          const std::uint32_t h = halfEdge(this->region[i], corner);
          this->begin(h);
          this->addRing(h);
        }
      }
    }
  }

  /// The polygon of the site where a half-edge begins.
  void begin(std::uint32_t h)
  {
    const Number none = this->values.number(0.0);
    this->parts.push_back({ this->mesh.origin(h), none, Size(0) });
    this->site = this->space.site(this->mesh.origin(h));
    this->sum = Values::pairOf(none, none);
    this->way[0] = this->way[1] = Size(0);
  }

  /// The sides from the triangle of @p first on, counter-clockwise around its origin, until the
  /// ring leaves the region, or is closed.
  void addRing(std::uint32_t first)
  {
    for (std::uint32_t h = first;;)
    {
      Measured& m = this->measured[this->region.find(triangleOf(h))];
      m.seen |= 1 << cornerOf(h);
      const std::uint32_t back = previousHalfEdge(h);
      this->addSide(m.side[cornerOf(back)], this->mesh.origin(back));
      const bool leaves = this->across(back) == NoIndex;
      h = this->mesh.twin(back);
      if (leaves || h == first)
      {
        return;
      }
    }
  }

  /// The next side is so many times the edge to @p neighbour, turned by a right angle.
  void addSide(const Number& multiple, std::uint32_t neighbour)
  {
    const Vertex to = this->space.site(neighbour);
    const Pair side =
      Values::pairOf(multiple, multiple) * this->values.differences(to.x, this->site.x);
    const Size width = Values::sizeOf(side, 0);
    const Size height = Values::sizeOf(side, 1);
    Part& part = this->parts.back();
    part.area = part.area + Values::cross(this->sum, side);
    part.terms = part.terms + this->way[0] * height + this->way[1] * width;
    this->sum = this->sum + side;
    this->way[0] = this->way[0] + width;
    this->way[1] = this->way[1] + height;
  }

  /// The last side of the polygon, between the centers of the query, closes it. It is perpendicular
  /// to the line from the query to the site, as the other sides are to their edges.
  void measureLastSide()
  {
    const Pair towards = this->values.differences(this->space.query.x, this->site.x);
    const int axis = Values::sizeOf(towards, 0) >= Values::sizeOf(towards, 1) ? 0 : 1;
    Part& part = this->parts.back();
    part.area = Values::at(this->sum, axis);
    part.terms = this->way[axis];
    this->values.checkSum(part.area, part.terms);
    part.area = part.area / Values::at(towards, axis);
    part.terms = Size(0);
  }

  /// How deep the corner beyond a half-edge is below its triangle, times twice the area.
  Number depthBeyond(std::uint32_t h)
  {
    const std::uint32_t* v = this->mesh.triangles[triangleOf(h)].v;
    const Vertex a = this->space.site(v[0]);
    const Vertex b = this->space.site(v[1]);
    const Vertex c = this->space.site(v[2]);
    const Vertex d = this->space.site(this->mesh.origin(previousHalfEdge(this->mesh.twin(h))));
    const Number none = this->values.number(0.0);
    // On one circle the value would be too vague to be zero.
    return this->space.geometry.above(a, b, c, d) == 0
      ? none
      : none - this->values.heightAbove(a.x, b.x, c.x, d.x);
  }

  /// The index in the region of the triangle beyond a half-edge; NoIndex: it is not in there.
  std::uint32_t across(std::uint32_t h) const
  {
    const std::uint32_t twin = this->mesh.twin(h);
    return twin == NoIndex ? NoIndex : this->region.find(triangleOf(twin));
  }

  const FanMesh& mesh;
  const TriangleSet& region;
  const Space& space;
  Values& values;
  Memory& memory;
  std::vector<Measured> measured; ///< as the region is ordered
  std::vector<Part> parts;
  NaturalMeasure measure = NaturalMeasure::Area;
  Vertex site; ///< of the last part
  Pair sum;    ///< of its sides so far, before they are turned
  Size way[2]; ///< of their sizes
};

}

class NaturalNeighbours::State
{
public:
  explicit State(const FanMesh& fans)
    : mesh(fans)
  {
  }

  template <class Space>
  void share(const Space& space, std::uint32_t start, NaturalMeasure measure, PlaneShares& shares)
  {
    this->region.clear();
    this->addIfAbove(space, start);
    for (std::size_t i = 0; i < this->region.size(); ++i)
    {
      for (const std::uint32_t twin : this->mesh.triangles[this->region[i]].twin)
      {
        if (twin != NoIndex && this->region.find(triangleOf(twin)) == NoIndex)
        {
          this->addIfAbove(space, triangleOf(twin));
        }
      }
    }
    if (this->region.size() > 0)
    {
      withPlainValues(
        [&](auto& values)
        {
          using Values = std::decay_t<decltype(values)>;
          auto& memory = this->memoryFor<Space, Values>();
          return StolenAreas<Space, Values, std::decay_t<decltype(memory)>>(
            this->mesh, this->region, space, values, memory)
            .share(measure, shares);
        });
    }
  }

private:
  template <class Space>
  void addIfAbove(const Space& space, std::uint32_t t)
  {
    const std::uint32_t* v = this->mesh.triangles[t].v;
    if (space.geometry.above(space.site(v[0]), space.site(v[1]), space.site(v[2]), space.query) > 0)
    {
      this->region.add(t);
    }
  }

  /// Only where sites are scaled and numbers are short.
  template <class Space, class Values>
  auto& memoryFor()
  {
    if constexpr (!std::is_same<Space, SiteSigns::Narrow>::value)
    {
      return this->noMemory;
    }
    else if constexpr (std::is_same<Values, PlainValues>::value)
    {
      return this->plainMemory;
    }
    else if constexpr (std::is_same<Values, NearValues>::value)
    {
      return this->nearMemory;
    }
    else
    {
      return this->noMemory;
    }
  }

  const FanMesh& mesh;
  TriangleSet region;
  TriangleMemory<PlainValues::Number> plainMemory;
  TriangleMemory<NearValues::Number> nearMemory;
  NoMemory noMemory;
};

NaturalNeighbours::NaturalNeighbours(const FanMesh& mesh)
  : state(std::make_unique<State>(mesh))
{
}

NaturalNeighbours::~NaturalNeighbours() = default;

void NaturalNeighbours::share(
  const SiteSigns::Narrow& space, std::uint32_t start, NaturalMeasure measure, PlaneShares& shares)
{
  this->state->share(space, start, measure, shares);
}

void NaturalNeighbours::share(
  const SiteSigns::Wide& space, std::uint32_t start, NaturalMeasure measure, PlaneShares& shares)
{
  this->state->share(space, start, measure, shares);
}

}
