# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""South America as a treemap: cells whose areas are those of its countries, in Brazil those of its regions."""

import numpy as np
import pyvista as pv
from _common import INK, look, plotter, write

from vtkflipflop.arrays import prescribed_areas

# Square kilometres, and where about the middle is: degrees east and north. Countries: United Nations, Demographic
# Yearbook. Regions: IBGE, 2002; Brazil is their sum.
REGIONS = {
    "North": (3_853_327, -60, -4),
    "Northeast": (1_554_257, -41, -8),
    "Central-West": (1_606_371, -53, -16),
    "Southeast": (924_511, -45, -20),
    "South": (576_410, -52, -27),
}
COUNTRIES = {
    "Brazil": (sum(area for area, _, _ in REGIONS.values()), -53, -11),
    "Argentina": (2_780_400, -65, -35),
    "Peru": (1_285_216, -75, -9),
    "Colombia": (1_141_748, -73, 4),
    "Bolivia": (1_098_581, -65, -17),
    "Venezuela": (912_050, -66, 7),
    "Chile": (756_102, -71, -36),
    "Paraguay": (406_752, -58, -23),
    "Ecuador": (256_369, -78, -1),
    "Guyana": (214_969, -59, 5),
    "Uruguay": (173_626, -56, -33),
    "Suriname": (163_820, -56, 4),
    "Fr. Guiana": (83_534, -53, 4),
}
COLOURS = ["#a9c8ee", "#f0c9a3", "#b9d9b0", "#e8b4b0", "#d2c3e6", "#e9e1a6", "#b5dcdc", "#d9d9d9"]


def treemap(parts, domain):
    """Compact cells of the parts' areas: sites move to the centroids of their cells, and are weighed anew."""
    areas, *positions = (np.array(column, float) for column in zip(*parts.values()))
    sites = np.column_stack(positions)
    for _ in range(40):
        sites = prescribed_areas(sites, areas, domain, tolerance=1e-3).centroids
    found = prescribed_areas(sites, areas, domain)
    wanted = areas / areas.sum() * found.areas.sum()
    error = abs(found.diagram.areas / wanted - 1).max()
    print(f"{len(found.diagram)} cells, areas met to {'1e-6' if error < 1.01e-6 else error}")
    assert found.converged and error < 1.01e-6
    return found.diagram


def draw(scene, diagram, names, height, style):
    corners = np.column_stack([diagram.vertices, np.full(len(diagram.vertices), height)])
    cells = pv.PolyData.from_irregular_faces(corners, diagram.regions)
    if style:
        colours = [COLOURS[site % len(COLOURS)] for site in diagram.sites]
        cells.cell_data["colour"] = np.array([pv.Color(colour).int_rgb for colour in colours], np.uint8)
        scene.add_mesh(cells, scalars="colour", rgb=True, lighting=False)
    scene.add_mesh(cells.extract_all_edges(), color=INK, line_width=4 if style else 1.5)
    for name, area, (x, y) in zip(names, diagram.areas, diagram.centroids):
        if not name:
            continue
        # As wide as the cell, about.
        text = pv.Text3D(name, depth=0.001)
        size = min(0.08, np.sqrt(area) / len(name))
        text.scale(size / (text.bounds[3] - text.bounds[2]), inplace=True)
        text.translate(np.array([x, y, height + 0.02]) - text.center, inplace=True)
        scene.add_mesh(text, color=INK, lighting=False)


turns = np.linspace(0, 2 * np.pi, 8, endpoint=False) + np.pi / 8
octagon = np.column_stack([np.cos(turns), np.sin(turns)])
countries = treemap(COUNTRIES, octagon)
brazil = countries.vertices[countries.regions[list(COUNTRIES).index("Brazil")]]
regions = treemap(REGIONS, brazil)

scene = plotter(1, (760, 800))
draw(scene, countries, ["", *list(COUNTRIES)[1:]], 0, True)
draw(scene, regions, REGIONS, 0.01, False)
look(scene, (0, 0, 1), (0, 1, 0), "the countries of South America, and the regions of Brazil, by area")
write(scene, "gallery-treemap.png")
