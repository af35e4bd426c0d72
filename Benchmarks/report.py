#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Summarize the results of flipflop-benchmark.

    report.py SECTION.csv [--csv SUMMARY.csv] [--metrics NAME,...]

Prints a table in Markdown: a line for each case, with median seconds and, for FlipFlop, how many times as long each
other program takes: the median over the rounds of the ratio within a round. A star marks a wrong result. --metrics
adds columns with the first program's metrics. --csv writes everything, a line for each case and program;
Documentation/Measurements has such files, and plot.py there draws them.
"""
import argparse
import csv
import statistics

OURS = ("flipflop", "cuda", "one-run")
KEYS = ["family", "count", "program", "threads", "parts"]


def read(path):
    """The lines that name the machine, and the rows."""
    with open(path, newline="", encoding="utf-8") as file:
        lines = file.readlines()
    facts = [line for line in lines if line.startswith("# ")]
    return facts, list(csv.DictReader(line for line in lines if not line.startswith("# ")))


def median(rows, column):
    values = [float(row[column]) for row in rows if row[column] != ""]
    return statistics.median(values) if values else None


def seconds_by_round(rows):
    return {row["round"]: float(row["seconds"]) for row in rows if row["seconds"] != ""}


def ratio(rows, others):
    """How many times as long the others take, round by round."""
    mine, theirs = seconds_by_round(rows), seconds_by_round(others)
    ratios = [theirs[key] / mine[key] for key in mine if key in theirs]
    return statistics.median(ratios) if ratios else None


def grouped(rows):
    """The rounds of each program, by case."""
    cases = {}
    for row in rows:
        key = row["program"], row["threads"], row["parts"]
        cases.setdefault((row["family"], int(row["count"])), {}).setdefault(key, []).append(row)
    return cases


def is_ours(program):
    return program.startswith(OURS) or program.startswith("vtkflipflop")


def status(rows):
    """Of the first round, which alone is checked, or of the one that failed."""
    bad = [row["status"] for row in rows if row["status"] != "ok"]
    return bad[0] if bad else "ok"


def text(value):
    return "" if value is None else f"{value:.6g}"


def summary(rows):
    """A dictionary for each case and program."""
    columns = list(rows[0])
    metrics = columns[columns.index("peak_bytes") + 1 : -1]
    for (family, count), programs in grouped(rows).items():
        for (program, threads, parts), mine in programs.items():
            line = dict(zip(KEYS, (family, count, program, threads, parts)))
            line.update(status=status(mine), rounds=sum(row["seconds"] != "" for row in mine))
            seconds = list(seconds_by_round(mine).values())
            line["seconds_median"] = text(statistics.median(seconds) if seconds else None)
            line["seconds_min"] = text(min(seconds, default=None))
            line["seconds_max"] = text(max(seconds, default=None))
            for (other, _, other_parts), theirs in programs.items():
                if is_ours(program) and not is_ours(other) and other_parts == parts:
                    line[f"ratio_{other}"] = text(ratio(mine, theirs))
            for metric in ["peak_bytes"] + metrics:
                line[metric] = text(median(mine, metric))
            line["message"] = next((row["message"] for row in mine if row["message"]), "")
            yield line


def write_csv(path, facts, lines):
    columns = list(dict.fromkeys(column for line in lines for column in line if column != "message"))
    with open(path, "w", newline="", encoding="utf-8") as file:
        file.writelines(facts)
        writer = csv.DictWriter(file, columns + ["message"], restval="")
        writer.writeheader()
        writer.writerows(lines)


def label(line):
    name = line["program"]
    name += f", {line['threads']} thr." if is_ours(name) and not name.startswith("cuda") else ""
    return name + (f", {line['parts']} parts" if line["parts"] != "0" else "")


def seconds_text(line):
    if not line or not line["seconds_median"]:
        return line["status"] if line else "-"
    value = float(line["seconds_median"])
    digits = f"{value:.3g}" if value < 100 else f"{value:.0f}"
    return digits + ("*" if line["status"] == "wrong" else "")


def markdown(lines, metrics):
    labels = list(dict.fromkeys(label(line) for line in lines))
    ratios = list(dict.fromkeys(key for line in lines for key in line if key.startswith("ratio_")))
    ours = [name for name in labels if is_ours(name)]
    cases = {}
    for line in lines:
        cases.setdefault((line["family"], line["count"]), {})[label(line)] = line
    has = lambda name, key: any(line.get(key) for line in lines if label(line) == name)
    pairs = [(name, key) for key in ratios for name in ours if has(name, key)]
    head = ["family", "count", *metrics, *(f"{name}, s" for name in labels)]
    head += [f"{key[6:]} / {name}" for name, key in pairs]
    print("| " + " | ".join(head) + " |")
    print("|---" + "|--:" * (len(head) - 1) + "|")
    for (family, count), found in cases.items():
        first = next(iter(found.values()))
        row = [family, f"{count:,}", *(first.get(metric, "") for metric in metrics)]
        row += [seconds_text(found.get(name)) for name in labels]
        values = (found.get(name, {}).get(key, "") for name, key in pairs)
        row += [f"{float(value):.1f}" if value else "-" for value in values]
        print("| " + " | ".join(row) + " |")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("results", help="what flipflop-benchmark wrote")
    parser.add_argument("--csv", help="where to write the summary")
    parser.add_argument("--metrics", default="", help="columns of the table, of the first program")
    arguments = parser.parse_args()
    facts, rows = read(arguments.results)
    lines = list(summary(rows))
    if arguments.csv:
        write_csv(arguments.csv, facts, lines)
    print("".join(facts))
    markdown(lines, [name for name in arguments.metrics.split(",") if name])


if __name__ == "__main__":
    main()
