// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Meshes of polygons whose triangles have no small angles and are small enough, for finite
/// elements.
#ifndef flipflop_RefinedMesh_h
#define flipflop_RefinedMesh_h

#include <flipflop/Buffer.h>
#include <flipflop/ConstrainedTriangulation.h>
#include <flipflop/Options.h>
#include <flipflop/PointView.h>
#include <flipflop/TriangulationQueries.h>

#include <cstdint>
#include <functional>

namespace flipflop
{

/// A part of a mesh that has its own limit, or its own number.
struct MeshRegion
{
  double x;            ///< of a point in it, on no constraint
  double y;            ///< of the same
  double maxArea = 0;  ///< of its triangles; 0: as everywhere
  bool isHole = false; ///< leave it out
};

/// What the triangles of a mesh must be like.
struct RefinementOptions
{
  /// The least angle of a triangle, in degrees: 0 to 34. Up to 20.7 the refinement is proven to end
  /// with no smaller angle but at small angles of the input; to about 30 it does in practice.
  double minAngle = 25;
  double maxArea = 0; ///< of a triangle; 0: any

  ///@{
  /// Greatest areas that change with the position; of several, and of the region's, the least
  /// counts. Each is above 0, or infinite: any. A triangle has that at its centroid: one found so
  /// late that a large triangle jumps over it does not count.
  /// - of each point of the input; between them, linear over the triangles of the input
  /// - of each pixel of an image, by rows (ImageGrid); bilinear between these
  /// - by a function of the caller's: for x and y of so many positions, it writes the area at each.
  ///   It is called about twenty times, with many at once, and may throw.
  const double* areaOfPoint = nullptr;
  const double* areaOfPixel = nullptr;
  ImageGrid areaGrid;
  std::function<void(const double* positions, std::int64_t count, double* areas)> areaAt;
  ///@}

  const MeshRegion* regions = nullptr; ///< each in a part of its own that constraints enclose
  std::int64_t regionCount = 0;        ///< how many
  std::int64_t maxPoints = 0;          ///< insert no more; 0: ten million
  /// For each side of a polygon its feature, as cellsInsideFeatures() takes them: their union is
  /// inside. Null: by Options::polygons.
  const std::int64_t* featureOf = nullptr;
  bool findsShares = false; ///< RefinedMesh::shares
};

/// The constrained Delaunay triangulation of the input's points and the new ones, bit for bit what
/// constrainedTriangulation() of these and of `fixedEdges` gives. Ids of new points follow those of
/// the input.
///
/// A constraint runs through the new points that divide it. These are rounded to multiples of one
/// unit, the spacing of doubles at the greatest coordinate, so each is off the part that it divides
/// by less than a unit; by up to 2.2 units where it would otherwise be beyond a thin triangle.
struct RefinedMesh : ConstrainedTriangulation
{
  Buffer<double> points; ///< x and y of all points, by id

  /// For each new point the constraint that it divides; -1: it is inside, or on an edge of the
  /// convex hull that no constraint runs along.
  Buffer<std::int64_t> constraintOfPoint;

  /// For each cell: -1: it is outside of the mesh; 0: in none of the regions; else the number of
  /// its region, from 1 on.
  Buffer<std::int64_t> region;

  /// For each new point the points of the input, and their shares, that a value there is made of:
  /// on a constraint linear along it, inside over a triangle of the input. Empty unless asked for.
  SiteShares shares;

  /// For each angle of less than 60 degrees between constraints, inside of the mesh, three ids: of
  /// the apex and of the other ends there, counter-clockwise. The constraints end at the next
  /// points of the input on them.
  Buffer<std::int64_t> smallAngles;

  std::int64_t newPoints = 0;     ///< how many
  std::int64_t keptSegments = 0;  ///< parts of constraints that are too short to be divided
  std::int64_t keptTriangles = 0; ///< bad triangles whose center is too near to a vertex
  bool isComplete = true;         ///< false: maxPoints ended it
};

/// A mesh by Delaunay refinement. It covers what is inside of the polygons; without polygons, what
/// the constraints enclose; where they enclose nothing, the convex hull.
/// Constraints inside are edges of it.
///
/// Every triangle in it has the least angle, and at most the area, but for those at angles of less
/// than 60 degrees between constraints, and near what was kept (keptSegments, keptTriangles).
/// Angles and areas are compared exactly; of the angle, the square of its cosine as a double.
///
/// @param points      as for constrainedTriangulation(); finite
/// @param constraints the same; crossing ones: see splitCrossings()
/// @param refinement  see RefinementOptions
/// @param options     see Options; facets do not count
/// @return            the mesh, the same for any number of threads
/// @throw Error       BadArgument (an angle, an area or a number out of range; of a point, a pixel
///                    or a position: index: it; a region's point outside of the mesh or on a
///                    constraint, two in one part: index: it;
///                    coordinates that are not 0, and smaller than the greatest by more than about
///                    60 orders of magnitude),
///                    ConstraintPoint, ConstraintsCross, PolygonsDisagree, NonFinite,
///                    TooManyPoints, OutOfMemory, Aborted
RefinedMesh refinedMesh(const PointView& points, const ConstraintView& constraints,
  const RefinementOptions& refinement, const Options& options = Options());

/// Leave out the cells that are outside of the mesh.
/// @throw Error OutOfMemory
void keepInside(RefinedMesh& mesh);

/// What the triangles of a mesh are like, rounded.
/// @param mesh   its triangles, or those that keepInside() left
/// @param areas  receives the area of each cell
/// @param angles receives its least angle, in degrees
/// @throw Error  BadArgument (no array; cells that are no triangles)
void measureTriangles(const RefinedMesh& mesh, double* areas, double* angles);

}

#endif
