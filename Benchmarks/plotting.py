# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the benchmarks' pictures and tables share: the CSV's rows, colours, tables."""
import csv
import math
import os

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

COLOURS = {1: "#4f9bd9", 2: "#14508c"}
OTHER_COLOURS = ["#0b2f52", "#2a9d8f", "#8e5ea2", "#c44e52"]


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
    """The CSV's rows, found by points, contender, threads and size.

    peers: a name and a colour for each contender of another library.
    """

    def __init__(self, path, peers):
        with open(path, newline="", encoding="utf-8") as file:
            self.rows = list(csv.DictReader(file))
        self.labels = list(dict.fromkeys(label(row) for row in self.rows))
        ours = (int(r["threads"]) for r in self.rows if r["contender"] == "flipflop")
        self.threads = sorted(set(ours))
        present = {r["contender"] for r in self.rows}
        self.names = {peer: name for peer, (name, _) in peers.items()}
        self.colours = {peer: colour for peer, (_, colour) in peers.items()}
        self.peers = [peer for peer in peers if peer in present]

    def sizes(self, name):
        return sorted({int(row["n"]) for row in self.rows if label(row) == name})

    def row(self, name, n, contender, threads=1):
        """threads: ours; of another library, a number of threads is a contender by itself."""
        for row in self.rows:
            mine = contender != "flipflop" or int(row["threads"]) == threads
            if (label(row), int(row["n"]), row["contender"]) == (name, n, contender) and mine:
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
        result = [(peer, 1, self.names[peer], self.colours[peer]) for peer in self.peers]
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


def number(value, digits=2):
    if value is None:
        return "-"
    if value >= 1000:
        return f"{value:,.0f}"
    return f"{value:.{digits}f}" if value >= 1 else f"{value:.{max(digits, 3)}f}"


def seconds(results, name, n, contender, threads=1):
    """With a star where the result was judged wrong; where there is none, why."""
    row = results.row(name, n, contender, threads)
    value = results.value(name, n, contender, "seconds_median", threads)
    if value is None:
        return row["status"] if row else "-"
    star = "*" if row["status"] == "wrong" else ""
    text = f"{value:.4f}" if value < 0.1 else f"{value:.3f}" if value < 10 else f"{value:.1f}"
    return text + star


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "|".join(["---"] + ["--:"] * (len(head) - 1)) + "|"]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(lines)


def cases(results):
    return [(name, n) for name in results.labels for n in results.sizes(name)]


def time_table(results, counted, against=None):
    """counted: what the number of vertices is of; against: the peers to give ratios to; else all."""
    against = [p for p in results.peers if against is None or p in against]
    head = ["points", "n", counted]
    head += [f"{results.names[peer]} s" for peer in results.peers]
    head += [f"FlipFlop s, {t} thr." for t in results.threads]
    head += [f"times {results.names[p]}, {t} thr." for p in against for t in results.threads]
    rows = []
    for name, n in cases(results):
        row = [name, nice_size(n)]
        row.append(number(results.value(name, n, "flipflop", "vertices", results.threads[0]), 0))
        row += [seconds(results, name, n, peer) for peer in results.peers]
        row += [seconds(results, name, n, "flipflop", t) for t in results.threads]
        row += [
            number(results.value(name, n, "flipflop", f"ratio_{peer}", t), 1)
            for peer in against
            for t in results.threads
        ]
        rows.append(row)
    return table(head, rows)


def vertices_and_memory_table(results):
    head = ["points", "n"]
    lines = [("flipflop", t, f"FlipFlop, {t} thr.") for t in results.threads]
    lines += [(peer, 1, results.names[peer]) for peer in results.peers]
    head += ["vertices: FlipFlop"] + [f"vertices: {results.names[p]}" for p in results.peers]
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
