// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The polyhedron without its gaps, as it leaves the executor's memory.
///
///   MarkTriangles, MarkVertices   what stays?  (prefix sums give the new numbers)
///   GatherTriangles, GatherVertices
///   ListDuplicates, GatherDuplicates   pairs of ids that stand at one position
#ifndef flipflop_CompactKernels_h
#define flipflop_CompactKernels_h

#include "Mesh/Mesh.h"
#include "Points/Duplicate.h"
#include "Rounds/Atomics.h"
#include "Rounds/Counters.h"
#include "Rounds/Kernel.h"

#include <cstddef>
#include <cstdint>

namespace flipflop
{

/// Over all triangles and one more, whose number will be the count.
struct MarkTriangles : Kernel
{
  static constexpr const char* Name = "mark triangles";
  static constexpr int Bytes = 4 + 4;
  Mesh mesh;
  std::uint32_t count;
  std::uint32_t* numbers;

  FF_HD void operator()(std::uint32_t i, Local&) const
  {
    this->numbers[i] = i < this->count && !(this->mesh.triangles[i].flags & TriangleDead) ? 1 : 0;
  }
};

/// Over all vertices and one more.
struct MarkVertices : Kernel
{
  static constexpr const char* Name = "mark vertices";
  static constexpr int Bytes = 4 + 4;
  Mesh mesh;
  std::uint32_t count;
  std::uint32_t* numbers;

  FF_HD void operator()(std::uint32_t i, Local&) const
  {
    this->numbers[i] = i < this->count && (this->mesh.vertices[i].flags & VertexAlive) ? 1 : 0;
  }
};

/// Over all triangles.
struct GatherTriangles : Kernel
{
  static constexpr const char* Name = "gather triangles";
  static constexpr int Bytes = 32 + 8 + 6 * 4 + 32;
  Mesh mesh;
  const std::uint32_t* triangleNumbers;
  const std::uint32_t* vertexNumbers;
  Triangle* result;

  FF_HD void operator()(std::uint32_t i, Local&) const
  {
    const Triangle& triangle = this->mesh.triangles[i];
    if (triangle.flags & TriangleDead)
    {
      return;
    }
    Triangle copy;
    for (int e = 0; e < 3; ++e)
    {
      const std::uint32_t twin = triangle.twin[e];
      copy.v[e] = this->vertexNumbers[triangle.v[e]];
      copy.twin[e] = halfEdge(this->triangleNumbers[triangleOf(twin)], cornerOf(twin));
    }
    copy.flags = 0;
    copy.flatEdges = 0;
    this->result[this->triangleNumbers[i]] = copy;
  }
};

/// Over all vertices.
struct GatherVertices : Kernel
{
  static constexpr const char* Name = "gather vertices";
  static constexpr int Bytes = 32 + 4 + 32;
  Mesh mesh;
  const std::uint32_t* numbers;
  Vertex* result;

  FF_HD void operator()(std::uint32_t i, Local&) const
  {
    Vertex copy = this->mesh.vertices[i];
    if (copy.flags & VertexAlive)
    {
      copy.flags &= VertexAlive | VertexVirtual;
      this->result[this->numbers[i]] = copy;
    }
  }
};

/// Over all vertices, those that are gone too.
struct ListDuplicates : Kernel
{
  static constexpr const char* Name = "list duplicates";
  static constexpr int Bytes = 4 + 4 + 12;
  Mesh mesh;
  const std::uint32_t* lowest;
  const std::uint32_t* sameAs;
  std::uint32_t* list;
  Counters* counters;

  FF_HD void operator()(std::uint32_t i, Local&) const
  {
    const std::uint32_t* const same = this->sameAs + 3 * std::size_t(i);
    if (this->lowest[i] != this->mesh.vertices[i].id || (same[0] & same[1] & same[2]) != NoIndex)
    {
      this->list[atomics::add(&this->counters->duplicates, 1u)] = i;
    }
  }
};

/// Over the list: four pairs a vertex, of which some may be of a vertex and itself.
struct GatherDuplicates : Kernel
{
  static constexpr const char* Name = "gather duplicates";
  static constexpr int Pairs = 4; ///< a vertex
  static constexpr int Bytes = 4 + 4 + 4 + 12 + Pairs * 8;
  Mesh mesh;
  const std::uint32_t* lowest;
  const std::uint32_t* sameAs;
  const std::uint32_t* list;
  Duplicate* result;

  FF_HD void operator()(std::uint32_t i, Local&) const
  {
    const std::uint32_t v = this->list[i];
    const std::uint32_t id = this->mesh.vertices[v].id;
    Duplicate* const pairs = this->result + Pairs * std::size_t(i);
    pairs[0] = { id, this->lowest[v] };
    for (int k = 0; k < 3; ++k)
    {
      const std::uint32_t same = this->sameAs[3 * std::size_t(v) + static_cast<std::size_t>(k)];
      pairs[1 + k] = { id, same != NoIndex ? same : id };
    }
  }
};

}

#endif
