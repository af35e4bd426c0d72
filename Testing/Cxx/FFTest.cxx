// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFTest.h"

#include "vtkFFRegularTriangulationFilter.h"

#include <flipflop/ConvexHull.h>
#include <flipflop/RegularTriangulation.h>

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkFFErrorCode.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <map>
#include <random>
#include <set>

namespace fftest
{

//------------------------------------------------------------------------------
int& failures()
{
  static int count = 0;
  return count;
}

//------------------------------------------------------------------------------
int result()
{
  if (failures() > 0)
  {
    std::cerr << failures() << " check(s) failed\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

//------------------------------------------------------------------------------
vtkSmartPointer<ErrorObserver> ErrorObserver::Of(vtkObject* object)
{
  vtkSmartPointer<ErrorObserver> observer;
  observer.TakeReference(ErrorObserver::New());
  object->AddObserver(vtkCommand::ErrorEvent, observer);
  object->AddObserver(vtkCommand::WarningEvent, observer);
  if (auto* algorithm = vtkAlgorithm::SafeDownCast(object))
  {
    algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  }
  return observer;
}

//------------------------------------------------------------------------------
void ErrorObserver::Execute(vtkObject*, unsigned long, void* data)
{
  this->Messages.emplace_back(static_cast<const char*>(data));
}

//------------------------------------------------------------------------------
bool ErrorObserver::Has(const std::string& part) const
{
  for (const std::string& message : this->Messages)
  {
    if (message.find(part) != std::string::npos)
    {
      return true;
    }
  }
  std::cerr << "no message with \"" << part << "\" among " << this->Messages.size() << ":\n";
  for (const std::string& message : this->Messages)
  {
    std::cerr << "  " << message << "\n";
  }
  return false;
}

namespace
{

/// The messages of one update.
vtkSmartPointer<ErrorObserver> update(vtkAlgorithm* filter)
{
  auto errors = ErrorObserver::Of(filter);
  filter->Update();
  filter->RemoveObserver(errors);
  filter->GetExecutive()->RemoveObserver(errors);
  return errors;
}

}

//------------------------------------------------------------------------------
bool succeeds(vtkAlgorithm* filter)
{
  const auto errors = update(filter);
  for (const std::string& message : errors->Messages)
  {
    std::cerr << message;
  }
  return errors->Messages.empty() && filter->GetErrorCode() == vtkFFErrorCode::NoError;
}

//------------------------------------------------------------------------------
bool failsInPart(vtkAlgorithm* filter, unsigned long code, const std::vector<std::string>& parts)
{
  const auto errors = update(filter);
  bool good = true;
  for (const std::string& part : parts)
  {
    good = errors->Has(part) && good;
  }
  if (errors->Messages.size() != 1)
  {
    std::cerr << errors->Messages.size() << " messages, not one\n";
    good = false;
  }
  if (filter->GetErrorCode() != code)
  {
    std::cerr << "the error code is " << filter->GetErrorCode() << ", not " << code << "\n";
    good = false;
  }
  return good;
}

//------------------------------------------------------------------------------
bool fails(vtkFFAlgorithm* filter, unsigned long code, const std::vector<std::string>& parts)
{
  const bool good = failsInPart(filter, code, parts);
  return hasForgotten(filter) && good;
}

//------------------------------------------------------------------------------
void ProgressObserver::Execute(vtkObject* caller, unsigned long, void* data)
{
  this->Values.push_back(*static_cast<double*>(data));
  const char* text = vtkAlgorithm::SafeDownCast(caller)->GetProgressText();
  if (text && (this->Texts.empty() || this->Texts.back() != text))
  {
    this->Texts.emplace_back(text);
  }
  if (this->Values.back() >= this->AbortAt)
  {
    vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1);
  }
}

//------------------------------------------------------------------------------
bool ProgressObserver::StoppedOnTheWay() const
{
  auto own = this->Values.size();
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  // The executive's last word is 1, after an abort, too.
  own -= own > 0 ? 1 : 0;
#endif
  return own > 0 && this->Values[own - 1] < 1.0;
}

//------------------------------------------------------------------------------
void checkProgress(const std::vector<double>& values)
{
  FF_CHECK(values.size() >= 4);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    FF_CHECK(values[i] >= 0.0 && values[i] <= 1.0);
    FF_CHECK(i == 0 || values[i] >= values[i - 1] - 1e-12); // the executive rounds sums
  }
  FF_CHECK(!values.empty() && values.back() == 1.0);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> makePoints(vtkDataArray* array)
{
  vtkNew<vtkPoints> points;
  points->SetData(array);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  return data;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> makePoints(const std::vector<Point>& points, int type)
{
  vtkSmartPointer<vtkDataArray> array;
  array.TakeReference(vtkDataArray::CreateDataArray(type));
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    array->SetTuple(static_cast<vtkIdType>(i), points[i].data());
  }
  return makePoints(array);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> makeSurface(
  const std::vector<Point>& points, const std::vector<std::vector<vtkIdType>>& polygons, int type)
{
  auto data = makePoints(points, type);
  vtkNew<vtkCellArray> cells;
  for (const auto& polygon : polygons)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(polygon.size()), polygon.data());
  }
  data->SetPolys(cells);
  return data;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> makeVoxels(const std::vector<std::array<int, 3>>& cubes)
{
  const std::set<std::array<int, 3>> solid(cubes.begin(), cubes.end());
  std::map<std::array<int, 3>, vtkIdType> ids;
  std::vector<Point> points;
  std::vector<std::vector<vtkIdType>> triangles;
  for (const auto& cube : solid)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      for (int side = 0; side < 2; ++side)
      {
        auto neighbour = cube;
        neighbour[axis] += 2 * side - 1;
        if (solid.count(neighbour))
        {
          continue;
        }
        // Counter-clockwise as seen from the axis's positive end.
        const int square[4][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
        std::array<vtkIdType, 4> corners{};
        for (std::size_t k = 0; k < 4; ++k)
        {
          auto corner = cube;
          corner[axis] += side;
          corner[(axis + 1) % 3] += square[k][0];
          corner[(axis + 2) % 3] += square[k][1];
          const auto found = ids.emplace(corner, static_cast<vtkIdType>(points.size()));
          if (found.second)
          {
            points.push_back({ double(corner[0]), double(corner[1]), double(corner[2]) });
          }
          corners[side ? k : 3 - k] = found.first->second;
        }
        triangles.push_back({ corners[0], corners[1], corners[2] });
        triangles.push_back({ corners[0], corners[2], corners[3] });
      }
    }
  }
  return makeSurface(points, triangles);
}

//------------------------------------------------------------------------------
std::vector<Point> randomPoints(int count, unsigned int seed)
{
  // The generator is fixed by the standard; the library's distributions are not.
  std::mt19937_64 generator(seed);
  const auto next = [&]() { return static_cast<double>(generator() >> 11) * 0x1p-52 - 1.0; };
  std::vector<Point> points(static_cast<std::size_t>(count));
  for (Point& point : points)
  {
    for (double& x : point)
    {
      x = next();
    }
  }
  return points;
}

//------------------------------------------------------------------------------
std::vector<Point> spherePoints(int count, unsigned int seed)
{
  auto points = randomPoints(count, seed);
  for (Point& p : points)
  {
    const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    p = { p[0] / length, p[1] / length, p[2] / length };
  }
  return points;
}

//------------------------------------------------------------------------------
std::vector<Point> cubeCorners()
{
  std::vector<Point> corners;
  for (int i = 0; i < 8; ++i)
  {
    corners.push_back({ double(i & 1), double(i >> 1 & 1), double(i >> 2 & 1) });
  }
  return corners;
}

//------------------------------------------------------------------------------
std::vector<vtkIdType> originalIds(vtkPolyData* output)
{
  auto* ids =
    vtkIdTypeArray::SafeDownCast(output->GetPointData()->GetAbstractArray("vtkOriginalPointIds"));
  if (!ids || ids->GetNumberOfComponents() != 1 ||
    ids->GetNumberOfTuples() != output->GetNumberOfPoints())
  {
    std::cerr << "vtkOriginalPointIds is missing or of the wrong size\n";
    ++failures();
    return {};
  }
  return std::vector<vtkIdType>(ids->GetPointer(0), ids->GetPointer(0) + ids->GetNumberOfTuples());
}

//------------------------------------------------------------------------------
std::vector<std::vector<vtkIdType>> cellsByOriginalIds(vtkPolyData* output, vtkCellArray* cells)
{
  const auto ids = originalIds(output);
  std::vector<std::vector<vtkIdType>> all;
  vtkNew<vtkIdList> corners;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    cells->GetCellAtId(i, corners);
    all.emplace_back();
    for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
    {
      all.back().push_back(ids.at(static_cast<std::size_t>(corners->GetId(k))));
    }
  }
  return all;
}

namespace
{

/// The coordinates as doubles, which is exact for every type in these tests.
vtkSmartPointer<vtkDoubleArray> doubles(vtkPointSet* data)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  if (data->GetPoints())
  {
    array->DeepCopy(data->GetPoints()->GetData());
  }
  return array;
}

/// Whether the output's ids and cells are the engine's, in its order.
bool areOf(const flipflop::CellComplex& expected, vtkPolyData* output)
{
  const auto ids = originalIds(output);
  bool same =
    std::equal(ids.begin(), ids.end(), expected.pointIds.begin(), expected.pointIds.end());
  std::int64_t cell = 0;
  for (vtkCellArray* cells : { output->GetVerts(), output->GetLines(), output->GetPolys() })
  {
    for (vtkIdType i = 0; same && i < cells->GetNumberOfCells(); ++i, ++cell)
    {
      vtkIdType size = 0;
      const vtkIdType* corners = nullptr;
      cells->GetCellAtId(i, size, corners);
      same = cell < expected.cellCount() &&
        std::equal(corners, corners + size,
          expected.connectivity.begin() + expected.cellBegin(cell),
          expected.connectivity.begin() + expected.cellBegin(cell + 1));
    }
  }
  return same && cell == expected.cellCount();
}

/// Either kind of facets.
template <class Make>
bool areOfEngine(const Make& make, vtkPolyData* output)
{
  flipflop::Options options;
  options.nonFinite = flipflop::NonFinitePolicy::Ignore;
  const bool triangles = areOf(make(options), output);
  options.facets = flipflop::FacetMode::Polygons;
  if (triangles || areOf(make(options), output))
  {
    return true;
  }
  std::cerr << "other points or cells than the engine's\n";
  return false;
}

/// Whether the output's points are those of the input that its ids name, in type and bits, and
/// whether it has cells of the dimension alone.
bool hasPointsOf(vtkPointSet* input, vtkPolyData* output, int dimension)
{
  const auto from = doubles(input);
  const auto to = doubles(output);
  const auto ids = originalIds(output);
  if (!output->GetPoints())
  {
    std::cerr << "the output has no points\n";
    return false;
  }
  if (output->GetPoints()->GetDataType() != input->GetPoints()->GetDataType())
  {
    std::cerr << "the output's points are of another type\n";
    return false;
  }
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    if (std::memcmp(to->GetPointer(3 * static_cast<vtkIdType>(i)), from->GetPointer(3 * ids[i]),
          3 * sizeof(double)) != 0)
    {
      std::cerr << "point " << i << " of the output is not point " << ids[i] << " of the input\n";
      return false;
    }
  }
  const vtkIdType others = dimension == 0 ? output->GetNumberOfVerts()
    : dimension == 1                      ? output->GetNumberOfLines()
                                          : output->GetNumberOfPolys();
  if (output->GetNumberOfCells() != others)
  {
    std::cerr << "the output has cells of another kind than its dimension asks for\n";
    return false;
  }
  return true;
}

}

//------------------------------------------------------------------------------
bool isHullOf(vtkPointSet* input, vtkPolyData* output, int dimension)
{
  if (!hasPointsOf(input, output, dimension))
  {
    return false;
  }
  const auto points = doubles(input);
  const flipflop::PointView view(points->GetPointer(0), points->GetNumberOfTuples());
  return areOfEngine(
    [&](const flipflop::Options& options) { return flipflop::convexHull(view, options); }, output);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> makeWeighted(
  const std::vector<Point>& points, const std::vector<double>& weights, int type, const char* name)
{
  vtkSmartPointer<vtkDataArray> array;
  array.TakeReference(vtkDataArray::CreateDataArray(type));
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(weights.size()));
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    array->SetTuple1(static_cast<vtkIdType>(i), weights[i]);
  }
  auto data = makePoints(points);
  data->GetPointData()->AddArray(array);
  return data;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> randomWeighted(int count, unsigned int seed, int type)
{
  std::vector<double> weights;
  for (int i = 0; i < count; ++i)
  {
    weights.push_back(0.01 * (i % 5));
  }
  return makeWeighted(randomPoints(count, seed), weights, type);
}

//------------------------------------------------------------------------------
void markPoints(vtkDataSet* data, const std::vector<int>& marks, bool again)
{
  const std::size_t count =
    again ? static_cast<std::size_t>(data->GetNumberOfPoints()) : marks.size();
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  for (std::size_t i = 0; i < count; ++i)
  {
    ghosts->InsertNextValue(static_cast<unsigned char>(marks[i % marks.size()]));
  }
  data->GetPointData()->AddArray(ghosts);
}

//------------------------------------------------------------------------------
void useWeights(vtkAlgorithm* filter, const char* name)
{
  filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name);
}

//------------------------------------------------------------------------------
bool isTriangulationOf(
  vtkPointSet* input, const char* weights, vtkFFRegularTriangulationFilter* filter, int dimension)
{
  vtkPolyData* output = filter->GetOutput();
  vtkPolyData* hidden = filter->GetOutput(1);
  if (filter->GetDimension() != dimension)
  {
    std::cerr << "the dimension is " << filter->GetDimension() << "\n";
    return false;
  }
  if (!hasPointsOf(input, output, dimension) || !hasPointsOf(input, hidden, 0))
  {
    return false;
  }
  if (hidden->GetNumberOfVerts() != hidden->GetNumberOfPoints() ||
    filter->GetNumberOfHiddenPoints() != hidden->GetNumberOfPoints())
  {
    std::cerr << "hidden points are not a vertex cell each\n";
    return false;
  }
  const auto points = doubles(input);
  for (vtkIdType i = 0; i < points->GetNumberOfTuples(); ++i)
  {
    if (!std::isfinite(points->GetComponent(i, 2))) // left out by the filter, not by the engine
    {
      points->SetComponent(i, 0, std::nan(""));
    }
  }
  vtkNew<vtkDoubleArray> values;
  flipflop::WeightView weightView;
  if (weights)
  {
    values->DeepCopy(input->GetPointData()->GetArray(weights));
    weightView = flipflop::WeightView(values->GetPointer(0), values->GetNumberOfTuples());
  }
  const flipflop::PointView view(points->GetPointer(0), points->GetNumberOfTuples());
  const auto ids = originalIds(hidden);
  return areOfEngine(
    [&](const flipflop::Options& options)
    {
      auto triangulation = flipflop::regularTriangulation(view, weightView, options);
      const auto& expected = triangulation.hiddenIds;
      FF_CHECK(std::equal(ids.begin(), ids.end(), expected.begin(), expected.end()));
      return triangulation;
    },
    output);
}

}
