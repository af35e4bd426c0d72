# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The demo's runs of the ParaView plugin's filters, by their proxies in pvpython."""
import time

from paraview import servermanager, simple

if not hasattr(simple, "ConvexHullFlipFlop"):
    raise SystemExit("the plugin is not loaded: PV_PLUGIN_PATH names no folder that holds it")


def updated(kind, points, **properties):
    """A proxy of the kind after its run on the points, and the seconds that took."""
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(points)
    source.UpdatePipeline()
    proxy = kind(Input=source, ReportAsFieldData=1, **properties)
    start = time.perf_counter()
    proxy.UpdatePipeline()
    seconds = time.perf_counter() - start
    if proxy.GetClientSideObject().GetErrorCode() != 0:
        raise SystemExit(f"{proxy.GetXMLLabel()} failed")
    return proxy, seconds


def reported(output, figure):
    """A figure of the run, which is field data of its output."""
    return output.GetFieldData().GetAbstractArray(f"FlipFlop{figure}").GetValue(0)


def hull(points):
    """The hull, its volume, the engine's name, and the seconds that took."""
    proxy, seconds = updated(simple.ConvexHullFlipFlop, points, FacetMode="Polygons")
    output = servermanager.Fetch(proxy)
    return output, reported(output, "Volume"), reported(output, "Engine"), seconds


def triangulation(points, weights=None, bounds=None):
    """(Triangulation, hidden points, power diagram if there are bounds), the engine's name, seconds."""
    properties = {}
    if weights:
        properties.update(Weights=["POINTS", weights])
    proxy, seconds = updated(simple.Delaunay2DFlipFlop, points, **properties)
    outputs = [servermanager.Fetch(proxy, idx=port) for port in range(2)]
    if bounds:
        low_x, high_x, low_y, high_y = bounds
        properties.update(PowerDiagramBoxMode="Bounds Given", PowerDiagramCorner=[low_x, low_y, 0])
        properties.update(PowerDiagramLengths=[high_x - low_x, high_y - low_y, 0])
        diagram, more = updated(simple.Voronoi2DFlipFlop, points, **properties)
        outputs.append(servermanager.Fetch(diagram))
        seconds += more
    return outputs, reported(outputs[0], "Engine"), seconds
