// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// What the streamed writer writes is what the filters give, bit for bit, with all point data,
// whatever the pieces, the blocks and the threads.
#include "FFStreamed.h"

#include "vtkBitArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFFAlgorithm.h"
#include "vtkFFPlanarAlgorithm.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkRTAnalyticSource.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkVariant.h"

#include <cmath>
#include <limits>
#include <sstream>

using namespace fftest;

namespace
{

const double nan = std::numeric_limits<double>::quiet_NaN();

/// All shapes, in pieces, blocks and threads; one file is written over and over.
void testShapes()
{
  unsigned int seed = 700;
  for (const StreamCase& each : streamCases)
  {
    WriterStream stream(each);
    for (const int type : { VTK_DOUBLE, VTK_FLOAT })
    {
      const auto whole = makeInput(2000, ++seed, type);
      stream.Source->SetWhole(whole);
      for (const int pieces : { 1, 7 })
      {
        for (const vtkIdType blockPoints : { 0, 150 })
        {
          stream.Writer->SetNumberOfPieces(pieces);
          stream.Writer->SetPointsPerBlock(blockPoints);
          stream.Writer->SetNumberOfThreads(pieces > 1 ? 3 : 1);
          stream.Source->Asked.clear();
          const std::string what = each.Name + " in " + std::to_string(pieces) + " pieces, seed " +
            std::to_string(seed) + ", blocks of " + std::to_string(blockPoints);
          FF_CHECK(stream.Run(whole, what, blockPoints > 0 ? 10 : 1));
          // One piece alone may be there from before.
          FF_CHECK(stream.Source->Asked.size() == static_cast<std::size_t>(pieces) ||
            (pieces == 1 && stream.Source->Asked.empty()));
        }
      }
    }
  }
}

/// A writer and the filter of one case, by its name.
WriterStream makeStream(const std::string& name)
{
  return WriterStream(*std::find_if(streamCases.begin(), streamCases.end(),
    [&](const StreamCase& each) { return each.Name == name; }));
}

/// Points that span less than the shape.
void testDimensions()
{
  const std::vector<std::vector<Point>> inputs = { {}, { { 1, 2, 3 } },
    { { 1, 2, 3 }, { 1, 2, 3 } }, { { 0, 0, 0 }, { 2, 2, 2 }, { 1, 1, 1 }, { 3, 3, 3 } },
    { { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } } };
  for (const StreamCase& each : streamCases)
  {
    WriterStream stream(each);
    for (const auto& points : inputs)
    {
      auto data = makePoints(points);
      if (each.IsWeighted)
      {
        data = makeWeighted(points, std::vector<double>(points.size(), 0.5));
      }
      stream.Source->SetWhole(data);
      stream.Writer->SetNumberOfPieces(3);
      stream.Writer->SetPointsPerBlock(2);
      FF_CHECK(stream.Run(data, each.Name + " of " + std::to_string(points.size()) + " points"));
    }
  }
}

/// Arrays of all types that VTK's files distinguish, of several components with names, of bits, of
/// other layouts; attributes; none of it, if it is not to be passed.
void testPointData()
{
  for (const char* name : { "delaunay", "hull" })
  {
    auto stream = makeStream(name);
    auto data = makeInput(400, 731, VTK_FLOAT);
    const vtkIdType count = data->GetNumberOfPoints();
    for (const int type : { VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT,
           VTK_INT, VTK_UNSIGNED_INT, VTK_FLOAT, VTK_DOUBLE, VTK_ID_TYPE })
    {
      vtkSmartPointer<vtkDataArray> array;
      array.TakeReference(vtkDataArray::CreateDataArray(type));
      array->SetName((std::string("type ") + std::to_string(type)).c_str());
      array->SetNumberOfComponents(type % 3 + 1);
      array->SetComponentName(0, "first");
      array->SetNumberOfTuples(count);
      for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
      {
        array->SetVariantValue(i, vtkVariant(static_cast<int>(i % 120)));
      }
      data->GetPointData()->AddArray(array);
    }
    vtkNew<vtkSOADataArrayTemplate<vtkTypeInt64>> apart;
    apart->SetName("apart");
    apart->SetNumberOfComponents(2);
    apart->SetNumberOfTuples(count);
    for (vtkIdType i = 0; i < count; ++i)
    {
      const vtkTypeInt64 tuple[2] = { (vtkTypeInt64(1) << 60) + 1 + i, -i };
      apart->SetTypedTuple(i, tuple);
    }
    data->GetPointData()->AddArray(apart);
    data->GetPointData()->SetActiveScalars("type 9");
    stream.Source->SetWhole(data);
    stream.Writer->SetNumberOfPieces(4);
    stream.Writer->SetPointsPerBlock(100);
    FF_CHECK(stream.Run(data, std::string(name) + " with arrays"));

    stream.Filter->SetPassPointData(false);
    stream.Writer->SetPassPointData(false);
    FF_CHECK(stream.Run(data, std::string(name) + " without arrays"));
  }
}

/// Bits are written as bits.
void testBits()
{
  auto stream = makeStream("delaunay");
  auto data = makePoints(randomPoints(100, 735));
  vtkNew<vtkBitArray> bits;
  bits->SetName("bits");
  bits->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < 300; ++i)
  {
    bits->InsertNextValue(i % 7 == 0 || i % 5 == 0);
  }
  data->GetPointData()->AddArray(bits);
  stream.Source->SetWhole(data);
  stream.Writer->SetNumberOfPieces(3);
  FF_CHECK(stream.Run(data, "bits"));
}

void testWeights()
{
  auto stream = makeStream("regular");
  auto data = makeInput(500, 741);
  auto* weights = data->GetPointData()->GetArray("weights");
  for (vtkIdType i = 0; i < weights->GetNumberOfTuples(); ++i)
  {
    weights->SetComponent(i, 0, std::abs(weights->GetComponent(i, 0)));
  }
  stream.Source->SetWhole(data);
  stream.Writer->SetNumberOfPieces(2);
  stream.Writer->SetPointsPerBlock(100);
  auto* filter = vtkFFPlanarAlgorithm::SafeDownCast(stream.Filter);
  filter->SetWeightMode(vtkFFPlanarAlgorithm::RADII);
  filter->SetWeightFactor(3.7);
  stream.Writer->SetWeightMode(vtkFFPlanarAlgorithm::RADII);
  stream.Writer->SetWeightFactor(3.7);
  FF_CHECK(stream.Run(data, "radii"));
}

/// Cells with a long edge are left out, of a hull none; all points stay.
void testEdgeLength()
{
  for (const StreamCase& each : streamCases)
  {
    WriterStream stream(each);
    const auto data = makeInput(600, 745);
    stream.Source->SetWhole(data);
    stream.Writer->SetNumberOfPieces(2);
    stream.Writer->SetPointsPerBlock(100);
    stream.Writer->SetMaximumEdgeLength(0.125);
    auto* const filter = vtkFFRegularTriangulationFilter::SafeDownCast(stream.Filter);
    if (filter)
    {
      filter->SetMaximumEdgeLength(0.125);
    }
    FF_CHECK(stream.Run(data, each.Name + " without long edges"));
    FF_CHECK(!filter || filter->GetNumberOfDroppedCells() > 100);
    FF_CHECK(!filter || filter->GetOutput()->GetNumberOfCells() > 100);
  }
}

/// Points that are not finite, z among them, are left out, and keep their places.
void testNonFinite()
{
  for (const StreamCase& each : streamCases)
  {
    WriterStream stream(each);
    auto data = makeInput(600, 751);
    for (vtkIdType i = 0; i < 600; i += 9)
    {
      double x[3];
      data->GetPoint(i, x);
      x[i / 9 % 3] = i % 2 ? nan : HUGE_VAL;
      data->GetPoints()->SetPoint(i, x);
    }
    data->GetPointData()->GetArray("weights")->SetComponent(100, 0, nan);
    stream.Source->SetWhole(data);
    stream.Writer->SetNumberOfPieces(5);
    stream.Writer->SetPointsPerBlock(100);
    stream.Writer->SetNonFinitePoints(vtkFFAlgorithm::NON_FINITE_IGNORE);
    stream.Filter->SetNonFinitePoints(vtkFFAlgorithm::NON_FINITE_IGNORE);
    FF_CHECK(stream.Run(data, each.Name + " not finite"));
  }
}

/// Ghosts are left out, and are not counted; or they are points like all others.
void testGhosts()
{
  for (const char* name : { "regular", "hull" })
  {
    auto stream = makeStream(name);
    auto data = makeInput(600, 761);
    markPoints(
      data, { 0, vtkDataSetAttributes::DUPLICATEPOINT, 0, vtkDataSetAttributes::HIDDENPOINT });
    stream.Source->SetWhole(data);
    stream.Writer->SetNumberOfPieces(3);
    stream.Writer->SetPointsPerBlock(100);
    vtkNew<vtkPolyData> remaining;
    vtkNew<vtkPoints> points;
    points->SetDataType(VTK_DOUBLE);
    remaining->GetPointData()->CopyAllOn();
    remaining->GetPointData()->CopyAllocate(data->GetPointData());
    for (vtkIdType i = 0; i < 600; i += 2)
    {
      remaining->GetPointData()->CopyData(
        data->GetPointData(), i, points->InsertNextPoint(data->GetPoint(i)));
    }
    remaining->SetPoints(points);
    FF_CHECK(stream.Run(remaining, std::string(name) + " without ghosts"));
    stream.Writer->SetSkipGhostPoints(false);
    stream.Filter->SetSkipGhostPoints(false);
    FF_CHECK(stream.Run(data, std::string(name) + " with ghosts"));
  }
}

/// Composites are points together; grids, and what no one delivers in pieces.
void testInputs()
{
  auto stream = makeStream("delaunay");
  const auto data = makeInput(300, 771);
  std::vector<vtkSmartPointer<vtkDataObject>> pieces;
  for (int k = 0; k < 3; ++k)
  {
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(1, cut(data, 100 * k, 100 * k + 40));
    blocks->SetBlock(3, cut(data, 100 * k + 40, 100 * k + 100));
    pieces.emplace_back(blocks);
  }
  stream.Source->SetPieces(pieces);
  stream.Writer->SetNumberOfPieces(3);
  stream.Writer->SetPointsPerBlock(50);
  FF_CHECK(stream.Run(data, "composites"));

  stream.Source->SetWhole(data);
  stream.Source->CanHandlePieces = false;
  stream.Source->Asked.clear();
  FF_CHECK(stream.Run(data, "a source without pieces"));
  FF_CHECK_EQUAL(stream.Source->Asked.size(), std::size_t(1));

  stream.Writer->SetInputData(data);
  FF_CHECK(stream.Run(data, "data that was set"));

  auto hull = makeStream("hull");
  vtkNew<vtkRTAnalyticSource> image;
  image->SetWholeExtent(0, 10, 0, 8, 0, 9);
  image->Update();
  hull.Writer->SetInputConnection(image->GetOutputPort());
  hull.Writer->SetNumberOfPieces(1);
  hull.Writer->SetPointsPerBlock(200);
  FF_CHECK(hull.Run(image->GetOutput(), "an image"));
  // Pieces of an image have the points between them twice.
  hull.Writer->SetNumberOfPieces(4);
  FF_CHECK_EQUAL(hull.Writer->Write(), 1);
  FF_CHECK(hull.Writer->GetNumberOfInputPoints() > 11 * 9 * 10);
  FF_CHECK_EQUAL(hull.Writer->GetVolume(), vtkFFHullFilter::SafeDownCast(hull.Filter)->GetVolume());
}

/// A first piece without points says nothing about the others; one piece is in memory at a time;
/// floats among doubles become doubles.
void testPieces()
{
  auto stream = makeStream("hull");
  auto data = makeInput(900, 781);
  std::vector<vtkSmartPointer<vtkDataObject>> pieces{ vtkSmartPointer<vtkPolyData>::New(),
    makePoints(std::vector<Point>{}, VTK_INT) };
  for (int k = 0; k < 3; ++k)
  {
    pieces.emplace_back(cut(data, 300 * k, 300 * (k + 1)));
  }
  stream.Source->SetPieces(pieces);
  stream.Writer->SetNumberOfPieces(5);
  stream.Writer->SetPointsPerBlock(200);
  FF_CHECK(stream.Run(data, "empty pieces"));
  FF_CHECK_EQUAL(stream.Source->Points->Most, stream.Source->Points->Largest);

  const auto floats = makeInput(300, 782, VTK_FLOAT);
  const auto doubles = makeInput(300, 783);
  vtkNew<vtkPolyData> whole;
  vtkNew<vtkPoints> points;
  points->SetDataType(VTK_DOUBLE);
  whole->GetPointData()->CopyAllOn();
  whole->GetPointData()->CopyAllocate(doubles->GetPointData());
  for (vtkPolyData* part : { doubles.Get(), floats.Get() })
  {
    for (vtkIdType i = 0; i < 300; ++i)
    {
      whole->GetPointData()->CopyData(
        part->GetPointData(), i, points->InsertNextPoint(part->GetPoint(i)));
    }
  }
  whole->SetPoints(points);
  stream.Source->SetPieces({ doubles, floats });
  stream.Writer->SetNumberOfPieces(2);
  FF_CHECK(stream.Run(whole, "floats among doubles"));
}

/// What holds no numbers is named.
void testWarning()
{
  auto stream = makeStream("hull");
  const auto data = makeInput(50, 791);
  stream.Source->SetWhole(data);
  const auto errors = ErrorObserver::Of(stream.Writer);
  FF_CHECK_EQUAL(stream.Writer->Write(), 1);
  FF_CHECK(errors->Has("Point data \"names\" without numbers or a name is left out."));
}

void testSettings()
{
  vtkNew<vtkFFStreamedWriter> writer;
  writer->SetMemoryLimit(1);
  FF_CHECK_EQUAL(writer->GetMemoryLimit(), vtkIdType(1024));
  writer->SetNumberOfPieces(0);
  FF_CHECK_EQUAL(writer->GetNumberOfPieces(), 1);
  writer->SetFileName("one");
  writer->SetWorkFolder("two");
  std::ostringstream printed;
  writer->Print(printed);
  for (const char* line : { "FileName: one", "WorkFolder: two", "MemoryLimit: 1024", "Shape: 0" })
  {
    FF_CHECK(printed.str().find(line) != std::string::npos);
  }
}

}

int TestFFStreamedWriter(int, char*[])
{
  testShapes();
  testDimensions();
  testPointData();
  testBits();
  testWeights();
  testEdgeLength();
  testNonFinite();
  testGhosts();
  testInputs();
  testPieces();
  testWarning();
  testSettings();
  return result();
}
