// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shares.h"

#include "Twins.h"
#include "vtkFFParcel.h"

#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkFieldData.h"
#include "vtkMultiProcessController.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <map>

namespace fftest
{
namespace
{

/// All processes' texts, on process 0.
std::vector<std::string> gather(const std::string& own)
{
  auto* controller = vtkMultiProcessController::GetGlobalController();
  std::vector<std::string> all{ own };
  auto size = static_cast<vtkIdType>(own.size());
  if (rank() > 0)
  {
    controller->Send(&size, 1, 0, 1);
    controller->Send(own.data(), size, 0, 2);
    return {};
  }
  for (int process = 1; process < processes(); ++process)
  {
    controller->Receive(&size, 1, process, 1);
    all.emplace_back(static_cast<std::size_t>(size), '\0');
    controller->Receive(&all.back()[0], size, process, 2);
  }
  return all;
}

vtkCellArray* cellsOf(vtkPolyData* data, int kind)
{
  return kind == 0 ? data->GetVerts() : kind == 1 ? data->GetLines() : data->GetPolys();
}

/// Vertices, lines or polygons; -1: no cells.
int kindOf(vtkPolyData* data)
{
  int kind = -1;
  for (int k = 0; k < 3; ++k)
  {
    kind = cellsOf(data, k)->GetNumberOfCells() > 0 ? k : kind;
  }
  return kind;
}

/// Power diagrams have ids for their cells alone.
bool isDiagram(vtkPolyData* data)
{
  return data->GetCellData()->HasArray("vtkOriginalPointIds") != 0;
}

/// The cells of one kind, each as the places of its corners.
std::vector<std::vector<vtkIdType>> cellsByPlaces(vtkCellArray* cells)
{
  std::vector<std::vector<vtkIdType>> byPlaces;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    cells->GetCellAtId(i, size, corners);
    byPlaces.emplace_back(corners, corners + size);
  }
  return byPlaces;
}

/// Where values are: in whose share, and at which place there.
using Places = std::vector<std::pair<std::size_t, vtkIdType>>;

vtkSmartPointer<vtkAbstractArray> select(
  const std::vector<vtkAbstractArray*>& parts, const Places& places)
{
  vtkSmartPointer<vtkAbstractArray> array;
  array.TakeReference(parts[0]->NewInstance());
  array->SetName(parts[0]->GetName());
  array->SetNumberOfComponents(parts[0]->GetNumberOfComponents());
  array->CopyComponentNames(parts[0]);
  for (const auto& place : places)
  {
    array->InsertNextTuple(place.second, parts[place.first]);
  }
  return array;
}

void select(
  const std::vector<vtkDataSetAttributes*>& parts, const Places& places, vtkDataSetAttributes* to)
{
  for (int i = 0; i < parts[0]->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* first = parts[0]->GetAbstractArray(i);
    std::vector<vtkAbstractArray*> arrays;
    for (vtkDataSetAttributes* part : parts)
    {
      FF_CHECK_EQUAL(part->GetNumberOfArrays(), parts[0]->GetNumberOfArrays());
      vtkAbstractArray* array = part->GetAbstractArray(i);
      if (!array || array->GetDataType() != first->GetDataType() ||
        std::string(array->GetName() ? array->GetName() : "") !=
          (first->GetName() ? first->GetName() : ""))
      {
        std::cerr << "not all processes have the same arrays\n";
        ++failures();
        return;
      }
      arrays.push_back(array);
    }
    const int index = to->AddArray(select(arrays, places));
    for (int attribute = 0; attribute < vtkDataSetAttributes::NUM_ATTRIBUTES; ++attribute)
    {
      if (parts[0]->GetAbstractAttribute(attribute) == first)
      {
        to->SetActiveAttribute(index, attribute);
      }
    }
  }
}

/// Takes the marks of duplicates away. Returns how many points have none.
vtkIdType countOwned(const std::vector<Share>& shares)
{
  constexpr int mark = vtkDataSetAttributes::DUPLICATEPOINT;
  vtkIdType owned = 0;
  for (const Share& share : shares)
  {
    const vtkIdType count = share.Points->GetNumberOfPoints();
    vtkDataArray* marks =
      share.Points->GetPointData()->GetArray(vtkDataSetAttributes::GhostArrayName());
    for (vtkIdType i = 0; i < count; ++i)
    {
      const int value = marks ? static_cast<int>(marks->GetTuple1(i)) : 0;
      owned += !(value & mark);
      if (marks)
      {
        marks->SetTuple1(i, value & ~mark);
      }
    }
  }
  return owned;
}

/// The points of all shares; returns their ids.
std::vector<vtkIdType> joinPoints(const std::vector<Share>& shares, vtkPolyData* joined)
{
  std::map<vtkIdType, std::pair<std::size_t, vtkIdType>> firsts;
  Places others; // further places of points
  Places theirFirsts;
  for (std::size_t process = 0; process < shares.size(); ++process)
  {
    vtkPolyData* points = shares[process].Points; // none after an error
    const auto ids =
      points->GetNumberOfPoints() > 0 ? originalIds(points) : std::vector<vtkIdType>();
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      const std::pair<std::size_t, vtkIdType> place{ process, static_cast<vtkIdType>(i) };
      const auto added = firsts.emplace(ids[i], place);
      if (!added.second)
      {
        others.push_back(place);
        theirFirsts.push_back(added.first->second);
      }
    }
  }
  std::vector<vtkIdType> ids;
  Places places;
  for (const auto& first : firsts)
  {
    ids.push_back(first.first);
    places.push_back(first.second);
  }
  const auto take = [&](const Places& which, vtkPolyData* to)
  {
    std::vector<vtkAbstractArray*> points;
    std::vector<vtkDataSetAttributes*> data;
    for (const Share& share : shares)
    {
      data.push_back(share.Points->GetPointData());
      points.push_back(share.Points->GetPoints() ? share.Points->GetPoints()->GetData() : nullptr);
      FF_CHECK((points.back() ? points.back()->GetDataType() : 0) ==
        (points[0] ? points[0]->GetDataType() : 0));
    }
    if (points[0])
    {
      vtkNew<vtkPoints> array;
      array->SetData(vtkDataArray::SafeDownCast(select(points, which)));
      to->SetPoints(array);
    }
    select(data, which, to->GetPointData());
  };
  take(places, joined);
  vtkNew<vtkPolyData> again;
  vtkNew<vtkPolyData> first;
  take(others, again);
  take(theirFirsts, first);
  FF_CHECK(isIdentical(again, first, "a point that several processes have"));
  return ids;
}

vtkSmartPointer<vtkPolyData> joinDiagrams(vtkPolyData* own)
{
  const std::vector<Share> shares = gatherShares(own);
  if (rank() > 0)
  {
    return nullptr;
  }
  const vtkIdType owned = countOwned(shares);
  auto joined = vtkSmartPointer<vtkPolyData>::New();
  std::map<vtkIdType, std::pair<std::size_t, vtkIdType>> sites;
  std::vector<vtkDataSetAttributes*> data;
  for (std::size_t process = 0; process < shares.size(); ++process)
  {
    data.push_back(shares[process].CellData->GetPointData());
    vtkDataArray* ids = shares[process].CellData->GetPointData()->GetArray("vtkOriginalPointIds");
    for (vtkIdType i = 0; ids && i < ids->GetNumberOfTuples(); ++i)
    {
      const auto id = static_cast<vtkIdType>(ids->GetTuple1(i));
      FF_CHECK(sites.emplace(id, std::make_pair(process, i)).second);
    }
  }
  Places places;
  std::map<Point, vtkIdType> numbers; // of corners, in the order of their first use
  vtkNew<vtkPoints> corners;
  corners->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (const auto& site : sites)
  {
    places.push_back(site.second);
    const Share& share = shares[site.second.first];
    const auto& cell = share.Cells[static_cast<std::size_t>(site.second.second)];
    cells->InsertNextCell(static_cast<int>(cell.size()));
    for (const vtkIdType place : cell)
    {
      Point corner;
      share.Points->GetPoint(place, corner.data());
      const auto number = numbers.emplace(corner, corners->GetNumberOfPoints());
      if (number.second)
      {
        corners->InsertNextPoint(corner.data());
      }
      cells->InsertCellPoint(number.first->second);
    }
  }
  joined->SetPoints(corners);
  FF_CHECK_EQUAL(owned, joined->GetNumberOfPoints());
  if (!sites.empty())
  {
    joined->SetPolys(cells);
  }
  select(data, places, joined->GetCellData());
  joined->GetFieldData()->PassData(own->GetFieldData());
  return joined;
}

vtkSmartPointer<vtkPolyData> join(vtkPolyData* own)
{
  int ownIs = isDiagram(own);
  int anyIs = 0;
  vtkMultiProcessController::GetGlobalController()->AllReduce(
    &ownIs, &anyIs, 1, vtkCommunicator::MAX_OP);
  if (anyIs)
  {
    return joinDiagrams(own);
  }
  // What kind of cells there are: some may have none.
  int ownKind = kindOf(own);
  int kind = -1;
  vtkMultiProcessController::GetGlobalController()->AllReduce(
    &ownKind, &kind, 1, vtkCommunicator::MAX_OP);
  const std::vector<Share> shares = gatherShares(own);
  if (rank() > 0)
  {
    return nullptr;
  }
  auto joined = vtkSmartPointer<vtkPolyData>::New();
  const vtkIdType owned = countOwned(shares);
  const std::vector<vtkIdType> ids = joinPoints(shares, joined);
  FF_CHECK_EQUAL(owned, joined->GetNumberOfPoints());
  std::vector<std::pair<std::vector<vtkIdType>, std::pair<std::size_t, vtkIdType>>> cells;
  std::vector<vtkDataSetAttributes*> data;
  for (std::size_t process = 0; process < shares.size(); ++process)
  {
    data.push_back(shares[process].CellData->GetPointData());
    for (std::size_t i = 0; i < shares[process].Cells.size(); ++i)
    {
      cells.push_back({ shares[process].Cells[i], { process, static_cast<vtkIdType>(i) } });
    }
  }
  std::sort(cells.begin(), cells.end());
  Places places;
  vtkNew<vtkCellArray> array;
  for (const auto& cell : cells)
  {
    places.push_back(cell.second);
    array->InsertNextCell(static_cast<int>(cell.first.size()));
    for (const vtkIdType id : cell.first)
    {
      array->InsertCellPoint(std::lower_bound(ids.begin(), ids.end(), id) - ids.begin());
    }
  }
  if (kind == 0)
  {
    joined->SetVerts(array);
  }
  else if (kind == 1)
  {
    joined->SetLines(array);
  }
  else if (kind == 2)
  {
    joined->SetPolys(array);
  }
  select(data, places, joined->GetCellData());
  joined->GetFieldData()->PassData(own->GetFieldData());
  return joined;
}

}

//------------------------------------------------------------------------------
std::vector<Share> gatherShares(vtkPolyData* own)
{
  const int kind = kindOf(own);
  const std::vector<std::vector<vtkIdType>> cells = kind < 0 ? std::vector<std::vector<vtkIdType>>()
    : isDiagram(own)                                         ? cellsByPlaces(cellsOf(own, kind))
                     : cellsByOriginalIds(own, cellsOf(own, kind));
  std::string packed;
  for (const auto& cell : cells)
  {
    const auto size = static_cast<vtkIdType>(cell.size());
    packed.append(reinterpret_cast<const char*>(&size), sizeof(size));
    packed.append(reinterpret_cast<const char*>(cell.data()), cell.size() * sizeof(vtkIdType));
  }
  vtkNew<vtkPolyData> cellData;
  cellData->GetPointData()->ShallowCopy(own->GetCellData());
  const auto points = gather(vtkFFParcel::Pack(own));
  const auto data = gather(vtkFFParcel::Pack(cellData));
  const auto lists = gather(packed);
  std::vector<Share> shares;
  for (std::size_t process = 0; process < points.size(); ++process)
  {
    Share share{ vtkFFParcel::Unpack(points[process]), vtkFFParcel::Unpack(data[process]), {} };
    std::vector<vtkIdType> numbers(lists[process].size() / sizeof(vtkIdType));
    std::copy_n(
      lists[process].data(), lists[process].size(), reinterpret_cast<char*>(numbers.data()));
    for (auto number = numbers.begin(); number != numbers.end();)
    {
      const auto end = number + 1 + *number;
      share.Cells.emplace_back(number + 1, end);
      number = end;
    }
    shares.push_back(share);
  }
  return shares;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> joinShares(vtkDataObject* own)
{
  if (auto* data = vtkPolyData::SafeDownCast(own))
  {
    return join(data);
  }
  auto* tree = vtkDataObjectTree::SafeDownCast(own);
  vtkSmartPointer<vtkDataObjectTree> joined;
  joined.TakeReference(tree->NewInstance());
  joined->CopyStructure(tree);
  vtkSmartPointer<vtkDataObjectTreeIterator> leaves;
  leaves.TakeReference(tree->NewTreeIterator());
  for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
  {
    const auto leaf = join(vtkPolyData::SafeDownCast(leaves->GetCurrentDataObject()));
    joined->SetDataSet(leaves, leaf);
  }
  return joined;
}

}
