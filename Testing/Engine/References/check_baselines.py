# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks each baseline by Checker/check_result.py: check_baselines.py <MakeBaselines> <folder of baselines>.

So neither the engine nor CGAL is believed.
"""

import array
import os
import subprocess
import sys
import tempfile

TOP = os.path.dirname(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))))
sys.path.insert(0, os.path.join(TOP, "Checker"))

import check_result  # noqa: E402
from result_files import rows_of  # noqa: E402


def main(program, folder):
    names = sorted(name[:-4] for name in os.listdir(folder) if name.endswith(".txt"))
    with tempfile.TemporaryDirectory() as made:
        subprocess.run([program, "--points", made], check=True)
        for name in names:
            flat = array.array("d")
            with open(os.path.join(made, name + ".f64"), "rb") as file:
                flat.frombytes(file.read())
            rows = rows_of(flat.tolist(), 3)
            with open(os.path.join(folder, name + ".txt"), encoding="utf-8") as file:
                kind = file.readline().split()[0]
                cells = [tuple(map(int, line.split())) for line in list(file)[4:]]
            case = {"points": rows, "cells": cells}
            if kind == "triangulation":
                case = {"points": [row[:2] for row in rows], "weights": [row[2] for row in rows], "cells": cells}
            check_result.KINDS[kind](case)
            print(f"{kind} {name}: right, {len(rows)} points, {len(cells)} cells", flush=True)
    if len(names) < 37:
        raise SystemExit(f"{len(names)} baselines alone")


if __name__ == "__main__":
    main(*sys.argv[1:])
