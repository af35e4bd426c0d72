// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFMessage
 * @brief   plain values as bytes, for another process
 *
 * Both processes must run on machines of the same kind: values are sent as they are in memory.
 */

#ifndef vtkFFMessage_h
#define vtkFFMessage_h

#include "vtkFFMarks.h"
#include "vtkFFParcel.h"

#include <cstddef>
#include <cstring>
#include <type_traits>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkFFMessage
{
public:
  /**
   * Add values to the end of a message.
   */
  template <class T>
  static void Add(const T* values, std::size_t count, std::vector<char>& message)
  {
    static_assert(std::is_trivially_copyable<T>::value, "only plain values can be sent");
    const char* bytes = reinterpret_cast<const char*>(values);
    message.insert(message.end(), bytes, bytes + count * sizeof(T));
  }

  /**
   * The values of a message that holds nothing else.
   *
   * @throw vtkFFDamagedParcel for a message that is not a number of such values.
   */
  template <class T>
  static std::vector<T> Values(const std::vector<char>& message)
  {
    static_assert(std::is_trivially_copyable<T>::value, "only plain values can be sent");
    if (message.size() % sizeof(T) != 0)
    {
      throw vtkFFDamagedParcel();
    }
    std::vector<T> values(message.size() / sizeof(T));
    if (!values.empty())
    {
      std::memcpy(values.data(), message.data(), message.size());
    }
    return values;
  }
};
VTK_ABI_NAMESPACE_END

#endif
