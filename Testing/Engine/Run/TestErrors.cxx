// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Bad input gets an Error that says what is wrong, where, and how often; what is left out changes
/// nothing else; and nothing but an Error leaves. What each call does with bad input is in
/// TestEveryCall.
#include "Support/EngineCall.h"
#include "Testing/Engine/Conformance/Kind.h"

#include <cerrno>
#include <cmath>
#include <limits>
#include <new>
#include <stdexcept>
#include <system_error>

namespace flipflop
{
namespace test
{

namespace
{

class ErrorsOf : public ::testing::TestWithParam<FamilyOf>
{
};

TEST_P(ErrorsOf, IgnoredNonFinitePointsChangeNothingElse)
{
  const FamilyOf& of = this->GetParam();
  const Cloud clean = of.kind->family(of.name, of.count, 19).make();
  Random random(20);
  std::vector<std::int64_t> names;
  const Cloud dirty = withNonFinite(clean, random, names);
  const auto bad = static_cast<std::int64_t>(dirty.size() - clean.size());
  std::vector<Cell> wanted = of.kind->cgal(clean).cells;
  for (Cell& cell : wanted)
  {
    for (std::int64_t& id : cell)
    {
      id = names[static_cast<std::size_t>(id)];
    }
  }
  std::int64_t first = 0;
  while (first < static_cast<std::int64_t>(names.size()) && names[first] == first)
  {
    ++first;
  }
  for (const int threads : { 1, 2, 4 })
  {
    Options options;
    options.threads = threads;
    options.facets = FacetMode::Polygons;
    if (bad > 0)
    {
      expectError([&] { of.kind->run(dirty, options); }, ErrorCode::NonFinite, first, bad);
    }
    options.nonFinite = NonFinitePolicy::Ignore;
    const Result found = of.kind->run(dirty, options);
    EXPECT_EQ(cellsOf(complexOf(found)), wanted);
    EXPECT_EQ(complexOf(found).statistics.nonFinite, bad);
    EXPECT_TRUE(validate(dirty, found));
  }
}

INSTANTIATE_TEST_SUITE_P(ConvexHull, ErrorsOf,
  ::testing::ValuesIn(
    familiesOf(convexHulls, { "ball", "shell1e2" }, { 1, 2, 8, 100, 3000, 20000 })),
  Named());
INSTANTIATE_TEST_SUITE_P(RegularTriangulation, ErrorsOf,
  ::testing::ValuesIn(familiesOf(regularTriangulations,
    { "uniformHeavy", "smallIntegers", "lineAlongX" }, { 1, 2, 8, 60, 800, 12000 })),
  Named());

TEST(Errors, NonFiniteWhereAllPointsAreBad)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Kind* kind : { &convexHulls, &regularTriangulations })
  {
    for (const int count : { 1, 4, 7000 })
    {
      const Cloud cloud(static_cast<std::size_t>(count), Point{ nan, 0, HUGE_VAL });
      Options options;
      expectError([&] { kind->run(cloud, options); }, ErrorCode::NonFinite, 0, count);
      options.nonFinite = NonFinitePolicy::Ignore;
      const Result none = kind->run(cloud, options);
      EXPECT_EQ(complexOf(none).dimension, -1);
      EXPECT_EQ(complexOf(none).statistics.nonFinite, count);
      EXPECT_TRUE(validate(cloud, none));
    }
  }
}

TEST(Errors, OnePointHasAnyStride)
{
  // No address behind it is formed: UBSan watches this.
  const double data[] = { 1, 2, 3 };
  const float floats[] = { 1, 2, 3 };
  EXPECT_EQ(convexHull(PointView(data, 1, INT64_MAX)).dimension, 0);
  EXPECT_EQ(convexHull(PointView(floats, 1, INT64_MAX)).dimension, 0);
}

TEST(Errors, TooManyPointsBeforeAnythingIsRead)
{
  // Nobody may follow this pointer.
  const double* dummy = reinterpret_cast<const double*>(static_cast<std::uintptr_t>(8));
  const std::int64_t limit = (std::int64_t(1) << 32) - 2;
  for (std::int64_t count : { limit + 1, 2 * limit, std::numeric_limits<std::int64_t>::max() })
  {
    const PointView points(dummy, count);
    const ErrorCode code = ErrorCode::TooManyPoints;
    expectError([&] { convexHull(points); }, code, -2, count);
    expectError([&] { regularTriangulation(points); }, code, -2, count);
    expectError([&] { regularTriangulation(points, WeightView(dummy, count)); }, code, -2, count);
  }
}

TEST(Errors, WordsForEveryCode)
{
  std::vector<std::string> words;
  for (int code = static_cast<int>(ErrorCode::NonFinite);
       code <= static_cast<int>(ErrorCode::Internal); ++code)
  {
    const Error error(static_cast<ErrorCode>(code), 3, 5);
    EXPECT_EQ(static_cast<int>(error.code()), code);
    EXPECT_EQ(error.index(), 3);
    EXPECT_EQ(error.count(), 5);
    words.emplace_back(error.what());
    EXPECT_NE(words.back(), "unknown error");
  }
  EXPECT_GE(words.size(), 23u);
  std::sort(words.begin(), words.end());
  EXPECT_EQ(std::unique(words.begin(), words.end()), words.end());
}

TEST(Errors, WhateverIsThrownLeavesAsAnError)
{
  const auto expectCode = [](auto thrown, ErrorCode code, std::int64_t index = -2)
  { expectError([&] { engineCall([&]() -> int { throw thrown; }); }, code, index); };
  expectCode(Error(ErrorCode::NotClosed, 3, 5), ErrorCode::NotClosed, 3);
  expectCode(std::bad_alloc(), ErrorCode::OutOfMemory);
  expectCode(std::bad_array_new_length(), ErrorCode::OutOfMemory);
  expectCode(std::length_error("too long"), ErrorCode::OutOfMemory);
  expectCode(std::system_error(EAGAIN, std::generic_category()), ErrorCode::Internal);
  expectCode(std::runtime_error("of the threads' library"), ErrorCode::Internal);
  expectCode(7, ErrorCode::Internal);
}

TEST(Errors, BufferRefusesWhatNoMemoryHolds)
{
  expectError(
    [] { Buffer<double>(std::numeric_limits<std::size_t>::max() / 4); }, ErrorCode::OutOfMemory);
}

}
}
}
