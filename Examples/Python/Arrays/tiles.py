# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""A survey in tiles, triangulated block by block, as if it did not fit into memory: tiles.py"""

import tempfile
from pathlib import Path

import numpy as np

from vtkflipflop.arrays import Polygons, stream

with tempfile.TemporaryDirectory() as folder:
    survey, out = Path(folder, "survey"), Path(folder, "out")
    survey.mkdir()
    for number in range(9):
        rng = np.random.default_rng(number)
        xy = rng.random((20_000, 2)) * 100 + [number % 3 * 100, number // 3 * 100]
        points = np.column_stack([xy, np.sin(xy[:, 0] / 30) * 5])
        np.savez(survey / f"tile-{number}.npz", points=points, intensity=rng.integers(0, 999, 20_000, np.uint16))

    # Files by their names: also .npy, and .las. If the run is stopped, the same call goes on.
    found = stream(sorted(survey.glob("*.npz")), out, block_points=30_000)
    print(f"{found.points} points, {found.cells} triangles in {len(found.files)} files, {found.hidden} points hidden")
    assert found.points == 180_000 and found.hidden == 0 and len(found.files) == 6

    with np.load(found.files[0]) as block:
        corners = block["points"][block["simplices"]]
        own = (block["blocks"] == 0).sum()
        others, first = len(block["ids"]) - own, block["ids"][block["simplices"][0]]
        print(f"{found.files[0].name} has {len(corners)} triangles of {own} own points and {others} of others")
        print(f"the first triangle has the points {first}, at {corners[0].round(2).tolist()}")
        print(f"intensities there: {block['intensity'][block['simplices'][0]]}")

    hull = stream(sorted(survey.glob("*.npz")), Path(folder, "hull"), kind="hull", facets="polygons")
    with np.load(hull.files[0]) as block:
        facets = Polygons(block["offsets"], block["connectivity"])
    print(f"a hull of volume {hull.volume:.0f}; this block has {len(facets)} of its {hull.cells} facets")
    assert hull.dimension == 3
