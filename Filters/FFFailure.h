// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Why a run gave no result, in a sentence; and what is thrown for it.
 */

#ifndef FFFailure_h
#define FFFailure_h

#include "vtkFFErrorCode.h"
#include "vtkFFMarks.h"
#include "vtkType.h"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
/**
 * Thrown for settings that do not go together, and for constraints that do not.
 */
class FFBadSetting : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

class FFBadConstraint : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/**
 * Apart from the error that users see, so that several processes can agree on one before it is
 * reported.
 */
struct FFFailure
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
  vtkIdType Point = -1;                               ///< NonFinite: the id of the first such point
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
  void Add(const FFFailure& other)
  {
    if (this->Kind == NonFinite && other.Kind == NonFinite)
    {
      this->Point = std::min(this->Point, other.Point);
      this->Count += other.Count;
    }
    else if (other.Kind > this->Kind)
    {
      *this = other;
    }
  }

  /**
   * The failure that the exception is which is being handled.
   *
   * @param idOf  the id of a point that the engine counts
   * @param where the point of an id in words: "point 7 of the block of flat index 2"
   * @param of    which data set it is: " of the block of flat index 2", or nothing
   */
  static FFFailure OfException(const std::function<vtkIdType(vtkIdType)>& idOf,
    const std::function<std::string(vtkIdType)>& where, const std::string& of);

  /**
   * @throw FFBadSetting unless the setting of that name is a length, or 0, which means @p zero.
   */
  static void CheckLength(double length, const char* name, const char* zero);
};
VTK_ABI_NAMESPACE_END

#endif
