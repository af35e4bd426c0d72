// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What an interpolation needs before its first position: for many positions the values in the
/// order of the sites, and gradients.
#ifndef flipflop_TaskValues_h
#define flipflop_TaskValues_h

#include "Query/InterpolationTask.h"
#include "Query/PreparedTriangulation.h"
#include "Query/SiteGradients.h"
#include "Support/Monitor.h"
#include "Support/Parallel.h"
#include <flipflop/Buffer.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace flipflop
{

class TaskValues
{
public:
  /// @param task      will refer to this object
  /// @param positions at how many values are wanted
  /// @throw Error OutOfMemory, Aborted
  void prepare(const PreparedTriangulation& prepared, std::int64_t positions,
    InterpolationTask& task, Monitor& monitor)
  {
    const bool areMany = positions > static_cast<std::int64_t>(prepared.sites.count()) / 8;
    if (areMany)
    {
      this->orderValues(prepared.sites, task);
    }
    if (task.method == Interpolation::CloughTocher)
    {
      this->gradients.emplace(prepared, task, areMany, monitor);
      task.gradients = &*this->gradients;
    }
  }

private:
  void orderValues(const Sites& sites, InterpolationTask& task)
  {
    constexpr std::size_t SitesPerTask = 1 << 14;
    const auto components = static_cast<std::size_t>(task.components);
    this->values.allocate(sites.count() * components);
    eachChunk(sites.count(), SitesPerTask,
      [&](std::size_t begin, std::size_t end, std::size_t)
      {
        for (std::size_t site = begin; site < end; ++site)
        {
          std::copy_n(task.valuesOf(sites, static_cast<std::uint32_t>(site)), components,
            this->values.data() + site * components);
        }
      });
    task.values = this->values.data();
    task.areBySite = true;
  }

  Buffer<double> values;
  std::optional<SiteGradients> gradients;
};

}

#endif
