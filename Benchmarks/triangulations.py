# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The triangulations' picture (the paper's Figure 7) and tables."""
import plotting
from plotting import legend_above, nice_size, number, plt, save, table

PEERS = {"cgal-regular": ("CGAL RT", "#7a7a7a"), "cgal-delaunay": ("CGAL DT", "#d1711f")}
BEGIN = "<!-- triangulation tables: begin -->"
END = "<!-- triangulation tables: end -->"

FIGURE7 = {"uniform:27": "(a) Weights in [0, 27/n]", "uniform:0.19": "(b) Weights in [0, 0.19/n]"}
FIGURE7_FILE = "figure7-triangulation.png"


def figure7(results, folder):
    names = [name for name in FIGURE7 if name in results.labels]
    if not names:
        return
    figure, grid = plt.subplots(
        1, len(names), figsize=(5.5 * len(names), 4.6), squeeze=False, layout="constrained"
    )
    lines = [line for line in results.lines() if line[0] != "cgal-delaunay"]
    for axes, name in zip(grid[0], names):
        for contender, threads, text, colour in lines:
            n, seconds = results.series(name, contender, "seconds_median", threads)
            # The paper begins at a million.
            pairs = [p for p in zip(n, seconds) if p[0] >= 10**6] or list(zip(n, seconds))
            axes.plot([p[0] / 1e6 for p in pairs], [p[1] for p in pairs], "o-", color=colour,
                      label=text)  # fmt: skip
        axes.set_title(FIGURE7[name])
        axes.set_xlabel("number of points (millions)")
        axes.set_xlim(left=0)
        axes.set_ylim(bottom=0)
    grid[0][0].set_ylabel("running time (s)")
    handles, texts = grid[0][0].get_legend_handles_labels()
    legend_above(figure, handles, texts)
    save(figure, folder, FIGURE7_FILE)


def kept_table(results):
    """What stays visible, and that all agree on it."""
    rows = []
    for name, n in plotting.cases(results):
        mine = results.value(name, n, "flipflop", "vertices", results.threads[0])
        others = [results.value(name, n, peer, "vertices") for peer in results.peers]
        known = [count for count in others if count is not None]
        agree = "-" if not known else "yes" if all(count == mine for count in known) else "no"
        share = None if mine is None else 100 * mine / n
        kept = "-" if mine is None else f"{mine:,.0f}"
        rows.append([name, nice_size(n), kept, "-" if share is None else number(share, 1), agree])
    return table(["points", "n", "kept", "kept %", "CGAL keeps as many"], rows)


def figures(results, folder):
    figure7(results, folder)


def tables(results, machine):
    parts = []
    if machine:
        parts.append(
            f"Measured on {machine['processor']}, {machine['cores']} cores, g++ "
            f"{machine['compiler']}; CGAL {machine['cgal']}; seed {machine['seed']}."
        )
    if any(name in results.labels for name in FIGURE7):
        parts.append(f"![Running time over the number of points](Figures/{FIGURE7_FILE})")
    parts += ["### Triangulations: running time", plotting.time_table(results, "vertices")]
    if results.threads:
        parts += ["### Triangulations: points kept", kept_table(results)]
    parts += ["### Triangulations: vertices and memory"]
    parts += [plotting.vertices_and_memory_table(results)]
    if results.threads:
        many = "thread" if results.threads[0] == 1 else "threads"
        parts += [f"### Triangulations: stages and flips ({results.threads[0]} {many})"]
        parts += [plotting.stage_table(results)]
    return "\n\n".join(parts) + "\n"
