// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A triangulation that is edited, next to the lists of what should be there.
#ifndef flipflop_test_MirroredEdits_h
#define flipflop_test_MirroredEdits_h

#include "Testing/Engine/Calls/Bits.h"
#include "Testing/Engine/Conformance/Compare.h"
#include "Testing/Engine/Query/PlaneQueries.h"
#include "Testing/Engine/References/ReferenceConstrained.h"
#include <flipflop/EditableTriangulation.h>
#include <flipflop/RegularTriangulation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace flipflop
{
namespace test
{

class MirroredEdits
{
public:
  /// @param hasWeights the third coordinates of points are their weights
  explicit MirroredEdits(bool hasWeights = false)
    : isWeighted(hasWeights)
  {
  }

  /// Begin with points.
  void begin(const Cloud& cloud)
  {
    this->edited = EditableTriangulation(view(cloud), this->weightsOf(cloud));
    this->add(cloud);
  }

  void insert(const Cloud& cloud)
  {
    const auto first = static_cast<std::int64_t>(this->points.size());
    ASSERT_EQ(this->edited.insert(view(cloud), this->weightsOf(cloud)), first);
    this->add(cloud);
  }

  /// Of points that no constraint ends at.
  void remove(const std::vector<std::int64_t>& ids)
  {
    this->unlessCrossing([&] { this->edited.remove(ids.data(), std::int64_t(ids.size())); },
      [&]
      {
        for (const std::int64_t id : ids)
        {
          this->present.erase(std::find(this->present.begin(), this->present.end(), id));
        }
        this->last.clear();
      });
  }

  void move(const std::vector<std::int64_t>& ids, const Cloud& to, bool keepWeights = true)
  {
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
        this->last = ids;
      });
  }

  /// @param ends two ids a constraint
  void insertConstraints(const std::vector<std::int64_t>& ends)
  {
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
        this->last.clear();
      });
  }

  void removeConstraint(std::int64_t number)
  {
    this->edited.removeConstraints(&number, 1);
    this->numbers.erase(std::find(this->numbers.begin(), this->numbers.end(), number));
    this->last.clear();
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
    ASSERT_EQ(this->edited.dividedEdges(), this->dividing());
    ASSERT_EQ(this->edited.pointCount(), std::int64_t(this->present.size()));
    ASSERT_EQ(this->edited.idCount(), std::int64_t(this->points.size()));
  }

  const bool isWeighted;
  EditableTriangulation edited;
  Cloud points; ///< by id
  std::vector<std::int64_t> present;
  std::vector<std::array<std::int64_t, 2>> constraints; ///< by number
  std::vector<std::int64_t> numbers;                    ///< of those that are there
  std::vector<std::int64_t> last; ///< ids of the last edit, if it was an insertion or a move

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
    return this->isWeighted && !cloud.empty()
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

  /// An edit, and what should have been done; or neither, if constraints cross then.
  template <class Edit, class Note>
  void unlessCrossing(const Edit& edit, const Note& note)
  {
    const auto old =
      std::make_tuple(this->points, this->present, this->constraints, this->numbers, this->last);
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
      std::tie(this->points, this->present, this->constraints, this->numbers, this->last) = old;
    }
  }

  void add(const Cloud& cloud)
  {
    this->last.clear();
    for (const Point& p : cloud)
    {
      this->last.push_back(static_cast<std::int64_t>(this->points.size()));
      this->present.push_back(this->last.back());
      this->points.push_back(p);
    }
  }

  /// How many points of the last edit are inside constraints and visible, by rationals.
  std::int64_t dividing() const
  {
    const ConstrainedTriangulation found = this->edited.snapshot();
    const auto& ids = found.pointIds;
    std::int64_t count = 0;
    for (const std::int64_t id : this->last)
    {
      bool isInside = false;
      bool isAtEnd = false;
      for (const std::int64_t number : this->numbers)
      {
        const auto& ends = this->constraints[static_cast<std::size_t>(number)];
        const Point& p = this->points[static_cast<std::size_t>(id)];
        const Point& a = this->points[static_cast<std::size_t>(ends[0])];
        const Point& b = this->points[static_cast<std::size_t>(ends[1])];
        const int axis = a[0] != b[0] ? 0 : 1;
        isAtEnd = isAtEnd || (p[0] == a[0] && p[1] == a[1]) || (p[0] == b[0] && p[1] == b[1]);
        isInside = isInside ||
          (p[axis] > std::min(a[axis], b[axis]) && p[axis] < std::max(a[axis], b[axis]) &&
            orientation(a, b, p) == 0);
      }
      count += isInside && !isAtEnd && std::binary_search(ids.begin(), ids.end(), id) ? 1 : 0;
    }
    return found.dimension == 2 ? count : 0;
  }
};

}
}

#endif
