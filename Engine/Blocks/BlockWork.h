// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What a block does, over one geometry.
///
/// A facet is settled when no block has a point in conflict with it; a point of the block is
/// settled when all facets around it are. After the first run, on all points of the block, only
/// points that are not settled are triangulated again: together with the corners of the facets
/// around them, and with what other blocks have told. That is enough. A facet of all known points
/// around such a point has its corners among the corners of the facets there before, and the points
/// that are new.
///
/// A question about a facet goes to the blocks that might have the furthest point, then to twice as
/// many. An answer has some of the furthest points in conflict, or at least one where there is any;
/// so a facet that is left without a new point is settled. Points on a facet (of one circle, of one
/// plane) matter only for the block that has its first corner by place, whose cell it is: it alone
/// asks for them.
///
/// Points that all lie on one line have no triangles. A point beside the line, which all blocks
/// add, makes one of each edge of the chain, and no other.
#ifndef flipflop_BlockWork_h
#define flipflop_BlockWork_h

#include "Blocks/BlockFacets.h"
#include "Blocks/BlockReach.h"
#include "Blocks/BlockSite.h"
#include "Blocks/BlockViews.h"
#include "Blocks/Introduction.h"
#include "Blocks/SiteTree.h"
#include "Geometry/HullGeometry.h"
#include "Geometry/LiftedGeometry.h"
#include "Points/CoordinateRange.h"
#include <flipflop/BlockRun.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <type_traits>
#include <unordered_map>
#include <vector>

namespace flipflop
{

/// As BlockRun's functions.
class BlockRun::Work
{
public:
  virtual ~Work() = default;
  virtual BlockMessage introduction() const = 0;
  virtual void begin(const std::vector<BlockMessage>& introductions, int self) = 0;
  virtual std::map<int, BlockMessage> ask() = 0;
  virtual BlockMessage answer(const BlockMessage& questions) = 0;
  virtual void take(int from, const BlockMessage& answers) = 0;
  virtual BlockResult finish() = 0;
  virtual std::int64_t pointsTold() const = 0;
};

template <class Model>
class BlockRun::WorkOf : public BlockRun::Work
{
public:
  WorkOf(BlockShape shape, const BlockPoints& points, const Options& options);

  BlockMessage introduction() const override { return this->own.message(); }
  void begin(const std::vector<BlockMessage>& introductions, int self) override;
  std::map<int, BlockMessage> ask() override;
  BlockMessage answer(const BlockMessage& questions) override;
  void take(int from, const BlockMessage& answers) override;
  BlockResult finish() override;
  std::int64_t pointsTold() const override
  {
    return static_cast<std::int64_t>(this->known.size()) - this->ownCount;
  }

private:
  /// Points are named by their places in this->known.
  using Handle = std::uint32_t;

  static constexpr bool IsLifted = !std::is_same_v<Model, HullGeometry>;

  /// Is there a point above a facet?
  struct Question
  {
    double corner[3][3]; ///< of a border's edge only two
    bool isBorder;
    bool wantsTies; ///< or on it
  };

  std::vector<BlockSite> takeIntroductions(const std::vector<BlockMessage>& introductions);
  void addPointBesideLine(const std::vector<BlockSite>& sample);
  void scale(BlockSite& site, int sign) const;

  CellComplex run(const std::vector<BlockSite>& sites, bool isFirst) const;
  CellComplex runOn(std::vector<Handle>& members) const;
  void hideMissing(const CellComplex& complex, const std::vector<Handle>& members);
  void takeFirstCells(const CellComplex& complex, const std::vector<Handle>& members);
  void takeCells(const CellComplex& complex, const std::vector<Handle>& members);
  std::vector<std::uint8_t> freeCells(
    const CellComplex& complex, const std::vector<Handle>& members) const;

  void update();
  void findActive();
  bool owns(const std::vector<Handle>& corners) const;
  void write(const std::vector<Handle>& cell);
  void writeCells(BlockResult& result);

  ConflictBound boundOf(const std::vector<Handle>& corners, bool isBorder) const;
  ConflictBound boundOf(const double* a, const double* b, const double* c) const;
  std::vector<std::uint32_t> conflicts(const std::vector<Question>& questions) const;

  bool gathers() const { return !IsLifted && this->dimension < 3; }
  std::map<int, BlockMessage> askForAll();

  /// Is an active point among the corners?
  bool isAround(const std::vector<Handle>& corners) const
  {
    return std::any_of(
      corners.begin(), corners.end(), [this](Handle handle) { return this->active[handle] != 0; });
  }

  /// use (edge): the two ends of each edge of the border.
  template <class Use>
  void eachBorder(
    const CellComplex& complex, const std::vector<Handle>& members, const Use& use) const
  {
    if (IsLifted)
    {
      const auto handleOf = [&](std::uint32_t point)
      { return members[static_cast<std::size_t>(complex.pointIds[point])]; };
      eachBorderEdge(complex,
        [&](std::uint32_t from, std::uint32_t to) {
          use(std::vector<Handle>{ handleOf(from), handleOf(to) });
        });
    }
  }

  const BlockShape shape;
  const Options options;
  std::int64_t ownCount;
  Introduction own;
  int self = -1;
  int dimension = -1;
  std::vector<int> others; ///< blocks that have a point
  CoordinateRange range;   ///< of the scaled points of all blocks
  int exponent = 0;        ///< coordinates are scaled by 2^ this, weights by its square
  Model geometry;
  std::unique_ptr<BlockReach> reach;
  std::unique_ptr<SiteTree<Model>> tree;

  std::vector<BlockSite> known;     ///< scaled; those of the first run by id, then as they came
  std::vector<std::uint8_t> active; ///< by handle: own points that are not settled
  std::unordered_map<std::int64_t, Handle> foreign; ///< by id
  std::vector<Handle> arrived;                      ///< since the last run
  std::vector<Handle> core;       ///< active points, and the corners of their facets
  std::vector<BlockFacet> facets; ///< around active points
  bool isLeader = false;          ///< of a hull that spans less than space: has all of it
  bool hasAskedForAll = false;
  bool isWhole = false;

  std::vector<Handle> corners;      ///< of the settled cells, one after another
  std::vector<std::size_t> ends;    ///< of each cell there
  std::vector<std::int64_t> hidden; ///< ids
  mutable Statistics statistics;
};

}

#endif
