// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FlipFlop/CpuBuilderBody.h"

#include "Geometry/HullCones.h"
#include "Geometry/HullLocator.h"
#include "Geometry/HullStart.h"

namespace flipflop
{

template class CpuBuilder<HullGeometry>;

}
