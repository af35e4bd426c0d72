#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draw the paper's Figures 5 and 6 (hull part) from hull-benchmark's CSV, and write the tables.

    plot-figures.py results.csv --figures Documentation/Figures --markdown Documentation/Benchmarks.md

The tables go into the Markdown file between its lines `<!-- tables: begin -->` and
`<!-- tables: end -->`; without --markdown they are printed.
"""
import argparse
import csv
import json
import math
import os

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

BEGIN = "<!-- tables: begin -->"
END = "<!-- tables: end -->"

COLOURS = {"qhull": "#d1711f", "cgal": "#7a7a7a", 1: "#4f9bd9", 2: "#14508c"}
OTHER_COLOURS = ["#0b2f52", "#2a9d8f", "#8e5ea2", "#c44e52"]
NAMES = {"qhull": "Qhull", "cgal": "CGAL"}

# Ratios to a peer that a release should reach (1 and 2 threads), at 1e6 points and at 1e7.
TARGETS = {
    "cube": ("qhull", {10**6: (6, 10), 10**7: (12, 20)}),
    "ball": ("qhull", {10**6: (6, 10), 10**7: (12, 20)}),
    "box:0.01": ("qhull", {10**6: (6, 10), 10**7: (12, 20)}),
    "shell:0.01": ("qhull", {10**6: (5, 9), 10**7: (5, 9)}),
    "shell:0.0001": ("qhull", {10**6: (6, 10), 10**7: (6, 10)}),
    "shell:0": ("qhull", {10**6: (8, 14), 10**7: (8, 14)}),
    "grid": ("cgal", {10**6: (5, 8), 10**7: (5, 8)}),
    "surface-grid": ("cgal", {10**6: (5, 8), 10**7: (5, 8)}),
    "rotated-grid": ("cgal", {10**6: (5, 8), 10**7: (5, 8)}),
    "duplicates": ("cgal", {10**6: (5, 8), 10**7: (5, 8)}),
}
# Bytes a point beyond the input, at the peak: all points extreme, few of them extreme.
MEMORY_TARGETS = {"shell:0": 200}
FEW_EXTREME = 60


def label(row):
    """The points' name as the command line gives it."""
    parameter = row["parameter"]
    if parameter == "":
        return row["distribution"]
    number = float(parameter)
    text = f"{number:.6f}".rstrip("0").rstrip(".") if number else "0"
    return f"{row['distribution']}:{text}"


def nice_size(n):
    """100000 -> 10^5 where n is close to a power of ten."""
    power = round(math.log10(n))
    return f"1e{power}" if abs(n / 10**power - 1) < 0.05 else f"{n:,}"


class Results:
    """The CSV's rows, found by points, contender, threads and size."""

    def __init__(self, path):
        with open(path, newline="", encoding="utf-8") as file:
            self.rows = list(csv.DictReader(file))
        self.labels = list(dict.fromkeys(label(row) for row in self.rows))
        ours = (int(r["threads"]) for r in self.rows if r["contender"] == "flipflop")
        self.threads = sorted(set(ours))
        present = {r["contender"] for r in self.rows}
        self.peers = [peer for peer in ("qhull", "cgal") if peer in present]

    def sizes(self, name):
        return sorted({int(row["n"]) for row in self.rows if label(row) == name})

    def row(self, name, n, contender, threads=1):
        for row in self.rows:
            if (label(row), int(row["n"]), row["contender"], int(row["threads"])) == (
                name,
                n,
                contender,
                threads,
            ):
                return row
        return None

    def value(self, name, n, contender, field, threads=1):
        """A number, or None where nothing was measured."""
        row = self.row(name, n, contender, threads)
        return float(row[field]) if row and row[field] != "" else None

    def series(self, name, contender, field, threads=1):
        """n and value, where there is one."""
        pairs = [(n, self.value(name, n, contender, field, threads)) for n in self.sizes(name)]
        return [p[0] for p in pairs if p[1] is not None], [p[1] for p in pairs if p[1] is not None]

    def lines(self):
        """Everything that is drawn: contender, threads, name, colour."""
        result = [(peer, 1, NAMES[peer], COLOURS[peer]) for peer in self.peers]
        for i, count in enumerate(self.threads):
            text = f"FlipFlop, {count} thread{'s' if count > 1 else ''}"
            colour = COLOURS.get(count, OTHER_COLOURS[i % len(OTHER_COLOURS)])
            result.append(("flipflop", count, text, colour))
        return result


def style():
    plt.rcParams.update(
        {
            "font.size": 11,
            "axes.titlesize": 12,
            "axes.spines.top": False,
            "axes.spines.right": False,
            "axes.grid": True,
            "grid.alpha": 0.3,
            "lines.linewidth": 2,
            "lines.markersize": 6,
            "savefig.dpi": 110,
            "savefig.pad_inches": 0.15,
        }
    )


def save(figure, folder, name):
    path = os.path.join(folder, name)
    figure.savefig(path, bbox_inches="tight")
    plt.close(figure)
    print("wrote", path)


def legend_above(figure, handles, texts, title=None):
    figure.legend(handles, texts, loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=len(texts),
                  frameon=False, title=title)  # fmt: skip


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
        bottom.axhline(1, color=COLOURS["qhull"], linestyle="--", linewidth=1.5)
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
    right.axhline(1, color=COLOURS["qhull"], linestyle="--", linewidth=1.5)
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


def number(value, digits=2):
    if value is None:
        return "-"
    if value >= 1000:
        return f"{value:,.0f}"
    return f"{value:.{digits}f}" if value >= 1 else f"{value:.{max(digits, 3)}f}"


def seconds(results, name, n, contender, threads=1):
    value = results.value(name, n, contender, "seconds_median", threads)
    if value is None:
        row = results.row(name, n, contender, threads)
        return row["status"] if row else "-"
    return f"{value:.4f}" if value < 0.1 else f"{value:.3f}" if value < 10 else f"{value:.1f}"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "|".join(["---"] + ["--:"] * (len(head) - 1)) + "|"]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(lines)


def cases(results):
    return [(name, n) for name in results.labels for n in results.sizes(name)]


def time_table(results):
    head = ["points", "n", "hull vertices"]
    head += [f"{NAMES[peer]} s" for peer in results.peers]
    head += [f"FlipFlop s, {t} thr." for t in results.threads]
    head += [f"times {NAMES[p]}, {t} thr." for p in results.peers for t in results.threads]
    rows = []
    for name, n in cases(results):
        row = [name, nice_size(n)]
        row.append(number(results.value(name, n, "flipflop", "vertices", results.threads[0]), 0))
        row += [seconds(results, name, n, peer) for peer in results.peers]
        row += [seconds(results, name, n, "flipflop", t) for t in results.threads]
        row += [
            number(results.value(name, n, "flipflop", f"ratio_{peer}", t), 1)
            for peer in results.peers
            for t in results.threads
        ]
        rows.append(row)
    return table(head, rows)


def vertices_and_memory_table(results):
    head = ["points", "n"]
    lines = [("flipflop", t, f"FlipFlop, {t} thr.") for t in results.threads]
    lines += [(peer, 1, NAMES[peer]) for peer in results.peers]
    head += ["vertices: FlipFlop"] + [f"vertices: {NAMES[p]}" for p in results.peers]
    head += [f"B/point: {text}" for _, _, text in lines]
    rows = []
    for name, n in cases(results):
        row = [name, nice_size(n)]
        for contender in ["flipflop"] + results.peers:
            count = results.value(
                name, n, contender, "vertices", results.threads[0] if contender == "flipflop" else 1
            )
            row.append("-" if count is None else f"{count:,.0f}")
        for contender, threads, _ in lines:
            value = results.value(name, n, contender, "bytes_per_point", threads)
            row.append("-" if value is None else f"{value:.0f}")
        rows.append(row)
    return table(head, rows)


def against(value, target):
    """A measured ratio beside its target."""
    if value is None:
        return "not measured"
    return f"{value:.1f} of {target}" + ("" if value >= target else " (missed)")


def target_table(results):
    rows = []
    for name, n in cases(results):
        peer, sizes = TARGETS.get(name, (None, {}))
        near = [size for size in sizes if abs(n / size - 1) < 0.05]
        if not near:
            continue
        row = [name, nice_size(n), NAMES[peer]]
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


def stage_table(results):
    if not results.threads:
        return ""
    threads = results.threads[0]
    stages = ["scan", "locate", "grow", "flip", "finish"]
    counts = ["culled", "insertions", "flips22", "flips31", "labelled", "exact_calls"]
    heads = ["culled", "inserted", "2-2 flips", "3-1 flips", "labelled", "exact calls"]
    rows = []
    for name, n in cases(results):
        row = [name, nice_size(n)]
        for stage in stages:
            value = results.value(name, n, "flipflop", f"seconds_{stage}", threads)
            row.append("-" if value is None else f"{1000 * value:,.1f}")
        for count in counts:
            value = results.value(name, n, "flipflop", count, threads)
            row.append("-" if value is None else f"{value:,.0f}")
        rows.append(row)
    return table(["points", "n"] + [f"{stage} ms" for stage in stages] + heads, rows)


def tables(results, machine):
    parts = []
    if machine:
        parts.append(
            f"Measured on {machine['processor']}, {machine['cores']} cores, g++ "
            f"{machine['compiler']}; {machine['qhull']}, CGAL {machine['cgal']}; "
            f"seed {machine['seed']}."
        )
    parts += ["### Targets", target_table(results)]
    parts += ["### Running time", time_table(results)]
    parts += ["### Hull vertices and memory", vertices_and_memory_table(results)]
    if results.threads:
        many = "thread" if results.threads[0] == 1 else "threads"
        parts += [f"### Stages and flips ({results.threads[0]} {many})", stage_table(results)]
    return "\n\n".join(parts) + "\n"


def put_tables(path, text):
    with open(path, encoding="utf-8") as file:
        page = file.read()
    begin, end = page.find(BEGIN), page.find(END)
    if begin < 0 or end < begin:
        raise SystemExit(f"{path}: the lines {BEGIN} and {END} are missing")
    page = page[: begin + len(BEGIN)] + "\n\n" + text + "\n" + page[end:]
    with open(path, "w", encoding="utf-8") as file:
        file.write(page)
    print("wrote", path)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("csv", help="what hull-benchmark --csv wrote")
    parser.add_argument("--json", help="what hull-benchmark --json wrote: names the machine")
    parser.add_argument("--figures", help="folder for the pictures; none without it")
    parser.add_argument("--markdown", help="page whose tables are replaced; printed without it")
    arguments = parser.parse_args()

    results = Results(arguments.csv)
    machine = None
    if arguments.json:
        with open(arguments.json, encoding="utf-8") as file:
            machine = json.load(file)
    if arguments.figures:
        os.makedirs(arguments.figures, exist_ok=True)
        style()
        for figure in (figure5, figure6a, figure6b):
            figure(results, arguments.figures)
    text = tables(results, machine)
    if arguments.markdown:
        put_tables(arguments.markdown, text)
    else:
        print(text)


if __name__ == "__main__":
    main()
