#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""One plot for each table of measurements in this folder: plot.py [FILE.csv]...

By default all, into Documentation/Figures. A file's name ends with its date, which the picture's has not. A plot of
peers shows how many times as long as FlipFlop each of them takes.
"""

import csv
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.ticker import NullLocator

HERE = Path(__file__).resolve().parent
FIGURES = HERE.parent / "Figures"
COLOURS = ["#14508c", "#c44e52", "#2a9d8f", "#8e5ea2", "#e08e2b", "#555555", "#7a5c3e"]
# Ours, and how many threads where the table has no column for that.
OURS = {"flipflop": 1, "vtkflipflop, 1 thread": 1, "vtkflipflop": 2, "vtkflipflop, one call, 1 thread": 1,
        "vtkflipflop, one call": 2}  # fmt: skip
ALSO_OURS = ("vtkflipflop, a loop", "vtkflipflop-loop", "flipflop-loop", "flipflop-filter")


def read(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def name_of(row):
    """The points, with their parameter, and how many there are."""
    name = row.get("distribution") or (f"{row['subject']}, {row['family']}" if "subject" in row else row["family"])
    if row.get("parameter"):
        name += f":{float(row['parameter']):g}"
    return name, int(row.get("n") or row.get("count") or row["points"])


def by_case(rows):
    """For each case, in order: our seconds by threads, and the others' seconds with whether they are right."""
    cases = {}
    for row in rows:
        name, n = name_of(row)
        if name.endswith("-shuffled"):
            continue
        ours, others = cases.setdefault((name, n), ({}, {}))
        contender = row.get("contender") or row["program"]
        seconds = row.get("seconds_median") or row.get("seconds")
        if not seconds or contender in ALSO_OURS:
            continue
        if contender in OURS:
            ours[int(row.get("threads") or OURS[contender])] = float(seconds)
        else:
            others[contender] = float(seconds), row.get("status", "ok") == "ok" and row.get("right", "yes") == "yes"
    return cases


def plain_ticks(axis):
    """1, 2, 5 and so on, as numbers, within what a logarithmic axis shows."""
    low, high = axis.get_view_interval()
    ticks = [step * 10.0**power for power in range(-3, 5) for step in (1, 2, 5)]
    axis.set_ticks([tick for tick in ticks if low <= tick <= high])
    axis.set_major_formatter("{x:g}")
    axis.set_minor_locator(NullLocator())


def plot_peers(rows, axes):
    cases = by_case(rows)
    largest = {}
    for name, n in cases:
        largest[name] = max(n, largest.get(name, 0))
    # In long tables, the largest size of each family alone.
    shown = [case for case in cases if len(cases) <= 32 or case[1] == largest[case[0]]]
    peers = list(dict.fromkeys(peer for case in shown for peer in cases[case][1]))
    for at, case in enumerate(shown):
        ours, others = cases[case]
        for peer, (seconds, right) in others.items():
            colour = COLOURS[peers.index(peer)]
            for threads, marker in ((1, "o"), (2, "D")):
                # Another library on two threads stands beside our two.
                if threads in ours and not (threads == 1 and peer.endswith(("-2", "2 threads"))):
                    axes.plot(seconds / ours[threads], at, marker, color=colour, markersize=6 if threads == 1 else 5,
                              fillstyle="full" if right else "none")  # fmt: skip
    axes.axvline(1, color="black", linewidth=1)
    axes.set_xscale("log")
    axes.set_yticks(range(len(shown)), [f"{name}  {n:.0e}".replace("e+0", "e") for name, n in shown])
    axes.invert_yaxis()
    plain_ticks(axes.xaxis)
    axes.set_xlabel("times FlipFlop's seconds (right of the line: FlipFlop is faster)")
    for peer, colour in zip(peers, COLOURS):
        axes.plot([], [], "o", color=colour, label=peer)
    axes.plot([], [], "ko", label="1 thread")
    axes.plot([], [], "kD", markersize=5, label="2 threads")
    if any(not right for case in shown for _, right in cases[case][1].values()):
        axes.plot([], [], "ko", fillstyle="none", label="wrong result")
    return len(shown)


def plot_small(rows, axes):
    for colour, name in zip(COLOURS, dict.fromkeys(row["distribution"] for row in rows)):
        mine = [row for row in rows if row["distribution"] == name]
        for key, style in (("first", "--"), ("next", "-")):
            axes.plot([int(row["n"]) for row in mine], [float(row[key]) for row in mine], style, color=colour,
                      label=name if key == "next" else None)  # fmt: skip
    axes.plot([], [], "k--", label="first of a process")
    axes.axhline(1, color="black", linewidth=1)
    axes.set_xscale("log")
    axes.set_xlabel("points")
    axes.set_ylabel("CGAL's seconds over FlipFlop's")
    return 12


def blocks_of_driver(rows):
    """The driver's rows of blocks, in the columns that plot_blocks() knows."""
    serial = {name_of(row): row["seconds_median"] for row in rows if row["program"] == "one-run"}
    for row in rows:
        if row["program"] != "one-run":
            name, n = name_of(row)
            yield {"distribution": name, "points": n, "blocks": row["parts"], "path_seconds": row["seconds_median"],
                   "one_run_seconds": serial[name, n]}  # fmt: skip


def plot_blocks(rows, axes):
    rows = rows if "blocks" in rows[0] else list(blocks_of_driver(rows))
    most = max(int(row["points"]) for row in rows)
    size = 1_000_000 if most > 1_000_000 else most
    for colour, name in zip(COLOURS, dict.fromkeys(row["distribution"] for row in rows)):
        mine = [row for row in rows if row["distribution"] == name and abs(int(row["points"]) / size - 1) < 0.05]
        axes.plot([int(row["blocks"]) for row in mine],
                  [float(row["path_seconds"]) / float(row["one_run_seconds"]) for row in mine],
                  "o-", color=colour, label=name)  # fmt: skip
    axes.axhline(1, color="black", linewidth=1)
    axes.set_xscale("log", base=2)
    axes.set_yscale("log", base=2)
    axes.xaxis.set_major_formatter("{x:g}")
    axes.yaxis.set_major_formatter("{x:g}")
    axes.set_xlabel(f"ranks ({size:.0e} points)".replace("e+0", "e"))
    axes.set_ylabel("critical path over one serial run")
    return 12


def plot_shares(rows, axes):
    """Stacked shares of the time of a transport's steps."""
    rows = [row for row in rows if row["share_solving"]]
    left = [0.0] * len(rows)
    for colour, part in zip(COLOURS, ("triangulating", "measuring", "solving")):
        widths = [float(row[f"share_{part}"]) * float(row["seconds_1_thread"]) for row in rows]
        axes.barh(range(len(rows)), widths, left=left, color=colour, label=part)
        left = [a + b for a, b in zip(left, widths)]
    axes.set_yticks(range(len(rows)), [row["sites"] for row in rows])
    axes.invert_yaxis()
    axes.set_xlabel("seconds, 1 thread")
    return len(rows)


def plot_counts(rows, axes):
    cases = [(row["points"], row["n"]) for row in rows if row["state"] == "after"]
    for colour, state in zip(COLOURS, ("before", "after")):
        mine = {(row["points"], row["n"]): int(row["launches"]) for row in rows if row["state"] == state}
        axes.plot([mine[case] for case in cases], range(len(cases)), "o", color=colour, label=state)
    axes.set_yticks(range(len(cases)), [f"{name}  {float(n):.0e}".replace("e+0", "e") for name, n in cases])
    axes.invert_yaxis()
    axes.set_xlabel("launches of kernels")
    return len(cases)


def plot(path):
    rows = read(path)
    kinds = {"first": plot_small, "blocks": plot_blocks, "share_solving": plot_shares, "state": plot_counts}
    draw = next((draw for key, draw in kinds.items() if key in rows[0]), plot_peers)
    if any(row.get("program") == "one-run" for row in rows):
        draw = plot_blocks
    figure, axes = plt.subplots(dpi=80)
    height = draw(rows, axes)
    figure.set_size_inches(9, 1.6 + 0.26 * height)
    axes.grid(alpha=0.3)
    axes.set_title(path.stem, loc="left", fontsize=11)
    axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1), frameon=False)
    figure.savefig(FIGURES / f"measured-{path.stem[:-11]}.png", bbox_inches="tight")
    plt.close(figure)


if __name__ == "__main__":
    for name in sys.argv[1:] or sorted(HERE.glob("*.csv")):
        plot(Path(name))
