// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The cells of a block, as they become certain; in the end in canonical form.
#ifndef flipflop_BlockCells_h
#define flipflop_BlockCells_h

#include "Blocks/BlockFrame.h"
#include "Blocks/ReceivedSites.h"
#include <flipflop/BlockRun.h>
#include <flipflop/Error.h>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace flipflop
{

/// The corners of a cell of some points' complex.
inline void cornersOf(const CellComplex& complex, std::int64_t cell,
  const std::vector<SiteHandle>& members, std::vector<SiteHandle>& corners)
{
  corners.clear();
  for (std::int64_t k = complex.cellBegin(cell); k < complex.cellBegin(cell + 1); ++k)
  {
    const std::int64_t point = complex.connectivity[static_cast<std::size_t>(k)];
    corners.push_back(
      members[static_cast<std::size_t>(complex.pointIds[static_cast<std::size_t>(point)])]);
  }
}

/// Cells, one after another.
struct CellList
{
  std::vector<SiteHandle> corners;
  std::vector<std::uint32_t> sizes; ///< of each cell; none: all are triangles, as most are

  void add(const std::vector<SiteHandle>& cell);

  /// use (corners, size) for each cell.
  template <class Use>
  void each(const Use& use) const
  {
    const std::size_t count = this->sizes.empty() ? this->corners.size() / 3 : this->sizes.size();
    const SiteHandle* next = this->corners.data();
    for (std::size_t cell = 0; cell < count; ++cell)
    {
      const std::size_t size = this->sizes.empty() ? 3 : this->sizes[cell];
      use(next, size);
      next += size;
    }
  }

  template <class Self, class Archive>
  static void visit(Self& self, Archive& archive)
  {
    archive(self.corners, self.sizes);
    if constexpr (Archive::IsReader)
    {
      ensure(self.corners.size() ==
        std::accumulate(self.sizes.begin(), self.sizes.end(),
          self.sizes.empty() ? self.corners.size() / 3 * 3 : 0));
    }
  }
};

class BlockCells
{
public:
  /// The cells that were added, not read, are written; those read come before what is added.
  template <class Self, class Archive>
  static void visit(Self& self, Archive& archive)
  {
    archive(self.lists.back());
    if constexpr (Archive::IsReader)
    {
      self.lists.emplace_back();
    }
  }

  /// @param corners in their order
  void add(const std::vector<SiteHandle>& corners) { this->lists.back().add(corners); }

  /// Fill in the cells, and what is said of their points.
  void write(const ReceivedSites& known, const BlockFrame& frame, FacetMode facets,
    BlockResult& result) const;

private:
  std::vector<SiteHandle> usedById(const ReceivedSites& known) const;
  void writeConnectivity(
    const std::vector<std::uint32_t>& indexOf, std::size_t points, CellComplex& cells) const;

  std::vector<CellList> lists = std::vector<CellList>(1); ///< each that was read; what is added
};

}

#endif
