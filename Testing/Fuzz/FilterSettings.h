// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Calls of the filters' setters, in any order and with any values.
#ifndef flipflop_fuzz_FilterSettings_h
#define flipflop_fuzz_FilterSettings_h

#include "Bytes.h"

class vtkObject;

namespace flipflop
{
namespace fuzz
{

/// A few calls. The same bytes are the same calls, for another filter of the class too.
void drawSettings(Bytes& bytes, vtkObject* filter);

}
}

#endif
