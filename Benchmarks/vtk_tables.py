# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The picture and tables of the runs beside VTK's newest release: hulls, and triangulations."""
import plotting
from plotting import legend_above, nice_size, plt, save, table


class Subject:
    """One of the two.

    peers: a name and a colour each; against: those to give ratios to; panels: what is drawn.
    """

    def __init__(self, title, counted, peers, against, panels):
        self.title, self.counted = title, counted
        self.PEERS, self.against, self.panels = peers, against, panels
        self.BEGIN = f"<!-- vtk {title} tables: begin -->"
        self.END = f"<!-- vtk {title} tables: end -->"
        self.picture = f"vtk-{title}.png"

    def drawn(self, results):
        return [name for name in self.panels if len(results.sizes(name)) > 1]

    def figures(self, results, folder):
        names = self.drawn(results)
        if not names:
            return
        figure, grid = plt.subplots(
            1, len(names), figsize=(4 * len(names), 4), squeeze=False, layout="constrained"
        )
        for axes, name in zip(grid[0], names):
            for contender, threads, text, colour in results.lines():
                axes.loglog(*results.series(name, contender, "seconds_median", threads), "o-",
                            color=colour, label=text)  # fmt: skip
            axes.set_title(self.panels[name])
            axes.set_xlabel("number of points")
        grid[0][0].set_ylabel("running time (s)")
        legend_above(figure, *grid[0][0].get_legend_handles_labels())
        save(figure, folder, self.picture)

    def tables(self, results, machine):
        parts = []
        if machine:
            parts.append(
                f"Measured on {machine['processor']}, {machine['cores']} cores, g++ "
                f"{machine['compiler']}; VTK {machine['vtk']}; seed {machine['seed']}."
            )
        if self.drawn(results):
            parts.append(f"![Running time over the number of points](Figures/{self.picture})")
        name = self.title.capitalize()
        parts += [f"## {name} beside VTK: how many are right", summary_table(results)]
        parts += [f"## {name} beside VTK: running time (a star: the result is wrong)"]
        parts += [plotting.time_table(results, self.counted, self.against)]
        parts += [f"## {name} beside VTK: verdicts", verdict_table(results)]
        parts += [f"## {name} beside VTK: vertices and memory"]
        parts += [plotting.vertices_and_memory_table(results)]
        return "\n\n".join(parts) + "\n"


def contenders(results):
    """Name and rows of each, ours first, as one of as many as there are numbers of threads."""
    lines = sorted(results.lines(), key=lambda line: line[0] != "flipflop")
    cases = plotting.cases(results)
    return [
        (name, {case: results.row(*case, contender, threads) for case in cases})
        for contender, threads, name, _ in lines
    ]


def summary_table(results):
    """Where there are only gaps, what is there of the triangulation is right."""
    kinds = ["ok", "wrong", "failed", "timeout", "skipped"]
    rows = []
    for name, found in contenders(results):
        given = [row for row in found.values() if row]
        status = [row["status"] for row in given]
        gaps = sum(row["message"].startswith("only gaps") for row in given)
        rows.append([name] + [str(status.count(kind)) for kind in kinds])
        rows[-1][2] += f" ({gaps} only gaps)" if gaps else ""
    return table(["", "right"] + kinds[1:], rows)


def verdict(row):
    if row is None:
        return "-"
    if row["status"] in ("ok", "wrong"):
        return row["message"] or "not judged"
    return row["status"] + (f": {row['message']}" if row["message"] else "")


def verdict_table(results):
    columns = contenders(results)
    columns = columns[:1] + columns[len(results.threads) :]
    rows = [
        [name, nice_size(n)] + [verdict(found[name, n]) for _, found in columns]
        for name, n in plotting.cases(results)
    ]
    return table(["points", "n", "FlipFlop"] + [name for name, _ in columns[1:]], rows)


HULLS = Subject(
    "hull",
    "hull vertices",
    {
        "vtk-hull": ("vtkConvexHull", "#d1711f"),
        "vtk-delaunay-3d": ("vtkDelaunay3D", "#7a7a7a"),
    },
    ["vtk-hull", "vtk-delaunay-3d"],
    {
        "cube": "Cube",
        "ball": "Ball",
        "shell:0.01": "Sphere, thickness 0.01",
        "shell:0": "Sphere: all extreme",
    },
)
TRIANGULATIONS = Subject(
    "triangulation",
    "points kept",
    {
        "vtk-flower": ("vtkVoronoiFlower2D", "#d1711f"),
        "vtk-flower-2": ("vtkVoronoiFlower2D, 2 thr.", "#8f4a10"),
        "vtk-delaunay-2d-sorted": ("vtkDelaunay2D, sorted", "#7a7a7a"),
        "vtk-delaunay-2d": ("vtkDelaunay2D", "#b5b5b5"),
    },
    ["vtk-flower", "vtk-flower-2", "vtk-delaunay-2d-sorted"],
    {
        "uniform:0": "Uniform",
        "square-grid": "Grid",
        "clusters": "Clusters",
        "circle": "Circle",
    },
)
