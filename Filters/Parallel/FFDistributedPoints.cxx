// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFDistributedPoints.h"

#include "FFOutput.h"
#include "FFPointMessage.h"
#include "FFProcesses.h"

#include <flipflop/Error.h>

#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

vtkSmartPointer<vtkPointSet> withoutData(vtkPointSet* points)
{
  auto bare = vtkSmartPointer<vtkPolyData>::New();
  bare->SetPoints(points->GetPoints());
  return bare;
}

/// The points of these ids, of a piece whose ids begin there.
vtkSmartPointer<vtkPointSet> select(
  vtkPointSet* piece, const std::vector<vtkIdType>& ids, vtkIdType begin)
{
  vtkNew<vtkIdTypeArray> indices;
  for (const vtkIdType id : ids)
  {
    indices->InsertNextValue(id - begin);
  }
  return FFOutput::Select(piece, indices);
}

}

//------------------------------------------------------------------------------
void FFDistributedPoints::Count(vtkIdType points)
{
  this->Begins = { 0 };
  std::int64_t end = 0;
  for (const std::vector<vtkIdType>& count : this->Processes.Gather<vtkIdType>({ points }))
  {
    end += count[0];
    this->Begins.push_back(static_cast<vtkIdType>(end));
  }
  if (end > VTK_ID_MAX) // of a VTK whose ids have 32 bits
  {
    throw flipflop::Error(flipflop::ErrorCode::TooManyPoints, -1, end);
  }
}

//------------------------------------------------------------------------------
vtkIdType FFDistributedPoints::GetBegin() const
{
  return this->Begins[static_cast<std::size_t>(this->Processes.GetRank())];
}

//------------------------------------------------------------------------------
int FFDistributedPoints::GetNumberOfSources() const
{
  int sources = 0;
  for (std::size_t k = 1; k < this->Begins.size(); ++k)
  {
    sources += this->Begins[k] > this->Begins[k - 1];
  }
  return sources;
}

//------------------------------------------------------------------------------
void FFDistributedPoints::SetPoints(vtkPointSet* own)
{
  this->Own = own;
  FFProcesses::Message first;
  if (own->GetNumberOfPoints() > 0)
  {
    first = FFPointMessage::Pack(select(own, { 0 }, 0));
  }
  std::vector<vtkSmartPointer<vtkPointSet>> firsts;
  for (const FFProcesses::Message& message : this->Processes.Gather(first))
  {
    if (!message.empty())
    {
      firsts.emplace_back(FFPointMessage::Unpack(message));
    }
  }
  this->Kind = firsts.empty()
    ? own
    : select(FFOutput::Append({ firsts.begin(), firsts.end() }), { 0 }, 0).Get();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPointSet> FFDistributedPoints::Fetch(
  const std::vector<vtkIdType>& ids, bool withData)
{
  FFProcesses::Messages messages;
  auto begin = ids.begin();
  for (int process = 0; begin != ids.end(); ++process)
  {
    const auto end =
      std::lower_bound(begin, ids.end(), this->Begins[static_cast<std::size_t>(process) + 1]);
    if (begin != end)
    {
      FFProcesses::Append(&*begin, static_cast<std::size_t>(end - begin), messages[process]);
    }
    begin = end;
  }
  const auto own = withData ? this->Own : withoutData(this->Own);
  this->Processes.Query(messages,
    [&](const FFProcesses::Message& wanted)
    {
      return FFPointMessage::Pack(
        select(own, FFProcesses::ValuesOf<vtkIdType>(wanted), this->GetBegin()));
    });
  const auto kind = withData ? this->Kind : withoutData(this->Kind);
  if (ids.empty())
  {
    return kind;
  }
  // The kind decides the type and what data is passed. If only one process has points, it does not:
  // it may lack data that has no name.
  std::vector<vtkSmartPointer<vtkPointSet>> parts;
  if (this->GetNumberOfSources() > 1)
  {
    parts.push_back(kind);
  }
  const auto leftOut = static_cast<vtkIdType>(parts.size());
  for (auto& message : messages)
  {
    parts.emplace_back(FFPointMessage::Unpack(std::move(message.second)));
  }
  return FFOutput::Append({ parts.begin(), parts.end() }, leftOut);
}
VTK_ABI_NAMESPACE_END
