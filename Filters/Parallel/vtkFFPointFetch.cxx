// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFPointFetch.h"

#include "vtkFFBlockExchange.h"
#include "vtkFFParcel.h"
#include "vtkFFPieces.h"

#include <flipflop/Error.h>

#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

/// Some points of a piece, as a message.
std::vector<char> packSome(
  vtkPointSet* piece, const std::vector<vtkIdType>& which, vtkIdType begin, bool withData)
{
  vtkNew<vtkIdTypeArray> places;
  for (const vtkIdType id : which)
  {
    if (id < begin || id >= begin + piece->GetNumberOfPoints())
    {
      throw vtkFFDamagedParcel();
    }
    places->InsertNextValue(id - begin);
  }
  vtkNew<vtkPolyData> bare;
  if (!withData)
  {
    bare->SetPoints(piece->GetPoints());
    piece = bare;
  }
  const std::string parcel = vtkFFParcel::Pack(vtkFFPieces::Select(piece, places));
  return { parcel.begin(), parcel.end() };
}

vtkSmartPointer<vtkPointSet> unpack(const std::vector<char>& message)
{
  return vtkFFParcel::Unpack(std::string(message.begin(), message.end()));
}

}

//------------------------------------------------------------------------------
void vtkFFPointFetch::Count(vtkIdType points)
{
  this->Begins = { 0 };
  std::int64_t end = 0;
  for (const vtkIdType count : this->Exchange.GetProcesses().Gather({ points }))
  {
    end += count;
    this->Begins.push_back(static_cast<vtkIdType>(end));
  }
  this->Exchange.Do(
    [&]
    {
      if (end > VTK_ID_MAX) // of a VTK whose ids have 32 bits
      {
        throw flipflop::Error(flipflop::ErrorCode::TooManyPoints, -1, end);
      }
    });
}

//------------------------------------------------------------------------------
vtkIdType vtkFFPointFetch::GetBegin() const
{
  return this->Begins[static_cast<std::size_t>(this->Exchange.GetProcesses().GetRank())];
}

//------------------------------------------------------------------------------
bool vtkFFPointFetch::HasSeveralSources() const
{
  // The ids of the first process that has points are not all.
  const auto first = std::upper_bound(this->Begins.begin(), this->Begins.end(), vtkIdType(0));
  return first != this->Begins.end() && *first < this->Begins.back();
}

//------------------------------------------------------------------------------
void vtkFFPointFetch::SetPoints(vtkPointSet* own)
{
  const int count = this->Exchange.GetProcesses().GetCount();
  this->Own = own;
  vtkFFBlockExchange::Messages messages;
  this->Exchange.Do(
    [&]
    {
      if (own->GetNumberOfPoints() > 0)
      {
        messages[0] = packSome(own, { this->GetBegin() }, this->GetBegin(), true);
      }
    });
  this->Exchange.Exchange(messages);
  this->Exchange.Do(
    [&]
    {
      std::vector<vtkSmartPointer<vtkPointSet>> kinds;
      for (const auto& message : messages)
      {
        kinds.push_back(unpack(message.second));
      }
      messages.clear();
      if (!kinds.empty())
      {
        const auto all = vtkFFPieces::Append({ kinds.begin(), kinds.end() });
        const std::vector<char> kind = packSome(all, { 0 }, 0, true);
        for (int process = 0; process < count; ++process)
        {
          messages[process] = kind;
        }
      }
    });
  this->Exchange.Exchange(messages);
  this->Exchange.Do([&] { this->Kind = messages.empty() ? this->Own : unpack(messages[0]); });
  this->Exchange.Agree();
}

//------------------------------------------------------------------------------
void vtkFFPointFetch::Fetch(
  const std::vector<vtkIdType>& ids, bool withData, vtkSmartPointer<vtkPointSet>& points)
{
  vtkFFBlockExchange::Messages messages;
  this->Exchange.Do(
    [&]
    {
      auto begin = ids.begin();
      for (std::size_t process = 0; begin != ids.end(); ++process)
      {
        const auto end = std::lower_bound(begin, ids.end(), this->Begins[process + 1]);
        if (begin != end)
        {
          vtkFFBlockExchange::Add(
            &*begin, static_cast<std::size_t>(end - begin), messages[static_cast<int>(process)]);
        }
        begin = end;
      }
    });
  this->Exchange.Exchange(messages);
  this->Exchange.Do(
    [&]
    {
      for (auto& message : messages)
      {
        message.second = packSome(this->Own, vtkFFBlockExchange::Values<vtkIdType>(message.second),
          this->GetBegin(), withData);
      }
    });
  this->Exchange.Exchange(messages);
  this->Exchange.Do(
    [&]
    {
      // The kind has a say in the type and in what is passed. If only one process has points, it
      // has none: it may lack data that has no name.
      vtkSmartPointer<vtkPointSet> kind = this->Kind;
      if (!withData)
      {
        kind = vtkSmartPointer<vtkPolyData>::New();
        kind->SetPoints(this->Kind->GetPoints());
      }
      if (ids.empty())
      {
        points = kind;
        return;
      }
      std::vector<vtkSmartPointer<vtkPointSet>> parts;
      if (this->HasSeveralSources())
      {
        parts.push_back(kind);
      }
      const auto leftOut = static_cast<vtkIdType>(parts.size());
      for (auto& message : messages)
      {
        parts.push_back(unpack(message.second));
        std::vector<char>().swap(message.second);
      }
      points = vtkFFPieces::Append({ parts.begin(), parts.end() }, leftOut);
      if (points->GetNumberOfPoints() != static_cast<vtkIdType>(ids.size()))
      {
        throw vtkFFDamagedParcel();
      }
    });
  this->Exchange.Agree();
}
VTK_ABI_NAMESPACE_END
