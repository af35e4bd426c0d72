# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Exact convex hulls and regular triangulations of NumPy's arrays. Nothing but numpy is needed.

    import numpy as np
    from vtkflipflop.arrays import convex_hull

    hull = convex_hull(np.random.default_rng(1).random((1000, 3)))
    print(len(hull.vertices), hull.volume, hull.simplices[0])

Points are anything that NumPy reads as n rows of 2 or 3 real numbers, in any type, byte order and layout; float32 and
float64 are not copied where a row's numbers lie side by side. No number is rounded: one that no double holds is an
error. Masked points are left out, and ids stay the caller's; a masked value of interpolate() is NaN, and so is what it
enters; anywhere else, a masked entry is an InputError. Results are frozen; their arrays are the engine's memory,
and read-only. Names are scipy.spatial's where it has them. Points are kept, not copied: do not change them while a
result is in use.

All calls release the GIL and stop at Ctrl-C. These keywords are common to them:

threads : int
    1 or more; 0, the default: as many as the machine has. The result never depends on it.
non_finite : {"error", "ignore"}
    what NaN and infinity lead to: an InputError that names the first, or that these points are left out
engine : {"automatic", "cpu", "cuda"}
    who does the work. The result is the same.
progress : callable, bool or None
    called with the fraction that is done, 0 to 1, now and then; if it returns False, the run ends with an
    AbortedError. True shows tqdm's bar.
"""

from __future__ import annotations

from ._alpha import AlphaComplex
from ._batch import HullBatch, TriangulationBatch, convex_hulls, regular_triangulations
from ._constrained import ConstrainedTriangulation
from ._constraints import SplitConstraints, split_crossings
from ._directions import directions_of, lonlat_of
from ._edit import EditableTriangulation
from ._errors import AbortedError, DeviceError, FlipFlopError, InputError, OutOfMemoryError
from ._furthest_site import FurthestSiteDiagram, FurthestSiteTriangulation, furthest_site_triangulation
from ._half_spaces import HalfSpaceIntersection, half_space_intersection
from ._hull import ConvexHull, Diameter, OrientedBox, Side, convex_hull, convexify
from ._image import Image
from ._las import LasPoints, read_las
from ._lines import JoinedTriangulation, constrained_triangulation
from ._power_diagram import PowerDiagram
from ._rescaled import RescaledTriangulation
from ._results import Polygons, Validation
from ._refine import RefinedMesh, refined_mesh
from ._selection import CellSelection
from ._spherical import SphericalDiagram, SphericalTriangulation, spherical_triangulation, spherical_voronoi
from ._stream import Streamed, stream
from ._terrain import TerrainMesh, terrain_mesh
from ._transport import CentroidalCells, PrescribedAreas, centroidal_cells, prescribed_areas
from ._triangulation import RegularTriangulation, alpha_complex, power_diagram, regular_triangulation
from ._voronoi import VoronoiDiagram, voronoi_diagram

__all__ = [
    "AbortedError",
    "AlphaComplex",
    "CellSelection",
    "CentroidalCells",
    "ConstrainedTriangulation",
    "ConvexHull",
    "DeviceError",
    "Diameter",
    "EditableTriangulation",
    "FlipFlopError",
    "FurthestSiteDiagram",
    "FurthestSiteTriangulation",
    "HalfSpaceIntersection",
    "HullBatch",
    "Image",
    "InputError",
    "JoinedTriangulation",
    "LasPoints",
    "OrientedBox",
    "OutOfMemoryError",
    "Polygons",
    "PowerDiagram",
    "PrescribedAreas",
    "RefinedMesh",
    "RegularTriangulation",
    "RescaledTriangulation",
    "Side",
    "SphericalDiagram",
    "SphericalTriangulation",
    "SplitConstraints",
    "Streamed",
    "TerrainMesh",
    "TriangulationBatch",
    "Validation",
    "VoronoiDiagram",
    "alpha_complex",
    "centroidal_cells",
    "constrained_triangulation",
    "convex_hull",
    "convex_hulls",
    "convexify",
    "directions_of",
    "furthest_site_triangulation",
    "half_space_intersection",
    "lonlat_of",
    "power_diagram",
    "prescribed_areas",
    "read_las",
    "refined_mesh",
    "regular_triangulation",
    "regular_triangulations",
    "spherical_triangulation",
    "spherical_voronoi",
    "split_crossings",
    "stream",
    "terrain_mesh",
    "validate",
    "voronoi_diagram",
]


def validate(result: ConvexHull | RegularTriangulation, *, threads: int = 0) -> Validation:
    """Decides exactly whether a hull or a triangulation is right: that of its points, in its canonical form.

    This is an independent check, near-linear in the number of points.
    """
    if not hasattr(result, "validate"):
        raise TypeError(f"result is what convex_hull() or regular_triangulation() gives, not {type(result).__name__}")
    return result.validate(threads=threads)
