// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFRegularTriangulationFilter.h"

#include "vtkFFConstraints.h"
#include "vtkFFFailure.h"
#include "vtkFFRegularTriangulationInternals.h"

#include <flipflop/Error.h>

#include "vtkAbstractTransform.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkFFRegularTriangulationFilter);

namespace
{

/// The field data of an output, or of each of its blocks, on another one of the same structure.
void passFieldData(vtkDataObject* from, vtkDataObject* to)
{
  to->GetFieldData()->PassData(from->GetFieldData());
  auto* source = vtkDataObjectTree::SafeDownCast(from);
  if (!source)
  {
    return;
  }
  vtkSmartPointer<vtkDataObjectTreeIterator> leaves;
  leaves.TakeReference(source->NewTreeIterator());
  for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
  {
    vtkDataObject* target = vtkDataObjectTree::SafeDownCast(to)->GetDataSet(leaves);
    if (target)
    {
      target->GetFieldData()->PassData(leaves->GetCurrentDataObject()->GetFieldData());
    }
  }
}

}

//------------------------------------------------------------------------------
vtkFFRegularTriangulationFilter::vtkFFRegularTriangulationFilter()
  : ProjectionPlaneMode(XY_PLANE)
  , Transform(nullptr)
  , WeightMode(WEIGHTS)
  , WeightFactor(1.0)
  , Alpha(0.0)
  , AlphaLines(false)
  , AlphaVerts(false)
  , GenerateAlphas(false)
  , GenerateBoundary(false)
  , MaximumEdgeLength(0.0)
  , SplitCrossingConstraints(false)
  , PolygonRule(EVEN_ODD)
  , GeneratePowerDiagram(false)
  , GenerateCellMeasures(false)
  , PowerDiagramBoxMode(BOX_OF_POINTS)
  , PowerDiagramBounds{ 0.0, 1.0, 0.0, 1.0 }
  , PowerDiagramLengths{ 1.0, 1.0 }
  , NumberOfHiddenPoints(0)
  , NumberOfDroppedCells(0)
  , NumberOfSplitPoints(0)
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(4);
  this->SetInternals(std::make_unique<vtkInternals>(this));
}

//------------------------------------------------------------------------------
vtkFFRegularTriangulationFilter::~vtkFFRegularTriangulationFilter()
{
  this->StoreTransform(nullptr);
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::SetTransform(vtkAbstractTransform* transform)
{
  this->StoreTransform(transform);
  if (transform)
  {
    this->SetProjectionPlaneMode(TRANSFORM_PLANE);
  }
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::StoreTransform(vtkAbstractTransform* transform)
{
  vtkSetObjectBodyMacro(Transform, vtkAbstractTransform, transform);
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::SetSourceData(vtkDataObject* source)
{
  this->SetInputData(1, source);
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::SetSourceConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkFFRegularTriangulationFilter::GetSource()
{
  return this->GetNumberOfInputConnections(1) > 0
    ? vtkPolyData::SafeDownCast(this->GetExecutive()->GetInputData(1, 0))
    : nullptr;
}

//------------------------------------------------------------------------------
int vtkFFRegularTriangulationFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 0)
  {
    return this->Superclass::FillInputPortInformation(port, info);
  }
  // Any type will do, and we say ourselves what is wrong with it.
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::SetPowerDiagramBounds(
  double xmin, double xmax, double ymin, double ymax)
{
  this->StorePowerDiagramBounds(xmin, xmax, ymin, ymax);
  this->SetPowerDiagramBoxMode(BOX_OF_BOUNDS);
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::SetPowerDiagramBounds(const double bounds[4])
{
  this->SetPowerDiagramBounds(bounds[0], bounds[1], bounds[2], bounds[3]);
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::StorePowerDiagramBounds(
  double xmin, double xmax, double ymin, double ymax)
{
  const double bounds[4] = { xmin, xmax, ymin, ymax };
  if (!std::equal(bounds, bounds + 4, this->PowerDiagramBounds))
  {
    std::copy(bounds, bounds + 4, this->PowerDiagramBounds);
    this->PowerDiagramLengths[0] = xmax - xmin;
    this->PowerDiagramLengths[1] = ymax - ymin;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::StorePowerDiagramCorner(double x, double y, double)
{
  const double lengths[2] = { this->PowerDiagramLengths[0], this->PowerDiagramLengths[1] };
  this->StorePowerDiagramBounds(x, x + lengths[0], y, y + lengths[1]);
  // What was rounded on the way does not stay.
  std::copy(lengths, lengths + 2, this->PowerDiagramLengths);
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::StorePowerDiagramLengths(double x, double y, double)
{
  const double* from = this->PowerDiagramBounds;
  this->StorePowerDiagramBounds(from[0], from[0] + x, from[2], from[2] + y);
  this->PowerDiagramLengths[0] = x;
  this->PowerDiagramLengths[1] = y;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkFFRegularTriangulationFilter::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Transform ? std::max(own, this->Transform->GetMTime()) : own;
}

//------------------------------------------------------------------------------
vtkPolyData* vtkFFRegularTriangulationFilter::GetHiddenPointsOutput()
{
  return this->GetNumberOfOutputPorts() < 4
    ? nullptr
    : vtkPolyData::SafeDownCast(this->GetOutputDataObject(1));
}

//------------------------------------------------------------------------------
vtkPolyData* vtkFFRegularTriangulationFilter::GetPowerDiagramOutput()
{
  return this->GetNumberOfOutputPorts() < 4
    ? nullptr
    : vtkPolyData::SafeDownCast(this->GetOutputDataObject(2));
}

//------------------------------------------------------------------------------
vtkPolyData* vtkFFRegularTriangulationFilter::GetBoundaryOutput()
{
  return this->GetNumberOfOutputPorts() < 4
    ? nullptr
    : vtkPolyData::SafeDownCast(this->GetOutputDataObject(3));
}

//------------------------------------------------------------------------------
int vtkFFRegularTriangulationFilter::RequestDataOfOneOutput(int index, vtkInformation* request,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // The others are made as always, and nobody sees them.
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  vtkNew<vtkInformationVector> all;
  for (int port = 0; port < 4; ++port)
  {
    vtkSmartPointer<vtkDataObject> data = output;
    if (port != index)
    {
      data.TakeReference(output->NewInstance());
    }
    vtkNew<vtkInformation> info;
    info->Set(vtkDataObject::DATA_OBJECT(), data);
    all->Append(info);
  }
  const int done = this->vtkFFAlgorithm::RequestData(request, inputVector, all);
  if (!done)
  {
    vtkFFGuard::ForgetExtents(outputVector);
  }
  else if (index != 0)
  {
    passFieldData(vtkDataObject::GetData(all, 0), output);
  }
  return done;
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::vtkInternals::ResetReport()
{
  auto* filter = this->GetTriangulationFilter();
  this->vtkFFAlgorithm::vtkInternals::ResetReport();
  filter->NumberOfHiddenPoints = 0;
  filter->NumberOfDroppedCells = 0;
  filter->NumberOfSplitPoints = 0;
  this->HasWarnedOfVerticalPlane = false;
  this->Constraints = nullptr;
}

//------------------------------------------------------------------------------
const char* vtkFFRegularTriangulationFilter::vtkInternals::GetProgressTitle()
{
  return "Regular triangulation";
}

//------------------------------------------------------------------------------
vtkFFRegularTriangulationFilter*
vtkFFRegularTriangulationFilter::vtkInternals::GetTriangulationFilter()
{
  return static_cast<vtkFFRegularTriangulationFilter*>(this->GetFilter());
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::vtkInternals::CheckSettings(vtkFFFailure& failure)
{
  auto* filter = this->GetTriangulationFilter();
  if (filter->ProjectionPlaneMode == TRANSFORM_PLANE && !filter->Transform)
  {
    failure.Say("Projection Plane Mode is Transform, and no Transform is set. Set one, or take "
                "another mode.");
    return;
  }
  if (!(filter->MaximumEdgeLength >= 0.0)) // NaN, too
  {
    std::ostringstream message;
    message << "Maximum Edge Length is " << filter->MaximumEdgeLength
            << "; it must be a length, or 0 for edges of any length.";
    failure.Say(message.str());
    return;
  }
  if (!(filter->Alpha >= 0.0))
  {
    std::ostringstream message;
    message << "Alpha is " << filter->Alpha
            << "; it must be a length, or 0 for the whole triangulation.";
    failure.Say(message.str());
    return;
  }
  const double* box = filter->PowerDiagramBounds;
  const bool isBox = std::all_of(box, box + 4, [](double x) { return std::isfinite(x); }) &&
    box[0] < box[1] && box[2] < box[3];
  if (filter->GeneratePowerDiagram && filter->PowerDiagramBoxMode == BOX_OF_BOUNDS && !isBox)
  {
    std::ostringstream message;
    message << "The power diagram's box has no inside or is not finite: it is (xmin, xmax, ymin, "
               "ymax) = ("
            << box[0] << ", " << box[1] << ", " << box[2] << ", " << box[3] << ").";
    failure.Say(message.str());
    return;
  }
  this->CheckSource(failure);
}

//------------------------------------------------------------------------------
bool vtkFFRegularTriangulationFilter::vtkInternals::HasSource()
{
  return this->GetFilter()->GetNumberOfInputConnections(1) > 0;
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::vtkInternals::CheckSource(vtkFFFailure& failure)
{
  auto* filter = this->GetTriangulationFilter();
  if (!this->HasSource())
  {
    return;
  }
  vtkDataObject* source = filter->GetExecutive()->GetInputData(1, 0);
  if (source && !filter->GetSource())
  {
    failure.Say(std::string("The source is a ") + source->GetClassName() +
      ". It must be a vtkPolyData, whose lines and polygons are constraints.");
  }
  else if (filter->GeneratePowerDiagram)
  {
    failure.Say("A power diagram has no constraints. Turn off Generate Power Diagram, or take the "
                "source away.");
  }
  else if (filter->Engine == ENGINE_CUDA)
  {
    failure.Say("The CUDA engine was asked for, but constraints are the CPU's. Set Engine to "
                "Automatic or CPU.");
  }
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::vtkInternals::SelectBlocks(
  std::vector<Block>& blocks, vtkFFFailure& failure)
{
  this->CheckParts(
    std::count_if(blocks.begin(), blocks.end(), [](const Block& block) { return block.HasData(); }),
    failure);
  this->vtkFFAlgorithm::vtkInternals::SelectBlocks(blocks, failure);
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::vtkInternals::CheckParts(
  vtkIdType count, vtkFFFailure& failure)
{
  if (count > 1 && failure.Kind == vtkFFFailure::None && this->HasSource())
  {
    failure.Say("The source has ids of one data set's points, and the input has " +
      std::to_string(count) + " parts. Take one, merge them, or take the source away.");
  }
}

//------------------------------------------------------------------------------
std::string vtkFFRegularTriangulationFilter::vtkInternals::DescribeError(
  const flipflop::Error& error)
{
  auto* filter = this->GetTriangulationFilter();
  if (error.code() == flipflop::ErrorCode::NonFinite)
  {
    const std::string projected =
      filter->ProjectionPlaneMode == XY_PLANE ? "" : " (as given, or projected)";
    return this->DescribeNonFinite("A coordinate" + projected + " or a weight", error) +
      " Remove them, or set Non Finite Points to Ignore.";
  }
  // The engine was given no ids but those of points.
  if (error.code() == flipflop::ErrorCode::ConstraintPoint && this->Constraints)
  {
    return "Point " + std::to_string(this->GetPlaceOfPoint(static_cast<vtkIdType>(error.count()))) +
      " of " + this->Constraints->DescribeCell(error.index()) +
      " is left out: it has a coordinate that is NaN or infinite.";
  }
  if (error.code() == flipflop::ErrorCode::ConstraintsCross && this->Constraints)
  {
    return "An edge of " + this->Constraints->DescribeCell(error.index()) + " crosses one of " +
      this->Constraints->DescribeCell(error.count()) +
      ", and there is no point where they do. Add one to the input and to both, or turn on Split "
      "Crossing Constraints.";
  }
  if (error.code() == flipflop::ErrorCode::PolygonsDisagree && this->Constraints)
  {
    const std::string wrong = this->Constraints->DescribeCell(error.index());
    const std::string right = this->Constraints->DescribeCell(error.count());
    const std::string rule = "The polygons disagree about what is inside: what is on the left of a "
                             "side is inside, and holes run clockwise. ";
    return wrong == right ? rule + "The sides of " + wrong +
        " disagree with each other, as where a polygon crosses itself. Set Polygon Rule to "
        "Even-Odd."
                          : rule + "Reverse " + wrong + ", which disagrees with " + right +
        ", or set Polygon Rule to Even-Odd.";
  }
  return this->vtkFFAlgorithm::vtkInternals::DescribeError(error);
}

//------------------------------------------------------------------------------
const char* vtkFFRegularTriangulationFilter::GetProjectionPlaneModeAsString()
{
  return this->ProjectionPlaneMode == BEST_FITTING_PLANE ? "BestFittingPlane"
    : this->ProjectionPlaneMode == TRANSFORM_PLANE       ? "Transform"
                                                         : "XYPlane";
}

//------------------------------------------------------------------------------
const char* vtkFFRegularTriangulationFilter::GetWeightModeAsString()
{
  return this->WeightMode == RADII ? "Radii" : "Weights";
}

//------------------------------------------------------------------------------
const char* vtkFFRegularTriangulationFilter::GetPolygonRuleAsString()
{
  return this->PolygonRule == DIRECTION ? "Direction" : "EvenOdd";
}

//------------------------------------------------------------------------------
const char* vtkFFRegularTriangulationFilter::GetPowerDiagramBoxModeAsString()
{
  return this->PowerDiagramBoxMode == BOX_OF_BOUNDS ? "Bounds" : "Points";
}

//------------------------------------------------------------------------------
void vtkFFRegularTriangulationFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ProjectionPlaneMode: " << this->GetProjectionPlaneModeAsString() << "\n";
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
  os << indent << "WeightMode: " << this->GetWeightModeAsString() << "\n";
  os << indent << "WeightFactor: " << this->WeightFactor << "\n";
  os << indent << "Alpha: " << this->Alpha << "\n";
  os << indent << "AlphaLines: " << (this->AlphaLines ? "On" : "Off") << "\n";
  os << indent << "AlphaVerts: " << (this->AlphaVerts ? "On" : "Off") << "\n";
  os << indent << "GenerateAlphas: " << (this->GenerateAlphas ? "On" : "Off") << "\n";
  os << indent << "GenerateBoundary: " << (this->GenerateBoundary ? "On" : "Off") << "\n";
  os << indent << "MaximumEdgeLength: " << this->MaximumEdgeLength << "\n";
  os << indent << "SplitCrossingConstraints: " << (this->SplitCrossingConstraints ? "On" : "Off")
     << "\n";
  os << indent << "PolygonRule: " << this->GetPolygonRuleAsString() << "\n";
  os << indent << "GeneratePowerDiagram: " << (this->GeneratePowerDiagram ? "On" : "Off") << "\n";
  os << indent << "GenerateCellMeasures: " << (this->GenerateCellMeasures ? "On" : "Off") << "\n";
  os << indent << "PowerDiagramBoxMode: " << this->GetPowerDiagramBoxModeAsString() << "\n";
  const double* box = this->PowerDiagramBounds;
  os << indent << "PowerDiagramBounds: (" << box[0] << ", " << box[1] << ", " << box[2] << ", "
     << box[3] << ")\n";
  os << indent << "NumberOfHiddenPoints: " << this->NumberOfHiddenPoints << "\n";
  os << indent << "NumberOfDroppedCells: " << this->NumberOfDroppedCells << "\n";
  os << indent << "NumberOfSplitPoints: " << this->NumberOfSplitPoints << "\n";
}
VTK_ABI_NAMESPACE_END
