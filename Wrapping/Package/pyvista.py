# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""The filters in one line, for PyVista.

    import pyvista as pv
    from vtkflipflop.pyvista import convex_hull

    hull = convex_hull(pv.examples.download_bunny())

Each function accepts a mesh (or anything that pyvista.wrap turns into one), or an array or list of points. It runs
one filter and returns its output as a PyVista mesh, with the point data and "vtkOriginalPointIds". PyVista 0.48 and
later offer the same as methods of a mesh, without an import: mesh.flipflop.convex_hull().

Arrays are read exactly, in any byte order and of any type of real numbers. Masked numbers are an error like NaN, or
ignored like NaN.

A filter's properties are keyword arguments: VTK's names in snake_case, such as number_of_threads=4. Give choices
by name: facet_mode="polygons", engine="cpu", non_finite_points="ignore". If a filter reports an error, or no filter
accepts the data, the functions raise FilterError. An argument of the wrong type is a TypeError; an argument out of
its range is a ValueError.
"""

import pyvista
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDataArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkDataObjectTree, vtkPointSet, vtkPolyData

from . import vtkFFConvexifyFilter, vtkFFHullFilter, vtkFFRegularTriangulationFilter
from ._arrays import FilterError, as_points, as_weights, is_array_like
from ._properties import flag, set_properties

__all__ = [
    "FilterError",
    "convex_hull",
    "convexify",
    "power_diagram",
    "regular_triangulation",
]

if not issubclass(pyvista.PolyData, vtkPolyData):
    _base = next(kind for kind in pyvista.PolyData.__mro__ if kind.__name__ == "vtkPolyData")
    _other = _base.__module__.split(".")[0]
    raise ImportError(
        f"PyVista {pyvista.__version__} runs on {_other}, a VTK of its own, and not on vtk, as vtkflipflop does: the "
        f"one cannot use the other's data. The way out: PYVISTA_VTK_BACKEND=vtk in the environment, or "
        f"pip uninstall {_other}"
    )


def convex_hull(mesh, *, progress_bar=False, **properties):
    """The convex hull of a mesh's points (vtkFFHullFilter).

    Parameters
    ----------
    mesh : any PyVista or VTK data set or composite, or an array or list of n by 3 or n by 2 coordinates
    progress_bar : show progress in the terminal; needs tqdm
    properties : of vtkFFHullFilter; facet_mode="polygons" gives whole facets

    Returns
    -------
    pyvista.PolyData, closed, with facets facing outwards. For a composite, a composite of the same structure with the
    hull of each block, or one hull with composite_mode="all_blocks".
    """
    hull = vtkFFHullFilter()
    set_properties(hull, properties)
    return _outputs(hull, _points_of(mesh, hull), progress_bar)[0]


def convexify(surface, *, progress_bar=False, **properties):
    """The convex hull of a closed star-shaped surface, reached by flips alone (vtkFFConvexifyFilter).

    Parameters
    ----------
    surface : a closed, oriented PolyData of triangles that is star-shaped from some point
    progress_bar : show progress in the terminal; needs tqdm
    properties : of vtkFFConvexifyFilter

    Returns
    -------
    pyvista.PolyData
    """
    convexifier = vtkFFConvexifyFilter()
    set_properties(convexifier, properties)
    points = _points_of(surface, convexifier)
    if is_array_like(surface) or isinstance(points, vtkPointSet) and not points.IsA("vtkPolyData"):
        raise FilterError(f"{type(surface).__name__} is no surface: a PolyData is wanted")
    return _outputs(convexifier, points, progress_bar)[0]


def regular_triangulation(
    mesh, weights=None, *, return_hidden_points=False, progress_bar=False, **properties
):
    """The regular (weighted Delaunay) triangulation of points in the plane (vtkFFRegularTriangulationFilter).

    Parameters
    ----------
    mesh : any PyVista or VTK data set or composite, or an array or list of n by 3 or n by 2 coordinates
    weights : a point array's name, or n numbers if mesh is no composite; squared lengths. By default none: Delaunay
    return_hidden_points : also return the points that do not appear in the triangulation
    progress_bar : show progress in the terminal; needs tqdm
    properties : of vtkFFRegularTriangulationFilter; projection_plane_mode="best_fitting_plane" for tilted points

    Returns
    -------
    pyvista.PolyData, or a pair of them: the triangulation, and the hidden points as vertices
    """
    both = flag("return_hidden_points", return_hidden_points)
    outputs = _triangulated(mesh, weights, properties, progress_bar)
    return (outputs[0], outputs[1]) if both else outputs[0]


def power_diagram(mesh, weights=None, *, progress_bar=False, **properties):
    """The power diagram of points in the plane, a polygon for each cell; without weights, the Voronoi diagram.

    Parameters
    ----------
    mesh, weights, progress_bar, properties : as for regular_triangulation

    Returns
    -------
    pyvista.PolyData, with the points' data as cell data
    """
    if not flag("generate_power_diagram", properties.pop("generate_power_diagram", True)):
        raise ValueError("power_diagram() generates a power diagram: generate_power_diagram cannot be False")
    return _triangulated(mesh, weights, {**properties, "generate_power_diagram": True}, progress_bar)[2]


class _Accessor:
    """The functions of this module as methods: mesh.flipflop.convex_hull()."""

    def __init__(self, mesh):
        self._mesh = mesh

    def convex_hull(self, **settings):
        return convex_hull(self._mesh, **settings)

    def convexify(self, **settings):
        return convexify(self._mesh, **settings)

    def regular_triangulation(self, weights=None, **settings):
        return regular_triangulation(self._mesh, weights, **settings)

    def power_diagram(self, weights=None, **settings):
        return power_diagram(self._mesh, weights, **settings)


for _method, _function in (
    (_Accessor.convex_hull, convex_hull),
    (_Accessor.convexify, convexify),
    (_Accessor.regular_triangulation, regular_triangulation),
    (_Accessor.power_diagram, power_diagram),
):
    _method.__doc__ = _function.__doc__

if hasattr(pyvista, "register_dataset_accessor"):  # distributions have older ones
    pyvista.register_dataset_accessor("flipflop", pyvista.DataObject)(_Accessor)


def _points_of(mesh, algorithm):
    """The algorithm's input: the mesh as a data set that stores its points, or as a composite of such data sets."""
    if isinstance(mesh, vtkDataObjectTree):
        copy = mesh.NewInstance()
        copy.ShallowCopy(mesh)
        places = mesh.NewTreeIterator()
        while not places.IsDoneWithTraversal():
            leaf = places.GetCurrentDataObject()
            if leaf.IsA("vtkImageData") or leaf.IsA("vtkRectilinearGrid"):
                copy.SetDataSetFrom(places, _points_of(leaf, algorithm))
            places.GoToNextItem()
        return copy
    if isinstance(mesh, vtkPoints):
        mesh = mesh.GetData()
    if isinstance(mesh, vtkDataArray):
        mesh = vtk_to_numpy(mesh)
    if not hasattr(mesh, "IsA"):
        if is_array_like(mesh):
            # Integers stay: as floats, they were rounded.
            return pyvista.PolyData(as_points(mesh, _ignores_masked(algorithm)), force_float=False)
        mesh = _wrapped(mesh)
    elif not isinstance(mesh, vtkDataObject) and hasattr(mesh, "GetDataObjectType"):
        raise FilterError(f"{type(mesh).__name__} is of another VTK, the module {type(mesh).__module__}")
    if isinstance(mesh, vtkPointSet):
        return mesh
    if mesh is None or not (mesh.IsA("vtkImageData") or mesh.IsA("vtkRectilinearGrid")):
        raise FilterError(f"{type(mesh).__name__} has no points to take")
    return pyvista.wrap(mesh).cast_to_structured_grid()


def _wrapped(mesh):
    """PyVista's mesh for an object that is not VTK's; None for None."""
    try:
        return pyvista.wrap(mesh)
    except (NotImplementedError, TypeError):
        raise FilterError(f"{type(mesh).__name__} has no points to take") from None


def _ignores_masked(algorithm):
    return algorithm.GetNonFinitePoints() == algorithm.NON_FINITE_IGNORE


def _triangulated(mesh, weights, properties, progress_bar):
    triangulation = vtkFFRegularTriangulationFilter()
    set_properties(triangulation, properties)
    mesh = _points_of(mesh, triangulation)
    own = None
    if isinstance(weights, str):
        triangulation.SetInputArrayToProcess(0, 0, 0, 0, weights)
    elif weights is not None:
        if not isinstance(mesh, vtkPointSet):
            raise TypeError("the weights of a composite are the name of a point array")
        own = "weights"
        while mesh.GetPointData().HasArray(own):
            own += "_"
        array = numpy_to_vtk(as_weights(weights, _ignores_masked(triangulation)), deep=True)
        array.SetName(own)
        weighted = mesh.NewInstance()
        weighted.ShallowCopy(mesh)
        weighted.GetPointData().AddArray(array)
        mesh = weighted
        triangulation.SetInputArrayToProcess(0, 0, 0, 0, own)
    outputs = _outputs(triangulation, mesh, progress_bar)
    for output in outputs if own else ():
        output.GetPointData().RemoveArray(own)
        output.GetCellData().RemoveArray(own)
    return outputs


def _outputs(algorithm, mesh, progress_bar):
    """Runs the algorithm on the mesh; returns its outputs as PyVista meshes, which do not share its pipeline."""
    errors = []

    def keep(caller, event, message):
        errors.append(message)

    keep.CallDataType = "string0"
    algorithm.AddObserver("ErrorEvent", keep)
    # It says no more than that the algorithm failed, and would say it on the terminal.
    algorithm.GetExecutive().AddObserver("ErrorEvent", lambda caller, event: None)
    algorithm.SetInputDataObject(mesh)
    if flag("progress_bar", progress_bar):
        from pyvista.core.utilities.observers import ProgressMonitor

        with ProgressMonitor(algorithm, message=algorithm.GetClassName()):
            algorithm.Update()
    else:
        algorithm.Update()
    if errors:
        # Without VTK's head, which names a source line and an address.
        raise FilterError("\n".join(message.split("): ", 1)[-1].strip() for message in errors))
    if algorithm.GetErrorCode():
        raise FilterError("vtkObject.GlobalWarningDisplayOff() is in force: VTK tells no errors")
    return [
        _of_pyvista(algorithm.GetOutputDataObject(port))
        for port in range(algorithm.GetNumberOfOutputPorts())
    ]


def _of_pyvista(data):
    """The data as PyVista's class if it has one, otherwise a copy."""
    try:
        return pyvista.wrap(data)
    except TypeError:
        copy = data.NewInstance()
        copy.ShallowCopy(data)
        return copy
