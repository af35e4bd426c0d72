// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A run from the caller's points and weights to their regular triangulation.
/// RegularTriangulation.cxx has its steps.
#ifndef flipflop_TriangulationRun_h
#define flipflop_TriangulationRun_h

#include "Finish/VertexRanks.h"
#include "Geometry/HullGeometry.h"
#include "Geometry/LiftedGeometry.h"
#include "Run/GeometryRun.h"
#include "Run/Span.h"
#include <flipflop/Triangulation.h>

#include <cstdint>
#include <type_traits>

namespace flipflop
{

/// Are there weights that are not all one finite number? Only these change a triangulation. A view
/// that is at fault matters, too: the run says what is.
bool matter(const WeightView& weights, std::int64_t pointCount);

/// use (std::bool_constant, WeightView): with true and the weights where they matter. Without,
/// their geometry is another, which does not pay for them.
template <class Use>
auto withOrWithoutWeights(const PointView& points, const WeightView& weights, Use&& use)
{
  return matter(weights, points.count) ? use(std::true_type(), weights)
                                       : use(std::false_type(), WeightView());
}

/// @tparam Weighted false: there are no weights
template <bool Weighted>
class TriangulationRun : public GeometryRun<LiftedGeometry<Weighted>>
{
public:
  using Geometry = LiftedGeometry<Weighted>;

  /// @throw Error BadArgument, WeightCount, TooManyPoints
  TriangulationRun(const PointView& points, const WeightView& weights, const Options& options);
  virtual ~TriangulationRun() = default;

  /// The regular triangulation of all points: all steps, on the run's threads.
  /// @throw Error NonFinite, TooManyPoints, OutOfMemory, Aborted
  Triangulation compute(PolyhedronBuilder<Geometry>& builder);

  /// Scan the points, and choose the arithmetic. False: there is no finite point.
  /// @param scanner scans the points; null: PointScanner does
  /// @throw Error NonFinite
  bool inspect(Statistics& statistics, PointScanner* scanner = nullptr);

  /// Three points that are not collinear, or fewer that span the others' positions.
  /// @param sample see findSpan(): ids and their count, or samples
  template <class... Sample>
  Span spanOf(const Sample&... sample)
  {
    // In space, with zero for the third coordinate.
    CoordinateRange flatRange = this->range;
    flatRange.low[2] = flatRange.high[2] = 0;
    const HullGeometry flat(flatRange, this->arithmetic);
    return findSpan(flat, this->source.flattened(), sample..., 2, this->checkFinite, this->monitor);
  }

protected:
  /// The steps, on the calling threads.
  void computeSteps(PolyhedronBuilder<Geometry>& builder, Triangulation& result);

  /// Write the true triangulation in its canonical form, and what is hidden.
  /// @param anyFlat whether there is a flat edge
  template <class Surface>
  void write(Surface& surface, bool anyFlat, const Tally& tally, Triangulation& result);

  /// All finite points that do not appear.
  void listHidden(Triangulation& result);

private:
  /// The same span by the first points that do.
  Span firstSpan();

  void finishLower(Triangulation& result);
  void finish(Polyhedron&& polyhedron, Tally& tally, Triangulation& result);
  void finish(PlanePolyhedron&& plane, Tally& tally, Triangulation& result);
  void finish(FinishedCells&& cells, Tally& tally, Triangulation& result);

  /// Does beforeCanonicalForm() change the triangulation?
  virtual bool changesTriangulation() const { return false; }

  /// Change the true triangulation before it is written.
  /// @param anyFlat whether there is a flat edge
  /// @return        the same, after the change
  virtual bool beforeCanonicalForm(Polyhedron&, Tally&, bool anyFlat) { return anyFlat; }

  /// Called when the result's points are final, before its cells are written.
  virtual void beforeCells(const VertexRanks&) {}
};

extern template class TriangulationRun<false>;
extern template class TriangulationRun<true>;

}

#endif
