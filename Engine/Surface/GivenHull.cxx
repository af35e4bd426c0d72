// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/GivenHull.h"

#include "Mesh/Faults.h"
#include "Surface/StarShape.h"

#include <algorithm>
#include <utility>

namespace flipflop
{

GivenHull::GivenHull(const PointSource& points, const Hull& cells)
  : source(points)
  , hull(cells)
  , corners(cornersIn(points, cells))
{
}

Validation GivenHull::link(HullGeometry& geometry, Monitor& monitor)
{
  if (this->hull.dimension == 2)
  {
    this->ring = ringOfCells(this->hull);
    if (this->ring.empty() || this->ring.size() != this->corners.size())
    {
      return faultAt(this->ring.empty() ? Fault::NotClosed : Fault::Structure, 0);
    }
    this->axes = planeAxes(geometry, this->around(0), this->around(1), this->around(2));
  }
  if (this->hull.dimension < 3)
  {
    return Validation();
  }
  CellMesh mesh;
  const Validation linked = mesh.link(this->hull, false, monitor);
  if (!linked)
  {
    return linked;
  }
  this->solid = Polyhedron(this->corners.size(), 0);
  std::copy(this->corners.begin(), this->corners.end(), this->solid.vertices.begin());
  this->solid.triangles = std::move(mesh.triangles);
  this->cellOf = std::move(mesh.cells);
  std::vector<std::uint32_t> ids;
  for (const Vertex& corner : this->corners)
  {
    ids.push_back(corner.id);
  }
  this->independent = findSpan(
    geometry, this->source, ids.data(), static_cast<std::uint32_t>(ids.size()), 3, false, monitor);
  if (this->independent.dimension < 3)
  {
    return faultAt(Fault::WrongDimension, -1);
  }
  Vertex four[4];
  double s[3] = { 0, 0, 0 };
  for (int k = 0; k < 4; ++k)
  {
    four[k] = this->source.vertex(this->independent.ids[k]);
    for (int i = 0; i < 3; ++i)
    {
      s[i] += 0.25 * four[k].x[i];
    }
  }
  geometry.setKernel(s);
  if (findStarFault(geometry, this->solid).count)
  {
    geometry.setSymbolicKernel(four);
  }
  return Validation();
}

}
