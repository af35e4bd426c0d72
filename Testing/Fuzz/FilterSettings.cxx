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

/// A setter with a value from the bytes.
template <class Filter>
using Setter = void (*)(Bytes&, Filter*);

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

void print(Bytes&, vtkFFAlgorithm* filter)
{
  std::ostringstream text;
  filter->Print(text);
}

void drawCommon(Bytes& bytes, vtkFFAlgorithm* filter)
{
  using F = vtkFFAlgorithm;
  static const Setter<F> setters[] = {
    [](Bytes&, F* f) { f->Modified(); },
    [](Bytes& b, F* f) { f->SetEngine(drawChoice(b)); },
    [](Bytes& b, F* f) { f->SetCUDAThreshold(static_cast<vtkIdType>(b.integer())); },
    [](Bytes& b, F* f) { f->SetNumberOfThreads(drawThreads(b)); },
    [](Bytes& b, F* f) { f->SetFacetMode(drawChoice(b)); },
    [](Bytes& b, F* f) { f->SetNonFinitePoints(drawChoice(b)); },
    [](Bytes& b, F* f) { f->SetPassPointData(b.flag()); },
    [](Bytes& b, F* f) { f->SetVisiblePointIds(b.flag()); },
    [](Bytes& b, F* f) { f->SetReportAsFieldData(b.flag()); },
    [](Bytes& b, F* f) { f->SetVBiased(b.flag()); },
    [](Bytes& b, F* f) { f->SetSkipGhostPoints(b.flag()); },
    print,
  };
  setters[bytes.below(12)](bytes, filter);
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

/// A length; 0 is none.
double drawLength(Bytes& bytes)
{
  return bytes.flag() ? 0.0 : bytes.number();
}

void drawOwn(Bytes& bytes, vtkFFRegularTriangulationFilter* filter, int which)
{
  using F = vtkFFRegularTriangulationFilter;
  static const Setter<F> setters[] = {
    [](Bytes& b, F* f) { f->SetMaximumEdgeLength(drawLength(b)); },
    [](Bytes& b, F* f) { f->SetGenerateBoundary(b.flag()); },
    [](Bytes& b, F* f) { f->SetAlpha(drawLength(b)); },
    [](Bytes& b, F* f) { f->SetAlphaLines(b.flag()); },
    [](Bytes& b, F* f) { f->SetAlphaVerts(b.flag()); },
    [](Bytes& b, F* f) { f->SetGenerateAlphas(b.flag()); },
    [](Bytes& b, F* f) { f->SetGenerateCertificate(b.flag()); },
  };
  setters[which >= 12 && which < 19 ? which - 12 : 1](bytes, filter);
}

void drawOwn(Bytes& bytes, vtkFFConstrainedDelaunayFilter* filter, int which)
{
  if (which == 12)
  {
    filter->SetMaximumEdgeLength(drawLength(bytes));
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

constexpr int OfPoints = vtkDataObject::FIELD_ASSOCIATION_POINTS;

void drawOwn(Bytes& bytes, vtkFFPlanarAlgorithm* filter)
{
  using F = vtkFFPlanarAlgorithm;
  static const Setter<F> setters[] = {
    [](Bytes& b, F* f) { f->SetProjectionPlaneMode(drawChoice(b)); },
    [](Bytes& b, F* f) { f->SetTransform(drawTransform(b)); },
    [](Bytes& b, F* f)
    {
      const int association = drawChoice(b);
      f->SetInputArrayToProcess(0, 0, 0, association, drawArrayName(b));
    },
    [](Bytes& b, F* f) { f->SetInputArrayToProcess(0, 0, 0, OfPoints, drawChoice(b)); },
    [](Bytes&, F* f) { f->SetInputArrayToProcess(0, 0, 0, OfPoints, "weights"); },
    [](Bytes& b, F* f)
    {
      f->SetProjectionPlaneMode(F::TRANSFORM_PLANE);
      f->SetTransform(drawTransform(b));
    },
    [](Bytes& b, F* f) { f->SetGenerateCellMeasures(b.flag()); },
    [](Bytes& b, F* f) { f->SetWeightMode(drawChoice(b)); },
    [](Bytes& b, F* f) { f->SetWeightFactor(b.number()); },
  };
  const int which = bytes.below(19);
  if (which >= 3 && which < 12)
  {
    setters[which - 3](bytes, filter);
  }
  else if (auto* triangulation = vtkFFRegularTriangulationFilter::SafeDownCast(filter))
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
}

void drawOwn(Bytes& bytes, vtkFFSelectEnclosedPoints* filter)
{
  using F = vtkFFSelectEnclosedPoints;
  static const Setter<F> setters[] = {
    [](Bytes& b, F* f) { f->SetGenerateDistances(b.flag()); },
    [](Bytes& b, F* f) { f->SetInsideOut(b.flag()); },
    [](Bytes& b, F* f) { f->SetSelectPointsOnSurface(b.flag()); },
  };
  setters[bytes.below(3)](bytes, filter);
}

/// An array's name, and never none.
const char* drawName(Bytes& bytes, const char* otherwise)
{
  const char* const name = drawArrayName(bytes);
  return name ? name : otherwise;
}

void drawOwn(Bytes& bytes, vtkFFPointInterpolator2D* filter)
{
  using F = vtkFFPointInterpolator2D;
  static const Setter<F> setters[] = {
    [](Bytes& b, F* f) { f->SetInterpolationMode(drawChoice(b)); },
    [](Bytes& b, F* f) { f->SetNullPointsStrategy(drawChoice(b)); },
    [](Bytes& b, F* f) { f->SetNullValue(b.number()); },
    [](Bytes& b, F* f) { f->SetValidPointsMaskArrayName(drawName(b, "mask")); },
    [](Bytes& b, F* f) { f->SetInterpolateZ(b.flag()); },
    [](Bytes& b, F* f) { f->SetZArrayName(drawName(b, "z")); },
    [](Bytes& b, F* f) { f->AddExcludedArray(drawArrayName(b)); },
    [](Bytes& b, F* f)
    {
      f->SetPassPointArrays(b.flag());
      f->SetPassCellArrays(b.flag());
      f->SetPassFieldArrays(b.flag());
    },
    [](Bytes& b, F* f) { f->SetInputArrayToProcess(0, 1, 0, OfPoints, drawArrayName(b)); },
    [](Bytes& b, F* f)
    {
      f->SetWeightMode(drawChoice(b));
      f->SetWeightFactor(b.flag() ? 1.0 : b.number());
    },
  };
  setters[bytes.below(10)](bytes, filter);
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
  using F = vtkFFQueryAlgorithm;
  static const Setter<F> setters[] = {
    [](Bytes& b, F* f) { f->SetNumberOfThreads(drawThreads(b)); },
    [](Bytes& b, F* f) { f->SetNonFinitePoints(drawChoice(b)); },
    [](Bytes& b, F* f) { f->SetSkipGhostPoints(b.flag()); },
  };
  for (int n = bytes.below(8); n > 0; --n)
  {
    const int which = bytes.below(8);
    if (which >= 1 && which < 4)
    {
      setters[which - 1](bytes, filter);
    }
    else if (auto* interpolator = vtkFFPointInterpolator2D::SafeDownCast(filter))
    {
      drawOwn(bytes, interpolator);
    }
    else if (auto* enclosed = vtkFFSelectEnclosedPoints::SafeDownCast(filter))
    {
      drawOwn(bytes, enclosed);
    }
  }
}

}
}
