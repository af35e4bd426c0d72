// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The greatest area of a triangle by its position: of a function of the caller's, between the
/// pixels of an image, and between values at the points of the input. The least of these counts.
#ifndef flipflop_AreaField_h
#define flipflop_AreaField_h

#include <flipflop/Options.h>
#include <flipflop/RefinedMesh.h>
#include <flipflop/TriangulationQueries.h>

#include <optional>
#include <vector>

namespace flipflop
{

class AreaField
{
public:
  /// @param start of the points, with the constraints
  /// @throw Error BadArgument (index: of a point or pixel: an area that is not above 0)
  AreaField(const RefinementOptions& wanted, const PointView& points,
    const ConstrainedTriangulation& start, const Options& options);

  bool isAnywhereTheSame() const
  {
    return !this->refinement.areaAt && !this->refinement.areaOfPixel && !this->ofPoints;
  }

  /// @param positions x and y of each, in the caller's unit
  /// @param areas     receives the area at each
  /// @throw Error BadArgument: the function's area is not above 0; what the function throws
  void find(const std::vector<double>& positions, std::vector<double>& areas) const;

private:
  double betweenPixels(double x, double y) const;

  const RefinementOptions& refinement;
  std::optional<TriangulationQueries> ofPoints;
  Options plain; ///< for the queries
};

}

#endif
