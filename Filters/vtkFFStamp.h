// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFStamp
 * @brief   what a result was made of
 *
 * vtkFFStamp has the identities and times of the data that a result was made of, and the settings
 * that it depends on. Where two are equal, so are the results: a filter that kept one need not make
 * the other.
 */

#ifndef vtkFFStamp_h
#define vtkFFStamp_h

#include "vtkFFInput.h"
#include "vtkFFMarks.h"

#include "vtkDataObject.h"

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkFFStamp
{
public:
  /**
   * Of nothing: it equals no other.
   */
  vtkFFStamp() = default;

  /**
   * Of an input of a vtkFFAlgorithm or the second one of a vtkFFQueryAlgorithm, and of all settings
   * but those that the filter changes with ChangeOutput().
   */
  template <class Filter>
  vtkFFStamp(Filter* filter, vtkDataObject* input)
    : Words{ filter->ResultTime }
  {
    // A composite does not know when its data sets change.
    this->AddData(input);
    for (const vtkFFInput::PieceType& piece : vtkFFInput::PiecesOf(input))
    {
      this->AddData(piece.Data);
    }
  }

  //@{
  /**
   * Further settings. An object is one with its state; it may be null.
   */
  void Add(vtkObject* object)
  {
    this->Words.push_back(reinterpret_cast<std::uintptr_t>(object));
    this->Words.push_back(object ? object->GetMTime() : 0);
  }
  void Add(double setting)
  {
    std::uint64_t word;
    std::memcpy(&word, &setting, sizeof(word));
    this->Words.push_back(word);
  }
  void Add(const std::string& setting)
  {
    this->Words.insert(this->Words.end(), setting.begin(), setting.end());
    this->Words.push_back(setting.size());
  }
  //@}

  bool operator==(const vtkFFStamp& other) const
  {
    return !this->Words.empty() && this->Words == other.Words;
  }

private:
  /// No two states of any data have the same time.
  void AddData(vtkDataObject* data)
  {
    this->Add(data);
    this->Words.push_back(data ? data->GetUpdateTime() : 0);
  }

  std::vector<std::uint64_t> Words;
};
VTK_ABI_NAMESPACE_END

#endif
