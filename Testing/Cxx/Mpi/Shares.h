// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// An output of which each process has a share, compared with what one process has.
#ifndef Shares_h
#define Shares_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace fftest
{

/// What a process has of an output.
struct Share
{
  vtkSmartPointer<vtkPolyData> Points;
  vtkSmartPointer<vtkPolyData> CellData; ///< as point data
  /// Of each cell its corners: an id each, or of a power diagram three coordinates.
  std::vector<std::vector<vtkIdType>> Cells;
};

/// The cells of an output, as in a share.
std::vector<std::vector<vtkIdType>> cellKeysOf(vtkPolyData* data);

/// All processes' shares, on process 0; none on the others. Collective.
std::vector<Share> gatherShares(vtkPolyData* own);

/// Whether the shares of all processes are the output of one, which process 0 has: its points, each
/// unmarked on one process, its cells, each on one process, and their data. Says what is not so.
/// Collective.
bool areSharesOf(vtkPolyData* own, vtkPolyData* whole, const std::string& what);

}

#endif
