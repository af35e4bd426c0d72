// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Images of points: each pixel has the bits that vtkFFPointInterpolator2D gives there, on any
// number of threads; where pixels are, by dimensions and by spacing; planes, breaklines, what is
// known before the data, what is kept, errors.
#include "FFPieceSource.h"
#include "FFPlanar.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFFPointInterpolator2D.h"
#include "vtkFFPointsToImage.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"
#include "vtkTransform.h"

#include <flipflop/RegularTriangulation.h>
#include <flipflop/TriangulationQueries.h>

#include <algorithm>
#include <array>
#include <climits>
#include <cmath>
#include <functional>
#include <iostream>
#include <utility>

using namespace fftest;

namespace
{

using Image = vtkFFPointsToImage;
using Numbers = std::vector<double>;

/// A filter with its input and its messages.
struct Imaging
{
  explicit Imaging(vtkDataObject* input)
    : Errors(ErrorObserver::Of(this->Filter))
  {
    this->Filter->SetReportAsFieldData(true);
    this->Filter->SetInputDataObject(input);
  }

  Image* operator->() { return this->Filter; }

  /// The output after a run without a message.
  vtkImageData* Run()
  {
    FF_CHECK(succeeds(this->Filter));
    return this->Filter->GetOutput();
  }

  Numbers Values(const char* name)
  {
    vtkDataArray* const array = this->Run()->GetPointData()->GetArray(name);
    Numbers values;
    for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
    {
      values.push_back(array->GetComponent(
        i / array->GetNumberOfComponents(), static_cast<int>(i % array->GetNumberOfComponents())));
    }
    return values;
  }

  void Fail(unsigned long code, const std::string& words)
  {
    this->Filter->Modified();
    FF_CHECK(fails(this->Filter, code, { words }));
  }

  vtkNew<Image> Filter;
  vtkSmartPointer<ErrorObserver> Errors;
};

/// Points with arrays of several types, one of several components.
vtkSmartPointer<vtkPolyData> makeSource(int count, unsigned int seed)
{
  const auto points = randomPoints(count, seed);
  const auto source = makeWeighted(points, Numbers(points.size(), 0.0), VTK_INT, "integers");
  vtkNew<vtkDoubleArray> waves;
  waves->SetName("waves");
  vtkNew<vtkFloatArray> pairs;
  pairs->SetName("pairs");
  pairs->SetNumberOfComponents(2);
  pairs->SetComponentName(1, "y");
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Point& p = points[i];
    waves->InsertNextValue(std::sin(5.0 * p[0]) * p[1]);
    pairs->InsertNextTuple2(p[0] * p[1], -p[1]);
    source->GetPointData()->GetArray("integers")->SetTuple1(static_cast<vtkIdType>(i), 100 * p[2]);
  }
  source->GetPointData()->SetScalars(waves);
  source->GetPointData()->SetTCoords(pairs);
  return source;
}

/// An image without its report, and without arrays.
vtkSmartPointer<vtkImageData> gridOf(vtkImageData* image)
{
  auto grid = vtkSmartPointer<vtkImageData>::New();
  grid->CopyStructure(image);
  return grid;
}

vtkSmartPointer<vtkImageData> withoutReport(vtkImageData* image)
{
  auto copy = gridOf(image);
  copy->GetPointData()->ShallowCopy(image->GetPointData());
  return copy;
}

/// The promise: the bits of vtkFFPointInterpolator2D, and they do not depend on threads.
void testAgainstPoints()
{
  constexpr unsigned int seed = 811;
  std::cout << "seed " << seed << "\n";
  const auto source = makeSource(2000, seed);
  const auto weighted = randomWeighted(500, seed);
  const auto grid = makeSource(900, seed); // of facets with four corners
  for (int i = 0; i < 900; ++i)
  {
    grid->GetPoints()->SetPoint(i, 0.07 * (i % 30), 0.07 * (i / 30), grid->GetPoint(i)[2]);
  }
  vtkNew<vtkFFPointInterpolator2D> points;
  for (vtkPolyData* given : { source.Get(), weighted.Get(), grid.Get() })
  {
    Imaging run(given);
    points->SetSourceData(given);
    const char* const weights = given == weighted ? "weights" : "";
    useWeights(run.Filter, weights);
    points->SetInputArrayToProcess(0, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, weights);
    for (int k = 0; k < 9; ++k)
    {
      const double null = k % 2 == 0 ? notANumber : -7.0;
      run->SetFacetMode(k % 2);
      run->SetInterpolationMode(k / 3);
      points->SetInterpolationMode(k / 3);
      run->SetNullPointsStrategy(k % 3);
      points->SetNullPointsStrategy(k % 3);
      run->SetNullValue(null);
      points->SetNullValue(null);
      if (k % 4 == 0)
      {
        run->SetDimensions(71, 43);
        run->SetSizeMode(Image::SIZE_BY_DIMENSIONS);
      }
      else
      {
        run->SetSpacing(0.041, 0.07);
        run->SetSizeMode(Image::SIZE_BY_SPACING);
      }
      vtkSmartPointer<vtkImageData> first;
      for (const int threads : { 1, 2, 4 })
      {
        run->SetNumberOfThreads(threads);
        const auto image = withoutReport(run.Run());
        first = first ? first : image;
        FF_CHECK(isIdentical(image, first, "on other threads"));
      }
      FF_CHECK(first->GetNumberOfPoints() > 1000);
      points->SetInputData(gridOf(first));
      FF_CHECK(succeeds(points));
      FF_CHECK(isIdentical(first, points->GetOutput(), "by points"));
      FF_CHECK(first->GetPointData()->HasArray("vtkValidPointMask") == (k % 3 == 0));
    }
  }
}

/// And those of the engine's image, which Python's to_image() gives: its rows go down. In these
/// bounds, sums are exact, so positions do not depend on where rows are counted from.
void testAgainstEngine()
{
  constexpr int columns = 64;
  constexpr int rows = 32;
  const auto points = randomPoints(1500, 817);
  const flipflop::PointView view(points[0].data(), 1500, 3);
  const flipflop::TriangulationQueries queries(
    view, flipflop::WeightView(), flipflop::regularTriangulation(view, flipflop::WeightView()));
  Numbers heights;
  for (const Point& p : points)
  {
    heights.push_back(p[2]);
  }
  const flipflop::ImageGrid grid{ { -1.0 + 1.0 / columns, 1.0 - 1.0 / rows },
    { 2.0 / columns, -2.0 / rows }, { columns, rows }, {} };
  Imaging run(makePoints(points));
  run->SetUseInputBounds(false);
  run->SetSamplingBounds(-1, 1, -1, 1);
  run->SetDimensions(columns, rows);
  run->SetNullValue(-7.0);
  using flipflop::Interpolation;
  for (const auto method :
    { Interpolation::Linear, Interpolation::Natural, Interpolation::CloughTocher })
  {
    Numbers expected(columns * rows);
    queries.interpolateImage(
      method, heights.data(), 1, grid, flipflop::ImageView(expected.data()), -7.0);
    for (int row = 0; 2 * row < rows; ++row)
    {
      std::swap_ranges(expected.begin() + row * columns, expected.begin() + (row + 1) * columns,
        expected.end() - (row + 1) * columns);
    }
    run->SetInterpolationMode(static_cast<int>(method));
    FF_CHECK(run.Values("Elevation") == expected);
    const auto nulls = std::count(expected.begin(), expected.end(), -7.0);
    FF_CHECK(nulls > 0 && nulls < columns * rows / 2);
  }
}

/// Where pixels are, and their values by heart.
void testSizes()
{
  // z is 0 on the diagonal from corner 0 to corner 2; 8 at the others.
  Imaging run(makePoints({ { 0, 0, 0 }, { 4, 0, 8 }, { 4, 4, 0 }, { 0, 4, 8 } }));
  run->SetDimensions(2, 4);
  FF_CHECK((run.Values("Elevation") == Numbers{ 1, 5, 1, 3, 3, 1, 5, 1 }));
  const auto isAt = [&](std::array<int, 2> size, Point origin, std::array<double, 2> spacing)
  {
    vtkImageData* const image = run->GetOutput();
    const double* const x = image->GetOrigin();
    const double* const step = image->GetSpacing();
    return image->GetDimensions()[0] == size[0] && image->GetDimensions()[1] == size[1] &&
      image->GetDimensions()[2] == 1 && std::equal(x, x + 3, origin.begin()) &&
      step[0] == spacing[0] && step[1] == spacing[1] && step[2] == 1.0;
  };
  FF_CHECK(isAt({ 2, 4 }, { 1, 0.5, 0 }, { 2, 1 }));
  // From the left and from the top on, whole pixels.
  run->SetSizeMode(Image::SIZE_BY_SPACING);
  run->SetSpacing(2, 3);
  FF_CHECK_EQUAL(run.Values("Elevation").size(), 4u);
  FF_CHECK(isAt({ 2, 2 }, { 1, -0.5, 0 }, { 2, 3 }));
  FF_CHECK((run.Values("vtkValidPointMask") == Numbers{ 0, 0, 1, 1 }));
  run->SetSpacing(100, 1e-300 + 4.0 / (1.0 + 1e-8)); // but for a millionth of a pixel
  run.Run();
  FF_CHECK_EQUAL(run->GetOutput()->GetDimensions()[1], 1);
  run->SetUseInputBounds(false);
  run->SetSamplingBounds(-4, 4, 0, 2);
  run->SetSpacing(2, 1);
  run->SetNullValue(-1);
  FF_CHECK((run.Values("Elevation") == Numbers{ -1, -1, 1, 5, -1, -1, 1, 3 }));
  FF_CHECK(isAt({ 4, 2 }, { -3, 0.5, 0 }, { 2, 1 }));

  // Arrays: no ids, no marks, no strings; all or none; attributes.
  const auto source = makeSource(50, 812);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("ids");
  ids->SetNumberOfValues(50);
  ids->Fill(1);
  source->GetPointData()->SetGlobalIds(ids);
  vtkNew<vtkStringArray> words;
  words->SetName("words");
  words->SetNumberOfValues(50);
  source->GetPointData()->AddArray(words);
  addGhosts(source, { 3 });
  const auto namesOf = [](vtkImageData* image)
  {
    std::string names;
    for (int i = 0; i < image->GetPointData()->GetNumberOfArrays(); ++i)
    {
      names += std::string(" ") + image->GetPointData()->GetArrayName(i);
    }
    return names;
  };
  Imaging arrays(source);
  FF_CHECK_EQUAL(namesOf(arrays.Run()), " integers waves pairs Elevation vtkValidPointMask");
  FF_CHECK_EQUAL(arrays->GetNumberOfInputPoints(), 49);
  vtkPointData* const data = arrays->GetOutput()->GetPointData();
  FF_CHECK(data->GetTCoords() == data->GetArray("pairs"));
  FF_CHECK_EQUAL(std::string(data->GetTCoords()->GetComponentName(1)), "y");
  FF_CHECK_EQUAL(data->GetTCoords()->GetDataType(), VTK_FLOAT);
  FF_CHECK_EQUAL(data->GetArray("integers")->GetDataType(), VTK_DOUBLE);
  arrays->SetPassPointData(false);
  arrays->SetZArrayName("z");
  arrays->SetValidPointsMaskArrayName("mask");
  FF_CHECK_EQUAL(namesOf(arrays.Run()), " z mask");
  arrays->SetInterpolateZ(false);
  FF_CHECK_EQUAL(namesOf(arrays.Run()), " mask");
}

/// Of few points, and of points on a line.
void testSmall()
{
  Imaging run(makePoints({}));
  FF_CHECK(isEmpty(run.Run()));
  FF_CHECK_EQUAL(run->GetDimension(), -1);
  run->SetUseInputBounds(false);
  run->SetDimensions(2, 1);
  run->SetNullValue(5.0);
  FF_CHECK((run.Values("Elevation") == Numbers{ 5, 5 }));
  run->SetUseInputBounds(true);
  run->SetDimensions(1, 2);
  run->SetNullValue(-1.0);
  run->SetInputDataObject(makePoints({ { 2, 3, 7 } }));
  FF_CHECK((run.Values("Elevation") == Numbers{ -1, -1 }));
  FF_CHECK_EQUAL(run->GetOutput()->GetOrigin()[1], 2.75);
  run->SetDimensions(1, 1);
  FF_CHECK((run.Values("Elevation") == Numbers{ 7 }));
  FF_CHECK_EQUAL(run->GetDimension(), 0);
  run->SetDimensions(3, 3);
  run->SetInputDataObject(makePoints({ { 0, 1, 0 }, { 6, 1, 12 } }));
  FF_CHECK((run.Values("Elevation") == Numbers{ -1, -1, -1, 2, 6, 10, -1, -1, -1 }));
  FF_CHECK_EQUAL(run->GetDimension(), 1);
  run->SetInputDataObject(makePoints({ { 0, 0, 0 }, { 6, 6, 12 }, { 2, 2, 4 } }));
  FF_CHECK((run.Values("Elevation") == Numbers{ 2, -1, -1, -1, 6, -1, -1, -1, 10 }));
}

/// In its plane, an image lies where its points are.
void testPlanes()
{
  // z = x / 2 + y / 4 + 3: a linear function has its own values at all pixels.
  auto points = randomPoints(300, 813);
  const auto height = [](const double* p) { return 0.5 * p[0] + 0.25 * p[1] + 3.0; };
  for (Point& p : points)
  {
    p[2] = height(p.data());
  }
  Imaging run(makePoints(points));
  run->SetDimensions(20, 10);
  run->SetProjectionPlaneMode(Image::BEST_FITTING_PLANE);
  const Numbers values = run.Values("Elevation");
  const Numbers mask = run.Values("vtkValidPointMask");
  int valid = 0;
  for (vtkIdType i = 0; i < 200; ++i)
  {
    double x[3];
    run->GetOutput()->GetPoint(i, x);
    FF_CHECK(std::abs(x[2] - height(x)) < 1e-12);
    const auto k = static_cast<std::size_t>(i);
    valid += mask[k] > 0.0 ? 1 : 0;
    FF_CHECK(mask[k] > 0.0 ? std::abs(values[k] - x[2]) < 1e-12 : std::isnan(values[k]));
  }
  FF_CHECK(valid > 100 && valid < 200);

  vtkNew<vtkTransform> transform;
  transform->Scale(2.0, 1.0, 1.0);
  Imaging moved(makePoints({ { 0, 0, 0 }, { 4, 0, 8 }, { 4, 4, 0 }, { 0, 4, 8 } }));
  moved->SetDimensions(2, 4);
  moved->SetTransform(transform);
  FF_CHECK((moved.Values("Elevation") == Numbers{ 1, 5, 1, 3, 3, 1, 5, 1 }));
  FF_CHECK_EQUAL(moved->GetOutput()->GetSpacing()[0], 4.0);
  moved->SetProjectionPlaneMode(Image::XY_PLANE);
  moved.Run();
  FF_CHECK_EQUAL(moved->GetOutput()->GetSpacing()[0], 2.0);
}

/// Pixels of the triangulation with breaklines, inside polygons.
void testBreaklines()
{
  const auto input = makePoints({ { 0, 0, 0 }, { 4, 0, 8 }, { 4, 4, 0 }, { 0, 4, 8 } });
  Imaging run(input);
  run->SetDimensions(2, 4);
  run->SetSourceData(makeConstraints({ { 1, 3 } })); // the diagonal of 8
  FF_CHECK((run.Values("Elevation") == Numbers{ 3, 7, 5, 7, 7, 5, 7, 3 }));
  FF_CHECK_EQUAL(std::string(run->GetEngineReason()), "constraints are the CPU's");
  run->SetSourceData(makeConstraints({}, { { 0, 1, 3 } }));
  run->SetNullValue(-1);
  FF_CHECK((run.Values("Elevation") == Numbers{ 3, 7, 5, -1, 7, -1, -1, -1 }));
  run->SetInterpolationMode(Image::CLOUGH_TOCHER);
  FF_CHECK((run.Values("vtkValidPointMask") == Numbers{ 1, 1, 1, 0, 1, 0, 0, 0 }));

  constexpr unsigned long setting = vtkFFErrorCode::SettingError;
  const std::string unknown = "Natural neighbours and closest points do not know breaklines. "
                              "Choose another, or take the source away.";
  run->SetInterpolationMode(Image::NATURAL_NEIGHBOR);
  run.Fail(setting, unknown);
  run->SetInterpolationMode(Image::LINEAR);
  run->SetNullPointsStrategy(Image::CLOSEST_POINT);
  run.Fail(setting, unknown);
  run->SetNullPointsStrategy(Image::NULL_VALUE);
  run->SetEngine(vtkFFAlgorithm::ENGINE_CUDA);
  run.Fail(setting, "The CUDA engine was asked for, but constraints are the CPU's.");
  run->SetEngine(vtkFFAlgorithm::ENGINE_AUTOMATIC);
  run->SetSourceData(makeConstraints({ { 0, 2 }, { 1, 3 } }));
  run.Fail(vtkFFErrorCode::ConstraintError,
    "An edge of cell 1 of the source crosses one of cell 0 of the source, and there is no point "
    "where they do. Add one to the input and to both.");
  run->SetSourceData(makeConstraints({ { 0, 7 } }));
  run.Fail(vtkFFErrorCode::InputError, "Point 7 of cell 0 of the source is not there");
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, input);
  blocks->SetBlock(1, input);
  run->SetInputDataObject(blocks);
  run->Update();
  FF_CHECK(run.Errors->Has("The source's lines are for one data set"));
  run->RemoveSource();
  FF_CHECK(succeeds(run.Filter));
  Imaging weighted(makeWeighted(cubeCorners(), Numbers(8, 0.0)));
  useWeights(weighted.Filter);
  weighted->SetSourceData(makeConstraints({ { 0, 3 } }));
  weighted.Fail(setting, "Constraints take no weights.");

  // Breaklines that cross, with points of their own: by the filter that takes them.
  vtkNew<vtkPoints> own;
  const Point ends[] = { { -9, 2, 1 }, { 13, 2, 1 }, { 2, -9, 1 }, { 2, 13, 1 } };
  for (const Point& end : ends)
  {
    own->InsertNextPoint(end.data());
  }
  vtkNew<vtkFFRegularTriangulationFilter> lines;
  lines->SetInputData(input);
  lines->SetSourceData(makeConstraints({ { 0, 1 }, { 2, 3 } }, {}, own));
  lines->SetSourcePoints(vtkFFRegularTriangulationFilter::OWN_POINTS);
  lines->SetSplitCrossingConstraints(true);
  Imaging split(nullptr);
  split->SetInputConnection(lines->GetOutputPort(0));
  split->SetSourceConnection(lines->GetOutputPort(3));
  split->SetUseInputBounds(false);
  split->SetSamplingBounds(-1, 3, 1.5, 2.5); // its pixels are on the first line
  split->SetDimensions(4, 1);
  FF_CHECK((split.Values("Elevation") == Numbers{ 1, 1, 1, 1 }));
  FF_CHECK_EQUAL(lines->GetNumberOfSplitPoints(), 1);
  split->RemoveSource();
  FF_CHECK((split.Values("Elevation") != Numbers{ 1, 1, 1, 1 }));
}

/// What a pipeline has before the data, and that one error is said once.
void testExtents()
{
  Imaging run(makePoints(randomPoints(50, 814)));
  const auto extentOf = [&]
  {
    run->UpdateInformation();
    std::array<int, 6> extent{};
    run->GetOutputInformation(0)->Get(
      vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent.data());
    return extent;
  };
  using Extent = std::array<int, 6>;
  FF_CHECK((extentOf() == Extent{ 0, 255, 0, 255, 0, 0 }));
  run->SetSizeMode(Image::SIZE_BY_SPACING);
  FF_CHECK((extentOf() == Extent{ 0, -1, 0, -1, 0, -1 }));
  run->SetSpacing(0.5, 0.25);
  run.Run();
  FF_CHECK_EQUAL(run->GetOutput()->GetDimensions()[0], 4);
  run->SetUseInputBounds(false);
  FF_CHECK((extentOf() == Extent{ 0, 1, 0, 3, 0, 0 }));
  vtkInformation* const info = run->GetOutputInformation(0);
  FF_CHECK_EQUAL(info->Get(vtkDataObject::ORIGIN())[1], 0.125);
  FF_CHECK_EQUAL(info->Get(vtkDataObject::SPACING())[0], 0.5);
  run->SetProjectionPlaneMode(Image::BEST_FITTING_PLANE);
  FF_CHECK((extentOf() == Extent{ 0, 1, 0, 3, 0, 0 }));
  FF_CHECK(!info->Has(vtkDataObject::ORIGIN()) && !info->Has(vtkDataObject::SPACING()));
  run->SetProjectionPlaneMode(Image::XY_PLANE);
  run->SetSpacing(-1.0, 1.0);
  FF_CHECK((extentOf() == Extent{ 0, -1, 0, -1, 0, -1 }));
  run->SetSpacing(1.0, 1.0);

  // Of whatever piece of the image, all points are asked for.
  vtkNew<PieceSource> pieces;
  pieces->SetWhole(makePoints(cubeCorners()));
  Imaging part(nullptr);
  part->SetInputConnection(pieces->GetOutputPort());
  part->SetDimensions(4, 4);
  part->UpdatePiece(1, 2, 0);
  FF_CHECK((pieces->Asked == std::vector<std::pair<int, int>>{ { 0, 1 } }));
  FF_CHECK_EQUAL(part->GetNumberOfInputPoints(), 8);
  FF_CHECK_EQUAL(part->GetOutput()->GetNumberOfPoints(), 16);

  // Without a change, nothing runs again, neither after an error nor after an empty result.
  for (const bool isBad : { false, true })
  {
    run->SetUseInputBounds(true);
    run->SetSizeMode(isBad ? Image::SIZE_BY_SPACING : Image::SIZE_BY_DIMENSIONS);
    run->SetSpacing(isBad ? 0.0 : 1.0, 1.0);
    run->SetInputDataObject(makePoints({}));
    run.Errors->Clear();
    for (int i = 0; i < 3; ++i)
    {
      run->Update();
    }
    FF_CHECK_EQUAL(run.Errors->Messages.size(), isBad ? 1u : 0u);
    FF_CHECK(isEmpty(run->GetOutput()));
  }
}

void testErrors()
{
  constexpr unsigned long setting = vtkFFErrorCode::SettingError;
  Imaging run(makePoints(randomPoints(50, 816)));
  for (const auto& size : { std::array<int, 2>{ 0, 5 }, { 5, -3 }, { INT_MIN, 1 } })
  {
    run->SetDimensions(size.data());
    run.Fail(setting, "; each must be 1 or more.");
  }
  run->SetDimensions(INT_MAX, INT_MAX);
  run.Fail(vtkFFErrorCode::MemoryError, "There is not enough memory for this input: ");
  run->SetSizeMode(Image::SIZE_BY_SPACING);
  for (const double bad : { 0.0, -1.0, notANumber, infinity })
  {
    run->SetSpacing(1.0, bad);
    run.Fail(setting, "; it must be above 0 and finite.");
  }
  run->SetSpacing(1.0, 1e-12);
  run.Fail(setting, " makes too many pixels of a length of ");
  run->SetSpacing(1e-300, 1e-300);
  run.Fail(setting, " makes too many pixels of a length of ");
  run->SetSizeMode(Image::SIZE_BY_DIMENSIONS);
  run->SetDimensions(3, 3);
  run->SetUseInputBounds(false);
  for (const auto& box : { std::array<double, 4>{ 1, 1, 0, 1 }, { 0, infinity, 0, 1 },
         { 0, 1, notANumber, 1 }, { 0, 1, 2, -2 } })
  {
    run->SetSamplingBounds(box.data());
    run.Fail(setting,
      "The image's box has no inside or is not finite: it is (xmin, xmax, ymin, ymax) = (");
  }
  run->SetSamplingBounds(-1e308, 1e308, 0, 1);
  run.Fail(setting, "A length of inf cannot be divided into 3 pixels.");
  run->SetSamplingBounds(0, 5e-324, 0, 1);
  run.Fail(setting, "cannot be divided into 3 pixels.");
  run->SetUseInputBounds(true);
  run.Run();

  auto points = cubeCorners();
  points[5][1] = notANumber;
  run->SetInputDataObject(makePoints(points));
  run.Fail(vtkFFErrorCode::NonFiniteError, "NaN or infinite: first at point 5, 1 such point(s)");
  run->SetNonFinitePoints(vtkFFAlgorithm::NON_FINITE_IGNORE);
  FF_CHECK_EQUAL(run.Values("Elevation").size(), 9u);
  FF_CHECK_EQUAL(run->GetNumberOfNonFinitePoints(), 1);
  FF_CHECK_EQUAL(reported(run->GetOutput(), "NonFinite"), 1.0);
}

}

int TestFFPointsToImage(int, char*[])
{
  testAgainstPoints();
  testAgainstEngine();
  testSizes();
  testSmall();
  testPlanes();
  testBreaklines();
  testExtents();
  testErrors();
  return result();
}
