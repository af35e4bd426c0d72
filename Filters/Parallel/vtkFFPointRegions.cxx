// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFPointRegions.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

using Key = vtkFFPointRegions::Key;

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

}

//------------------------------------------------------------------------------
std::size_t vtkFFPointRegions::GetSampleSize(int regions)
{
  constexpr std::size_t least = 1 << 14;
  constexpr std::size_t ofRegion = 512;
  return std::max(least, static_cast<std::size_t>(regions) * ofRegion);
}

//------------------------------------------------------------------------------
vtkFFPointRegions::vtkFFPointRegions(std::vector<Key> sample, int regions)
{
  this->Split(sample.data(), sample.data() + sample.size(), 0, regions);
}

//------------------------------------------------------------------------------
void vtkFFPointRegions::Split(Key* begin, Key* end, int first, int last)
{
  const std::size_t node = this->Nodes.size();
  this->Nodes.push_back({ first, last, 0, {}, 0 });
  if (last - first == 1)
  {
    return;
  }
  const int middle = this->Nodes[node].Middle();
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
  this->Nodes[node].Axis = axis;
  this->Nodes[node].Cut = at;
  this->Split(begin, upper, first, middle);
  this->Nodes[node].Upper = this->Nodes.size();
  this->Split(upper, end, middle, last);
}

//------------------------------------------------------------------------------
int vtkFFPointRegions::Find(const Key& key) const
{
  std::size_t i = 0;
  while (this->Nodes[i].Last - this->Nodes[i].First > 1)
  {
    const Node& node = this->Nodes[i];
    i = isBefore(key, node.Cut, node.Axis) ? i + 1 : node.Upper;
  }
  return this->Nodes[i].First;
}
VTK_ABI_NAMESPACE_END
