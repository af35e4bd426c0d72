// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the tests of the filters that work in a plane share.
#ifndef FFPlanar_h
#define FFPlanar_h

#include "FFTest.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFFErrorCode.h"
#include "vtkFFPlanarAlgorithm.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <limits>
#include <string>
#include <vector>

namespace fftest
{

using Ids = std::vector<vtkIdType>;
using Cells = std::vector<Ids>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

/// A filter with its input and its messages.
template <class FilterT>
class Watched
{
public:
  explicit Watched(vtkDataObject* input, const char* weights = nullptr)
    : Errors(ErrorObserver::Of(this->Filter))
  {
    if (weights)
    {
      useWeights(this->Filter, weights);
    }
    this->Filter->SetInputDataObject(input);
  }

  FilterT* operator->() { return this->Filter; }
  FilterT* Get() { return this->Filter; }

  /// An output after a run without a message.
  vtkPolyData* Run(int port = 0)
  {
    this->Errors->Clear();
    this->Filter->Update();
    FF_CHECK(this->Errors->Messages.empty() || !this->Errors->Has("no message at all"));
    FF_CHECK_EQUAL(this->Filter->GetErrorCode(), vtkFFErrorCode::NoError);
    return vtkPolyData::SafeDownCast(this->Filter->GetOutputDataObject(port));
  }

  /// A run with this input, and no message.
  vtkPolyData* RunWith(vtkDataObject* input)
  {
    this->Filter->SetInputDataObject(input);
    return this->Run();
  }

  /// A run that ends in one error with these words and that code, without an output.
  void Fail(const std::string& words, unsigned long code)
  {
    this->Errors->Clear();
    this->Filter->Modified();
    FF_CHECK(fails(this->Filter, code, { words }));
  }

  vtkNew<FilterT> Filter;
  vtkSmartPointer<ErrorObserver> Errors;
};

/// The cells of one kind, each as its corners' ids in the output.
inline Cells cellsOf(vtkCellArray* cells)
{
  Cells all;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    cells->GetCellAtId(i, size, corners);
    all.emplace_back(corners, corners + size);
  }
  return all;
}

inline Cells polysOf(vtkPolyData* output)
{
  return cellsByOriginalIds(output, output->GetPolys());
}

/// A copy, which a further run does not change.
inline vtkSmartPointer<vtkPolyData> copyOf(vtkPolyData* output)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->DeepCopy(output);
  return copy;
}

/// A vtkCellArray of these cells.
inline vtkSmartPointer<vtkCellArray> makeCells(const Cells& from)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (const Ids& ids : from)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }
  return cells;
}

/// Lines and polygons of the points of another data set.
inline vtkSmartPointer<vtkPolyData> makeConstraints(
  const Cells& lines, const Cells& polygons = {}, vtkPoints* points = nullptr)
{
  auto source = vtkSmartPointer<vtkPolyData>::New();
  source->SetPoints(points);
  source->SetLines(makeCells(lines));
  source->SetPolys(makeCells(polygons));
  return source;
}

/// Marks these points as another piece's.
inline void addGhosts(vtkDataSet* data, const Ids& ghosts)
{
  std::vector<int> marks(static_cast<std::size_t>(data->GetNumberOfPoints()), 0);
  for (const vtkIdType id : ghosts)
  {
    marks[static_cast<std::size_t>(id)] = vtkDataSetAttributes::DUPLICATEPOINT;
  }
  markPoints(data, marks);
}

/// Points at integer positions, in rows, with z = @p z.
inline std::vector<Point> gridOf(int columns, int rows, double z = 0.0)
{
  std::vector<Point> points;
  for (int i = 0; i < columns * rows; ++i)
  {
    points.push_back({ double(i % columns), double(i / columns), z });
  }
  return points;
}

}

#endif
