// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shares.h"

#include "DistributedVersusSerial.h"
#include "FFPointMessage.h"

#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkMultiProcessController.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cstring>
#include <map>

namespace fftest
{
namespace
{

using Key = std::vector<vtkIdType>;
using Message = std::vector<char>;

/// All processes' messages, on process 0.
std::vector<Message> gather(const Message& own)
{
  auto* controller = vtkMultiProcessController::GetGlobalController();
  std::vector<Message> all{ own };
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
    all.emplace_back(static_cast<std::size_t>(size));
    controller->Receive(all.back().data(), size, process, 2);
  }
  return all;
}

/// What names each point: its id, or its position where it has none, as in a power diagram.
std::vector<Key> keysOf(vtkPolyData* data)
{
  vtkDataArray* const ids = data->GetPointData()->GetArray("vtkOriginalPointIds");
  std::vector<Key> keys;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    if (ids)
    {
      keys.push_back({ static_cast<vtkIdType>(ids->GetTuple1(i)) });
      continue;
    }
    double position[3];
    data->GetPoint(i, position);
    std::transform(position, position + 3, position, [](double x) { return x + 0.0; }); // no -0
    keys.emplace_back(3);
    static_assert(sizeof(position) == 3 * sizeof(vtkIdType), "a coordinate is a number of a key");
    std::memcpy(keys.back().data(), position, sizeof(position));
  }
  return keys;
}

/// Whether a tuple of all arrays but the marks is the same, in arrays of the same names and types.
bool isSameTuple(vtkDataSetAttributes* one, vtkIdType i, vtkDataSetAttributes* other, vtkIdType j)
{
  for (int k = 0; k < one->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* const a = one->GetAbstractArray(k);
    vtkAbstractArray* const b =
      a->GetName() ? other->GetAbstractArray(a->GetName()) : other->GetAbstractArray(k);
    if (a->GetName() && !std::strcmp(a->GetName(), vtkDataSetAttributes::GhostArrayName()))
    {
      continue;
    }
    const int size = a->GetNumberOfComponents();
    bool isSame = b && b->GetDataType() == a->GetDataType() && b->GetNumberOfComponents() == size;
    for (int c = 0; isSame && c < size; ++c)
    {
      const vtkVariant x = a->GetVariantValue(i * size + c);
      const vtkVariant y = b->GetVariantValue(j * size + c);
      isSame = x == y || (x.ToString() == "nan" && y.ToString() == "nan");
    }
    if (!isSame)
    {
      return false;
    }
  }
  return true;
}

/// Whether there are the same arrays but marks, as the same attributes.
bool hasSameArrays(vtkDataSetAttributes* one, vtkDataSetAttributes* other)
{
  const auto count = [](vtkDataSetAttributes* data)
  { return data->GetNumberOfArrays() - data->HasArray(vtkDataSetAttributes::GhostArrayName()); };
  bool isSame = count(one) == count(other);
  for (int k = 0; k < vtkDataSetAttributes::NUM_ATTRIBUTES; ++k)
  {
    vtkAbstractArray* const a = one->GetAbstractAttribute(k);
    vtkAbstractArray* const b = other->GetAbstractAttribute(k);
    isSame = isSame && !a == !b &&
      (!a || std::string(a->GetName() ? a->GetName() : "") == (b->GetName() ? b->GetName() : ""));
  }
  return isSame;
}

/// The mark of a point but for that of a duplicate, and whether it has that one.
std::pair<int, bool> markOf(vtkPolyData* data, vtkIdType point)
{
  constexpr int duplicate = vtkDataSetAttributes::DUPLICATEPOINT;
  vtkDataArray* const marks =
    data->GetPointData()->GetArray(vtkDataSetAttributes::GhostArrayName());
  const int mark = marks ? static_cast<int>(marks->GetTuple1(point)) : 0;
  return { mark & ~duplicate, (mark & duplicate) != 0 };
}

/// Of a power diagram's corners, which are named by their positions, the sign of a zero may differ.
bool hasSameBits(vtkPolyData* one, vtkIdType i, vtkPolyData* other, vtkIdType j)
{
  Point a, b;
  one->GetPoint(i, a.data());
  other->GetPoint(j, b.data());
  return one->GetPointData()->HasArray("vtkOriginalPointIds")
    ? std::memcmp(a.data(), b.data(), sizeof(a)) == 0
    : a == b;
}

/// Where each key is.
std::map<Key, vtkIdType> indicesOf(const std::vector<Key>& keys)
{
  std::map<Key, vtkIdType> indices;
  for (const Key& key : keys)
  {
    indices.emplace(key, static_cast<vtkIdType>(indices.size()));
  }
  return indices;
}

/// Whether each point is one of the whole's, with its data, and what is not marked is there once.
bool arePointsOf(const std::vector<Share>& shares, vtkPolyData* whole)
{
  const auto indices = indicesOf(keysOf(whole));
  std::vector<int> owners(indices.size());
  bool good = indices.size() == static_cast<std::size_t>(whole->GetNumberOfPoints());
  for (const Share& share : shares)
  {
    const std::vector<Key> keys = keysOf(share.Points);
    good = good &&
      (keys.empty() ||
        (hasSameArrays(share.Points->GetPointData(), whole->GetPointData()) &&
          share.Points->GetPoints()->GetDataType() == whole->GetPoints()->GetDataType()));
    for (std::size_t i = 0; good && i < keys.size(); ++i)
    {
      const auto own = static_cast<vtkIdType>(i);
      const auto at = indices.find(keys[i]);
      good = at != indices.end() && hasSameBits(share.Points, own, whole, at->second) &&
        markOf(share.Points, own).first == markOf(whole, at->second).first &&
        isSameTuple(share.Points->GetPointData(), own, whole->GetPointData(), at->second);
      if (good && !markOf(share.Points, own).second)
      {
        ++owners[static_cast<std::size_t>(at->second)];
      }
    }
  }
  return good && std::all_of(owners.begin(), owners.end(), [](int count) { return count == 1; });
}

/// Whether the cells are the whole's, each on one process, with its data.
bool areCellsOf(const std::vector<Share>& shares, vtkPolyData* whole)
{
  const auto indices = indicesOf(cellKeysOf(whole));
  std::vector<int> holders(indices.size());
  bool good = indices.size() == static_cast<std::size_t>(whole->GetNumberOfCells());
  for (const Share& share : shares)
  {
    good = good &&
      (share.Cells.empty() || hasSameArrays(share.CellData->GetPointData(), whole->GetCellData()));
    for (std::size_t i = 0; good && i < share.Cells.size(); ++i)
    {
      const auto at = indices.find(share.Cells[i]);
      good = at != indices.end() &&
        isSameTuple(share.CellData->GetPointData(), static_cast<vtkIdType>(i), whole->GetCellData(),
          at->second);
      if (good)
      {
        ++holders[static_cast<std::size_t>(at->second)];
      }
    }
  }
  return good && std::all_of(holders.begin(), holders.end(), [](int count) { return count == 1; });
}

}

//------------------------------------------------------------------------------
std::vector<Key> cellKeysOf(vtkPolyData* data)
{
  const std::vector<Key> points = keysOf(data);
  std::vector<Key> keys;
  for (vtkCellArray* cells : { data->GetVerts(), data->GetLines(), data->GetPolys() })
  {
    for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
    {
      vtkIdType size = 0;
      const vtkIdType* corners = nullptr;
      cells->GetCellAtId(i, size, corners);
      keys.emplace_back();
      for (vtkIdType k = 0; k < size; ++k)
      {
        const Key& corner = points[static_cast<std::size_t>(corners[k])];
        keys.back().insert(keys.back().end(), corner.begin(), corner.end());
      }
    }
  }
  return keys;
}

//------------------------------------------------------------------------------
std::vector<Share> gatherShares(vtkPolyData* own)
{
  std::vector<vtkIdType> flat;
  for (const Key& cell : cellKeysOf(own))
  {
    flat.push_back(static_cast<vtkIdType>(cell.size()));
    flat.insert(flat.end(), cell.begin(), cell.end());
  }
  Message packed(flat.size() * sizeof(vtkIdType));
  std::copy_n(reinterpret_cast<const char*>(flat.data()), packed.size(), packed.data());
  vtkNew<vtkPolyData> cellData;
  cellData->GetPointData()->ShallowCopy(own->GetCellData());
  const auto points = gather(FFPointMessage::Pack(own));
  const auto data = gather(FFPointMessage::Pack(cellData));
  const auto lists = gather(packed);
  std::vector<Share> shares;
  for (std::size_t process = 0; process < points.size(); ++process)
  {
    Share share{ FFPointMessage::Unpack(points[process]), FFPointMessage::Unpack(data[process]),
      {} };
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
bool areSharesOf(vtkPolyData* own, vtkPolyData* whole, const std::string& what)
{
  const std::vector<Share> shares = gatherShares(own);
  if (rank() > 0)
  {
    return true;
  }
  bool good = arePointsOf(shares, whole);
  if (!good)
  {
    std::cerr << what << ": the points are not those of one process\n";
  }
  if (!areCellsOf(shares, whole))
  {
    std::cerr << what << ": the cells are not those of one process\n";
    good = false;
  }
  return good;
}

}
