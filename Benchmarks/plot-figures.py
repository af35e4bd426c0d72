#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draw a benchmark's figures from its CSV, and write its tables.

    plot-figures.py hull results.csv --figures Documentation/Figures --markdown Documentation/Benchmarks.md
    plot-figures.py triangulation|vtk-hull|vtk-triangulation ...

hull: the paper's Figures 5 and 6 (hull part); triangulation: its Figure 7; the others: beside VTK.
The tables go into the Markdown file between its lines `<!-- tables: begin -->` and
`<!-- tables: end -->`, or `<!-- triangulation tables: begin -->` and so on; without --markdown they
are printed.
"""
import argparse
import json
import os

import hulls
import plotting
import triangulations
import vtk_tables

SUBJECTS = {
    "hull": hulls,
    "triangulation": triangulations,
    "vtk-hull": vtk_tables.HULLS,
    "vtk-triangulation": vtk_tables.TRIANGULATIONS,
}


def put_tables(path, text, begin_line, end_line):
    with open(path, encoding="utf-8") as file:
        page = file.read()
    begin, end = page.find(begin_line), page.find(end_line)
    if begin < 0 or end < begin:
        raise SystemExit(f"{path}: the lines {begin_line} and {end_line} are missing")
    page = page[: begin + len(begin_line)] + "\n\n" + text + "\n" + page[end:]
    with open(path, "w", encoding="utf-8") as file:
        file.write(page)
    print("wrote", path)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("subject", choices=SUBJECTS, help="what was measured")
    parser.add_argument("csv", help="what the benchmark's --csv wrote")
    parser.add_argument("--json", help="what the benchmark's --json wrote: names the machine")
    parser.add_argument("--figures", help="folder for the pictures; none without it")
    parser.add_argument("--markdown", help="page whose tables are replaced; printed without it")
    arguments = parser.parse_args()

    subject = SUBJECTS[arguments.subject]
    results = plotting.Results(arguments.csv, subject.PEERS)
    machine = None
    if arguments.json:
        with open(arguments.json, encoding="utf-8") as file:
            machine = json.load(file)
    if arguments.figures:
        os.makedirs(arguments.figures, exist_ok=True)
        plotting.style()
        subject.figures(results, arguments.figures)
    text = subject.tables(results, machine)
    if arguments.markdown:
        put_tables(arguments.markdown, text, subject.BEGIN, subject.END)
    else:
        print(text)


if __name__ == "__main__":
    main()
