// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFPieces.h"

#include "vtkFFOutput.h"
#include "vtkFFPointSource.h"

#include "Buffer.h"

#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
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

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPointSet> vtkFFPieces::Append(const std::vector<vtkPointSet*>& pieces)
{
  const auto hasPoints = [](vtkPointSet* piece) { return piece->GetNumberOfPoints() > 0; };
  const auto first = std::find_if(pieces.begin(), pieces.end(), hasPoints);
  if (pieces.size() == 1 ||
    (first != pieces.end() && std::none_of(first + 1, pieces.end(), hasPoints)))
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
  flipflop::Buffer<std::int64_t> all(static_cast<std::size_t>(count));
  std::iota(all.begin(), all.end(), std::int64_t(0));

  auto whole = vtkSmartPointer<vtkPolyData>::New();
  whole->SetPoints(vtkFFPointSource(arrays).Gather(all.data(), count));
  vtkFFOutput::CopyPointData(data, vtkFFOutput::AdoptIds(all), whole->GetPointData());
  return whole;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPointSet> vtkFFPieces::OwnPoints(vtkPointSet* piece)
{
  vtkUnsignedCharArray* ghosts = piece->GetPointGhostArray();
  const vtkIdType count = ghosts ? piece->GetNumberOfPoints() : 0;
  vtkNew<vtkIdTypeArray> own;
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (!(ghosts->GetValue(i) & vtkDataSetAttributes::DUPLICATEPOINT))
    {
      own->InsertNextValue(i);
    }
  }
  if (own->GetNumberOfValues() == count)
  {
    return piece;
  }

  vtkNew<vtkIdList> ids;
  ids->SetNumberOfIds(own->GetNumberOfValues());
  std::copy_n(own->GetPointer(0), own->GetNumberOfValues(), ids->GetPointer(0));
  vtkNew<vtkPoints> places;
  places->SetDataType(piece->GetPoints()->GetDataType());
  piece->GetPoints()->GetPoints(ids, places);
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(places);
  vtkFFOutput::CopyPointData({ { piece->GetPointData(), count } }, own, result->GetPointData());
  return result;
}
