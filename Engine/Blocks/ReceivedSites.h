// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// All points that a block has: its own, the sample of others, and what it received.
#ifndef flipflop_ReceivedSites_h
#define flipflop_ReceivedSites_h

#include "Blocks/BlockSite.h"
#include "Points/Vertex.h"
#include <flipflop/Error.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace flipflop
{

/// A point's name within the block: its position among the known ones.
using SiteHandle = std::uint32_t;

class ReceivedSites
{
public:
  ReceivedSites() = default;

  /// @param sites what is known in the beginning
  ReceivedSites(std::vector<BlockSite> sites, int block)
    : self(block)
    , sites(std::move(sites))
    , atFirst(this->size())
  {
    for (SiteHandle handle = 0; handle < this->size(); ++handle)
    {
      if (!this->isOwn(handle))
      {
        this->foreign.emplace((*this)[handle].id, handle);
      }
    }
  }

  /// Learn a point of another block. False: it is known.
  /// @throw Error TooManyPoints
  bool add(const BlockSite& site)
  {
    if (this->sites.size() >= NoIndex - 1)
    {
      throw Error(ErrorCode::TooManyPoints, -1, static_cast<std::int64_t>(this->sites.size()) + 1);
    }
    if (!this->foreign.emplace(site.id, this->size()).second)
    {
      return false;
    }
    this->sites.push_back(site);
    return true;
  }

  const BlockSite& operator[](SiteHandle handle) const { return this->sites[handle]; }
  SiteHandle size() const { return static_cast<SiteHandle>(this->sites.size()); }
  const std::vector<BlockSite>& all() const { return this->sites; }

  ///@{
  /// What was known in the beginning, and what has been added.
  SiteHandle countAtFirst() const { return this->atFirst; }
  std::vector<BlockSite> first() const
  {
    return { this->sites.begin(), this->sites.begin() + this->atFirst };
  }
  std::vector<BlockSite> added() const
  {
    return { this->sites.begin() + this->atFirst, this->sites.end() };
  }
  ///@}

  bool isOwn(SiteHandle handle) const { return (*this)[handle].block == this->self; }

  std::size_t ownCount() const { return this->sites.size() - this->foreign.size(); }

  /// Points of other blocks.
  std::int64_t foreignCount() const { return static_cast<std::int64_t>(this->foreign.size()); }

  bool hasLowerId(SiteHandle a, SiteHandle b) const
  {
    return flipflop::hasLowerId((*this)[a], (*this)[b]);
  }

  /// Does the block have the first corner by position? Of all points on a facet, that is a corner
  /// for certain, which the one of lowest id need not be.
  bool ownsFacet(const std::vector<SiteHandle>& corners) const
  {
    const SiteHandle first = *std::min_element(corners.begin(), corners.end(),
      [this](SiteHandle a, SiteHandle b)
      {
        // A point off the line is no corner of a chain's edge.
        const bool isNone[2] = { (*this)[a].id == NoBlockId, (*this)[b].id == NoBlockId };
        return isNone[0] != isNone[1] ? isNone[1] : precedes((*this)[a], (*this)[b]);
      });
    return this->isOwn(first);
  }

private:
  int self = -1;
  std::vector<BlockSite> sites; ///< those of the beginning, then as they came
  SiteHandle atFirst = 0;       ///< how many those are
  std::unordered_map<std::int64_t, SiteHandle> foreign; ///< by id
};

}

#endif
