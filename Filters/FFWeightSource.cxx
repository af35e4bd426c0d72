// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFWeightSource.h"

#include "FFExactValues.h"
#include "FFRun.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"

#include <cmath>
#include <cstddef>
#include <cstring>
#include <sstream>
#include <stdexcept>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
FFWeightSource::FFWeightSource(
  vtkDataArray* array, const flipflop::WeightRule& rule, const char* noun)
{
  if (!std::isfinite(rule.factor))
  {
    std::ostringstream message;
    message << "Weight Factor is " << rule.factor << "; it must be finite.";
    throw FFBadSetting(message.str());
  }
  if (!array)
  {
    return;
  }
  const vtkIdType count = array->GetNumberOfTuples();
  const char* const kind = rule.areRadii ? "radius" : noun;
  if (const float* floats = FFExactValues::Memory<float>(array))
  {
    this->View = flipflop::WeightView(floats, count);
  }
  else if (const double* doubles = FFExactValues::Memory<double>(array))
  {
    this->View = flipflop::WeightView(doubles, count);
  }
  else if (array->GetDataType() == VTK_FLOAT)
  {
    this->Convert(array, kind, this->Floats);
  }
  else
  {
    this->Convert(array, kind, this->Doubles);
  }
  if (!rule.isIdentity())
  {
    this->Doubles = flipflop::computeWeights(this->View, rule);
    this->View = flipflop::WeightView(this->Doubles.data(), count);
  }
}

//------------------------------------------------------------------------------
template <class T>
void FFWeightSource::Convert(vtkDataArray* array, const char* kind, flipflop::Buffer<T>& copy)
{
  copy.allocate(static_cast<std::size_t>(array->GetNumberOfTuples()));
  FFExactValues::Copy<1>(array, kind, 0, copy.data());
  this->View = flipflop::WeightView(copy.data(), array->GetNumberOfTuples());
  // After the copy to the host, which waits for whatever still writes to the device.
  if (array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE)
  {
    this->View.deviceData = FFExactValues::DeviceMemory(array);
  }
}

//------------------------------------------------------------------------------
vtkDataArray* FFWeightSource::FindArray(vtkAlgorithm* filter, vtkDataSet* points,
  const std::string& ofWhat, const std::string& owner, const std::string& noun)
{
  vtkInformationVector* chosen =
    filter->GetInformation()->Get(vtkAlgorithm::INPUT_ARRAYS_TO_PROCESS());
  vtkInformation* choice = chosen ? chosen->GetInformationObject(0) : nullptr;
  if (!choice || points->GetNumberOfPoints() == 0)
  {
    return nullptr;
  }
  const char* name = choice->Get(vtkDataObject::FIELD_NAME());
  if (name && !std::strcmp(name, "None") && !points->GetPointData()->HasArray(name))
  {
    return nullptr;
  }
  const bool byName = name && *name;
  if (!byName && !choice->Has(vtkDataObject::FIELD_ATTRIBUTE_TYPE()))
  {
    return nullptr;
  }
  std::string what;
  vtkAbstractArray* array = nullptr;
  if (byName)
  {
    what = "The " + noun + "s' array \"" + name + "\"" + ofWhat + " ";
    array = points->GetPointData()->GetAbstractArray(name);
  }
  else
  {
    const int attribute = choice->Get(vtkDataObject::FIELD_ATTRIBUTE_TYPE());
    const char* label = vtkDataSetAttributes::GetAttributeTypeAsString(attribute);
    array = label ? points->GetPointData()->GetAbstractAttribute(attribute) : nullptr;
    what = "The " + noun + "s' array" + ofWhat + ", the point data's active " +
      (label ? label : "array") +
      (array && array->GetName() ? std::string(" \"") + array->GetName() + "\", " : ", ");
  }

  const int association = choice->Get(vtkDataObject::FIELD_ASSOCIATION());
  std::ostringstream wrong;
  if (association != vtkDataObject::FIELD_ASSOCIATION_POINTS &&
    association != vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS)
  {
    wrong << "was asked for as data that does not belong to the points; " << noun
          << "s must be point data";
  }
  else if (!array)
  {
    wrong << "is missing from the " << owner << "'s point data";
  }
  else if (!vtkDataArray::SafeDownCast(array))
  {
    wrong << "is a " << array->GetClassName() << ", which does not hold numbers";
  }
  else if (array->GetNumberOfComponents() != 1)
  {
    wrong << "has " << array->GetNumberOfComponents() << " components; a " << noun << " has 1";
  }
  else if (array->GetNumberOfTuples() != points->GetNumberOfPoints())
  {
    wrong << "has " << array->GetNumberOfTuples() << " value(s) for " << points->GetNumberOfPoints()
          << " point(s)";
  }
  if (!wrong.str().empty())
  {
    throw std::runtime_error(what + wrong.str() + ".");
  }
  return vtkDataArray::SafeDownCast(array);
}

VTK_ABI_NAMESPACE_END
