// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// VTK's own filters, from its newest release.
#ifndef flipflop_VtkContenders_h
#define flipflop_VtkContenders_h

#include "Contender.h"

namespace flipflop
{

/// @param filter a name that vtk_contenders.py knows; its output is judged as a hull.
ContenderFactory vtkHulls(const std::string& filter);

/// The same, judged as a Delaunay triangulation in the plane.
/// @param threads for VTK's vtkSMPTools
ContenderFactory vtkTriangulations(const std::string& filter, int threads);

/// For the report. Ends the program where FLIPFLOP_VTK_PYTHON names no Python that has VTK.
std::string vtkVersion();

}

#endif
