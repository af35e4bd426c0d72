// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What must hold, else the fuzzer has found something.
#ifndef flipflop_fuzz_Demand_h
#define flipflop_fuzz_Demand_h

#include <string>

namespace flipflop
{
namespace fuzz
{

/// Say what is wrong and end the process, unless it holds.
void demand(bool holds, const std::string& what);

}
}

#endif
