// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PowerDiagram.h"

namespace flipflop
{

PowerDiagram powerDiagram(const PointView&, const WeightView&, const Triangulation&, const double*)
{
  throw Error(ErrorCode::BadArgument);
}

}
