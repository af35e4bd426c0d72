// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Edits.h"

#include "Problems.h"
#include <flipflop/EditableTriangulation.h>

#include <algorithm>
#include <memory>

namespace flipflop
{
namespace
{

class FlipFlopEdits final : public Program
{
public:
  explicit FlipFlopEdits(const Settings& settings)
    : options(optionsOf(settings))
  {
  }
  void prepare(const Input& given) override
  {
    this->points = EditedPoints(given);
    this->edited = EditableTriangulation(given.points(), given.weights(), this->options);
    this->isWeighted = given.isWeighted;
    std::vector<std::size_t>& gone = this->points.gone;
    std::vector<bool> seen(static_cast<std::size_t>(given.count()));
    gone.erase(std::remove_if(gone.begin(), gone.end(),
                 [&](std::size_t id)
                 {
                   const bool again = seen[id];
                   seen[id] = true;
                   return again;
                 }),
      gone.end());
  }
  void run() override
  {
    const std::size_t count = this->points.count;
    const auto insertEach = [&](const std::vector<double>& x)
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        this->edited.insert(x[3 * i], x[3 * i + 1], x[3 * i + 2]);
      }
    };
    this->times.time("insert_far", count, [&] { insertEach(this->points.far); });
    this->times.time("insert_near", count, [&] { insertEach(this->points.near); });
    this->times.time("remove_near", count,
      [&]
      {
        for (std::size_t i = 0; i < count; ++i)
        {
          this->edited.remove(this->edited.idCount() - 1 - static_cast<std::int64_t>(i));
        }
      });
    this->times.time("remove_far", this->points.gone.size(),
      [&]
      {
        for (const std::size_t id : this->points.gone)
        {
          this->edited.remove(static_cast<std::int64_t>(id));
        }
      });
    this->times.time("insert_many", count,
      [&]
      {
        const double* const x = this->points.many.data();
        const auto n = static_cast<std::int64_t>(count);
        this->edited.insert(PointView(x, n),
          this->isWeighted ? WeightView(x + 2, n, 3) : WeightView(), this->options);
      });
  }
  Metrics metrics() const override { return this->times.metrics(); }

private:
  Options options;
  EditedPoints points;
  bool isWeighted = false;
  EditableTriangulation edited;
  EditTimes times;
};

}

Problem editsProblem()
{
  Problem problem;
  problem.name = "edits";
  problem.isPlane = true;
  problem.warmUp = "uniform";
  problem.programs = { ProgramKind::ours("flipflop",
    [](const Settings& settings) { return std::make_unique<FlipFlopEdits>(settings); }) };
#if defined(FLIPFLOP_HAVE_CGAL)
  append(problem.programs, cgalEditsPrograms());
#endif
  return problem;
}

}
