#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draw the shares of a distributed triangulation: the picture of Documentation/Distributed.md.

    mpiexec -n 6 DistributedTriangulation share-      # of Examples/Cxx
    plot-shares.py share-?.vtp --output Documentation/Figures/distributed.png

Each process's triangles have a colour. The rings are the points of the first file's triangles that other processes
have, too: they sent them, or have triangles there.
"""
import argparse

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

COLOURS = ["#8ecae6", "#ffb703", "#95d5b2", "#f4978e", "#cdb4db", "#d4d4aa", "#a9def9", "#e0aaff"]


def read(path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    share = reader.GetOutput()
    positions = vtk_to_numpy(share.GetPoints().GetData())[:, :2]
    triangles = vtk_to_numpy(share.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    ids = vtk_to_numpy(share.GetPointData().GetArray("vtkOriginalPointIds"))
    return positions, triangles, ids


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("shares", nargs="+", help="the files, one a process")
    parser.add_argument("--output", required=True, help="the picture")
    parser.add_argument("--ringed", type=int, default=0, help="of which file the shared points are ringed")
    arguments = parser.parse_args()

    shares = [read(path) for path in arguments.shares]
    figure, axes = plt.subplots(figsize=(9, 6), dpi=80)
    for number, (positions, triangles, _) in enumerate(shares):
        axes.tripcolor(*positions.T, triangles, facecolors=np.full(len(triangles), number), cmap=matplotlib.colors.
                       ListedColormap(COLOURS), vmin=0, vmax=len(COLOURS), edgecolors="#333333", linewidth=0.4)
    others = set()
    for number, (_, _, ids) in enumerate(shares):
        if number != arguments.ringed:
            others.update(ids.tolist())
    positions, _, ids = shares[arguments.ringed]
    shared = np.array([i in others for i in ids.tolist()])
    axes.plot(*positions[shared].T, "o", fillstyle="none", markersize=6, color="#b00020", markeredgewidth=1.2)
    axes.set_aspect("equal")
    axes.axis("off")
    figure.tight_layout(pad=0.2)
    figure.savefig(arguments.output)


if __name__ == "__main__":
    main()
