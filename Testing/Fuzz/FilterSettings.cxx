// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FilterSettings.h"
#include "FilterInputs.h"

#include "vtkCellArray.h"
#include "vtkDataObject.h"
#include "vtkFFConstrainedDelaunayFilter.h"
#include "vtkFFConvexifyFilter.h"
#include "vtkFFHullFilter.h"
#include "vtkFFPointInterpolator2D.h"
#include "vtkFFPowerDiagramFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkFFSelectEnclosedPoints.h"
#include "vtkGeneralTransform.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkThinPlateSplineTransform.h"
#include "vtkTransform.h"

#include <sstream>

namespace flipflop
{
namespace fuzz
{

namespace
{

/// Any number for a setting of a few values.
int drawChoice(Bytes& bytes)
{
  const int choice = bytes.below(8);
  return choice == 7 ? static_cast<int>(bytes.integer()) : choice % 3;
}

int drawThreads(Bytes& bytes)
{
  constexpr int threads[] = { 1, 2, 3, 0, -1, 64, 1000, 1000000, VTK_INT_MAX };
  return threads[bytes.below(9)];
}

vtkSmartPointer<vtkAbstractTransform> drawTransform(Bytes& bytes)
{
  const int kind = bytes.below(6);
  if (kind == 0)
  {
    return nullptr;
  }
  auto linear = vtkSmartPointer<vtkTransform>::New();
  if (kind == 1) // any matrix, without an inverse too
  {
    vtkNew<vtkMatrix4x4> matrix;
    for (int n = bytes.below(6); n > 0; --n)
    {
      const int at = bytes.below(16);
      matrix->SetElement(at / 4, at % 4, bytes.number());
    }
    linear->SetMatrix(matrix);
    return linear;
  }
  linear->RotateX(15.0 * bytes.below(24));
  linear->Scale(bytes.raw<std::int8_t>() / 4.0, 1, 1);
  linear->Translate(bytes.number(), 0, 0);
  if (kind == 2) // not linear
  {
    auto spline = vtkSmartPointer<vtkThinPlateSplineTransform>::New();
    vtkNew<vtkPoints> from;
    vtkNew<vtkPoints> to;
    for (int i = 0; i < 4; ++i)
    {
      from->InsertNextPoint(i & 1, i >> 1, i == 3);
      to->InsertNextPoint(i & 1, i >> 1, bytes.raw<std::int8_t>());
    }
    spline->SetSourceLandmarks(from);
    spline->SetTargetLandmarks(to);
    spline->SetBasisToR();
    return spline;
  }
  if (kind == 3)
  {
    auto general = vtkSmartPointer<vtkGeneralTransform>::New();
    general->Concatenate(linear);
    general->Inverse();
    return general;
  }
  return linear;
}

void drawCommon(Bytes& bytes, vtkFFAlgorithm* filter)
{
  switch (bytes.below(12))
  {
    case 1:
      filter->SetEngine(drawChoice(bytes));
      break;
    case 2:
      filter->SetCUDAThreshold(static_cast<vtkIdType>(bytes.integer()));
      break;
    case 3:
      filter->SetNumberOfThreads(drawThreads(bytes));
      break;
    case 4:
      filter->SetFacetMode(drawChoice(bytes));
      break;
    case 5:
      filter->SetNonFinitePoints(drawChoice(bytes));
      break;
    case 6:
      filter->SetPassPointData(bytes.flag());
      break;
    case 7:
      filter->SetVisiblePointIds(bytes.flag());
      break;
    case 8:
      filter->SetReportAsFieldData(bytes.flag());
      break;
    case 9:
      filter->SetVBiased(bytes.flag());
      break;
    case 10:
      filter->SetSkipGhostPoints(bytes.flag());
      break;
    case 11:
    {
      std::ostringstream text;
      filter->Print(text);
      break;
    }
    default:
      filter->Modified();
      break;
  }
}

void drawOwn(Bytes& bytes, vtkFFConvexifyFilter* filter)
{
  if (bytes.flag())
  {
    const double x = bytes.number();
    filter->SetKernelPoint(x, bytes.flag() ? 0 : bytes.number(), 0);
  }
  filter->SetUseKernelPoint(bytes.flag());
}

/// Points for a source: none, its own, or those that the filter's input has now.
void givePoints(Bytes& bytes, int kind, vtkAlgorithm* filter, vtkPolyData* source)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(kind % 2 ? VTK_DOUBLE : VTK_FLOAT);
  auto* input = vtkPointSet::SafeDownCast(filter->GetInputDataObject(0, 0));
  if (kind > 3 && input)
  {
    source->SetPoints(input->GetPoints());
  }
  else if (kind > 1)
  {
    for (int i = bytes.below(12); i > 0; --i)
    {
      points->InsertNextPoint(bytes.raw<std::int8_t>(), bytes.raw<std::int8_t>(), 0);
    }
    source->SetPoints(points);
  }
}

/// Lines and polygons of small ids, now and then any; or something else, or none.
vtkSmartPointer<vtkDataObject> drawSource(Bytes& bytes)
{
  if (bytes.oneOf(8))
  {
    return bytes.flag() ? vtkSmartPointer<vtkTable>::New() : nullptr;
  }
  vtkNew<vtkCellArray> cells[2];
  for (int i = bytes.below(12); i > 0; --i)
  {
    vtkCellArray* const chosen = cells[bytes.below(2)];
    const bool isWild = bytes.oneOf(32);
    const int size = bytes.below(6);
    chosen->InsertNextCell(size);
    for (int k = 0; k < size; ++k)
    {
      chosen->InsertCellPoint(isWild ? bytes.integer() : bytes.below(8));
    }
  }
  auto source = vtkSmartPointer<vtkPolyData>::New();
  source->SetLines(cells[0]);
  source->SetPolys(cells[1]);
  return source;
}

void drawOwn(Bytes& bytes, vtkFFRegularTriangulationFilter* filter, int which)
{
  switch (which)
  {
    case 12:
      filter->SetMaximumEdgeLength(bytes.flag() ? 0.0 : bytes.number());
      break;
    case 14:
      filter->SetAlpha(bytes.flag() ? 0.0 : bytes.number());
      break;
    case 15:
      filter->SetAlphaLines(bytes.flag());
      break;
    case 16:
      filter->SetAlphaVerts(bytes.flag());
      break;
    case 17:
      filter->SetGenerateAlphas(bytes.flag());
      break;
    default:
      filter->SetGenerateBoundary(bytes.flag());
      break;
  }
}

void drawOwn(Bytes& bytes, vtkFFConstrainedDelaunayFilter* filter, int which)
{
  if (which == 12)
  {
    filter->SetMaximumEdgeLength(bytes.flag() ? 0.0 : bytes.number());
    return;
  }
  const int choices = bytes.byte();
  filter->SetSplitCrossingConstraints((choices & 1) != 0);
  filter->SetPolygonRule((choices >> 1) & 1);
  const auto source = drawSource(bytes);
  if (auto* cells = vtkPolyData::SafeDownCast(source))
  {
    givePoints(bytes, (choices >> 2) % 6, filter, cells);
  }
  filter->SetInputData(1, source);
}

void drawOwn(Bytes& bytes, vtkFFPowerDiagramFilter* filter, int which)
{
  if (which == 2)
  {
    filter->SetPowerDiagramBoxMode(drawChoice(bytes));
    return;
  }
  double box[4];
  for (double& bound : box)
  {
    bound = bytes.number();
  }
  filter->SetPowerDiagramBounds(box);
}

void drawOwn(Bytes& bytes, vtkFFPlanarAlgorithm* filter)
{
  const int which = bytes.below(19);
  switch (which)
  {
    case 3:
      filter->SetProjectionPlaneMode(drawChoice(bytes));
      break;
    case 4:
      filter->SetTransform(drawTransform(bytes));
      break;
    case 5:
    {
      const int association = drawChoice(bytes);
      filter->SetInputArrayToProcess(0, 0, 0, association, drawArrayName(bytes));
      break;
    }
    case 6:
      filter->SetInputArrayToProcess(
        0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, drawChoice(bytes));
      break;
    case 7:
      filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "weights");
      break;
    case 8:
      filter->SetProjectionPlaneMode(vtkFFPlanarAlgorithm::TRANSFORM_PLANE);
      filter->SetTransform(drawTransform(bytes));
      break;
    case 9:
      filter->SetGenerateCellMeasures(bytes.flag());
      break;
    case 10:
      filter->SetWeightMode(drawChoice(bytes));
      break;
    case 11:
      filter->SetWeightFactor(bytes.number());
      break;
    default:
      if (auto* triangulation = vtkFFRegularTriangulationFilter::SafeDownCast(filter))
      {
        drawOwn(bytes, triangulation, which);
      }
      else if (auto* constrained = vtkFFConstrainedDelaunayFilter::SafeDownCast(filter))
      {
        drawOwn(bytes, constrained, which);
      }
      else if (auto* diagram = vtkFFPowerDiagramFilter::SafeDownCast(filter))
      {
        drawOwn(bytes, diagram, which);
      }
      break;
  }
}

void drawOwn(Bytes& bytes, vtkFFSelectEnclosedPoints* filter)
{
  switch (bytes.below(3))
  {
    case 1:
      filter->SetInsideOut(bytes.flag());
      break;
    case 2:
      filter->SetSelectPointsOnSurface(bytes.flag());
      break;
    default:
      filter->SetGenerateDistances(bytes.flag());
      break;
  }
}

void drawOwn(Bytes& bytes, vtkFFPointInterpolator2D* filter)
{
  const char* name = nullptr;
  switch (bytes.below(10))
  {
    case 1:
      filter->SetNullPointsStrategy(drawChoice(bytes));
      break;
    case 2:
      filter->SetNullValue(bytes.number());
      break;
    case 3:
      name = drawArrayName(bytes);
      filter->SetValidPointsMaskArrayName(name ? name : "mask");
      break;
    case 4:
      filter->SetInterpolateZ(bytes.flag());
      break;
    case 5:
      name = drawArrayName(bytes);
      filter->SetZArrayName(name ? name : "z");
      break;
    case 6:
      filter->AddExcludedArray(drawArrayName(bytes));
      break;
    case 7:
      filter->SetPassPointArrays(bytes.flag());
      filter->SetPassCellArrays(bytes.flag());
      filter->SetPassFieldArrays(bytes.flag());
      break;
    case 8:
      filter->SetInputArrayToProcess(
        0, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, drawArrayName(bytes));
      break;
    case 9:
      filter->SetWeightMode(drawChoice(bytes));
      filter->SetWeightFactor(bytes.flag() ? 1.0 : bytes.number());
      break;
    default:
      filter->SetInterpolationMode(drawChoice(bytes));
      break;
  }
}

}

void drawSettings(Bytes& bytes, vtkFFAlgorithm* filter)
{
  for (int n = bytes.below(8); n > 0; --n)
  {
    if (bytes.flag())
    {
      drawCommon(bytes, filter);
    }
    else if (auto* convexify = vtkFFConvexifyFilter::SafeDownCast(filter))
    {
      drawOwn(bytes, convexify);
    }
    else if (auto* planar = vtkFFPlanarAlgorithm::SafeDownCast(filter))
    {
      drawOwn(bytes, planar);
    }
    else if (auto* hull = vtkFFHullFilter::SafeDownCast(filter))
    {
      const int choice = drawChoice(bytes); // one for both: the corpus has no byte for the second
      hull->SetCompositeMode(choice);
      hull->SetNumberOfStreamDivisions(choice);
    }
  }
}

void drawSettings(Bytes& bytes, vtkFFQueryAlgorithm* filter)
{
  for (int n = bytes.below(8); n > 0; --n)
  {
    switch (bytes.below(8))
    {
      case 1:
        filter->SetNumberOfThreads(drawThreads(bytes));
        break;
      case 2:
        filter->SetNonFinitePoints(drawChoice(bytes));
        break;
      case 3:
        filter->SetSkipGhostPoints(bytes.flag());
        break;
      default:
        if (auto* interpolator = vtkFFPointInterpolator2D::SafeDownCast(filter))
        {
          drawOwn(bytes, interpolator);
        }
        else if (auto* enclosed = vtkFFSelectEnclosedPoints::SafeDownCast(filter))
        {
          drawOwn(bytes, enclosed);
        }
        break;
    }
  }
}

}
}
