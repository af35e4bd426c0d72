// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The points of all pieces, in files: first as they come, then dealt to blocks.
///
/// Pieces are joined to chunks, a file each, that memory holds easily. Each chunk has a sample.
/// When all are there, the samples' k-d tree gives each block its region, and each chunk is written
/// again, its points sorted by block. A block finds its points in all of these.
#ifndef flipflop_PointStore_h
#define flipflop_PointStore_h

#include "Stream/WorkFolder.h"
#include "Support/Monitor.h"
#include <flipflop/PointRegions.h>
#include <flipflop/StreamedRun.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace flipflop
{

/// How many points and blocks there are.
struct StoredCounts
{
  std::int64_t points = 0;
  std::int64_t nonFinite = 0;
  std::int64_t chunks = 0;
  std::int64_t blocks = 0;
};

class PointStore
{
public:
  /// @param memory that decides how large chunks are
  PointStore(
    WorkFolder& inFolder, const StreamSettings& chosen, std::int64_t memory, Monitor& ofRun);

  /// Store all pieces that are not stored yet.
  void read(std::int64_t pieces, const ReadPiece& readPiece);

  /// Sort all chunks by block that are not sorted yet.
  /// @param blocksFor how many blocks so many points are dealt to; an earlier call's number stays
  void deal(const std::function<std::int64_t(std::int64_t points)>& blocksFor);

  /// The points of a block; its records are written to the block's file, where recordsOf() finds
  /// them, if there are any.
  BlockPoints pointsOf(std::int64_t block) const;
  void storeRecords(std::int64_t block) const;

  /// The chunks are not needed any longer.
  void removeChunks();

  /// The records of a result's points, which may be in several blocks.
  std::vector<char> recordsOf(const BlockResult& result) const;

  /// After deal().
  const StoredCounts& counts() const { return this->found; }

private:
  struct Chunk;

  void add(StreamPiece&& piece, std::int64_t number, Chunk& chunk) const;
  void write(Chunk& chunk);
  void writeSample(std::size_t enough);
  void dealChunk(std::int64_t number, const PointRegions& regions) const;
  PointRegions::Key keyOf(const double* position) const;
  std::size_t countOf(std::int64_t block) const;
  template <class Use>
  void eachPart(std::int64_t block, const Use& use) const;

  WorkFolder& folder;
  const StreamSettings& settings;
  Monitor& monitor;
  const std::size_t rowSize; ///< bytes of a point in a file
  const std::size_t chunkPoints;
  StoredCounts found;
  std::vector<FileSections> dealt; ///< of each chunk
};

}

#endif
