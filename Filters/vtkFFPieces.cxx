// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFPieces.h"

#include "vtkFFOutput.h"
#include "vtkFFPointSource.h"

#include <flipflop/Buffer.h>

#include "vtkDataSetAttributes.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

/// The points that are no ghosts; null: all.
vtkSmartPointer<vtkIdTypeArray> idsWithoutGhosts(vtkPointSet* piece)
{
  vtkUnsignedCharArray* marks = piece->GetPointGhostArray();
  const vtkIdType count = piece->GetNumberOfPoints();
  if (!marks || count == 0)
  {
    return nullptr;
  }
  if (marks->GetNumberOfValues() != count)
  {
    throw std::runtime_error(std::string("The point array ") +
      vtkDataSetAttributes::GhostArrayName() + " has " +
      std::to_string(marks->GetNumberOfValues()) + " value(s) for " + std::to_string(count) +
      " point(s). Mend or remove it, or turn off Skip Ghost Points.");
  }
  constexpr int ghost = vtkDataSetAttributes::DUPLICATEPOINT | vtkDataSetAttributes::HIDDENPOINT;
  auto ids = vtkSmartPointer<vtkIdTypeArray>::New();
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (!(marks->GetValue(i) & ghost))
    {
      ids->InsertNextValue(i);
    }
  }
  return ids->GetNumberOfValues() < count ? ids : nullptr;
}

}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPointSet> vtkFFPieces::Append(
  const std::vector<vtkPointSet*>& pieces, vtkIdType leftOut)
{
  const auto hasPoints = [](vtkPointSet* piece) { return piece->GetNumberOfPoints() > 0; };
  const auto first = std::find_if(pieces.begin(), pieces.end(), hasPoints);
  if (leftOut == 0 &&
    (pieces.size() == 1 ||
      (first != pieces.end() && std::none_of(first + 1, pieces.end(), hasPoints))))
  {
    return pieces.size() == 1 ? pieces[0] : *first;
  }
  std::vector<vtkDataArray*> arrays;
  std::vector<vtkFFOutput::Source> data;
  vtkIdType count = 0;
  for (vtkPointSet* piece : pieces)
  {
    arrays.push_back(piece->GetPoints() ? piece->GetPoints()->GetData() : nullptr);
    data.push_back({ piece->GetPointData(), piece->GetNumberOfPoints() });
    count += piece->GetNumberOfPoints();
  }
  count -= leftOut;
  flipflop::Buffer<std::int64_t> all(static_cast<std::size_t>(count));
  std::iota(all.begin(), all.end(), static_cast<std::int64_t>(leftOut));

  auto whole = vtkSmartPointer<vtkPolyData>::New();
  whole->SetPoints(vtkFFPointSource(arrays).Gather(all.data(), count));
  vtkFFOutput::CopyPointData(data, vtkFFOutput::AdoptIds(all), whole->GetPointData());
  return whole;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPointSet> vtkFFPieces::Select(vtkPointSet* piece, vtkIdTypeArray* which)
{
  const vtkIdType count = piece->GetNumberOfPoints();
  vtkNew<vtkPointData> from;
  vtkNew<vtkPointData> to;
  from->AddArray(piece->GetPoints()->GetData());
  vtkFFOutput::CopyPointData({ { from, count } }, which, to);
  vtkNew<vtkPoints> places;
  places->SetData(to->GetArray(0));
  auto points = vtkSmartPointer<vtkPolyData>::New();
  points->SetPoints(places);
  vtkFFOutput::CopyPointData({ { piece->GetPointData(), count } }, which, points->GetPointData());
  return points;
}

//------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkPointSet>> vtkFFPieces::SkipGhosts(
  const std::vector<vtkPointSet*>& pieces, std::vector<vtkIdType>& places)
{
  std::vector<vtkSmartPointer<vtkPointSet>> left;
  std::vector<vtkSmartPointer<vtkIdTypeArray>> ids;
  bool allLeft = true;
  for (vtkPointSet* piece : pieces)
  {
    ids.push_back(idsWithoutGhosts(piece));
    left.emplace_back(ids.back() ? Select(piece, ids.back()).Get() : piece);
    allLeft = allLeft && !ids.back();
  }
  places.clear();
  vtkIdType begin = 0;
  for (std::size_t k = 0; k < pieces.size() && !allLeft; ++k)
  {
    const vtkIdType count = left[k]->GetNumberOfPoints();
    for (vtkIdType i = 0; i < count; ++i)
    {
      places.push_back(begin + (ids[k] ? ids[k]->GetValue(i) : i));
    }
    begin += pieces[k]->GetNumberOfPoints();
  }
  return left;
}
VTK_ABI_NAMESPACE_END
