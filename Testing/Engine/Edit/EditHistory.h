// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Random edits of a triangulation.
#ifndef flipflop_test_EditHistory_h
#define flipflop_test_EditHistory_h

#include "Testing/Engine/Edit/MirroredEdits.h"
#include "Testing/Engine/Inputs/Inputs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace flipflop
{
namespace test
{

/// Where random points are: each kind has its own ties.
class PointMaker
{
public:
  explicit PointMaker(std::uint64_t seed)
    : random(seed)
    , kind(this->random.integer(0, 7))
    , weights(this->random.integer(0, 3))
    , constrained(this->random.integer(0, 1) != 0)
    , scale(this->random.integer(0, 5) ? 1.0 : std::ldexp(1.0, this->random.integer(-500, 500)))
  {
  }

  bool isWeighted() const { return this->weights > 0; }

  /// Are there constraints, too?
  bool isConstrained() const { return this->weights == 0 && this->constrained; }

  Point operator()()
  {
    Point p = this->position();
    for (double& x : p)
    {
      x *= this->scale;
    }
    if (this->isWeighted())
    {
      const double unit = this->scale * this->scale;
      p[2] = this->weights == 1 ? unit * this->random.integer(0, 3)
        : this->weights == 2    ? unit * this->random.uniform(-1, 1)
                                : (this->random.integer(0, 1) ? 7.0 : 0.0) * unit;
    }
    return p;
  }

  Random random;

private:
  Point position()
  {
    const double x = this->random.uniform();
    const double y = this->random.uniform();
    const int few = this->random.integer(0, 2) ? 4 : 9;
    switch (this->kind)
    {
      case 0:
        return { { x, y, 0 } };
      case 1:
        return { { double(this->random.integer(0, few)), double(this->random.integer(0, few)),
          0 } };
      case 2: // on a circle
        return ofCircle(this->random.integer(0, 35));
      case 3: // on a line, and rarely off it
        return { { double(this->random.integer(0, 8)),
          this->random.integer(0, 15) ? 0.0 : this->random.integer(-2, 2), 0 } };
      case 4: // neighbours in doubles
        return { { 1 + 0x1p-52 * this->random.integer(0, few),
          1 + 0x1p-52 * this->random.integer(0, few), 0 } };
      case 5: // of all magnitudes
        return { { std::ldexp(x - 0.5, this->random.integer(-400, 400)),
          std::ldexp(y - 0.5, this->random.integer(-400, 400)), 0 } };
      case 6: // a star: many neighbours of the middle
        return this->random.integer(0, 5) ? ofCircle(this->random.integer(0, 35))
                                          : Point{ { double(this->random.integer(-1, 1)), 0, 0 } };
      default: // almost on a line
        return { { x, x * 0.1, 0 } };
    }
  }

  /// Of the 36 integer points at the distance 65 from the origin.
  static Point ofCircle(int i)
  {
    static const Cloud points = []
    {
      Cloud all;
      for (int a = -65; a <= 65; ++a)
      {
        for (int b = -65; b <= 65; ++b)
        {
          if (a * a + b * b == 65 * 65)
          {
            all.push_back({ { double(a), double(b), 0 } });
          }
        }
      }
      return all;
    }();
    return points[static_cast<std::size_t>(i) % points.size()];
  }

  const int kind;
  const int weights;
  const bool constrained;
  const double scale;
};

class EditHistory : public MirroredEdits
{
public:
  explicit EditHistory(std::uint64_t seed)
    : EditHistory(PointMaker(seed))
  {
  }

  /// One random edit.
  void step()
  {
    Random& random = this->make.random;
    if (this->make.isConstrained() && random.integer(0, 2) == 0)
    {
      this->changeConstraints();
      return;
    }
    const int what = random.integer(0, 9);
    if (what < 4 || this->present.empty())
    {
      this->insert(this->some(1));
    }
    else if (what < 7)
    {
      this->removeSome(1);
    }
    else if (what == 7)
    {
      this->moveSome(1);
    }
    else if (what == 8)
    {
      this->insert(this->some(random.integer(0, 1) ? random.integer(0, 5) : 80));
    }
    else if (random.integer(0, 1))
    {
      this->removeSome(random.pick(this->present.size() + 1));
    }
    else
    {
      this->moveSome(random.pick(this->present.size() + 1));
    }
  }

private:
  explicit EditHistory(const PointMaker& points)
    : MirroredEdits(points.isWeighted())
    , make(points)
  {
    if (this->make.random.integer(0, 1))
    {
      this->begin(this->some(this->make.random.integer(0, 40)));
    }
  }

  void changeConstraints()
  {
    Random& random = this->make.random;
    if (this->present.empty())
    {
      return;
    }
    if (!this->numbers.empty() && random.integer(0, 2) == 0)
    {
      this->removeConstraint(this->numbers[random.pick(this->numbers.size())]);
      return;
    }
    std::vector<std::int64_t> ends;
    for (int i = random.integer(1, 3); i > 0; --i)
    {
      ends.push_back(this->present[random.pick(this->present.size())]);
      ends.push_back(this->present[random.pick(this->present.size())]);
    }
    this->insertConstraints(ends);
  }

  Cloud some(std::size_t count)
  {
    Cloud result;
    for (std::size_t i = 0; i < count; ++i)
    {
      result.push_back(this->make());
    }
    return result;
  }

  std::vector<std::int64_t> choose(std::size_t count)
  {
    std::vector<std::int64_t> ids = this->present;
    this->make.random.shuffle(ids);
    ids.resize(count);
    return ids;
  }

  void removeSome(std::size_t count)
  {
    std::vector<std::int64_t> ids = this->choose(count);
    const auto kept =
      std::partition(ids.begin(), ids.end(), [this](std::int64_t id) { return !this->isEnd(id); });
    if (kept != ids.end())
    {
      EXPECT_THROW(this->edited.remove(ids.data(), std::int64_t(ids.size())), Error);
      ids.erase(kept, ids.end());
    }
    this->remove(ids);
  }

  void moveSome(std::size_t count)
  {
    const std::vector<std::int64_t> ids = this->choose(count);
    const Cloud to = this->some(ids.size());
    this->move(ids, to, this->make.random.integer(0, 1) != 0);
  }

  PointMaker make;
};

}
}

#endif
