// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the lists of inputs are written with.
#ifndef flipflop_test_InputMaking_h
#define flipflop_test_InputMaking_h

#include "Testing/Engine/Inputs/Inputs.h"

namespace flipflop
{
namespace test
{

/// @p count points. @param make Point (int): one by its number
template <class Make>
Cloud generate(int count, const Make& make)
{
  Cloud cloud;
  cloud.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
  {
    cloud.push_back(make(i));
  }
  return cloud;
}

/// Special inputs by their names.
struct InputList
{
  std::vector<Input> inputs;

  void add(std::string name, std::function<Cloud()> make)
  {
    this->inputs.push_back({ std::move(name), 0, std::move(make) });
  }
  template <class Make>
  void addRandom(std::string name, std::uint64_t seed, Make make)
  {
    this->inputs.push_back({ std::move(name), seed,
      [make, seed]()
      {
        Random random(seed);
        return make(random);
      } });
  }
};

}
}

#endif
