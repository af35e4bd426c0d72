// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFBlockFailures
 * @brief   the blocks of a composite that have no result
 *
 * vtkFFBlockFailures collects the blocks that failed, in the order of their flat indices. It makes
 * one error of them, whose length has a bound: the first block's message, and which blocks have no
 * result.
 */

#ifndef vtkFFBlockFailures_h
#define vtkFFBlockFailures_h

#include "vtkFFMarks.h"
#include "vtkType.h"

#include <cstddef>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkFFGuard;
struct vtkFFFailure;

class vtkFFBlockFailures
{
public:
  /**
   * The guard describes the failures; it does so while their blocks are worked on.
   */
  explicit vtkFFBlockFailures(vtkFFGuard& guard)
    : Guard(guard)
  {
  }

  /**
   * Add a block's failure, if there is one.
   */
  void Add(unsigned int flatIndex, const vtkFFFailure& failure);

  /**
   * Whether one of them is an abort. No other block needs to be worked on then.
   */
  bool IsAborted() const { return this->HasAbort; }

  /**
   * Whether one of so many blocks has a result; none has after an abort. What was added becomes the
   * failure of all.
   */
  bool Join(std::size_t numberOfBlocks, vtkFFFailure& failure) const;

private:
  std::string Describe(std::size_t numberOfBlocks) const;

  vtkFFGuard& Guard;
  bool HasAbort = false;
  std::size_t Count = 0;
  vtkIdType NonFinite = 0;
  std::string Message;               // of the first one
  std::vector<unsigned int> Indices; // of the first ones
};
VTK_ABI_NAMESPACE_END

#endif
