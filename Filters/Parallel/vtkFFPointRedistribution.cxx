// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFPointRedistribution.h"

#include "vtkFFProcesses.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <random>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

using Key = vtkFFPointRedistribution::Key;
using KeyOf = vtkFFPointRedistribution::KeyOf;
using Point = vtkFFPointRedistribution::Point;

/// The sample: enough for regions that are alike to some percent, and all points where these are
/// few.
constexpr vtkIdType leastSample = 1 << 14;
constexpr vtkIdType sampleOfProcess = 512;

/// Whether a key comes before another along an axis. The other coordinate parts what has the same
/// one there, as the columns of a grid do.
bool isBefore(const Key& a, const Key& b, std::size_t axis)
{
  return a[axis] < b[axis] || (a[axis] == b[axis] && a[1 - axis] < b[1 - axis]);
}

/// The axis along which keys extend further.
std::size_t longAxis(const Key* begin, const Key* end)
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

/// Keys of some of the points: of all processes' together, so many or all. The same ones each time.
std::vector<Key> sampleOf(
  const std::vector<Point>& points, const KeyOf& keyOf, vtkIdType all, vtkIdType wanted)
{
  std::vector<Key> sample;
  if (all <= wanted)
  {
    std::transform(points.begin(), points.end(), std::back_inserter(sample), keyOf);
    return sample;
  }
  const double share = static_cast<double>(points.size()) / static_cast<double>(all);
  const auto size = static_cast<std::size_t>(share * static_cast<double>(wanted) + 0.5);
  // By chance, since every n-th may lie along one line of a grid.
  std::mt19937_64 generator(points.size());
  while (sample.size() < size)
  {
    sample.push_back(keyOf(points[generator() % points.size()]));
  }
  return sample;
}

/// Walks down the k-d tree over the sample, which all processes have, with the points.
struct Tree
{
  const KeyOf& KeyOfPoint;
  vtkFFProcesses::Messages& Messages; ///< become the points of each process's region, in order

  /// The node whose regions are those of the processes from first to last.
  void Split(Key* begin, Key* end, Point* firstPoint, Point* lastPoint, int first, int last)
  {
    if (last - first == 1)
    {
      vtkFFProcesses::Append(
        firstPoint, static_cast<std::size_t>(lastPoint - firstPoint), this->Messages[first]);
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
    const auto isLower = [&](const Key& key) { return isBefore(key, at, axis); };
    Key* const upper = std::partition(begin, end, isLower);
    Point* const upperPoint = std::stable_partition(
      firstPoint, lastPoint, [&](const Point& point) { return isLower(this->KeyOfPoint(point)); });
    this->Split(begin, upper, firstPoint, upperPoint, first, middle);
    this->Split(upper, end, upperPoint, lastPoint, middle, last);
  }
};

}

//------------------------------------------------------------------------------
flipflop::BlockPoints vtkFFPointRedistribution::Run(
  std::vector<Point>&& points, const KeyOf& keyOf, vtkFFProcesses& processes)
{
  const int count = processes.GetCount();
  const vtkIdType all = processes.Sum(static_cast<vtkIdType>(points.size()));
  const std::vector<Key> own =
    sampleOf(points, keyOf, all, std::max(leastSample, count * sampleOfProcess));
  vtkFFProcesses::Messages messages;
  for (int process = 0; process < count; ++process)
  {
    vtkFFProcesses::Append(own.data(), own.size(), messages[process]);
  }
  processes.Exchange(messages);
  std::vector<Key> sample;
  for (const auto& message : messages)
  {
    const auto part = vtkFFProcesses::ValuesOf<Key>(message.second);
    sample.insert(sample.end(), part.begin(), part.end());
  }
  messages.clear();
  Tree{ keyOf, messages }.Split(sample.data(), sample.data() + sample.size(), points.data(),
    points.data() + points.size(), 0, count);
  std::vector<Point>().swap(points);
  processes.Exchange(messages);

  flipflop::BlockPoints received;
  std::size_t total = 0;
  for (const auto& message : messages)
  {
    total += message.second.size() / sizeof(Point);
  }
  received.positions.allocate(3 * total);
  received.ids.allocate(total);
  std::size_t i = 0;
  for (auto& message : messages)
  {
    for (const Point& point : vtkFFProcesses::ValuesOf<Point>(message.second))
    {
      std::copy(point.Position, point.Position + 3, received.positions.data() + 3 * i);
      received.ids[i++] = point.Id;
    }
    std::vector<char>().swap(message.second);
  }
  return received;
}
VTK_ABI_NAMESPACE_END
