// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFFailure
 * @brief   why a run gave no result
 *
 * vtkFFFailure says why a guarded run gave no result. It is separate from the error that users see,
 * so that several processes can agree on one error before it is reported.
 */

#ifndef vtkFFFailure_h
#define vtkFFFailure_h

#include "vtkFFMarks.h"
#include "vtkType.h"

#include <algorithm>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
struct vtkFFFailure
{
  /// The graver kinds come last.
  enum KindType
  {
    None,
    NonFinite,
    Other,
    Aborted
  };

  KindType Kind = None;
  vtkIdType Place = -1; ///< NonFinite: of the first such point, among all of the current blocks
  vtkIdType Count = 0;  ///< of points that are not finite, where these are at fault
  std::string Message;  ///< Other: a sentence

  /**
   * A failure of the kind Other.
   */
  void Say(const std::string& message)
  {
    this->Kind = Other;
    this->Message = message;
  }

  /**
   * Combine both: the graver one remains, or this one if they are equal. All points that are not
   * finite are counted.
   */
  void Add(const vtkFFFailure& other)
  {
    if (this->Kind == NonFinite && other.Kind == NonFinite)
    {
      this->Place = std::min(this->Place, other.Place);
      this->Count += other.Count;
    }
    else if (other.Kind > this->Kind)
    {
      *this = other;
    }
  }
};
VTK_ABI_NAMESPACE_END

#endif
