// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// DIY's k-d trees do not do: their coordinates are floats, in which a cluster may be a single
/// position; they take a power of two of blocks; and where many points are at one position they
/// fail on regions without points.
#include <flipflop/PointRegions.h>

#include "Support/EngineCall.h"

#include <algorithm>

namespace flipflop
{

namespace
{

using Key = PointRegions::Key;

/// Whether a key comes before another along an axis. The other coordinates part what has the same
/// one there, as the columns of a grid do.
bool isBefore(const Key& a, const Key& b, std::size_t axis)
{
  for (std::size_t k = 0; k < 2; ++k)
  {
    const std::size_t i = (axis + k) % 3;
    if (a[i] != b[i])
    {
      return a[i] < b[i];
    }
  }
  return a[(axis + 2) % 3] < b[(axis + 2) % 3];
}

/// The axis along which keys extend furthest.
std::size_t longAxis(const Key* begin, const Key* end)
{
  Key extent{};
  for (std::size_t k = 0; begin != end && k < 3; ++k)
  {
    const auto range =
      std::minmax_element(begin, end, [k](const Key& a, const Key& b) { return a[k] < b[k]; });
    // Halves, since a difference may overflow.
    extent[k] = (*range.second)[k] / 2 - (*range.first)[k] / 2;
  }
  return static_cast<std::size_t>(std::max_element(extent.begin(), extent.end()) - extent.begin());
}

}

class PointRegions::Tree
{
public:
  Tree(Key* begin, Key* end, int regions) { this->split(begin, end, 0, regions); }

  int regionOf(const Key& key) const
  {
    std::size_t i = 0;
    while (this->nodes[i].last - this->nodes[i].first > 1)
    {
      const Node& node = this->nodes[i];
      i = isBefore(key, node.cut, node.axis) ? i + 1 : node.upper;
    }
    return this->nodes[i].first;
  }

private:
  /// The regions from first to last. The lower half of them has the keys before the cut.
  struct Node
  {
    int first, last;
    std::size_t axis;
    Key cut;
    std::size_t upper; ///< the node of the upper half; that of the lower one is next
  };

  void split(Key* begin, Key* end, int first, int last)
  {
    const std::size_t node = this->nodes.size();
    this->nodes.push_back({ first, last, 0, {}, 0 });
    if (last - first == 1)
    {
      return;
    }
    const int middle = first + (last - first) / 2;
    const std::size_t axis = longAxis(begin, end);
    Key* const cut = begin + (end - begin) * (middle - first) / (last - first);
    Key at{};
    if (cut != end)
    {
      std::nth_element(
        begin, cut, end, [&](const Key& a, const Key& b) { return isBefore(a, b, axis); });
      at = *cut;
    }
    Key* const upper =
      std::partition(begin, end, [&](const Key& key) { return isBefore(key, at, axis); });
    this->nodes[node].axis = axis;
    this->nodes[node].cut = at;
    this->split(begin, upper, first, middle);
    this->nodes[node].upper = this->nodes.size();
    this->split(upper, end, middle, last);
  }

  std::vector<Node> nodes;
};

PointRegions::PointRegions(std::vector<Key> sample, int regions)
  : tree(engineCall(
      [&] {
        return std::make_shared<const Tree>(sample.data(), sample.data() + sample.size(), regions);
      }))
{
}

void PointRegions::find(const Key* keys, std::size_t count, int* regions) const
{
  engineCall(
    [&]
    {
      std::transform(
        keys, keys + count, regions, [this](const Key& key) { return this->tree->regionOf(key); });
    });
}

}
