// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFDuplicates
 * @brief   which points of an output other processes count
 *
 * A point on the border of two shares is in both. Of the processes that have it, all but one mark
 * it as a duplicate, so that a sum over processes counts each point once.
 */

#ifndef vtkFFDuplicates_h
#define vtkFFDuplicates_h

#include "vtkFFMarks.h"

#include <flipflop/Buffer.h>

#include <array>
#include <cstdint>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSetAttributes;
class vtkFFBlockExchange;

class vtkFFDuplicates
{
public:
  /**
   * Whether each of this process's points is another's: that of its block, if that has it, or of
   * the first process that does. Collective, as is the next function.
   *
   * @param ids    distinct over all processes
   * @param blocks the process to which each belongs
   */
  static void FindByIds(const flipflop::Buffer<std::int64_t>& ids,
    const flipflop::Buffer<std::int32_t>& blocks, vtkFFBlockExchange& exchange,
    std::vector<bool>& duplicates);

  /**
   * The same for points that have no ids: those of the same position, x and y of each, are one.
   */
  static void FindByPlaces(const flipflop::Buffer<double>& places, vtkFFBlockExchange& exchange,
    std::vector<bool>& duplicates);

  /**
   * Set a mark where that is so, and nowhere else, in an array of marks that may be there already.
   */
  static void Mark(vtkDataSetAttributes* data, const std::vector<bool>& where, int mark);

private:
  using Key = std::array<std::int64_t, 2>;
  static void Find(const std::vector<Key>& keys, const std::vector<int>& homes,
    vtkFFBlockExchange& exchange, std::vector<bool>& duplicates);
};
VTK_ABI_NAMESPACE_END

#endif
