// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A streamed run that was stopped anywhere leaves whole files, and goes on to the same bits.
#include "Stream/WorkFolder.h"
#include "Support/Parallel.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"
#include "Testing/Engine/Stream/StreamedRuns.h"

#include <flipflop/Error.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <fstream>
#include <functional>
#include <limits>
#include <stdexcept>
#include <thread>

#ifndef _WIN32
#include <sys/resource.h>
#endif

namespace flipflop
{
namespace test
{

namespace
{

namespace fs = std::filesystem;

/// What it throws, as words.
std::string messageOf(const std::function<void()>& call)
{
  try
  {
    call();
  }
  catch (const PieceError& error)
  {
    return "piece " + std::to_string(error.piece()) + ", point " + std::to_string(error.index()) +
      " of " + std::to_string(error.count()) + ": " + error.what();
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
  return "";
}

class StreamedRunFaults : public ::testing::Test
{
protected:
  /// One call, with five blocks.
  std::string call(Gathered& gathered, const ReadPiece& read, const WriteBlock& write)
  {
    this->settings.shape = this->shape;
    return messageOf(
      [&]
      {
        const StreamReport report = streamedRun(this->settings, this->pieces.count, read, write);
        Cloud seen = this->cloud;
        for (Point& p : seen)
        {
          p[2] = this->shape == BlockShape::Delaunay ? 0 : p[2];
        }
        EXPECT_EQ(
          differenceFromOneRun(this->shape, seen, gathered.report(report), this->settings.options),
          "");
      });
  }
  std::string call(Gathered& gathered)
  {
    return this->call(
      gathered, this->pieces, [&](StreamedBlock&& block) { gathered(std::move(block)); });
  }

  /// After an error: whole files are all that is left, and the run goes on to the same bits.
  void expectGoesOn(Gathered& gathered)
  {
    if (fs::exists(this->folder.path))
    {
      EXPECT_EQ(this->folder.unfinished(), std::vector<std::string>());
    }
    EXPECT_EQ(this->call(gathered), "");
    EXPECT_FALSE(fs::exists(this->folder.path));
  }

  const SmallSamples small;
  BlockShape shape = BlockShape::RegularTriangulation;
  const Cloud cloud = randomSites(600, 0.0001, 1);
  const Pieces pieces{ this->cloud, 4 };
  const StreamFolder folder;
  StreamSettings settings = settingsOf(BlockShape::RegularTriangulation, 130, 2, this->folder);
};

/// While it lives, the file step of that number fails, as on a disk that is full.
class FileFault
{
public:
  explicit FileFault(int number)
    : left(number)
  {
    beforeFileStep() = [this]
    {
      if (--this->left == 0)
      {
        throw fs::filesystem_error("full", std::make_error_code(std::errc::no_space_on_device));
      }
    };
  }
  FileFault(const FileFault&) = delete;
  FileFault& operator=(const FileFault&) = delete;
  ~FileFault() { beforeFileStep() = nullptr; }

private:
  std::atomic<int> left;
};

/// Of the steps, each third, begun at another for each shape; few under a sanitizer.
TEST_F(StreamedRunFaults, OfFileSteps)
{
  const int stride = isSanitized() ? 30 : 3;
  int faults = 0;
  for (const BlockShape of :
    { BlockShape::Hull, BlockShape::Delaunay, BlockShape::RegularTriangulation })
  {
    this->shape = of;
    bool ended = false;
    for (int step = 1 + static_cast<int>(of); !ended && !HasFailure(); step += stride)
    {
      Gathered gathered;
      {
        const FileFault fault(step);
        const std::string message = this->call(gathered);
        ended = message.empty();
        EXPECT_TRUE(ended || message.find("full") != std::string::npos) << message;
      }
      if (!ended)
      {
        ++faults;
        this->expectGoesOn(gathered);
      }
    }
  }
  EXPECT_GT(faults, effort(200));
}

/// A run that is stopped again and again does not begin again and again.
TEST_F(StreamedRunFaults, OneAfterAnother)
{
  Gathered gathered;
  int pieceCalls = 0;
  int calls = 0;
  for (std::string message = "none yet"; !message.empty(); ++calls)
  {
    ASSERT_LT(calls, 200);
    const FileFault fault(40);
    message = this->call(
      gathered,
      [&](std::int64_t piece)
      {
        ++pieceCalls;
        return this->pieces(piece);
      },
      [&](StreamedBlock&& block) { gathered(std::move(block)); });
  }
  EXPECT_GT(calls, 4);
  EXPECT_EQ(pieceCalls, 4);
}

TEST_F(StreamedRunFaults, OfWhoReads)
{
  for (std::int64_t failing = 0; failing < this->pieces.count; ++failing)
  {
    Gathered gathered;
    const auto write = [&](StreamedBlock&& block) { gathered(std::move(block)); };
    EXPECT_EQ(
      this->call(
        gathered,
        [&](std::int64_t piece)
        { return piece == failing ? throw std::runtime_error("no tape") : this->pieces(piece); },
        write),
      "no tape");
    this->expectGoesOn(gathered);
    const std::size_t count = this->pieces(failing).positions.size() / 3;
    if (count == 0)
    {
      continue;
    }
    const auto withNaN = [&](std::int64_t piece)
    {
      StreamPiece points = this->pieces(piece);
      if (piece == failing)
      {
        points.positions[3 * count - 2] = std::numeric_limits<double>::quiet_NaN();
      }
      return points;
    };
    EXPECT_EQ(this->call(gathered, withNaN, write),
      "piece " + std::to_string(failing) + ", point " + std::to_string(count - 1) +
        " of 1: a coordinate or weight is NaN or infinite");
    this->expectGoesOn(gathered);
    EXPECT_EQ(this->call(
                gathered,
                [&](std::int64_t piece)
                {
                  StreamPiece points = this->pieces(piece);
                  points.records.pop_back();
                  return points;
                },
                write),
      "piece 0, point -1 of 0: a piece must have three numbers and one record a point");
    this->expectGoesOn(gathered);
  }
}

TEST_F(StreamedRunFaults, OfWhoWrites)
{
  for (int failing = 1; failing <= 5; ++failing)
  {
    Gathered gathered;
    int calls = 0;
    EXPECT_EQ(this->call(gathered, this->pieces,
                [&](StreamedBlock&& block)
                {
                  if (++calls == failing)
                  {
                    throw std::runtime_error("enough");
                  }
                  gathered(std::move(block));
                }),
      "enough");
    EXPECT_EQ(calls, failing) << "nothing comes after an error";
    this->expectGoesOn(gathered);
    EXPECT_EQ(gathered.calls, 5) << "no block comes twice";
  }
}

/// While its loop waits, a thread must not be given another block.
TEST_F(StreamedRunFaults, NoneOfLoopsOfWhoWrites)
{
  this->settings.blockPoints = 5;
  this->settings.options.threads = 4;
  Gathered gathered;
  EXPECT_EQ(this->call(gathered, this->pieces,
              [&](StreamedBlock&& block)
              {
                std::atomic<int> sum{ 0 };
                threads::eachAlone(16,
                  [&](std::size_t)
                  {
                    std::this_thread::sleep_for(std::chrono::microseconds(100));
                    ++sum;
                  });
                EXPECT_EQ(sum, 16);
                gathered(std::move(block));
              }),
    "");
}

struct Stop
{
  int calls;

  static bool after(double, void* self) { return --static_cast<Stop*>(self)->calls > 0; }
};

TEST_F(StreamedRunFaults, AbortAtAnyCall)
{
  int aborted = 0;
  bool ended = false;
  for (int calls = 1; !ended && !HasFailure(); calls += isSanitized() ? 5 : 1)
  {
    Gathered gathered;
    Stop stop{ calls };
    this->settings.options.progress = &Stop::after;
    this->settings.options.progressContext = &stop;
    const std::string message = this->call(gathered);
    this->settings.options.progress = nullptr;
    ended = message.empty();
    aborted += message == "aborted on request";
    EXPECT_TRUE(ended || message == "aborted on request") << message;
    if (!ended)
    {
      this->expectGoesOn(gathered);
    }
  }
  EXPECT_GT(aborted, isSanitized() ? 3 : 15);
}

#ifndef _WIN32
/// Files may have no more than so many bytes.
TEST_F(StreamedRunFaults, OfAFullDisk)
{
  const auto before = std::signal(SIGXFSZ, SIG_IGN);
  rlimit usual{};
  getrlimit(RLIMIT_FSIZE, &usual);
  int failures = 0;
  for (rlim_t most = 100; most < 60000; most += most / 2)
  {
    Gathered gathered;
    rlimit limit = usual;
    limit.rlim_cur = most;
    setrlimit(RLIMIT_FSIZE, &limit);
    const std::string message = this->call(gathered);
    setrlimit(RLIMIT_FSIZE, &usual);
    if (!message.empty())
    {
      ++failures;
      EXPECT_NE(message.find("cannot write a file: File too large ["), std::string::npos)
        << message;
      EXPECT_NE(message.find(this->folder.path.string()), std::string::npos) << message;
      this->expectGoesOn(gathered);
    }
  }
  EXPECT_GT(failures, 8);
  std::signal(SIGXFSZ, before);
}
#endif

TEST_F(StreamedRunFaults, OfTheFolder)
{
  Gathered gathered;
  std::ofstream(this->folder.path) << "a file";
  EXPECT_NE(this->call(gathered).find(this->folder.path.string()), std::string::npos);
  fs::remove(this->folder.path);

  // What is not the run's stays.
  fs::create_directory(this->folder.path);
  std::ofstream(this->folder.path / "notes.txt") << "mine";
  EXPECT_EQ(this->call(gathered), "");
  EXPECT_TRUE(fs::exists(this->folder.path / "notes.txt"));
  EXPECT_EQ(this->folder.unfinished().size(), 1u);
  fs::remove_all(this->folder.path);

  {
    const FileFault fault(100);
    EXPECT_NE(this->call(gathered), "");
  }
  this->settings.options.facets = FacetMode::Polygons;
  EXPECT_EQ(this->call(gathered),
    "the folder has the files of another streamed run: its shape, facets, points that are not "
    "finite, pieces or records are others");
  this->settings.options.facets = FacetMode::Triangles;
  this->expectGoesOn(gathered);
}

/// Harm to each file of runs that were stopped. What is not an error is right.
class HarmedFiles : public StreamedRunFaults
{
protected:
  void expectNoticed(
    const std::function<void(const fs::path&)>& harm, const std::vector<std::string>& errors)
  {
    for (const int steps : { 20, 80, 150 })
    {
      std::set<fs::path> harmed;
      for (bool ended = false; !ended && !HasFailure();)
      {
        fs::remove_all(this->folder.path);
        Gathered gathered;
        {
          const FileFault fault(steps);
          EXPECT_NE(this->call(gathered), "");
        }
        ended = true;
        for (const fs::directory_entry& entry : fs::directory_iterator(this->folder.path))
        {
          if (harmed.insert(entry.path()).second)
          {
            SCOPED_TRACE(entry.path());
            harm(entry.path());
            const std::string message = this->call(gathered);
            EXPECT_TRUE(message.empty() ||
              std::any_of(errors.begin(), errors.end(),
                [&](const std::string& error) { return message.find(error) != message.npos; }))
              << message;
            ended = false;
            break;
          }
        }
      }
      EXPECT_GT(harmed.size(), 3u);
    }
  }
};

TEST_F(HarmedFiles, WithAnotherByte)
{
  this->expectNoticed(
    [](const fs::path& path)
    {
      std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
      const auto at = static_cast<std::streamoff>(fs::file_size(path) - 1);
      file.seekg(at);
      const int byte = file.get();
      file.seekp(at);
      file.put(static_cast<char>(byte ^ 1));
    },
    { "is damaged" });
}

TEST_F(HarmedFiles, OfAnotherVersion)
{
  this->expectNoticed(
    [](const fs::path& path)
    {
      std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
      file.seekp(7); // behind the name that all versions begin with
      file.put('1');
    },
    { "a file of a streamed run is of another version: remove its folder" });
}

TEST_F(HarmedFiles, ThatAreGone)
{
  this->expectNoticed([](const fs::path& path) { fs::remove(path); },
    { "cannot read a file", "files of a streamed run are missing: remove their folder" });
}

TEST_F(StreamedRunFaults, OfSettings)
{
  Gathered gathered;
  const StreamSettings good = this->settings;
  const auto wrong = [&](const std::function<void(StreamSettings&)>& change)
  {
    this->settings = good;
    change(this->settings);
    return this->call(gathered);
  };
  EXPECT_EQ(wrong([](StreamSettings& s) { s.folder.clear(); }),
    "a streamed run needs a folder for its files");
  EXPECT_EQ(wrong([](StreamSettings& s) { s.memory = 1000; }),
    "the memory of a streamed run must be a mebibyte or more");
  EXPECT_EQ(wrong([](StreamSettings& s) { s.blockPoints = -1; }),
    "the points of a block must be 0 or more");
  EXPECT_EQ(messageOf([&] { streamedRun(good, -1, this->pieces, std::ref(gathered)); }),
    "the number of pieces must be 0 or more");
  EXPECT_FALSE(fs::exists(this->folder.path));
}

/// A run whose files stay is not done again.
TEST_F(StreamedRunFaults, FilesThatAreKept)
{
  this->settings.keepFiles = true;
  for (int calls = 0; calls < 2; ++calls)
  {
    Gathered gathered;
    const StreamReport report =
      streamedRun(this->settings, 4, Pieces{ this->cloud, calls == 0 ? 4 : 0 }, std::ref(gathered));
    EXPECT_EQ(report.points, 600);
    EXPECT_EQ(gathered.calls, calls == 0 ? report.blocks : 0);
    EXPECT_TRUE(fs::exists(this->folder.path));
  }
  removeStreamedRun(this->folder.path);
  EXPECT_FALSE(fs::exists(this->folder.path));
}

/// The last piece has no point that is kept, and all before are stored.
TEST_F(StreamedRunFaults, PiecesOfNoPointsAreCounted)
{
  this->settings.options.nonFinite = NonFinitePolicy::Ignore;
  this->settings.memory = 1 << 20;
  Cloud points = randomSites(6000, 0.0001, 1);
  points.resize(6010, { NAN, 0, 0 });
  const StreamReport report = streamedRun(
    this->settings, 2,
    [&](std::int64_t piece)
    {
      const Cloud part(points.begin() + (piece ? 6000 : 0), points.begin() + (piece ? 6010 : 6000));
      return Pieces{ part, 1 }(0);
    },
    [](StreamedBlock&&) {});
  EXPECT_EQ(report.points, 6010);
  EXPECT_EQ(report.nonFinite, 10);
}

TEST_F(StreamedRunFaults, PointsThatAreNotFiniteAreLeftOut)
{
  this->settings.options.nonFinite = NonFinitePolicy::Ignore;
  Cloud holes = this->cloud;
  for (std::size_t i = 0; i < holes.size(); i += 7)
  {
    holes[i][i % 3] = std::numeric_limits<double>::infinity();
  }
  Gathered gathered;
  const StreamReport report = streamedRun(this->settings, 4, Pieces{ holes, 4 },
    [&](StreamedBlock&& block) { gathered(std::move(block)); });
  EXPECT_EQ(report.points, 600);
  EXPECT_EQ(report.nonFinite, 86);
  EXPECT_EQ(
    differenceFromOneRun(this->shape, holes, gathered.report(report), this->settings.options), "");
}

}

}
}
