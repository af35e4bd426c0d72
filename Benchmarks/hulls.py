# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The hulls' pictures (the paper's Figures 5 and 6, hull part) and tables."""
import plotting
from plotting import legend_above, nice_size, plt, save, table

PEERS = {"qhull": ("Qhull", "#d1711f"), "cgal": ("CGAL", "#7a7a7a")}
BEGIN = "<!-- tables: begin -->"
END = "<!-- tables: end -->"

# Ratios to a peer that a release should reach (1 and 2 threads), at 1e6 points and at 1e7.
TARGETS = {
    "cube": ("qhull", {10**6: (6, 10), 10**7: (12, 20)}),
    "ball": ("qhull", {10**6: (6, 10), 10**7: (12, 20)}),
    "box:0.01": ("qhull", {10**6: (6, 10), 10**7: (12, 20)}),
    "shell:0.01": ("qhull", {10**6: (5, 9), 10**7: (5, 9)}),
    "shell:0.0001": ("qhull", {10**6: (9, 17), 10**7: (9, 17)}),
    "shell:0": ("qhull", {10**6: (13, 24), 10**7: (13, 24)}),
    "grid": ("cgal", {10**6: (5, 8), 10**7: (5, 8)}),
    "surface-grid": ("cgal", {10**6: (5, 8), 10**7: (5, 8)}),
    "rotated-grid": ("cgal", {10**6: (5, 8), 10**7: (5, 8)}),
    "duplicates": ("cgal", {10**6: (5, 8), 10**7: (5, 8)}),
}
# Bytes a point beyond the input, at the peak: all points extreme, few of them extreme.
MEMORY_TARGETS = {"shell:0": 160}
FEW_EXTREME = 20


def speedups(results, name, n, contender, threads):
    """Over Qhull: the median of the rounds' ratios for us, the ratio of medians for CGAL."""
    if contender == "flipflop":
        return results.value(name, n, contender, "ratio_qhull", threads)
    mine = results.value(name, n, contender, "seconds_median", threads)
    qhull = results.value(name, n, "qhull", "seconds_median")
    return qhull / mine if mine and qhull else None


def bar_panel(axes, groups, lines, value, width=0.8):
    """Grouped bars: one group a tick, one bar a line."""
    each = width / len(lines)
    for i, (contender, threads, name, colour) in enumerate(lines):
        offset = (i - (len(lines) - 1) / 2) * each
        found = [(g, value(g, contender, threads)) for g in range(len(groups))]
        found = [(g, v) for g, v in found if v is not None]
        axes.bar([g + offset for g, _ in found], [v for _, v in found], each, color=colour,
                 label=name)  # fmt: skip
    axes.set_xticks(range(len(groups)), groups)
    axes.set_xlim(-0.5, len(groups) - 0.5)
    axes.grid(axis="x", visible=False)
    axes.set_axisbelow(True)


def figure5(results, folder):
    titles = {
        "cube": "(a) Cube",
        "ball": "(b) Ball",
        "shell:0.01": "(c) Sphere, thickness 0.01",
        "box:0.01": "(d) Box, thickness 0.01",
    }
    names = [name for name in titles if name in results.labels]
    if not names:
        return
    figure, grid = plt.subplots(
        2, len(names), figsize=(4 * len(names), 7), squeeze=False, layout="constrained"
    )
    for column, name in enumerate(names):
        top, bottom = grid[0][column], grid[1][column]
        for contender, threads, text, colour in results.lines():
            top.loglog(*results.series(name, contender, "seconds_median", threads), "o-",
                       color=colour, label=text)  # fmt: skip
            if contender != "qhull":
                pairs = [
                    (n, speedups(results, name, n, contender, threads))
                    for n in results.sizes(name)
                ]
                pairs = [p for p in pairs if p[1] is not None]
                bottom.semilogx([p[0] for p in pairs], [p[1] for p in pairs], "o-", color=colour)
        bottom.axhline(1, color=results.colours["qhull"], linestyle="--", linewidth=1.5)
        bottom.set_ylim(bottom=0)
        top.set_title(titles[name])
        bottom.set_xlabel("number of points")
    grid[0][0].set_ylabel("running time (s)")
    grid[1][0].set_ylabel("speed-up over Qhull")
    handles, texts = grid[0][0].get_legend_handles_labels()
    legend_above(figure, handles, texts)
    save(figure, folder, "figure5-running-time.png")


def figure6a(results, folder):
    names = [("ball", "0.5")]
    shells = [name for name in results.labels if name.startswith("shell:")]
    shells.sort(key=lambda name: -float(name.split(":")[1]))
    names += [(name, name.split(":")[1]) for name in shells]
    names = [pair for pair in names if pair[0] in results.labels]
    if len(names) < 2:
        return
    n = max(n for name, _ in names for n in results.sizes(name))
    names = [pair for pair in names if n in results.sizes(pair[0])]
    lines = results.lines()
    figure, (left, right) = plt.subplots(1, 2, figsize=(13, 4.8), layout="constrained")
    groups = [text for _, text in names]
    bar_panel(left, groups, lines,
              lambda g, c, t: results.value(names[g][0], n, c, "seconds_median", t))  # fmt: skip
    left.set_yscale("log")
    left.set_ylabel("running time (s)")
    bar_panel(right, groups, [line for line in lines if line[0] != "qhull"],
              lambda g, c, t: speedups(results, names[g][0], n, c, t))  # fmt: skip
    right.axhline(1, color=results.colours["qhull"], linestyle="--", linewidth=1.5)
    right.set_ylabel("speed-up over Qhull")
    for axes in (left, right):
        axes.set_xlabel("thickness of the sphere (0.5: ball; 0: all points extreme)")
    handles, texts = left.get_legend_handles_labels()
    legend_above(figure, handles, texts, f"{nice_size(n)} points")
    save(figure, folder, "figure6a-thickness.png")


def figure6b(results, folder):
    curves = [
        ("cube", "Cube", "#4f9bd9", "o-"),
        ("box:0.01", "Box, thickness 0.01", "#2a9d8f", "s--"),
        ("ball", "Ball", "#8e5ea2", "o-"),
        ("shell:0.01", "Sphere, thickness 0.01", "#d1711f", "o-"),
        ("shell:0.0001", "Sphere, thickness 0.0001", "#c44e52", "s--"),
        ("shell:0", "Sphere, all points extreme", "#14508c", "o-"),
    ]
    curves = [curve for curve in curves if curve[0] in results.labels]
    if not curves or not results.threads:
        return
    figure, axes = plt.subplots(figsize=(7.5, 4.8), layout="constrained")
    for name, text, colour, dots in curves:
        n, twos = results.series(name, "flipflop", "flips22", results.threads[0])
        _, threes = results.series(name, "flipflop", "flips31", results.threads[0])
        axes.loglog(n, [max(a + b, 1) for a, b in zip(twos, threes)], dots, color=colour,
                    label=text)  # fmt: skip
    axes.set_xlabel("number of points")
    axes.set_ylabel("flips (2-2 and 3-1)")
    axes.legend(frameon=False, loc="center left", bbox_to_anchor=(1, 0.5))
    save(figure, folder, "figure6b-flips.png")


def against(value, target):
    """A measured ratio beside its target."""
    if value is None:
        return "not measured"
    return f"{value:.1f} of {target}" + ("" if value >= target else " (missed)")


def target_table(results):
    rows = []
    for name, n in plotting.cases(results):
        peer, sizes = TARGETS.get(name, (None, {}))
        near = [size for size in sizes if abs(n / size - 1) < 0.05]
        if not near:
            continue
        row = [name, nice_size(n), results.names[peer]]
        for threads, target in zip((1, 2), sizes[near[0]]):
            row.append(against(results.value(name, n, "flipflop", f"ratio_{peer}", threads), target))
        for threads in (1, 2):
            bytes_a_point = results.value(name, n, "flipflop", "bytes_per_point", threads)
            vertices = results.value(name, n, "flipflop", "vertices", threads)
            few = FEW_EXTREME if vertices is not None and vertices < 0.05 * n else None
            target = MEMORY_TARGETS.get(name, few)
            if bytes_a_point is None or target is None:
                row.append("-" if bytes_a_point is None else f"{bytes_a_point:.0f}")
            else:
                missed = "" if bytes_a_point <= target else " (missed)"
                row.append(f"{bytes_a_point:.0f} of {target}{missed}")
        rows.append(row)
    head = ["points", "n", "peer", "times as fast, 1 thr.", "times as fast, 2 thr."]
    return table(head + ["B/point, 1 thr.", "B/point, 2 thr."], rows)


def figures(results, folder):
    for figure in (figure5, figure6a, figure6b):
        figure(results, folder)


def tables(results, machine):
    parts = []
    if machine:
        parts.append(
            f"Measured on {machine['processor']}, {machine['cores']} cores, g++ "
            f"{machine['compiler']}; {machine['qhull']}, CGAL {machine['cgal']}; "
            f"seed {machine['seed']}."
        )
    parts += ["### Targets", target_table(results)]
    parts += ["### Running time", plotting.time_table(results, "hull vertices")]
    parts += ["### Hull vertices and memory", plotting.vertices_and_memory_table(results)]
    if results.threads:
        many = "thread" if results.threads[0] == 1 else "threads"
        parts += [f"### Stages and flips ({results.threads[0]} {many})", plotting.stage_table(results)]
    return "\n\n".join(parts) + "\n"
