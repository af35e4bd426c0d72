// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// A streaming filter in the pipeline: sources that deliver no pieces, errors and aborts in some
// piece, what makes it run again.
#include "FFPieceSource.h"
#include "FFTest.h"

#include "vtkFFErrorCode.h"
#include "vtkFFHullFilter.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPassInputTypeAlgorithm.h"
#include "vtkTypeInt64Array.h"

#include <limits>
#include <utility>

using namespace fftest;

namespace
{

const double nan = std::numeric_limits<double>::quiet_NaN();

/// Passes its input on; counts its runs.
class Passing : public vtkPassInputTypeAlgorithm
{
public:
  static Passing* New();
  vtkTypeMacro(Passing, vtkPassInputTypeAlgorithm);
  int Runs = 0;

protected:
  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    ++this->Runs;
    vtkDataObject::GetData(outputs)->ShallowCopy(vtkDataObject::GetData(inputs[0]));
    return 1;
  }
};
vtkStandardNewMacro(Passing);

vtkSmartPointer<vtkPolyData> hullOf(vtkDataObject* data)
{
  vtkNew<vtkFFHullFilter> hull;
  hull->SetInputDataObject(data);
  hull->Update();
  return hull->GetOutput();
}

/// A source of points, and a filter that streams them in seven pieces.
struct Stream
{
  vtkSmartPointer<vtkPolyData> Whole = makeDecorated(randomPoints(700, 150));
  vtkNew<PieceSource> Source;
  vtkNew<vtkFFHullFilter> Hull;
  vtkSmartPointer<ErrorObserver> SourceErrors = ErrorObserver::Of(this->Source);

  Stream()
  {
    this->Source->SetWhole(this->Whole);
    this->Hull->SetInputConnection(this->Source->GetOutputPort());
    this->Hull->SetNumberOfStreamDivisions(7);
  }

  std::size_t GetAsked() const { return this->Source->Asked.size(); }

  bool IsRight() { return isIdentical(this->Hull->GetOutput(), hullOf(this->Whole), "streamed"); }

  /// The next update fails with these words, after so many pieces, and the one after it works.
  void Fails(unsigned long code, const std::string& part, std::size_t asked)
  {
    this->Source->Asked.clear();
    FF_CHECK(fails(this->Hull, code, { part }));
    FF_CHECK_EQUAL(this->GetAsked(), asked);
    this->SourceErrors->Clear();
    this->Source->Asked.clear();
    this->Source->SetWhole(this->Whole);
    FF_CHECK(succeeds(this->Hull));
    FF_CHECK_EQUAL(this->GetAsked(), std::size_t(7));
    FF_CHECK(this->IsRight());
  }
};

/// What cannot deliver pieces delivers all in the first, and is asked for no other; a filter
/// between does not matter.
void testSources()
{
  for (const bool canHandle : { false, true })
  {
    Stream stream;
    stream.Source->CanHandlePieces = canHandle;
    const std::size_t pieces = canHandle ? 7 : 1;
    FF_CHECK(succeeds(stream.Hull));
    FF_CHECK(stream.IsRight());
    FF_CHECK_EQUAL(stream.GetAsked(), pieces);
    vtkNew<Passing> between;
    between->SetInputConnection(stream.Source->GetOutputPort());
    stream.Hull->SetInputConnection(between->GetOutputPort());
    FF_CHECK(succeeds(stream.Hull));
    FF_CHECK(stream.IsRight());
    FF_CHECK_EQUAL(between->Runs, int(pieces));
    FF_CHECK_EQUAL(stream.Hull->GetNumberOfInputPoints(), 700);

    stream.Hull->SetInputData(stream.Whole);
    stream.Hull->SetNumberOfStreamDivisions(VTK_INT_MAX);
    FF_CHECK(succeeds(stream.Hull));
    FF_CHECK(stream.IsRight());
    FF_CHECK_EQUAL(stream.Hull->GetNumberOfInputPoints(), 700);
  }
}

/// It runs again when something changed, and only then; what is asked for it divides.
void testModification()
{
  Stream stream;
  std::size_t expected = 0;
  const auto check = [&](int divisions, std::size_t asked)
  {
    stream.Hull->SetNumberOfStreamDivisions(divisions);
    FF_CHECK(succeeds(stream.Hull));
    FF_CHECK_EQUAL(stream.GetAsked(), expected += asked);
    FF_CHECK(stream.IsRight());
  };
  check(7, 7);
  check(7, 0);
  check(3, 3);
  check(0, 1); // at least one
  FF_CHECK_EQUAL(stream.Hull->GetNumberOfStreamDivisions(), 1);
  FF_CHECK(stream.Source->Asked.back() == std::make_pair(0, 1));
  stream.Source->Modified();
  check(2, 2);

  stream.Source->Asked.clear();
  stream.Hull->UpdatePiece(1, 3, 0);
  FF_CHECK((stream.Source->Asked == std::vector<std::pair<int, int>>{ { 2, 6 }, { 3, 6 } }));
  const auto ids = originalIds(stream.Hull->GetOutput());
  FF_CHECK(!ids.empty() && ids.back() < 234);
  FF_CHECK_EQUAL(stream.Hull->GetNumberOfInputPoints(), 233);
}

/// What a piece holds is wrong, or the source fails, where the executive does not see it.
void testBadPieces()
{
  auto points = randomPoints(20, 160);
  points[11][1] = points[15][2] = nan;
  const auto notFinite = makePoints(points);
  vtkNew<vtkTypeInt64Array> wide;
  wide->SetNumberOfComponents(3);
  wide->SetNumberOfTuples(5);
  wide->Fill(0);
  wide->SetTypedComponent(3, 1, (vtkTypeInt64(1) << 53) + 1);
  const auto inexact = makePoints(wide);
  const auto marked = makePoints(cubeCorners());
  markPoints(marked, { 0 }, false);
  Stream stream;
  for (const int at : { 0, 6 })
  {
    const std::string piece = "Piece " + std::to_string(at + 1) + " of 7: ";
    const auto fails = [&](vtkPolyData* bad, unsigned long code, const std::string& part)
    {
      const vtkSmartPointer<vtkPolyData> whole = stream.Whole;
      const vtkSmartPointer<vtkPolyData> given = bad;
      stream.Source->SetMaker(
        [=](int k, int n) { return k == at ? given : cut(whole, 100 * k, 700 * (k + 1) / n); });
      stream.Fails(code, part, static_cast<std::size_t>(at + 1));
    };
    fails(notFinite, vtkFFErrorCode::NonFiniteError,
      piece + "A coordinate is NaN or infinite: first at point " + std::to_string(100 * at + 11) +
        ", 2 such point(s) so far. Remove them, or set Non Finite Points to Ignore.");
    fails(inexact, vtkFFErrorCode::InputError,
      piece + "A coordinate is a 64-bit integer that no double holds: first at point " +
        std::to_string(100 * at + 3) + ".");
    fails(marked, vtkFFErrorCode::InputError, piece + "The point array vtkGhostType");
    if (at > 0)
    {
      fails(nullptr, vtkFFErrorCode::InputError,
        piece + "The input did not deliver it. Its own error says why.");
    }
  }
}

/// Of blocks, errors name theirs; pieces may differ in their number.
void testBadBlocks()
{
  vtkNew<PieceSource> source;
  vtkNew<vtkFFHullFilter> hull;
  hull->SetInputConnection(source->GetOutputPort());
  hull->SetNumberOfStreamDivisions(3);
  hull->SetCompositeMode(vtkFFHullFilter::HULL_OF_ALL_BLOCKS);
  const auto deliver = [&](int bad, unsigned int at, vtkDataObject* block)
  {
    std::vector<vtkSmartPointer<vtkDataObject>> pieces;
    for (int k = 0; k < 3; ++k)
    {
      vtkNew<vtkMultiBlockDataSet> blocks;
      blocks->SetBlock(0, makePoints(randomPoints(50, static_cast<unsigned int>(170 + k))));
      blocks->SetBlock(1, makePoints(randomPoints(50, static_cast<unsigned int>(180 + k))));
      if (k == bad)
      {
        blocks->SetBlock(at, block);
      }
      pieces.emplace_back(blocks);
    }
    source->SetPieces(pieces);
  };
  auto points = randomPoints(50, 190);
  points[4][0] = nan;
  deliver(2, 1, makePoints(points));
  FF_CHECK(fails(hull, vtkFFErrorCode::NonFiniteError,
    { "first at point 4 of the block of flat index 2, 1 such point(s) so far." }));
  FF_CHECK_EQUAL(hull->GetNumberOfNonFinitePoints(), 1);
  deliver(-1, 0, nullptr);
  FF_CHECK(succeeds(hull));
}

/// An abort, at whatever piece: no error, no output; the next update works.
void testAbort()
{
  for (const double mark : { 0.0, 0.6 })
  {
    Stream stream;
    vtkNew<ProgressObserver> progress;
    progress->AbortAt = mark;
    stream.Hull->AddObserver(vtkCommand::ProgressEvent, progress);
    FF_CHECK(succeeds(stream.Hull));
    FF_CHECK(hasForgotten(stream.Hull));
    FF_CHECK(stream.GetAsked() <= static_cast<std::size_t>(7 * mark) + 2);
    progress->AbortAt = 2.0;
    progress->Values.clear();
    stream.Hull->SetAbortExecute(0);
    stream.Source->Modified();
    stream.Source->Asked.clear();
    FF_CHECK(succeeds(stream.Hull));
    FF_CHECK_EQUAL(stream.GetAsked(), std::size_t(7));
    FF_CHECK(stream.IsRight());
    checkProgress(progress->Values);
    FF_CHECK(progress->Values.size() > 7);
  }
}

}

int TestFFHullFilterStreamedErrors(int, char*[])
{
  testSources();
  testModification();
  testBadPieces();
  testBadBlocks();
  testAbort();
  return result();
}
