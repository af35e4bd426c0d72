// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The oracle is put to the test: what the references say passes, on both kinds of results; and
/// nothing else does.
#include "Testing/Engine/Inputs/InputsWeighted.h"
#include "Testing/Engine/Validate/ValidateClaims.h"

#include <algorithm>
#include <limits>
#include <set>

namespace flipflop
{
namespace test
{

namespace
{

class Validates : public ::testing::TestWithParam<const Kind*>
{
protected:
  const Kind& kind() const { return *this->GetParam(); }
  /// Without weights that hide, nor flat facets.
  Cloud general(int count, std::uint64_t seed) const
  {
    return this->kind()
      .family(this->kind().dimension == 3 ? "shell0" : "uniform", count, seed)
      .make();
  }
  Cloud grid() const { return this->kind().dimension == 3 ? integerGrid(3) : squareGrid(3); }
  Fault faultOfCells(const Cloud& cloud, int dimension, const std::vector<Cell>& cells,
    FacetMode facets = FacetMode::Polygons) const
  {
    return validationOf(cloud, claimOf(this->kind(), cloud, dimension, cells, facets)).fault;
  }
  /// Small, of integers, with many ties and duplicates.
  Cloud integers(Random& random, int most, int side) const
  {
    const int count = random.integer(1, most);
    return this->kind().dimension == 3 ? smallIntegerSites(count, 0, side, 0, side, random)
                                       : smallIntegerSites(count, 0, side + 1, -2, 3, random);
  }
};

TEST_P(Validates, WhatReferencesSay)
{
  const Kind& kind = this->kind();
  const auto expectNone = [&](const Cloud& cloud, const ReferenceHull& reference)
  {
    for (const FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
    {
      EXPECT_EQ(
        validationOf(cloud, makeResult(kind, reference, cloud.size(), facets)).fault, Fault::None);
    }
  };
  for (const Input& input : kind.smallInputs())
  {
    SCOPED_TRACE(input.name);
    expectNone(input.make(), kind.bruteForce(input.make()));
  }
  for (const Family& family : kind.families())
  {
    for (const int count : { 0, 1, 2, 3, 10, 3000 })
    {
      const Input input = kind.family(family.name, effort(count), 3);
      SCOPED_TRACE(input.name + ", seed 3");
      expectNone(input.make(), kind.cgal(input.make()));
    }
  }
}

TEST_P(Validates, LeavesOutNonFinitePoints)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const Cloud grid = this->grid();
  const Cloud cloud = joined(grid, { { infinity, 0, 0 }, { 0, 0, -infinity }, { 7, NAN, 0 } });
  const ReferenceHull reference = this->kind().bruteForce(grid);
  const auto faultOfMany = [&](std::size_t points)
  {
    return validationOf(cloud, makeResult(this->kind(), reference, points, FacetMode::Polygons))
      .fault;
  };
  EXPECT_EQ(faultOfMany(grid.size()), Fault::None);
  if (this->kind().dimension == 2) // they are not hidden either
  {
    EXPECT_NE(faultOfMany(grid.size() + 3), Fault::None);
    EXPECT_NE(faultOfMany(grid.size() + 1), Fault::None);
  }
}

TEST_P(Validates, NoChangeOfARightResult)
{
  // Whatever is changed in a right answer makes it wrong: there is one right answer.
  std::set<Fault> seen;
  for (int i = 0; i < effort(20000); ++i)
  {
    Random random(static_cast<std::uint64_t>(i));
    const Cloud cloud = this->integers(random, 14, 3);
    const int count = static_cast<int>(cloud.size());
    const FacetMode facets = random.integer(0, 1) ? FacetMode::Polygons : FacetMode::Triangles;
    const Result right =
      makeResult(this->kind(), this->kind().bruteForce(cloud), cloud.size(), facets);
    Result changed = clone(right);
    CellComplex& other = cellsIn(changed);
    auto* triangulation = std::get_if<Triangulation>(&changed);
    Buffer<std::int64_t>& hidden = triangulation ? triangulation->hiddenIds : other.pointIds;
    const auto any = [&](Buffer<std::int64_t>& values) -> std::int64_t&
    {
      static std::int64_t none;
      return values.empty() ? none : values[random.integer(0, static_cast<int>(values.size()) - 1)];
    };
    for (int changes = random.integer(1, 3); changes > 0; --changes)
    {
      const int value = random.integer(-1, count);
      switch (random.integer(0, 8))
      {
        case 0:
          std::swap(any(other.connectivity), any(other.connectivity));
          break;
        case 1:
          any(other.connectivity) = value;
          break;
        case 2:
          any(other.pointIds) = value;
          break;
        case 3:
          any(hidden) = value;
          break;
        case 4:
          std::swap(any(other.pointIds), any(hidden));
          break;
        case 5:
          any(other.offsets) += random.integer(-1, 1);
          break;
        case 6:
          other.connectivity.truncate(
            other.connectivity.size() - std::min<std::size_t>(3, other.connectivity.size()));
          break;
        case 7:
          hidden.truncate(hidden.size() - std::min<std::size_t>(1, hidden.size()));
          break;
        default:
          other.dimension = random.integer(-2, 4);
          break;
      }
    }
    const Validation valid = validate(cloud, changed, 1);
    ASSERT_EQ(valid.fault == Fault::None, bitDifference(right, changed).empty())
      << "case " << i << ": " << describe(valid.fault) << "\n"
      << toString(cloud);
    seen.insert(valid.fault);
  }
  EXPECT_GE(seen.size(), 5u);
}

TEST_P(Validates, NoResultOfAnotherCloud)
{
  for (int i = 0; i < effort(20000); ++i)
  {
    Random random(static_cast<std::uint64_t>(i));
    const Cloud cloud = this->integers(random, 10, 2);
    const int count = static_cast<int>(cloud.size());
    Cloud other = cloud;
    for (int changes = random.integer(1, 3); changes > 0; --changes)
    {
      other[static_cast<std::size_t>(random.integer(0, count - 1))]
           [random.integer(0, 5) == 0 ? 0 : 2] += random.integer(-2, 2);
    }
    const FacetMode facets = random.integer(0, 1) ? FacetMode::Polygons : FacetMode::Triangles;
    const auto made = [&](const Cloud& of)
    { return makeResult(this->kind(), this->kind().bruteForce(of), cloud.size(), facets); };
    const Result right = made(cloud);
    const Result wrong = made(other);
    const Validation valid = validate(cloud, wrong, 1);
    ASSERT_EQ(valid.fault == Fault::None, bitDifference(right, wrong).empty())
      << "case " << i << ": " << describe(valid.fault) << "\n"
      << toString(cloud) << "with the answer for\n"
      << toString(other);
  }
}

/// The same of many points, of every family: one that appears is moved to where another is.
TEST_P(Validates, NoResultOfAnotherCloudOfAnyFamily)
{
  for (const Family& family : this->kind().families())
  {
    SCOPED_TRACE(family.name);
    Cloud cloud = this->kind().family(family.name, 300, 1).make();
    const ReferenceHull reference = this->kind().cgalBy(cloud, CgalKernel::Rational);
    const auto fault = [&]
    {
      return validationOf(
        cloud, makeResult(this->kind(), reference, cloud.size(), FacetMode::Triangles))
        .fault;
    };
    EXPECT_EQ(fault(), Fault::None);
    const std::size_t at = reference.ids.size() / 3;
    cloud[static_cast<std::size_t>(reference.ids[at])] =
      cloud[static_cast<std::size_t>(reference.ids[at + 1])];
    EXPECT_NE(fault(), Fault::None);
  }
}

TEST_P(Validates, NoCellMissingTwiceTurnedOrFlipped)
{
  const int dimension = this->kind().dimension;
  const Cloud cloud = this->general(60, 7);
  const std::vector<Cell> all = this->kind().cgal(cloud).cells;
  const auto expectFault = [&](const std::vector<Cell>& cells, Fault name = Fault::None)
  {
    for (const FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
    {
      const Fault fault = this->faultOfCells(cloud, dimension, cells, facets);
      EXPECT_NE(fault, Fault::None);
      EXPECT_TRUE(name == Fault::None || fault == name) << describe(fault);
    }
  };
  int flipped = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    std::vector<Cell> cells = all;
    cells.insert(cells.begin() + static_cast<std::ptrdiff_t>(i), cells[i]);
    expectFault(cells);
    cells = all;
    std::swap(cells[i][1], cells[i][2]);
    expectFault(cells);
    cells = all;
    cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(i));
    expectFault(cells, dimension == 3 ? Fault::NotClosed : Fault::None);
    for (std::size_t e = 0; e < 9; ++e)
    {
      const std::int64_t a = all[i][e % 3], b = all[i][(e + 1) % 3], c = all[i][(e + 2) % 3];
      for (std::size_t j = i + 1; j < all.size(); ++j)
      {
        const Cell& t = all[j];
        if (t[e / 3] == b && t[(e / 3 + 1) % 3] == a)
        {
          const std::int64_t d = t[(e / 3 + 2) % 3];
          cells = all;
          cells[i] = { c, a, d };
          cells[j] = { d, b, c };
          expectFault(cells); // of any name: c and d may be neighbours already
          ++flipped;
        }
      }
    }
  }
  EXPECT_GT(flipped, 60);
  std::vector<Cell> turned = all;
  for (Cell& cell : turned)
  {
    std::swap(cell[1], cell[2]);
  }
  EXPECT_EQ(this->faultOfCells(cloud, dimension, turned), Fault::NotConvex);
}

TEST_P(Validates, PointOutsideIsNamed)
{
  // The result without one of its points.
  const bool isHull = this->kind().dimension == 3;
  int tried = 0;
  for (const char* name : { isHull ? "shell0" : "uniformHeavy", isHull ? "ball" : "uniform",
         "far15", isHull ? "thin200" : "clusters" })
  {
    const Cloud cloud = this->kind().family(name, 300, 9).make();
    const ReferenceHull whole = this->kind().cgalBy(cloud, CgalKernel::Rational);
    for (std::size_t k = 0; k < whole.ids.size(); k += 1 + whole.ids.size() / 9)
    {
      const auto gone = static_cast<std::size_t>(whole.ids[k]);
      Cloud less = cloud;
      if (isHull)
      {
        less[gone] = cloud[static_cast<std::size_t>(whole.ids[k == 0 ? 1 : 0])];
      }
      else
      {
        less[gone][2] = -1e30;
      }
      const ReferenceHull part = this->kind().cgalBy(less, CgalKernel::Rational);
      if (std::count(part.ids.begin(), part.ids.end(), whole.ids[k]) > 0 ||
        part.ids.size() == whole.ids.size() || lowestIds(cloud)[gone] != whole.ids[k])
      {
        continue; // a corner of the border, or another one took its place
      }
      ++tried;
      for (const FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
      {
        const Validation valid =
          validationOf(cloud, makeResult(this->kind(), part, cloud.size(), facets));
        EXPECT_EQ(valid.fault, Fault::PointOutside) << name;
        EXPECT_EQ(valid.index, whole.ids[k]) << name;
      }
    }
  }
  EXPECT_GT(tried, 8);
}

TEST_P(Validates, BrokenStructureIsNamed)
{
  const std::int64_t least = std::numeric_limits<std::int64_t>::min();
  const auto expectStructure = [&](const Cloud& cloud, const Result& right,
                                 const std::vector<std::function<void(CellComplex&)>>& changes)
  {
    ASSERT_EQ(validationOf(cloud, right).fault, Fault::None);
    for (std::size_t i = 0; i < changes.size(); ++i)
    {
      Result copy = clone(right);
      changes[i](cellsIn(copy));
      EXPECT_EQ(validationOf(cloud, copy).fault, Fault::Structure) << "change " << i;
    }
  };
  const Cloud cloud = this->general(200, 5);
  const Result triangles =
    makeResult(this->kind(), this->kind().cgal(cloud), cloud.size(), FacetMode::Triangles);
  const auto points = static_cast<std::int64_t>(complexOf(triangles).pointIds.size());
  std::vector<std::function<void(CellComplex&)>> changes = { [](CellComplex& h)
    { std::swap(h.pointIds[1], h.pointIds[2]); },
    [](CellComplex& h) { h.pointIds[3] = h.pointIds[2]; },
    [](CellComplex& h) { std::rotate(&h.connectivity[6], &h.connectivity[7], &h.connectivity[9]); },
    [](CellComplex& h)
    { std::swap_ranges(&h.connectivity[3], &h.connectivity[6], &h.connectivity[6]); },
    [](CellComplex& h) { h.connectivity.truncate(h.connectivity.size() - 1); },
    [](CellComplex& h) { h.cellSize = -3; }, [](CellComplex& h) { h.dimension = 4; },
    [](CellComplex& h) { h.dimension = -2; } };
  for (const std::int64_t bad : { std::int64_t(-1), points, std::int64_t(1) << 40, least })
  {
    changes.emplace_back([=](CellComplex& h) { h.connectivity[4] = bad; });
  }
  for (const std::int64_t bad : { std::int64_t(-1), std::int64_t(200), std::int64_t(1) << 40 })
  {
    changes.emplace_back([=](CellComplex& h) { h.pointIds[points - 1] = bad; });
  }
  expectStructure(cloud, triangles, changes);
  const Cloud grid = this->grid();
  expectStructure(grid,
    makeResult(this->kind(), this->kind().bruteForce(grid), grid.size(), FacetMode::Polygons),
    { [](CellComplex& h) { h.offsets[0] = 1; }, [](CellComplex& h) { h.offsets[2] = 30; },
      [](CellComplex& h) { h.offsets[1] = -4; },
      [](CellComplex& h) { h.offsets[h.offsets.size() - 1] += 4; },
      [](CellComplex& h) { h.offsets[h.offsets.size() - 1] -= 1; },
      [](CellComplex& h) { h.offsets[1] = 0; }, [](CellComplex& h) { h.offsets[1] = 2; } });
}

INSTANTIATE_TEST_SUITE_P(ConvexHull, Validates, ::testing::Values(&convexHulls));
INSTANTIATE_TEST_SUITE_P(
  RegularTriangulation, Validates, ::testing::Values(&regularTriangulations));

}
}
}
