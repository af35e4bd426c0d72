// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FilterSettings.h"
#include "FilterInputs.h"

#include "vtkCellArray.h"
#include "vtkDataObject.h"
#include "vtkFFConvexifyFilter.h"
#include "vtkFFHullFilter.h"
#include "vtkFFPointInterpolator2D.h"
#include "vtkFFPointsToImage.h"
#include "vtkFFPowerDiagramFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkFFSelectEnclosedPoints.h"
#include "vtkFFTerrainMeshFilter.h"
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

#include <functional>
#include <sstream>
#include <vector>

namespace flipflop
{
namespace fuzz
{

namespace
{

constexpr int OfPoints = vtkDataObject::FIELD_ASSOCIATION_POINTS;

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

/// An array's name, and never none.
const char* drawName(Bytes& bytes, const char* otherwise)
{
  const char* const name = drawArrayName(bytes);
  return name ? name : otherwise;
}

/// A setter with a value from the bytes, for filters of its class.
struct Setter
{
  std::function<bool(vtkObject*)> fits;
  std::function<void(Bytes&, vtkObject*)> set;
};

template <class F>
Setter of(void (*set)(Bytes&, F*))
{
  return { [](vtkObject* filter) { return F::SafeDownCast(filter) != nullptr; },
    [set](Bytes& bytes, vtkObject* filter) { set(bytes, F::SafeDownCast(filter)); } };
}

void print(Bytes&, vtkFFAlgorithm* filter)
{
  std::ostringstream text;
  filter->Print(text);
}

void setKernel(Bytes& bytes, vtkFFConvexifyFilter* filter)
{
  if (bytes.flag())
  {
    const double x = bytes.number();
    filter->SetKernelPoint(x, bytes.flag() ? 0 : bytes.number(), 0);
  }
  filter->SetUseKernelPoint(bytes.flag());
}

void setSource(Bytes& bytes, vtkFFRegularTriangulationFilter* filter)
{
  const int choices = bytes.byte();
  filter->SetSplitCrossingConstraints((choices & 1) != 0);
  filter->SetPolygonRule((choices >> 1) & 1);
  filter->SetSourcePoints((choices >> 5) % 3);
  filter->SetClosedLinesAsBorders((choices & 16) != 0);
  const auto source = drawSource(bytes);
  if (auto* cells = vtkPolyData::SafeDownCast(source))
  {
    givePoints(bytes, (choices >> 2) % 6, filter, cells);
  }
  filter->SetInputData(1, source);
}

/// Any bounds and any spacing, of few pixels.
void setGrid(Bytes& bytes, vtkFFPointsToImage* filter)
{
  const int kind = bytes.below(4);
  filter->SetSizeMode(kind > 1);
  filter->SetUseInputBounds(kind == 0);
  filter->SetDimensions(bytes.below(48) - 1, bytes.below(48) - 1);
  double box[4];
  double step[2];
  for (int k = 0; k < 2; ++k)
  {
    step[k] = bytes.number();
    box[2 * k] = kind == 3 ? bytes.raw<std::int8_t>() : bytes.number();
    box[2 * k + 1] = kind == 1 ? bytes.number() : box[2 * k] + step[k] * bytes.below(48);
  }
  filter->SetSpacing(step);
  filter->SetSamplingBounds(box);
}

void setBreaklines(Bytes& bytes, vtkFFPointsToImage* filter)
{
  const int kind = bytes.below(6);
  const auto drawn = drawSource(bytes);
  auto* const source = vtkPolyData::SafeDownCast(drawn);
  if (source)
  {
    givePoints(bytes, kind, filter, source);
  }
  filter->SetSourceData(source);
}

void setBounds(Bytes& bytes, vtkFFPowerDiagramFilter* filter)
{
  double box[4];
  for (double& bound : box)
  {
    bound = bytes.number();
  }
  filter->SetPowerDiagramBounds(box);
}

std::vector<Setter> settersOfAll()
{
  using F = vtkFFAlgorithm;
  return {
    of<F>([](Bytes&, F* f) { f->Modified(); }),
    of<F>([](Bytes& b, F* f) { f->SetEngine(drawChoice(b)); }),
    of<F>([](Bytes& b, F* f) { f->SetCUDAThreshold(static_cast<vtkIdType>(b.integer())); }),
    of<F>([](Bytes& b, F* f) { f->SetNumberOfThreads(drawThreads(b)); }),
    of<F>([](Bytes& b, F* f) { f->SetFacetMode(drawChoice(b)); }),
    of<F>([](Bytes& b, F* f) { f->SetNonFinitePoints(drawChoice(b)); }),
    of<F>([](Bytes& b, F* f) { f->SetPassPointData(b.flag()); }),
    of<F>([](Bytes& b, F* f) { f->SetVisiblePointIds(b.flag()); }),
    of<F>([](Bytes& b, F* f) { f->SetReportAsFieldData(b.flag()); }),
    of<F>([](Bytes& b, F* f) { f->SetVBiased(b.flag()); }),
    of<F>([](Bytes& b, F* f) { f->SetSkipGhostPoints(b.flag()); }),
    of<F>(print),
    of<vtkFFHullFilter>([](Bytes& b, vtkFFHullFilter* f) { f->SetCompositeMode(drawChoice(b)); }),
    of<vtkFFHullFilter>(
      [](Bytes& b, vtkFFHullFilter* f) { f->SetNumberOfStreamDivisions(drawChoice(b)); }),
    of<vtkFFConvexifyFilter>(setKernel),
  };
}

std::vector<Setter> settersOfThePlane()
{
  using F = vtkFFPlanarAlgorithm;
  using T = vtkFFRegularTriangulationFilter;
  using P = vtkFFPowerDiagramFilter;
  return {
    of<F>([](Bytes& b, F* f) { f->SetProjectionPlaneMode(drawChoice(b)); }),
    of<F>([](Bytes& b, F* f) { f->SetTransform(drawTransform(b)); }),
    of<F>(
      [](Bytes& b, F* f)
      {
        const int association = drawChoice(b);
        f->SetInputArrayToProcess(0, 0, 0, association, drawArrayName(b));
      }),
    of<F>([](Bytes& b, F* f) { f->SetInputArrayToProcess(0, 0, 0, OfPoints, drawChoice(b)); }),
    of<F>([](Bytes&, F* f) { f->SetInputArrayToProcess(0, 0, 0, OfPoints, "weights"); }),
    of<F>(
      [](Bytes& b, F* f)
      {
        f->SetProjectionPlaneMode(F::TRANSFORM_PLANE);
        f->SetTransform(drawTransform(b));
      }),
    of<F>([](Bytes& b, F* f) { f->SetGenerateCellMeasures(b.flag()); }),
    of<F>([](Bytes& b, F* f) { f->SetWeightMode(drawChoice(b)); }),
    of<F>([](Bytes& b, F* f) { f->SetWeightFactor(b.number()); }),
    of<T>([](Bytes& b, T* f) { f->SetMaximumEdgeLength(drawLength(b)); }),
    of<T>([](Bytes& b, T* f) { f->SetGenerateBoundary(b.flag()); }),
    of<T>([](Bytes& b, T* f) { f->SetAlpha(drawLength(b)); }),
    of<T>([](Bytes& b, T* f) { f->SetAlphaLines(b.flag()); }),
    of<T>([](Bytes& b, T* f) { f->SetAlphaVerts(b.flag()); }),
    of<T>([](Bytes& b, T* f) { f->SetGenerateAlphas(b.flag()); }),
    of<T>(setSource),
    of<P>([](Bytes& b, P* f) { f->SetPowerDiagramBoxMode(drawChoice(b)); }),
    of<P>(setBounds),
  };
}

/// What both filters have that interpolate.
template <class I>
std::vector<Setter> settersOfInterpolation()
{
  return {
    of<I>([](Bytes& b, I* f) { f->SetInterpolationMode(drawChoice(b)); }),
    of<I>([](Bytes& b, I* f) { f->SetNullPointsStrategy(drawChoice(b)); }),
    of<I>([](Bytes& b, I* f) { f->SetNullValue(b.number()); }),
    of<I>([](Bytes& b, I* f) { f->SetValidPointsMaskArrayName(drawName(b, "mask")); }),
    of<I>([](Bytes& b, I* f) { f->SetInterpolateZ(b.flag()); }),
    of<I>([](Bytes& b, I* f) { f->SetZArrayName(drawName(b, "z")); }),
  };
}

std::vector<Setter> settersOfTerrain()
{
  using I = vtkFFPointsToImage;
  using M = vtkFFTerrainMeshFilter;
  return {
    of<I>(setGrid),
    of<I>(setBreaklines),
    of<M>([](Bytes& b, M* f) { f->SetTolerance(drawLength(b)); }),
    of<M>([](Bytes& b, M* f) { f->SetMaximumNumberOfVertices(b.below(100)); }),
    of<M>([](Bytes& b, M* f) { f->SetInputArrayToProcess(0, 0, 0, OfPoints, drawArrayName(b)); }),
  };
}

std::vector<Setter> settersOfQueries()
{
  using F = vtkFFQueryAlgorithm;
  using S = vtkFFSelectEnclosedPoints;
  using I = vtkFFPointInterpolator2D;
  return {
    of<F>([](Bytes& b, F* f) { f->SetNumberOfThreads(drawThreads(b)); }),
    of<F>([](Bytes& b, F* f) { f->SetNonFinitePoints(drawChoice(b)); }),
    of<F>([](Bytes& b, F* f) { f->SetSkipGhostPoints(b.flag()); }),
    of<S>([](Bytes& b, S* f) { f->SetGenerateDistances(b.flag()); }),
    of<S>([](Bytes& b, S* f) { f->SetInsideOut(b.flag()); }),
    of<S>([](Bytes& b, S* f) { f->SetSelectPointsOnSurface(b.flag()); }),
    of<I>([](Bytes& b, I* f) { f->AddExcludedArray(drawArrayName(b)); }),
    of<I>(
      [](Bytes& b, I* f)
      {
        f->SetPassPointArrays(b.flag());
        f->SetPassCellArrays(b.flag());
        f->SetPassFieldArrays(b.flag());
      }),
    of<I>([](Bytes& b, I* f) { f->SetInputArrayToProcess(0, 1, 0, OfPoints, drawArrayName(b)); }),
    of<I>(
      [](Bytes& b, I* f)
      {
        f->SetWeightMode(drawChoice(b));
        f->SetWeightFactor(b.flag() ? 1.0 : b.number());
      }),
  };
}

std::vector<Setter> everySetter()
{
  std::vector<Setter> all;
  for (const auto& some : { settersOfAll(), settersOfThePlane(), settersOfTerrain(),
         settersOfQueries(), settersOfInterpolation<vtkFFPointsToImage>(),
         settersOfInterpolation<vtkFFPointInterpolator2D>() })
  {
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

}

void drawSettings(Bytes& bytes, vtkObject* filter)
{
  static const std::vector<Setter> setters = everySetter();
  std::vector<const Setter*> own;
  for (const Setter& setter : setters)
  {
    if (setter.fits(filter))
    {
      own.push_back(&setter);
    }
  }
  for (int n = bytes.below(8); n > 0; --n)
  {
    own[static_cast<std::size_t>(bytes.below(static_cast<int>(own.size())))]->set(bytes, filter);
  }
}

}
}
