// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFFailure
 * @brief   why a run gave no result
 *
 * vtkFFFailure says why a run gave no result. It is separate from the error that users see, so that
 * several processes can agree on one error before it is reported. vtkFFBadSetting is thrown for
 * settings that do not go together, vtkFFBadConstraint for constraints that do not.
 */

#ifndef vtkFFFailure_h
#define vtkFFFailure_h

#include "vtkFFErrorCode.h"
#include "vtkFFMarks.h"
#include "vtkType.h"

#include <algorithm>
#include <stdexcept>
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
  vtkIdType Place = -1;                               ///< NonFinite: the id of the first such point
  vtkIdType Count = 0;                                ///< NonFinite: of such points
  unsigned long Code = vtkFFErrorCode::InternalError; ///< Other
  std::string Message;                                ///< Other: a sentence

  explicit operator bool() const { return this->Kind != None; }

  /**
   * A failure of the kind Other.
   */
  void Say(const std::string& message, unsigned long code = vtkFFErrorCode::InputError)
  {
    this->Kind = Other;
    this->Code = code;
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

class vtkFFBadSetting : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

class vtkFFBadConstraint : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};
VTK_ABI_NAMESPACE_END

#endif
