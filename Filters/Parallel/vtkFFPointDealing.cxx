// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFPointDealing.h"

#include "vtkFFBlockExchange.h"

#include <algorithm>
#include <cstddef>
#include <random>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

using Key = vtkFFPointDealing::Key;
using Point = vtkFFPointDealing::Point;

/// The sample: enough for regions that are alike to some percent, and all points where these are
/// few.
constexpr vtkIdType leastSample = 1 << 14;
constexpr vtkIdType sampleOfProcess = 512;

/// An inner node. Its regions are stretches of processes, in order.
struct Split
{
  Key At{};                  ///< keys below it go to the lower side
  std::int64_t Axis = 0;     ///< which coordinate is compared first
  std::int64_t Boundary = 0; ///< the first process of the upper side
};

/// Whether a key comes before another along an axis. The other coordinate parts what has the same
/// one there, as the columns of a grid do.
bool isBefore(const Key& a, const Key& b, std::int64_t axis)
{
  const auto k = static_cast<std::size_t>(axis);
  return a[k] < b[k] || (a[k] == b[k] && a[1 - k] < b[1 - k]);
}

/// The axis along which keys extend further.
std::int64_t longAxis(const Key* begin, const Key* end)
{
  Key extent{};
  for (std::size_t k = 0; begin != end && k < 2; ++k)
  {
    const auto range =
      std::minmax_element(begin, end, [k](const Key& a, const Key& b) { return a[k] < b[k]; });
    // Halves, since a difference may overflow.
    extent[k] = (*range.second)[k] / 2 - (*range.first)[k] / 2;
  }
  return extent[1] > extent[0];
}

/// The tree over the regions of the processes from first to last, in the order of a walk from its
/// root, lower sides first.
void build(Key* begin, Key* end, int first, int last, std::vector<Split>& tree)
{
  if (last - first < 2)
  {
    return;
  }
  Split split;
  const int middle = first + (last - first) / 2;
  split.Boundary = middle;
  split.Axis = longAxis(begin, end);
  Key* const cut = begin + (end - begin) * (middle - first) / (last - first);
  if (cut != end)
  {
    std::nth_element(
      begin, cut, end, [&](const Key& a, const Key& b) { return isBefore(a, b, split.Axis); });
    split.At = *cut;
  }
  tree.push_back(split);
  Key* const upper =
    std::partition(begin, end, [&](const Key& key) { return isBefore(key, split.At, split.Axis); });
  build(begin, upper, first, middle, tree);
  build(upper, end, middle, last, tree);
}

/// The process that a key goes to.
int processOf(const Key& key, const std::vector<Split>& tree, int count)
{
  std::size_t node = 0;
  int first = 0;
  int last = count;
  while (last - first > 1)
  {
    const Split& split = tree[node];
    const int boundary = static_cast<int>(split.Boundary);
    if (isBefore(key, split.At, split.Axis))
    {
      last = boundary;
      ++node;
    }
    else
    {
      node += static_cast<std::size_t>(boundary - first); // past the lower side's nodes
      first = boundary;
    }
  }
  return first;
}

/// Keys of some of the points: of all processes' together, so many or all. The same ones each time.
std::vector<Key> sampleOf(const std::vector<Point>& points, const vtkFFPointDealing::KeyOf& keyOf,
  vtkIdType all, vtkIdType wanted)
{
  std::vector<Key> sample;
  if (all <= wanted)
  {
    for (const Point& point : points)
    {
      sample.push_back(keyOf(point));
    }
    return sample;
  }
  const double share = static_cast<double>(points.size()) / static_cast<double>(all);
  const auto size = static_cast<std::size_t>(share * static_cast<double>(wanted) + 0.5);
  // By chance, since what is every so manieth may lie along one line of a grid.
  std::mt19937_64 generator(points.size());
  while (sample.size() < size)
  {
    sample.push_back(keyOf(points[generator() % points.size()]));
  }
  return sample;
}

/// The points that came in, in their order.
void take(vtkFFBlockExchange::Messages& messages, flipflop::BlockPoints& dealt)
{
  std::size_t total = 0;
  for (const auto& message : messages)
  {
    total += message.second.size() / sizeof(Point);
  }
  dealt.positions.allocate(3 * total);
  dealt.ids.allocate(total);
  std::size_t i = 0;
  for (auto& message : messages)
  {
    for (const Point& point : vtkFFBlockExchange::Values<Point>(message.second))
    {
      std::copy(point.Place, point.Place + 3, dealt.positions.data() + 3 * i);
      dealt.ids[i++] = point.Id;
    }
    std::vector<char>().swap(message.second);
  }
}

}

//------------------------------------------------------------------------------
void vtkFFPointDealing::Deal(std::vector<Point>&& points, const KeyOf& keyOf,
  vtkFFBlockExchange& exchange, flipflop::BlockPoints& dealt)
{
  const int count = exchange.GetProcesses().GetCount();
  const vtkIdType all = exchange.GetProcesses().Sum(static_cast<vtkIdType>(points.size()));
  vtkFFBlockExchange::Messages messages;
  exchange.Do(
    [&]
    {
      const std::vector<Key> sample =
        sampleOf(points, keyOf, all, std::max(leastSample, count * sampleOfProcess));
      vtkFFBlockExchange::Add(sample.data(), sample.size(), messages[0]);
    });
  exchange.Exchange(messages);
  exchange.Do(
    [&]
    {
      std::vector<Key> sample;
      std::vector<Split> tree;
      for (const auto& message : messages)
      {
        const auto part = vtkFFBlockExchange::Values<Key>(message.second);
        sample.insert(sample.end(), part.begin(), part.end());
      }
      const bool builds = !messages.empty(); // process 0
      messages.clear();
      if (builds)
      {
        build(sample.data(), sample.data() + sample.size(), 0, count, tree);
        for (int process = 0; process < count; ++process)
        {
          vtkFFBlockExchange::Add(tree.data(), tree.size(), messages[process]);
        }
      }
    });
  exchange.Exchange(messages);
  exchange.Do(
    [&]
    {
      const auto tree = vtkFFBlockExchange::Values<Split>(messages[0]);
      messages.clear();
      std::vector<std::vector<char>> parts(static_cast<std::size_t>(count));
      for (const Point& point : points)
      {
        const int process = processOf(keyOf(point), tree, count);
        vtkFFBlockExchange::Add(&point, 1, parts[static_cast<std::size_t>(process)]);
      }
      std::vector<Point>().swap(points);
      for (int process = 0; process < count; ++process)
      {
        messages[process].swap(parts[static_cast<std::size_t>(process)]);
      }
    });
  exchange.Exchange(messages);
  exchange.Do([&] { take(messages, dealt); });
  exchange.Agree();
}
VTK_ABI_NAMESPACE_END
