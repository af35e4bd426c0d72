// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FilterArrays.h"

#include "vtkDataArray.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkStringArray.h"
#include "vtkVariant.h"
#include "vtkVariantArray.h"

#include <algorithm>
#include <cmath>

namespace flipflop
{
namespace fuzz
{

namespace
{

constexpr int Types[] = { VTK_DOUBLE, VTK_FLOAT, VTK_DOUBLE, VTK_FLOAT, VTK_INT, VTK_UNSIGNED_INT,
  VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_LONG,
  VTK_UNSIGNED_LONG, VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE, VTK_BIT };

template <class T>
vtkSmartPointer<vtkDataArray> makeSoa()
{
  return vtkSmartPointer<vtkSOADataArrayTemplate<T>>::New();
}

}

vtkSmartPointer<vtkDataArray> drawDataArray(Bytes& bytes, int components, vtkIdType tuples)
{
  vtkSmartPointer<vtkDataArray> array;
  const int kind = bytes.below(24);
  if (kind < 17)
  {
    array.TakeReference(vtkDataArray::CreateDataArray(Types[kind]));
  }
  else
  {
    array = kind == 17 ? makeSoa<float>()
      : kind == 18     ? makeSoa<int>()
      : kind == 19     ? makeSoa<long long>()
      : kind == 20     ? makeSoa<unsigned char>()
                       : makeSoa<double>();
  }
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  for (int k = 0; k < components; ++k)
  {
    array->FillComponent(k, 0);
  }
  return array;
}

void setComponent(vtkDataArray* array, vtkIdType tuple, int component, double value)
{
  const int type = array->GetDataType();
  if (type == VTK_BIT)
  {
    value = value > 0 ? 1 : 0;
  }
  else if (type == VTK_FLOAT)
  {
    value = std::isfinite(value) ? std::max(-3e38, std::min(value, 3e38)) : value;
  }
  else if (type != VTK_DOUBLE)
  {
    // Out of the type's range a conversion would be undefined.
    const double least = std::max(array->GetDataTypeMin(), -9e18);
    const double most = std::min(array->GetDataTypeMax(), 9e18);
    value = std::isfinite(value) ? std::max(least, std::min(value, most)) : 0;
  }
  array->SetComponent(tuple, component, value);
}

vtkSmartPointer<vtkAbstractArray> drawAnyArray(Bytes& bytes, vtkIdType tuples)
{
  const int kind = bytes.below(8);
  if (kind == 6)
  {
    auto strings = vtkSmartPointer<vtkStringArray>::New();
    for (vtkIdType i = 0; i < tuples; ++i)
    {
      strings->InsertNextValue(i % 3 ? "1" : "");
    }
    return strings;
  }
  if (kind == 7)
  {
    auto variants = vtkSmartPointer<vtkVariantArray>::New();
    for (vtkIdType i = 0; i < tuples; ++i)
    {
      variants->InsertNextValue(vtkVariant(static_cast<int>(i)));
    }
    return variants;
  }
  const int components = bytes.oneOf(4) ? bytes.below(4) + 1 : 1;
  auto numbers = drawDataArray(bytes, components, tuples);
  const bool each = bytes.flag();
  for (vtkIdType i = 0; i < tuples; ++i)
  {
    const double value = each ? bytes.number() : static_cast<double>(i % 5);
    setComponent(numbers, i, 0, value);
  }
  if (bytes.oneOf(8) && tuples > 0 && numbers->GetDataTypeSize() == 8 &&
    numbers->GetDataType() != VTK_DOUBLE)
  {
    // No double holds it.
    numbers->SetVariantValue(0, vtkVariant((1LL << 53) + 1));
  }
  return numbers;
}

}
}
