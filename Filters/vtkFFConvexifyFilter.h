// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFConvexifyFilter
 * @brief   turns a star-shaped surface into its convex hull, by flips
 *
 * vtkFFConvexifyFilter is the Flip-Flop algorithm itself (Algorithm 1 of the paper named in
 * vtkFFAlgorithm): it turns a star-shaped polyhedron into its convex hull by local flips. Its time
 * is proportional to the flips needed. So a surface that is nearly convex, such as a hull whose
 * points have moved a little, takes less time than a hull from scratch.
 *
 * The input is a vtkPolyData of triangles, polygons and triangle strips that form a closed,
 * consistently oriented manifold. Its normals may point outward or inward. Polygons are cut into
 * triangles, concave ones too: as they are seen along the coordinate axis that is nearest to their
 * normal, by exact signs, so that none of a flat polygon's triangles folds over another. A convex
 * polygon becomes the fan from its first corner.
 *
 * The surface must be star-shaped: there is a kernel point that strictly sees the inside of every
 * triangle. Give that point with SetKernelPoint(), or let the
 * filter search for one (the default). An exact test decides whether the surface is star-shaped
 * from it.
 *
 * The output is the exact hull in the same canonical form as vtkFFHullFilter's, with the same
 * arrays. How polygons were cut does not show in it. Points that no cell uses are ignored. An input
 * without points gives an empty output.
 *
 * The following inputs are errors. They name the first cell at fault and give an empty output:
 * points without a cell; a vertex or a line; a polygon or strip of fewer than three points; a cell
 * with a corner that does not exist or is used twice; a polygon that crosses or touches itself; a
 * surface that is not closed, not a
 * manifold or not oriented consistently; a surface that is not star-shaped from the kernel point. A
 * NaN or infinite coordinate of a used point is always an error, since the surface would not be
 * closed without the point.
 *
 * This filter runs on the CPU engine, whatever GetCUDAThreshold() is.
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
  ///@{
  /**
   * Standard methods for instantiation, type information and printing.
   */
  static vtkFFConvexifyFilter* New();
  vtkTypeMacro(vtkFFConvexifyFilter, vtkFFHullAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /**
   * Set the engine: ENGINE_AUTOMATIC or ENGINE_CPU, to which ENGINE_CUDA is clamped.
   */
  void SetEngine(int engine) override;

  ///@{
  /**
   * Set/Get the kernel point, which strictly sees the inside of every triangle. (0, 0, 0) by
   * default. SetKernelPoint() also turns UseKernelPoint on; you can turn it off later.
   *
   * StoreKernelPoint() never turns it on. It is for applications that set all properties, in any
   * order.
   */
  virtual void SetKernelPoint(double x, double y, double z);
  virtual void SetKernelPoint(const double point[3]);
  void StoreKernelPoint(double x, double y, double z);
  vtkGetVector3Macro(KernelPoint, double);
  ///@}

  ///@{
  /**
   * Set/Get whether KernelPoint is used. Off by default: the filter searches for a kernel point.
   * SetKernelPoint() turns it on.
   */
  vtkSetMacro(UseKernelPoint, bool);
  vtkGetMacro(UseKernelPoint, bool);
  vtkBooleanMacro(UseKernelPoint, bool);
  ///@}

protected:
  vtkFFConvexifyFilter();
  ~vtkFFConvexifyFilter() override;

  void Execute(vtkDataObject* data, vtkInformationVector** inputVector,
    const std::vector<vtkDataObject*>& results, FFRun& run) override;
  const char* GetTitle() const override { return "Convexify"; }

  double KernelPoint[3] = { 0.0, 0.0, 0.0 };
  bool UseKernelPoint = false;

private:
  vtkFFConvexifyFilter(const vtkFFConvexifyFilter&) = delete;
  void operator=(const vtkFFConvexifyFilter&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
