# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""In place of the extension _core, where the package was built for the VTK of a distribution or of ParaView."""

raise ImportError(
    "This build of vtkflipflop has the VTK classes alone: vtkflipflop.arrays and vtkflipflop.pyvista are in the builds "
    "by pip (pip install . in the source tree)",
    name="vtkflipflop._core",
)
