// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFProjection
 * @brief   points in space as points of a plane, and back
 *
 * vtkFFProjection gives the engine the x and y of points: as they lie in memory, measured in the
 * plane that fits the points best, or after a transform. A point of which any coordinate is not
 * finite, or does not stay so, has a NaN there: the engine then deals with it.
 *
 * To project can be stopped, as the engine can: by the progress function, which is told 0 every
 * now and then.
 */

#ifndef vtkFFProjection_h
#define vtkFFProjection_h

#include <flipflop/Buffer.h>
#include <flipflop/Options.h>
#include <flipflop/PointView.h>

#include "vtkFFMarks.h"
#include "vtkType.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractTransform;

class vtkFFProjection
{
public:
  /**
   * Only the progress function of @p options counts.
   */
  explicit vtkFFProjection(const flipflop::Options& options)
    : Progress(options.progress)
    , ProgressContext(options.progressContext)
  {
  }
  vtkFFProjection(const vtkFFProjection&) = delete;
  void operator=(const vtkFFProjection&) = delete;

  /**
   * Leave z out. The points are not copied, unless a z is not finite.
   *
   * @throw flipflop::Error Aborted, OutOfMemory; so do the next two.
   */
  void ToXY(const flipflop::PointView& points);

  /**
   * Measure the points in the plane through their centroid that has the least sum of squared
   * distances to them. The plane's frame is right-handed: the normal's component of largest
   * magnitude is positive (the last such one, of equals), and the first axis is the next coordinate
   * axis (y after x, x after z), laid into the plane. The first finite point is at (0, 0).
   *
   * All is computed in double and in a fixed order, so the same points give the same bits.
   */
  void ToBestFittingPlane(const flipflop::PointView& points);

  /**
   * Take x and y of the transformed points.
   */
  void ByTransform(const flipflop::PointView& points, vtkAbstractTransform* transform);

  /**
   * The projected points, valid as long as this and the points are.
   */
  const flipflop::PointView& GetView() const { return this->View; }

  /**
   * The positions in space, as x, y, z, of positions in the plane, given as x, y. In the XY plane
   * and before a transform is undone, z is 0. False when a position has none.
   */
  bool ToSpace(const double* xy, vtkIdType count, double* xyz) const;

private:
  struct Plane
  {
    double Origin[3]; // of the frame, on the plane
    double First[3];  // its axes
    double Second[3];
  };

  /**
   * Calls work(begin, end) for one stretch of @p count points after another, of @p length each.
   *
   * @throw flipflop::Error Aborted
   */
  template <class Work>
  void InStretches(vtkIdType count, vtkIdType length, const Work& work) const;

  //@{
  /**
   * Calls visit(id, xyz) for each point: in order, or by several threads in no order.
   *
   * @throw flipflop::Error Aborted
   */
  template <class Visit>
  void VisitPoints(const flipflop::PointView& points, const Visit& visit) const;
  template <class Visit>
  void VisitInParallel(const flipflop::PointView& points, const Visit& visit) const;
  //@}

  double* AllocateCopy(std::int64_t count);
  Plane FitPlane(const flipflop::PointView& points, double* start) const;

  flipflop::ProgressFunction Progress;
  void* ProgressContext;
  flipflop::PointView View;
  flipflop::Buffer<double> Copy;
  vtkAbstractTransform* Transform = nullptr; // not owned
  bool Fitted = false;
  Plane BestPlane;
};
VTK_ABI_NAMESPACE_END

#endif
