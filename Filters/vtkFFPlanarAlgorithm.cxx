// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFPlanarAlgorithm.h"

#include "vtkAbstractTransform.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
vtkFFPlanarAlgorithm::~vtkFFPlanarAlgorithm()
{
  this->StoreTransform(nullptr);
}

//------------------------------------------------------------------------------
void vtkFFPlanarAlgorithm::SetTransform(vtkAbstractTransform* transform)
{
  this->StoreTransform(transform);
  if (transform)
  {
    this->SetProjectionPlaneMode(TRANSFORM_PLANE);
  }
}

//------------------------------------------------------------------------------
void vtkFFPlanarAlgorithm::StoreTransform(vtkAbstractTransform* transform)
{
  vtkSetObjectBodyMacro(Transform, vtkAbstractTransform, transform);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkFFPlanarAlgorithm::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Transform ? std::max(own, this->Transform->GetMTime()) : own;
}

//------------------------------------------------------------------------------
void vtkFFPlanarAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ProjectionPlaneMode: " << this->ProjectionPlaneMode << "\n";
  os << indent << "Transform: ";
  if (this->Transform)
  {
    os << "\n";
    this->Transform->PrintSelf(os, indent.GetNextIndent());
  }
  else
  {
    os << "(none)\n";
  }
  os << indent << "WeightMode: " << this->WeightMode << "\n";
  os << indent << "WeightFactor: " << this->WeightFactor << "\n";
  os << indent << "GenerateCellMeasures: " << (this->GenerateCellMeasures ? "On" : "Off") << "\n";
}
VTK_ABI_NAMESPACE_END
