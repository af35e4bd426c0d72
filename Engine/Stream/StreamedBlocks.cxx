// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Stream/StreamedBlocks.h"

#include "Blocks/MessageArchive.h"
#include "Support/EngineCall.h"
#include "Support/Threads.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace flipflop
{

namespace
{

/// glibc keeps what a block has freed, in pieces that do not fit the next one: ten blocks of 1e6
/// points took 947 MB, and take half so. For steps that need the most: it takes time.
void giveFreeMemoryBack()
{
#if defined(__GLIBC__)
  malloc_trim(0);
#endif
}

/// The round whose files are all there, and how many these are, with those of earlier rounds.
struct RoundMark
{
  std::int64_t round, files;
};
const char* const RoundFile = "round";

/// Of a block's file. The other sections are its queries, by the block that receives them.
constexpr std::int64_t StateSection = -1;

/// What a block adds to the report.
struct Taken
{
  std::int64_t hidden, cells, received, dimension;
  BlockMeasure measure;
};

/// Files of a round can be listed by this, and a number.
std::string nameOfRound(const char* prefix, std::int64_t round)
{
  return nameOf(prefix, round) + "-";
}

/// A ProgressFunction of a block's runs: they report nothing, and stop when the whole does.
bool goesOn(double, void* monitor)
{
  const DefaultFloatingPointEnvironment environment; // it is called in the caller's
  try
  {
    static_cast<Monitor*>(monitor)->poll();
    return true;
  }
  catch (const Error&)
  {
    return false;
  }
}

/// A point that may be the lowest of all by id.
struct Lowest
{
  std::int64_t id = std::numeric_limits<std::int64_t>::max();
  double x[3] = {};
};

}

StreamedBlocks::StreamedBlocks(WorkFolder& inFolder, PointStore& allPoints,
  const StreamSettings& chosen, Monitor& ofRun, int threadsOfRun)
  : folder(inFolder)
  , points(allPoints)
  , settings(chosen)
  , monitor(ofRun)
  , threads(threadsOfRun)
  , options(chosen.options)
  , all(static_cast<std::size_t>(allPoints.counts().blocks))
  , rounds(this->all.size())
{
  this->options.threads = 1;
  this->options.progress = goesOn;
  this->options.progressContext = &ofRun;
  this->options.step = nullptr;
  std::iota(this->all.begin(), this->all.end(), std::int64_t(0));
}

bool StreamedBlocks::haveBegun(const WorkFolder& folder)
{
  return folder.has(RoundFile);
}

void StreamedBlocks::stage(double from, double to, const char* name, const Numbers& blocks,
  const std::string& files, const MakeFile& make)
{
  this->monitor.stage(from, to, static_cast<std::int64_t>(blocks.size()), name);
  std::mutex mutex;
  std::exception_ptr failure;
  std::atomic<bool> failed{ false };
  runSideBySide(blocks.size(), this->threads,
    [&](std::size_t i)
    {
      try
      {
        if (!failed)
        {
          this->monitor.poll();
          const std::string file = nameOf(files, blocks[i]);
          if (!this->folder.has(file))
          {
            make(blocks[i], file);
          }
          this->monitor.advance(1);
        }
      }
      catch (...)
      {
        const std::lock_guard<std::mutex> lock(mutex);
        failed = true;
        failure = failure ? failure : std::current_exception();
      }
    });
  if (failure)
  {
    std::rethrow_exception(failure);
  }
}

void StreamedBlocks::run(const WriteBlock& write, StreamReport& report)
{
  this->summarize();
  this->begin();
  while (this->exchange())
  {
  }
  this->finish(write, report);
}

void StreamedBlocks::summarize()
{
  if (!this->folder.has("summaries"))
  {
    this->folder.requireAll(!haveBegun(this->folder), "summaries");
    this->stage(0.2, 0.3, "looking at blocks", this->all, "summary-",
      [this](std::int64_t block, const std::string& file)
      {
        const BlockRun run(this->settings.shape, this->points.pointsOf(block), this->options);
        this->folder.write(file, run.summary());
      });
    std::map<std::int64_t, std::vector<char>> sections;
    for (const std::int64_t block : this->all)
    {
      sections[block] = this->folder.read(nameOf("summary-", block));
    }
    this->folder.write("summaries", sections);
  }
  this->folder.removeNumbered("summary-");
  std::vector<BlockMessage> messages;
  for (const FileSection& section : this->folder.sections("summaries"))
  {
    messages.push_back(this->folder.read("summaries", section));
  }
  Options quiet = this->options;
  quiet.threads = this->settings.options.threads;
  this->summaries = BlockSummaries(this->settings.shape, messages, quiet);
}

void StreamedBlocks::begin()
{
  if (!haveBegun(this->folder))
  {
    this->stage(0.3, 0.6, "triangulating blocks", this->all, nameOfRound("block-", 0),
      [this](std::int64_t block, const std::string& file)
      {
        this->beginBlock(block, file);
        giveFreeMemoryBack();
      });
    this->endRound(0);
  }
  this->points.removeChunks();
  const auto mark = valueOf<RoundMark>(this->folder.read(RoundFile));
  this->round = mark.round;
  std::int64_t files = 0;
  for (std::int64_t number = 0; number <= this->round; ++number)
  {
    files += this->beginRound(number);
  }
  this->folder.requireAll(files == mark.files, "block-*");
}

/// Marks that all files of a round are there.
void StreamedBlocks::endRound(std::int64_t number)
{
  RoundMark mark{ number, 0 };
  for (std::int64_t i = 0; i <= number; ++i)
  {
    mark.files += static_cast<std::int64_t>(this->folder.numbered(nameOfRound("block-", i)).size());
  }
  this->folder.write(RoundFile, toBytes(mark));
}

void StreamedBlocks::beginBlock(std::int64_t block, const std::string& file)
{
  this->points.storeRecords(block);
  BlockRun run(this->settings.shape, this->points.pointsOf(block), this->options);
  run.begin(this->summaries, static_cast<int>(block));
  this->folder.write(nameOf("points-", block), run.savePoints());
  this->save(run, file);
}

std::string StreamedBlocks::stateOf(std::int64_t block, std::int64_t ofRound) const
{
  return nameOf(nameOfRound("block-", ofRound), block);
}

BlockRun StreamedBlocks::restored(std::int64_t block, Cells cells) const
{
  const Numbers& saved = this->rounds[static_cast<std::size_t>(block)];
  std::vector<BlockMessage> messages;
  for (const std::int64_t ofRound : saved)
  {
    if (cells == Cells::All || ofRound == saved.back())
    {
      messages.push_back(this->folder.read(this->stateOf(block, ofRound), StateSection));
    }
  }
  return { this->folder.read(nameOf("points-", block)), messages, this->options, this->summaries };
}

/// What the block has found in a round, with its queries.
void StreamedBlocks::save(BlockRun& run, const std::string& file)
{
  std::map<std::int64_t, std::vector<char>> sections;
  for (auto& [receiver, queries] : run.makeQueries())
  {
    sections.emplace(receiver, std::move(queries));
  }
  sections.emplace(StateSection, run.save());
  this->folder.write(file, sections);
}

/// Replies of the round before are not needed any longer.
/// @return how many blocks were saved after that round
std::int64_t StreamedBlocks::beginRound(std::int64_t number)
{
  const auto states = this->folder.numbered(nameOfRound("block-", number));
  for (const auto& file : states)
  {
    this->rounds[static_cast<std::size_t>(file.first)].push_back(number);
  }
  if (number > 0)
  {
    this->folder.removeNumbered(nameOfRound("replies-", number - 1));
  }
  return static_cast<std::int64_t>(states.size());
}

/// One round. Returns whether any block had a query.
bool StreamedBlocks::exchange()
{
  using Files = std::map<std::int64_t, FileSections>; // by the block that sends the messages
  Files queries;
  std::map<std::int64_t, Numbers> senders; // to each block that receives
  Numbers querying;
  for (const auto& [block, name] : this->folder.numbered(nameOfRound("block-", this->round)))
  {
    FileSections sections = this->folder.sections(name);
    sections.erase(sections.begin()); // the StateSection
    for (const FileSection& section : sections)
    {
      senders[section.key].push_back(block);
    }
    if (!sections.empty())
    {
      querying.push_back(block);
      queries[block] = std::move(sections);
    }
  }
  if (querying.empty())
  {
    return false;
  }
  Numbers replying;
  for (const auto& receiver : senders)
  {
    replying.push_back(receiver.first);
  }
  const std::string repliesOf = nameOfRound("replies-", this->round);
  this->stage(0.6, 0.8, "replying to queries", replying, repliesOf,
    [&](std::int64_t block, const std::string& file)
    {
      BlockRun run = this->restored(block, Cells::ToCome);
      std::map<std::int64_t, std::vector<char>> sections;
      for (const std::int64_t sender : senders.at(block))
      {
        sections[sender] = run.reply(this->folder.read(
          this->stateOf(sender, this->round), *sectionOf(queries.at(sender), block)));
      }
      this->folder.write(file, sections);
    });
  Files replies;
  for (const std::int64_t block : replying)
  {
    replies[block] = this->folder.sections(nameOf(repliesOf, block));
  }
  this->stage(0.6, 0.8, "adding replies", querying, nameOfRound("block-", this->round + 1),
    [&](std::int64_t block, const std::string& file)
    {
      BlockRun run = this->restored(block, Cells::ToCome);
      for (const FileSection& query : queries.at(block))
      {
        const FileSection* const reply = sectionOf(replies.at(query.key), block);
        ensure(reply);
        run.receive(
          static_cast<int>(query.key), this->folder.read(nameOf(repliesOf, query.key), *reply));
      }
      this->save(run, file);
    });
  this->endRound(++this->round);
  this->beginRound(this->round);
  return true;
}

void StreamedBlocks::finish(const WriteBlock& write, StreamReport& report)
{
  const std::vector<double> origin =
    this->settings.shape == BlockShape::Hull ? this->lowestPoint() : std::vector<double>();
  this->stage(0.85, 1.0, "writing cells", this->all, "taken-",
    [&](std::int64_t block, const std::string& file)
    {
      this->take(block, file, origin, write);
      giveFreeMemoryBack();
    });
  BlockMeasure measure;
  for (const std::int64_t block : this->all)
  {
    const auto taken = valueOf<Taken>(this->folder.read(nameOf("taken-", block)));
    report.hidden += taken.hidden;
    report.cells += taken.cells;
    report.pointsReceived += taken.received;
    report.dimension = std::max(report.dimension, static_cast<int>(taken.dimension));
    measure += taken.measure;
  }
  if (!origin.empty())
  {
    this->restored(0, Cells::ToCome).sizeOf(measure, report.volume, report.area);
  }
}

/// The corner of lowest id, from which blocks measure their share of a hull; none of no points.
std::vector<double> StreamedBlocks::lowestPoint()
{
  this->stage(0.8, 0.85, "measuring", this->all, "lowest-",
    [this](std::int64_t block, const std::string& file)
    {
      const BlockResult result = this->restored(block, Cells::All).finish();
      const auto& ids = result.cells.pointIds;
      const auto at = std::min_element(ids.begin(), ids.end()) - ids.begin();
      Lowest lowest;
      if (!ids.empty())
      {
        lowest.id = ids[static_cast<std::size_t>(at)];
        std::copy_n(result.positions.data() + 3 * at, 3, lowest.x);
      }
      this->folder.write(file, toBytes(lowest));
    });
  Lowest lowest;
  for (const std::int64_t block : this->all)
  {
    const auto other = valueOf<Lowest>(this->folder.read(nameOf("lowest-", block)));
    lowest = other.id < lowest.id ? other : lowest;
  }
  return lowest.id == Lowest().id ? std::vector<double>()
                                  : std::vector<double>(lowest.x, lowest.x + 3);
}

void StreamedBlocks::take(std::int64_t block, const std::string& file,
  const std::vector<double>& origin, const WriteBlock& write)
{
  BlockRun run = this->restored(block, Cells::All);
  StreamedBlock streamed;
  streamed.number = block;
  streamed.result = run.finish();
  const CellComplex& cells = streamed.result.cells;
  Taken taken{ static_cast<std::int64_t>(streamed.result.hiddenIds.size()), cells.cellCount(),
    run.pointsReceived(), cells.dimension, {} };
  if (!origin.empty())
  {
    taken.measure = run.measure(streamed.result, origin.data());
  }
  streamed.records = this->points.recordsOf(streamed.result);
  const std::lock_guard<std::mutex> lock(this->writing);
  if (this->writeFailed)
  {
    return; // nothing comes after an error
  }
  this->writeFailed = true;
  // Loops of the caller's must not be given another block, which would wait for the lock.
  threads::isolated([&] { callersFunction([&] { write(std::move(streamed)); }); });
  this->writeFailed = false;
  this->folder.write(file, toBytes(taken));
}

}
