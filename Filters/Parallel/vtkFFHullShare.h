// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFHullShare
 * @brief   the hull of distributed points, of which each process keeps a share
 *
 * Where nearly all points are extreme, as on a thin shell, no process need hold them all. The
 * extreme points of the pieces are dealt out to blocks by their direction from the middle, one
 * block for each process. The blocks find their facets. Then each process fetches the points of its
 * facets, with their data, from where they came.
 */

#ifndef vtkFFHullShare_h
#define vtkFFHullShare_h

#include "vtkFFMarks.h"
#include "vtkSmartPointer.h"

#include <flipflop/Hull.h>
#include <flipflop/Options.h>

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkFFBlockExchange;
class vtkPolyData;

class vtkFFHullShare
{
public:
  /**
   * This process's share of the hull of all processes' points. Collective, as
   * vtkFFBlockExchange::Exchange() is.
   *
   * @param extremes this process's points with their data, among them all that are extreme, in the
   *                 order of their ids. Points that are not finite count for their kind alone.
   * @param hull     becomes the dimension, volume and area of the whole; its statistics are added
   *                 to
   * @param share    becomes the process's facets, with their points
   * @param duplicates becomes whether another process counts each of these points
   */
  static void Take(vtkPolyData* extremes, const flipflop::Options& options,
    vtkFFBlockExchange& exchange, flipflop::Hull& hull, vtkSmartPointer<vtkPolyData>& share,
    std::vector<bool>& duplicates);
};
VTK_ABI_NAMESPACE_END

#endif
