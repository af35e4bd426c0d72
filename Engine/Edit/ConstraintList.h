// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The constraints of an editable triangulation: which points they join, which end at a point, and
/// how many run along an edge. Changes since the last commit can be taken back.
#ifndef flipflop_ConstraintList_h
#define flipflop_ConstraintList_h

#include "Edit/JournaledArray.h"
#include "Points/Vertex.h"

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace flipflop
{

/// How many constraints run along each fixed edge.
class EdgeCounts
{
public:
  std::uint32_t of(std::uint64_t edge) const
  {
    const auto found = this->counts.find(edge);
    return found == this->counts.end() ? 0 : found->second;
  }

  void set(std::uint64_t edge, std::uint32_t count)
  {
    std::uint32_t& value = this->counts[edge];
    this->old.emplace_back(edge, value); // if memory runs out here, the new count is 0
    value = count;
  }

  void commit() noexcept
  {
    this->eraseZeros();
    this->old.clear();
  }

  void rollback() noexcept
  {
    for (auto entry = this->old.rbegin(); entry != this->old.rend(); ++entry)
    {
      // Nothing was erased since the last commit.
      this->counts.find(entry->first)->second = entry->second;
    }
    this->commit();
  }

private:
  void eraseZeros() noexcept
  {
    for (const auto& entry : this->old)
    {
      const auto found = this->counts.find(entry.first);
      if (found != this->counts.end() && found->second == 0)
      {
        this->counts.erase(found);
      }
    }
  }

  std::unordered_map<std::uint64_t, std::uint32_t> counts;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> old;
};

/// Constraints by number; a number is given once. Points are named by slots.
class ConstraintList
{
public:
  std::uint32_t numberCount() const { return static_cast<std::uint32_t>(this->all.size()); }
  std::uint32_t count() const { return this->present; }
  bool contains(std::int64_t number) const
  {
    return number >= 0 && number < std::int64_t(this->all.size()) &&
      this->all[static_cast<std::size_t>(number)].end[0] != NoSlot;
  }
  /// @param which 0 or 1
  std::uint32_t end(std::uint32_t number, int which) const { return this->all[number].end[which]; }

  /// @return its number
  /// @throw Error TooManyPoints
  std::uint32_t add(std::uint32_t a, std::uint32_t b)
  {
    const std::uint32_t number = this->numberCount();
    if (number == MostNumbers)
    {
      throw Error(ErrorCode::TooManyPoints, -1, std::int64_t(number));
    }
    this->all.append({ { a, b }, { NoLink, NoLink }, { NoLink, NoLink } });
    for (std::uint32_t link = 2 * number; link < 2 * number + 2; ++link)
    {
      std::uint32_t& first = this->editFirst(this->slotOf(link));
      const std::uint32_t next = std::exchange(first, link);
      this->all.edit(number).next[link % 2] = next;
      if (next != NoLink)
      {
        this->all.edit(next / 2).previous[next % 2] = link;
      }
    }
    ++this->present;
    return number;
  }

  /// Give the next numbers to no constraint.
  /// @throw Error TooManyPoints
  void skip(std::int64_t count)
  {
    if (count > std::int64_t(MostNumbers) - this->numberCount())
    {
      throw Error(ErrorCode::TooManyPoints, -1, count);
    }
    for (; count > 0; --count)
    {
      this->all.append({ { NoSlot, NoSlot }, { NoLink, NoLink }, { NoLink, NoLink } });
    }
  }

  void remove(std::uint32_t number)
  {
    for (std::uint32_t link = 2 * number; link < 2 * number + 2; ++link)
    {
      const std::uint32_t next = this->all[number].next[link % 2];
      const std::uint32_t previous = this->all[number].previous[link % 2];
      if (next != NoLink)
      {
        this->all.edit(next / 2).previous[next % 2] = previous;
      }
      if (previous != NoLink)
      {
        this->all.edit(previous / 2).next[previous % 2] = next;
      }
      else
      {
        this->editFirst(this->slotOf(link)) = next;
      }
    }
    this->all.edit(number).end[0] = NoSlot;
    --this->present;
  }

  /// Does any end at the point?
  bool anyAt(std::uint32_t slot) const { return this->firstAt(slot) != NoLink; }

  /// The numbers of those that end at the point; of one with both ends there, twice.
  std::vector<std::uint32_t> at(std::uint32_t slot) const
  {
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t link = this->firstAt(slot); link != NoLink;
         link = this->all[link / 2].next[link % 2])
    {
      numbers.push_back(link / 2);
    }
    return numbers;
  }

  void commit() noexcept
  {
    this->all.commit();
    this->first.commit();
    this->committed = this->present;
  }

  void rollback() noexcept
  {
    this->all.rollback([](auto&) {});
    this->first.rollback([](auto&) {});
    this->present = this->committed;
  }

private:
  static constexpr std::uint32_t NoSlot = 0;
  static constexpr std::uint32_t NoLink = NoIndex;
  static constexpr std::uint32_t MostNumbers =
    NoLink / 2; ///< a link is twice a number, or one more

  /// Link 2 * number + which is in the list of the constraints that end where this end is.
  struct Constraint
  {
    std::uint32_t end[2];
    std::uint32_t next[2], previous[2];
  };

  std::uint32_t slotOf(std::uint32_t link) const { return this->all[link / 2].end[link % 2]; }
  std::uint32_t firstAt(std::uint32_t slot) const
  {
    return slot < this->first.size() ? this->first[slot] : NoLink;
  }
  std::uint32_t& editFirst(std::uint32_t slot)
  {
    while (this->first.size() <= slot)
    {
      this->first.append(NoLink);
    }
    return this->first.edit(slot);
  }

  JournaledArray<Constraint> all;
  JournaledArray<std::uint32_t> first; ///< by slot, as far as any was an end
  std::uint32_t present = 0;
  std::uint32_t committed = 0;
};

}

#endif
