// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Any edits of a triangulation: an error of a promised code changes nothing, and what is left is
/// the triangulation of a run from nothing.
#include "Clouds.h"
#include "Demand.h"
#include "EngineCalls.h"
#include "Testing/Engine/Calls/Bits.h"
#include <flipflop/EditableTriangulation.h>
#include <flipflop/RegularTriangulation.h>

#include <algorithm>
#include <array>
#include <vector>

namespace flipflop
{
namespace fuzz
{

namespace
{

/// Edits, and what should be there after them.
class Edits
{
public:
  explicit Edits(Bytes& from)
    : bytes(from)
    , weighted(from.flag())
  {
  }

  void step()
  {
    switch (this->bytes.below(6))
    {
      case 0:
      case 1:
        this->insert();
        break;
      case 2:
        this->remove();
        break;
      case 3:
        this->move();
        break;
      case 4:
        this->insertConstraint();
        break;
      default:
        this->removeConstraint();
    }
  }

  void check() const
  {
    std::vector<std::int64_t> ids;
    test::Cloud left;
    for (std::size_t id = 0; id < this->points.size(); ++id)
    {
      if (this->isThere[id])
      {
        ids.push_back(static_cast<std::int64_t>(id));
        left.push_back(this->points[id]);
      }
    }
    const auto rankOf = [&ids](std::int64_t id)
    { return std::lower_bound(ids.begin(), ids.end(), id) - ids.begin(); };
    std::vector<std::int64_t> ends, numbers;
    for (std::size_t number = 0; number < this->constraints.size(); ++number)
    {
      if (this->constraints[number][0] >= 0)
      {
        numbers.push_back(static_cast<std::int64_t>(number));
        ends.push_back(rankOf(this->constraints[number][0]));
        ends.push_back(rankOf(this->constraints[number][1]));
      }
    }
    const auto count = static_cast<std::int64_t>(left.size());
    const PointView view = left.empty() ? PointView() : PointView(left[0].data(), count);
    ConstrainedTriangulation wanted;
    if (numbers.empty())
    {
      static_cast<Triangulation&>(wanted) = regularTriangulation(view,
        this->weighted && count > 0 ? WeightView(left[0].data() + 2, count, 3) : WeightView());
    }
    else
    {
      wanted = constrainedTriangulation(
        view, ConstraintView(ends.data(), static_cast<std::int64_t>(numbers.size())));
    }
    rename(wanted.pointIds, ids);
    rename(wanted.hiddenIds, ids);
    rename(wanted.constraintOf, numbers);
    demand(test::bitsOf(this->edited.snapshot()) == test::bitsOf(wanted),
      "edits give another triangulation than a run from nothing");
    demand(this->edited.pointCount() == count &&
        this->edited.idCount() == static_cast<std::int64_t>(this->points.size()),
      "points are not counted");
  }

private:
  static void rename(Buffer<std::int64_t>& indices, const std::vector<std::int64_t>& names)
  {
    for (std::int64_t& index : indices)
    {
      index = names[static_cast<std::size_t>(index)];
    }
  }

  test::Point draw()
  {
    return { this->bytes.number(), this->bytes.number(),
      this->weighted ? this->bytes.number() : 0.0 };
  }
  static bool isFinite(const test::Point& p)
  {
    return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
  }
  /// Often of a point that was there once.
  std::int64_t drawId()
  {
    return this->points.empty() || this->bytes.oneOf(16)
      ? this->bytes.integer()
      : this->bytes.below(static_cast<int>(std::min<std::size_t>(this->points.size(), 256)));
  }
  bool contains(std::int64_t id) const
  {
    return id >= 0 && id < static_cast<std::int64_t>(this->points.size()) &&
      this->isThere[static_cast<std::size_t>(id)];
  }

  /// @return whether the edit was made
  template <class Edit>
  static bool made(bool isRight, const Edit& edit)
  {
    try
    {
      edit();
      demand(isRight, "an edit that is wrong was made");
      return true;
    }
    catch (const Error& error)
    {
      demand(!isRight || error.code() == ErrorCode::ConstraintsCross, "an edit was refused");
      demand(error.code() == ErrorCode::NonFinite || error.code() == ErrorCode::BadArgument ||
          error.code() == ErrorCode::ConstraintPoint || error.code() == ErrorCode::ConstraintsCross,
        "an edit has an error of another code");
      return false;
    }
  }

  bool anyWeight() const
  {
    return std::any_of(
      this->points.begin(), this->points.end(), [](const test::Point& p) { return p[2] != 0; });
  }
  bool anyConstraint() const
  {
    return std::any_of(this->constraints.begin(), this->constraints.end(),
      [](const auto& ends) { return ends[0] >= 0; });
  }

  void insert()
  {
    const test::Point p = this->draw();
    const bool excluded = p[2] != 0 && this->anyConstraint();
    if (made(isFinite(p) && !excluded, [&] { this->edited.insert(p[0], p[1], p[2]); }))
    {
      this->points.push_back(p);
      this->isThere.push_back(true);
    }
  }
  void remove()
  {
    const std::int64_t id = this->drawId();
    const bool isEnd = std::any_of(this->constraints.begin(), this->constraints.end(),
      [id](const auto& ends) { return ends[0] >= 0 && (ends[0] == id || ends[1] == id); });
    if (made(this->contains(id) && !isEnd, [&] { this->edited.remove(id); }))
    {
      this->isThere[static_cast<std::size_t>(id)] = false;
    }
  }
  void move()
  {
    const std::int64_t id = this->drawId();
    const test::Point p = this->draw();
    if (made(this->contains(id) && std::isfinite(p[0]) && std::isfinite(p[1]),
          [&] { this->edited.move(id, p[0], p[1]); }))
    {
      std::copy_n(p.begin(), 2, this->points[static_cast<std::size_t>(id)].begin());
    }
  }
  void insertConstraint()
  {
    const std::int64_t ends[2] = { this->drawId(), this->drawId() };
    const bool isRight = this->contains(ends[0]) && this->contains(ends[1]) && !this->anyWeight();
    if (made(isRight, [&] { this->edited.insertConstraints({ ends, 1 }); }))
    {
      this->constraints.push_back({ ends[0], ends[1] });
    }
  }
  void removeConstraint()
  {
    const std::int64_t number = this->bytes.oneOf(8)
      ? this->bytes.integer()
      : this->bytes.below(
          static_cast<int>(std::min<std::size_t>(1 + this->constraints.size(), 256)));
    const bool isRight = number >= 0 &&
      number < static_cast<std::int64_t>(this->constraints.size()) &&
      this->constraints[static_cast<std::size_t>(number)][0] >= 0;
    if (made(isRight, [&] { this->edited.removeConstraints(&number, 1); }))
    {
      this->constraints[static_cast<std::size_t>(number)] = { -1, -1 };
    }
  }

  Bytes& bytes;
  const bool weighted;
  EditableTriangulation edited;
  test::Cloud points;
  std::vector<bool> isThere;
  std::vector<std::array<std::int64_t, 2>> constraints;
};

}

void fuzzEdits(Bytes& bytes)
{
  Edits edits(bytes);
  for (int step = 0; step < 200 && !bytes.empty(); ++step)
  {
    edits.step();
    edits.check();
  }
}

}
}
