// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFHullAlgorithm
 * @brief   what the filters that give a convex hull have in common
 *
 * vtkFFHullAlgorithm is the abstract superclass of the Flip-Flop filters that give a convex hull.
 * It adds the hull's volume and area to the figures that all Flip-Flop filters report, and gives
 * the planes of its facets as an implicit function.
 *
 * @sa
 * vtkFFAlgorithm vtkFFHullFilter vtkFFConvexifyFilter
 */

#ifndef vtkFFHullAlgorithm_h
#define vtkFFHullAlgorithm_h

#include "vtkFFAlgorithm.h"
#include "vtkFFMarks.h"               // For VTK_MARSHALAUTO
#include "vtkFiltersFlipFlopModule.h" // For export macro

VTK_ABI_NAMESPACE_BEGIN
struct FFHullResult;
class vtkPlanes;

class VTKFILTERSFLIPFLOP_EXPORT VTK_MARSHALAUTO vtkFFHullAlgorithm : public vtkFFAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkFFHullAlgorithm, vtkFFAlgorithm);

  ///@{
  /**
   * Get the volume of the last run's result (0 below dimension 3), and the area of its surface (of
   * the polygon, once, in dimension 2; 0 below). Of several blocks: the sums.
   */
  double GetVolume() { return this->Report.Volume; }
  double GetArea() { return this->Report.Area; }
  ///@}

  /**
   * Give @p planes the planes of the last output's cells, in the cells' order: the first corner of
   * each, and the outward unit normal, off by no more than 1e-15 of each component. So the implicit
   * function is negative inside. Next to the surface it is not exact; vtkFFSelectEnclosedPoints is.
   *
   * If the output is a composite, or no hull of dimension 3, there is an error, @p planes has no
   * plane, and the result is false.
   */
  bool GetPlanes(vtkPlanes* planes);

protected:
  vtkFFHullAlgorithm() = default;
  ~vtkFFHullAlgorithm() override = default;

  /**
   * The hull, whose facets are polygons, becomes the output, which may be its data, and part of the
   * report. Threads may call this at the same time.
   */
  void WriteHull(const FFHullResult& hull, vtkPolyData* output, FFRun& run) const;

private:
  vtkFFHullAlgorithm(const vtkFFHullAlgorithm&) = delete;
  void operator=(const vtkFFHullAlgorithm&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
