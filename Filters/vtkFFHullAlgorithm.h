// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFHullAlgorithm
 * @brief   what the filters that give a convex hull have in common
 *
 * vtkFFHullAlgorithm is the abstract superclass of the Flip-Flop filters that give a convex hull.
 * It adds the hull's volume and area to the figures that all Flip-Flop filters report.
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
class VTKFILTERSFLIPFLOP_EXPORT VTK_MARSHALAUTO vtkFFHullAlgorithm : public vtkFFAlgorithm
{
public:
  //@{
  /**
   * Standard methods for type information and printing.
   */
  vtkAbstractTypeMacro(vtkFFHullAlgorithm, vtkFFAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  //@}

  //@{
  /**
   * Get the volume of the last run's result (0 below dimension 3), and the area of its surface (of
   * the polygon, once, in dimension 2; 0 below). For several blocks with a result each: the sums.
   */
  vtkGetMacro(Volume, double);
  vtkGetMacro(Area, double);
  //@}

protected:
  vtkFFHullAlgorithm();
  ~vtkFFHullAlgorithm() override;

  class vtkInternals;

private:
  vtkFFHullAlgorithm(const vtkFFHullAlgorithm&) = delete;
  void operator=(const vtkFFHullAlgorithm&) = delete;

  double Volume;
  double Area;
};
VTK_ABI_NAMESPACE_END

#endif
