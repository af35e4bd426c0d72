// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A hull as VTK data, which can be joined to others.
 *
 * The hull of hulls is the hull: of pieces one after another, of processes' pieces.
 */

#ifndef FFHullResult_h
#define FFHullResult_h

#include "vtkFFMarks.h"
#include "vtkSmartPointer.h"

#include <flipflop/Engines.h>
#include <flipflop/Hull.h>

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class FFInput;
class FFRun;
class vtkPolyData;

struct FFHullResult
{
  FFHullResult();
  explicit FFHullResult(vtkPolyData* data); ///< which it becomes

  vtkSmartPointer<vtkPolyData> Data; ///< points, true facets, point data and ids
  flipflop::Hull Hull;               ///< dimension and measures; statistics of all work so far
  flipflop::EngineReport Engine;

  /**
   * Become the hull of the input's points. The ids are those that the run has for them.
   *
   * @throw FFInexactValue, flipflop::Error; also in the next function.
   */
  void Take(const FFInput& input, bool passPointData, FFRun& run);

  /**
   * Become the hull of hulls, whose ids it takes over. Points were counted where they came from.
   */
  void Join(const std::vector<FFHullResult>& hulls, FFRun& run);

  /**
   * Points that are not finite have a say in the type of the points and in what data is passed,
   * even if none are left in their hull. One of their kind then speaks for them in the next Join(),
   * where it is left out again.
   */
  void KeepKind() const;
};
VTK_ABI_NAMESPACE_END

#endif
