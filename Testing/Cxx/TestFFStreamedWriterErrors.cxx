// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// A streamed writing that an error or an abort ends leaves whole files and one message, and the
// next goes on, unless the input or the settings have changed.
#include "FFStreamed.h"

#include "vtkErrorCode.h"
#include "vtkFFErrorCode.h"
#include "vtkIntArray.h"
#include "vtkPassThrough.h"

#include <fstream>
#include <functional>
#include <limits>

#ifndef _WIN32
#include <csignal>
#include <sys/resource.h>
#endif

using namespace fftest;
namespace fs = std::filesystem;

namespace
{

const double nan = std::numeric_limits<double>::quiet_NaN();

bool endsWith(const std::string& name, const std::string& end)
{
  return name.size() >= end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
}

/// A triangulation in seven pieces and some blocks.
struct Stream : public WriterStream
{
  explicit Stream(unsigned int seed, const StreamCase& ofCase = streamCases[0])
    : WriterStream(ofCase)
    , Whole(makeInput(700, seed))
  {
    this->Whole->GetPointData()->RemoveArray("names"); // no warnings
    this->Source->SetWhole(this->Whole);
    this->Writer->SetNumberOfPieces(7);
    this->Writer->SetPointsPerBlock(100);
    this->Errors = ErrorObserver::Of(this->Writer);
    this->SourceErrors = ErrorObserver::Of(this->Source);
  }

  /// Nothing half written is there, and no list of blocks.
  void CheckFiles()
  {
    for (const std::string& name : this->Folder.List())
    {
      FF_CHECK(!endsWith(name, ".part") && !endsWith(name, ".vtpd"));
    }
  }

  /// Writing fails with one message that has this part, and the code.
  bool Fails(unsigned long code, const std::string& part)
  {
    this->Errors->Clear();
    FF_CHECK_EQUAL(this->Writer->Write(), 0);
    this->CheckFiles();
    FF_CHECK_EQUAL(this->Writer->GetErrorCode(), code);
    FF_CHECK_EQUAL(this->Errors->Messages.size(), std::size_t(1));
    FF_CHECK_EQUAL(this->Writer->GetNumberOfInputPoints(), 0);
    FF_CHECK_EQUAL(this->Writer->GetDimension(), -1);
    const bool has = this->Errors->Has(part);
    for (const std::string& message : this->Errors->Messages)
    {
      std::cerr << (has && this->Errors->Messages.size() == 1 ? "" : message);
    }
    this->Errors->Clear();
    return has;
  }

  /// The next writing is right.
  bool Works(const std::string& what) { return this->Run(this->Whole, what, 4); }

  /// Give another piece in place of one.
  void Replace(int piece, const vtkSmartPointer<vtkPolyData>& other)
  {
    const vtkSmartPointer<vtkPolyData> whole = this->Whole;
    this->Source->SetMaker([=](int k, int) -> vtkSmartPointer<vtkDataObject>
      { return k == piece ? other : cut(whole, 100 * k, 100 * (k + 1)); });
  }

  vtkSmartPointer<vtkPolyData> Whole;
  vtkSmartPointer<ErrorObserver> Errors;
  vtkSmartPointer<ErrorObserver> SourceErrors;
};

/// What a piece holds is wrong, or the input does not deliver it.
void testPieces()
{
  const auto check = [](int piece,
                       const std::function<vtkSmartPointer<vtkPolyData>(vtkPolyData * whole)>& make,
                       unsigned long code, const std::string& part)
  {
    Stream stream(801);
    stream.Replace(piece, make(stream.Whole));
    FF_CHECK(stream.Fails(code, "Piece " + std::to_string(piece + 1) + " of 7: " + part));
    stream.Source->SetWhole(stream.Whole);
    FF_CHECK(stream.Works(part));
  };
  for (const int piece : { 0, 5 })
  {
    check(
      piece,
      [](vtkPolyData* whole)
      {
        auto bad = cut(whole, 0, 100);
        bad->GetPoints()->SetPoint(17, 0, 0, nan);
        bad->GetPoints()->SetPoint(19, nan, 0, 0);
        return bad;
      },
      vtkFFErrorCode::NonFiniteError,
      "A coordinate or a weight is NaN or infinite: first at point 17, 2 such point(s) in it. "
      "Remove them, or set Non Finite Points to Ignore.");
    check(
      piece, [](vtkPolyData*) { return vtkSmartPointer<vtkPolyData>(); },
      vtkFFErrorCode::InputError, "The input did not deliver it. Its own error says why.");
  }
  check(
    3,
    [](vtkPolyData* whole)
    {
      auto bad = cut(whole, 0, 100);
      bad->GetPointData()->RemoveArray("velocity");
      return bad;
    },
    vtkFFErrorCode::InputError,
    "It has no array velocity of 3 float, as the first piece with points has.");
  {
    Stream stream(802);
    const auto floats = makeInput(100, 803, VTK_FLOAT);
    floats->GetPointData()->RemoveArray("names");
    stream.Replace(0, floats);
    FF_CHECK(stream.Fails(vtkFFErrorCode::InputError,
      "Piece 2 of 7: It has no points of float, as the first piece with points has."));
  }
  {
    Stream stream(804, streamCases[2]);
    auto bad = cut(stream.Whole, 0, 100);
    bad->GetPointData()->RemoveArray("weights");
    stream.Replace(2, bad);
    FF_CHECK(stream.Fails(vtkFFErrorCode::InputError,
      "Piece 3 of 7: The weights' array \"weights\" is missing from the input's point data."));
  }
}

/// An input that failed, here or further up, and was mended without a Modified(), is run again.
void testMended()
{
  for (const int pieces : { 1, 7 })
  {
    for (const bool isNear : { true, false })
    {
      Stream stream(806);
      stream.Writer->SetNumberOfPieces(pieces);
      bool isBroken = true;
      stream.Source->SetMaker([&](int k, int n)
        { return isBroken ? nullptr : cut(stream.Whole, 700 * k / n, 700 * (k + 1) / n); });
      vtkNew<vtkPassThrough> between;
      between->SetInputConnection(stream.Source->GetOutputPort());
      if (!isNear)
      {
        stream.Writer->SetInputConnection(between->GetOutputPort());
      }
      FF_CHECK(stream.Fails(vtkFFErrorCode::InputError, "The input did not deliver it."));
      isBroken = false;
      FF_CHECK(stream.Works("a mended input"));
    }
  }
}

/// Names of files that cannot be.
void testNames()
{
  Stream stream(811);
  stream.Writer->SetFileName(nullptr);
  FF_CHECK(stream.Fails(vtkErrorCode::NoFileNameError, "There is no File Name."));
  stream.Writer->SetFileName("points.vtp");
  FF_CHECK(
    stream.Fails(vtkFFErrorCode::SettingError, "File Name is points.vtp; it must end with .vtpd."));

  stream.Writer->SetFileName(stream.File.c_str());
  stream.Writer->SetMaximumEdgeLength(-1.5);
  FF_CHECK(stream.Fails(vtkFFErrorCode::SettingError,
    "Maximum Edge Length is -1.5; it must be a length, or 0 for edges of any length."));
  stream.Writer->SetMaximumEdgeLength(nan);
  FF_CHECK(stream.Fails(vtkFFErrorCode::SettingError, "Maximum Edge Length is nan; "));
  stream.Writer->SetMaximumEdgeLength(0.0);

  std::ofstream(stream.Folder.File("file")) << "no folder";
  stream.Writer->SetFileName(stream.Folder.File("file/a.vtpd").c_str());
  FF_CHECK(stream.Fails(vtkErrorCode::CannotOpenFileError, "file"));

  fs::create_directories(stream.Folder.File("others"));
  std::ofstream(stream.Folder.File("others/mine")) << "precious";
  stream.Writer->SetFileName(stream.File.c_str());
  stream.Writer->SetWorkFolder(stream.Folder.File("others").c_str());
  FF_CHECK(stream.Fails(vtkFFErrorCode::SettingError, "others has other files in it."));
  FF_CHECK(fs::exists(stream.Folder.File("others/mine")));
  fs::remove_all(stream.Folder.File("others"));
  fs::remove(stream.Folder.File("file"));
  FF_CHECK(stream.Works("a work folder of one's own"));
  FF_CHECK(!fs::exists(stream.Folder.File("others")));

  vtkNew<vtkFFStreamedWriter> alone;
  alone->SetFileName(stream.File.c_str());
  const auto errors = ErrorObserver::Of(alone);
  FF_CHECK_EQUAL(alone->Write(), 0);
  FF_CHECK_EQUAL(errors->Messages.size(), std::size_t(1));
  FF_CHECK(errors->Has("There is no input. Set one."));
  FF_CHECK_EQUAL(alone->GetErrorCode(), (unsigned long)vtkFFErrorCode::InputError);
}

/// Something else is where a block belongs, or the list of blocks.
void testObstacles()
{
  for (const char* name : { "a <b>", "a <b>/a <b>_2.vtp", "a <b>/a <b>_2.vtp.part", "a <b>.vtpd" })
  {
    Stream stream(821);
    stream.Writer->SetNumberOfThreads(1);
    const fs::path obstacle = stream.Folder.File(name);
    if (std::string(name) == "a <b>")
    {
      std::ofstream(obstacle) << "no folder";
    }
    else
    {
      fs::create_directories(obstacle / "full");
    }
    stream.Errors->Clear();
    FF_CHECK_EQUAL(stream.Writer->Write(), 0);
    FF_CHECK_EQUAL(stream.Errors->Messages.size(), std::size_t(1));
    FF_CHECK(stream.Errors->Has("cannot be written or read: "));
    FF_CHECK(stream.Errors->Has(". Write again to go on."));
    FF_CHECK_EQUAL(stream.Writer->GetErrorCode(), (unsigned long)vtkErrorCode::CannotOpenFileError);
    fs::remove_all(obstacle);
    stream.Errors->Clear();
    stream.CheckFiles();
    std::map<std::string, fs::file_time_type> times;
    for (const std::string& file : stream.Folder.List())
    {
      if (endsWith(file, ".vtp"))
      {
        times[file] = fs::last_write_time(stream.Folder.File(file));
      }
    }
    FF_CHECK(stream.Works(name));
    // Blocks that were there are not written again.
    FF_CHECK_EQUAL(times.size(), std::size_t(fs::path(name).has_parent_path() ? 2 : 0));
    for (const auto& [file, time] : times)
    {
      FF_CHECK(fs::last_write_time(stream.Folder.File(file)) == time);
    }
  }
}

/// The list of blocks alone cannot be written: no block is written again. One that is gone by then
/// is, and so are all.
void testList()
{
  for (const bool isGone : { false, true })
  {
    Stream stream(825);
    const fs::path obstacle = stream.Folder.File("a <b>.vtpd.part");
    const fs::path block = stream.Folder.File("a <b>/a <b>_1.vtp");
    fs::create_directories(obstacle / "full");
    FF_CHECK_EQUAL(stream.Writer->Write(), 0);
    FF_CHECK_EQUAL(stream.Errors->Messages.size(), std::size_t(1));
    FF_CHECK(fs::exists(block));
    fs::remove_all(obstacle);
    if (isGone)
    {
      fs::remove(block);
      FF_CHECK(stream.Fails(vtkErrorCode::CannotOpenFileError, "a <b>_1.vtp cannot be written"));
      FF_CHECK(stream.Works("without a block"));
      continue;
    }
    const auto time = fs::last_write_time(block);
    stream.Errors->Clear();
    FF_CHECK(stream.Works("without a list"));
    FF_CHECK(fs::last_write_time(block) == time);
  }
}

/// A disk that has room for a little more each time.
void testFullDisk()
{
#ifndef _WIN32
  Stream stream(831);
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before;
  getrlimit(RLIMIT_FSIZE, &before);
  int failures = 0;
  std::size_t blocks = 0;
  bool isWritten = false;
  for (rlim_t size = 1; size < (rlim_t(1) << 24) && !isWritten; size += size / 4 + 10)
  {
    const rlimit small{ size, before.rlim_max };
    setrlimit(RLIMIT_FSIZE, &small);
    stream.Errors->Clear();
    isWritten = stream.Writer->Write() == 1;
    setrlimit(RLIMIT_FSIZE, &before);
    if (!isWritten)
    {
      ++failures;
      FF_CHECK_EQUAL(stream.Errors->Messages.size(), std::size_t(1));
      FF_CHECK(stream.Errors->Has("cannot be written or read: "));
      FF_CHECK_EQUAL(
        stream.Writer->GetErrorCode(), (unsigned long)vtkErrorCode::OutOfDiskSpaceError);
      stream.CheckFiles();
    }
    blocks = std::max(blocks, stream.Folder.List().size());
  }
  stream.Errors->Clear();
  FF_CHECK(isWritten);
  FF_CHECK(failures > 10);
  stream.Filter->SetInputData(stream.Whole);
  stream.Filter->Update();
  FF_CHECK(isWrittenLike(stream.File, stream.Filter->GetOutput(), "a full disk", 4));
#endif
}

/// An abort, wherever it comes: no error. What was written stays, and the next goes on; of another
/// input, or with other settings, it begins again.
void testAborts()
{
  for (const double mark : { 0.0, 0.03, 0.1, 0.3, 0.5, 0.7, 0.9, 0.96 })
  {
    const std::string what = "after an abort at " + std::to_string(mark);
    for (const int change : { 0, 1, 2, 3 })
    {
      Stream stream(841);
      vtkNew<ProgressObserver> progress;
      progress->AbortAt = mark;
      const auto observer = stream.Writer->AddObserver(vtkCommand::ProgressEvent, progress);
      stream.Writer->SetNumberOfThreads(change == 0 ? 1 : 2);
      FF_CHECK_EQUAL(stream.Writer->Write(), 0);
      FF_CHECK(stream.Errors->Messages.empty());
      FF_CHECK_EQUAL(stream.Writer->GetErrorCode(), 0ul);
      stream.CheckFiles();
      stream.Writer->RemoveObserver(observer);
      stream.Writer->SetAbortExecute(0);

      if (change == 1)
      {
        stream.Whole->GetPoints()->SetPoint(0, 5, 5, 5);
        stream.Source->SetWhole(stream.Whole);
      }
      if (change == 2)
      {
        stream.Writer->SetFacetMode(1);
        stream.Filter->SetFacetMode(1);
      }
      if (change == 3)
      {
        stream.Whole->GetPointData()->GetArray("temperature")->SetComponent(699, 0, 77.0);
        stream.Source->SetWhole(stream.Whole);
      }
      FF_CHECK(stream.Works(what));
    }
  }
}

void stopHalfway(Stream& stream)
{
  vtkNew<ProgressObserver> progress;
  progress->AbortAt = 0.5;
  const auto observer = stream.Writer->AddObserver(vtkCommand::ProgressEvent, progress);
  FF_CHECK_EQUAL(stream.Writer->Write(), 0);
  stream.Writer->RemoveObserver(observer);
  stream.Writer->SetAbortExecute(0);
}

/// Emptying the work folder fails in its midst: what remains is not taken for a run.
void testHalfEmptied()
{
  Stream stream(845);
  stopHalfway(stream);
  const fs::path work = stream.Folder.File("a <b>.work");
  FF_CHECK(fs::exists(work / "run.flipflop"));

  fs::create_directories(work / "obstacle.flipflop" / "full");
  stream.Writer->SetFacetMode(1);
  FF_CHECK(stream.Fails(vtkErrorCode::CannotOpenFileError, "obstacle.flipflop"));
  FF_CHECK(!fs::exists(work / "run.flipflop"));
  fs::remove_all(work / "obstacle.flipflop");
  stream.Writer->SetFacetMode(0);
  FF_CHECK(stream.Works("half emptied"));
}

/// A damaged file of the work folder is named; without the folder, a writing is right.
void testDamaged()
{
  Stream stream(848);
  stream.Writer->SetNumberOfThreads(1);
  stopHalfway(stream);
  const fs::path work = stream.Folder.File("a <b>.work");
  fs::resize_file(work / "run.flipflop", 30);
  FF_CHECK(stream.Fails(vtkErrorCode::CannotOpenFileError,
    "; if it is damaged or missing, remove its folder. Write again to go on."));
  FF_CHECK(stream.Fails(vtkErrorCode::CannotOpenFileError, "run.flipflop cannot be"));
  fs::remove_all(work);
  FF_CHECK(stream.Works("damaged"));
}

/// A later writing of fewer blocks leaves none of the earlier ones, of whatever numbers, nor what
/// a killed process left of one; and leaves all others' files.
void testFewerBlocks()
{
  Stream stream(851);
  FF_CHECK(stream.Works("many blocks"));
  const std::string block = stream.Folder.File("a <b>/a <b>_");
  for (const char* name : { "70.vtp", "90.vtp", "80.vtp.part", "1000000000000.vtp.part" })
  {
    std::ofstream(block + name) << "of an earlier writing";
  }
  stream.Writer->SetPointsPerBlock(10000);
  FF_CHECK(stream.Run(stream.Whole, "one block"));
  FF_CHECK_EQUAL(stream.Writer->GetNumberOfBlocks(), 1);

  const std::vector<std::string> others{ "70.vtk", "070.vtp", "70.vtp.parts", "7a.vtp", ".vtp",
    "-7.vtp", "99999999999999999999.vtp" };
  for (const std::string& name : others)
  {
    std::ofstream(block + name) << "precious";
  }
  FF_CHECK_EQUAL(stream.Writer->Write(), 1);
  for (const std::string& name : others)
  {
    FF_CHECK(fs::exists(block + name));
  }
}

}

int TestFFStreamedWriterErrors(int, char*[])
{
  testPieces();
  testMended();
  testNames();
  testObstacles();
  testList();
  testFullDisk();
  testAborts();
  testHalfEmptied();
  testDamaged();
  testFewerBlocks();
  return result();
}
