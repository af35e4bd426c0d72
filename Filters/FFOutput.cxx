// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFOutput.h"

#include "FFExactValues.h"

#include <flipflop/CellComplex.h>

#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <deque>
#include <numeric>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

using Sources = std::vector<FFOutput::Source>;

/// Hands the buffer's memory to a VTK array of equally wide values; copies to narrower ones.
template <class ArrayT>
vtkSmartPointer<ArrayT> adopt(flipflop::Buffer<std::int64_t>& buffer)
{
  using Value = typename ArrayT::ValueType;
  auto array = vtkSmartPointer<ArrayT>::New();
  const auto size = static_cast<vtkIdType>(buffer.size());
  if (size == 0)
  {
    return array;
  }
  if constexpr (sizeof(Value) == sizeof(std::int64_t))
  {
    array->SetArray(
      reinterpret_cast<Value*>(buffer.release()), size, 0, ArrayT::VTK_DATA_ARRAY_ALIGNED_FREE);
  }
  else
  {
    array->SetNumberOfValues(size);
    std::transform(buffer.begin(), buffer.end(), array->GetPointer(0),
      [](std::int64_t value) { return static_cast<Value>(value); });
  }
  return array;
}

/// A new array like this one: type, components, names, keys; room for count tuples.
vtkSmartPointer<vtkAbstractArray> makeLike(vtkAbstractArray* array, vtkIdType count)
{
  // Of the same class, unless its layout is not the plain one: others can be read-only.
  vtkSmartPointer<vtkAbstractArray> like;
  like.TakeReference(array->HasStandardMemoryLayout()
      ? array->NewInstance()
      : vtkAbstractArray::CreateArray(array->GetDataType()));
  if (!like)
  {
    return like;
  }
  like->SetName(array->GetName());
  like->SetNumberOfComponents(array->GetNumberOfComponents());
  like->CopyComponentNames(array);
  if (array->HasInformation())
  {
    like->CopyInformation(array->GetInformation());
  }
  if (auto* const to = vtkDataArray::SafeDownCast(like))
  {
    to->SetLookupTable(vtkDataArray::SafeDownCast(array)->GetLookupTable());
  }
  like->SetNumberOfTuples(count);
  return like;
}

/// The points of one source among the output's: which they are there, and which here.
struct Share
{
  vtkPointData* Data;
  vtkIdType NumberOfPoints; // of the source
  vtkNew<vtkIdList> From;
  vtkNew<vtkIdList> To;
};

/// The shares of all sources that have a point.
std::deque<Share> sharesOf(const Sources& sources, vtkIdTypeArray* ids)
{
  // Ascending ids: each source's are a range.
  std::deque<Share> shares;
  const vtkIdType* const first = ids->GetPointer(0);
  const vtkIdType* begin = first;
  vtkIdType sourceBegin = 0;
  for (const FFOutput::Source& source : sources)
  {
    if (source.NumberOfPoints == 0)
    {
      continue;
    }
    const vtkIdType* const end = std::lower_bound(
      begin, first + ids->GetNumberOfValues(), sourceBegin + source.NumberOfPoints);
    Share& share = shares.emplace_back();
    share.Data = source.Data;
    share.NumberOfPoints = source.NumberOfPoints;
    share.From->SetNumberOfIds(end - begin);
    share.To->SetNumberOfIds(end - begin);
    std::transform(
      begin, end, share.From->GetPointer(0), [=](vtkIdType id) { return id - sourceBegin; });
    vtkIdType* const to = share.To->GetPointer(0);
    std::iota(to, to + (end - begin), static_cast<vtkIdType>(begin - first));
    begin = end;
    sourceBegin += source.NumberOfPoints;
  }
  return shares;
}

/// PassPointData() with all attributes.
void copyPointData(const Sources& sources, vtkIdTypeArray* ids, vtkDataSetAttributes* output)
{
  if (std::all_of(sources.begin(), sources.end(),
        [](const FFOutput::Source& source) { return source.Data->GetNumberOfArrays() == 0; }))
  {
    return;
  }
  const std::deque<Share> shares = sharesOf(sources, ids);
  vtkPointData* const leader = shares.empty() ? nullptr : shares[0].Data;
  for (int i = 0; leader && i < leader->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* const array = leader->GetAbstractArray(i);
    const auto partOf = [&](const Share& share)
    {
      return &share == &shares[0] ? array
        : array->GetName()        ? share.Data->GetAbstractArray(array->GetName())
                                  : nullptr;
    };
    const bool areAll = std::all_of(shares.begin(), shares.end(),
      [&](const Share& share)
      {
        vtkAbstractArray* const part = partOf(share);
        return part && part->GetDataType() == array->GetDataType() &&
          part->GetNumberOfComponents() == array->GetNumberOfComponents() &&
          part->GetNumberOfTuples() >= share.NumberOfPoints;
      });
    const auto copy = areAll ? makeLike(array, ids->GetNumberOfValues()) : nullptr;
    if (!copy)
    {
      continue;
    }
    for (const Share& share : shares)
    {
      FFCopyTuples(partOf(share), share.From, copy, share.To);
    }
    const int index = output->AddArray(copy);
    for (int attribute = 0; attribute < vtkDataSetAttributes::NUM_ATTRIBUTES; ++attribute)
    {
      if (leader->GetAbstractAttribute(attribute) == array)
      {
        output->SetActiveAttribute(index, attribute);
      }
    }
  }
}

/// The values of an array for these points.
void copyValues(
  vtkAbstractArray* from, vtkPointSet* piece, vtkIdTypeArray* which, vtkAbstractArray* to)
{
  for (const Share& share : sharesOf(FFOutput::DataOf({ piece }), which))
  {
    FFCopyTuples(from, share.From, to, share.To);
  }
}

/// These points, in the piece's own type.
vtkSmartPointer<vtkPoints> selectPoints(vtkPointSet* piece, vtkIdTypeArray* which)
{
  vtkDataArray* const positions = piece->GetPoints()->GetData();
  const auto selected = makeLike(positions, which->GetNumberOfValues());
  copyValues(positions, piece, which, selected);
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(vtkDataArray::SafeDownCast(selected));
  return points;
}

/// Values of a new array for these points of a source, by its array of the same name. Without one
/// of as many components: NaN, or 0 and an empty string of types that have none.
void fillFrom(vtkPointSet* source, vtkIdTypeArray* which, vtkAbstractArray* array)
{
  array->SetNumberOfTuples(which->GetNumberOfValues());
  vtkAbstractArray* const same =
    array->GetName() ? source->GetPointData()->GetAbstractArray(array->GetName()) : nullptr;
  auto* const numbers = vtkDataArray::SafeDownCast(array);
  auto* const others = vtkDataArray::SafeDownCast(same);
  const bool fits = same && same->GetNumberOfComponents() == array->GetNumberOfComponents();
  if (fits && same->GetDataType() == array->GetDataType())
  {
    copyValues(same, source, which, array);
  }
  else if (fits && numbers && others)
  {
    for (vtkIdType k = 0; k < which->GetNumberOfValues(); ++k)
    {
      numbers->SetTuple(k, others->GetTuple(which->GetValue(k)));
    }
  }
  else if (numbers)
  {
    const int type = array->GetDataType();
    numbers->Fill(type == VTK_FLOAT || type == VTK_DOUBLE ? vtkMath::Nan() : 0.0);
  }
}

}

//------------------------------------------------------------------------------
Sources FFOutput::DataOf(const std::vector<vtkPointSet*>& pieces)
{
  Sources data;
  for (vtkPointSet* piece : pieces)
  {
    data.push_back({ piece->GetPointData(), piece->GetNumberOfPoints() });
  }
  return data;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkIdTypeArray> FFOutput::Adopt(flipflop::CellComplex& cells,
  const FFPointSource& points, const std::vector<Source>& data, vtkPolyData* output)
{
  output->SetPoints(
    points.Gather(cells.pointIds.data(), static_cast<vtkIdType>(cells.pointIds.size())));
  AdoptCells(cells, output);
  const auto ids = AdoptIds(cells.pointIds);
  PassPointData(data, ids, output->GetPointData());
  AddIds(ids, output->GetPointData());
  return ids;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkIdTypeArray> FFOutput::AdoptIds(flipflop::Buffer<std::int64_t>& ids)
{
  return adopt<vtkIdTypeArray>(ids);
}

//------------------------------------------------------------------------------
void FFOutput::AddIds(vtkIdTypeArray* ids, vtkDataSetAttributes* output)
{
  ids->SetName("vtkOriginalPointIds");
  output->AddArray(ids);
}

//------------------------------------------------------------------------------
void FFOutput::Renumber(
  vtkDataSetAttributes* output, const std::function<vtkIdType(vtkIdType)>& idOf)
{
  auto* ids = vtkIdTypeArray::SafeDownCast(output->GetAbstractArray("vtkOriginalPointIds"));
  const vtkIdType count = ids ? ids->GetNumberOfValues() : 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    ids->SetValue(i, idOf(ids->GetValue(i)));
  }
}

//------------------------------------------------------------------------------
void FFOutput::ShowIds(vtkDataSetAttributes* output)
{
  if (vtkDataArray* ids = output->GetArray("vtkOriginalPointIds"))
  {
    vtkNew<vtkIdTypeArray> copy; // shares the memory
    copy->ShallowCopy(ids);
    copy->SetName("OriginalPointIds");
    output->AddArray(copy);
  }
}

//------------------------------------------------------------------------------
void FFOutput::AdoptCells(flipflop::CellComplex& complex, vtkPolyData* output)
{
  if (complex.cellCount() == 0)
  {
    return;
  }
  vtkNew<vtkCellArray> cells;
  const auto cellSize = static_cast<vtkIdType>(complex.cellSize);
  const auto connectivity = adopt<vtkTypeInt64Array>(complex.connectivity);
  if (cellSize > 0)
  {
    cells->SetData(cellSize, connectivity);
  }
  else
  {
    const auto offsets = adopt<vtkTypeInt64Array>(complex.offsets);
    cells->SetData(offsets.Get(), connectivity.Get());
  }
  complex.dimension == 0     ? output->SetVerts(cells)
    : complex.dimension == 1 ? output->SetLines(cells)
                             : output->SetPolys(cells);
}

//------------------------------------------------------------------------------
void FFOutput::CopyCells(vtkCellArray* cells, flipflop::CellComplex& complex)
{
  const auto count = static_cast<std::size_t>(cells->GetNumberOfCells());
  complex.connectivity.allocate(static_cast<std::size_t>(cells->GetNumberOfConnectivityIds()));
  complex.offsets.allocate(count + 1);
  vtkNew<vtkIdList> corners; // of our own: other threads may read the same cells
  std::int64_t end = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    cells->GetCellAtId(static_cast<vtkIdType>(i), corners);
    const vtkIdType size = corners->GetNumberOfIds();
    complex.offsets[i] = end;
    std::copy_n(corners->GetPointer(0), size, complex.connectivity.data() + end);
    end += size;
  }
  complex.offsets[count] = end;
}

//------------------------------------------------------------------------------
void FFOutput::FanPolygons(vtkPolyData* output)
{
  vtkCellArray* const polygons = output->GetPolys();
  if (polygons->GetNumberOfCells() == 0 || polygons->IsHomogeneous() == 3)
  {
    return;
  }
  flipflop::CellComplex complex;
  complex.dimension = 2;
  CopyCells(polygons, complex);
  flipflop::fanPolygons(complex);
  AdoptCells(complex, output);
}

//------------------------------------------------------------------------------
void FFOutput::PassPointData(
  const Sources& sources, vtkIdTypeArray* ids, vtkDataSetAttributes* output)
{
  copyPointData(sources, ids, output);
  for (const int attribute :
    { vtkDataSetAttributes::NORMALS, vtkDataSetAttributes::TANGENTS, vtkDataSetAttributes::EDGEFLAG,
      vtkDataSetAttributes::RATIONALWEIGHTS, vtkDataSetAttributes::HIGHERORDERDEGREES })
  {
    output->SetActiveAttribute(-1, attribute);
  }
  auto* const marks = vtkCellData::SafeDownCast(output)
    ? vtkUnsignedCharArray::SafeDownCast(
        output->GetAbstractArray(vtkDataSetAttributes::GhostArrayName()))
    : nullptr;
  for (vtkIdType i = 0; marks && i < marks->GetNumberOfValues(); ++i)
  {
    const int mark = marks->GetValue(i);
    const int duplicate =
      mark & vtkDataSetAttributes::DUPLICATEPOINT ? vtkDataSetAttributes::DUPLICATECELL : 0;
    const int hidden =
      mark & vtkDataSetAttributes::HIDDENPOINT ? vtkDataSetAttributes::HIDDENCELL : 0;
    marks->SetValue(i, static_cast<unsigned char>(duplicate | hidden));
  }
}

//------------------------------------------------------------------------------
void FFOutput::PassFieldData(vtkDataObject* input, vtkDataObject* output)
{
  if (vtkFieldData* const data = input->GetFieldData())
  {
    output->GetFieldData()->PassData(data);
  }
}

//------------------------------------------------------------------------------
void FFOutput::RemoveReport(vtkFieldData* data)
{
  for (int i = data ? data->GetNumberOfArrays() - 1 : -1; i >= 0; --i)
  {
    const char* name = data->GetArrayName(i);
    if (name && std::strncmp(name, "FlipFlop", 8) == 0)
    {
      data->RemoveArray(i);
    }
  }
}

//------------------------------------------------------------------------------
void FFOutput::AddValue(vtkFieldData* output, const char* name, const vtkVariant& value)
{
  const int type = static_cast<int>(value.GetType());
  const bool isLong = type == VTK_LONG || type == VTK_LONG_LONG;
  vtkSmartPointer<vtkAbstractArray> array;
  array.TakeReference(vtkAbstractArray::CreateArray(isLong ? VTK_ID_TYPE : type));
  array->SetName(name);
  array->InsertVariantValue(0, value);
  output->AddArray(array);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPointSet> FFOutput::Append(
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
  const Sources data = DataOf(pieces);
  const vtkIdType count = std::accumulate(data.begin(), data.end(), -leftOut,
    [](vtkIdType sum, const Source& source) { return sum + source.NumberOfPoints; });
  flipflop::Buffer<std::int64_t> all(static_cast<std::size_t>(count));
  std::iota(all.begin(), all.end(), static_cast<std::int64_t>(leftOut));
  auto whole = vtkSmartPointer<vtkPolyData>::New();
  whole->SetPoints(FFPointSource(pieces).Gather(all.data(), count));
  copyPointData(data, AdoptIds(all), whole->GetPointData());
  return whole;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPointSet> FFOutput::Select(vtkPointSet* piece, vtkIdTypeArray* which)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(selectPoints(piece, which));
  copyPointData(DataOf({ piece }), which, result->GetPointData());
  return result;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> FFOutput::SelectLike(
  vtkPointSet* followed, vtkPolyData* source, const flipflop::Buffer<std::int64_t>& which)
{
  flipflop::Buffer<std::int64_t> copy(which.size());
  std::copy(which.begin(), which.end(), copy.begin());
  const auto ids = AdoptIds(copy);
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(selectPoints(source, ids));
  vtkPointData* const data = result->GetPointData();
  data->InterpolateAllocate(followed->GetPointData(), ids->GetNumberOfValues());
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    fillFrom(source, ids, data->GetAbstractArray(i));
  }
  return result;
}
VTK_ABI_NAMESPACE_END
