// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Each process streams its share of the pieces: the hull is that of all pieces, one of which is in
// memory at a time. What is wrong with one on one process ends all, and nobody waits for ever.
#include "DistributedVersusSerial.h"
#include "FFPieceSource.h"
#include "Shares.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFFHullFilter.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkPFFHullFilter.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

using namespace fftest;

namespace
{

const double nan = std::numeric_limits<double>::quiet_NaN();

/// A filter that streams on each process, one that takes the whole, and a source of pieces.
struct Stream
{
  vtkNew<PieceSource> Source;
  vtkSmartPointer<ErrorObserver> SourceErrors = ErrorObserver::Of(this->Source);
  DistributedVersusSerial Both = compare<vtkPFFHullFilter, vtkFFHullFilter>();
  vtkPFFHullFilter* Hull = vtkPFFHullFilter::SafeDownCast(this->Both.Distributed);
  int Divisions;

  explicit Stream(int divisions, int resultMode = vtkPFFHullFilter::RESULT_GATHERED)
    : Divisions(divisions)
  {
    this->Hull->SetNumberOfStreamDivisions(divisions);
    this->Hull->SetResultMode(resultMode);
  }

  int GetCount() const { return processes() * this->Divisions; }

  /// So many pieces of points, one after another.
  Pieces Make(const std::vector<Point>& points, int type = VTK_DOUBLE) const
  {
    const int size = static_cast<int>(points.size()) / this->GetCount() + 1;
    const Pieces pieces = split(
      points, [=](int i) { return i / size; }, type, this->GetCount());
    decorate(pieces);
    return pieces;
  }

  void Set(const Pieces& pieces)
  {
    this->Source->SetPieces({ pieces.begin(), pieces.end() });
    this->Source->Asked.clear();
  }

  /// Reads its own pieces in their order, one at a time, and gets what one process gets of all.
  bool Run(const std::string& what, const Pieces& pieces)
  {
    return this->Run(what, pieces, append(pieces));
  }

  bool Run(const std::string& what, const Pieces& pieces, vtkDataObject* whole)
  {
    this->Set(pieces);
    this->Source->Points->Most = this->Source->Points->Largest = this->Source->Points->Now;
    const std::string all = what + " in " + std::to_string(this->Divisions);
    bool good = this->Both.Run(all, this->Source, whole);
    good = good && this->Source->Points->Most == this->Source->Points->Largest;
    good = good && this->Source->Asked.size() == static_cast<std::size_t>(this->Divisions);
    for (int k = 0; k < this->Divisions && good; ++k)
    {
      good = this->Source->Asked[static_cast<std::size_t>(k)] ==
        std::make_pair(rank() * this->Divisions + k, this->GetCount());
    }
    return good;
  }
};

std::vector<std::pair<std::string, std::vector<Point>>> shapes()
{
  std::vector<Point> grid;
  std::vector<Point> plane;
  std::vector<Point> line;
  for (int i = 0; i < 500; ++i)
  {
    grid.push_back({ double(i % 7), double(i / 7 % 7), double(i / 100) });
    plane.push_back({ double(i % 30), double(i / 30), double(i % 30 + 2 * (i / 30)) });
    line.push_back({ double(i % 37), 2.0 * (i % 37), -3.0 * (i % 37) });
  }
  return { { "cube", randomPoints(1500, 201) }, { "sphere", spherePoints(600, 202) },
    { "grid", grid }, { "plane", plane }, { "line", line },
    { "one position", std::vector<Point>(50, Point{ 1.0, 2.0, 3.0 }) },
    { "one point", { { 1, 2, 3 } } }, { "no point", {} } };
}

void testShapes(int divisions, int mode)
{
  Stream stream(divisions, mode);
  for (const auto& [name, points] : shapes())
  {
    FF_CHECK(stream.Run(name, stream.Make(points)));
  }
  using Filter = vtkFFHullFilter;
  stream.Both.Set<Filter>(
    [](Filter* filter)
    {
      filter->SetReportAsFieldData(true);
      filter->SetVisiblePointIds(true);
      filter->SetFacetMode(vtkFFAlgorithm::FACETS_AS_POLYGONS);
    });
  FF_CHECK(stream.Run("report", stream.Make(shapes()[2].second)));
  stream.Both.Set<Filter>([](Filter* filter) { filter->SetPassPointData(false); });
  FF_CHECK(stream.Run("no point data", stream.Make(shapes()[0].second)));
}

/// Pieces without points, of any kind, in the first places, in the last ones, and in between.
void testEmptyPieces(int divisions, int mode)
{
  Stream stream(divisions, mode);
  const int count = stream.GetCount();
  const auto points = randomPoints(400, 203);
  for (const int only : { 0, count / 2, count - 1 })
  {
    Pieces pieces = split(
      points, [=](int) { return only; }, VTK_FLOAT, count);
    decorate(pieces);
    FF_CHECK(stream.Run("one piece has points", pieces));
    for (std::size_t k = 0; k < pieces.size(); ++k)
    {
      if (pieces[k]->GetNumberOfPoints() == 0 && k % 2 == 0)
      {
        pieces[k] = vtkSmartPointer<vtkPolyData>::New(); // not even points
      }
    }
    FF_CHECK(stream.Run("untouched pieces", pieces));
  }
  const Pieces untouched(static_cast<std::size_t>(count), vtkSmartPointer<vtkPolyData>::New());
  FF_CHECK(stream.Run("nothing", untouched));
}

/// Types that differ, arrays that some lack, pieces without a finite point.
void testKinds(int divisions, int mode)
{
  Stream stream(divisions, mode);
  stream.Both.Set<vtkFFHullFilter>(
    [](vtkFFHullFilter* filter) { filter->SetNonFinitePoints(vtkFFAlgorithm::NON_FINITE_IGNORE); });
  auto points = randomPoints(600, 204);
  for (Point& p : points)
  {
    p = { std::floor(50 * p[0]), std::floor(50 * p[1]), std::floor(50 * p[2]) };
  }
  for (const auto& types : std::vector<std::vector<int>>{
         { VTK_INT }, { VTK_FLOAT, VTK_DOUBLE }, { VTK_FLOAT, VTK_FLOAT, VTK_INT } })
  {
    const Pieces pieces = stream.Make(points);
    for (std::size_t k = 0; k < pieces.size(); ++k)
    {
      vtkNew<vtkPoints> typed;
      typed->SetDataType(types[k % types.size()]);
      typed->DeepCopy(pieces[k]->GetPoints());
      pieces[k]->SetPoints(typed);
    }
    FF_CHECK(stream.Run("types", pieces));
  }
  const Pieces pieces = stream.Make(points);
  pieces.back()->GetPointData()->RemoveArray("wide");
  pieces[0]->GetPointData()->RemoveArray("longs");
  FF_CHECK(stream.Run("arrays", pieces));

  points.assign(points.size(), { 0, nan, 0 });
  for (std::size_t i = 0; i < points.size(); i += 97)
  {
    points[i] = { double(i), double(i % 5), double(i % 7) };
  }
  FF_CHECK(stream.Run("not finite", stream.Make(points)));
  points.assign(points.size(), { 0, nan, 0 });
  FF_CHECK(stream.Run("nothing finite", stream.Make(points)));
}

/// Ids count the points that are no ghosts, as those of several processes do.
void testGhosts(int divisions, int mode)
{
  Stream stream(divisions, mode);
  const Pieces pieces = stream.Make(randomPoints(300, 205));
  Pieces given;
  for (vtkPolyData* piece : pieces)
  {
    markPoints(piece, { 0 });
    const auto ghosts = makePoints({ { 9, 9, 9 }, { -9, 9, 9 }, { 9, -9, 9 }, { 9, 9, -9 } });
    decorate({ ghosts });
    markPoints(ghosts, { vtkDataSetAttributes::DUPLICATEPOINT, vtkDataSetAttributes::HIDDENPOINT });
    given.push_back(append({ ghosts, piece }));
  }
  given.back() = cut(given.back(), 0, 4); // nothing but ghosts
  Pieces remaining = pieces;
  remaining.back() = vtkSmartPointer<vtkPolyData>::New();
  // One process counts all.
  FF_CHECK(stream.Run("ghosts", given, append(processes() == 1 ? given : remaining)));
}

/// Blocks have one hull: that of one process that streams all pieces.
void testBlocks(int divisions, int mode)
{
  Stream stream(divisions, mode);
  const auto make = [](int k, int) -> vtkSmartPointer<vtkDataObject>
  {
    Pieces leaves;
    for (int leaf = 0; leaf < 4; ++leaf)
    {
      leaves.push_back(makeDecorated(randomPoints(40 + k, unsigned(10 * leaf + k)),
        leaf == 2 ? VTK_FLOAT : VTK_DOUBLE, 4 * k + leaf));
    }
    leaves[static_cast<std::size_t>(k % 4)] = nullptr;
    if (k == 2)
    {
      leaves.assign(4, nullptr);
    }
    return makeBlocks(leaves);
  };
  stream.Source->SetMaker(make, "vtkMultiBlockDataSet");
  stream.Both.Fails("a hull of each block", stream.Source,
    (processes() > 1 ? "Piece 1 of " + std::to_string(divisions) + " of process 0: "
                     : std::string()) +
      "A composite that is streamed has one hull. Set Composite Mode to Hull of All Blocks");

  stream.Hull->SetCompositeMode(vtkFFHullFilter::HULL_OF_ALL_BLOCKS);
  stream.Hull->UpdatePiece(rank(), processes(), 0);
  vtkNew<PieceSource> source;
  source->SetMaker(make, "vtkMultiBlockDataSet");
  vtkNew<vtkFFHullFilter> serial;
  serial->SetInputConnection(source->GetOutputPort());
  serial->SetNumberOfStreamDivisions(stream.GetCount());
  serial->SetCompositeMode(vtkFFHullFilter::HULL_OF_ALL_BLOCKS);
  serial->Update();
  vtkDataArray* const indices = serial->GetOutput()->GetPointData()->GetArray("BlockIndex");
  FF_CHECK(indices && indices->GetRange()[0] == 1 && indices->GetRange()[1] == 5);
  if (mode == vtkPFFHullFilter::RESULT_DISTRIBUTED && processes() > 1)
  {
    FF_CHECK(
      areSharesOf(stream.Hull->GetOutput(), rank() == 0 ? serial->GetOutput() : nullptr, "blocks"));
  }
  else
  {
    FF_CHECK(rank() == 0 ? isIdentical(stream.Hull->GetOutput(), serial->GetOutput(), "blocks")
                         : isEmpty(stream.Hull->GetOutput()));
  }
}

/// What cannot deliver pieces gives all at once; one process may have what another has not.
void testSources()
{
  const Pieces pieces = split(randomPoints(500, 206), byTurns);
  decorate(pieces);
  Stream stream(5);
  FF_CHECK(stream.Both.Run("data that was set", pieces));
  stream.Source->SetWhole(pieces.back());
  stream.Hull->SetInputConnection(stream.Source->GetOutputPort());
  if (rank() < processes() - 1)
  {
    stream.Hull->SetInputData(pieces[static_cast<std::size_t>(rank())]);
  }
  stream.Hull->UpdatePiece(0, 1, 0); // of a source of one's own
  if (rank() == processes() - 1)
  {
    FF_CHECK((stream.Source->Asked ==
      std::vector<std::pair<int, int>>{ { 0, 5 }, { 1, 5 }, { 2, 5 }, { 3, 5 }, { 4, 5 } }));
  }
  if (rank() == 0)
  {
    vtkNew<vtkFFHullFilter> whole;
    whole->SetInputData(append(pieces));
    whole->Update();
    FF_CHECK(isIdentical(stream.Hull->GetOutput(), whole->GetOutput(), "a source on one"));
  }
}

/// What is wrong with a piece ends all after that piece, with its name; sources that wait for each
/// other, as those of several processes may, wait in vain for nobody.
void testFaultyPieces(int divisions, int mode)
{
  vtkNew<vtkTypeInt64Array> wide;
  wide->SetNumberOfComponents(3);
  wide->SetNumberOfTuples(5);
  wide->Fill(0);
  wide->SetTypedComponent(3, 1, (vtkTypeInt64(1) << 53) + 1);
  auto points = randomPoints(20, 207);
  points[11][1] = points[15][2] = nan;
  const auto notFinite = makePoints(points);
  const auto inexact = makePoints(wide);
  Stream stream(divisions, mode);
  const int size = 10;
  const Pieces good = stream.Make(randomPoints(size * stream.GetCount() - 1, 208));
  for (int process = 0; process < processes(); ++process)
  {
    for (const int at : { 0, divisions - 1 })
    {
      const std::string piece = "Piece " + std::to_string(at + 1) + " of " +
        std::to_string(divisions) +
        (processes() > 1 ? " of process " + std::to_string(process) : "") + ": ";
      const auto fails = [&](vtkPolyData* bad, const std::string& part, vtkIdType count)
      {
        const vtkSmartPointer<vtkPolyData> given = bad;
        stream.Source->Asked.clear();
        stream.Source->SetMaker(
          [=](int k, int)
          {
            vtkMultiProcessController::GetGlobalController()->Barrier();
            vtkPolyData* const next =
              k == process * divisions + at ? given : good[static_cast<std::size_t>(k)];
            return next ? cut(next, 0, next->GetNumberOfPoints()) : nullptr;
          });
        stream.Both.Fails("a piece at fault", stream.Source, piece + part);
        FF_CHECK_EQUAL(stream.Source->Asked.size(), static_cast<std::size_t>(at + 1));
        FF_CHECK_EQUAL(!stream.SourceErrors->Messages.empty(), bad == nullptr && rank() == process);
        stream.SourceErrors->Clear();
        FF_CHECK_EQUAL(stream.Hull->GetNumberOfNonFinitePoints(), rank() == 0 ? count : 0);
      };
      const auto id = [&](int i) { return std::to_string(size * at + i); };
      fails(notFinite,
        "A coordinate is NaN or infinite: first at point " + id(11) +
          ", 2 such point(s) so far. Remove them, or set Non Finite Points to Ignore.",
        2);
      fails(inexact,
        "A coordinate is a 64-bit integer that no double holds: first at point " + id(3), 0);
      if (at > 0)
      {
        fails(nullptr, "The input did not deliver it. Its own error says why.", 0);
      }
      FF_CHECK(stream.Run("after an error", good));
    }
  }
}

/// Who asks for a stop stops all: no error, no output, no further pieces; the next run works.
void testAbort(int divisions, int mode)
{
  Stream stream(divisions, mode);
  const Pieces pieces = stream.Make(randomPoints(2000, 209));
  for (int process = 0; process < processes(); ++process)
  {
    for (const double mark : { 0.0, 0.45 })
    {
      stream.Set(pieces);
      vtkNew<ProgressObserver> progress;
      progress->AbortAt = rank() == process ? mark : 2.0;
      const unsigned long tag = stream.Hull->AddObserver(vtkCommand::ProgressEvent, progress);
      stream.Both.Fails("an abort", stream.Source, "");
      FF_CHECK(stream.Source->Asked.size() <= std::size_t(1 + mark * divisions) + 1);
      stream.Hull->RemoveObserver(tag);
      stream.Hull->SetAbortExecute(0);
      stream.Source->Modified();

      progress->AbortAt = 2.0;
      progress->Values.clear();
      const unsigned long again = stream.Hull->AddObserver(vtkCommand::ProgressEvent, progress);
      FF_CHECK(stream.Run("after an abort", pieces));
      checkProgress(progress->Values);
      stream.Hull->RemoveObserver(again);
    }
  }
}

}

void testHullStreamed()
{
  for (const int mode : { vtkPFFHullFilter::RESULT_GATHERED, vtkPFFHullFilter::RESULT_DISTRIBUTED })
  {
    for (const int divisions : { 1, 2, 5 })
    {
      testShapes(divisions, mode);
      testEmptyPieces(divisions, mode);
      testKinds(divisions, mode);
      testGhosts(divisions, mode);
    }
    for (const int divisions : { 2, 5 })
    {
      testBlocks(divisions, mode);
      testFaultyPieces(divisions, mode);
      testAbort(divisions, mode);
    }
  }
  testSources();
}
