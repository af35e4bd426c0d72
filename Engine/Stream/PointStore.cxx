// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Stream/PointStore.h"

#include "Blocks/MessageArchive.h"
#include "Support/EngineCall.h"
#include "Support/Parallel.h"
#include "Support/Threads.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace flipflop
{

namespace
{

using Key = PointRegions::Key;

/// What begins a point in a file. Its record follows.
struct StoredPoint
{
  std::int64_t id;
  double x[3];
};

StoredPoint pointOf(const char* row)
{
  StoredPoint point;
  std::memcpy(&point, row, sizeof(point));
  return point;
}

/// Sections of a chunk's file.
enum : std::int64_t
{
  HeadSection,
  PointsSection,
  SampleSection
};

/// Sections of a file of records.
enum : std::int64_t
{
  IdsSection,
  RecordsSection
};

/// Of a chunk, one point of so many is in the sample, or more if it is small.
constexpr std::size_t SampledOf = 128;
constexpr std::size_t LeastSampled = 8192;

constexpr std::size_t LeastChunk = 1024; ///< points
constexpr std::size_t MostChunk = std::size_t(1) << 22;

/// Spreads ids, so that a sample of regular data is not regular.
std::uint64_t mixed(std::uint64_t id)
{
  return (id * 0x9e3779b97f4a7c15) >> 32;
}

}

/// Pieces that are stored together.
struct PointStore::Chunk
{
  struct Head
  {
    std::int64_t number;
    std::int64_t endPiece; ///< past the last
    StoredCounts found;    ///< with all chunks before
  } head{};
  std::vector<char> rows;
};

PointStore::PointStore(
  WorkFolder& inFolder, const StreamSettings& chosen, std::int64_t memory, Monitor& ofRun)
  : folder(inFolder)
  , settings(chosen)
  , monitor(ofRun)
  , rowSize(sizeof(StoredPoint) + chosen.recordSize)
  , chunkPoints(
      std::clamp(static_cast<std::size_t>(memory) / (6 * this->rowSize), LeastChunk, MostChunk))
{
}

Key PointStore::keyOf(const double* x) const
{
  return { x[0], x[1], this->settings.shape == BlockShape::Hull ? x[2] : 0.0 };
}

void PointStore::read(std::int64_t pieces, const ReadPiece& readPiece)
{
  if (this->folder.has("counts"))
  {
    this->found = valueOf<StoredCounts>(this->folder.read("counts"));
    return;
  }
  Chunk chunk;
  for (const auto& input : this->folder.numbered("input-"))
  {
    chunk.head = valueOf<Chunk::Head>(this->folder.read(input.second, HeadSection));
    ensure(chunk.head.number == input.first && chunk.head.endPiece <= pieces);
    this->found = chunk.head.found;
    this->found.chunks = input.first + 1;
  }
  std::int64_t stored = chunk.head.endPiece;
  this->monitor.stage(0.0, 0.1, pieces, "storing points");
  for (std::int64_t piece = chunk.head.endPiece; piece < pieces; ++piece)
  {
    this->add(callersFunction([&] { return readPiece(piece); }), piece, chunk);
    if (chunk.rows.size() >= this->chunkPoints * this->rowSize)
    {
      this->write(chunk);
      stored = piece + 1;
    }
    this->monitor.advance(1);
  }
  // Also where only points came that are not finite, or none.
  if (chunk.head.endPiece > stored || this->found.chunks == 0)
  {
    this->write(chunk);
  }
}

void PointStore::add(StreamPiece&& piece, std::int64_t number, Chunk& chunk) const
{
  const std::size_t count = piece.positions.size() / 3;
  if (piece.positions.size() != 3 * count ||
    piece.records.size() != count * this->settings.recordSize)
  {
    throw PieceError(badArgument("a piece must have three numbers and one record a point"), number);
  }
  StoredCounts& sum = chunk.head.found;
  chunk.head.endPiece = number + 1;
  std::int64_t first = -1;
  std::int64_t wrong = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    StoredPoint point{ sum.points + static_cast<std::int64_t>(i), {} };
    std::copy_n(piece.positions.data() + 3 * i,
      this->settings.shape == BlockShape::Delaunay ? 2 : 3, point.x);
    if (!std::all_of(point.x, point.x + 3, [](double x) { return std::isfinite(x); }))
    {
      first = first < 0 ? static_cast<std::int64_t>(i) : first;
      ++wrong;
      continue;
    }
    const auto* const bytes = reinterpret_cast<const char*>(&point);
    chunk.rows.insert(chunk.rows.end(), bytes, bytes + sizeof(point));
    const auto record =
      piece.records.begin() + static_cast<std::ptrdiff_t>(i * this->settings.recordSize);
    chunk.rows.insert(
      chunk.rows.end(), record, record + static_cast<std::ptrdiff_t>(this->settings.recordSize));
  }
  if (wrong > 0 && this->settings.options.nonFinite == NonFinitePolicy::Error)
  {
    throw PieceError(Error(ErrorCode::NonFinite, first, wrong), number);
  }
  sum.points += static_cast<std::int64_t>(count);
  sum.nonFinite += wrong;
}

void PointStore::write(Chunk& chunk)
{
  const std::size_t count = chunk.rows.size() / this->rowSize;
  // The same share of each chunk, unless there is one alone.
  const std::size_t size = this->found.chunks > 0 ? this->chunkPoints : count;
  const std::size_t step = std::clamp(size / LeastSampled, std::size_t(1), SampledOf);
  std::vector<Key> sample;
  for (std::size_t i = 0; i < count; ++i)
  {
    const StoredPoint point = pointOf(chunk.rows.data() + i * this->rowSize);
    if (mixed(static_cast<std::uint64_t>(point.id)) % step == 0)
    {
      sample.push_back(this->keyOf(point.x));
    }
  }
  chunk.head.number = this->found.chunks;
  std::map<std::int64_t, std::vector<char>> sections;
  sections.emplace(HeadSection, toBytes(chunk.head));
  sections.emplace(PointsSection, std::exchange(chunk.rows, {}));
  sections.emplace(SampleSection, toBytes(sample));
  this->folder.write(nameOf("input-", chunk.head.number), sections);
  this->found = chunk.head.found;
  this->found.chunks = chunk.head.number + 1;
}

void PointStore::deal(const std::function<std::int64_t(std::int64_t points)>& blocksFor)
{
  if (!this->folder.has("counts"))
  {
    // Of all chunks, before the first of them is sorted.
    const std::int64_t kept = this->found.points - this->found.nonFinite;
    this->found.blocks = blocksFor(kept);
    if (this->found.blocks > std::numeric_limits<int>::max())
    {
      throw Error(ErrorCode::TooManyPoints, -1, kept);
    }
    this->writeSample(PointRegions::sampleSize(static_cast<std::size_t>(this->found.blocks)));
    this->folder.write("counts", toBytes(this->found));
  }
  this->monitor.stage(0.1, 0.2, this->found.chunks, "dealing points to blocks");
  const PointRegions regions(
    valueOf<std::vector<Key>>(this->folder.read("sample")), static_cast<int>(this->found.blocks));
  for (std::int64_t chunk = 0; chunk < this->found.chunks; ++chunk)
  {
    if (!this->folder.has(nameOf("dealt-", chunk)))
    {
      this->dealChunk(chunk, regions);
    }
    this->folder.remove(nameOf("input-", chunk));
    this->dealt.push_back(this->folder.sections(nameOf("dealt-", chunk)));
    this->monitor.advance(1);
  }
}

/// Of the chunks' samples together as many as are enough, or a few more.
void PointStore::writeSample(std::size_t enough)
{
  std::vector<FileSection> parts;
  std::size_t all = 0;
  for (std::int64_t chunk = 0; chunk < this->found.chunks; ++chunk)
  {
    const FileSections sections = this->folder.sections(nameOf("input-", chunk));
    const FileSection* const part = sectionOf(sections, SampleSection);
    ensure(part);
    parts.push_back(*part);
    all += static_cast<std::size_t>(part->size - sizeof(std::size_t)) / sizeof(Key);
  }
  const std::size_t step = std::max<std::size_t>(1, all / enough);
  std::vector<Key> sample;
  std::size_t at = 0;
  for (std::int64_t chunk = 0; chunk < this->found.chunks; ++chunk)
  {
    const FileSection& part = parts[static_cast<std::size_t>(chunk)];
    for (const Key& key :
      valueOf<std::vector<Key>>(this->folder.read(nameOf("input-", chunk), part)))
    {
      if (at++ % step == 0)
      {
        sample.push_back(key);
      }
    }
  }
  this->folder.write("sample", toBytes(sample));
}

void PointStore::dealChunk(std::int64_t number, const PointRegions& regions) const
{
  const std::vector<char> rows = this->folder.read(nameOf("input-", number), PointsSection);
  ensure(rows.size() % this->rowSize == 0);
  const std::size_t count = rows.size() / this->rowSize;
  std::vector<int> region(count);
  constexpr std::size_t PointsPerTask = 1 << 12;
  ArenaLoan arena(threadCount(this->settings.options.threads, static_cast<std::int64_t>(count)));
  arena.execute(
    [&]
    {
      eachChunk(count, PointsPerTask,
        [&](std::size_t begin, std::size_t end, std::size_t)
        {
          std::vector<Key> keys;
          for (std::size_t i = begin; i < end; ++i)
          {
            keys.push_back(this->keyOf(pointOf(rows.data() + i * this->rowSize).x));
          }
          regions.find(keys.data(), keys.size(), region.data() + begin);
        });
    });
  std::vector<std::size_t> sizes(static_cast<std::size_t>(this->found.blocks));
  for (const int block : region)
  {
    sizes[static_cast<std::size_t>(block)] += this->rowSize;
  }
  std::map<std::int64_t, std::vector<char>> sections;
  std::vector<std::vector<char>*> sectionOf(sizes.size());
  for (std::size_t block = 0; block < sizes.size(); ++block)
  {
    if (sizes[block] > 0)
    {
      sectionOf[block] = &sections[static_cast<std::int64_t>(block)];
      sectionOf[block]->reserve(sizes[block]);
    }
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    std::vector<char>& section = *sectionOf[static_cast<std::size_t>(region[i])];
    const auto row = rows.begin() + static_cast<std::ptrdiff_t>(i * this->rowSize);
    section.insert(section.end(), row, row + static_cast<std::ptrdiff_t>(this->rowSize));
  }
  this->folder.write(nameOf("dealt-", number), sections);
}

/// use(rows) for each chunk that has points of a block.
template <class Use>
void PointStore::eachPart(std::int64_t block, const Use& use) const
{
  for (std::size_t chunk = 0; chunk < this->dealt.size(); ++chunk)
  {
    const FileSection* const section = sectionOf(this->dealt[chunk], block);
    if (section)
    {
      const std::vector<char> rows =
        this->folder.read(nameOf("dealt-", static_cast<std::int64_t>(chunk)), *section);
      ensure(rows.size() % this->rowSize == 0);
      use(rows);
    }
  }
}

std::size_t PointStore::countOf(std::int64_t block) const
{
  std::uint64_t size = 0;
  for (const FileSections& sections : this->dealt)
  {
    const FileSection* const section = sectionOf(sections, block);
    size += section ? section->size : 0;
  }
  return static_cast<std::size_t>(size) / this->rowSize;
}

BlockPoints PointStore::pointsOf(std::int64_t block) const
{
  BlockPoints points;
  const std::size_t count = this->countOf(block);
  points.positions.allocate(3 * count);
  points.ids.allocate(count);
  std::size_t i = 0;
  this->eachPart(block,
    [&](const std::vector<char>& rows)
    {
      for (std::size_t at = 0; at < rows.size(); at += this->rowSize, ++i)
      {
        const StoredPoint point = pointOf(rows.data() + at);
        std::copy_n(point.x, 3, points.positions.data() + 3 * i);
        points.ids[i] = point.id;
      }
    });
  return points;
}

void PointStore::storeRecords(std::int64_t block) const
{
  if (this->settings.recordSize == 0)
  {
    return;
  }
  std::vector<std::int64_t> ids;
  std::vector<char> records;
  const std::size_t count = this->countOf(block);
  ids.reserve(count);
  records.reserve(count * this->settings.recordSize);
  this->eachPart(block,
    [&](const std::vector<char>& rows)
    {
      for (auto row = rows.begin(); row != rows.end();
           row += static_cast<std::ptrdiff_t>(this->rowSize))
      {
        ids.push_back(pointOf(&*row).id);
        records.insert(records.end(), row + sizeof(StoredPoint),
          row + static_cast<std::ptrdiff_t>(this->rowSize));
      }
    });
  std::map<std::int64_t, std::vector<char>> sections;
  sections.emplace(IdsSection, toBytes(ids));
  sections.emplace(RecordsSection, std::move(records));
  this->folder.write(nameOf("records-", block), sections);
}

void PointStore::removeChunks()
{
  this->dealt.clear();
  this->folder.removeNumbered("dealt-");
}

std::vector<char> PointStore::recordsOf(const BlockResult& result) const
{
  const std::size_t size = this->settings.recordSize;
  const std::size_t count = size > 0 ? result.blocks.size() : 0;
  std::vector<char> records(count * size);
  std::map<std::int32_t, std::vector<std::size_t>> corners; // of each block
  for (std::size_t i = 0; i < count; ++i)
  {
    corners[result.blocks[i]].push_back(i);
  }
  for (const auto& [block, members] : corners)
  {
    const std::string name = nameOf("records-", block);
    const FileSections sections = this->folder.sections(name);
    const FileSection* const section = sectionOf(sections, RecordsSection);
    ensure(section);
    const auto ids = valueOf<std::vector<std::int64_t>>(this->folder.read(name, IdsSection));
    const auto rowOf = [&](std::size_t i)
    {
      const std::int64_t id = result.cells.pointIds[i];
      const auto found = std::lower_bound(ids.begin(), ids.end(), id);
      ensure(found != ids.end() && *found == id);
      return static_cast<std::size_t>(found - ids.begin());
    };
    if (members.size() > ids.size() / 8) // nearly all, one after another
    {
      const std::vector<char> all = this->folder.read(name, *section);
      for (const std::size_t i : members)
      {
        std::copy_n(all.data() + rowOf(i) * size, size, records.data() + i * size);
      }
      continue;
    }
    WorkFolder::Rows rows(this->folder, name, *section);
    for (const std::size_t i : members)
    {
      rows.read(rowOf(i), size, records.data() + i * size);
    }
  }
  return records;
}

}
