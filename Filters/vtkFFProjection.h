// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFProjection
 * @brief   points in space as points of a plane, and back
 *
 * vtkFFProjection gives the engine the x and y of points: as they are in memory, measured in the
 * plane that fits the points best, or after a transform. If a coordinate of a point is not finite,
 * or becomes so, the projected point has a NaN, and the engine handles it.
 *
 * A projection can be stopped, as the engine can: by the progress function, which is called with 0
 * from time to time.
 */

#ifndef vtkFFProjection_h
#define vtkFFProjection_h

#include <flipflop/Buffer.h>
#include <flipflop/Options.h>
#include <flipflop/PlaneFit.h>
#include <flipflop/PointView.h>

#include "vtkFFMarks.h"
#include "vtkType.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractTransform;

class vtkFFProjection
{
public:
  /**
   * Only the threads and the progress function of @p options are used.
   */
  explicit vtkFFProjection(const flipflop::Options& options)
    : Options(options)
  {
  }
  vtkFFProjection(const vtkFFProjection&) = delete;
  void operator=(const vtkFFProjection&) = delete;

  /**
   * Leave z out. The points are not copied, unless a z is not finite.
   *
   * @throw flipflop::Error Aborted, OutOfMemory; also in the next functions.
   */
  void ToXY(const flipflop::PointView& points);

  /**
   * Measure the points in the plane that fits them best: flipflop::fitPlane(). The first finite
   * point is at (0, 0).
   */
  void ToBestFittingPlane(const flipflop::PointView& points);

  //@{
  /**
   * The same for points that come in parts, one on each process: what flipflop::PlaneSums takes of
   * this part; and measure it in the plane of all parts.
   */
  void AddExtent(const flipflop::PointView& points, flipflop::PlaneSums& sums) const;
  void AddToSum(const flipflop::PointView& points, flipflop::PlaneSums& sums) const;
  void AddToSpread(const flipflop::PointView& points, flipflop::PlaneSums& sums) const;
  static void JoinExtent(flipflop::PlaneSums& sums, const flipflop::PlaneSums& next);
  void ToPlane(const flipflop::PointView& points, const flipflop::PlaneSums& sums);
  //@}

  /**
   * Take x and y of the transformed points.
   */
  void ByTransform(const flipflop::PointView& points, vtkAbstractTransform* transform);

  /**
   * Have other points, which are given as x and y in the plane.
   */
  void SetPlaces(flipflop::Buffer<double>&& places);

  /**
   * The projected points; valid as long as this object and the points exist.
   */
  const flipflop::PointView& GetView() const { return this->View; }

  /**
   * Where the XY plane lies for ToSpace(): at this z, 0 by default. It does not move other planes.
   */
  void SetHeight(double z) { this->Height = z; }

  /**
   * Whether the plane is the XY plane, so that there is a height to set.
   */
  bool IsXYPlane() const { return !this->Fitted && !this->Transform; }

  /**
   * The positions in space, as x, y, z, of positions in the plane, given as x, y. In the XY plane,
   * z is the height; before a transform is undone, z is 0. False if a position in the plane has
   * none in space.
   */
  bool ToSpace(const double* xy, vtkIdType count, double* xyz) const;

private:
  /**
   * Calls work(begin, end) for one stretch of points after another: @p count points in stretches of
   * @p length.
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

  flipflop::Options Options;
  flipflop::PointView View;
  flipflop::Buffer<double> Copy;
  vtkAbstractTransform* Transform = nullptr; // not owned
  bool Fitted = false;
  double Height = 0.0;
  flipflop::FittedPlane BestPlane;
};
VTK_ABI_NAMESPACE_END

#endif
