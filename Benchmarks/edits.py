#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Edits of a Delaunay triangulation in Python, by each package that is installed: microseconds an edit.

    edits.py [POINTS [EDITS]]

startinpy inserts points one by one, each from the last one; its points here are 2.5D with the height 0. What a package cannot do is empty.
"""

import importlib.metadata
import sys
import time

import numpy as np

KINDS = ("insert near", "insert anywhere", "insert many", "remove anywhere")


def points_of(count, edits):
    random = np.random.default_rng(2015)
    start = random.random((count, 2))
    steps = (random.random((edits, 2)) - 0.5) * 2 / np.sqrt(count)
    return start, (0.5 + np.cumsum(steps, axis=0)) % 1, random.random((edits, 2)), random.random((edits, 2))


def seconds_of(work):
    begin = time.perf_counter()
    work()
    return time.perf_counter() - begin


def flipflop(start, near, anywhere, many):
    from vtkflipflop.arrays import EditableTriangulation

    edited = EditableTriangulation(start, threads=1)
    yield seconds_of(lambda: [edited.insert(p) for p in near])
    yield seconds_of(lambda: [edited.insert(p) for p in anywhere])
    yield seconds_of(lambda: edited.insert(many, threads=1))
    yield seconds_of(lambda: [edited.remove(i) for i in range(len(near))])


def startin(start, near, anywhere, many):
    import startinpy

    def with_heights(points):
        return np.column_stack([points, np.zeros(len(points))])

    edited = startinpy.DT()
    edited.insert(with_heights(start), insertionstrategy="BBox")
    yield seconds_of(lambda: [edited.insert_one_pt([*p, 0.0]) for p in near])
    yield seconds_of(lambda: [edited.insert_one_pt([*p, 0.0]) for p in anywhere])
    yield seconds_of(lambda: edited.insert(with_heights(many), insertionstrategy="BBox"))
    yield seconds_of(lambda: [edited.remove(i + 1) for i in range(len(near))])


def main(count="100000", edits="10000"):
    given = points_of(int(count), int(edits))
    print(f"# edits.py {count} {edits}, numpy seed 2015; one thread")
    print("package,version," + ",".join(KINDS))
    for package, run in (("vtkflipflop", flipflop), ("startinpy", startin)):
        try:
            version = importlib.metadata.version(package)
        except importlib.metadata.PackageNotFoundError:
            version = "" if package == "vtkflipflop" else None
        if version is not None:
            times = ",".join(f"{1e6 * seconds / int(edits):.2f}" for seconds in run(*given))
            print(f"{package},{version},{times}", flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
