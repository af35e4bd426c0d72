# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checker/check_result.py: every result with its certificate passes it, and every mutant of a result fails it.

FLIPFLOP_CHECKER_CASES is the number of random cases of each kind: 40, if it is not set.
"""

import os
import subprocess
import sys
import zipfile
from pathlib import Path

import numpy as np
import pytest

from vtkflipflop.arrays import constrained_triangulation, convex_hull, regular_triangulation

PROGRAM = str(Path(__file__).parents[2] / "Checker" / "check_result.py")
sys.path.insert(0, os.path.dirname(PROGRAM))

import check_result as checker  # noqa: E402

CASES = int(os.environ.get("FLIPFLOP_CHECKER_CASES", "40"))


def listed(arrays):
    """As the program reads them from a file."""
    rows = lambda a: list(map(tuple, a.tolist())) if a.ndim == 2 else a.tolist()
    return {name: rows(np.asarray(a)) if not isinstance(a, list) else a for name, a in arrays.items() if a is not None}


def check(kind, arrays):
    checker.KINDS[kind](listed(arrays))


def cloud(random, columns):
    """Points of some family: in general position, with ties, of lower dimension, of any range."""
    count = int(random.integers(0, 60))
    whole = random.integers(-3, 4, (count, columns)).astype(float)
    kind = random.integers(10)
    if kind == 0:
        return whole
    if kind == 1:
        return whole * [1, 1, 0][:columns]
    if kind == 2:
        return whole[:, :1] * [1, 2, 3][:columns]
    if kind == 3:
        return np.repeat(random.random((count // 5 + 1, columns)), 5, axis=0)
    if kind == 4:
        return np.ldexp(random.standard_normal((count, columns)), random.integers(-1000, 1000, (count, columns)))
    if kind == 5:
        return whole * 5e-324
    if kind == 6:
        return whole + 2.0**52
    if kind == 7:
        angles = random.random(count) * 7
        return np.column_stack([np.cos(angles), np.sin(angles), random.random(count)])[:, :columns]
    if kind == 8:
        return random.random((count, columns)).astype(np.float32)
    points = random.random((count, columns))
    points[: count // 4] = np.nan
    return points


def weights_for(random, points):
    kind = random.integers(4)
    if kind == 0:
        return None
    if kind == 1:
        return random.integers(0, 3, len(points)).astype(float)
    spread = float(np.ptp(np.nan_to_num(points.astype(float)), axis=0).max()) if len(points) else 0.0
    return random.random(len(points)) * (min(spread, 1e150) ** 2 if kind == 2 else 0.01)


def hull_of(points):
    hull = convex_hull(points, non_finite="ignore")
    cells = [tuple(hull.vertices.tolist())] * (hull.dimension >= 0) if points.shape[1] == 2 else hull.simplices
    return {"points": points, "cells": cells, "certificate": hull.certificate, "apex": hull.apex}


def triangulation_of(points, weights=None):
    found = regular_triangulation(points, weights, non_finite="ignore")
    return {"points": points, "weights": weights, "cells": found.simplices, "hidden": found.hidden,
            "certificate": found.certificate}  # fmt: skip


def constrained_of(points, random):
    """Chains from point to point that do not cross: edges of another triangulation."""
    whole = regular_triangulation(points, random.random(len(points)) * 0.05)
    edges = whole.simplices[:, :2][random.random(whole.nsimplex) < 0.3]
    found = regular_triangulation(points, constraints=edges)
    return {"points": points, "constraints": edges, "cells": found.simplices, "hidden": found.hidden}


def alpha_of(points, weights, alpha):
    found = regular_triangulation(points, weights, non_finite="ignore")
    part = found.alpha_complex(alpha)
    return triangulation_of(points, weights) | {
        "alpha": alpha, "within": part.within, "edges": part.edges, "edge_alphas": part.edge_alphas,
        "vertices": part.vertices, "vertex_alphas": part.vertex_alphas}  # fmt: skip


def diagram_of(points, weights, box):
    found = regular_triangulation(points, weights, non_finite="ignore")
    cells = found.power_diagram(box)
    return triangulation_of(points, weights) | {
        "box": np.array(box, float), "corners": cells.vertices, "sites": cells.sites,
        "rings": [tuple(ring.tolist()) for ring in cells.cells]}  # fmt: skip


def span_of(points):
    low, high = np.nanmin(points, axis=0), np.nanmax(points, axis=0)
    return low - (high == low), high + (high == low)


@pytest.mark.parametrize("kind", ["hull", "triangulation", "constrained", "alpha", "diagram"])
def test_results_pass(kind):
    for seed in range(CASES):
        random = np.random.default_rng([seed, len(kind)])
        points = cloud(random, 3 if kind == "hull" and random.random() < 0.7 else 2)
        weights = weights_for(random, points)
        if kind == "hull":
            arrays = hull_of(points)
        elif kind == "triangulation":
            arrays = triangulation_of(points, weights)
        elif kind == "constrained":
            arrays = constrained_of(
                random.random((40, 2)) if seed % 2 else random.integers(0, 6, (30, 2)) * 0.5, random)  # fmt: skip
        else:
            points = points.astype(float)
            if len(points) == 0 or not np.isfinite(points).any() or abs(np.nan_to_num(points)).max() > 1e100:
                points = random.random((9, 2))
                weights = None
            if kind == "diagram" and np.max(points) > 2**51:
                points = points - 2.0**52  # cells of a unit in the last place are mended in more ways
            (x0, y0), (x1, y1) = span_of(points)
            arrays = alpha_of(points, weights, float(random.choice([0.0, 0.1, 0.5, 1.0, 1e300, np.inf])) * (x1 - x0)
                              ) if kind == "alpha" else diagram_of(points, weights, (x0, x1, y0, y1))  # fmt: skip
        try:
            check(kind, arrays)
            check(kind, {name: a for name, a in arrays.items() if name not in ("certificate", "apex")})
        except Exception as error:
            raise AssertionError(f"{kind}, seed {seed}: {error!r}") from error


def flipped(cells, i, random):
    """The edge between a cell and one of its neighbours, flipped; None: they have none."""
    a, b, c = cells[i]
    for j, other in enumerate(cells):
        third = set(other) - {b, c}
        if j != i and {b, c} < set(other) and len(third) == 1:
            d = third.pop()
            changed = [tuple(cell) for cell in cells]
            changed[i], changed[j] = (a, b, d), (d, c, a)
            return changed
    return None


def mutants_of_cells(arrays, random):
    """Of hulls and triangulations in general position: the name and the arrays."""
    cells = [tuple(cell) for cell in np.asarray(arrays["cells"]).tolist()]
    corners = {id for cell in cells for id in cell}
    i, count = int(random.integers(len(cells))), len(arrays["points"])
    a, b, c = cells[i]
    put = lambda cell: cells[:i] + [cell] + cells[i + 1 :]
    yield "flipped edge", {"cells": flipped(cells, i, random)}
    yield "moved id", {"cells": put((a, b, int(random.choice(sorted(set(range(count)) - {a, b, c})))))}
    yield "id out of range", {"cells": put((a, b, count))}
    yield "negative id", {"cells": put((a, b, -1))}
    yield "dropped cell", {"cells": cells[:i] + cells[i + 1 :]}
    yield "cell twice", {"cells": cells + [cells[i]]}
    yield "swapped orientation", {"cells": put((a, c, b))}
    yield "all turned over", {"cells": [(u, w, v) for u, v, w in cells]}
    yield "two corners alike", {"cells": put((a, b, b))}
    inner = next(id for id in random.permutation(count).tolist() if id not in corners)
    certificate = np.array(arrays["certificate"])
    certificate[inner] = (certificate[inner] + 1 + random.integers(len(cells) - 1)) % len(cells)
    yield "certificate names another", {"certificate": certificate}
    certificate = certificate.copy()
    certificate[inner] = random.choice([-1, len(cells)])
    yield "certificate names none", {"certificate": certificate}
    yield "certificate too short", {"certificate": certificate[:-1]}
    for number in (-1, int(next(n for n, cell in enumerate(cells) if a not in cell))):
        certificate = np.array(arrays["certificate"])
        certificate[a] = number
        yield f"certificate names {number} for a corner", {"certificate": certificate}


def mutants(random):
    """For each kind of result: (kind, name, arrays)."""
    points = random.random((50, 3))
    hull = hull_of(points)
    for name, change in mutants_of_cells(hull, random):
        yield "hull", name, hull | change
    out = points.copy()
    inner = int(np.setdiff1d(np.arange(50), hull["cells"])[0])
    out[inner] += random.choice([-2, 2], 3)
    yield "hull", "point outside", hull | {"points": out}
    yield "hull", "apex outside", hull | {"apex": hull["apex"] + 2}
    for value in (np.nan, np.inf):
        yield "hull", "apex that is not finite", hull | {"apex": np.full_like(hull["apex"], value)}
    yield "hull", "apex on a vertex", hull | {"apex": points[hull["cells"][0, :1]]}
    corner = int(hull["cells"][0, 0])
    less = hull_of(np.delete(points, corner, axis=0))
    yield "hull", "vertex passed over", {"points": points, "cells": less["cells"] + (less["cells"] >= corner)}
    flat = points * [1, 1, 0]
    polygon = hull_of(flat)
    yield "hull", "flat: dropped cell", polygon | {"cells": polygon["cells"][1:]}
    yield "hull", "of another dimension", {"points": flat, "cells": hull["cells"]}

    weights = random.random(50) * 0.02
    triangulation = triangulation_of(points[:, :2], weights)
    for name, change in mutants_of_cells(triangulation, random):
        yield "triangulation", name, triangulation | change
    hidden = triangulation["hidden"]
    yield "triangulation", "wrong hidden point", triangulation | {
        "hidden": np.append(hidden[1:], triangulation["cells"][0, 0])}  # fmt: skip
    yield "triangulation", "hidden twice", triangulation | {"hidden": np.append(hidden, hidden[-1])}
    yield "triangulation", "hidden id out of range", triangulation | {"hidden": np.append(hidden, 50)}
    yield "triangulation", "no hidden point", triangulation | {"hidden": hidden[:0]}
    raised = weights.copy()
    raised[hidden[0]] += 1
    yield "triangulation", "hidden point outweighs", triangulation | {"weights": raised}
    most = int(np.argmax(weights))
    less = triangulation_of(np.delete(points[:, :2], most, axis=0), np.delete(weights, most))["cells"]
    yield "triangulation", "vertex passed over", {
        "points": points[:, :2], "weights": weights, "cells": less + (less >= most)}  # fmt: skip
    line = triangulation_of(points[:, :1] * [1, 2])
    yield "triangulation", "chain: dropped cell", line | {"cells": line["cells"][1:], "hidden": None}

    constrained = constrained_of(points[:, :2], random)
    plain = triangulation_of(points[:, :2])
    yield "constrained", "without its constraints", constrained | {"cells": plain["cells"]}
    across = [int(np.argmin(points[:, 0])), int(np.argmax(points[:, 0]))]
    yield "constrained", "one more constraint", constrained | {
        "constraints": np.vstack([constrained["constraints"], across])}  # fmt: skip
    for sides in (-1, len(constrained["constraints"]) + 1):
        yield "constrained", "more sides than constraints, or fewer than none", constrained | {"sides": sides}
    chain = {"points": line["points"], "constraints": line["cells"][:1], "cells": line["cells"]}
    check("constrained", chain | {"kept": line["cells"]})
    for kept in (line["cells"][1:], line["cells"][[0, *range(len(line["cells"]))]], line["cells"] + 1):
        yield "constrained", "kept of a line", chain | {"kept": kept}
    yield "constrained", "no constraint", constrained | {"constraints": constrained["constraints"][:0]}
    square = {"points": np.array([[0, 0], [4, 0], [4, 4], [0, 4], [1, 1], [3, 1], [3, 3], [1, 3]], float),
              "constraints": np.array([[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4]]),
              "sides": 8}  # fmt: skip
    whole = regular_triangulation(square["points"], constraints=square["constraints"])
    kept = regular_triangulation(square["points"], polygons=[[0, 1, 2, 3], [4, 5, 6, 7]])
    square |= {"cells": whole.simplices, "kept": kept.simplices}
    check("constrained", square)
    yield "constrained", "hole filled", square | {"kept": whole.simplices}
    yield "constrained", "kept cell dropped", square | {"kept": kept.simplices[1:]}
    both = constrained_triangulation([], [
        {"type": "Polygon", "coordinates": [[(t, t), (t + 4, t), (t + 4, t + 4), (t, t + 4), (t, t)]]} for t in (0, 2)
    ])  # fmt: skip
    whole = regular_triangulation(both.points, constraints=both.constraints)
    union = {"points": both.points, "constraints": both.constraints, "cells": whole.simplices, "kept": both.simplices,
             "sides": len(both.constraints), "features": both.geometry_of}  # fmt: skip
    check("constrained", union)
    yield "constrained", "one feature in place of two", union | {"features": None}
    yield "constrained", "the other feature", union | {"features": np.roll(both.geometry_of, 1)}
    yield "constrained", "a feature of no side", union | {"features": [*both.geometry_of.tolist(), 0]}
    yield "constrained", "kept cell twice", square | {"kept": kept.simplices[[0, *range(len(kept.simplices))]]}

    alpha = alpha_of(points[:, :2], weights * 0.01, 0.05)
    within, i = alpha["within"].copy(), int(random.integers(len(alpha["within"])))
    within[i] = not within[i]
    yield "alpha", "cell", alpha | {"within": within}
    yield "alpha", "another alpha", alpha | {"alpha": 0.16}
    yield "alpha", "dropped edge", alpha | {"edges": alpha["edges"][1:]}
    if len(alpha["vertices"]):
        yield "alpha", "dropped vertex", alpha | {"vertices": alpha["vertices"][1:]}
    for name in ("within", "edge_alphas", "vertex_alphas", "edges", "vertices"):
        more = alpha[name][[0, *range(len(alpha[name]))]] if len(alpha[name]) else np.ones(1)
        yield "alpha", f"{name}: one more", alpha | {name: more}
        if len(alpha[name]):
            yield "alpha", f"{name}: one less", alpha | {name: alpha[name][:-1]}
    yield "alpha", "an alpha that is no number", alpha | {"edge_alphas": alpha["edge_alphas"] * np.nan}
    for step in (-1, 1):
        yield "alpha", "an edge's alpha off by one ulp", alpha | {
            "edge_alphas": np.nextafter(alpha["edge_alphas"], step * np.inf)}  # fmt: skip

    diagram = diagram_of(points[:, :2], weights, (0.25, 0.75, 0.25, 0.75))
    rings = diagram["rings"]
    moved = diagram["corners"].copy()
    which = int(random.integers(len(moved)))
    moved[which] = np.nextafter(moved[which], random.choice([-1, 1], 2))
    yield "diagram", "corner off by one ulp", diagram | {"corners": moved}
    corners = len(moved)
    yield "diagram", "corner of no cell", diagram | {"corners": np.vstack([diagram["corners"], [0.3, 0.3]])}
    yield "diagram", "corner twice", diagram | {
        "corners": np.vstack([diagram["corners"], diagram["corners"][rings[0][:1]]]),
        "rings": [(corners, *rings[0][1:]), *rings[1:]]}  # fmt: skip
    for i in (rings[0][0] - corners, corners):
        yield "diagram", "corner out of range", diagram | {"rings": [(i, *rings[0][1:]), *rings[1:]]}
    yield "diagram", "site twice", diagram | {"sites": diagram["sites"][[0, 0, *range(2, len(rings))]]}
    yield "diagram", "site out of range", diagram | {"sites": [50, *diagram["sites"][1:]]}
    yield "diagram", "dropped cell", diagram | {"rings": rings[1:], "sites": diagram["sites"][1:]}
    yield "diagram", "sites exchanged", diagram | {"sites": np.roll(diagram["sites"], 1)}
    yield "diagram", "dropped corner", diagram | {"rings": [rings[0][1:], *rings[1:]]}
    yield "diagram", "turned over", diagram | {"rings": [rings[0][::-1], *rings[1:]]}
    yield "diagram", "another box", diagram | {"box": np.array([0.25, 0.75, 0.25, 0.76])}


def test_mutants_fail():
    count = 0
    for seed in range(4):
        for kind, name, arrays in mutants(np.random.default_rng(seed)):
            if arrays["cells"] is None:
                continue
            count += 1
            with pytest.raises(checker.Wrong) as found:
                check(kind, arrays)
                pytest.fail(f"{kind}, {name}, seed {seed} is not noticed")
            assert str(found.value)
    assert count >= 200


def test_the_program(tmp_path):
    """Files, exit codes, messages."""

    def run(kind, path):
        done = subprocess.run([sys.executable, PROGRAM, kind, path], capture_output=True, text=True)
        return done.returncode, done.stdout + done.stderr

    points, path = np.random.default_rng(1).random((500, 3)), str(tmp_path / "hull.npz")
    hull = convex_hull(points)
    np.savez(path, points=points, cells=hull.simplices, certificate=hull.certificate, apex=hull.apex)
    assert run("hull", path)[0] == 0
    np.savez_compressed(path, points=np.asfortranarray(points), cells=hull.simplices)
    assert run("hull", path)[0] == 0
    polygons = convex_hull(np.round(points * 4)).polygons
    np.savez(path, points=np.round(points * 4), connectivity=polygons.connectivity, offsets=polygons.offsets)
    assert run("hull", path)[0] == 0
    np.savez(path, points=points, cells=hull.simplices[1:])
    code, text = run("hull", path)
    assert code == 1 and "has no facet on its other side" in text
    for offsets in (polygons.offsets[::-1], polygons.offsets[:-1], polygons.offsets + 1, polygons.offsets[:0]):
        np.savez(path, points=np.round(points * 4), connectivity=polygons.connectivity, offsets=offsets)
        code, text = run("hull", path)
        assert code == 1 and "the offsets of cells" in text
    np.savez(path, points=points)
    assert run("hull", path)[0] == 2
    assert run("hull", str(tmp_path / "none.npz"))[0] == 2


def test_types_of_files(tmp_path):
    """Weights of every type count; what is not read is refused by its name, as is a header that does not fit."""
    path = str(tmp_path / "case.npz")
    points = np.array([[0, 0], [4, 0], [4, 4], [0, 4], [2, 2]])

    def read(**arrays):
        np.savez(path, **arrays)
        return checker.read_case(type("Given", (), {"result": path}))

    for kind in ("f8", "f4", "f2", "i8", "i4", "i2", "i1", "u8", "u4", "u2", "u1", ">f8", ">i4", ">f2"):
        for weights in (np.array([20, 20, 20, 20, 0], kind), np.array([[20], [20], [20], [20], [0]], kind)):
            found = regular_triangulation(points, weights)
            case = {"points": points.astype(kind), "weights": weights, "hidden": found.hidden}
            assert found.hidden.tolist() == [4]
            checker.KINDS["triangulation"](read(**case, cells=found.simplices))
            with pytest.raises(checker.Wrong, match="point 4 is not hidden|hidden points"):
                checker.KINDS["triangulation"](
                    read(**case | {"weights": weights * 0}, cells=found.simplices))  # fmt: skip
    checker.KINDS["triangulation"](read(points=points, weights=np.ones(5, bool), cells=[
        (0, 1, 4), (0, 4, 3), (1, 2, 4), (2, 3, 4)]))  # fmt: skip
    for kind in (np.longdouble, complex, "U3", "M8[s]"):
        with pytest.raises(ValueError, match="array weights has the type"):
            read(points=points, weights=np.zeros(5, kind))
    with pytest.raises(ValueError, match="as many weights"):
        checker.KINDS["triangulation"](read(points=points, weights=np.zeros(0), cells=points[:0, :1]))
    for shape in ("(2305843009213693952,)", "(2305843009213693952, 3)", "(-1, -10)", "(5, 0)", "(1, 2, 5)"):
        header = f"{{'descr': '<i8', 'fortran_order': False, 'shape': {shape}, }}\n".encode()
        with zipfile.ZipFile(path, "w") as archive:
            data = b"" if shape == "(5, 0)" else points.tobytes()
            archive.writestr("points.npy", b"\x93NUMPY\1\0" + len(header).to_bytes(2, "little") + header + data)
        with pytest.raises(ValueError, match="array points has not the numbers of its shape"):
            checker.read_case(type("Given", (), {"result": path}))
