// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A streamed run has what one run has; a run that was stopped anywhere leaves whole files, and
/// goes on to the same bits.
#include "Stream/WorkFolder.h"
#include "Support/Parallel.h"
#include "Testing/Engine/Blocks/BlocksInProcess.h"
#include "Testing/Engine/Conformance/RandomCases.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"

#include <flipflop/Error.h>
#include <flipflop/StreamedRun.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
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

/// Made by a run, and removed by it.
class Folder
{
public:
  Folder()
    : path(
        fs::temp_directory_path() / ("TestStreamedRun-" + std::to_string(std::random_device()())))
  {
    fs::remove_all(this->path);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { fs::remove_all(this->path); }

  /// Names of files that are not whole.
  std::vector<std::string> unfinished() const
  {
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(this->path))
    {
      if (entry.path().extension() != ".flipflop")
      {
        names.push_back(entry.path().filename().string());
      }
    }
    return names;
  }

  const fs::path path;
};

/// The points in pieces of unlike sizes, some of them empty.
struct Pieces
{
  const Cloud& cloud;
  std::int64_t count;

  std::size_t beginOf(std::int64_t piece) const
  {
    const auto k = static_cast<std::size_t>(std::min(piece, this->count - 1));
    const auto all = static_cast<std::size_t>(this->count);
    return piece == this->count ? this->cloud.size() : this->cloud.size() * k * k / (all * all);
  }

  /// A record is the point's id.
  StreamPiece operator()(std::int64_t piece) const
  {
    const std::size_t begin = this->beginOf(piece);
    const std::size_t size = this->beginOf(piece + 1) - begin;
    StreamPiece points;
    points.positions.allocate(3 * size);
    points.records.resize(size * sizeof(std::int64_t));
    for (std::size_t i = 0; i < size; ++i)
    {
      const auto id = static_cast<std::int64_t>(begin + i);
      std::copy_n(this->cloud[begin + i].begin(), 3, points.positions.data() + 3 * i);
      std::memcpy(points.records.data() + i * sizeof(id), &id, sizeof(id));
    }
    return points;
  }
};

/// What all blocks of a run had, also if it went on several times.
struct Gathered
{
  std::map<std::int64_t, BlocksReport> blocks; ///< by number
  int calls = 0;
  std::string fault;

  void operator()(StreamedBlock&& block)
  {
    ++this->calls;
    BlocksReport& report = this->blocks[block.number];
    report = BlocksReport(); // a block may come again
    const CellComplex& cells = block.result.cells;
    report.dimension = cells.dimension;
    report.cells = cellsOf(cells);
    report.ids.assign(cells.pointIds.begin(), cells.pointIds.end());
    report.hidden.assign(block.result.hiddenIds.begin(), block.result.hiddenIds.end());
    std::vector<std::int64_t> records(cells.pointIds.size());
    if (block.records.size() != records.size() * sizeof(std::int64_t))
    {
      this->fault = "records of another size";
      return;
    }
    std::copy(block.records.begin(), block.records.end(), reinterpret_cast<char*>(records.data()));
    this->fault = records == report.ids ? this->fault : "the records of other points";
  }

  BlocksReport report(const StreamReport& of) const
  {
    BlocksReport all;
    std::set<std::int64_t> ids;
    for (const auto& [number, block] : this->blocks)
    {
      all.cells.insert(all.cells.end(), block.cells.begin(), block.cells.end());
      all.hidden.insert(all.hidden.end(), block.hidden.begin(), block.hidden.end());
      ids.insert(block.ids.begin(), block.ids.end());
    }
    all.ids.assign(ids.begin(), ids.end());
    std::sort(all.cells.begin(), all.cells.end());
    std::sort(all.hidden.begin(), all.hidden.end());
    all.dimension = of.dimension;
    all.volume = of.volume;
    all.area = of.area;
    all.fault = this->fault;
    if (static_cast<std::int64_t>(this->blocks.size()) != of.blocks ||
      static_cast<std::int64_t>(all.cells.size()) != of.cells ||
      static_cast<std::int64_t>(all.hidden.size()) != of.hidden)
    {
      all.fault = "other counts of blocks, cells or hidden points";
    }
    return all;
  }
};

StreamSettings settingsOf(
  BlockShape shape, std::int64_t blockPoints, int threads, const Folder& folder)
{
  StreamSettings settings;
  settings.shape = shape;
  settings.options.threads = threads;
  settings.blockPoints = blockPoints;
  settings.recordSize = sizeof(std::int64_t);
  settings.folder = folder.path;
  return settings;
}

/// What differs from one run; empty when nothing does.
std::string fault(BlockShape shape, Cloud cloud, std::int64_t pieces, int blocks, int threads)
{
  const Folder folder;
  StreamSettings settings =
    settingsOf(shape, static_cast<std::int64_t>(cloud.size()) / blocks + 1, threads, folder);
  settings.options.facets = blocks % 2 ? FacetMode::Polygons : FacetMode::Triangles;
  Gathered gathered;
  const StreamReport report =
    streamedRun(settings, pieces, Pieces{ cloud, pieces }, std::ref(gathered));
  EXPECT_EQ(report.points, static_cast<std::int64_t>(cloud.size()));
  EXPECT_EQ(gathered.calls, report.blocks);
  EXPECT_FALSE(fs::exists(folder.path));
  for (Point& p : cloud)
  {
    p[2] = shape == BlockShape::Delaunay ? 0 : p[2];
  }
  return differenceFromOneRun(shape, cloud, gathered.report(report), settings.options);
}

class StreamedRun : public ::testing::TestWithParam<InputOf>
{
};

TEST_P(StreamedRun, IsOneRun)
{
  const Cloud cloud = this->GetParam().input.make();
  const SmallSamples small;
  if (this->GetParam().kind->dimension == 3)
  {
    EXPECT_EQ(fault(BlockShape::Hull, cloud, 3, 5, 2), "");
    EXPECT_EQ(fault(BlockShape::Hull, cloud, 1, 4, 1), "");
    return;
  }
  EXPECT_EQ(fault(BlockShape::RegularTriangulation, cloud, 3, 5, 1), "");
  EXPECT_EQ(fault(BlockShape::Delaunay, cloud, 1, 4, 2), "");
}

INSTANTIATE_TEST_SUITE_P(Hulls, StreamedRun, ::testing::ValuesIn(blockInputs(convexHulls)));
INSTANTIATE_TEST_SUITE_P(
  Triangulations, StreamedRun, ::testing::ValuesIn(blockInputs(regularTriangulations)));

TEST(StreamedRunOfMany, IsOneRun)
{
  const Cloud cloud = randomSites(100000, 0.0001, 1);
  EXPECT_EQ(fault(BlockShape::RegularTriangulation, cloud, 10, 16, 2), "");
  EXPECT_EQ(fault(BlockShape::Delaunay, cloud, 100, 7, 1), "");
}

TEST(StreamedRunOfNothing, HasNoCells)
{
  EXPECT_EQ(fault(BlockShape::Delaunay, {}, 0, 1, 1), "");
  EXPECT_EQ(fault(BlockShape::Hull, {}, 5, 1, 1), "");
}

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
  const Folder folder;
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

/// Each file of a run that was stopped, changed in one byte.
TEST_F(StreamedRunFaults, OfDamagedFiles)
{
  for (const int steps : { 20, 80, 150 })
  {
    std::set<fs::path> damaged;
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
        if (damaged.insert(entry.path()).second)
        {
          std::fstream file(entry.path(), std::ios::in | std::ios::out | std::ios::binary);
          const auto at = static_cast<std::streamoff>(fs::file_size(entry.path()) - 1);
          file.seekg(at);
          const int byte = file.get();
          file.seekp(at);
          file.put(static_cast<char>(byte ^ 1));
          ended = false;
          break;
        }
      }
      const std::string message = this->call(gathered);
      EXPECT_TRUE(message.empty() || message.find("is damaged") != std::string::npos) << message;
    }
    EXPECT_GT(damaged.size(), 3u);
  }
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
