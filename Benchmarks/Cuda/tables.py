#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""tables.py FOLDER: what cuda-benchmark wrote there, as Markdown. A file that is not there has no table."""
import csv
import os
import sys


def read(folder, name):
    """The facts at the top of a file, and its rows."""
    path = os.path.join(folder, name + ".csv")
    if not os.path.exists(path):
        return {}, []
    with open(path, newline="", encoding="utf-8") as file:
        lines = file.readlines()
    facts = [line[2:].rstrip("\n").split(": ", 1) for line in lines if line.startswith("# ")]
    return dict(facts), list(csv.DictReader(line for line in lines if not line.startswith("#")))


def number(text, scale=1.0):
    """Three digits, or a dash where nothing was measured."""
    if text in ("", None):
        return "-"
    value = scale * float(text)
    return f"{value:,.0f}" if abs(value) >= 100 else f"{value:.3g}"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "|".join(["---"] + ["--:"] * (len(head) - 1)) + "|"]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def label(row):
    return row["distribution"] + (":" + row["parameter"] if row["parameter"] else "")


def case(row):
    return [label(row), f"{int(row['n']):,}"]


def by_case(rows):
    cases = {}
    for row in rows:
        cases.setdefault((label(row), int(row["n"])), []).append(row)
    return cases.values()


def engines(rows):
    """Milliseconds of each contender, and how many times as fast the device is."""
    contenders = [("cpu", False), ("cpu", True), ("qhull", True), ("cuda", False), ("cuda-in-place", False)]
    head = ["points", "n", "CPU ms", "CPU ms, 1 thread", "Qhull ms", "CUDA ms", "CUDA ms, in place"]
    head += ["times CPU", "times CPU, in place", "times Qhull"]
    lines = []
    for group in by_case(rows):
        # The row of all threads comes first; on one core both are the same.
        found = {}
        for row in group:
            one = row["contender"] == "qhull" or (row["contender"] == "cpu" and ("cpu", False) in found)
            found[row["contender"], one] = row
        times = {key: float(row["seconds_median"]) for key, row in found.items()}

        def ratio(peer, ours):
            return number(times[peer] / times[ours]) if peer in times and ours in times else "-"

        line = case(group[0])
        line += [number(times.get(key, ""), 1000) for key in contenders]
        line += [ratio(("cpu", False), ("cuda", False)), ratio(("cpu", False), ("cuda-in-place", False))]
        lines.append(line + [ratio(("qhull", True), ("cuda", False))])
    return table(head, lines)


def stages(rows):
    names = ["scan", "grow", "flip", "compact", "finish"]
    head = ["points", "n"] + [f"{name} ms" for name in names]
    head += ["growth rounds", "flip rounds", "device bytes a point"]
    lines = []
    for row in rows:
        if row["contender"] == "cuda":
            line = case(row) + [number(row[f"seconds_{name}"], 1000) for name in names]
            line += [row["growth_rounds"], row["flip_rounds"], number(row["device_bytes_per_point"])]
            lines.append(line)
    return table(head, lines)


DEVICE_STAGES = ["copy_in", "grow", "flip", "finish", "copy_out"]


def device_stages(rows):
    """By the device's own clock."""
    head = ["points", "n"] + [f"{name.replace('_', ' ')} ms" for name in DEVICE_STAGES]
    lines = []
    for row in rows:
        if row["contender"] == "cuda":
            lines.append(case(row) + [number(row[f"device_{name}"], 1000) for name in DEVICE_STAGES])
    return table(head, lines)


# For ten million points: milliseconds on the device from points there to the result there, and how many times as
# fast as Qhull a whole run is.
GOAL_POINTS = 10000000
DEVICE_GOALS = {"cube": 2, "shell:0.0001": 15, "shell:0": 20, "uniform:0": 30}
QHULL_GOAL = 100


def goals(rows):
    """Which of the goals were met; of what was not measured, neither is said."""
    head = ["goal", "points", "wanted", "measured", "met"]
    lines = []
    times = {}
    for row in rows:
        if int(row["n"]) == GOAL_POINTS:
            times.setdefault((label(row), row["contender"]), row)

    def line(what, points, wanted, measured, good):
        met = "-" if measured is None else "yes" if good else "no"
        lines.append([what, points, wanted, "-" if measured is None else number(measured), met])

    for points, goal in DEVICE_GOALS.items():
        row = times.get((points, "cuda-in-place"))
        parts = [row[f"device_{name}"] for name in ("grow", "flip", "finish")] if row else [""]
        measured = None if "" in parts else 1000 * sum(map(float, parts))
        line("on the device, ms", points, f"at most {goal}", measured, measured is not None and measured <= goal)
    for points in [name for name in DEVICE_GOALS if not name.startswith("uniform")]:
        ours, peer = times.get((points, "cuda")), times.get((points, "qhull"))
        measured = float(peer["seconds_median"]) / float(ours["seconds_median"]) if ours and peer else None
        line("whole run, times Qhull", points, f"at least {QHULL_GOAL}", measured,
             measured is not None and measured >= QHULL_GOAL)
    return table(head, lines)


def crossover(rows):
    head = ["points", "the CUDA engine is faster from"]
    return table(head, [[label(group[0]), group[0]["cuda_pays_from"]] for group in by_label(rows)])


def by_label(rows):
    groups = {}
    for row in rows:
        groups.setdefault(label(row), []).append(row)
    return groups.values()


def kernels(rows):
    """Those of the largest size."""
    most = max(int(row["n"]) for row in rows)
    head = ["points", "n", "kernel", "launches", "items a point", "bytes an item", "bytes a point"]
    head += ["ms", "GB/s", "us a launch"]
    lines = []
    for row in rows:
        if int(row["n"]) == most:
            line = case(row) + [row["kernel"], row["launches"], number(row["items"], 1 / most)]
            line += [number(row["bytes_per_item"]), number(row["bytes"], 1 / most)]
            line += [number(row["seconds"], 1000), number(row["gb_per_second"])]
            lines.append(line + [number(row["microseconds_per_launch"])])
    return table(head, lines)


def rounds(rows):
    head = ["points", "n", "growth rounds", "flip rounds", "launches", "bytes a point, held"]
    head += ["bytes a point, read and written"]
    lines = []
    for group in by_case(rows):
        first = group[0]
        line = case(first) + [first["growth_rounds"], first["flip_rounds"]]
        line.append(str(sum(int(row["launches"]) for row in group)))
        line.append(number(first["peak_bytes_per_point"]))
        line.append(number(sum(int(row["bytes"]) for row in group), 1 / int(first["n"])))
        lines.append(line)
    return table(head, lines)


def floors(rows):
    return table(["floor", "", ""], [[row["floor"], number(row["value"]), row["unit"]] for row in rows])


PARTS = [
    ("floors", [("Floors", floors)]),
    ("crossover", [("From how many points on it pays", crossover)]),
    ("engines", [("Whole runs", engines), ("Stages of the CUDA engine", stages),
                 ("Stages on the device", device_stages), ("Goals", goals)]),
    ("kernels", [("Rounds", rounds), ("Kernels", kernels)]),
    ("rounds", [("Rounds, counted on the host", rounds), ("Kernels, counted on the host", kernels)]),
]


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: tables.py FOLDER")
    told = None
    for name, sections in PARTS:
        facts, rows = read(sys.argv[1], name)
        if rows and facts != told:
            print("\n".join(f"- {key}: {value}" for key, value in facts.items()) + "\n")
            told = facts
        for title, write in sections if rows else []:
            print(f"### {title}\n\n{write(rows)}\n")


if __name__ == "__main__":
    main()
