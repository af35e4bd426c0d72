// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Testing/Engine/References/PlaneFlips.h"
#include "Testing/Engine/Inputs/Inputs.h"

#include <algorithm>

namespace flipflop
{
namespace test
{

PlaneFlips::PlaneFlips(const Cloud& weighted)
{
  for (const Point& p : weighted)
  {
    const std::int64_t x = static_cast<std::int64_t>(p[0]);
    const std::int64_t y = static_cast<std::int64_t>(p[1]);
    this->Sites.push_back({ x, y, x * x + y * y - static_cast<std::int64_t>(p[2]) });
  }
  this->Triangles.push_back(this->turn(0, 1, 2) > 0 ? Triangle{ 0, 1, 2 } : Triangle{ 0, 2, 1 });
  std::vector<bool> placed(this->Sites.size());
  placed[0] = placed[1] = placed[2] = true;
  for (std::size_t before = 0; before != this->Triangles.size();)
  {
    before = this->Triangles.size();
    for (std::size_t t = 0; t < before; ++t)
    {
      const Triangle u = this->Triangles[t];
      int lowest = -1;
      for (int p = 3; p < static_cast<int>(this->Sites.size()); ++p)
      {
        const bool inside = this->turn(u[0], u[1], p) > 0 && this->turn(u[1], u[2], p) > 0 &&
          this->turn(u[2], u[0], p) > 0;
        if (!placed[p] && inside && this->height(u, p) < 0 &&
          (lowest < 0 || this->height(u, p) < this->height(u, lowest)))
        {
          lowest = p;
        }
      }
      if (lowest >= 0)
      {
        placed[lowest] = true;
        ++this->Inserted;
        this->Triangles[t] = { u[0], u[1], lowest };
        this->Triangles.push_back({ u[1], u[2], lowest });
        this->Triangles.push_back({ u[2], u[0], lowest });
      }
    }
  }
}

std::int64_t PlaneFlips::turn(int i, int j, int k) const
{
  const Site& p = this->Sites[i];
  const Site& q = this->Sites[j];
  const Site& r = this->Sites[k];
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

std::int64_t PlaneFlips::height(const Triangle& t, int l) const
{
  // The determinant by its last column, over the areas that l cuts the triangle into.
  const std::int64_t z = this->Sites[l][2];
  return (z - this->Sites[t[0]][2]) * this->turn(t[1], t[2], l) +
    (z - this->Sites[t[1]][2]) * this->turn(t[2], t[0], l) +
    (z - this->Sites[t[2]][2]) * this->turn(t[0], t[1], l);
}

std::size_t PlaneFlips::across(std::size_t t, int e) const
{
  const int a = this->Triangles[t][e];
  const int b = this->Triangles[t][(e + 1) % 3];
  std::size_t u = 0;
  for (; u < this->Triangles.size(); ++u)
  {
    for (int f = 0; f < 3; ++f)
    {
      if (this->Triangles[u][f] == b && this->Triangles[u][(f + 1) % 3] == a)
      {
        return u;
      }
    }
  }
  return u;
}

bool PlaneFlips::isIrregular(std::size_t t, int e) const
{
  const std::size_t u = this->across(t, e);
  if (u == this->Triangles.size())
  {
    return false;
  }
  const Triangle& other = this->Triangles[u];
  return std::any_of(
    other.begin(), other.end(), [&](int v) { return this->height(this->Triangles[t], v) < 0; });
}

int PlaneFlips::irregularEdges() const
{
  int count = 0;
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    for (int e = 0; e < 3; ++e)
    {
      count += this->isIrregular(t, e);
    }
  }
  return count / 2;
}

bool PlaneFlips::tryFlip(std::size_t t, int e)
{
  const std::size_t u = this->across(t, e);
  const Triangle s = this->Triangles[t];
  const int a = s[e];
  const int b = s[(e + 1) % 3];
  const int c = s[(e + 2) % 3];
  int d = -1;
  for (int v : this->Triangles[u])
  {
    d = v == a || v == b ? d : v;
  }
  const std::int64_t atA = this->turn(d, a, c); // the quad a d b c, clockwise seen from a: c, a, d
  const std::int64_t atB = this->turn(c, b, d);
  if (atA < 0 && atB < 0)
  {
    this->Triangles[t] = { a, d, c };
    this->Triangles[u] = { d, b, c };
    return true;
  }
  // A corner that is not convex goes if its third triangle closes it.
  const int gone = atA >= 0 ? a : b;
  const int kept = atA >= 0 ? b : a;
  std::vector<std::size_t> around;
  for (std::size_t w = 0; w < this->Triangles.size(); ++w)
  {
    const Triangle& f = this->Triangles[w];
    if (std::find(f.begin(), f.end(), gone) != f.end())
    {
      around.push_back(w);
    }
  }
  if (around.size() != 3 || (atA == 0 && gone == a) || (atB == 0 && gone == b) || gone < 3)
  {
    return false;
  }
  this->Triangles[around[0]] =
    this->turn(kept, c, d) > 0 ? Triangle{ kept, c, d } : Triangle{ kept, d, c };
  this->Triangles.erase(this->Triangles.begin() + static_cast<std::ptrdiff_t>(around[2]));
  this->Triangles.erase(this->Triangles.begin() + static_cast<std::ptrdiff_t>(around[1]));
  return true;
}

void PlaneFlips::flip(std::uint64_t seed)
{
  Random random(seed);
  for (bool flipped = true; flipped;)
  {
    flipped = false;
    std::vector<std::pair<std::size_t, int>> edges;
    for (std::size_t t = 0; t < this->Triangles.size(); ++t)
    {
      for (int e = 0; e < 3; ++e)
      {
        if (this->isIrregular(t, e))
        {
          edges.emplace_back(t, e);
        }
      }
    }
    random.shuffle(edges);
    for (const auto& edge : edges)
    {
      flipped = this->tryFlip(edge.first, edge.second);
      if (flipped)
      {
        ++this->Flips;
        break;
      }
    }
  }
}

}
}
