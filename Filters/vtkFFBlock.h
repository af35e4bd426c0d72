// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFBlock
 * @brief   a block of a filter's input
 *
 * vtkFFBlock is a leaf of the input, or a vtkPartitionedDataSet, whose partitions are the pieces of
 * one data set.
 */

#ifndef vtkFFBlock_h
#define vtkFFBlock_h

#include "vtkFFMarks.h"
#include "vtkType.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPointSet;

struct vtkFFBlock
{
  std::vector<vtkPointSet*> Pieces; ///< those here
  unsigned int FlatIndex;           ///< 0 where the input itself is the only block
  vtkIdType NumberOfPoints;         ///< wherever they are
  std::string Fault{};              ///< why it has no pieces, though it has data: a sentence

  /**
   * Whether there is something to work on here, right or wrong.
   */
  bool HasData() const { return !this->Pieces.empty() || !this->Fault.empty(); }
};
VTK_ABI_NAMESPACE_END

#endif
