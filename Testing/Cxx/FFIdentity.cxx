// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether two data objects are the same, bit for bit.
#include "FFTest.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkVariant.h"

#include <algorithm>
#include <cstring>

namespace fftest
{
namespace
{

/// Prints what differs; false.
bool differs(const std::string& where, const std::string& how)
{
  std::cerr << where << ": " << how << "\n";
  return false;
}

std::string text(const char* name)
{
  return name ? name : "(none)";
}

bool sameValues(vtkAbstractArray* a, vtkAbstractArray* b)
{
  if (a == b)
  {
    return true;
  }
  if (a->GetNumberOfTuples() != b->GetNumberOfTuples())
  {
    return false;
  }
  const vtkIdType count = a->GetNumberOfValues();
  if (!a->HasStandardMemoryLayout() || a->GetDataType() == VTK_BIT || !a->IsNumeric())
  {
    vtkIdType i = 0;
    while (i < count && a->GetVariantValue(i) == b->GetVariantValue(i))
    {
      ++i;
    }
    return i == count;
  }
  const auto bytes = static_cast<std::size_t>(count * a->GetDataTypeSize());
  return bytes == 0 || std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0), bytes) == 0;
}

bool sameArray(vtkAbstractArray* a, vtkAbstractArray* b, const std::string& where)
{
  if (text(a->GetName()) != text(b->GetName()))
  {
    return differs(where, "named " + text(a->GetName()) + ", not " + text(b->GetName()));
  }
  const std::string array = where + ", array " + text(a->GetName());
  if (a->GetDataType() != b->GetDataType())
  {
    return differs(array, std::string("a ") + a->GetClassName() + ", not a " + b->GetClassName());
  }
  if (a->GetNumberOfComponents() != b->GetNumberOfComponents())
  {
    return differs(array, "another number of components");
  }
  for (int k = 0; k < a->GetNumberOfComponents(); ++k)
  {
    if (text(a->GetComponentName(k)) != text(b->GetComponentName(k)))
    {
      return differs(array, "another component name");
    }
  }
  return sameValues(a, b) || differs(array, "other values");
}

/// What a run took depends on who ran.
bool isMeasured(vtkAbstractArray* array)
{
  const std::string name = text(array->GetName());
  return name.find("FlipFlopSeconds") == 0 || name == "FlipFlopThreads";
}

bool sameArrays(vtkFieldData* a, vtkFieldData* b, const std::string& where)
{
  if (a->GetNumberOfArrays() != b->GetNumberOfArrays())
  {
    return differs(where,
      std::to_string(a->GetNumberOfArrays()) + " arrays, not " +
        std::to_string(b->GetNumberOfArrays()));
  }
  for (int i = 0; i < a->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* one = a->GetAbstractArray(i);
    if (!isMeasured(one) && !sameArray(one, b->GetAbstractArray(i), where))
    {
      return false;
    }
  }
  return true;
}

bool sameAttributes(vtkDataSetAttributes* a, vtkDataSetAttributes* b, const std::string& where)
{
  for (int k = 0; k < vtkDataSetAttributes::NUM_ATTRIBUTES; ++k)
  {
    vtkAbstractArray* one = a->GetAbstractAttribute(k);
    vtkAbstractArray* other = b->GetAbstractAttribute(k);
    if (!one != !other || (one && text(one->GetName()) != text(other->GetName())))
    {
      return differs(
        where, std::string("other active ") + vtkDataSetAttributes::GetAttributeTypeAsString(k));
    }
  }
  return sameArrays(a, b, where);
}

bool sameCells(vtkCellArray* a, vtkCellArray* b)
{
  bool same = a->GetNumberOfCells() == b->GetNumberOfCells();
  for (vtkIdType i = 0; same && i < a->GetNumberOfCells(); ++i)
  {
    vtkIdType sizes[2] = { 0, 0 };
    const vtkIdType* corners[2] = { nullptr, nullptr };
    a->GetCellAtId(i, sizes[0], corners[0]);
    b->GetCellAtId(i, sizes[1], corners[1]);
    same = sizes[0] == sizes[1] && std::equal(corners[0], corners[0] + sizes[0], corners[1]);
  }
  return same;
}

bool samePoints(vtkPointSet* a, vtkPointSet* b, const std::string& where)
{
  if (!a->GetPoints() != !b->GetPoints())
  {
    return differs(where, a->GetPoints() ? "has points" : "has no points");
  }
  return !a->GetPoints() ||
    sameArray(a->GetPoints()->GetData(), b->GetPoints()->GetData(), where + ", points");
}

/// NaNs, as a damaged input passes on, included.
bool sameGrid(vtkImageData* a, vtkImageData* b)
{
  const auto isSame = [](const double* one, const double* other, std::size_t count)
  { return std::memcmp(one, other, count * sizeof(double)) == 0; };
  return std::equal(a->GetExtent(), a->GetExtent() + 6, b->GetExtent()) &&
    isSame(a->GetOrigin(), b->GetOrigin(), 3) && isSame(a->GetSpacing(), b->GetSpacing(), 3) &&
    isSame(a->GetDirectionMatrix()->GetData(), b->GetDirectionMatrix()->GetData(), 9);
}

/// Of the cells, those of poly data are compared, of others their number.
bool sameDataSet(vtkDataSet* a, vtkDataSet* b, const std::string& where)
{
  auto* points = vtkPointSet::SafeDownCast(a);
  if (points && !samePoints(points, vtkPointSet::SafeDownCast(b), where))
  {
    return false;
  }
  auto* image = vtkImageData::SafeDownCast(a);
  if (image && !sameGrid(image, vtkImageData::SafeDownCast(b)))
  {
    return differs(where, "another extent, origin, spacing or direction");
  }
  auto* one = vtkPolyData::SafeDownCast(a);
  auto* other = vtkPolyData::SafeDownCast(b);
  if (a->GetNumberOfPoints() != b->GetNumberOfPoints() ||
    a->GetNumberOfCells() != b->GetNumberOfCells() ||
    (one &&
      (!sameCells(one->GetVerts(), other->GetVerts()) ||
        !sameCells(one->GetLines(), other->GetLines()) ||
        !sameCells(one->GetPolys(), other->GetPolys()) ||
        !sameCells(one->GetStrips(), other->GetStrips()))))
  {
    return differs(where, "other points or cells");
  }
  return sameAttributes(a->GetPointData(), b->GetPointData(), where + ", point data") &&
    sameAttributes(a->GetCellData(), b->GetCellData(), where + ", cell data") &&
    sameArrays(a->GetFieldData(), b->GetFieldData(), where + ", field data");
}

}

//------------------------------------------------------------------------------
bool isSame(vtkPolyData* a, vtkPolyData* b)
{
  return samePoints(a, b, "same") && originalIds(a) == originalIds(b) &&
    sameCells(a->GetVerts(), b->GetVerts()) && sameCells(a->GetLines(), b->GetLines()) &&
    sameCells(a->GetPolys(), b->GetPolys());
}

//------------------------------------------------------------------------------
bool isIdentical(vtkDataObject* found, vtkDataObject* expected, const std::string& what)
{
  if (!found || !expected)
  {
    return (!found && !expected) || differs(what, found ? "is there" : "is not there");
  }
  if (strcmp(found->GetClassName(), expected->GetClassName()) != 0)
  {
    return differs(what, std::string("a ") + found->GetClassName());
  }
  if (auto* data = vtkDataSet::SafeDownCast(found))
  {
    return sameDataSet(data, vtkDataSet::SafeDownCast(expected), what);
  }

  vtkSmartPointer<vtkCompositeDataIterator> iterators[2];
  vtkDataObject* composites[2] = { found, expected };
  for (int k = 0; k < 2; ++k)
  {
    iterators[k].TakeReference(vtkCompositeDataSet::SafeDownCast(composites[k])->NewIterator());
    iterators[k]->SkipEmptyNodesOff();
    iterators[k]->InitTraversal();
  }
  for (; !iterators[0]->IsDoneWithTraversal(); iterators[0]->GoToNextItem())
  {
    const unsigned int flatIndex = iterators[0]->GetCurrentFlatIndex();
    if (iterators[1]->IsDoneWithTraversal() || iterators[1]->GetCurrentFlatIndex() != flatIndex)
    {
      return differs(what, "another structure");
    }
    if (!isIdentical(iterators[0]->GetCurrentDataObject(), iterators[1]->GetCurrentDataObject(),
          what + ", block " + std::to_string(flatIndex)))
    {
      return false;
    }
    iterators[1]->GoToNextItem();
  }
  return iterators[1]->IsDoneWithTraversal() || differs(what, "another structure");
}

}
