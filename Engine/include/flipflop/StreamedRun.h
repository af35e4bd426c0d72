// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A hull or a triangulation of more points than memory holds, on one machine.
#ifndef flipflop_StreamedRun_h
#define flipflop_StreamedRun_h

#include <flipflop/BlockRun.h>
#include <flipflop/Buffer.h>
#include <flipflop/Error.h>
#include <flipflop/Options.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

namespace flipflop
{

/// Some of the input's points.
struct StreamPiece
{
  Buffer<double> positions;  ///< three for each point, as BlockPoints has them
  std::vector<char> records; ///< of each point as many bytes as StreamSettings::recordSize
};

/// An Error of one piece. What index() names is in that piece.
class PieceError : public Error
{
public:
  /// The error of the piece of that number.
  PieceError(const Error& error, std::int64_t ofPiece) noexcept
    : Error(error)
    , Piece(ofPiece)
  {
  }

  /// The number of the piece, from 0 on.
  std::int64_t piece() const noexcept { return this->Piece; }

private:
  std::int64_t Piece;
};

/// What a block has in the end.
struct StreamedBlock
{
  std::int64_t number = 0;   ///< of the block, from 0 on
  BlockResult result;        ///< its cells; see there
  std::vector<char> records; ///< of each of the cells' points, in the order of cells.pointIds
};

/// The choices of a streamed run.
struct StreamSettings
{
  BlockShape shape = BlockShape::Delaunay; ///< what is built

  /// So many threads work on blocks, each on one. Points that are not finite are counted, or are
  /// an error, as in one run.
  Options options;

  /// Where what waits is, in files: 100 to 200 bytes a point, and the records. The folder is made
  /// if it is not there. It is removed in the end. After an error it stays: the same call goes on
  /// with it. It is of one run at a time.
  std::filesystem::path folder;

  /// Whether the files stay in the end, too: while something is still to be done with the blocks
  /// that were taken. The same call then gives the report alone; removeStreamedRun() ends that.
  bool keepFiles = false;

  /// The bytes that the run may take, about; not among them are a piece and a block's result while
  /// the caller has them. Points at one position are in one block, however many they are. When a
  /// run goes on, the first call's memory and threads decide its blocks.
  std::int64_t memory = std::int64_t(1) << 30;

  /// About how many points a block has; 0: as many as memory lets each thread have.
  std::int64_t blockPoints = 0;

  std::size_t recordSize = 0; ///< bytes that go with each point
};

/// What a streamed run has found.
struct StreamReport
{
  std::int64_t points = 0;         ///< of all pieces
  std::int64_t nonFinite = 0;      ///< of these, left out
  std::int64_t hidden = 0;         ///< in all BlockResult::hiddenIds
  std::int64_t cells = 0;          ///< of all blocks
  std::int64_t blocks = 0;         ///< how many there were
  int dimension = -1;              ///< of what the points span
  double volume = 0;               ///< of a hull; 0 below dimension 3
  double area = 0;                 ///< of a hull's facets
  std::int64_t pointsReceived = 0; ///< that blocks had from each other
  std::int64_t bytesWritten = 0;   ///< to files, by this call
  std::int64_t bytesRead = 0;      ///< from files, by this call
};

/// Gives the piece of a number. Called once for each piece, in their order, on the calling thread.
/// Not for pieces that an earlier call with the same folder has stored.
using ReadPiece = std::function<StreamPiece(std::int64_t piece)>;

/// Takes a block's cells. Called once for each block, one at a time, in any order, on any thread.
/// After an error, the next call may repeat a block which had been taken, with the same cells.
using WriteBlock = std::function<void(StreamedBlock&& block)>;

/// The hull or the triangulation of the points of all pieces. A point's id is its place in all
/// pieces, one after another. The cells of all blocks together are those of one run on all points,
/// bit for bit, whatever the blocks, the memory and the threads.
///
/// Pieces are stored in files and dealt to blocks, by regions. Each block is a BlockRun. It waits
/// in its file while others run, and so do the messages between blocks. Each file is whole or
/// absent. So a run whose process ended, in whatever way, goes on where its files end, when it is
/// called again with the same pieces, folder, shape, facets and size of records.
///
/// @param settings the choices
/// @param pieces   how many there are
/// @param read     gives the points
/// @param write    takes the cells
/// @throw PieceError NonFinite or BadArgument of a piece
/// @throw Error      BadArgument, TooManyPoints (in one block), OutOfMemory, Aborted
/// @throw std::filesystem::filesystem_error of a file, which it names: a full disk, no right to
///                   write, a damaged file
/// @throw whatever @p read and @p write throw
StreamReport streamedRun(const StreamSettings& settings, std::int64_t pieces, const ReadPiece& read,
  const WriteBlock& write);

/// Removes the files of a streamed run that is over, or not to go on, and the folder if nothing
/// else is in it. What is stopped in its midst is no run any longer.
/// @param folder StreamSettings::folder
/// @throw std::filesystem::filesystem_error of a file
void removeStreamedRun(const std::filesystem::path& folder);

}

#endif
