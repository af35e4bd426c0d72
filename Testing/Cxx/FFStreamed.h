// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What vtkFFStreamedWriter wrote, joined and compared with what a filter gives.
#ifndef FFStreamed_h
#define FFStreamed_h

#include "FFPieceSource.h"
#include "FFTest.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFFAlgorithm.h"
#include "vtkFFHullFilter.h"
#include "vtkFFPlanarAlgorithm.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkFFStreamedWriter.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkXMLPartitionedDataSetReader.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace fftest
{

/// A folder of the test's own, which is removed in the end.
class TestFolder
{
public:
  explicit TestFolder(const std::string& name)
    : Path(std::filesystem::temp_directory_path() /
        ("flipflop " + name + " & " + std::to_string(reinterpret_cast<std::uintptr_t>(this))))
  {
    std::filesystem::remove_all(this->Path);
    std::filesystem::create_directories(this->Path);
  }
  ~TestFolder() { std::filesystem::remove_all(this->Path); }

  std::string File(const std::string& name) const { return (this->Path / name).string(); }

  /// All that is in it, by names from here on, but what is in folders of names that end with .work.
  std::vector<std::string> List() const
  {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(this->Path))
    {
      const std::string name = std::filesystem::relative(entry.path(), this->Path).generic_string();
      if (name.find(".work/") == std::string::npos)
      {
        names.push_back(name);
      }
    }
    std::sort(names.begin(), names.end());
    return names;
  }

  const std::filesystem::path Path;
};

/// The blocks of a file, as VTK reads them.
inline std::vector<vtkSmartPointer<vtkPolyData>> readBlocks(const std::string& file)
{
  vtkNew<vtkXMLPartitionedDataSetReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  std::vector<vtkSmartPointer<vtkPolyData>> blocks;
  auto* const set = vtkPartitionedDataSet::SafeDownCast(reader->GetOutputDataObject(0));
  for (unsigned int i = 0; set && i < set->GetNumberOfPartitions(); ++i)
  {
    blocks.emplace_back(vtkPolyData::SafeDownCast(set->GetPartitionAsDataObject(i)));
    FF_CHECK(blocks.back());
  }
  return blocks;
}

/// The blocks as one poly data in the filters' form: points by ascending original ids, which they
/// may share, and all cells in order.
inline vtkSmartPointer<vtkPolyData> joinBlocks(
  const std::vector<vtkSmartPointer<vtkPolyData>>& blocks)
{
  std::map<vtkIdType, std::pair<vtkPolyData*, vtkIdType>> points;
  std::vector<std::vector<vtkIdType>> cells[3];
  const auto cellsOf = [](vtkPolyData* data, int kind) {
    return kind == 0 ? data->GetVerts() : kind == 1 ? data->GetLines() : data->GetPolys();
  };
  for (const auto& block : blocks)
  {
    const auto ids = originalIds(block);
    FF_CHECK_EQUAL(static_cast<vtkIdType>(ids.size()), block->GetNumberOfPoints());
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      points[ids[i]] = { block, static_cast<vtkIdType>(i) };
    }
    for (int kind = 0; kind < 3; ++kind)
    {
      const auto own = cellsByOriginalIds(block, cellsOf(block, kind));
      cells[kind].insert(cells[kind].end(), own.begin(), own.end());
    }
  }
  auto whole = vtkSmartPointer<vtkPolyData>::New();
  vtkPolyData* const like = points.empty() ? blocks.at(0).Get() : points.begin()->second.first;
  vtkNew<vtkPoints> positions;
  positions->SetDataType(like->GetPoints()->GetDataType());
  vtkPointData* const data = whole->GetPointData();
  data->CopyAllOn();
  data->CopyAllocate(like->GetPointData());
  std::map<vtkIdType, vtkIdType> indices;
  for (const auto& [id, place] : points)
  {
    const auto index = static_cast<vtkIdType>(indices.size());
    indices[id] = index;
    positions->GetData()->InsertNextTuple(place.second, place.first->GetPoints()->GetData());
    data->CopyData(place.first->GetPointData(), place.second, index);
  }
  whole->SetPoints(positions);
  for (int kind = 0; kind < 3; ++kind)
  {
    std::sort(cells[kind].begin(), cells[kind].end());
    vtkNew<vtkCellArray> to;
    for (const auto& cell : cells[kind])
    {
      to->InsertNextCell(static_cast<int>(cell.size()));
      for (const vtkIdType id : cell)
      {
        to->InsertCellPoint(indices.at(id));
      }
    }
    kind == 0 ? whole->SetVerts(to) : kind == 1 ? whole->SetLines(to) : whole->SetPolys(to);
  }
  return whole;
}

/// Whether the file's blocks, joined, are this output of a filter, bit for bit, but for arrays of
/// strings.
inline bool isWrittenLike(
  const std::string& file, vtkPolyData* output, const std::string& what, std::size_t blocks = 0)
{
  vtkNew<vtkPolyData> expected;
  expected->ShallowCopy(output);
  expected->SetFieldData(vtkNew<vtkFieldData>());
  expected->GetPointData()->RemoveArray("names");
  const auto parts = readBlocks(file);
  if (parts.empty() || parts.size() < blocks)
  {
    std::cerr << what << ": " << parts.size() << " blocks\n";
    return false;
  }
  const auto joined = joinBlocks(parts);
  joined->SetFieldData(vtkNew<vtkFieldData>());
  return isIdentical(joined, expected, what);
}

/// Points that no plane holds, some of them twice, some of them in one circle.
inline std::vector<Point> mixedPoints(int count, unsigned int seed)
{
  auto points = randomPoints(count, seed);
  for (std::size_t i = 0; i + 12 < points.size(); i += 12)
  {
    points[i + 1] = points[i];
    for (std::size_t k = 2; k < 6; ++k)
    {
      points[i + k] = { std::floor(8 * points[i + k][0]) / 8, std::floor(8 * points[i + k][1]) / 8,
        points[i + k][2] };
    }
  }
  return points;
}

inline vtkSmartPointer<vtkPolyData> makeInput(int count, unsigned int seed, int type = VTK_DOUBLE)
{
  auto data = makeDecorated(mixedPoints(count, seed), type);
  vtkNew<vtkDoubleArray> weights;
  weights->SetName("weights");
  for (const Point& point : randomPoints(count, seed + 1))
  {
    weights->InsertNextValue(0.01 * point[0]);
  }
  data->GetPointData()->AddArray(weights);
  return data;
}

/// A writer and the filter that it equals.
struct StreamCase
{
  std::string Name;
  bool IsHull;
  bool IsWeighted;
  int FacetMode;
};

inline const std::vector<StreamCase> streamCases = { { "delaunay", false, false, 0 },
  { "delaunay polygons", false, false, 1 }, { "regular", false, true, 0 },
  { "regular polygons", false, true, 1 }, { "hull", true, false, 0 },
  { "hull polygons", true, false, 1 } };

inline vtkSmartPointer<vtkFFAlgorithm> makeFilterOf(const StreamCase& ofCase)
{
  vtkSmartPointer<vtkFFAlgorithm> filter;
  if (ofCase.IsHull)
  {
    filter = vtkSmartPointer<vtkFFHullFilter>::New();
  }
  else
  {
    filter = vtkSmartPointer<vtkFFRegularTriangulationFilter>::New();
  }
  filter->SetFacetMode(ofCase.FacetMode);
  if (ofCase.IsWeighted)
  {
    useWeights(filter);
  }
  return filter;
}

/// A source in pieces, a writer, and a folder for its file.
struct WriterStream
{
  explicit WriterStream(const StreamCase& ofCase)
    : Folder(ofCase.Name)
    , Filter(makeFilterOf(ofCase))
    , File(Folder.File("a <b>.vtpd"))
  {
    this->Writer->SetInputConnection(this->Source->GetOutputPort());
    this->Writer->SetShape(
      ofCase.IsHull ? vtkFFStreamedWriter::HULL : vtkFFStreamedWriter::TRIANGULATION);
    this->Writer->SetFacetMode(ofCase.FacetMode);
    this->Writer->SetFileName(this->File.c_str());
    if (ofCase.IsWeighted)
    {
      useWeights(this->Writer);
    }
  }

  /// Writes, and compares with what the filter makes of the whole.
  bool Run(vtkDataObject* whole, const std::string& what, std::size_t blocks = 0)
  {
    this->Filter->SetInputDataObject(whole);
    this->Filter->Update();
    const auto errors = ErrorObserver::Of(this->Writer);
    FF_CHECK_EQUAL(this->Writer->Write(), 1);
    for (const std::string& message : errors->Messages)
    {
      const bool isExpected =
        message.find("Point data \"names\" without numbers or a name is left out.") !=
        std::string::npos;
      FF_CHECK(isExpected);
      std::cerr << (isExpected ? "" : message);
    }
    FF_CHECK_EQUAL(this->Writer->GetErrorCode(), 0ul);
    FF_CHECK_EQUAL(this->Writer->GetDimension(), this->Filter->GetDimension());
    FF_CHECK_EQUAL(this->Writer->GetNumberOfInputPoints(), this->Filter->GetNumberOfInputPoints());
    FF_CHECK_EQUAL(
      this->Writer->GetNumberOfNonFinitePoints(), this->Filter->GetNumberOfNonFinitePoints());
    auto* const triangulation = vtkFFRegularTriangulationFilter::SafeDownCast(this->Filter);
    FF_CHECK_EQUAL(this->Writer->GetNumberOfCells(),
      this->Filter->GetOutput()->GetNumberOfCells() +
        (triangulation ? triangulation->GetNumberOfDroppedCells() : 0));
    if (auto* hull = vtkFFHullFilter::SafeDownCast(this->Filter))
    {
      FF_CHECK_EQUAL(this->Writer->GetVolume(), hull->GetVolume());
      FF_CHECK_EQUAL(this->Writer->GetArea(), hull->GetArea());
    }
    else
    {
      FF_CHECK_EQUAL(this->Writer->GetNumberOfHiddenPoints(),
        vtkFFPlanarAlgorithm::SafeDownCast(this->Filter)->GetNumberOfHiddenPoints());
    }
    const auto names = this->Folder.List();
    FF_CHECK_EQUAL(names.size(), static_cast<std::size_t>(this->Writer->GetNumberOfBlocks()) + 2);
    return isWrittenLike(this->File, this->Filter->GetOutput(), what, blocks);
  }

  TestFolder Folder;
  vtkNew<PieceSource> Source;
  vtkNew<vtkFFStreamedWriter> Writer;
  vtkSmartPointer<vtkFFAlgorithm> Filter;
  const std::string File;
};

}

#endif
