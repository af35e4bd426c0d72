// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFConvexifyFilter
 * @brief   a star-shaped surface to its convex hull, by flips
 *
 * vtkFFConvexifyFilter is the Flip-Flop algorithm itself (Algorithm 1 of the paper named in
 * vtkFFAlgorithm): it turns a star-shaped polyhedron into its convex hull by local flips. It takes
 * time in the order of what is to be flipped, so a surface that is nearly convex, such as a hull
 * whose points have moved a little, is done sooner than a hull from scratch.
 *
 * The input is a vtkPolyData of triangles that form a closed, consistently oriented manifold;
 * whether its normals point outward or inward does not matter. It must be star-shaped: there is a
 * kernel point that strictly sees the inside of every triangle. Give that point with
 * SetKernelPoint(), or have one sought (the default). Whether the surface is
 * star-shaped from it is decided exactly.
 *
 * Of the partitions of a vtkPartitionedDataSet only one may have cells: it is the input.
 *
 * The output is the exact hull in the same canonical form as vtkFFHullFilter's, with the same
 * arrays. Points that no triangle uses do not count. An input without points gives an empty output.
 *
 * These are errors, which name the first cell at fault and give an empty output: points without a
 * cell, a cell that is no triangle (also vertices, lines and strips), a triangle with a corner that
 * does not exist or is used twice, a surface that is not closed, not a manifold or not oriented
 * consistently, and one that is not star-shaped from the kernel point. A NaN or infinite coordinate
 * of a used point is always an error: without its point, a surface would not be closed.
 *
 * This filter runs on the CPU engine, whatever GetCUDAThreshold() is. Asking it for the CUDA engine
 * is an error.
 *
 * @sa
 * vtkFFHullAlgorithm vtkFFHullFilter vtkTriangleFilter vtkPolyDataNormals
 */

#ifndef vtkFFConvexifyFilter_h
#define vtkFFConvexifyFilter_h

#include "vtkFFHullAlgorithm.h"
#include "vtkFFMarks.h"               // For VTK_MARSHALAUTO
#include "vtkFiltersFlipFlopModule.h" // For export macro

VTK_ABI_NAMESPACE_BEGIN
class VTKFILTERSFLIPFLOP_EXPORT VTK_MARSHALAUTO vtkFFConvexifyFilter : public vtkFFHullAlgorithm
{
public:
  //@{
  /**
   * Standard methods for instantiation, type information and printing.
   */
  static vtkFFConvexifyFilter* New();
  vtkTypeMacro(vtkFFConvexifyFilter, vtkFFHullAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  //@}

  //@{
  /**
   * Set/Get the kernel point, which strictly sees the inside of every triangle. To set it turns
   * UseKernelPoint on, which can be turned off later. (0, 0, 0) by default.
   *
   * StoreKernelPoint() never turns it on: it is for applications that set all they have, in
   * whatever order.
   */
  virtual void SetKernelPoint(double x, double y, double z);
  virtual void SetKernelPoint(const double point[3]);
  void StoreKernelPoint(double x, double y, double z);
  vtkGetVector3Macro(KernelPoint, double);
  //@}

  //@{
  /**
   * Set/Get whether KernelPoint is used. Off by default: a kernel point is sought. SetKernelPoint()
   * turns it on.
   */
  vtkSetMacro(UseKernelPoint, bool);
  vtkGetMacro(UseKernelPoint, bool);
  vtkBooleanMacro(UseKernelPoint, bool);
  //@}

protected:
  vtkFFConvexifyFilter();
  ~vtkFFConvexifyFilter() override;

  class vtkInternals;

  double KernelPoint[3];
  bool UseKernelPoint;

private:
  vtkFFConvexifyFilter(const vtkFFConvexifyFilter&) = delete;
  void operator=(const vtkFFConvexifyFilter&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
