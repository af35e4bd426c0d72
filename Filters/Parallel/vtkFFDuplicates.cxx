// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFDuplicates.h"

#include "vtkFFBlockExchange.h"

#include "vtkDataSetAttributes.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
//------------------------------------------------------------------------------
void vtkFFDuplicates::Find(const std::vector<Key>& keys, const std::vector<int>& homes,
  vtkFFBlockExchange& exchange, std::vector<bool>& duplicates)
{
  constexpr int home = -1; // before all others
  const int own = exchange.GetProcesses().GetRank();
  vtkFFBlockExchange::Messages messages;
  exchange.Do(
    [&]
    {
      for (std::size_t i = 0; i < keys.size(); ++i)
      {
        if (homes[i] != own)
        {
          vtkFFBlockExchange::Add(&keys[i], 1, messages[homes[i]]);
        }
      }
    });
  exchange.Exchange(messages);
  exchange.Do(
    [&]
    {
      std::vector<std::pair<Key, int>> holders; // the first of each key keeps it
      for (const auto& message : messages)
      {
        for (const Key& key : vtkFFBlockExchange::Values<Key>(message.second))
        {
          holders.emplace_back(key, message.first);
        }
      }
      std::sort(holders.begin(), holders.end());
      const auto first = [&](const Key& key)
      { return std::lower_bound(holders.begin(), holders.end(), std::make_pair(key, home)); };
      for (std::size_t i = 0; i < keys.size() && !holders.empty(); ++i)
      {
        const auto holder = homes[i] == own ? first(keys[i]) : holders.end();
        if (holder != holders.end() && holder->first == keys[i])
        {
          holder->second = home;
        }
      }
      for (auto& message : messages)
      {
        std::vector<char> answers;
        for (const Key& key : vtkFFBlockExchange::Values<Key>(message.second))
        {
          answers.push_back(first(key)->second != message.first);
        }
        message.second = answers;
      }
    });
  exchange.Exchange(messages);
  exchange.Do(
    [&]
    {
      std::vector<std::size_t> taken(static_cast<std::size_t>(exchange.GetProcesses().GetCount()));
      duplicates.assign(keys.size(), false);
      for (std::size_t i = 0; i < keys.size(); ++i)
      {
        if (homes[i] != own)
        {
          duplicates[i] = messages[homes[i]].at(taken[static_cast<std::size_t>(homes[i])]++) != 0;
        }
      }
    });
  exchange.Agree();
}

//------------------------------------------------------------------------------
void vtkFFDuplicates::FindByIds(const flipflop::Buffer<std::int64_t>& ids,
  const flipflop::Buffer<std::int32_t>& blocks, vtkFFBlockExchange& exchange,
  std::vector<bool>& duplicates)
{
  std::vector<Key> keys;
  std::vector<int> homes;
  exchange.Do(
    [&]
    {
      for (const std::int64_t id : ids)
      {
        keys.push_back({ id, 0 });
      }
      homes.assign(blocks.begin(), blocks.end());
    });
  return Find(keys, homes, exchange, duplicates);
}

//------------------------------------------------------------------------------
void vtkFFDuplicates::FindByPlaces(const flipflop::Buffer<double>& places,
  vtkFFBlockExchange& exchange, std::vector<bool>& duplicates)
{
  std::vector<Key> keys;
  std::vector<int> homes;
  exchange.Do(
    [&]
    {
      const auto count = static_cast<std::uint64_t>(exchange.GetProcesses().GetCount());
      for (std::size_t i = 0; i < places.size(); i += 2)
      {
        const double place[2] = { places[i] + 0.0, places[i + 1] + 0.0 }; // no -0
        Key key;
        std::memcpy(key.data(), place, sizeof(place));
        keys.push_back(key);
        // Spread over all processes, wherever the places are.
        std::uint64_t mixed =
          static_cast<std::uint64_t>(key[0]) * 31 + static_cast<std::uint64_t>(key[1]);
        mixed = (mixed ^ (mixed >> 33)) * 0xff51afd7ed558ccdU;
        homes.push_back(static_cast<int>((mixed >> 33) % count));
      }
    });
  return Find(keys, homes, exchange, duplicates);
}

//------------------------------------------------------------------------------
void vtkFFDuplicates::Mark(vtkDataSetAttributes* data, const std::vector<bool>& where, int mark)
{
  const char* name = vtkDataSetAttributes::GhostArrayName();
  const auto marks = vtkSmartPointer<vtkUnsignedCharArray>::New();
  auto* given = vtkUnsignedCharArray::SafeDownCast(data->GetAbstractArray(name));
  marks->SetName(name);
  marks->SetNumberOfValues(static_cast<vtkIdType>(where.size()));
  for (std::size_t i = 0; i < where.size(); ++i)
  {
    const auto place = static_cast<vtkIdType>(i);
    const int others = (given ? given->GetValue(place) : 0) & ~mark;
    marks->SetValue(place, static_cast<unsigned char>(where[i] ? others | mark : others));
  }
  data->AddArray(marks);
}
VTK_ABI_NAMESPACE_END
