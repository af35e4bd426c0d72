// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFConvexifyFilter
 * @brief   turns a star-shaped surface into its convex hull, by flips
 *
 * vtkFFConvexifyFilter is the Flip-Flop algorithm itself (Algorithm 1 of the paper named in
 * vtkFFAlgorithm): it turns a star-shaped polyhedron into its convex hull by local flips. Its time
 * is proportional to the flips needed: a surface that is nearly convex, such as a hull whose points
 * have moved a little, takes less time than a hull from scratch.
 *
 * The input is a vtkPolyData of triangles, polygons (also concave ones) and triangle strips that
 * form a closed, consistently oriented manifold, whose normals point outward or inward. It must be
 * star-shaped: there is a kernel point that strictly sees the inside of every triangle. Give that
 * point with SetKernelPoint(), or let the filter search for one (the default). Exact signs cut
 * polygons, as seen along the coordinate axis nearest to their normal, and test the kernel point.
 *
 * The output is the exact hull in the same canonical form as vtkFFHullFilter's, with the same
 * arrays. Points that no cell uses are ignored. An input without points gives an empty output.
 *
 * What is no such surface is an error that names the first cell at fault: points without a cell; a
 * vertex or a line; a cell of fewer than three points; a corner that does not exist or is used
 * twice; a polygon that crosses or touches itself; a surface that is not closed, no manifold, not
 * oriented consistently or not star-shaped. So is a NaN or infinite coordinate of a used point.
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
  /// Standard methods for instantiation, type information and printing.
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
   * Set/Get the kernel point, in the coordinates of the input. (0, 0, 0) by default. What is not
   * finite, or from where the surface is not star-shaped, is an error. SetKernelPoint() also turns
   * UseKernelPoint on; StoreKernelPoint() does not: it is for applications that set all properties.
   */
  virtual void SetKernelPoint(double x, double y, double z);
  virtual void SetKernelPoint(const double point[3]);
  void StoreKernelPoint(double x, double y, double z);
  vtkGetVector3Macro(KernelPoint, double);
  ///@}

  ///@{
  /**
   * Set/Get whether KernelPoint is used. Off by default: the filter searches for a kernel point.
   */
  vtkSetMacro(UseKernelPoint, bool);
  vtkGetMacro(UseKernelPoint, bool);
  vtkBooleanMacro(UseKernelPoint, bool);
  ///@}

protected:
  vtkFFConvexifyFilter() = default;
  ~vtkFFConvexifyFilter() override = default;

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
