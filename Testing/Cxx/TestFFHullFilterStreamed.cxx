// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// An input that is streamed in pieces gives what it gives as a whole, bit for bit; one piece is in
// memory at a time.
#include "FFPieceSource.h"
#include "FFTest.h"

#include "vtkDataSetAttributes.h"
#include "vtkErrorCode.h"
#include "vtkFFHullFilter.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
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
  const auto errors = ErrorObserver::Of(streaming);
  streaming->Update();
  plain->Update();
  for (const std::string& message : errors->Messages)
  {
    std::cerr << what << ": " << message;
  }
  if (!isIdentical(streaming->GetOutputDataObject(0), plain->GetOutputDataObject(0), what))
  {
    return false;
  }
  const bool same = errors->Messages.empty() && streaming->GetVolume() == plain->GetVolume() &&
    streaming->GetArea() == plain->GetArea() &&
    streaming->GetDimension() == plain->GetDimension() &&
    streaming->GetEngineUsed() == plain->GetEngineUsed() &&
    streaming->GetNumberOfInputPoints() == plain->GetNumberOfInputPoints() &&
    streaming->GetNumberOfNonFinitePoints() == plain->GetNumberOfNonFinitePoints();
  if (!same)
  {
    std::cerr << what << ": reports differ\n";
  }
  return same;
}

/// A filter that streams, beside a plain one.
struct Pair
{
  vtkNew<PieceSource> Source;
  vtkNew<vtkFFHullFilter> Streaming;
  vtkNew<vtkFFHullFilter> Plain;

  explicit Pair(const std::function<void(vtkFFHullFilter*)>& set = {})
  {
    this->Streaming->SetInputConnection(this->Source->GetOutputPort());
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

  /// Runs both: on these pieces, and on them as partitions of one data set.
  bool Run(const Objects& pieces, const std::string& what)
  {
    vtkNew<vtkPartitionedDataSet> whole;
    for (std::size_t k = 0; k < pieces.size(); ++k)
    {
      whole->SetPartition(static_cast<unsigned int>(k), pieces[k]);
    }
    this->Source->SetPieces(pieces);
    // As a block: the result of a plain vtkPartitionedDataSet would be one.
    this->Plain->SetCompositeModeToAllBlocks();
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

std::vector<Point> onSphere(int count)
{
  auto points = randomPoints(count, 61);
  for (Point& p : points)
  {
    const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    p = { p[0] / length, p[1] / length, p[2] / length };
  }
  return points;
}

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
  const std::vector<std::pair<std::string, std::vector<Point>>> inputs{
    { "cube", randomPoints(3000, 60) }, { "sphere", onSphere(2000) }, { "grid", lattice(2000, 3) },
    { "plane", lattice(300, 2) }, { "line", lattice(50, 1) }, { "position", lattice(20, 0) },
    { "tetrahedron", { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } }, { "nothing", {} }
  };
  Pair pair;
  for (const auto& [name, points] : inputs)
  {
    for (const int type : { VTK_DOUBLE, VTK_FLOAT, VTK_INT, VTK_BIT })
    {
      const auto whole = makeDecorated(points, type);
      for (const int divisions : { 1, 2, 7, 100 })
      {
        FF_CHECK(pair.Run(whole, divisions, name));
      }
    }
  }
}

void testSettings()
{
  const auto whole = makeDecorated(lattice(2000, 3));
  const std::vector<std::function<void(vtkFFHullFilter*)>> settings{ [](vtkFFHullFilter* hull)
    { hull->SetFacetModeToPolygons(); },
    [](vtkFFHullFilter* hull) { hull->PassPointDataOff(); },
    [](vtkFFHullFilter* hull) { hull->VisiblePointIdsOn(); },
    [](vtkFFHullFilter* hull) { hull->ReportAsFieldDataOn(); },
    [](vtkFFHullFilter* hull) { hull->SetCompositeModeToAllBlocks(); },
    [](vtkFFHullFilter* hull) { hull->SetNumberOfThreads(2); } };
  for (std::size_t i = 0; i < settings.size(); ++i)
  {
    Pair pair(settings[i]);
    FF_CHECK(pair.Run(whole, 7, "setting " + std::to_string(i)));
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
  FF_CHECK(pair.Run({ empty(VTK_DOUBLE), none }, "points without one, then nothing"));
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
  FF_CHECK(pair.Run({ lacks, piece(0) }, "an array more"));
  FF_CHECK(pair.Run({ piece(0), other, piece(3) }, "another type"));
  FF_CHECK(pair.Run({ other, piece(0), lacks }, "both"));

  // The lowest id stands for all, whichever piece it is in.
  FF_CHECK(pair.Run({ piece(0), piece(0), piece(1), piece(0) }, "duplicates"));
}

void testNonFiniteIgnored()
{
  Pair pair([](vtkFFHullFilter* hull) { hull->SetNonFinitePointsToIgnore(); });
  auto points = randomPoints(500, 80);
  for (std::size_t i = 0; i < points.size(); i += 9)
  {
    points[i][i % 3] = i % 2 ? nan : HUGE_VAL;
  }
  for (const int divisions : { 1, 2, 7, 100 })
  {
    FF_CHECK(pair.Run(makeDecorated(points), divisions, "not finite"));
  }
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
      vtkNew<vtkUnsignedCharArray> marks;
      marks->SetName(vtkDataSetAttributes::GhostArrayName());
      for (int i = 0; i < 300; ++i)
      {
        marks->InsertNextValue(i % ghostsEach == 0
            ? static_cast<unsigned char>(vtkDataSetAttributes::DUPLICATEPOINT)
            : 0);
      }
      data->GetPointData()->AddArray(marks);
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
  // An error, too, names the place among all.
  auto first = piece(0, 2);
  auto second = piece(1, 3);
  second->GetPoints()->SetPoint(17, nan, 0, 0);
  Pair pair;
  pair.Source->SetPieces({ first, second });
  pair.Streaming->SetNumberOfStreamDivisions(2);
  const auto errors = ErrorObserver::Of(pair.Streaming);
  pair.Streaming->Update();
  FF_CHECK(errors->Has("first at point 317, 1 such point(s) so far. Remove them"));
}

/// Images in pieces: their points are laid out, one piece's at a time.
void testImages()
{
  Objects pieces;
  for (int k = 0; k < 3; ++k)
  {
    vtkNew<vtkImageData> image;
    image->SetExtent(0, 4, 0, 4, 3 * k, 3 * k + 3);
    image->SetSpacing(1, 0.5, 0.1);
    pieces.emplace_back(image);
  }
  Pair pair;
  FF_CHECK(pair.Run(pieces, "images"));
  FF_CHECK_EQUAL(pair.Streaming->GetNumberOfInputPoints(), 300);
}

/// Blocks: flat indices 1, 3 and 4, of which some pieces have none.
Objects blocksInPieces()
{
  Objects pieces;
  for (int k = 0; k < 4; ++k)
  {
    const auto data = [k](int b) -> vtkSmartPointer<vtkPolyData>
    {
      return makeDecorated(randomPoints(100 + k, static_cast<unsigned int>(90 + 10 * b + k)),
        b == 2 ? VTK_FLOAT : VTK_DOUBLE, 10 * b + k);
    };
    vtkNew<vtkMultiBlockDataSet> blocks;
    vtkNew<vtkMultiBlockDataSet> nested;
    blocks->SetNumberOfBlocks(3);
    nested->SetNumberOfBlocks(2);
    blocks->SetBlock(1, nested);
    blocks->SetBlock(0, data(0));
    nested->SetBlock(0, k == 0 || k == 2 ? nullptr : data(1).Get());
    nested->SetBlock(1, data(2));
    blocks->SetBlock(2, nullptr);
    pieces.emplace_back(blocks);
  }
  return pieces;
}

/// The same as a whole: each block has its pieces as partitions.
vtkSmartPointer<vtkPartitionedDataSetCollection> blocksAsWhole(const Objects& pieces)
{
  auto whole = vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
  whole->SetNumberOfPartitionedDataSets(4);
  for (const auto& piece : pieces)
  {
    auto* blocks = vtkMultiBlockDataSet::SafeDownCast(piece);
    auto* nested = vtkMultiBlockDataSet::SafeDownCast(blocks->GetBlock(1));
    vtkDataObject* leaves[4] = { blocks->GetBlock(0), nested->GetBlock(0), nested->GetBlock(1),
      blocks->GetBlock(2) };
    for (unsigned int b = 0; b < 4; ++b)
    {
      if (leaves[b])
      {
        vtkPartitionedDataSet* block = whole->GetPartitionedDataSet(b);
        block->SetPartition(block->GetNumberOfPartitions(), leaves[b]);
      }
    }
  }
  return whole;
}

void testBlocks()
{
  const Objects pieces = blocksInPieces();
  Pair pair;
  pair.Source->SetPieces(pieces);
  pair.Plain->SetInputData(blocksAsWhole(pieces));

  // One hull of all. Flat indices of the two structures differ.
  pair.Streaming->SetNumberOfStreamDivisions(4);
  pair.Streaming->SetCompositeModeToAllBlocks();
  pair.Plain->SetCompositeModeToAllBlocks();
  pair.Streaming->Update();
  pair.Plain->Update();
  auto* found = vtkPolyData::SafeDownCast(pair.Streaming->GetOutputDataObject(0));
  auto* expected = vtkPolyData::SafeDownCast(pair.Plain->GetOutputDataObject(0));
  vtkDataArray* indices = found->GetPointData()->GetArray("BlockIndex");
  FF_CHECK(indices && indices->GetRange()[0] == 1 && indices->GetRange()[1] == 4);
  found->GetPointData()->RemoveArray("BlockIndex");
  expected->GetPointData()->RemoveArray("BlockIndex");
  FF_CHECK(isIdentical(found, expected, "all blocks"));
  FF_CHECK_EQUAL(pair.Streaming->GetVolume(), pair.Plain->GetVolume());
  FF_CHECK_EQUAL(pair.Streaming->GetNumberOfInputPoints(), pair.Plain->GetNumberOfInputPoints());

  // A hull of each.
  pair.Streaming->SetCompositeModeToEachBlock();
  pair.Plain->SetCompositeModeToEachBlock();
  pair.Streaming->Update();
  pair.Plain->Update();
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(pair.Streaming->GetOutputDataObject(0));
  auto* nested = vtkMultiBlockDataSet::SafeDownCast(blocks->GetBlock(1));
  auto* whole = vtkPartitionedDataSetCollection::SafeDownCast(pair.Plain->GetOutputDataObject(0));
  vtkDataObject* hulls[4] = { blocks->GetBlock(0), nested->GetBlock(0), nested->GetBlock(1),
    blocks->GetBlock(2) };
  for (unsigned int b = 0; b < 4; ++b)
  {
    FF_CHECK(isIdentical(
      hulls[b], b < 3 ? whole->GetPartition(b, 0) : nullptr, "block " + std::to_string(b)));
  }
  FF_CHECK_EQUAL(pair.Streaming->GetVolume(), pair.Plain->GetVolume());
  FF_CHECK_EQUAL(pair.Streaming->GetNumberOfInputPoints(), pair.Plain->GetNumberOfInputPoints());
}

/// A vtkPartitionedDataSet is one block, with any number of partitions in each piece.
void testPartitions()
{
  Objects pieces;
  vtkNew<vtkPartitionedDataSet> whole;
  for (int k = 0; k < 3; ++k)
  {
    vtkNew<vtkPartitionedDataSet> piece;
    for (int p = 0; p < 2 - k % 2; ++p)
    {
      const auto part =
        makeDecorated(randomPoints(100, static_cast<unsigned int>(120 + 2 * k + p)), VTK_FLOAT, k);
      piece->SetPartition(static_cast<unsigned int>(p), part);
      whole->SetPartition(whole->GetNumberOfPartitions(), part);
    }
    pieces.emplace_back(piece);
  }
  for (const int mode : { 0, 1 })
  {
    Pair pair([=](vtkFFHullFilter* hull) { hull->SetCompositeMode(mode); });
    pair.Source->SetPieces(pieces);
    pair.Plain->SetInputData(whole);
    FF_CHECK(pair.Compare(3, "partitions"));
  }
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
  testSettings();
  testKinds();
  testNonFiniteIgnored();
  testGhosts();
  testImages();
  testBlocks();
  testPartitions();
  testFieldData();
  return result();
}
