// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Bad input gets an Error that says what is wrong, where, and how often.
#include "Support/EngineCall.h"
#include "Testing/Engine/Conformance/Kind.h"

#include <cerrno>
#include <functional>
#include <limits>
#include <new>
#include <optional>
#include <stdexcept>
#include <system_error>

namespace flipflop
{
namespace test
{

namespace
{

const double nan = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

Options withThreads(int threads)
{
  Options options;
  options.threads = threads;
  return options;
}

std::string nameAndCount(const ::testing::TestParamInfo<FamilyOf>& given)
{
  return given.param.name + "_" + std::to_string(given.param.count);
}

class ErrorsOf : public ::testing::TestWithParam<FamilyOf>
{
};

/// In every chunk of a scan on several threads.
TEST_P(ErrorsOf, NonFiniteNamesTheFirstAndCountsAll)
{
  const FamilyOf& of = this->GetParam();
  const Cloud good = of.kind->family(of.name, of.count, 17).make();
  for (const int threads : { 1, 2, 4 })
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      Cloud cloud = good;
      const std::size_t first = good.size() / 3;
      const std::size_t last = good.size() - 1;
      const auto expect = [&](std::int64_t count)
      {
        expectError([&] { of.kind->run(cloud, withThreads(threads)); }, ErrorCode::NonFinite,
          static_cast<std::int64_t>(first), count);
      };
      cloud[first][axis] = nan;
      expect(1);
      cloud[last] = { infinity, infinity, infinity };
      expect(first == last ? 1 : 2);
    }
  }
}

TEST_P(ErrorsOf, IgnoredNonFinitePointsChangeNothingElse)
{
  const FamilyOf& of = this->GetParam();
  const Cloud clean = of.kind->family(of.name, of.count, 19).make();
  Random random(20);
  std::vector<std::int64_t> names;
  const Cloud dirty = withNonFinite(clean, random, names);
  ReferenceHull wanted = of.kind->cgal(clean);
  const auto rename = [&](std::vector<std::int64_t>& ids)
  {
    for (std::int64_t& id : ids)
    {
      id = names[static_cast<std::size_t>(id)];
    }
  };
  rename(wanted.ids);
  std::for_each(wanted.cells.begin(), wanted.cells.end(), rename);
  for (const int threads : { 1, 2, 4 })
  {
    Options options = withThreads(threads);
    options.nonFinite = NonFinitePolicy::Ignore;
    options.facets = FacetMode::Polygons;
    const Result found = of.kind->run(dirty, options);
    EXPECT_EQ(cellsOf(complexOf(found)), wanted.cells);
    EXPECT_EQ(complexOf(found).statistics.nonFinite,
      static_cast<std::int64_t>(dirty.size() - clean.size()));
    EXPECT_TRUE(validate(dirty, found));
  }
}

INSTANTIATE_TEST_SUITE_P(ConvexHull, ErrorsOf,
  ::testing::ValuesIn(
    familiesOf(convexHulls, { "ball", "shell1e2" }, { 1, 2, 8, 100, 3000, 20000 })),
  nameAndCount);
INSTANTIATE_TEST_SUITE_P(RegularTriangulation, ErrorsOf,
  ::testing::ValuesIn(familiesOf(regularTriangulations,
    { "uniformHeavy", "smallIntegers", "lineAlongX" }, { 1, 2, 8, 60, 800, 12000 })),
  nameAndCount);

TEST(Errors, NonFiniteWhereAllPointsAreBad)
{
  for (const Kind* kind : { &convexHulls, &regularTriangulations })
  {
    for (const int count : { 1, 4, 7000 })
    {
      const Cloud cloud(static_cast<std::size_t>(count), Point{ nan, 0, infinity });
      expectError([&] { kind->run(cloud, withThreads(2)); }, ErrorCode::NonFinite, 0, count);
      Options options = withThreads(2);
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
  const ErrorCode codes[] = { ErrorCode::NonFinite, ErrorCode::TooManyPoints,
    ErrorCode::OutOfMemory, ErrorCode::Aborted, ErrorCode::BadArgument, ErrorCode::WeightCount,
    ErrorCode::BadTriangle, ErrorCode::NotSimple, ErrorCode::NotClosed, ErrorCode::NotManifold,
    ErrorCode::NotOriented, ErrorCode::NotStarShaped, ErrorCode::NoKernel,
    ErrorCode::ConstraintPoint, ErrorCode::ConstraintsCross, ErrorCode::PolygonsDisagree,
    ErrorCode::NotConvex, ErrorCode::DuplicateSites, ErrorCode::BadArea, ErrorCode::NoDevice,
    ErrorCode::DeviceMemory, ErrorCode::DeviceFailed, ErrorCode::Internal };
  std::vector<std::string> words;
  for (ErrorCode code : codes)
  {
    const Error error(code, 3, 5);
    EXPECT_EQ(error.code(), code);
    EXPECT_EQ(error.index(), 3);
    EXPECT_EQ(error.count(), 5);
    words.push_back(error.what());
    EXPECT_NE(words.back(), "unknown error");
  }
  std::sort(words.begin(), words.end());
  EXPECT_EQ(std::unique(words.begin(), words.end()), words.end());
}

/// The code of the Error that leaves; none where another exception does, or nothing is thrown.
std::optional<ErrorCode> codeOf(const std::function<void()>& work)
{
  try
  {
    work();
  }
  catch (const Error& error)
  {
    return error.code();
  }
  catch (...)
  {
    ADD_FAILURE() << "what leaves is no Error";
  }
  return std::nullopt;
}

TEST(Errors, WhateverIsThrownLeavesAsAnError)
{
  const auto codeFrom = [](auto thrown)
  { return codeOf([&] { engineCall([&]() -> int { throw thrown; }); }); };
  EXPECT_EQ(codeFrom(Error(ErrorCode::NotClosed)), ErrorCode::NotClosed);
  EXPECT_EQ(codeFrom(std::bad_alloc()), ErrorCode::OutOfMemory);
  EXPECT_EQ(codeFrom(std::bad_array_new_length()), ErrorCode::OutOfMemory);
  EXPECT_EQ(codeFrom(std::length_error("too long")), ErrorCode::OutOfMemory);
  EXPECT_EQ(codeFrom(std::system_error(EAGAIN, std::generic_category())), ErrorCode::Internal);
  EXPECT_EQ(codeFrom(std::runtime_error("of the threads' library")), ErrorCode::Internal);
  EXPECT_EQ(codeFrom(7), ErrorCode::Internal);
  // The place at fault is kept.
  try
  {
    engineCall([]() -> int { throw Error(ErrorCode::NotManifold, 3, 5); });
    ADD_FAILURE() << "no error";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.index(), 3);
    EXPECT_EQ(error.count(), 5);
  }
}

TEST(Errors, BufferRefusesWhatNoMemoryHolds)
{
  try
  {
    const Buffer<double> buffer(std::numeric_limits<std::size_t>::max() / 4);
    FAIL() << "no error";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.code(), ErrorCode::OutOfMemory);
  }
}

}
}
}
