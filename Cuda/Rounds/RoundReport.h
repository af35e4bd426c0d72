// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What a round left behind, in a few numbers that are the same for every executor and order.
///
/// The perturbed hull is unique, so comparing hulls alone would not notice a lost vote or a race
/// that heals; these do.
#ifndef flipflop_RoundReport_h
#define flipflop_RoundReport_h

#include "Mesh/Mesh.h"

#include <cstdint>
#include <functional>

namespace flipflop
{

struct RoundReport
{
  enum class Stage : std::uint32_t
  {
    Associate,
    Grow,
    Flip
  };

  Stage stage;
  std::uint32_t round;
  std::uint32_t items;     ///< points alive, or triangles active in the next round
  std::uint32_t triangles; ///< slots taken
  std::uint32_t vertices;  ///< slots taken
  std::uint32_t changes;   ///< vertices inserted, or flips made
  std::uint64_t labelled;  ///< so far
  std::uint64_t mesh;      ///< hash of all triangles and vertices

  friend bool operator==(const RoundReport& a, const RoundReport& b)
  {
    return a.stage == b.stage && a.round == b.round && a.items == b.items &&
      a.triangles == b.triangles && a.vertices == b.vertices && a.changes == b.changes &&
      a.labelled == b.labelled && a.mesh == b.mesh;
  }
};

/// Called after every round; it makes each round wait for the host.
using RoundObserver = std::function<void(const RoundReport&)>;

/// Of host copies of the arrays.
inline std::uint64_t hashOf(const Triangle* triangles, std::uint32_t triangleCount,
  const Vertex* vertices, std::uint32_t vertexCount)
{
  std::uint64_t hash = 0xCBF29CE484222325ull;
  const auto add = [&hash](std::uint64_t value)
  {
    hash = (hash ^ value) * 0x9E3779B97F4A7C15ull;
    hash ^= hash >> 29;
  };
  for (std::uint32_t t = 0; t < triangleCount; ++t)
  {
    const bool dead = (triangles[t].flags & TriangleDead) != 0;
    add(dead ? 1 : 0);
    for (int e = 0; e < 3 && !dead; ++e)
    {
      add(static_cast<std::uint64_t>(triangles[t].v[e]) << 32 | triangles[t].twin[e]);
    }
  }
  for (std::uint32_t v = 0; v < vertexCount; ++v)
  {
    add(static_cast<std::uint64_t>(vertices[v].id) << 32 | vertices[v].flags);
  }
  return hash;
}

}

#endif
