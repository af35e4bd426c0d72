// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The cells of a block, as they become certain; in the end in canonical form.
#ifndef flipflop_BlockCells_h
#define flipflop_BlockCells_h

#include "Blocks/BlockFrame.h"
#include "Blocks/ReceivedSites.h"
#include <flipflop/BlockRun.h>

#include <cstddef>
#include <cstdint>
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

class BlockCells
{
public:
  ///@{
  /// The cells that were added, not restored, to bytes; and from them, after the others.
  void save(MessageWriter& writer) const;
  void restore(MessageReader& reader);
  ///@}

  /// @param corners in their order
  void add(const std::vector<SiteHandle>& corners);

  /// Fill in the cells, and what is said of their points.
  void write(const ReceivedSites& known, const BlockFrame& frame, FacetMode facets,
    BlockResult& result) const;

private:
  std::vector<SiteHandle> usedById(const ReceivedSites& known) const;
  void writeConnectivity(
    const std::vector<std::uint32_t>& indexOf, std::size_t points, CellComplex& cells) const;

  std::vector<SiteHandle> corners; ///< of one cell after another
  std::vector<std::size_t> ends;   ///< of each cell there
  std::size_t restored = 0;        ///< cells
};

}

#endif
