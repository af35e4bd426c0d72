// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFHullFilter::vtkInternals::Result
 * @brief   a hull that may be joined to others
 */

#ifndef vtkFFHullResult_h
#define vtkFFHullResult_h

#include "vtkFFHullInternals.h"
#include "vtkFFMarks.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <flipflop/Engines.h>

VTK_ABI_NAMESPACE_BEGIN
struct vtkFFHullFilter::vtkInternals::Result
{
  vtkSmartPointer<vtkPolyData> Data = vtkSmartPointer<vtkPolyData>::New();
  flipflop::Hull Hull; ///< its statistics are of all work so far
  flipflop::EngineReport Engine;
};
VTK_ABI_NAMESPACE_END

#endif
