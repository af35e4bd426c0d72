// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What launches of one kernel have come to, for reports.
#ifndef flipflop_KernelTally_h
#define flipflop_KernelTally_h

#include <cstdint>
#include <functional>
#include <map>
#include <string>

namespace flipflop
{

struct KernelTally
{
  std::int64_t launches = 0;
  std::int64_t items = 0; ///< on a device: of launches that were measured
  std::int64_t bytes = 0; ///< of the items, as the kernel declares them; of copies, really
  double seconds = 0;     ///< on a device: of launches that were measured
};

/// By kernel name.
class KernelTallies
{
public:
  using Map = std::map<std::string, KernelTally, std::less<>>;

  /// Every launch looks this up: no string is made for a name that is known.
  KernelTally& of(const char* name)
  {
    const auto found = this->all.find(name);
    return found != this->all.end() ? found->second : this->all[name];
  }
  const Map& map() const { return this->all; }

private:
  Map all;
};

}

#endif
