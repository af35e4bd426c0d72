// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Blocks/OpenFacets.h"

#include "Blocks/BorderEdges.h"
#include "Run/QueryRun.h"
#include "Support/Parallel.h"

#include <map>
#include <numeric>
#include <utility>

namespace flipflop
{

namespace
{

/// use (edge): the two ends of each edge of a triangulation's border; a hull has none.
template <class Use>
void eachBorder(const BlockFrame& frame, const CellComplex& complex,
  const std::vector<SiteHandle>& members, const Use& use)
{
  if (frame.isLifted())
  {
    const auto handleOf = [&](std::uint32_t point)
    { return members[static_cast<std::size_t>(complex.pointIds[point])]; };
    eachBorderEdge(complex,
      [&](std::uint32_t from, std::uint32_t to) {
        use(std::vector<SiteHandle>{ handleOf(from), handleOf(to) });
      });
  }
}

}

OpenFacets::OpenFacets(
  const BlockFrame& inFrame, const Options& chosen, const ReceivedSites& toAll, BlockCells& settled)
  : frame(inFrame)
  , options(chosen)
  , known(toAll)
  , cells(settled)
{
}

std::vector<SiteHandle> OpenFacets::activePoints() const
{
  std::vector<SiteHandle> active;
  for (SiteHandle handle = 0; handle < this->activity.size(); ++handle)
  {
    if (this->isActive(handle))
    {
      active.push_back(handle);
    }
  }
  return active;
}

void OpenFacets::setActive(const std::vector<SiteHandle>& active)
{
  this->activity.assign(this->known.countAtFirst(), Idle);
  for (const SiteHandle handle : active)
  {
    ensure(handle < this->activity.size());
    this->activity[handle] = Active;
  }
}

void OpenFacets::begin(const CellComplex& complex, const BlockReach& reach)
{
  std::vector<SiteHandle> members(this->known.size());
  std::iota(members.begin(), members.end(), SiteHandle(0));
  for (const SiteHandle handle : members)
  {
    this->activity.push_back(this->known.isOwn(handle) ? Active : Idle);
  }
  this->hideMissing(complex, members);
  this->core = members;
  std::vector<SiteHandle> corners;
  if (complex.dimension < 2)
  {
    // One position: one cell is all there is.
    cornersOf(complex, 0, members, corners);
    this->keep(corners);
    this->findActive();
    return;
  }
  // Nearly all cells are settled at once, and most points with them.
  const std::vector<CellState> states = this->statesOf(complex, members, reach);
  for (std::int64_t cell = 0; cell < complex.cellCount(); ++cell)
  {
    const CellState state = states[static_cast<std::size_t>(cell)];
    if (state == CellState::Owned)
    {
      cornersOf(complex, cell, members, corners);
      this->keep(corners);
    }
    else if (state == CellState::Open)
    {
      cornersOf(complex, cell, members, corners);
      this->facets.push_back({ corners });
    }
  }
  eachBorder(this->frame, complex, members,
    [&](const std::vector<SiteHandle>& edge)
    {
      if (this->isAround(edge) && !reach.isFree(this->boundOf(edge)))
      {
        this->facets.push_back({ edge });
      }
    });
  this->findActive();
  for (std::int64_t cell = 0; cell < complex.cellCount(); ++cell)
  {
    const CellState state = states[static_cast<std::size_t>(cell)];
    if (state == CellState::Settled || state == CellState::Owned)
    {
      cornersOf(complex, cell, members, corners);
      if (this->isAround(corners))
      {
        this->facets.push_back({ corners, true });
      }
    }
  }
  this->findActive();
}

/// Of the cells of a first run.
std::vector<OpenFacets::CellState> OpenFacets::statesOf(
  const CellComplex& complex, const std::vector<SiteHandle>& members, const BlockReach& reach) const
{
  constexpr std::size_t CellsPerTask = 1 << 12;
  std::vector<CellState> states(static_cast<std::size_t>(complex.cellCount()));
  runOver(states.size(), quiet(this->options),
    [&](Monitor& monitor)
    {
      eachChunk(states.size(), CellsPerTask,
        [&](std::size_t begin, std::size_t end, std::size_t)
        {
          monitor.poll();
          std::vector<SiteHandle> corners;
          for (std::size_t cell = begin; cell < end; ++cell)
          {
            cornersOf(complex, static_cast<std::int64_t>(cell), members, corners);
            states[cell] = !this->isAround(corners)   ? CellState::Elsewhere
              : !reach.isFree(this->boundOf(corners)) ? CellState::Open
              : this->known.ownsFacet(corners)        ? CellState::Owned
                                                      : CellState::Settled;
          }
        });
    });
  return states;
}

void OpenFacets::replace(const CellComplex& complex, const std::vector<SiteHandle>& members)
{
  this->hideMissing(complex, members);
  std::map<std::vector<SiteHandle>, OpenFacet> before;
  for (OpenFacet& facet : this->facets)
  {
    std::vector<SiteHandle> key = facet.corners;
    before.emplace(std::move(key), std::move(facet));
  }
  this->facets.clear();
  const auto add = [&](const std::vector<SiteHandle>& corners)
  {
    if (this->isAround(corners))
    {
      const auto found = before.find(corners);
      this->facets.push_back(
        found != before.end() ? std::move(found->second) : OpenFacet{ corners });
    }
  };
  std::vector<SiteHandle> corners;
  for (std::int64_t cell = 0; cell < complex.cellCount(); ++cell)
  {
    cornersOf(complex, cell, members, corners);
    add(corners);
  }
  eachBorder(this->frame, complex, members, add);
}

/// Active points that do not appear are hidden.
void OpenFacets::hideMissing(const CellComplex& complex, const std::vector<SiteHandle>& members)
{
  const std::int64_t* visible = complex.pointIds.begin(); // ascending, as the members
  for (std::size_t i = 0; i < members.size(); ++i)
  {
    const bool appears =
      visible != complex.pointIds.end() && *visible == static_cast<std::int64_t>(i);
    visible += appears;
    if (!appears && this->isActive(members[i]))
    {
      this->activity[members[i]] = Idle;
      this->hidden.push_back(this->known[members[i]].id);
    }
  }
}

void OpenFacets::update(const BlockReach& reach)
{
  for (OpenFacet& facet : this->facets)
  {
    if (!facet.isSettled && facet.queried == 0)
    {
      facet.reach = reach.blocks(this->boundOf(facet.corners));
    }
    if (!facet.isSettled && facet.queried == facet.reach.size())
    {
      facet.isSettled = true;
      if (!facet.isBorder() && this->known.ownsFacet(facet.corners))
      {
        this->keep(facet.corners);
      }
    }
  }
  this->findActive();
}

/// A cell of the block stays as it is.
void OpenFacets::keep(std::vector<SiteHandle> corners)
{
  if (this->frame.dimension == 1)
  {
    // With a point off the line, a triangle is an edge of the chain.
    corners.erase(std::remove_if(corners.begin(), corners.end(),
                    [this](SiteHandle handle) { return this->known[handle].id == NoBlockId; }),
      corners.end());
  }
  this->cells.add(corners);
}

/// Points stay active while a facet around them is not settled; other facets are let go.
void OpenFacets::findActive()
{
  for (const OpenFacet& facet : this->facets)
  {
    for (const SiteHandle handle : facet.corners)
    {
      if (!facet.isSettled && this->isActive(handle))
      {
        this->activity[handle] = Open;
      }
    }
  }
  for (const SiteHandle handle : this->core)
  {
    if (this->isActive(handle))
    {
      this->activity[handle] = this->activity[handle] == Open ? Active : Idle;
    }
  }
  this->facets.erase(std::remove_if(this->facets.begin(), this->facets.end(),
                       [this](const OpenFacet& facet) { return !this->isAround(facet.corners); }),
    this->facets.end());
  this->core.clear();
  for (const OpenFacet& facet : this->facets)
  {
    this->core.insert(this->core.end(), facet.corners.begin(), facet.corners.end());
  }
  std::sort(this->core.begin(), this->core.end());
  this->core.erase(std::unique(this->core.begin(), this->core.end()), this->core.end());
}

ConflictBound OpenFacets::boundOf(const std::vector<SiteHandle>& corners) const
{
  const auto coordinates = [&](std::size_t i) { return this->known[corners[i]].x; };
  return this->frame.boundOf(
    coordinates(0), coordinates(1), corners.size() == 2 ? nullptr : coordinates(2));
}

}
