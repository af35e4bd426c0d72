// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFBlockRounds.h"

#include "vtkFFBlockExchange.h"
#include "vtkFFBlockRun.h"

#include <memory>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
bool vtkFFBlockRounds::Run(flipflop::BlockShape shape, flipflop::BlockPoints&& points,
  const flipflop::Options& options, const std::function<void()>& look, vtkFFBlockExchange& exchange,
  flipflop::BlockResult& result)
{
  const int own = exchange.GetProcesses().GetRank();
  const int count = exchange.GetProcesses().GetCount();
  std::unique_ptr<vtkFFBlockRun> run;
  vtkFFBlockExchange::Messages messages;
  const auto step = [&](const std::function<void()>& work)
  {
    exchange.Do(
      [&]
      {
        look();
        work();
      });
  };

  step(
    [&]
    {
      {
        const flipflop::BlockPoints all = std::move(points); // not needed after this
        run = std::make_unique<vtkFFBlockRun>(shape, all, options);
      }
      const flipflop::BlockMessage introduction = run->Introduction();
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
      run->Begin(introductions, own);
    });

  for (;;)
  {
    messages.clear();
    step([&] { messages = run->Ask(); });
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
          message.second = run->Answer(message.second);
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
          run->Take(message.first, message.second);
        }
      });
  }
  step([&] { result = run->Finish(); });
  return exchange.IsWell();
}
VTK_ABI_NAMESPACE_END
