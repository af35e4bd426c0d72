// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FlipFlop/CpuBuilderBody.h"

#include "Geometry/LiftedStart.h"

namespace flipflop
{

template class CpuBuilder<LiftedGeometry<true>>;

}
