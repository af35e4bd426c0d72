// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFKeptTriangulation
 * @brief   the last triangulation of a filter, for runs that change the output alone
 *
 * vtkFFKeptTriangulation has what the engine gave, and the stamp of what it was made of. Indices
 * are kept in 32 bits: that is 28 bytes for each point. Triangles can be made of kept polygons, but
 * not the other way round: then the engine runs again.
 */

#ifndef vtkFFKeptTriangulation_h
#define vtkFFKeptTriangulation_h

#include "vtkFFMarks.h"
#include "vtkFFStamp.h"

#include <flipflop/Buffer.h>
#include <flipflop/Engines.h>
#include <flipflop/Options.h>
#include <flipflop/Triangulation.h>

#include <cstdint>
#include <memory>

VTK_ABI_NAMESPACE_BEGIN
class vtkFFPlanarAlgorithm;
class vtkFFPlanarInput;
class vtkFFRun;

class vtkFFKeptTriangulation
{
public:
  /**
   * The triangulation of the input: the kept one, if it was made of the same; otherwise the
   * engine's, which is kept then. It is not where the executive goes through a composite, nor if
   * the filter's release data flag is on.
   *
   * @throw flipflop::Error as regularTriangulation()
   */
  static flipflop::Triangulation Triangulate(vtkFFPlanarAlgorithm* filter,
    const vtkFFPlanarInput& input, vtkFFRun& run, std::shared_ptr<vtkFFKeptTriangulation>& kept);

  //@{
  /**
   * What the triangulation of the input depends on; whether the filter is to keep it.
   */
  static vtkFFStamp StampOf(vtkFFPlanarAlgorithm* filter, const vtkFFPlanarInput& input);
  static bool Keeps(vtkFFPlanarAlgorithm* filter, const vtkFFRun& run);
  //@}

private:
  vtkFFKeptTriangulation(const flipflop::Triangulation& triangulation, const vtkFFStamp& stamp,
    flipflop::FacetMode facets, const flipflop::EngineReport& report);

  bool IsOf(const vtkFFStamp& stamp, flipflop::FacetMode facets) const;
  flipflop::Triangulation Copy(flipflop::FacetMode facets) const;

  const vtkFFStamp Stamp;
  const flipflop::FacetMode Facets;
  const flipflop::EngineReport Report;
  const int Dimension;
  const std::int64_t CellSize;
  const flipflop::Statistics Statistics;
  const flipflop::Buffer<std::uint32_t> PointIds;
  const flipflop::Buffer<std::uint32_t> HiddenIds;
  const flipflop::Buffer<std::uint32_t> Connectivity;
  const flipflop::Buffer<std::uint32_t> Offsets;
};
VTK_ABI_NAMESPACE_END

#endif
