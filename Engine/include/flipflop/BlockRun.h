// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// One block's part of a hull or a triangulation of points that are distributed over blocks.
#ifndef flipflop_BlockRun_h
#define flipflop_BlockRun_h

#include <flipflop/Buffer.h>
#include <flipflop/CellComplex.h>
#include <flipflop/Options.h>

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace flipflop
{

/// What is built of the points of all blocks.
enum class BlockShape
{
  Hull,     ///< the convex hull in space; a point has x, y, z
  Delaunay, ///< the Delaunay triangulation in the plane; a point has x, y; its third number is not
            ///< read
  RegularTriangulation, ///< the regular triangulation in the plane; a point has x, y, and its
                        ///< weight
};

/// The points of a block.
struct BlockPoints
{
  Buffer<double> positions; ///< three for each point, as the shape has them; all finite
  Buffer<std::int64_t> ids; ///< of each point; ascending, and distinct over all blocks
};

/// A message between blocks: plain bytes, for machines of one kind.
using BlockMessage = std::vector<char>;

class BlockFrame;

/// The summaries of all blocks, read once for all blocks of a process. Copies share one memory.
class BlockSummaries
{
public:
  /// Of no blocks.
  BlockSummaries() = default;

  /// @param shape    what is built
  /// @param messages BlockRun::summary() of all blocks, by number
  /// @param options  of a run on their samples
  /// @throw Error    OutOfMemory, Aborted; Internal for a message that is damaged
  BlockSummaries(
    BlockShape shape, const std::vector<BlockMessage>& messages, const Options& options);

private:
  friend class BlockRun;
  std::shared_ptr<const BlockFrame> frame;
};

/// What a block has in the end: the cells of the facets whose first corner (by x, then y, then z)
/// is a point of the block. A hull that spans less than space is one facet; the block that has the
/// lowest id of all points has it.
struct BlockResult
{
  /// The cells in canonical form. Its pointIds are ids over all blocks, also of corners that other
  /// blocks have. Its dimension is that of all blocks' points together.
  CellComplex cells;

  /// x, y and z or weight of each of the cells' points.
  Buffer<double> positions;

  /// For each of the cells' points: the block that has it.
  Buffer<std::int32_t> blocks;

  /// The block's points that do not appear (in a hull: that are not strictly extreme), ascending.
  /// None of a hull that spans less than space: the block that has it alone knows its corners.
  Buffer<std::int64_t> hiddenIds;
};

/// A block's share of a hull's volume and area, in integers: shares add up, in any order.
struct BlockMeasure
{
  std::int64_t parts[4] = { 0, 0, 0, 0 }; ///< of the volume, two, and of the area

  /// Adds another block's.
  BlockMeasure& operator+=(const BlockMeasure& other)
  {
    for (int i = 0; i < 4; ++i)
    {
      this->parts[i] += other.parts[i];
    }
    return *this;
  }
};

/// A block finds the cells around each of its points. It triangulates its own points together with
/// a sample of all others. A cell is certain when no block has a point in conflict with it (inside
/// its orthocircle; for a hull, above its plane). The block sends a query to each block whose
/// bounds allow such a point. Replies hold points in conflict, which join the points that the block
/// has. The exact triangulation of these decides. So the cells of all blocks are those of one run
/// on all points, bit for bit, however points were distributed to blocks.
///
/// Use: one object for each block, on one process or many; messages go between them.
///
///     send all summaries() to all blocks;     begin(summaries, self);
///     repeat
///       queries = makeQueries();              // to other blocks, by number
///       replies = reply(queries);             // of every block that received some
///       receive(from, replies);               // of every block that was queried
///     until no block has any queries;         finish();
///
/// A block without queries may receive some later, and may have queries again after receive().
/// Points at the same position must be in the same block. The rounds end: each round in which a
/// block has queries brings it a point that it did not have, or makes a cell certain.
///
/// Between any two calls after begin(), the block can be saved as bytes, from which it can be made
/// again: savePoints() once, save() each time. So there may be more blocks than memory holds at
/// once.
class BlockRun
{
public:
  /// One block of many.
  /// @param shape   what is built; the same for all blocks
  /// @param points  of this block; not needed any longer after this
  /// @param options of each run; the same facets for all blocks
  /// @throw Error   BadArgument, NonFinite, TooManyPoints (in this block), OutOfMemory, Aborted;
  /// all
  ///                functions may, and Internal for a message that is damaged. The object is of no
  ///                use after that.
  BlockRun(BlockShape shape, const BlockPoints& points, const Options& options);

  /// A block that was saved. It has the results and sends the messages that the saved one would.
  /// @param points    of savePoints()
  /// @param saved     of save(), as often as it was called, in order. The last one is enough for
  ///                  all but finish(), which needs the cells of all.
  /// @param options   of each run that follows; the same facets as before
  /// @param summaries that begin() was given
  /// @throw Error     Internal if a byte has changed, or another version has saved; BadArgument
  ///                  without the summaries, or with nothing saved
  BlockRun(const BlockMessage& points, const std::vector<BlockMessage>& saved,
    const Options& options, const BlockSummaries& summaries);

  ~BlockRun();
  BlockRun(const BlockRun&) = delete;
  BlockRun& operator=(const BlockRun&) = delete;

  /// What all blocks need of this one: bounds, and a sample of its points.
  BlockMessage summary() const;

  ///@{
  /// The block as bytes, for builds of one version on machines of one kind: the points that it had
  /// after begin(), which stay; and all else, of the cells those found since the block was made, by
  /// either constructor. The summaries are not among them.
  /// @throw Error BadArgument before begin()
  BlockMessage savePoints() const;
  BlockMessage save() const;
  ///@}

  ///@{
  /// Triangulate the block's points.
  /// @param summaries of all blocks, by number, of this block, too
  /// @param self      the number of this block
  void begin(const std::vector<BlockMessage>& summaries, int self);
  void begin(const BlockSummaries& summaries, int self);
  ///@}

  /// The queries of a round, by the number of the block that receives them. Empty: none remains.
  std::map<int, BlockMessage> makeQueries();

  /// Replies to the queries of another block.
  BlockMessage reply(const BlockMessage& queries);

  /// Add the points of replies.
  /// @param from    the block that was queried
  /// @param replies its replies
  void receive(int from, const BlockMessage& replies);

  /// The block's cells. With FacetMode::Polygons, one cell a facet.
  BlockResult finish();

  /// The share of the block's cells in a hull's volume and area.
  /// @param result of finish()
  /// @param origin x, y, z of the point of lowest id in the results of all blocks
  BlockMeasure measure(const BlockResult& result, const double* origin) const;

  /// The volume and the area of the hull, with the bits that one run on all points gives. Every
  /// block has the same result, after begin().
  /// @param sum    of all blocks' measures
  /// @param volume becomes the volume; 0 below dimension 3
  /// @param area   becomes the area
  void sizeOf(const BlockMeasure& sum, double& volume, double& area) const;

  /// Points received from other blocks: those of the samples, and those of replies.
  std::int64_t pointsReceived() const;

private:
  class State;
  std::unique_ptr<State> state;
};

}

#endif
