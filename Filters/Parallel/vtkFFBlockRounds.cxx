// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFBlockRounds.h"

#include "vtkFFBlockExchange.h"
#include "vtkFFMessage.h"
#include "vtkFFRun.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

/// Of a process's share of a hull.
struct FirstPoint
{
  std::int64_t Id;
  double Place[3];
};

}

//------------------------------------------------------------------------------
bool vtkFFBlockRounds::Run(flipflop::BlockShape shape, flipflop::BlockPoints&& points,
  const flipflop::Options& options, vtkFFBlockExchange& exchange, flipflop::BlockResult& result,
  Size* size)
{
  const int own = exchange.GetProcesses().GetRank();
  const int count = exchange.GetProcesses().GetCount();
  std::unique_ptr<flipflop::BlockRun> run;
  vtkFFBlockExchange::Messages messages;
  const auto step = [&](const std::function<void()>& work)
  {
    exchange.Do(
      [&]
      {
        vtkFFRun::Look(options);
        work();
      });
  };

  step(
    [&]
    {
      {
        const flipflop::BlockPoints all = std::move(points); // not needed after this
        run = std::make_unique<flipflop::BlockRun>(shape, all, options);
      }
      const flipflop::BlockMessage introduction = run->introduction();
      for (int process = 0; process < count; ++process)
      {
        messages[process] = introduction;
      }
    });
  if (!exchange.Exchange(messages))
  {
    return false;
  }
  step(
    [&]
    {
      std::vector<flipflop::BlockMessage> introductions;
      for (auto& message : messages)
      {
        introductions.push_back(std::move(message.second));
      }
      run->begin(introductions, own);
    });

  for (;;)
  {
    messages.clear();
    step([&] { messages = run->ask(); });
    if (!exchange.Exchange(messages))
    {
      return false;
    }
    if (exchange.GetNumberOfMessages() == 0)
    {
      break;
    }
    step(
      [&]
      {
        for (auto& message : messages)
        {
          message.second = run->answer(message.second);
        }
      });
    if (!exchange.Exchange(messages))
    {
      return false;
    }
    step(
      [&]
      {
        for (const auto& message : messages)
        {
          run->take(message.first, message.second);
        }
      });
  }
  step([&] { result = run->finish(); });
  if (!size)
  {
    return exchange.IsWell();
  }

  // Volumes are measured from the hull's first point.
  messages.clear();
  step(
    [&]
    {
      if (result.cells.pointIds.empty())
      {
        return;
      }
      FirstPoint first{ result.cells.pointIds[0], {} };
      std::copy_n(result.places.begin(), 3, first.Place);
      for (int process = 0; process < count; ++process)
      {
        vtkFFMessage::Add(&first, 1, messages[process]);
      }
    });
  if (!exchange.Exchange(messages))
  {
    return false;
  }
  std::vector<vtkIdType> parts(4);
  step(
    [&]
    {
      FirstPoint first{ std::numeric_limits<std::int64_t>::max(), {} };
      for (const auto& message : messages)
      {
        for (const FirstPoint& other : vtkFFMessage::Values<FirstPoint>(message.second))
        {
          first = other.Id < first.Id ? other : first;
        }
      }
      const flipflop::BlockMeasure measure = run->measure(result, first.Place);
      std::copy_n(measure.parts, 4, parts.begin());
    });
  if (!exchange.IsWell())
  {
    return false;
  }
  parts = exchange.GetProcesses().Sum(parts);
  step(
    [&]
    {
      flipflop::BlockMeasure sum;
      std::copy_n(parts.begin(), 4, sum.parts);
      run->sizeOf(sum, size->Volume, size->Area);
    });
  return exchange.IsWell();
}
VTK_ABI_NAMESPACE_END
