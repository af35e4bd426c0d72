// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// One run of the engine from the caller's weighted points to the canonical regular triangulation.
#ifndef flipflop_TriangulationRun_h
#define flipflop_TriangulationRun_h

#include "Geometry/HullGeometry.h"
#include "Geometry/LiftedGeometry.h"
#include "Geometry/LiftedStart.h"
#include "Run/GeometryRun.h"
#include <flipflop/Triangulation.h>

#include <cstdint>
#include <type_traits>

namespace flipflop
{

/// use (std::bool_constant): with true where there are weights. Without, their geometry is another,
/// which does not pay for them.
template <class Use>
auto withOrWithoutWeights(const WeightView& weights, Use&& use)
{
  return weights.data ? use(std::true_type()) : use(std::false_type());
}

/// @tparam Weighted false: there are no weights
template <bool Weighted>
class TriangulationRun : public GeometryRun<LiftedGeometry<Weighted>>
{
public:
  using Geometry = LiftedGeometry<Weighted>;

  /// @throw Error BadArgument, WeightCount, TooManyPoints
  TriangulationRun(const PointView& points, const WeightView& weights, const Options& options);

  /// Look at all points, and choose the arithmetic. False: there is no finite point.
  /// @param scanner see look()
  /// @throw Error NonFinite
  bool inspect(Statistics& statistics, PointScanner* scanner = nullptr);

  /// Three points that are not collinear, or fewer that span the others' positions.
  /// @param ids, count a sample to choose from first; null: all
  Span spanOf(const std::uint32_t* ids, std::uint32_t count);

  /// The regular triangulation of all points.
  void triangulate(PolyhedronBuilder<Geometry>& engine, Triangulation& result);

private:
  /// The same by the first points that do, or fewer that all points' positions are spanned by.
  Span firstSpan();

  /// Tell more of a result of dimension 2, whose points are known, before its cells are written.
  virtual void describe(const VertexRanks&) {}

  /// All finite points that do not appear.
  void listHidden(Triangulation& result);
};

extern template class TriangulationRun<false>;
extern template class TriangulationRun<true>;

}

#endif
