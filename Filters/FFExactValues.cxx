// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFExactValues.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkVariant.h"
#include "vtkVersionMacros.h"

#include <limits>
#include <type_traits>

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
#define VTK_FF_HAS_DEVICE_ARRAYS 1
#else
#define VTK_FF_HAS_DEVICE_ARRAYS 0
#endif

VTK_ABI_NAMESPACE_BEGIN
namespace
{

/// Whether a double holds the value. Only integers of more than 53 bits can fail.
template <class T>
bool isExact(T value)
{
  if constexpr (std::is_integral<T>::value &&
    std::numeric_limits<T>::digits > std::numeric_limits<double>::digits)
  {
    // 2^digits is where the cast back would leave T; no such value equals it.
    const double rounded = static_cast<double>(value);
    constexpr double limit =
      2.0 * static_cast<double>(T{ 1 } << (std::numeric_limits<T>::digits - 1));
    return rounded < limit && static_cast<T>(rounded) == value;
  }
  else
  {
    static_cast<void>(value);
    return true;
  }
}

bool isWideInteger(vtkAbstractArray* array)
{
  return array->GetDataTypeSize() == 8 && array->GetDataType() != VTK_DOUBLE;
}

/// Copies an array's values to a plain array of Out.
template <int Components, class Out>
struct CopyValues
{
  Out* To;
  const char* Kind;
  vtkIdType Begin;

  template <class T>
  void Put(vtkIdType n, T value) const
  {
    if (!isExact(value))
    {
      throw FFInexactValue(this->Kind, this->Begin + n / Components);
    }
    this->To[n] = static_cast<Out>(value);
  }

  template <class ArrayT>
  void operator()(ArrayT* array) const
  {
    // Whole tuples: an array may hold some values of another.
    const vtkIdType end = Components * array->GetNumberOfTuples();
    vtkIdType n = 0;
    for (const auto value : vtk::DataArrayValueRange<Components>(array, 0, end))
    {
      using Value = vtk::GetAPIType<ArrayT>;
      const Value v = value;
      this->Put(n, v);
      ++n;
    }
  }

  /// Of a class that VTK does not dispatch: its double interface would round 64-bit integers.
  void CopyAnyLayout(vtkDataArray* array) const
  {
    const int type = array->GetDataType();
    if (!isWideInteger(array))
    {
      (*this)(array);
      return;
    }
    const bool isUnsigned = type == VTK_UNSIGNED_LONG || type == VTK_UNSIGNED_LONG_LONG;
    for (vtkIdType n = 0; n < Components * array->GetNumberOfTuples(); ++n)
    {
      const vtkVariant value = array->GetVariantValue(n);
      if (isUnsigned)
      {
        this->Put(n, value.ToUnsignedLongLong());
      }
      else
      {
        this->Put(n, value.ToLongLong());
      }
    }
  }
};

}

//------------------------------------------------------------------------------
template <class T>
const T* FFExactValues::Memory(vtkDataArray* array)
{
  auto* plain = vtkAOSDataArrayTemplate<T>::FastDownCast(array);
  return plain ? plain->GetPointer(0) : nullptr;
}

template const float* FFExactValues::Memory<float>(vtkDataArray*);
template const double* FFExactValues::Memory<double>(vtkDataArray*);

//------------------------------------------------------------------------------
const void* FFExactValues::DeviceMemory(vtkDataArray* array)
{
#if VTK_FF_HAS_DEVICE_ARRAYS
  if (array->GetMemorySpace() == vtkDataArray::CudaDeviceMemory)
  {
    return array->GetDeviceVoidPointer(0);
  }
#else
  static_cast<void>(array);
#endif
  return nullptr;
}

//------------------------------------------------------------------------------
bool FFExactValues::AreRoundedByCopies(vtkAbstractArray* array)
{
  return isWideInteger(array) && vtkDataArray::SafeDownCast(array) &&
    !array->HasStandardMemoryLayout();
}

//------------------------------------------------------------------------------
template <int Components, class Out>
void FFExactValues::Copy(vtkDataArray* array, const char* kind, vtkIdType begin, Out* to)
{
  const CopyValues<Components, Out> worker{ to, kind, begin };
  if (auto* soaFloats = vtkSOADataArrayTemplate<float>::FastDownCast(array))
  {
    worker(soaFloats);
  }
  else if (auto* soaDoubles = vtkSOADataArrayTemplate<double>::FastDownCast(array))
  {
    worker(soaDoubles);
  }
  else if (!vtkArrayDispatch::Dispatch::Execute(array, worker))
  {
    worker.CopyAnyLayout(array);
  }
}

template void FFExactValues::Copy<3>(vtkDataArray*, const char*, vtkIdType, float*);
template void FFExactValues::Copy<3>(vtkDataArray*, const char*, vtkIdType, double*);
template void FFExactValues::Copy<1>(vtkDataArray*, const char*, vtkIdType, float*);
template void FFExactValues::Copy<1>(vtkDataArray*, const char*, vtkIdType, double*);
VTK_ABI_NAMESPACE_END
