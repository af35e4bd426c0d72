// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFPointRedistribution.h"

#include "FFProcesses.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <random>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

using flipflop::PointRegions;
using Key = PointRegions::Key;
using KeyOf = FFPointRedistribution::KeyOf;
using Point = FFPointRedistribution::Point;

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

}

//------------------------------------------------------------------------------
flipflop::BlockPoints FFPointRedistribution::Run(
  std::vector<Point>&& points, const KeyOf& keyOf, FFProcesses& processes)
{
  const int count = processes.GetCount();
  const vtkIdType all = processes.Sum(static_cast<vtkIdType>(points.size()));
  const std::vector<Key> own = sampleOf(points, keyOf, all,
    static_cast<vtkIdType>(PointRegions::sampleSize(static_cast<std::size_t>(count))));
  FFProcesses::Messages messages;
  for (int process = 0; process < count; ++process)
  {
    FFProcesses::Append(own.data(), own.size(), messages[process]);
  }
  processes.Exchange(messages);
  std::vector<Key> sample;
  for (const auto& message : messages)
  {
    const auto part = FFProcesses::ValuesOf<Key>(message.second);
    sample.insert(sample.end(), part.begin(), part.end());
  }
  messages.clear();
  std::vector<Key> keys;
  keys.reserve(points.size());
  std::transform(points.begin(), points.end(), std::back_inserter(keys), keyOf);
  std::vector<int> regions(points.size());
  PointRegions(std::move(sample), count).find(keys.data(), keys.size(), regions.data());
  std::vector<Key>().swap(keys);
  std::vector<std::size_t> sizes(static_cast<std::size_t>(count));
  for (const int region : regions)
  {
    sizes[static_cast<std::size_t>(region)] += sizeof(Point);
  }
  for (int process = 0; process < count; ++process)
  {
    messages[process].reserve(sizes[static_cast<std::size_t>(process)]);
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    FFProcesses::Append(&points[i], 1, messages[regions[i]]);
  }
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
    for (const Point& point : FFProcesses::ValuesOf<Point>(message.second))
    {
      std::copy(point.Position, point.Position + 3, received.positions.data() + 3 * i);
      received.ids[i++] = point.Id;
    }
    std::vector<char>().swap(message.second);
  }
  return received;
}
VTK_ABI_NAMESPACE_END
