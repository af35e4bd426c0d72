// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include <flipflop/Memory.h>

#include "Support/StrictArithmetic.h"

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace flipflop
{

void adviseHugePages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes)
{
#if defined(__linux__)
  madvise(memory, bytes, MADV_HUGEPAGE);
#endif
}

}
