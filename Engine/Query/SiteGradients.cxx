// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Query/SiteGradients.h"

#include "Support/Parallel.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace flipflop
{

/// Of one site, for all values: a gradient is a sum of differences of values, times factors.
class SiteGradients::Fit
{
public:
  Fit(const PreparedTriangulation& triangulation, std::uint32_t site, double unit)
    : mesh(triangulation.mesh)
  {
    this->around[0] = site;
    this->addRing(site);
    for (int round = 0; this->count < Enough && round < 3; ++round)
    {
      this->addRound();
    }
    const Vertex* const sites = triangulation.sites.data();
    double farthest = 0;
    for (int i = 1; i < this->count; ++i)
    {
      for (int k = 0; k < 2; ++k)
      {
        this->offset[k][i] = sites[this->around[i]].x[k] * unit - sites[site].x[k] * unit;
        farthest = std::max(farthest, std::fabs(this->offset[k][i]));
      }
    }
    this->fit(farthest);
  }

  int size() const { return this->count; }
  std::uint32_t site(int i) const { return this->around[i]; }
  double factor(int axis, int i) const { return this->factors[axis][i]; }

private:
  static constexpr int Most = 128;
  static constexpr int Enough = 10; ///< the site, and more than the five that a quadratic needs

  void add(std::uint32_t site)
  {
    const auto end = this->around + this->count;
    if (this->count < Most && std::find(this->around, end, site) == end)
    {
      this->around[this->count++] = site;
    }
  }

  /// Of many triangles some, which are spread around.
  void addRing(std::uint32_t site)
  {
    constexpr int Triangles = 32;
    int degree = 0;
    this->mesh.eachLeaving(site,
      [&](std::uint32_t)
      {
        ++degree;
        return true;
      });
    const int step = (degree + Triangles - 1) / Triangles;
    int number = 0;
    this->mesh.eachLeaving(site,
      [&](std::uint32_t h)
      {
        if (number++ % step == 0)
        {
          this->add(this->mesh.origin(nextHalfEdge(h)));
          this->add(this->mesh.origin(previousHalfEdge(h)));
          const std::uint32_t beyond = this->mesh.twin(nextHalfEdge(h));
          if (beyond != NoIndex)
          {
            this->add(this->mesh.origin(previousHalfEdge(beyond)));
          }
        }
        return true;
      });
  }

  /// Some neighbours of those that are there.
  void addRound()
  {
    constexpr int Neighbours = 16;
    const int before = this->count;
    for (int i = 1; i < before; ++i)
    {
      int number = 0;
      this->mesh.eachNeighbour(this->around[i],
        [&](std::uint32_t u)
        {
          this->add(u);
          return ++number < Neighbours;
        });
    }
  }

  /// The factors, by Gram and Schmidt: of the squares' columns first, then of those of x and y.
  void fit(double farthest)
  {
    std::fill_n(this->factors[0], 2 * Most, 0.0);
    for (int i = 1; i < this->count; ++i)
    {
      this->offset[0][i] /= farthest;
      this->offset[1][i] /= farthest;
      // At most 1 each. (std::hypot's last bit is not the same everywhere.)
      const double square =
        this->offset[0][i] * this->offset[0][i] + this->offset[1][i] * this->offset[1][i];
      const double distance = std::max(std::sqrt(square), 0.1);
      this->weights[i] = 1 / (distance * distance * distance);
    }
    int kept = 0;
    for (int k = 0; k < 3; ++k)
    {
      const double* const first = this->offset[k < 2 ? 0 : 1];
      const double* const second = this->offset[k < 1 ? 0 : 1];
      for (int i = 1; i < this->count; ++i)
      {
        this->basis[kept][i] = this->weights[i] * first[i] * second[i];
      }
      double ignored;
      kept += this->orthogonalise(kept, ignored) > 0 ? 1 : 0;
    }
    if (!this->fitLinear(kept, farthest))
    {
      this->fitLinear(0, farthest);
    }
  }

  /// @param kept columns of squares are in the basis
  /// @return false where x and y depend on them, or on each other
  bool fitLinear(int kept, double farthest)
  {
    double size[2], ofX = 0;
    for (int k = 0; k < 2; ++k)
    {
      for (int i = 1; i < this->count; ++i)
      {
        this->basis[kept + k][i] = this->weights[i] * this->offset[k][i];
      }
      size[k] = this->orthogonalise(kept + k, ofX);
      if (!(size[k] > 0))
      {
        return false;
      }
    }
    for (int i = 1; i < this->count; ++i)
    {
      const double ofY = this->basis[kept + 1][i] / size[1];
      this->factors[0][i] =
        (this->basis[kept][i] - ofX * ofY) / size[0] * this->weights[i] / farthest;
      this->factors[1][i] = ofY * this->weights[i] / farthest;
    }
    return true;
  }

  /// Makes a column of the basis a unit vector perpendicular to those before it.
  /// @param ofLast receives the share of the column before it
  /// @return the length of what was left; 0: next to nothing
  double orthogonalise(int number, double& ofLast)
  {
    constexpr double Least = 1e-6;
    double* const column = this->basis[number];
    const double before = std::sqrt(this->product(column, column));
    ofLast = 0;
    for (int pass = 0; pass < 2; ++pass)
    {
      for (int k = 0; k < number; ++k)
      {
        const double share = this->product(this->basis[k], column);
        for (int i = 1; i < this->count; ++i)
        {
          column[i] -= share * this->basis[k][i];
        }
        ofLast += k == number - 1 ? share : 0;
      }
    }
    const double after = std::sqrt(this->product(column, column));
    if (!(after > Least * before))
    {
      return 0;
    }
    for (int i = 1; i < this->count; ++i)
    {
      column[i] /= after;
    }
    return after;
  }

  double product(const double* u, const double* v) const
  {
    double sum = 0;
    for (int i = 1; i < this->count; ++i)
    {
      sum += u[i] * v[i];
    }
    return sum;
  }

  const FanMesh& mesh;
  std::uint32_t around[Most]; ///< the site, and those around it
  int count = 1;
  double offset[2][Most]; ///< from the site to each
  double weights[Most];
  double basis[5][Most];
  double factors[2][Most];
};

SiteGradients::SiteGradients(const PreparedTriangulation& triangulation,
  const InterpolationTask& toDo, bool isTable, Monitor& monitor)
  : prepared(triangulation)
  , task(toDo)
{
  if (this->prepared.dimension < 2)
  {
    return;
  }
  double most = 0;
  for (int axis = 0; axis < 2; ++axis)
  {
    most =
      std::max({ most, std::fabs(this->prepared.sites.scaled(this->prepared.sites.lowest(axis))),
        std::fabs(this->prepared.sites.scaled(this->prepared.sites.highest(axis))) });
  }
  this->scale = std::ldexp(1.0, -std::max(std::ilogb(most) + 1, -1000));
  if (!isTable)
  {
    return;
  }
  constexpr std::size_t SitesPerTask = 1 << 10;
  const std::size_t count = this->prepared.sites.count();
  const auto size = static_cast<std::size_t>(2 * this->task.components);
  this->table.allocate(count * size);
  monitor.stage(0.0, 0.3, static_cast<std::int64_t>(count), "estimating gradients");
  eachChunk(count, SitesPerTask,
    [&](std::size_t begin, std::size_t end, std::size_t)
    {
      for (std::size_t site = begin; site < end; ++site)
      {
        this->compute(static_cast<std::uint32_t>(site), this->table.data() + site * size);
      }
      monitor.advance(static_cast<std::int64_t>(end - begin));
    });
}

void SiteGradients::at(std::uint32_t site, double* gradients) const
{
  if (this->table.empty())
  {
    this->compute(site, gradients);
    return;
  }
  const auto size = static_cast<std::size_t>(2 * this->task.components);
  std::copy_n(this->table.data() + site * size, size, gradients);
}

void SiteGradients::compute(std::uint32_t site, double* gradients) const
{
  const Fit fit(this->prepared, site, this->scale);
  for (std::int64_t c = 0; c < this->task.components; ++c, gradients += 2)
  {
    const double here = this->task.valuesOf(this->prepared.sites, site)[c];
    gradients[0] = gradients[1] = 0;
    for (int i = 1; i < fit.size(); ++i)
    {
      const double rise = this->task.valuesOf(this->prepared.sites, fit.site(i))[c] - here;
      gradients[0] += fit.factor(0, i) * rise;
      gradients[1] += fit.factor(1, i) * rise;
    }
  }
}

}
