// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Edit/ConstrainedEdits.h"

#include <algorithm>

namespace flipflop
{

ConstrainedEdits::ConstrainedEdits(
  MeshOfPoints& toEdit, const ConstraintList& list, EdgeCounts& countsOfEdges, Monitor& toPoll)
  : mesh(toEdit)
  , constraints(list)
  , counts(countsOfEdges)
  , insertion(toEdit, toPoll)
{
}

void ConstrainedEdits::insertPoint(std::uint32_t slot)
{
  const std::uint32_t t = this->mesh.locate(this->mesh.vertex(slot));
  for (const std::uint32_t corner : this->mesh.triangle(t).v)
  {
    if (corner != 0 && this->mesh.vertex(slot).id < this->mesh.vertex(corner).id &&
      LiftedGeometry<false>::samePlanePosition(this->mesh.vertex(corner), this->mesh.vertex(slot)))
    {
      // It hides the one that is there.
      const std::vector<Spoke> spokes = this->spokesOf(corner);
      this->releaseSpokes(corner, spokes);
      this->mesh.insert(slot);
      for (const Spoke& spoke : spokes)
      {
        this->fix(slot, spoke.end, spoke.count);
      }
      return;
    }
  }
  const std::uint32_t* const ends = this->mesh.dividedEdge();
  if (this->mesh.insertIn(slot, t) && ends[1] != ends[0])
  {
    const std::uint32_t count = this->countOf(ends[0], ends[1]);
    this->setCount(ends[0], ends[1], 0);
    this->setCount(ends[0], slot, count);
    this->setCount(slot, ends[1], count);
  }
}

bool ConstrainedEdits::removePoint(std::uint32_t slot)
{
  if (!this->mesh.isVisible(slot))
  {
    return this->mesh.remove(slot);
  }
  const std::vector<Spoke> spokes = this->spokesOf(slot);
  if (spokes.empty())
  {
    return this->mesh.remove(slot);
  }
  const std::uint32_t other = this->mesh.nextAt(slot);
  if (other == 0 && spokes.size() != 2)
  {
    return false; // they cross, unless another point comes here
  }
  this->releaseSpokes(slot, spokes);
  if (!this->mesh.remove(slot))
  {
    return false;
  }
  if (other == 0)
  {
    this->fix(spokes[0].end, spokes[1].end, spokes[0].count);
    return true;
  }
  for (const Spoke& spoke : spokes)
  {
    this->fix(other, spoke.end, spoke.count);
  }
  return true;
}

bool ConstrainedEdits::divides(std::uint32_t slot) const
{
  if (!this->mesh.isVisible(slot) || this->spokesOf(slot).empty())
  {
    return false;
  }
  bool isEnd = false;
  this->mesh.eachAt(
    slot, [&](std::uint32_t other) { isEnd = isEnd || this->constraints.anyAt(other); });
  return !isEnd;
}

void ConstrainedEdits::insert(std::uint32_t number)
{
  const std::uint32_t u = this->mesh.visibleAt(this->constraints.end(number, 0));
  const std::uint32_t v = this->mesh.visibleAt(this->constraints.end(number, 1));
  if (std::find(this->absent.begin(), this->absent.end(), number) == this->absent.end())
  {
    this->absent.push_back(number);
  }
  std::vector<std::uint64_t> crossed;
  this->insertion.insert(
    u, v, [] { return false; },
    [this](std::uint32_t from, std::uint32_t to)
    { this->setCount(from, to, this->countOf(from, to) + 1); },
    [&](std::uint32_t h)
    {
      crossed.push_back(
        MeshOfPoints::edgeKey(this->mesh.origin(h), this->mesh.origin(this->mesh.twin(h))));
    });
  if (!crossed.empty())
  {
    throw Error(ErrorCode::ConstraintsCross, -1, this->firstAlong(crossed));
  }
  this->absent.erase(std::find(this->absent.begin(), this->absent.end(), number));
}

void ConstrainedEdits::release(std::uint32_t number)
{
  this->absent.push_back(number);
  std::vector<std::uint64_t> free;
  this->eachEdge(number,
    [&](std::uint32_t from, std::uint32_t to)
    {
      const std::uint32_t count = this->countOf(from, to);
      this->setCount(from, to, count - 1);
      if (count == 1)
      {
        free.push_back(std::uint64_t(from) << 32 | to);
      }
    });
  for (const std::uint64_t edge : free)
  {
    this->insertion.release(
      this->halfEdgeTo(static_cast<std::uint32_t>(edge >> 32), static_cast<std::uint32_t>(edge)));
  }
}

void ConstrainedEdits::countAll()
{
  for (std::uint32_t number = 0; number < this->constraints.numberCount(); ++number)
  {
    if (this->constraints.contains(number))
    {
      this->eachEdge(number,
        [this](std::uint32_t from, std::uint32_t to)
        { this->setCount(from, to, this->countOf(from, to) + 1); });
    }
  }
}

template <class Use>
void ConstrainedEdits::eachEdge(std::uint32_t number, const Use& use)
{
  this->mesh.eachFixedEdge(this->mesh.visibleAt(this->constraints.end(number, 0)),
    this->mesh.visibleAt(this->constraints.end(number, 1)), use);
}

std::vector<ConstrainedEdits::Spoke> ConstrainedEdits::spokesOf(std::uint32_t slot) const
{
  std::vector<Spoke> spokes;
  const std::uint32_t first = this->mesh.leaving(slot);
  std::uint32_t h = first;
  do
  {
    if (this->mesh.isFixed(h))
    {
      const std::uint32_t end = this->mesh.origin(nextHalfEdge(h));
      spokes.push_back({ h, end, this->countOf(slot, end) });
    }
    h = this->mesh.twin(previousHalfEdge(h));
  } while (h != first);
  return spokes;
}

void ConstrainedEdits::releaseSpokes(std::uint32_t slot, const std::vector<Spoke>& spokes)
{
  for (const Spoke& spoke : spokes)
  {
    this->setCount(slot, spoke.end, 0);
    this->insertion.release(this->halfEdgeTo(slot, spoke.end));
  }
}

/// @param count of the constraints that run along the edge, or edges, between two points
void ConstrainedEdits::fix(std::uint32_t from, std::uint32_t to, std::uint32_t count)
{
  this->insertion.insert(
    from, to, [] { return false; },
    [&](std::uint32_t u, std::uint32_t v) { this->setCount(u, v, count); },
    [](std::uint32_t) { throw Error(ErrorCode::Internal); });
}

void ConstrainedEdits::setCount(std::uint32_t from, std::uint32_t to, std::uint32_t count)
{
  this->counts.set(MeshOfPoints::edgeKey(from, to), count);
}

std::uint32_t ConstrainedEdits::countOf(std::uint32_t from, std::uint32_t to) const
{
  return this->counts.of(MeshOfPoints::edgeKey(from, to));
}

/// Of an edge that is there.
std::uint32_t ConstrainedEdits::halfEdgeTo(std::uint32_t from, std::uint32_t to) const
{
  const std::uint32_t first = this->mesh.leaving(from);
  std::uint32_t h = first;
  while (this->mesh.origin(nextHalfEdge(h)) != to)
  {
    h = this->mesh.twin(previousHalfEdge(h));
    ensure(h != first);
  }
  return h;
}

/// The first constraint that runs along one of some edges: before an error, each is walked.
std::uint32_t ConstrainedEdits::firstAlong(const std::vector<std::uint64_t>& edges)
{
  std::vector<std::uint64_t> sorted = edges;
  std::sort(sorted.begin(), sorted.end());
  for (std::uint32_t number = 0; number < this->constraints.numberCount(); ++number)
  {
    bool isAlong = false;
    if (this->constraints.contains(number) &&
      std::find(this->absent.begin(), this->absent.end(), number) == this->absent.end())
    {
      this->eachEdge(number,
        [&](std::uint32_t from, std::uint32_t to)
        {
          isAlong = isAlong ||
            std::binary_search(sorted.begin(), sorted.end(), MeshOfPoints::edgeKey(from, to));
        });
    }
    if (isAlong)
    {
      return number;
    }
  }
  throw Error(ErrorCode::Internal);
}

}
