// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFCrossings
 * @brief   constraints in pieces that do not cross, and the points that this takes
 *
 * vtkFFCrossings has the engine split constraints where they cross. It gives the new points
 * positions in space and point data, along the first of the constraints that cross there.
 */

#ifndef vtkFFCrossings_h
#define vtkFFCrossings_h

#include "vtkFFMarks.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <flipflop/ConstraintCrossings.h>

#include <cstddef>
#include <cstdint>

VTK_ABI_NAMESPACE_BEGIN
class vtkFFProjection;
class vtkPointSet;

class vtkFFCrossings
{
public:
  /**
   * @param projection  of the points; it gets the places of the new ones after them
   * @param constraints as of the points; they have to stay as long as this object
   * @throw flipflop::Error as splitCrossings()
   */
  vtkFFCrossings(vtkFFProjection& projection, const flipflop::ConstraintView& constraints,
    const flipflop::Options& options);

  vtkFFCrossings(const vtkFFCrossings&) = delete;
  void operator=(const vtkFFCrossings&) = delete;

  /**
   * The pieces; valid as long as this object exists.
   */
  flipflop::ConstraintView GetView() const { return this->Split.view(); }

  /**
   * The constraint that a piece is of.
   */
  std::int64_t GetConstraint(std::int64_t piece) const
  {
    return this->Split.constraintOf[static_cast<std::size_t>(piece)];
  }

  /**
   * How many points are new.
   */
  vtkIdType GetNumberOfPoints() const
  {
    return static_cast<vtkIdType>(this->Split.newPointCount());
  }

  /**
   * The points of @p input, and then the new ones, with the point data that can be interpolated. In
   * the XY plane, a new point has the x and y that were triangulated. @p projection is that of the
   * constructor.
   */
  vtkSmartPointer<vtkPointSet> Append(vtkPointSet* input, const vtkFFProjection& projection) const;

private:
  const flipflop::ConstraintView Constraints;
  flipflop::SplitConstraints Split;
};
VTK_ABI_NAMESPACE_END

#endif
