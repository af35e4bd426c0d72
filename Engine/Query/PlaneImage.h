// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Values at all pixels of an image.
#ifndef flipflop_PlaneImage_h
#define flipflop_PlaneImage_h

#include "Query/PlaneInterpolator.h"

namespace flipflop
{

/// @throw Error BadArgument, OutOfMemory, Aborted
void interpolatePixels(const PreparedTriangulation& prepared, const InterpolationTask& task,
  const ImageGrid& grid, const ImageView& result, const Options& options);

}

#endif
