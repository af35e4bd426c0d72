// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Bytes.h"
#include "Demand.h"

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <thread>

namespace flipflop
{
namespace fuzz
{

double Bytes::number()
{
  const int kind = this->below(16);
  switch (kind)
  {
    case 8: // decimals, which no double holds
      return this->raw<std::int8_t>() / 10.0;
    case 9: // beside a small number
      return this->raw<std::int8_t>() * (1.0 + this->raw<std::int8_t>() * 0x1p-52);
    case 10: // far away, and beside that
      return 0x1p52 + this->raw<std::int8_t>();
    case 11: // of any size
      return std::ldexp(this->raw<std::int8_t>(), 4 * this->below(256) - 512);
    case 12:
      return std::ldexp(this->raw<std::int8_t>(), this->flag() ? 1016 : -1074);
    case 13:
      return static_cast<double>(this->raw<float>());
    case 14:
      return this->raw<double>();
    case 15:
    {
      using Limits = std::numeric_limits<double>;
      const int which = this->byte();
      static const double special[] = { -0.0, Limits::quiet_NaN(), Limits::infinity(),
        -Limits::infinity(), Limits::max(), -Limits::max(), Limits::denorm_min(),
        Limits::max() / 2 };
      return special[which < 128 ? which % 4 : 4 + which % 4];
    }
    default:
      return this->raw<std::int8_t>();
  }
}

void demand(bool holds, const std::string& what)
{
  static std::atomic_flag found = ATOMIC_FLAG_INIT;
  if (!holds)
  {
    // Of two threads that find something, one ends the process, and libFuzzer keeps the input.
    while (found.test_and_set())
    {
      std::this_thread::sleep_for(std::chrono::seconds(1));
    }
    std::cerr << "FOUND: " << what << std::endl;
    std::abort();
  }
}

}
}
