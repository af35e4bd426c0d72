// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// An output of which each process has a share, joined to what one process would have.
#ifndef Shares_h
#define Shares_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkDataObject;

namespace fftest
{

/// What a process has of an output.
struct Share
{
  vtkSmartPointer<vtkPolyData> Points;
  vtkSmartPointer<vtkPolyData> CellData;     // as point data
  std::vector<std::vector<vtkIdType>> Cells; // by their corners' ids; of a diagram, their places
};

/// All processes' shares, on process 0; none on the others. Collective.
std::vector<Share> gatherShares(vtkPolyData* own);

/// What all processes have of an output, on process 0: points by ascending id, each once; cells in
/// canonical form, as often as they are there; their data. All processes but one must mark a point
/// as a duplicate. The corners of a power diagram, which have no ids, are numbered as one process
/// would. Null on the others. A point that several have must be the same, and all must have the
/// same arrays: otherwise it is a failure. Leaves of composites are joined with those in the same
/// place. Collective.
vtkSmartPointer<vtkDataObject> joinShares(vtkDataObject* own);

}

#endif
