// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Blocks that wait in files have the cells of one run on all points, bit for bit; whatever fails
/// is an error that says what, and leaves no file.
#include "Testing/Engine/Blocks/BlocksInProcess.h"
#include "Testing/Engine/Conformance/RandomCases.h"
#include "Testing/Engine/Inputs/InputsWeighted.h"
#include "vtkFFStreamedBlocks.h"

#include <flipflop/Error.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <functional>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>

#include <sys/resource.h>
#include <unistd.h>

namespace flipflop
{
namespace test
{

namespace
{

/// A folder that must be empty again.
class Folder
{
public:
  Folder()
    : path(
        std::filesystem::temp_directory_path() / ("TestStreamedBlocks-" + std::to_string(getpid())))
  {
    std::filesystem::create_directory(this->path);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder()
  {
    EXPECT_TRUE(std::filesystem::is_empty(this->path));
    std::filesystem::remove_all(this->path);
  }

  const std::filesystem::path path;
};

/// The points in pieces of unlike sizes, some of them empty.
struct Pieces
{
  const Cloud& cloud;
  int count;

  std::size_t beginOf(vtkIdType piece) const
  {
    const auto k = static_cast<std::size_t>(std::min<vtkIdType>(piece, this->count - 1));
    const std::size_t share =
      this->cloud.size() * k * k / static_cast<std::size_t>(this->count * this->count);
    return piece == this->count ? this->cloud.size() : share;
  }
  std::vector<double> operator()(vtkIdType piece) const
  {
    std::vector<double> positions;
    for (std::size_t i = this->beginOf(piece); i < this->beginOf(piece + 1); ++i)
    {
      positions.insert(positions.end(), this->cloud[i].begin(), this->cloud[i].end());
    }
    return positions;
  }
};

vtkFFStreamedBlocks::SettingsType settingsOf(
  BlockShape shape, int blocks, int inMemory, int threads, const Folder& folder)
{
  vtkFFStreamedBlocks::SettingsType settings;
  settings.Shape = shape;
  settings.NumberOfBlocks = blocks;
  settings.BlocksInMemory = inMemory;
  settings.Options.threads = threads;
  settings.Folder = folder.path.string();
  return settings;
}

/// What differs from one run; empty when nothing does.
std::string fault(BlockShape shape, Cloud cloud, int pieces, int blocks, int inMemory, int threads)
{
  for (Point& p : cloud)
  {
    p[2] = shape == BlockShape::Delaunay ? 0 : p[2];
  }
  const Folder folder;
  const auto settings = settingsOf(shape, blocks, inMemory, threads, folder);
  BlocksReport report;
  std::set<std::int64_t> ids;
  std::set<int> seen;
  vtkFFStreamedBlocks::Run(settings, pieces, Pieces{ cloud, pieces },
    [&](int block, BlockResult&& result)
    {
      report.fault = seen.insert(block).second ? report.fault : "a block comes twice";
      report.dimension = result.cells.dimension;
      const std::vector<Cell> cells = cellsOf(result.cells);
      report.cells.insert(report.cells.end(), cells.begin(), cells.end());
      ids.insert(result.cells.pointIds.begin(), result.cells.pointIds.end());
      report.hidden.insert(report.hidden.end(), result.hiddenIds.begin(), result.hiddenIds.end());
    });
  EXPECT_EQ(seen.size(), static_cast<std::size_t>(blocks));
  report.ids.assign(ids.begin(), ids.end());
  std::sort(report.cells.begin(), report.cells.end());
  std::sort(report.hidden.begin(), report.hidden.end());
  return differenceFromOneRun(shape, cloud, report, settings.Options);
}

class StreamedBlocks : public ::testing::TestWithParam<InputOf>
{
};

TEST_P(StreamedBlocks, AreOneRun)
{
  const Cloud cloud = this->GetParam().input.make();
  EXPECT_EQ(fault(BlockShape::RegularTriangulation, cloud, 3, 5, 2, 1), "");
  EXPECT_EQ(fault(BlockShape::Delaunay, cloud, 1, 3, 2, 2), "");
}

/// The special ones, and 400 points of each family.
std::vector<InputOf> inputsOf(const Kind& kind)
{
  std::vector<Input> inputs = kind.smallInputs();
  for (const FamilyOf& of : familiesOf(kind, { 400 }))
  {
    inputs.push_back(kind.family(of.name, of.count, 1));
  }
  return inputsOf(kind, inputs);
}

INSTANTIATE_TEST_SUITE_P(
  Triangulations, StreamedBlocks, ::testing::ValuesIn(inputsOf(regularTriangulations)));

TEST(StreamedBlocksOfMany, AreOneRun)
{
  const Cloud cloud = randomSites(100000, 0.0001, 1);
  EXPECT_EQ(fault(BlockShape::RegularTriangulation, cloud, 10, 16, 4, 2), "");
  EXPECT_EQ(fault(BlockShape::Delaunay, cloud, 10, 16, 1, 1), "");
}

/// What it throws, as words.
std::string messageOf(const std::function<void()>& call)
{
  try
  {
    call();
  }
  catch (const Error& error)
  {
    return error.code() == ErrorCode::Aborted ? "aborted" : error.what();
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
  return "";
}

class StreamedBlockErrors : public ::testing::Test
{
protected:
  /// Of a run in 8 blocks, 2 in memory.
  std::string messageOfRun(
    const vtkFFStreamedBlocks::PieceOf& pieceOf,
    const vtkFFStreamedBlocks::Use& use = [](int, BlockResult&&) {})
  {
    const Folder folder;
    return messageOf(
      [&]
      {
        vtkFFStreamedBlocks::Run(
          settingsOf(BlockShape::RegularTriangulation, 8, 2, 2, folder), 4, pieceOf, use);
      });
  }

  const Cloud cloud = randomSites(3000, 0.0001, 1);
  const Pieces pieces{ this->cloud, 4 };
};

TEST_F(StreamedBlockErrors, NameThePiece)
{
  for (int failing = 1; failing <= 8; ++failing)
  {
    int calls = 0;
    const std::string piece = "Piece " + std::to_string((failing - 1) % 4) + " of the points ";
    EXPECT_EQ(this->messageOfRun(
                [&](vtkIdType k)
                {
                  if (++calls == failing)
                  {
                    throw std::runtime_error("no tape");
                  }
                  return this->pieces(k);
                }),
      piece + "could not be read: no tape.");
    calls = 0;
    std::vector<double> given = this->pieces((failing - 1) % 4);
    if (given.empty())
    {
      continue;
    }
    EXPECT_EQ(this->messageOfRun(
                [&](vtkIdType k)
                {
                  std::vector<double> positions = this->pieces(k);
                  if (++calls == failing)
                  {
                    positions.back() = std::numeric_limits<double>::quiet_NaN();
                  }
                  return positions;
                }),
      piece + "has a coordinate or a weight that is NaN or infinite, at its point " +
        std::to_string(given.size() / 3 - 1) + ".");
  }
  EXPECT_EQ(this->messageOfRun([](vtkIdType) { return std::vector<double>(4); }),
    "Piece 0 of the points has 4 numbers, and not three a point.");
  int calls = 0;
  const std::size_t count = this->pieces(2).size() / 3;
  EXPECT_EQ(this->messageOfRun(
              [&](vtkIdType k)
              {
                std::vector<double> positions = this->pieces(k);
                positions.resize(++calls == 7 ? positions.size() - 3 : positions.size());
                return positions;
              }),
    "Piece 2 of the points has " + std::to_string(count - 1) + " points, and had " +
      std::to_string(count) + " when it was read first.");
}

TEST_F(StreamedBlockErrors, OfTheFolder)
{
  const Folder folder;
  auto settings = settingsOf(BlockShape::Delaunay, 8, 2, 1, folder);
  settings.Folder += "/none";
  EXPECT_EQ(messageOf([&]
              { vtkFFStreamedBlocks::Run(settings, 4, this->pieces, [](int, BlockResult&&) {}); }),
    "The folder \"" + settings.Folder + "\" for blocks that wait cannot be written.");
}

TEST_F(StreamedBlockErrors, OfWhoUsesTheResults)
{
  int calls = 0;
  EXPECT_EQ(this->messageOfRun(this->pieces,
              [&](int, BlockResult&&)
              {
                if (++calls == 3)
                {
                  throw std::runtime_error("enough");
                }
              }),
    "enough");
  EXPECT_EQ(calls, 3);
}

/// Files may have no more than so many bytes, as on a disk that is full.
TEST_F(StreamedBlockErrors, OfAFullDisk)
{
  const auto before = std::signal(SIGXFSZ, SIG_IGN);
  rlimit usual{};
  getrlimit(RLIMIT_FSIZE, &usual);
  int failures = 0;
  for (rlim_t most = 100; most < 60000; most += most / 2)
  {
    rlimit limit = usual;
    limit.rlim_cur = most;
    setrlimit(RLIMIT_FSIZE, &limit);
    const std::string message = this->messageOfRun(this->pieces);
    setrlimit(RLIMIT_FSIZE, &usual);
    failures += !message.empty();
    EXPECT_EQ(message,
      most < 40000        ? "A block cannot be written to the folder: it may be full."
        : message.empty() ? ""
                          : "A block cannot be written to the folder: it may be full.")
      << most;
  }
  EXPECT_EQ(this->messageOfRun(this->pieces), "");
  EXPECT_GT(failures, 8);
  std::signal(SIGXFSZ, before);
}

struct Stop
{
  int calls;

  static bool after(double, void* self) { return --static_cast<Stop*>(self)->calls > 0; }
};

TEST_F(StreamedBlockErrors, AbortAtAnyCall)
{
  int aborted = 0;
  bool ended = false;
  for (int calls = 1; !ended && calls < 100000; calls += 1 + calls / 4)
  {
    const Folder folder;
    auto settings = settingsOf(BlockShape::RegularTriangulation, 8, 2, 2, folder);
    Stop stop{ calls };
    settings.Options.progress = &Stop::after;
    settings.Options.progressContext = &stop;
    const std::string message = messageOf(
      [&] { vtkFFStreamedBlocks::Run(settings, 4, this->pieces, [](int, BlockResult&&) {}); });
    ended = message.empty();
    aborted += message == "aborted";
    EXPECT_TRUE(ended || message == "aborted") << message;
  }
  EXPECT_TRUE(ended);
  EXPECT_GT(aborted, 10);
}

}

}
}
