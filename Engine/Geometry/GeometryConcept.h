// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The geometry concept: what the algorithms that any geometry shares need of space (PartsBuilder,
/// of the plane alone, uses LiftedGeometry's own besides). isGeometry checks that a model has all.
///
/// Vertices are seen from a kernel point s, inside of what is built. Triangles are
/// counter-clockwise seen from outside, so s is beneath every triangle of a polyhedron that is
/// star-shaped from s. Every sign is exact: -1, 0 or 1.
///
/// Two models: HullGeometry (points in space) and LiftedGeometry (weighted points of the plane).
/// FurthestGeometry and HalfSpaceGeometry have the signs alone, which insertion and the finish
/// take.
#ifndef flipflop_GeometryConcept_h
#define flipflop_GeometryConcept_h

#include "Geometry/InsertionOrder.h"
#include "Mesh/Mesh.h"
#include "Mesh/Polyhedron.h"
#include "Points/PointSource.h"
#include "Points/Vertex.h"
#include "Predicates/PredicateSteps.h"
#include "Support/Monitor.h"

#include <cstdint>
#include <type_traits>
#include <utility>

namespace flipflop
{

/// A static assertion for each line of the list: this expression, of this type.
#define FF_REQUIRES(Type, ...)                                                                     \
  static_assert(std::is_same_v<Type, decltype(__VA_ARGS__)>, #__VA_ARGS__)

/// The signs. Derive from PredicateSteps<Geometry>, and most signs follow from their
/// steps.
template <class Geometry>
constexpr bool hasSigns()
{
  using std::declval;
  using G = const Geometry&;
  using V = const Vertex&;

  // Are all points vertices but for duplicates?
  FF_REQUIRES(const bool, Geometry::AllExtreme);

  // Is p beyond the triangle abc, seen from s? orient3d of points in space; the power test of
  // weighted points.
  FF_REQUIRES(int, declval<G>().above(declval<V>(), declval<V>(), declval<V>(), declval<V>()));

  // Is s beneath the triangle abc? p is in the cone of abc when s is beneath abp, bcp and cap.
  FF_REQUIRES(int, declval<G>().kernelBeneath(declval<V>(), declval<V>(), declval<V>()));

  // The same, never zero: ties by Simulation of Simplicity, by the vertices' ids.
  FF_REQUIRES(
    int, declval<G>().perturbedAbove(declval<V>(), declval<V>(), declval<V>(), declval<V>()));
  FF_REQUIRES(int, declval<G>().perturbedKernelBeneath(declval<V>(), declval<V>(), declval<V>()));

  // Each step alone. The filters, in floating point, return false when they cannot decide; where
  // the exact sign is zero, the ties are never zero.
  FF_REQUIRES(bool,
    declval<G>().filterAbove(
      declval<V>(), declval<V>(), declval<V>(), declval<V>(), declval<int&>()));
  FF_REQUIRES(bool,
    declval<G>().filterKernelBeneath(declval<V>(), declval<V>(), declval<V>(), declval<int&>()));
  FF_REQUIRES(int, declval<G>().exactAbove(declval<V>(), declval<V>(), declval<V>(), declval<V>()));
  FF_REQUIRES(int, declval<G>().exactKernelBeneath(declval<V>(), declval<V>(), declval<V>()));
  FF_REQUIRES(int, declval<G>().tieAbove(declval<V>(), declval<V>(), declval<V>(), declval<V>()));
  FF_REQUIRES(int, declval<G>().tieKernelBeneath(declval<V>(), declval<V>(), declval<V>()));

  // May p, in the cone of abc and exactly on its plane, still be a vertex of the perturbed result?
  // On a triangle it is never strictly extreme, and dropped. Where the cone is flat (s is on the
  // plane, too) that does not follow.
  FF_REQUIRES(
    bool, declval<G>().mayAppearOn(declval<V>(), declval<V>(), declval<V>(), declval<V>()));

  // Do the three lie on a line? Exact.
  FF_REQUIRES(bool, declval<G>().collinear(declval<V>(), declval<V>(), declval<V>()));

  // What it has decided. Each task has a copy of its own, which counts.
  FF_REQUIRES(const PredicateCounts&, declval<G>().predicateCounts());
  static_assert(std::is_copy_constructible_v<Geometry>);
  return true;
}

/// What builders need besides, and a function next to the class.
template <class Geometry>
constexpr bool hasStart()
{
  using std::declval;
  using G = const Geometry&;
  using V = const Vertex&;

  // Is it built by parts (PartsBuilder), from points alone? Else it is built by growing and
  // flipping in rounds, from a tetrahedron (Builder).
  FF_REQUIRES(const bool, Geometry::IsPlanar);

  // The kernel point: a position, or the exact centroid of four vertices, which no double need be.
  // kernel() is rounded then.
  FF_REQUIRES(void, declval<Geometry&>().setKernel(declval<const double*>()));
  FF_REQUIRES(void, declval<Geometry&>().setSymbolicKernel(declval<const Vertex*>()));
  FF_REQUIRES(const double*, declval<G>().kernel());
  FF_REQUIRES(bool, declval<G>().kernelIsSymbolic());

  // How far p is above abc, times twice the area; rounded. For choosing the furthest point.
  FF_REQUIRES(
    double, Geometry::heightAbove(declval<V>(), declval<V>(), declval<V>(), declval<V>()));

  // Are integers of any size needed? Devices have none.
  FF_REQUIRES(bool, declval<G>().isWide());

  // The tetrahedron of the points that findSpan chose; the kernel point is set inside it.
  FF_REQUIRES(Polyhedron,
    startingTetrahedron(
      declval<Geometry&>(), declval<const PointSource&>(), declval<const std::uint32_t*>()));
  return true;
}

/// What Builder needs besides, of models that are not IsPlanar: tests of planes and split
/// cones, prepared for many points, each a rounded value and its error bound.
template <class Geometry>
constexpr bool canGrow()
{
  using std::declval;
  using V = const Vertex&;
  using G = const Geometry&;

  // The curve that points are inserted along.
  FF_REQUIRES(
    OctahedralMap, octahedralMapOf(declval<const Geometry&>(), declval<const Polyhedron&>()));
  // The kernel point may move to the middle of a convex polyhedron.
  FF_REQUIRES(void, centerKernel(declval<Geometry&>(), declval<const Polyhedron&>()));

  using Plane = typename Geometry::Plane;
  static_assert(std::is_constructible_v<Plane, G, V, V, V>);
  FF_REQUIRES(double, declval<const Plane&>().height(declval<const double*>()));
  FF_REQUIRES(double, declval<const Plane&>().error());

  // The cone of abc split by v: which child holds p (-1: too close to decide), how far p is above
  // it.
  using Split = typename Geometry::Split;
  static_assert(std::is_constructible_v<Split, G, V, V, V, V>);
  FF_REQUIRES(int, declval<const Split&>().child(declval<const double*>()));
  FF_REQUIRES(double, declval<const Split&>().height(0, declval<const double*>()));
  FF_REQUIRES(double, declval<const Split&>().heightError(0));

  // A locator starts walks near where they end: it keeps a triangle for each of some cells. And it
  // dismisses points that are certainly inside, a block at a time.
  using Locator = typename Geometry::Locator;
  using L = const Locator&;
  static_assert(std::is_constructible_v<Locator, const Geometry&, const Triangle*, std::uint32_t,
    const Vertex*, Monitor&>);
  using Cell = decltype(declval<L>().cellOf(declval<const double*>()));
  FF_REQUIRES(std::uint32_t, declval<L>().near(declval<const Vertex&>(), declval<Cell>()));
  // The triangle in whose cone p lies, by a visibility walk from a given one.
  FF_REQUIRES(std::uint32_t,
    declval<L>().locate(
      declval<const Geometry&>(), declval<const Vertex&>(), declval<std::uint32_t>()));
  FF_REQUIRES(void, declval<const Locator&>().classify(declval<typename Locator::Block&>(), 0));
  FF_REQUIRES(const int, Locator::BlockSize);
  static_assert(
    sizeof(Locator::Block::x) && sizeof(Locator::Block::cell) && sizeof(Locator::Block::inside));
  FF_REQUIRES(const Plane&, declval<const Locator&>().plane(std::uint32_t(0)));
  return true;
}

#undef FF_REQUIRES

/// Has the model all that it must give? A compiler that says no names the line of the list.
template <class Geometry>
constexpr bool isGeometry()
{
  if constexpr (!Geometry::IsPlanar)
  {
    static_assert(canGrow<Geometry>());
  }
  return hasSigns<Geometry>() && hasStart<Geometry>();
}

}

#endif
