# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""More points than memory: a made LiDAR survey in tiles, streamed to files, and the same triangulation in memory.

    python3 Benchmarks/stream.py 1e7 --memory 256
    python3 Benchmarks/stream.py 1e8 --memory 2048 --alone

Each run is a process of its own. It prints its seconds, its peak of memory, and a sum over all triangles by points'
ids, which two runs share only if they have the same triangles. The folder is emptied in the end.
"""

import argparse
import resource
import shutil
import subprocess
import sys
import tempfile
import time

import numpy as np

from vtkflipflop.arrays import regular_triangulation, stream


class Tiles:
    """Strips of a survey, one after another: lines of a scanner, four points a square metre, in whole centimetres."""

    def __init__(self, points, tiles):
        self.points, self.tiles = points, tiles

    def __len__(self):
        return self.tiles

    def __getitem__(self, tile):
        first, end = (self.points * k // self.tiles for k in (tile, tile + 1))
        random = np.random.default_rng(tile)
        side = self.points**0.5 / 2
        along = (np.arange(first, end) + random.random(end - first)) * (side / self.points)
        across = side * random.random(end - first)
        return np.round(np.stack([along, across], axis=1), 2)


def sum_of(triangles):
    """The same in any order of the triangles."""
    a, b, c = triangles.T.astype(np.uint64)
    mixed = (a * np.uint64(0x9E3779B97F4A7C15) + b) * np.uint64(0xBF58476D1CE4E5B9) + c
    return int(np.sum((mixed ^ (mixed >> np.uint64(29))) * np.uint64(0x94D049BB133111EB)))


def in_files(tiles, folder, options):
    found = stream(tiles, folder, memory=options.memory << 20, block_points=options.block_points,
                   threads=options.threads)
    seconds = time.monotonic()
    total = 0
    for file in found.files:
        with np.load(file) as block:
            total += sum_of(block["ids"][block["simplices"]])
    counts = {name: round(found.statistics[name] / 1e6) for name in ("bytes_written", "bytes_read")}
    print(f"  {len(found.files)} blocks; work: {counts['bytes_written']} MB written, {counts['bytes_read']} read")
    return seconds, found.cells, found.hidden, total


def in_memory(tiles, options):
    points = np.concatenate([tiles[i] for i in range(len(tiles))])
    found = regular_triangulation(points, threads=options.threads)
    return time.monotonic(), len(found.simplices), len(found.hidden), sum_of(found.simplices)


def run(options):
    tiles = Tiles(int(options.points), options.tiles)
    began = time.monotonic()
    if options.run == "memory":
        ended, cells, hidden, total = in_memory(tiles, options)
    else:
        folder = tempfile.mkdtemp(dir=options.folder)
        try:
            ended, cells, hidden, total = in_files(tiles, folder, options)
        finally:
            shutil.rmtree(folder)
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024
    sum_text = f"{total % 2**64:016x}"
    print(f"  {ended - began:.1f} s, at most {peak} MiB; {cells} triangles, {hidden} hidden, sum {sum_text}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("points", type=float)
    parser.add_argument("--tiles", type=int, default=100)
    parser.add_argument("--memory", type=int, default=1024, help="mebibytes")
    parser.add_argument("--block-points", type=int)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--folder", help="for files; by default the system's")
    parser.add_argument("--alone", action="store_true", help="not in memory, too")
    parser.add_argument("--run", choices=["files", "memory"], help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.run:
        run(options)
        return
    for kind in ["files"] if options.alone else ["files", "memory"]:
        print(f"in {kind}", flush=True)
        subprocess.run([sys.executable, *sys.argv, "--run", kind], check=True)


if __name__ == "__main__":
    main()
