// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Bad input gets an Error that says what is wrong, where, and how often.
#include "Support/TypedErrors.h"
#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/Inputs/Inputs.h"
#include "Testing/Engine/Inputs/Surfaces.h"
#include <flipflop/FlipFlop.h>
#include <flipflop/PowerDiagram.h>
#include <flipflop/RegularTriangulation.h>

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

void expectError(const PointView& view, const Options& options, ErrorCode code,
  std::int64_t index = -2, std::int64_t count = -2)
{
  test::expectError([&] { convexHull(view, options); }, code, index, count);
}

Options withThreads(int threads)
{
  Options options;
  options.threads = threads;
  return options;
}

TEST(Errors, NonFiniteNamesTheFirstAndCountsAll)
{
  for (int count : { 1, 2, 5, 100, 3000, 50000 })
  {
    const Cloud good = fromFamily("ball", count, 17).make();
    for (int threads : { 1, 2, 4 })
    {
      for (double bad : { nan, -nan, infinity, -infinity })
      {
        Cloud cloud = good;
        const int first = count / 3;
        cloud[first][count % 3] = bad;
        expectError(viewOf(cloud), withThreads(threads), ErrorCode::NonFinite, first, 1);
        // A point with three bad coordinates is one bad point.
        cloud[count - 1] = { bad, bad, bad };
        expectError(viewOf(cloud), withThreads(threads), ErrorCode::NonFinite, first,
          first == count - 1 ? 1 : 2);
      }
    }
  }
}

TEST(Errors, NonFiniteInFloats)
{
  std::vector<float> floats = floatsOf(fromFamily("ball", 1000, 18).make());
  floats[3 * 640 + 2] = std::numeric_limits<float>::infinity();
  floats[3 * 900 + 1] = std::numeric_limits<float>::quiet_NaN();
  for (int threads : { 1, 2 })
  {
    expectError(PointView(floats.data(), 1000), withThreads(threads), ErrorCode::NonFinite, 640, 2);
  }
}

TEST(Errors, NonFiniteWhereAllPointsAreBad)
{
  for (int count : { 1, 4, 7000 })
  {
    const Cloud cloud(static_cast<std::size_t>(count), Point{ nan, 0, infinity });
    expectError(viewOf(cloud), withThreads(2), ErrorCode::NonFinite, 0, count);
    Options options = withThreads(2);
    options.nonFinite = NonFinitePolicy::Ignore;
    const Hull hull = convexHull(viewOf(cloud), options);
    EXPECT_EQ(hull.dimension, -1);
    EXPECT_EQ(hull.cellCount(), 0);
    EXPECT_TRUE(hull.pointIds.empty());
    EXPECT_EQ(hull.statistics.nonFinite, count);
    EXPECT_EQ(hull.statistics.points, count);
  }
}

TEST(Errors, IgnoredNonFinitePointsChangeNothingElse)
{
  for (int count : { 8, 60, 800, 20000 })
  {
    const Cloud clean = fromFamily("shell1e2", count, 19).make();
    Random random(20);
    std::vector<std::int64_t> names;
    const Cloud dirty = withNonFinite(clean, random, names);
    const auto bad = static_cast<std::int64_t>(dirty.size() - clean.size());
    const ReferenceHull reference = cgalHull(clean);
    std::vector<Cell> wanted = reference.cells;
    for (Cell& cell : wanted)
    {
      for (std::int64_t& id : cell)
      {
        id = names[id];
      }
    }
    for (int threads : { 1, 2, 4 })
    {
      Options options = withThreads(threads);
      options.nonFinite = NonFinitePolicy::Ignore;
      options.facets = FacetMode::Polygons;
      const Hull hull = convexHull(viewOf(dirty), options);
      EXPECT_EQ(cellsOf(hull), wanted) << count << " points, seeds 19 and 20";
      EXPECT_EQ(hull.statistics.nonFinite, bad);
      EXPECT_TRUE(validate(viewOf(dirty), hull));
    }
  }
}

TEST(Errors, IgnoreCountsNothingOnCleanInput)
{
  Options options;
  options.nonFinite = NonFinitePolicy::Ignore;
  const Cloud cloud = integerGrid(3);
  const Hull hull = convexHull(viewOf(cloud), options);
  EXPECT_EQ(hull.statistics.nonFinite, 0);
  EXPECT_EQ(difference(hull, bruteForceHull(cloud), FacetMode::Triangles), "");
}

TEST(Errors, NonFiniteBetweenThePointsIsNotLookedAt)
{
  const double data[] = { 0, 0, 0, nan, 1, 0, 0, infinity, 0, 1, 0, nan, 0, 0, 1, nan };
  const Hull hull = convexHull(PointView(data, 4, 4));
  EXPECT_EQ(hull.cellCount(), 4);
}

TEST(Errors, TheLastPointEndsTheArray)
{
  // With a stride of 5 the last point's padding need not exist: ASan watches this.
  std::vector<double> data(5 * 3 + 3);
  const Cloud corners = latticeTetrahedron(2);
  for (std::size_t i = 0; i < 4; ++i)
  {
    std::copy(corners[i].begin(), corners[i].end(), data.begin() + 5 * static_cast<int>(i));
  }
  EXPECT_EQ(convexHull(PointView(data.data(), 4, 5)).cellCount(), 4);
  const std::vector<float> floats(data.begin(), data.end());
  EXPECT_EQ(convexHull(PointView(floats.data(), 4, 5)).cellCount(), 4);
}

TEST(Errors, OnePointHasAnyStride)
{
  // No address behind it is formed: UBSan watches this.
  const double data[] = { 1, 2, 3 };
  const float floats[] = { 1, 2, 3 };
  EXPECT_EQ(convexHull(PointView(data, 1, INT64_MAX)).dimension, 0);
  EXPECT_EQ(convexHull(PointView(floats, 1, INT64_MAX)).dimension, 0);
}

TEST(Errors, BadArguments)
{
  const double data[] = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1 };
  const Options options;
  expectError(PointView(static_cast<const double*>(nullptr), 4), options, ErrorCode::BadArgument);
  expectError(PointView(static_cast<const float*>(nullptr), 1), options, ErrorCode::BadArgument);
  expectError(PointView(data, -1), options, ErrorCode::BadArgument);
  expectError(
    PointView(data, std::numeric_limits<std::int64_t>::min()), options, ErrorCode::BadArgument);
  for (std::int64_t stride : { 2, 1, 0, -3 })
  {
    expectError(PointView(data, 4, stride), options, ErrorCode::BadArgument);
  }
  // No point is no error, with data or without.
  EXPECT_EQ(convexHull(PointView(data, 0)).dimension, -1);
  EXPECT_EQ(convexHull(PointView(static_cast<const double*>(nullptr), 0)).dimension, -1);
}

TEST(Errors, TooManyPointsBeforeAnythingIsRead)
{
  // Nobody may follow this pointer.
  const double* dummy = reinterpret_cast<const double*>(static_cast<std::uintptr_t>(8));
  const std::int64_t limit = (std::int64_t(1) << 32) - 2;
  for (std::int64_t count :
    { limit + 1, limit + 2, 2 * limit, std::numeric_limits<std::int64_t>::max() })
  {
    expectError(PointView(dummy, count), Options(), ErrorCode::TooManyPoints, -2, count);
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
  { return codeOf([&] { withTypedErrors([&]() -> int { throw thrown; }); }); };
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
    withTypedErrors([]() -> int { throw Error(ErrorCode::NotManifold, 3, 5); });
    ADD_FAILURE() << "no error";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.index(), 3);
    EXPECT_EQ(error.count(), 5);
  }
}

TEST(Errors, WhatAProgressFunctionThrowsLeavesAsAnError)
{
  const Cloud cloud = fromFamily("ball", 300, 23).make();
  Options polygons;
  polygons.facets = FacetMode::Polygons;
  const Triangulation triangulation = regularTriangulation(viewOf(cloud), WeightView(), polygons);
  const Surface surface = icosphere(1);
  for (int threads : { 1, 2 })
  {
    Options options = withThreads(threads);
    options.progress = [](double, void*) -> bool
    { throw std::system_error(EAGAIN, std::generic_category()); };
    const double box[4] = { 0, 1, 0, 1 };
    EXPECT_EQ(codeOf([&] { convexHull(viewOf(cloud), options); }), ErrorCode::Internal);
    EXPECT_EQ(codeOf([&] { regularTriangulation(viewOf(cloud), WeightView(), options); }),
      ErrorCode::Internal);
    EXPECT_EQ(codeOf([&] { flipFlop(viewOf(surface.points), surface.view(), nullptr, options); }),
      ErrorCode::Internal);
    EXPECT_EQ(
      codeOf([&] { powerDiagram(viewOf(cloud), WeightView(), triangulation, box, options); }),
      ErrorCode::Internal);
  }
}

TEST(Errors, ARunAfterAnErrorIsRight)
{
  Cloud cloud = integerGrid(4);
  cloud[10][1] = nan;
  EXPECT_THROW(convexHull(viewOf(cloud)), Error);
  cloud[10][1] = 0;
  EXPECT_EQ(convexHull(viewOf(cloud)).pointIds.size(), 8u);
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
