// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A third geometry: what the concept lists is all that the algorithms need. It takes its signs
/// from rationals, so its hulls are also a check of HullGeometry's filters and exact steps.
#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/Inputs/Inputs.h"
#include "Testing/Engine/Predicates/PredicateCases.h"

#include "Finish/Canonical.h"
#include "Finish/Redundant.h"
#include "FlipFlop/CurveInsertion.h"
#include "Geometry/GeometryConcept.h"
#include "Geometry/HullGeometry.h"
#include "Geometry/HullStart.h"
#include "Run/GeometryRun.h"
#include "Run/Span.h"

#include <gtest/gtest.h>

namespace flipflop
{
namespace test
{

namespace
{

/// Space, with signs from rationals. Only the kernel point and the ties are HullGeometry's.
class RationalGeometry : public PredicateSteps<RationalGeometry>
{
public:
  static constexpr bool AllExtreme = false;
  static constexpr bool IsPlanar = true;

  HullGeometry hull;

  void setKernel(const double* point) { this->hull.setKernel(point); }
  void setSymbolicKernel(const Vertex* corners) { this->hull.setSymbolicKernel(corners); }
  const double* kernel() const { return this->hull.kernel(); }
  bool kernelIsSymbolic() const { return this->hull.kernelIsSymbolic(); }

  bool filterAbove(const Vertex&, const Vertex&, const Vertex&, const Vertex&, int&) const
  {
    return false;
  }
  bool filterKernelBeneath(const Vertex&, const Vertex&, const Vertex&, int&) const
  {
    return false;
  }
  static int exactAbove(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p)
  {
    return test::exactAbove(a, b, c, p);
  }
  int exactKernelBeneath(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    EXPECT_FALSE(this->kernelIsSymbolic());
    const double* const s = this->kernel();
    return exactBeneath(a, b, c, rowOf(makeVertex(s[0], s[1], s[2], 0)));
  }
  int tieAbove(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p) const
  {
    return this->hull.tieAbove(a, b, c, p);
  }
  int tieKernelBeneath(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    return this->hull.tieKernelBeneath(a, b, c);
  }
  bool mayAppearOn(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p) const
  {
    return this->hull.mayAppearOn(a, b, c, p);
  }
  bool collinear(const Vertex& a, const Vertex& b, const Vertex& c) const
  {
    return this->hull.collinear(a, b, c);
  }
  static double heightAbove(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& p)
  {
    return HullGeometry::heightAbove(a, b, c, p);
  }
  static bool isWide() { return false; }
};

Polyhedron startingTetrahedron(
  RationalGeometry& geometry, const PointSource& source, const std::uint32_t* ids)
{
  return startingTetrahedron(geometry.hull, source, ids);
}

OctahedralMap octahedralMapOf(const RationalGeometry& geometry, const Polyhedron& polyhedron)
{
  return octahedralMapOf(geometry.hull, polyhedron);
}

static_assert(isGeometry<RationalGeometry>());

class RationalBuilder : public PolyhedronBuilder<RationalGeometry>
{
public:
  BuildResult build(const BuildTask<RationalGeometry>& task, Polyhedron&& start, Tally& tally,
    Statistics& statistics) override
  {
    const std::vector<std::uint32_t> corners = start.pointIds();
    PointSubset subset;
    subset.count = task.source.count();
    subset.exclude(corners);
    const OctahedralMap map = octahedralMapOf(task.geometry, start);
    return insertAlongCurve(task, std::move(start), subset, map, 0.1, 0.9, tally, statistics);
  }
};

/// What HullRun does, over the third geometry.
class RationalRun : public GeometryRun<RationalGeometry>
{
public:
  RationalRun(const PointView& points, const Options& options)
    : GeometryRun(points, 3, PointSource(points), options)
  {
  }

  void hullOfPoints(Hull& hull)
  {
    ASSERT_TRUE(this->scanPoints(hull.statistics));
    this->setArithmetic(chooseArithmetic(this->range));
    ASSERT_FALSE(this->arithmetic.wide);
    this->geometry.hull = HullGeometry(this->range, this->arithmetic);
    const Samples samples = nestedSamples(this->source.count());
    const Span span =
      findSpan(this->geometry.hull, this->source, samples, 3, this->checkFinite, this->monitor);
    ASSERT_EQ(span.dimension, 3);
    Polyhedron start = startingTetrahedron(this->geometry, this->source, span.ids);
    Tally tally;
    Polyhedron polyhedron = std::get<Polyhedron>(
      RationalBuilder().build(this->task(samples), std::move(start), tally, hull.statistics));
    hull.dimension = 3;
    const bool anyFlat =
      RedundantVertices<RationalGeometry>(this->geometry, polyhedron, tally, this->monitor)
        .remove();
    CanonicalForm<Polyhedron> form(polyhedron, anyFlat, tally.duplicates, this->source.count(),
      this->options.facets, this->monitor, hull.pointIds);
    form.writeHull(this->range, this->arithmetic.scaleExponent, this->monitor, hull);
    this->addStatistics(tally, hull.statistics);
  }
};

TEST(GeometryConcept, AThirdGeometryBuildsTheSameHulls)
{
  for (const char* family : { "cube", "shell0", "smallIntegers", "boxFaces" })
  {
    SCOPED_TRACE(family);
    const Cloud cloud = fromFamily(family, 400, 5).make();
    for (const int threads : threadsTried())
    {
      Options options;
      options.threads = threads;
      RationalRun run(viewOf(cloud), options);
      const Hull found = run.execute<Hull>([&run](Hull& hull) { run.hullOfPoints(hull); });
      EXPECT_EQ(bitDifference(found, convexHull(viewOf(cloud), options)), "");
    }
  }
}

}
}
}
