// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Stars, edges and twins of cells thrown together at random, so that they meet in every wrong way,
/// are those that a map of edges shows.
#include "Mesh/VertexStars.h"
#include "Testing/Engine/Inputs/Inputs.h"

#include <gtest/gtest.h>

#include <map>

namespace flipflop
{
namespace test
{

namespace
{

constexpr std::uint32_t Unset = NoIndex - 1;

using Ends = std::pair<std::uint32_t, std::uint32_t>;

CellComplex complexOf(const std::vector<std::vector<std::int64_t>>& cells, std::size_t vertices)
{
  CellComplex complex;
  complex.dimension = 2;
  complex.pointIds.allocate(vertices);
  std::vector<std::int64_t> corners;
  complex.offsets.allocate(cells.size() + 1);
  complex.offsets[0] = 0;
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    corners.insert(corners.end(), cells[c].begin(), cells[c].end());
    complex.offsets[c + 1] = static_cast<std::int64_t>(corners.size());
  }
  complex.connectivity.allocate(corners.size());
  std::copy(corners.begin(), corners.end(), complex.connectivity.begin());
  return complex;
}

CellComplex anyCells(std::size_t mostCorners, Random& random)
{
  std::vector<std::int64_t> vertices(4 + random.pick(6));
  std::iota(vertices.begin(), vertices.end(), 0);
  std::vector<std::vector<std::int64_t>> cells(1 + random.pick(12));
  for (std::vector<std::int64_t>& cell : cells)
  {
    random.shuffle(vertices);
    const std::size_t count = 3 + random.pick(std::min(mostCorners, vertices.size()) - 2);
    cell.assign(vertices.begin(), vertices.begin() + static_cast<std::ptrdiff_t>(count));
  }
  return complexOf(cells, vertices.size());
}

/// What is found another way: the sides of each edge, by a map.
template <class Sides>
class ByMap
{
public:
  explicit ByMap(const Sides& ofCells)
    : sides(ofCells)
  {
    for (std::size_t i = 0; i < this->sides.size(); ++i)
    {
      const std::uint32_t side = this->sides.at(i);
      this->edges[std::minmax({ this->sides.origin(side), this->to(side) })].push_back(side);
    }
  }

  std::uint32_t to(std::uint32_t side) const { return this->sides.origin(this->sides.next(side)); }

  bool isTurned(const std::vector<std::uint32_t>& along) const
  {
    return along.size() == 2 && this->to(along[0]) == this->to(along[1]);
  }

  /// The side that follows around its origin, whose twin is the one before @p side; NoIndex: none.
  std::uint32_t following(std::uint32_t side) const
  {
    const std::uint32_t in = this->sides.previous(side);
    const auto& along = this->edges.at(std::minmax({ this->sides.origin(in), this->to(in) }));
    return along.size() != 2 || this->isTurned(along) ? NoIndex : along[along[0] == in ? 1 : 0];
  }

  void expectStar(const VertexStars<Sides>& stars, std::uint32_t v, const Star& star) const
  {
    std::vector<std::uint32_t> starts;
    std::vector<std::uint32_t> leaving;
    for (std::size_t i = 0; i < this->sides.size(); ++i)
    {
      if (this->sides.origin(this->sides.at(i)) == v)
      {
        leaving.push_back(this->sides.at(i));
      }
    }
    EXPECT_EQ(star.leaving, leaving);
    std::copy_if(leaving.begin(), leaving.end(), std::back_inserter(starts),
      [&](std::uint32_t side)
      {
        return std::none_of(leaving.begin(), leaving.end(),
          [&](std::uint32_t other) { return this->following(other) == side; });
      });
    std::vector<std::uint32_t> ring;
    const std::uint32_t first = leaving.empty() ? NoIndex
      : starts.empty()                          ? leaving.front()
                                                : starts.front();
    for (std::uint32_t side = first; side != NoIndex && (ring.empty() || side != first);
         side = this->following(side))
    {
      ring.push_back(side);
    }
    ASSERT_EQ(star.isFan(), !leaving.empty() && ring.size() == leaving.size());
    if (star.isFan())
    {
      EXPECT_EQ(star.ring, ring);
      EXPECT_EQ(star.isClosed, starts.empty());
      std::map<std::uint32_t, std::uint32_t> twins;
      for (const std::uint32_t side : leaving)
      {
        twins[this->sides.previous(side)] = this->following(side);
      }
      std::map<std::uint32_t, std::uint32_t> found;
      stars.eachTwin(star, [&](std::uint32_t side, std::uint32_t twin) { found[side] = twin; });
      EXPECT_EQ(found, twins);
    }
  }

  const Sides& sides;
  std::map<Ends, std::vector<std::uint32_t>> edges;
};

void expectFaults(const FaultyCells& found, const std::vector<std::uint32_t>& cells)
{
  EXPECT_EQ(found.count(), static_cast<std::int64_t>(cells.size()));
  EXPECT_EQ(found.first(), cells.empty() ? NoIndex : *std::min_element(cells.begin(), cells.end()));
}

template <class Sides>
void expectLinked(Sides ofCells)
{
  const VertexStars<Sides> stars(std::move(ofCells));
  const Sides& sides = stars.of();
  const ByMap<Sides> expected(sides);
  std::vector<std::uint32_t> crowded, open, turned;
  std::map<std::uint32_t, std::uint32_t> twin;
  for (const auto& [ends, along] : expected.edges)
  {
    const std::uint32_t cell = sides.cell(along[0]);
    for (const std::uint32_t side : along)
    {
      twin[side] = along.size() > 2 ? Unset
        : along.size() == 1         ? NoIndex
                                    : along[side == along[0] ? 1 : 0];
    }
    if (along.size() != 2 || expected.isTurned(along))
    {
      (along.size() == 1 ? open : along.size() > 2 ? crowded : turned).push_back(cell);
    }
  }
  auto edge = expected.edges.begin();
  stars.eachEdge(
    [&](const LinkedEdge& found)
    {
      ASSERT_NE(edge, expected.edges.end());
      EXPECT_EQ(Ends(found.low, found.high), edge->first);
      EXPECT_EQ(std::vector<std::uint32_t>(found.sides, found.sides + found.count), edge->second);
      EXPECT_EQ(found.isTurned, expected.isTurned(edge->second));
      ++edge;
    });
  EXPECT_EQ(edge, expected.edges.end());
  Star star;
  for (std::uint32_t v = 0; v < sides.vertexCount(); ++v)
  {
    stars.link(v, star);
    expected.expectStar(stars, v, star);
  }
  std::map<std::uint32_t, std::uint32_t> found;
  for (const auto& [side, other] : twin)
  {
    found[side] = Unset;
  }
  LinkFaults faults;
  linkTwins(
    stars, [] {}, [&](std::uint32_t side, std::uint32_t other) { found[side] = other; }, faults);
  EXPECT_EQ(found, twin);
  expectFaults(faults.crowded, crowded);
  expectFaults(faults.open, open);
  expectFaults(faults.turned, turned);
}

TEST(VertexStars, AnyPolygons)
{
  Random random(1);
  for (int i = 0; i < 2000 && !testing::Test::HasFailure(); ++i)
  {
    const CellComplex complex = anyCells(5, random);
    expectLinked(CellSides(complex));
  }
}

TEST(VertexStars, AnyTriangles)
{
  Random random(2);
  for (int i = 0; i < 2000 && !testing::Test::HasFailure(); ++i)
  {
    CellComplex complex = anyCells(3, random);
    std::vector<Triangle> triangles(complex.connectivity.size() / 3);
    for (std::size_t k = 0; k < complex.connectivity.size(); ++k)
    {
      triangles[k / 3].v[k % 3] = static_cast<std::uint32_t>(complex.connectivity[k]);
    }
    expectLinked(TriangleSides(triangles.data(), triangles.size(), complex.pointIds.size()));
    complex.cellSize = 3;
    expectLinked(CellSides(complex));
  }
}

TEST(VertexStars, WheelsOfManyCells)
{
  Random random(3);
  for (int i = 0; i < 200 && !testing::Test::HasFailure(); ++i)
  {
    const std::int64_t rim = random.integer(10, 60);
    std::vector<std::vector<std::int64_t>> cells;
    for (std::int64_t k = 0; k < rim; ++k)
    {
      cells.push_back({ 0, 1 + k, 1 + (k + 1) % rim });
    }
    random.shuffle(cells);
    cells.resize(cells.size() - random.pick(3)); // closed, open, or two fans
    if (random.pick(3) == 0)
    {
      cells.push_back(cells[random.pick(cells.size())]);
    }
    const CellComplex complex = complexOf(cells, static_cast<std::size_t>(rim) + 1);
    expectLinked(CellSides(complex));
  }
}

TEST(VertexStars, CellsOfAChainMeetInCorners)
{
  CellComplex chain = complexOf({ { 0, 2 }, { 1, 2 }, { 1, 3 } }, 5);
  chain.dimension = 1;
  const VertexStars<CellSides> stars{ CellSides(chain) };
  std::vector<std::uint32_t> twin(6, Unset);
  LinkFaults faults;
  linkTwins(
    stars, [] {}, [&](std::uint32_t side, std::uint32_t other) { twin[side] = other; }, faults);
  EXPECT_EQ(twin, (std::vector<std::uint32_t>{ NoIndex, 3, 4, 1, 2, NoIndex }));
  EXPECT_EQ(faults.crowded.count(), 0);
  EXPECT_EQ(faults.open.count(), 2);
}

}
}
}
