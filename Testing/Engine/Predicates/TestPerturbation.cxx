// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Simulation of Simplicity against what it simulates: points really moved by powers of a small
// number.
#include "Testing/Engine/Predicates/PredicateCases.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace flipflop;
using namespace flipflop::test;

namespace
{

constexpr unsigned Seed = 20260201;

/// Row of a point whose coordinate j is moved by e^(2^(3 rank + j)), e = 2^-40: for coordinates of
/// a few bits the first term that does not vanish outweighs all later ones.
Row4 movedRow(const Vertex& v, int rank)
{
  Row4 row = rowOf(v);
  for (int j = 0; j < 3; ++j)
  {
    row[j] += mpq_class(1, mpz_class(1) << (40u << (3 * rank + j)));
  }
  return row;
}

std::vector<Vertex> smallIntegers(std::mt19937_64& random, int count, unsigned limit)
{
  std::vector<std::uint32_t> ids;
  for (int i = 0; i < count; ++i)
  {
    ids.push_back(static_cast<std::uint32_t>(10 * i + random() % 10));
  }
  std::shuffle(ids.begin(), ids.end(), random);
  std::vector<Vertex> v;
  for (const std::uint32_t id : ids)
  {
    v.push_back(makeVertex(static_cast<double>(random() % limit),
      static_cast<double>(random() % limit), static_cast<double>(random() % limit), id));
  }
  return v;
}

std::vector<int> ranksOf(const std::vector<Vertex>& v)
{
  std::vector<int> ranks;
  for (const Vertex& p : v)
  {
    ranks.push_back(static_cast<int>(
      std::count_if(v.begin(), v.end(), [&p](const Vertex& other) { return other.id < p.id; })));
  }
  return ranks;
}

}

TEST(Perturbation, AboveIsTheSignOfTheMovedPoints)
{
  SCOPED_TRACE(Seed);
  std::mt19937_64 random(Seed);
  int degenerate = 0;
  for (int i = 0; i < 1500; ++i)
  {
    std::vector<Vertex> v = smallIntegers(random, 4, 1 + i % 3);
    const std::vector<int> rank = ranksOf(v);
    Row4 row[4];
    for (int k = 0; k < 4; ++k)
    {
      row[k] = movedRow(v[k], rank[k]);
    }
    const int wanted = -sgn(det4(row[0], row[1], row[2], row[3]));
    const HullGeometry geometry = geometryOf(v);
    ASSERT_NE(wanted, 0);
    ASSERT_EQ(geometry.perturbedAbove(v[0], v[1], v[2], v[3]), wanted) << "case " << i;
    ASSERT_EQ(geometry.perturbedAbove(v[2], v[1], v[0], v[3]), -wanted) << "case " << i;
    ASSERT_EQ(geometry.perturbedAbove(v[2], v[3], v[0], v[1]), wanted) << "case " << i;
    degenerate += geometry.above(v[0], v[1], v[2], v[3]) == 0 ? 1 : 0;
  }
  EXPECT_GT(degenerate, 500);
}

TEST(Perturbation, TheKernelIsNotMoved)
{
  SCOPED_TRACE(Seed + 1);
  std::mt19937_64 random(Seed + 1);
  for (int i = 0; i < 1500; ++i)
  {
    std::vector<Vertex> v = smallIntegers(random, 3, 1 + i % 3);
    const std::vector<int> rank = ranksOf(v);
    const Vertex s = makeVertex(static_cast<double>(random() % 3),
      static_cast<double>(random() % 3), static_cast<double>(random() % 3), 0);
    const Row4 row[3] = { movedRow(v[0], rank[0]), movedRow(v[1], rank[1]),
      movedRow(v[2], rank[2]) };
    const int wanted = sgn(det4(row[0], row[1], row[2], rowOf(s)));
    HullGeometry geometry = geometryOf(v);
    geometry.setKernel(s.x);
    ASSERT_EQ(geometry.perturbedKernelBeneath(v[0], v[1], v[2]), wanted) << "case " << i;
    ASSERT_EQ(geometry.perturbedKernelBeneath(v[1], v[0], v[2]), -wanted) << "case " << i;
  }
}

TEST(Perturbation, NorIsTheSymbolicKernel)
{
  SCOPED_TRACE(Seed + 2);
  std::mt19937_64 random(Seed + 2);
  for (int i = 0; i < 500; ++i)
  {
    std::vector<Vertex> v = smallIntegers(random, 3, 1 + i % 3);
    std::vector<Vertex> corner = smallIntegers(random, 4, 3);
    const std::vector<int> rank = ranksOf(v);
    Row4 s = { 0, 0, 0, 4 };
    for (const Vertex& c : corner)
    {
      for (int k = 0; k < 3; ++k)
      {
        s[k] += mpq_class(c.x[k]);
      }
    }
    const Row4 row[3] = { movedRow(v[0], rank[0]), movedRow(v[1], rank[1]),
      movedRow(v[2], rank[2]) };
    HullGeometry geometry = geometryOf(v);
    geometry.setSymbolicKernel(corner.data());
    ASSERT_EQ(
      geometry.perturbedKernelBeneath(v[0], v[1], v[2]), sgn(det4(row[0], row[1], row[2], s)))
      << "case " << i;
  }
}
