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

#include "vtkFFAlgorithm.h"
#include "vtkFFInput.h"
#include "vtkFFMarks.h"
#include "vtkFFQueryAlgorithm.h"

#include "vtkCompositeDataSet.h"
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
   * Of an input, and of all settings but those that a filter changes with ChangeOutput().
   */
  vtkFFStamp(vtkFFAlgorithm* filter, vtkDataObject* input)
  {
    this->Add(input);
    this->Words.push_back(filter->ResultTime);
  }

  /**
   * The same of a second input, which a filter queries.
   */
  vtkFFStamp(vtkFFQueryAlgorithm* filter, vtkDataObject* input)
  {
    this->Add(input);
    this->Words.push_back(filter->ResultTime);
  }

  /**
   * Further data, which may be null. No two states of any data have the same time. A composite does
   * not know when its data sets change.
   */
  void Add(vtkDataObject* data)
  {
    this->AddTime(data);
    if (vtkCompositeDataSet::SafeDownCast(data))
    {
      for (const vtkFFInput::PieceType& piece : vtkFFInput::PiecesOf(data))
      {
        this->AddTime(piece.Data);
      }
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
  void AddTime(vtkDataObject* data)
  {
    this->Add(static_cast<vtkObject*>(data));
    this->Words.push_back(data ? data->GetUpdateTime() : 0);
  }

  std::vector<std::uint64_t> Words;
};
VTK_ABI_NAMESPACE_END

#endif
