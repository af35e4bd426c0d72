#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Convex hulls and triangulations of .vtp files: take, write and picture them, print tables.

    demo.py --output demo-output Data/*.vtp

Every file gets a hull. Points that are wider than high, such as terrain, are also triangulated in
the plane, without weights and with. A power diagram of a few disks is there with any files.

A few files are also pictured side by side, in the order given: hulls.png and triangulations.png.
Those in Documentation/Figures are the ones that this writes to demo-output:

    ./demo.sh Data/spot.vtp Data/sainthelens.vtp Data/autzen.vtp
"""
import argparse
import os

import demo_hulls
import demo_triangulations
from demo_files import read


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("files", nargs="+", help=".vtp files")
    parser.add_argument("--output", default="demo-output", help="folder for what is written")
    arguments = parser.parse_args()

    os.makedirs(arguments.output, exist_ok=True)
    sets = [(os.path.splitext(os.path.basename(path))[0], read(path)) for path in arguments.files]
    demo_hulls.run(sets, arguments.output)
    print()
    demo_triangulations.run(sets, arguments.output)
    print(f"\nWhat was computed (.vtp) and pictures of it (.png) are in {arguments.output}")


if __name__ == "__main__":
    main()
