// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A point as blocks send it each other, and messages of such plain values.
#ifndef flipflop_BlockSite_h
#define flipflop_BlockSite_h

#include "Points/Vertex.h"
#include <flipflop/BlockRun.h>
#include <flipflop/Error.h>
#include <flipflop/PointView.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <string_view>
#include <type_traits>
#include <vector>

namespace flipflop
{

/// A point of some block.
struct BlockSite
{
  double x[3];        ///< x, y, and z or the weight
  std::int64_t id;    ///< over all blocks
  std::int32_t block; ///< that has it
  std::uint32_t rank; ///< among the ids of its block
};

/// BlockSite::block of a point that no block has.
constexpr std::int32_t NoBlock = -1;

/// BlockSite::id of a point that is no input: behind all.
constexpr std::int64_t NoBlockId = std::numeric_limits<std::int64_t>::max();

inline bool hasLowerId(const BlockSite& a, const BlockSite& b)
{
  return a.id < b.id;
}

/// By x, then y, then z or the weight.
inline bool precedes(const BlockSite& a, const BlockSite& b)
{
  return std::lexicographical_compare(a.x, a.x + 3, b.x, b.x + 3);
}

/// As predicates without perturbation take it: they read no id.
inline Vertex asVertex(const double* x)
{
  return { { x[0], x[1], x[2] }, 0, 0 };
}

constexpr std::int64_t BlockSiteStride = sizeof(BlockSite) / sizeof(double);
static_assert(
  sizeof(BlockSite) % sizeof(double) == 0, "coordinates are doubles, equally far apart");

inline PointView viewOf(const std::vector<BlockSite>& sites)
{
  return { sites.empty() ? nullptr : sites.front().x, static_cast<std::int64_t>(sites.size()),
    BlockSiteStride };
}

/// No weights, unless the shape has some.
inline WeightView weightsOf(BlockShape shape, const std::vector<BlockSite>& sites)
{
  return shape != BlockShape::RegularTriangulation || sites.empty()
    ? WeightView()
    : WeightView(sites.front().x + 2, static_cast<std::int64_t>(sites.size()), BlockSiteStride);
}

class MessageWriter
{
public:
  template <class Value>
  void add(const Value& value)
  {
    static_assert(std::is_trivially_copyable_v<Value>);
    const auto* const bytes = reinterpret_cast<const char*>(&value);
    this->message.insert(this->message.end(), bytes, bytes + sizeof(Value));
  }

  template <class Value>
  void addAll(const std::vector<Value>& values)
  {
    static_assert(std::is_trivially_copyable_v<Value>);
    this->add(values.size());
    const auto* const bytes = reinterpret_cast<const char*>(values.data());
    this->message.insert(this->message.end(), bytes, bytes + values.size() * sizeof(Value));
  }

  /// Last: a hash of all bytes.
  void addHash()
  {
    this->add(std::hash<std::string_view>()({ this->message.data(), this->message.size() }));
  }

  BlockMessage message;
};

/// Takes nothing for granted: a message may be damaged.
class MessageReader
{
public:
  explicit MessageReader(const BlockMessage& message)
    : next(message.data())
    , remaining(message.size())
  {
  }

  /// @throw Error Internal if the message ends before
  template <class Value>
  Value read()
  {
    static_assert(std::is_trivially_copyable_v<Value>);
    ensure(this->remaining >= sizeof(Value));
    Value value;
    std::memcpy(&value, this->next, sizeof(Value));
    this->next += sizeof(Value);
    this->remaining -= sizeof(Value);
    return value;
  }

  template <class Value>
  std::vector<Value> readAll()
  {
    const auto count = this->read<std::size_t>();
    ensure(count <= this->remaining / sizeof(Value));
    std::vector<Value> values(count);
    if (count > 0)
    {
      std::memcpy(static_cast<void*>(values.data()), this->next, count * sizeof(Value));
    }
    this->next += count * sizeof(Value);
    this->remaining -= count * sizeof(Value);
    return values;
  }

  /// First: what follows are the bytes that were written.
  /// @throw Error Internal if one of them has changed
  void checkHash()
  {
    std::size_t hash;
    ensure(this->remaining >= sizeof(hash));
    this->remaining -= sizeof(hash);
    std::memcpy(&hash, this->next + this->remaining, sizeof(hash));
    ensure(hash == std::hash<std::string_view>()({ this->next, this->remaining }));
  }

  bool atEnd() const { return this->remaining == 0; }

private:
  const char* next;
  std::size_t remaining;
};

}

#endif
