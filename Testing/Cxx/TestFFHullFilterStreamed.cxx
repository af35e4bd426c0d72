// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// An input that is streamed in pieces gives what it gives as a whole, bit for bit; one piece is in
// memory at a time.
#include "FFPieceSource.h"
#include "FFTest.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFFErrorCode.h"
#include "vtkFFHullFilter.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <cmath>
#include <functional>
#include <limits>
#include <utility>

using namespace fftest;

namespace
{

using Objects = std::vector<vtkSmartPointer<vtkDataObject>>;

const double nan = std::numeric_limits<double>::quiet_NaN();

/// Whether a streaming filter gives what the plain one gives for the whole, and reports the same.
bool isLike(vtkFFHullFilter* streaming, vtkFFHullFilter* plain, const std::string& what)
{
  bool same = succeeds(streaming) && succeeds(plain);
  for (const char* name : { "Points", "NonFinite", "Dimension", "Volume", "Area" })
  {
    same = same && reported(streaming->GetOutput(), name) == reported(plain->GetOutput(), name);
  }
  same = same && printedReport(streaming) == printedReport(plain);
  if (!same)
  {
    std::cerr << what << ": reports differ\n";
  }
  // The work differs, and who has blocks.
  vtkNew<vtkPolyData> outputs[2];
  outputs[0]->ShallowCopy(streaming->GetOutput());
  outputs[1]->ShallowCopy(plain->GetOutput());
  for (const auto& output : outputs)
  {
    output->SetFieldData(vtkNew<vtkFieldData>());
    output->GetPointData()->RemoveArray("BlockIndex");
  }
  return isIdentical(outputs[0], outputs[1], what) && same;
}

/// A filter that streams, and a plain one.
struct Pair
{
  vtkNew<PieceSource> Source;
  vtkNew<vtkFFHullFilter> Streaming;
  vtkNew<vtkFFHullFilter> Plain;

  explicit Pair(const std::function<void(vtkFFHullFilter*)>& set = {})
  {
    this->Streaming->SetInputConnection(this->Source->GetOutputPort());
    this->Streaming->SetReportAsFieldData(true);
    this->Plain->SetReportAsFieldData(true);
    if (set)
    {
      set(this->Streaming);
      set(this->Plain);
    }
  }

  /// Runs both: on the whole, and on it in ranges.
  bool Run(vtkPolyData* whole, int divisions, const std::string& what)
  {
    this->Source->SetWhole(whole);
    this->Plain->SetInputData(whole);
    return this->Compare(divisions, what);
  }

  /// Runs both: on these pieces, and on all their data sets, as those of one composite.
  bool Run(const Objects& pieces, const std::string& what)
  {
    vtkNew<vtkPartitionedDataSet> whole;
    for (const auto& piece : pieces)
    {
      if (!vtkCompositeDataSet::SafeDownCast(piece))
      {
        whole->SetPartition(whole->GetNumberOfPartitions(), piece);
        continue;
      }
      vtkSmartPointer<vtkCompositeDataIterator> leaves;
      leaves.TakeReference(vtkCompositeDataSet::SafeDownCast(piece)->NewIterator());
      for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
      {
        whole->SetPartition(whole->GetNumberOfPartitions(), leaves->GetCurrentDataObject());
      }
    }
    this->Source->SetPieces(pieces);
    this->Plain->SetCompositeMode(vtkFFHullFilter::HULL_OF_ALL_BLOCKS);
    this->Plain->SetInputData(whole);
    return this->Compare(static_cast<int>(pieces.size()), what);
  }

  bool Compare(int divisions, const std::string& what)
  {
    this->Source->Asked.clear();
    this->Source->Points->Most = this->Source->Points->Largest = this->Source->Points->Now;
    this->Streaming->SetNumberOfStreamDivisions(divisions);
    this->Streaming->Modified();
    const std::string all = what + " in " + std::to_string(divisions);
    const bool same = isLike(this->Streaming, this->Plain, all);

    // Each piece once, in their order; never more than one at a time.
    bool asked = this->Source->Asked.size() == static_cast<std::size_t>(divisions);
    for (int k = 0; k < divisions && asked; ++k)
    {
      asked = this->Source->Asked[static_cast<std::size_t>(k)] == std::make_pair(k, divisions);
    }
    FF_CHECK(asked);
    FF_CHECK_EQUAL(this->Source->Points->Most, this->Source->Points->Largest);
    return same;
  }
};

/// Of a lattice: flat facets, many points on them, and duplicates.
std::vector<Point> lattice(int count, int axes)
{
  auto points = randomPoints(count, 62);
  for (Point& p : points)
  {
    for (int k = 0; k < 3; ++k)
    {
      p[static_cast<std::size_t>(k)] =
        k < axes ? std::round(4 * p[static_cast<std::size_t>(k)]) : 1;
    }
  }
  return points;
}

void testDivisions()
{
  const std::vector<std::pair<std::string, std::vector<Point>>> inputs{ { "cube",
                                                                          randomPoints(3000, 60) },
    { "sphere", spherePoints(2000, 61) }, { "grid", lattice(2000, 3) },
    { "plane", lattice(300, 2) }, { "line", lattice(50, 1) }, { "position", lattice(20, 0) },
    { "tetrahedron", { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } }, { "nothing", {} } };
  Pair pair;
  for (const auto& [name, points] : inputs)
  {
    for (const int type : { VTK_DOUBLE, VTK_FLOAT, VTK_INT, VTK_BIT })
    {
      const auto whole = makeDecorated(points, type);
      for (const int divisions : { 2, 7 })
      {
        pair.Streaming->SetFacetMode(divisions == 7);
        pair.Plain->SetFacetMode(divisions == 7);
        FF_CHECK(pair.Run(whole, divisions, name));
      }
    }
  }
}

/// Pieces of several types, with other arrays, without points.
void testKinds()
{
  const auto piece = [](int number, int type = VTK_DOUBLE) {
    return makeDecorated(randomPoints(200, 70u + static_cast<unsigned int>(number)), type, number);
  };
  const vtkSmartPointer<vtkPolyData> none = vtkSmartPointer<vtkPolyData>::New(); // not even points
  const auto empty = [](int type) { return makeDecorated({}, type); };
  Pair pair;
  FF_CHECK(pair.Run({ piece(0), none, piece(1), empty(VTK_FLOAT), piece(2) }, "empty pieces"));
  FF_CHECK(pair.Run({ none, empty(VTK_INT), piece(1, VTK_FLOAT), none }, "one with points"));
  FF_CHECK(pair.Run({ none, none }, "nothing"));
  FF_CHECK(pair.Run({ empty(VTK_INT), empty(VTK_DOUBLE), empty(VTK_SHORT) }, "points without one"));
  FF_CHECK(pair.Run({ piece(0, VTK_FLOAT), piece(1, VTK_INT), piece(2, VTK_FLOAT) }, "types"));
  FF_CHECK(pair.Run({ piece(0, VTK_INT), piece(1, VTK_INT), empty(VTK_DOUBLE) }, "integers"));

  // An array that one piece lacks, that has another type, another order.
  auto lacks = piece(1);
  lacks->GetPointData()->RemoveArray("names");
  auto other = piece(2);
  other->GetPointData()->RemoveArray("temperature");
  vtkNew<vtkIdTypeArray> temperature;
  temperature->SetName("temperature");
  temperature->SetNumberOfTuples(200);
  temperature->Fill(5);
  other->GetPointData()->AddArray(temperature);
  FF_CHECK(pair.Run({ piece(0), lacks, piece(3) }, "an array less"));
  FF_CHECK(pair.Run({ other, piece(0), lacks }, "both"));

  // The lowest id stands for all, whichever piece it is in.
  FF_CHECK(pair.Run({ piece(0), piece(0), piece(1), piece(0) }, "duplicates"));
}

void testNonFiniteIgnored()
{
  Pair pair(
    [](vtkFFHullFilter* hull) { hull->SetNonFinitePoints(vtkFFAlgorithm::NON_FINITE_IGNORE); });
  auto points = randomPoints(500, 80);
  for (std::size_t i = 0; i < points.size(); i += 9)
  {
    points[i][i % 3] = i % 2 ? nan : HUGE_VAL;
  }
  FF_CHECK(pair.Run(makeDecorated(points), 7, "not finite"));
  FF_CHECK_EQUAL(pair.Streaming->GetNumberOfNonFinitePoints(), 56);

  // A piece without a finite point has a say in the type, and in the arrays.
  const auto bad = [](int type, int count = 3) {
    return makeDecorated(std::vector<Point>(static_cast<std::size_t>(count), { 0, nan, 0 }), type);
  };
  const auto good = makeDecorated(randomPoints(100, 81), VTK_FLOAT);
  auto lacks = bad(VTK_FLOAT);
  lacks->GetPointData()->RemoveArray("names");
  FF_CHECK(pair.Run({ good, bad(VTK_DOUBLE), good }, "the second not finite"));
  FF_CHECK(pair.Run({ bad(VTK_DOUBLE), bad(VTK_FLOAT), good }, "the first two not finite"));
  FF_CHECK(pair.Run({ lacks, good }, "an array less"));
  FF_CHECK(pair.Run({ good, lacks, bad(VTK_FLOAT) }, "an array less at the end"));
  FF_CHECK(pair.Run({ bad(VTK_FLOAT), bad(VTK_FLOAT), bad(VTK_DOUBLE, 1) }, "nothing finite"));
}

/// Ghosts of each piece, whether or not the others have any; ids count them.
void testGhosts()
{
  const auto piece = [](int number, int ghostsEach)
  {
    auto data = makeDecorated(lattice(300, 3), VTK_DOUBLE, number);
    if (ghostsEach > 0)
    {
      std::vector<int> marks(static_cast<std::size_t>(ghostsEach), 0);
      marks[0] = vtkDataSetAttributes::DUPLICATEPOINT;
      markPoints(data, marks);
    }
    return data;
  };
  for (const bool skip : { true, false })
  {
    Pair pair([=](vtkFFHullFilter* hull) { hull->SetSkipGhostPoints(skip); });
    FF_CHECK(pair.Run({ piece(0, 2), piece(1, 3), piece(2, 2) }, "ghosts"));
    FF_CHECK(pair.Run({ piece(0, 0), piece(1, 3), piece(2, 0) }, "some ghosts"));
    FF_CHECK(pair.Run({ piece(0, 1), piece(1, 3), piece(2, 1) }, "only ghosts"));
    FF_CHECK(pair.Run({ piece(0, 1), piece(1, 1) }, "nothing but ghosts"));
  }
  // An error, too, names the id among all.
  const auto second = piece(1, 3);
  second->GetPoints()->SetPoint(17, nan, 0, 0);
  Pair pair;
  pair.Source->SetPieces({ piece(0, 2), second });
  pair.Streaming->SetNumberOfStreamDivisions(2);
  FF_CHECK(fails(pair.Streaming, vtkFFErrorCode::NonFiniteError,
    { "first at point 317, 1 such point(s) so far. Remove them" }));
}

/// Composites, of any class and number of data sets in each piece, have one hull. Of each data set,
/// there is none.
void testBlocks()
{
  Objects blocks;
  Objects partitions;
  for (int k = 0; k < 4; ++k)
  {
    const auto data = [k](int b)
    {
      return makeDecorated(randomPoints(100 + k, static_cast<unsigned int>(90 + 10 * b + k)),
        b == 2 ? VTK_FLOAT : VTK_DOUBLE, 10 * b + k);
    };
    vtkNew<vtkMultiBlockDataSet> outer; // flat indices 1, 3, 4
    vtkNew<vtkMultiBlockDataSet> nested;
    nested->SetNumberOfBlocks(2);
    outer->SetBlock(0, data(0));
    nested->SetBlock(0, k == 0 || k == 2 ? nullptr : data(1).Get());
    nested->SetBlock(1, data(2));
    outer->SetBlock(1, nested);
    blocks.emplace_back(outer);
    vtkNew<vtkPartitionedDataSet> set;
    for (int b = 0; b < 2 - k % 2; ++b)
    {
      set->SetPartition(static_cast<unsigned int>(b), data(b));
    }
    partitions.emplace_back(set);
  }
  Pair pair(
    [](vtkFFHullFilter* hull) { hull->SetCompositeMode(vtkFFHullFilter::HULL_OF_ALL_BLOCKS); });
  FF_CHECK(pair.Run(partitions, "partitions"));
  FF_CHECK(pair.Run(blocks, "blocks"));
  pair.Streaming->Modified();
  pair.Streaming->Update();
  vtkDataArray* indices = pair.Streaming->GetOutput()->GetPointData()->GetArray("BlockIndex");
  FF_CHECK(indices && indices->GetRange()[0] == 1 && indices->GetRange()[1] == 4);

  pair.Streaming->SetCompositeMode(vtkFFHullFilter::HULL_OF_EACH_BLOCK);
  FF_CHECK(fails(pair.Streaming, vtkFFErrorCode::SettingError,
    { "A composite that is streamed has one hull. Set Composite Mode to Hull of All Blocks, or "
      "Number Of Stream Divisions to 1." }));
  pair.Streaming->SetCompositeMode(vtkFFHullFilter::HULL_OF_ALL_BLOCKS);
  pair.Streaming->SetCompositeMode(vtkFFHullFilter::HULL_OF_EACH_BLOCK);
  pair.Streaming->SetNumberOfStreamDivisions(1);
  FF_CHECK(succeeds(pair.Streaming));
  FF_CHECK(pair.Streaming->GetOutputDataObject(0)->IsA("vtkMultiBlockDataSet"));
}

/// Field data is the first piece's.
void testFieldData()
{
  Objects pieces;
  for (int k = 0; k < 2; ++k)
  {
    const auto piece = makeDecorated(randomPoints(50, static_cast<unsigned int>(140 + k)));
    vtkNew<vtkIdTypeArray> number;
    number->SetName("number");
    number->InsertNextValue(k);
    piece->GetFieldData()->AddArray(number);
    pieces.emplace_back(piece);
  }
  Pair pair;
  pair.Source->SetPieces(pieces);
  pair.Streaming->SetNumberOfStreamDivisions(2);
  pair.Streaming->Update();
  vtkFieldData* data = pair.Streaming->GetOutput()->GetFieldData();
  FF_CHECK(data->GetArray("number") && data->GetArray("number")->GetTuple1(0) == 0);
}

}

int TestFFHullFilterStreamed(int, char*[])
{
  testDivisions();
  testKinds();
  testNonFiniteIgnored();
  testGhosts();
  testBlocks();
  testFieldData();
  return result();
}
