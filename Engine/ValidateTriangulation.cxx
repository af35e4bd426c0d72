// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Validate.h"

namespace flipflop
{

Validation validate(const PointView&, const WeightView&, const Triangulation&, int)
{
  throw Error(ErrorCode::BadArgument);
}

}
