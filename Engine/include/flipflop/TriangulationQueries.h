// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Queries for positions in the plane to a regular or constrained triangulation: which cell holds
/// a position, which site is nearest, and what value is there, between the sites' values.
#ifndef flipflop_TriangulationQueries_h
#define flipflop_TriangulationQueries_h

#include <flipflop/Buffer.h>
#include <flipflop/ConstrainedTriangulation.h>
#include <flipflop/Options.h>
#include <flipflop/PointView.h>
#include <flipflop/Triangulation.h>

#include <cstdint>
#include <memory>

namespace flipflop
{

class PreparedTriangulation;

/// How values are found between the sites.
enum class Interpolation
{
  Linear,       ///< as by TriangulationQueries::interpolateLinear()
  Natural,      ///< as by TriangulationQueries::interpolateNatural()
  CloughTocher, ///< as by TriangulationQueries::interpolateCloughTocher()
  Laplace       ///< as by TriangulationQueries::interpolateLaplace()
};

/// Where the pixels of an image are: at origin + index * spacing along each axis, computed in
/// doubles, product first. A pixel is a position, such as the center of what it shows.
struct ImageGrid
{
  double origin[2] = { 0, 0 };           ///< x and y of index 0; finite
  double spacing[2] = { 1, 1 };          ///< from an index to the next, in x and in y; finite, of
                                         ///< either sign: below 0 in y, rows go down
  std::int64_t size[2] = { 0, 0 };       ///< columns (along x) and rows (along y): 1 or more
  std::int64_t firstIndex[2] = { 0, 0 }; ///< of the first column and the first row
};

/// What receives an image: pixel (column, row) at data[(row * columns + column) * components].
struct ImageView
{
  void* data = nullptr;                  ///< the caller's
  ScalarType type = ScalarType::Float64; ///< of its numbers

  ///@{
  /// Numbers of float are the nearest to those of double.
  explicit ImageView(double* numbers)
    : data(numbers)
  {
  }
  explicit ImageView(float* numbers)
    : data(numbers)
    , type(ScalarType::Float32)
  {
  }
  ///@}
};

/// Of each of some queries, the sites that have a share in values there.
struct SiteShares
{
  /// Where those of each query begin, ascending from 0; then the number of all.
  Buffer<std::int64_t> offsets;
  Buffer<std::int64_t> ids; ///< of sites, ascending for each query
  Buffer<double> shares;    ///< of each of these: 0 to 1
};

/// A triangulation made ready for queries. It takes about 110 bytes a visible point.
///
/// Which cell and which site is exact for every finite position, at any range of numbers; values
/// are rounded. All results are the same, bit for bit, for any number of threads, and for any order
/// of the queries.
///
/// Several threads may call the const members at once.
///
/// Queries are positions: of a PointView, x and y are read. What all calls do alike:
/// - A query with a coordinate that is NaN or infinite is an error, or, with
///   NonFinitePolicy::Ignore, has the result of a position outside: -1 or NaN.
/// - Arrays of results are the caller's; they are written from the first to the last query. Where
///   a call throws, they are as they were, or partly written.
class TriangulationQueries
{
public:
  /// Copies what it needs; the arguments may go afterwards.
  /// @param points          as they were triangulated
  /// @param weights         as they were triangulated
  /// @param triangulation   of these points, in either mode of facets
  /// @param options         only the threads and the progress function are used
  /// @throw Error           WeightCount, TooManyPoints (2^30 triangles), OutOfMemory, Aborted,
  ///                        BadArgument. The last one also for a complex that is not a regular
  ///                        triangulation of its points: an index or id out of range, a triangle
  ///                        that is not counter-clockwise, facets that form no ring, an edge that
  ///                        is not regular, a border that is not convex. Whether the hidden points
  ///                        should be hidden is not checked.
  TriangulationQueries(const PointView& points, const WeightView& weights,
    const Triangulation& triangulation, const Options& options = Options())
    : TriangulationQueries(points, weights, triangulation, nullptr, options)
  {
  }

  /// Of some cells of a regular triangulation. A position that only the others hold is outside: it
  /// has no cell, value or share. A border that a cell inside and one of the others have in common
  /// is inside. Values are those of the whole triangulation, bit for bit: natural neighbours and
  /// gradients are found among all its sites. nearest() is that of the whole triangulation, too.
  /// @param points        as they were triangulated
  /// @param weights       as they were triangulated
  /// @param triangulation of these points, in either mode of facets, with all its cells
  /// @param inside        for each cell 1 if it is inside, else 0; null: all are. locate() numbers
  ///                      the cells inside alone, in their order, as keepCells() does; of several
  ///                      that hold a position, the lowest.
  /// @param options       only the threads and the progress function are used
  /// @throw Error         as of the whole triangulation
  TriangulationQueries(const PointView& points, const WeightView& weights,
    const Triangulation& triangulation, const std::uint8_t* inside,
    const Options& options = Options());

  /// Of a constrained triangulation: for locate(), and linear and Clough-Tocher values. Natural
  /// neighbours and the nearest site are those of the regular triangulation, so the other calls are
  /// an error.
  /// @param points        as they were triangulated
  /// @param triangulation of these points; apart from its cells, only its fixed edges count
  /// @param inside        for each cell 1 if it is inside, as cellsInside() gives it, else 0; null:
  ///                      all are. A position that only cells outside hold is outside. locate()
  ///                      numbers the cells inside alone, in their order, as keepCells() does.
  /// @param options       only the threads and the progress function are used
  /// @throw Error         as of a regular triangulation; of edges that are not regular, those that
  ///                      are not fixed are an error
  TriangulationQueries(const PointView& points, const ConstrainedTriangulation& triangulation,
    const std::uint8_t* inside = nullptr, const Options& options = Options());

  ///@{
  /// @p other may only be destroyed or assigned to afterwards.
  TriangulationQueries(TriangulationQueries&& other) noexcept;
  TriangulationQueries& operator=(TriangulationQueries&& other) noexcept;
  ///@}
  TriangulationQueries(const TriangulationQueries&) = delete;
  TriangulationQueries& operator=(const TriangulationQueries&) = delete;
  ~TriangulationQueries();

  /// The cell that holds each query, its border included. Exact.
  ///
  /// A query costs a short walk; near a site of very many neighbours, a longer one.
  /// @param queries positions
  /// @param cells   receives for each query the index of its cell in the triangulation; of several
  ///                (on an edge, at a corner) the lowest; -1 outside the convex hull. Of a
  ///                triangulation of dimension 1 a cell is a segment, of dimension 0 its one point.
  /// @param options the threads, the policy for what is not finite, and the progress function
  /// @throw Error   NonFinite (index: the first such query, count: how many), BadArgument (a null
  ///                array), TooManyPoints (queries), OutOfMemory, Aborted
  void locate(
    const PointView& queries, std::int64_t* cells, const Options& options = Options()) const;

  /// The visible point (site) with the least power distance from each query: |query - site|^2,
  /// less the site's weight. In other words, whose power cell holds the query. Without weights, it
  /// is the nearest point. Exact, inside the hull and outside.
  ///
  /// A query costs the neighbours of a few sites: more, if a site has very many.
  /// @param queries positions
  /// @param ids     receives for each query the site's id (index in the input); of several at
  ///                one distance, the lowest; -1 where there is no site
  /// @param options as for locate()
  /// @throw Error   as for locate(); BadArgument also of a constrained triangulation
  void nearest(
    const PointView& queries, std::int64_t* ids, const Options& options = Options()) const;

  /// Values between the sites: linear over each triangle. A cell of more than three corners counts
  /// as its fan from the lowest corner, which FacetMode::Triangles gives; the values are the same,
  /// bit for bit. At a site the value is the site's, exactly, on an edge linear between the two
  /// ends; so values are continuous, and NaN outside the convex hull.
  ///
  /// The share of each corner is rounded last: it is off by a few units in its last place, also
  /// where a triangle is almost flat. A value is never beyond those that it is made of: where they
  /// are equal, it is the same.
  /// @param values     of each point of the input: values[id * components + c]. Those of hidden
  ///                   points are not read.
  /// @param components of a value: 1 or more
  /// @param queries    positions
  /// @param result     receives for each query its value: result[query * components + c]
  /// @param options    as for locate()
  /// @throw Error      as for locate(); BadArgument also for components less than 1
  void interpolateLinear(const double* values, std::int64_t components, const PointView& queries,
    double* result, const Options& options = Options()) const;

  /// Values between the sites by natural neighbour coordinates (R. Sibson, 1981): smoother than
  /// linear ones, and no function of how facets are cut into triangles. Were the query a site, its
  /// power cell would take some area from the cells around. The share of a site in the value is its
  /// share of that area.
  ///
  /// The query has the weight that is linear over its triangle, from the corners' weights
  /// (rounded); without weights, none, as Sibson's has. So it is never hidden, and values pass
  /// through those of the sites. Shares are positive and sum to 1. Linear functions are reproduced,
  /// with weights, too. No value is beyond those that it is made of. Values are continuous, and
  /// without weights smooth but at the sites. At a site the value is the site's, exactly; on the
  /// hull's border it is linear between the two ends of the edge; it is NaN outside. In dimension 1
  /// and 0, it is that of interpolateLinear().
  ///
  /// Which sites have a share is exact. Shares are rounded: each is right to 2^-30 of itself, and
  /// mostly to 1e-13. A query costs the triangles that it would remove: a few, but all those at a
  /// site of very many neighbours.
  /// @param values     as for interpolateLinear()
  /// @param components as for interpolateLinear()
  /// @param queries    as for interpolateLinear()
  /// @param result     as for interpolateLinear()
  /// @param options    as for locate()
  /// @throw Error      as for interpolateLinear(); BadArgument also of a constrained triangulation
  void interpolateNatural(const double* values, std::int64_t components, const PointView& queries,
    double* result, const Options& options = Options()) const;

  /// Values between the sites by Laplace's (non-Sibsonian) coordinates (V. V. Belikov, V. D.
  /// Ivanov, V. K. Kontorovich, S. A. Korytnik, A. Y. Semenov, 1997). Were the query a site, its
  /// power cell would have a side to that of each natural neighbour. The share of a neighbour is
  /// the length of this side over the neighbour's distance, of the sum of all. They take less time
  /// than natural ones, and all else that is said of these holds; but values are not smooth at the
  /// circles around triangles.
  /// @param values     as for interpolateLinear()
  /// @param components as for interpolateLinear()
  /// @param queries    as for interpolateLinear()
  /// @param result     as for interpolateLinear()
  /// @param options    as for locate()
  /// @throw Error      as for interpolateNatural()
  void interpolateLaplace(const double* values, std::int64_t components, const PointView& queries,
    double* result, const Options& options = Options()) const;

  /// The shares that sites have in values: the natural neighbours of each query, and their
  /// coordinates; or the corners of its triangle. They sum to 1, but for rounding.
  /// @param method  Natural, Laplace or Linear
  /// @param queries positions
  /// @param options as for locate()
  /// @return        the shares of each query; none of one outside
  /// @throw Error   as of the method's own call; BadArgument of CloughTocher, whose values depend
  /// on
  ///                gradients, too
  SiteShares shares(
    Interpolation method, const PointView& queries, const Options& options = Options()) const;

  /// Values between the sites by a smooth surface through them, of cubic pieces over each triangle
  /// (R. W. Clough and J. L. Tocher, 1965): values and gradients are continuous. On smooth
  /// functions the error is a small part of that of linear values; where values jump, they swing
  /// beyond them.
  ///
  /// The gradient at a site is estimated: that of the quadratic function that fits the values of
  /// the sites around best, by least squares; near the border of more sites. So quadratic functions
  /// are reproduced up to rounding, where sites determine them. A linear one is fitted elsewhere.
  /// Fixed edges and cells left out do not part what is fitted.
  ///
  /// At a site the value is the site's, exactly; outside it is NaN. Where what is computed is not
  /// finite, because a value around is not or numbers overflow, it is that of interpolateLinear();
  /// in dimension 1 and 0, too. Weights count only in which sites are neighbours.
  ///
  /// Each call estimates the gradients at all sites, or of few queries those near. That takes about
  /// as long as a few queries a site.
  /// @param values     as for interpolateLinear()
  /// @param components as for interpolateLinear()
  /// @param queries    as for interpolateLinear()
  /// @param result     as for interpolateLinear()
  /// @param options    as for locate()
  /// @throw Error      as for interpolateLinear()
  void interpolateCloughTocher(const double* values, std::int64_t components,
    const PointView& queries, double* result, const Options& options = Options()) const;

  /// The gradients at the sites that interpolateCloughTocher() estimates, per unit of the
  /// positions. They are the same, bit for bit, for any number of threads.
  /// @param values     as for interpolateLinear()
  /// @param components as for interpolateLinear()
  /// @param gradients  of each point of the input: receives at [2 * (id * components + c)] the
  ///                   derivative by x, then that by y. Those of hidden points are left as they
  ///                   are. Not finite where a value around is not, or numbers overflow; in
  ///                   dimension 1 and 0, NaN.
  /// @param options    only the threads and the progress function are used
  /// @throw Error      BadArgument (a null array, components less than 1), OutOfMemory, Aborted
  void siteGradients(const double* values, std::int64_t components, double* gradients,
    const Options& options = Options()) const;

  /// The values at all pixels of an axis-aligned image: those that the call of the same method
  /// gives at the pixels' positions, bit for bit. It is faster, for pixels are found by triangles:
  /// a triangle costs the rows that it crosses, a pixel its value.
  /// @param method     how values are found
  /// @param values     as for interpolateLinear()
  /// @param components as for interpolateLinear()
  /// @param grid       where the pixels are
  /// @param result     receives the values
  /// @param fill       what pixels outside receive in each component; NaN is possible
  /// @param options    the threads and the progress function
  /// @throw Error      BadArgument: as of the method's own call; no column or row; an origin, a
  ///                   spacing or a pixel that is not finite; 2^60 numbers or more.
  ///                   OutOfMemory, Aborted: the image is then partly written
  void interpolateImage(Interpolation method, const double* values, std::int64_t components,
    const ImageGrid& grid, const ImageView& result, double fill,
    const Options& options = Options()) const;

private:
  std::unique_ptr<PreparedTriangulation> prepared;
};

}

#endif
