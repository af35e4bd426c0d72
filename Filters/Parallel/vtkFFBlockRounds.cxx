// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFBlockRounds.h"

#include "vtkFFBlockExchange.h"
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

/// The size of the hull of which each block has some cells. Collective.
void measure(const flipflop::BlockRun& run, const flipflop::BlockResult& result,
  vtkFFBlockExchange& exchange, vtkFFBlockRounds::Size& size)
{
  // Volumes are measured from the hull's first point.
  vtkFFBlockExchange::Messages messages;
  exchange.Do(
    [&]
    {
      if (result.cells.pointIds.empty())
      {
        return;
      }
      FirstPoint first{ result.cells.pointIds[0], {} };
      std::copy_n(result.positions.begin(), 3, first.Place);
      for (int process = 0; process < exchange.GetProcesses().GetCount(); ++process)
      {
        vtkFFBlockExchange::Add(&first, 1, messages[process]);
      }
    });
  exchange.Exchange(messages);
  std::vector<vtkIdType> parts(4);
  exchange.Do(
    [&]
    {
      FirstPoint first{ std::numeric_limits<std::int64_t>::max(), {} };
      for (const auto& message : messages)
      {
        for (const FirstPoint& other : vtkFFBlockExchange::Values<FirstPoint>(message.second))
        {
          first = other.Id < first.Id ? other : first;
        }
      }
      const flipflop::BlockMeasure own = run.measure(result, first.Place);
      std::copy_n(own.parts, 4, parts.begin());
    });
  parts = exchange.GetProcesses().Sum(parts);
  exchange.Do(
    [&]
    {
      flipflop::BlockMeasure sum;
      std::copy_n(parts.begin(), 4, sum.parts);
      run.sizeOf(sum, size.Volume, size.Area);
    });
}

}

//------------------------------------------------------------------------------
void vtkFFBlockRounds::Run(flipflop::BlockShape shape, flipflop::BlockPoints&& points,
  const flipflop::Options& options, vtkFFBlockExchange& exchange, flipflop::BlockResult& result,
  Size* size)
{
  const int own = exchange.GetProcesses().GetRank();
  std::unique_ptr<flipflop::BlockRun> run;
  vtkFFBlockExchange::Messages messages;
  const auto send = [&](const std::function<void()>& write)
  {
    exchange.Do([&] { vtkFFRun::Look(options); });
    exchange.Do(write);
    exchange.Exchange(messages);
  };

  send(
    [&]
    {
      const flipflop::BlockPoints all = std::move(points); // not needed after this
      run = std::make_unique<flipflop::BlockRun>(shape, all, options);
      const flipflop::BlockMessage summary = run->summary();
      for (int process = 0; process < exchange.GetProcesses().GetCount(); ++process)
      {
        messages[process] = summary;
      }
    });
  exchange.Do(
    [&]
    {
      std::vector<flipflop::BlockMessage> summaries;
      for (auto& message : messages)
      {
        summaries.push_back(std::move(message.second));
      }
      run->begin(summaries, own);
    });
  for (bool goesOn = true; goesOn;)
  {
    send([&] { messages = run->makeQueries(); });
    goesOn = exchange.GetNumberOfMessages() > 0;
    if (goesOn)
    {
      send(
        [&]
        {
          for (auto& message : messages)
          {
            message.second = run->reply(message.second);
          }
        });
      exchange.Do(
        [&]
        {
          for (const auto& message : messages)
          {
            run->receive(message.first, message.second);
          }
        });
    }
  }
  exchange.Do([&] { result = run->finish(); });
  exchange.Agree();
  if (size)
  {
    measure(*run, result, exchange, *size);
  }
  exchange.Agree();
}
VTK_ABI_NAMESPACE_END
