// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFOutput.h"

#include "FFExactValues.h"
#include "FFPointSource.h"

#include <flipflop/CellComplex.h>

#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>
#include <numeric>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

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

/// An array of one value.
template <class ArrayT, class T>
void addValue(vtkFieldData* output, const char* name, T value)
{
  vtkNew<ArrayT> array;
  array->SetName(name);
  array->InsertNextValue(value);
  output->AddArray(array);
}

/// A new array like this one: type, components, names, keys; room for count tuples.
vtkSmartPointer<vtkAbstractArray> makeLike(vtkAbstractArray* array, vtkIdType count)
{
  // Of the same class, unless its layout is not the plain one: others can be read-only.
  vtkSmartPointer<vtkAbstractArray> like;
  like.TakeReference(array->HasStandardMemoryLayout()
      ? array->NewInstance()
      : vtkAbstractArray::CreateArray(array->GetDataType()));
  if (like)
  {
    like->SetName(array->GetName());
    like->SetNumberOfComponents(array->GetNumberOfComponents());
    like->CopyComponentNames(array);
    if (array->HasInformation())
    {
      like->CopyInformation(array->GetInformation());
    }
    auto* from = vtkDataArray::SafeDownCast(array);
    auto* to = vtkDataArray::SafeDownCast(like);
    if (from && to)
    {
      to->SetLookupTable(from->GetLookupTable());
    }
    like->SetNumberOfTuples(count);
  }
  return like;
}

/// The array of a further source that continues this one, null when there is none.
vtkAbstractArray* findLike(const FFOutput::Source& source, vtkAbstractArray* array)
{
  vtkAbstractArray* other =
    array->GetName() ? source.Data->GetAbstractArray(array->GetName()) : nullptr;
  const bool alike = other && other->GetDataType() == array->GetDataType() &&
    other->GetNumberOfComponents() == array->GetNumberOfComponents();
  return alike ? other : nullptr;
}

/// Points can go without the surface that these attributes tell of.
void retireSurfaceAttributes(vtkDataSetAttributes* data)
{
  for (const int attribute :
    { vtkDataSetAttributes::NORMALS, vtkDataSetAttributes::TANGENTS, vtkDataSetAttributes::EDGEFLAG,
      vtkDataSetAttributes::RATIONALWEIGHTS, vtkDataSetAttributes::HIGHERORDERDEGREES })
  {
    data->SetActiveAttribute(-1, attribute);
  }
}

/// The points of one source among the output's: which they are there, and which here.
struct Share
{
  FFOutput::Source Source;
  vtkNew<vtkIdList> From;
  vtkNew<vtkIdList> To;

  Share(const FFOutput::Source& source, vtkIdType sourceBegin, const vtkIdType* ids,
    vtkIdType begin, vtkIdType end)
    : Source(source)
  {
    this->From->SetNumberOfIds(end - begin);
    this->To->SetNumberOfIds(end - begin);
    std::transform(ids + begin, ids + end, this->From->GetPointer(0),
      [=](vtkIdType id) { return id - sourceBegin; });
    std::iota(this->To->GetPointer(0), this->To->GetPointer(0) + (end - begin), begin);
  }

  /// Their tuples of one array into another of the same type.
  void CopyTuples(vtkAbstractArray* from, vtkAbstractArray* to) const
  {
    if (!FFExactValues::AreRoundedByCopies(from))
    {
      to->InsertTuples(this->To, this->From, from);
      return;
    }
    const vtkIdType size = from->GetNumberOfComponents();
    for (vtkIdType i = 0; i < this->From->GetNumberOfIds(); ++i)
    {
      for (vtkIdType k = 0; k < size; ++k)
      {
        to->SetVariantValue(
          this->To->GetId(i) * size + k, from->GetVariantValue(this->From->GetId(i) * size + k));
      }
    }
  }
};

/// Values of a new array for these points of a source, by its array of the same name. Without one
/// of as many components: NaN, or 0 and an empty string of types that have none.
void fillFrom(vtkDataSetAttributes* source, const flipflop::Buffer<std::int64_t>& points,
  vtkAbstractArray* array)
{
  const auto count = static_cast<vtkIdType>(points.size());
  array->SetNumberOfTuples(count);
  vtkAbstractArray* const same =
    array->GetName() ? source->GetAbstractArray(array->GetName()) : nullptr;
  auto* const numbers = vtkDataArray::SafeDownCast(array);
  const bool isThere = same && same->GetNumberOfComponents() == array->GetNumberOfComponents() &&
    (numbers ? vtkDataArray::SafeDownCast(same) != nullptr
             : same->GetDataType() == array->GetDataType());
  if (!isThere)
  {
    const int type = array->GetDataType();
    if (numbers)
    {
      numbers->Fill(type == VTK_FLOAT || type == VTK_DOUBLE ? vtkMath::Nan() : 0.0);
    }
    return;
  }
  auto* const other = vtkDataArray::SafeDownCast(same);
  for (vtkIdType k = 0; k < count; ++k)
  {
    const auto from = static_cast<vtkIdType>(points[static_cast<std::size_t>(k)]);
    if (same->GetDataType() == array->GetDataType())
    {
      array->SetTuple(k, from, same);
    }
    else // both are of numbers
    {
      numbers->SetTuple(k, other->GetTuple(from));
    }
  }
}

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
  switch (complex.dimension)
  {
    case 0:
      output->SetVerts(cells);
      break;
    case 1:
      output->SetLines(cells);
      break;
    default:
      output->SetPolys(cells);
      break;
  }
}

//------------------------------------------------------------------------------
void FFOutput::CopyCells(vtkCellArray* cells, flipflop::CellComplex& complex)
{
  const auto count = static_cast<std::size_t>(cells->GetNumberOfCells());
  complex.connectivity.allocate(static_cast<std::size_t>(cells->GetNumberOfConnectivityIds()));
  complex.offsets.allocate(count + 1);
  std::int64_t end = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    vtkIdType size;
    const vtkIdType* corners;
    cells->GetCellAtId(static_cast<vtkIdType>(i), size, corners);
    complex.offsets[i] = end;
    std::copy_n(corners, size, complex.connectivity.data() + end);
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
void FFOutput::CopyPointData(
  const std::vector<Source>& sources, vtkIdTypeArray* ids, vtkDataSetAttributes* output)
{
  // Ascending ids: each source's are a range.
  const vtkIdType count = ids->GetNumberOfValues();
  const vtkIdType* first = ids->GetPointer(0);
  std::vector<std::unique_ptr<Share>> shares;
  vtkIdType sourceBegin = 0;
  vtkIdType begin = 0;
  for (const Source& source : sources)
  {
    const vtkIdType sourceEnd = sourceBegin + source.NumberOfPoints;
    if (source.NumberOfPoints > 0)
    {
      const vtkIdType end = std::lower_bound(first + begin, first + count, sourceEnd) - first;
      shares.push_back(std::make_unique<Share>(source, sourceBegin, first, begin, end));
      begin = end;
    }
    sourceBegin = sourceEnd;
  }
  if (shares.empty())
  {
    return;
  }

  vtkPointData* leader = shares.front()->Source.Data;
  for (int i = 0; i < leader->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = leader->GetAbstractArray(i);
    std::vector<vtkAbstractArray*> parts;
    for (const auto& share : shares)
    {
      vtkAbstractArray* part = share == shares.front() ? array : findLike(share->Source, array);
      if (!part || part->GetNumberOfTuples() < share->Source.NumberOfPoints)
      {
        break;
      }
      parts.push_back(part);
    }
    const auto copy = parts.size() == shares.size() ? makeLike(array, count) : nullptr;
    if (!copy)
    {
      continue;
    }
    for (std::size_t k = 0; k < parts.size(); ++k)
    {
      shares[k]->CopyTuples(parts[k], copy);
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
  for (int i = data->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    const char* name = data->GetArrayName(i);
    if (name && std::strncmp(name, "FlipFlop", 8) == 0)
    {
      data->RemoveArray(i);
    }
  }
}

//------------------------------------------------------------------------------
void FFOutput::PassPointData(
  const std::vector<Source>& sources, vtkIdTypeArray* ids, vtkPointData* output)
{
  CopyPointData(sources, ids, output);
  retireSurfaceAttributes(output);
}

//------------------------------------------------------------------------------
void FFOutput::PassPointData(
  const std::vector<Source>& sources, vtkIdTypeArray* ids, vtkCellData* output)
{
  CopyPointData(sources, ids, output);
  retireSurfaceAttributes(output);

  auto* marks = vtkUnsignedCharArray::SafeDownCast(
    output->GetAbstractArray(vtkDataSetAttributes::GhostArrayName()));
  const vtkIdType count = marks ? marks->GetNumberOfValues() : 0;
  for (vtkIdType i = 0; i < count; ++i)
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
void FFOutput::AddValue(vtkFieldData* output, const char* name, int value)
{
  addValue<vtkIntArray>(output, name, value);
}

//------------------------------------------------------------------------------
void FFOutput::AddValue(vtkFieldData* output, const char* name, std::int64_t value)
{
  addValue<vtkIdTypeArray>(output, name, static_cast<vtkIdType>(value));
}

//------------------------------------------------------------------------------
void FFOutput::AddValue(vtkFieldData* output, const char* name, double value)
{
  addValue<vtkDoubleArray>(output, name, value);
}

//------------------------------------------------------------------------------
void FFOutput::AddValue(vtkFieldData* output, const char* name, const char* value)
{
  addValue<vtkStringArray>(output, name, value);
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
  std::vector<vtkDataArray*> arrays;
  std::vector<Source> data;
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
  whole->SetPoints(FFPointSource(arrays).Gather(all.data(), count));
  CopyPointData(data, AdoptIds(all), whole->GetPointData());
  return whole;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPointSet> FFOutput::Select(vtkPointSet* piece, vtkIdTypeArray* which)
{
  const vtkIdType count = piece->GetNumberOfPoints();
  vtkNew<vtkPointData> from;
  vtkNew<vtkPointData> to;
  from->AddArray(piece->GetPoints()->GetData());
  CopyPointData({ { from, count } }, which, to);
  vtkNew<vtkPoints> positions;
  positions->SetData(to->GetArray(0));
  auto points = vtkSmartPointer<vtkPolyData>::New();
  points->SetPoints(positions);
  CopyPointData({ { piece->GetPointData(), count } }, which, points->GetPointData());
  return points;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> FFOutput::SelectLike(
  vtkPointSet* followed, vtkPolyData* source, const flipflop::Buffer<std::int64_t>& which)
{
  const auto count = static_cast<vtkIdType>(which.size());
  vtkNew<vtkPoints> points;
  points->SetDataType(source->GetPoints()->GetDataType());
  points->SetNumberOfPoints(count);
  for (vtkIdType k = 0; k < count; ++k)
  {
    double x[3];
    source->GetPoint(static_cast<vtkIdType>(which[static_cast<std::size_t>(k)]), x);
    points->SetPoint(k, x);
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  vtkPointData* const data = result->GetPointData();
  data->InterpolateAllocate(followed->GetPointData(), count);
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    fillFrom(source->GetPointData(), which, data->GetAbstractArray(i));
  }
  return result;
}
VTK_ABI_NAMESPACE_END
