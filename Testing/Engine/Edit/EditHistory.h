// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Random edits of a triangulation, next to the list of the points that should be there.
#ifndef flipflop_test_EditHistory_h
#define flipflop_test_EditHistory_h

#include "Testing/Engine/Calls/Bits.h"
#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/Inputs/Inputs.h"
#include "Testing/Engine/References/ReferenceConstrained.h"
#include <flipflop/EditableTriangulation.h>
#include <flipflop/RegularTriangulation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <tuple>
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

class EditHistory
{
public:
  explicit EditHistory(std::uint64_t seed)
    : make(seed)
  {
    if (this->make.random.integer(0, 1))
    {
      this->edited = EditableTriangulation();
      return;
    }
    this->points = this->some(this->make.random.integer(0, 40));
    this->edited = EditableTriangulation(this->view(this->points), this->weightsOf(this->points));
    for (std::size_t i = 0; i < this->points.size(); ++i)
    {
      this->present.push_back(static_cast<std::int64_t>(i));
    }
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
      this->insert(1);
    }
    else if (what < 7)
    {
      this->remove(1);
    }
    else if (what == 7)
    {
      this->move(1);
    }
    else if (what == 8)
    {
      this->insert(random.integer(0, 1) ? random.integer(0, 5) : 80);
    }
    else if (random.integer(0, 1))
    {
      this->remove(random.pick(this->present.size() + 1));
    }
    else
    {
      this->move(random.pick(this->present.size() + 1));
    }
  }

  /// Is it what a run from nothing gives, in both modes of facets?
  void check()
  {
    Cloud left;
    for (const std::int64_t id : this->present)
    {
      left.push_back(this->points[static_cast<std::size_t>(id)]);
    }
    const std::vector<std::int64_t> ends = this->endsAmong(this->present);
    const ConstraintView constrained(ends.data(), std::int64_t(ends.size() / 2));
    for (const FacetMode facets : { FacetMode::Triangles, FacetMode::Polygons })
    {
      Options options;
      options.threads = 1;
      options.facets = facets;
      ConstrainedTriangulation wanted;
      if (constrained.count > 0)
      {
        wanted = constrainedTriangulation(view(left), constrained, options);
      }
      else
      {
        static_cast<Triangulation&>(wanted) =
          regularTriangulation(view(left), this->weightsOf(left), options);
      }
      if (facets == FacetMode::Polygons && left.size() <= MostByForce)
      {
        this->checkByForce(left, ends, wanted);
      }
      rename(wanted.pointIds, this->present);
      rename(wanted.hiddenIds, this->present);
      rename(wanted.constraintOf, this->numbers);
      ASSERT_TRUE(bitsOf(this->edited.snapshot(options)) == bitsOf(wanted));
    }
    ASSERT_EQ(this->edited.pointCount(), std::int64_t(this->present.size()));
    ASSERT_EQ(this->edited.idCount(), std::int64_t(this->points.size()));
  }

  EditableTriangulation edited;
  Cloud points; ///< by id
  std::vector<std::int64_t> present;
  std::vector<std::array<std::int64_t, 2>> constraints; ///< by number
  std::vector<std::int64_t> numbers;                    ///< of those that are there

private:
  static constexpr std::size_t MostByForce = 8;

  /// Of few points, by rationals: each triple of points, or flips.
  void checkByForce(const Cloud& left, const std::vector<std::int64_t>& ends,
    const ConstrainedTriangulation& found) const
  {
    std::vector<Segment> segments;
    for (std::size_t i = 0; i < ends.size(); i += 2)
    {
      segments.push_back({ ends[i], ends[i + 1] });
    }
    const ReferenceTriangulation wanted = segments.empty()
      ? bruteForceTriangulation(left)
      : bruteForceConstrained(left, segments).triangulation;
    ASSERT_EQ(found.dimension, wanted.dimension);
    ASSERT_EQ(cellsOf(found), wanted.cells);
  }

  static PointView view(const Cloud& cloud)
  {
    return cloud.empty() ? PointView()
                         : PointView(cloud.front().data(), std::int64_t(cloud.size()));
  }
  WeightView weightsOf(const Cloud& cloud) const
  {
    return this->make.isWeighted() && !cloud.empty()
      ? WeightView(cloud.front().data() + 2, std::int64_t(cloud.size()), 3)
      : WeightView();
  }

  static void rename(Buffer<std::int64_t>& indices, const std::vector<std::int64_t>& names)
  {
    for (std::int64_t& index : indices)
    {
      index = names[static_cast<std::size_t>(index)];
    }
  }

  /// The ends of the constraints, as indices of some ids.
  std::vector<std::int64_t> endsAmong(const std::vector<std::int64_t>& ids) const
  {
    std::vector<std::int64_t> ends;
    for (const std::int64_t number : this->numbers)
    {
      for (const std::int64_t id : this->constraints[static_cast<std::size_t>(number)])
      {
        ends.push_back(std::find(ids.begin(), ids.end(), id) - ids.begin());
      }
    }
    return ends;
  }

  bool isEnd(std::int64_t id) const
  {
    return std::any_of(this->numbers.begin(), this->numbers.end(),
      [&](std::int64_t number)
      {
        const auto& ends = this->constraints[static_cast<std::size_t>(number)];
        return ends[0] == id || ends[1] == id;
      });
  }

  /// An edit, and what should have been done; or neither, if constraints cross then.
  template <class Edit, class Note>
  void unlessCrossing(const Edit& edit, const Note& note)
  {
    const auto old = std::make_tuple(this->points, this->present, this->constraints, this->numbers);
    note();
    const std::vector<std::int64_t> ends = this->endsAmong(this->present);
    bool crosses = false;
    try
    {
      Cloud left;
      for (const std::int64_t id : this->present)
      {
        left.push_back(this->points[static_cast<std::size_t>(id)]);
      }
      constrainedTriangulation(
        view(left), ConstraintView(ends.data(), std::int64_t(ends.size() / 2)));
    }
    catch (const Error& error)
    {
      ASSERT_EQ(error.code(), ErrorCode::ConstraintsCross);
      crosses = true;
    }
    bool refused = false;
    try
    {
      edit();
    }
    catch (const Error& error)
    {
      ASSERT_EQ(error.code(), ErrorCode::ConstraintsCross) << error.what();
      refused = true;
    }
    ASSERT_EQ(refused, crosses);
    if (crosses)
    {
      std::tie(this->points, this->present, this->constraints, this->numbers) = old;
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
      const std::size_t which = random.pick(this->numbers.size());
      this->edited.removeConstraints(&this->numbers[which], 1);
      this->numbers.erase(this->numbers.begin() + static_cast<std::ptrdiff_t>(which));
      return;
    }
    std::vector<std::int64_t> ends;
    for (int i = random.integer(1, 3); i > 0; --i)
    {
      ends.push_back(this->present[random.pick(this->present.size())]);
      ends.push_back(this->present[random.pick(this->present.size())]);
    }
    this->unlessCrossing(
      [&] {
        this->edited.insertConstraints({ ends.data(), std::int64_t(ends.size() / 2) });
      },
      [&]
      {
        for (std::size_t i = 0; i < ends.size(); i += 2)
        {
          this->numbers.push_back(std::int64_t(this->constraints.size()));
          this->constraints.push_back({ { ends[i], ends[i + 1] } });
        }
      });
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

  void insert(int count)
  {
    const Cloud fresh = this->some(static_cast<std::size_t>(count));
    const auto first = static_cast<std::int64_t>(this->points.size());
    ASSERT_EQ(this->edited.insert(this->view(fresh), this->weightsOf(fresh)), first);
    for (const Point& p : fresh)
    {
      this->present.push_back(static_cast<std::int64_t>(this->points.size()));
      this->points.push_back(p);
    }
  }

  std::vector<std::int64_t> choose(std::size_t count)
  {
    std::vector<std::int64_t> ids = this->present;
    this->make.random.shuffle(ids);
    ids.resize(count);
    return ids;
  }

  void remove(std::size_t count)
  {
    std::vector<std::int64_t> ids = this->choose(count);
    const auto kept =
      std::partition(ids.begin(), ids.end(), [this](std::int64_t id) { return !this->isEnd(id); });
    if (kept != ids.end())
    {
      EXPECT_THROW(this->edited.remove(ids.data(), std::int64_t(ids.size())), Error);
      ids.erase(kept, ids.end());
    }
    this->unlessCrossing([&] { this->edited.remove(ids.data(), std::int64_t(ids.size())); },
      [&]
      {
        for (const std::int64_t id : ids)
        {
          this->present.erase(std::find(this->present.begin(), this->present.end(), id));
        }
      });
  }

  void move(std::size_t count)
  {
    const std::vector<std::int64_t> ids = this->choose(count);
    const Cloud to = this->some(ids.size());
    const bool keepWeights = this->make.random.integer(0, 1) != 0;
    this->unlessCrossing(
      [&] {
        this->edited.move(ids.data(), view(to), keepWeights ? WeightView() : this->weightsOf(to));
      },
      [&]
      {
        for (std::size_t i = 0; i < ids.size(); ++i)
        {
          Point& p = this->points[static_cast<std::size_t>(ids[i])];
          p = { { to[i][0], to[i][1], keepWeights ? p[2] : to[i][2] } };
        }
      });
  }

  PointMaker make;
};

}
}

#endif
