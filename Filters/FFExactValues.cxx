// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFExactValues.h"

#include "FFFailure.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkAlgorithm.h"
#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkTypeTraits.h"
#include "vtkVariant.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <type_traits>

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
    const auto rounded = static_cast<double>(value);
    return rounded < std::ldexp(1.0, std::numeric_limits<T>::digits) &&
      static_cast<T>(rounded) == value;
  }
  return true;
}

bool isWideInteger(vtkAbstractArray* array)
{
  return array->GetDataTypeSize() == 8 && array->GetDataType() != VTK_DOUBLE;
}

/// Copies an array's values to a plain array of Out. Only arrays of float are copied to floats.
template <int Components, class Out>
struct CopyValues
{
  Out* To;
  const char* Kind;
  vtkIdType Begin; // the point of the first value

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
      this->Put(n++, static_cast<vtk::GetAPIType<ArrayT>>(value));
    }
  }

  void Copy(vtkDataArray* array) const
  {
    if (auto* soaFloats = vtkSOADataArrayTemplate<float>::FastDownCast(array))
    {
      (*this)(soaFloats);
    }
    else if (auto* soaDoubles = vtkSOADataArrayTemplate<double>::FastDownCast(array))
    {
      (*this)(soaDoubles);
    }
    else if (!vtkArrayDispatch::Dispatch::Execute(array, *this))
    {
      isWideInteger(array) ? this->CopyWide(array) : (*this)(array);
    }
  }

  /// Of a class that VTK does not dispatch: its double interface would round.
  void CopyWide(vtkDataArray* array) const
  {
    const int type = array->GetDataType();
    const bool isUnsigned = type == VTK_UNSIGNED_LONG || type == VTK_UNSIGNED_LONG_LONG;
    for (vtkIdType n = 0; n < Components * array->GetNumberOfTuples(); ++n)
    {
      const vtkVariant value = array->GetVariantValue(n);
      isUnsigned ? this->Put(n, value.ToUnsignedLongLong()) : this->Put(n, value.ToLongLong());
    }
  }
};

/// Where the values of an array lie on the CUDA device; null if they are not there, or if this VTK
/// cannot tell.
const void* deviceMemory(vtkDataArray* array)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  if (array->GetMemorySpace() == vtkDataArray::CudaDeviceMemory)
  {
    return array->GetDeviceVoidPointer(0);
  }
#else
  static_cast<void>(array);
#endif
  return nullptr;
}

}

//------------------------------------------------------------------------------
std::string FFInexactValue::Describe(const std::string& where) const
{
  const std::string kind = this->Kind;
  return "A " + kind + " is a 64-bit integer that no double holds: first at " + where +
    // Other disks have other radii, but weights may be shifted.
    (kind == "radius"
        ? ". Round the radii to doubles."
        : ". Subtract an offset from every " + kind + ": the result has the same shape.");
}

//------------------------------------------------------------------------------
void FFCopyTuples(
  vtkAbstractArray* from, vtkIdList* fromIds, vtkAbstractArray* to, vtkIdList* toIds)
{
  if (!isWideInteger(from) || !vtkDataArray::SafeDownCast(from) || from->HasStandardMemoryLayout())
  {
    to->InsertTuples(toIds, fromIds, from);
    return;
  }
  const vtkIdType size = from->GetNumberOfComponents();
  for (vtkIdType i = 0; i < fromIds->GetNumberOfIds(); ++i)
  {
    for (vtkIdType k = 0; k < size; ++k)
    {
      to->SetVariantValue(
        toIds->GetId(i) * size + k, from->GetVariantValue(fromIds->GetId(i) * size + k));
    }
  }
}

//------------------------------------------------------------------------------
template <class View>
void FFValueSource<View>::Read(const std::vector<vtkDataArray*>& arrays, const char* kind)
{
  // Arrays without a value have no say in the type, unless there is nothing else.
  std::vector<vtkDataArray*> parts;
  std::int64_t count = 0;
  for (vtkDataArray* array : arrays)
  {
    const vtkIdType size = array ? array->GetNumberOfTuples() : 0;
    if (array && (parts.empty() || (size > 0 && array->GetDataType() != this->Type)))
    {
      this->Type = parts.empty() ? array->GetDataType() : VTK_DOUBLE;
    }
    if (size > 0)
    {
      parts.push_back(array);
      count += size;
    }
  }
  const auto read = [&](auto& copy)
  {
    using Value = std::decay_t<decltype(*copy.data())>;
    constexpr int components = static_cast<int>(View().stride);
    auto* const plain =
      parts.size() == 1 ? vtkAOSDataArrayTemplate<Value>::FastDownCast(parts[0]) : nullptr;
    if (plain)
    {
      this->Values = View(plain->GetPointer(0), count);
      return;
    }
    copy.allocate(static_cast<std::size_t>(components * count));
    this->Values = View(copy.data(), count);
    vtkIdType begin = 0;
    for (vtkDataArray* part : parts)
    {
      CopyValues<components, Value>{ copy.data() + components * begin, kind, begin }.Copy(part);
      begin += part->GetNumberOfTuples();
    }
    // After the copy to the host, which waits for whatever still writes to the device.
    if (parts.size() == 1 && this->Type == vtkTypeTraits<Value>::VTK_TYPE_ID)
    {
      this->Values.deviceData = deviceMemory(parts[0]);
    }
  };
  this->Type == VTK_FLOAT ? read(this->Floats) : read(this->Doubles);
}

//------------------------------------------------------------------------------
FFPointSource::FFPointSource(vtkDataArray* array)
{
  this->Read({ array }, "coordinate");
}

//------------------------------------------------------------------------------
FFPointSource::FFPointSource(const std::vector<vtkPointSet*>& pieces)
{
  std::vector<vtkDataArray*> arrays;
  for (vtkPointSet* piece : pieces)
  {
    arrays.push_back(piece->GetPoints() ? piece->GetPoints()->GetData() : nullptr);
  }
  this->Read(arrays, "coordinate");
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPoints> FFPointSource::Gather(const std::int64_t* ids, vtkIdType count) const
{
  vtkSmartPointer<vtkPoints> points;
  points.TakeReference(vtkPoints::New(this->Type));
  points->SetNumberOfPoints(count);
  const auto gather = [&](auto* to)
  {
    const auto* const from = static_cast<decltype(to)>(const_cast<void*>(this->Values.data));
    vtkSMPTools::For(0, count, 1 << 14,
      [=](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          std::copy_n(from + 3 * ids[i], 3, to + 3 * i);
        }
      });
  };
  if (this->Type == VTK_FLOAT)
  {
    gather(static_cast<float*>(points->GetVoidPointer(0)));
  }
  else if (this->Type == VTK_DOUBLE)
  {
    gather(static_cast<double*>(points->GetVoidPointer(0)));
  }
  else // exact both ways: it was converted to double
  {
    for (vtkIdType i = 0; i < count; ++i)
    {
      points->SetPoint(i, static_cast<const double*>(this->Values.data) + 3 * ids[i]);
    }
  }
  return points;
}

//------------------------------------------------------------------------------
FFWeightSource::FFWeightSource(
  vtkDataArray* array, const flipflop::WeightRule& rule, const char* noun)
{
  if (!array)
  {
    return;
  }
  if (!std::isfinite(rule.factor))
  {
    std::ostringstream message;
    message << "Weight Factor is " << rule.factor << "; it must be finite.";
    throw FFBadSetting(message.str());
  }
  this->Read({ array }, rule.areRadii ? "radius" : noun);
  if (!rule.isIdentity())
  {
    this->Doubles = flipflop::computeWeights(this->Values, rule);
    this->Values = flipflop::WeightView(this->Doubles.data(), this->Values.count);
  }
}

//------------------------------------------------------------------------------
vtkDataArray* FFWeightSource::FindArray(vtkAlgorithm* filter, vtkDataSet* points,
  const std::string& ofWhat, const std::string& owner, const std::string& noun)
{
  vtkInformationVector* const chosen =
    filter->GetInformation()->Get(vtkAlgorithm::INPUT_ARRAYS_TO_PROCESS());
  vtkInformation* const choice = chosen ? chosen->GetInformationObject(0) : nullptr;
  if (!choice || points->GetNumberOfPoints() == 0)
  {
    return nullptr;
  }
  vtkPointData* const data = points->GetPointData();
  const char* const name = choice->Get(vtkDataObject::FIELD_NAME());
  const bool byName = name && *name;
  if (byName ? !std::strcmp(name, "None") && !data->HasArray(name)
             : !choice->Has(vtkDataObject::FIELD_ATTRIBUTE_TYPE()))
  {
    return nullptr;
  }
  vtkAbstractArray* array = nullptr;
  std::ostringstream wrong;
  wrong << "The " << noun << "s' array";
  if (byName)
  {
    array = data->GetAbstractArray(name);
    wrong << " \"" << name << "\"" << ofWhat << " ";
  }
  else
  {
    const int attribute = choice->Get(vtkDataObject::FIELD_ATTRIBUTE_TYPE());
    const char* const label = vtkDataSetAttributes::GetAttributeTypeAsString(attribute);
    array = label ? data->GetAbstractAttribute(attribute) : nullptr;
    wrong << ofWhat << ", the point data's active " << (label ? label : "array")
          << (array && array->GetName() ? std::string(" \"") + array->GetName() + "\", " : ", ");
  }

  auto* const numbers = vtkDataArray::SafeDownCast(array);
  const int association = choice->Get(vtkDataObject::FIELD_ASSOCIATION());
  if (association != vtkDataObject::FIELD_ASSOCIATION_POINTS &&
    association != vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS)
  {
    wrong << "was asked for as data that does not belong to the points; " << noun
          << "s must be point data";
  }
  else if (!array)
  {
    wrong << "is missing from " << (ofWhat.empty() ? "the " + owner + "'s" : "its")
          << " point data";
  }
  else if (!numbers)
  {
    wrong << "is a " << array->GetClassName() << ", which does not hold numbers";
  }
  else if (numbers->GetNumberOfComponents() != 1)
  {
    wrong << "has " << numbers->GetNumberOfComponents() << " components; a " << noun << " has 1";
  }
  else if (numbers->GetNumberOfTuples() != points->GetNumberOfPoints())
  {
    wrong << "has " << numbers->GetNumberOfTuples() << " value(s) for "
          << points->GetNumberOfPoints() << " point(s)";
  }
  else
  {
    return numbers;
  }
  throw std::runtime_error(wrong.str() + ".");
}
VTK_ABI_NAMESPACE_END
