// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RegularTriangulation.h"

namespace flipflop
{

Triangulation regularTriangulation(const PointView&, const WeightView&, const Options&)
{
  throw Error(ErrorCode::BadArgument);
}

}
