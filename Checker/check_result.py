#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks a hull, a triangulation, an alpha complex or a power diagram, exactly.

    check_result.py hull|triangulation|constrained|alpha|diagram RESULT [POINTS] [options]

RESULT is an .npz file with the arrays of Documentation/CheckAResult.md; or a .vtp file of a hull, a triangulation or a
diagram, and POINTS that of the input. Exit codes: 0 right, 1 wrong (the message names what), 2 a file cannot be read.

This program shares nothing with what it checks: it uses Python's integers and fractions alone. Why it is enough:
(1) A hull: every edge is in two facets, once in either direction; no facet's neighbour is above it; an interior point,
the apex, is beneath all facets; and the ray from it through one facet meets no other. Then the surface is the border of
a convex body (Mehlhorn, Naeher, Seel, Seidel, Schilz, Schirra, Uhrig, "Checking geometric programs or verification of
geometric structures", Computational Geometry 12, 1999). A point in the cone of a facet and beneath it is inside; so
with the certificate, which names that facet, a point costs four signs. (2) A triangulation: all cells turn left, and
the edges with one cell are one convex loop. How many cells cover a point is how often the loop winds around it: once.
No neighbour's lift is beneath a cell's plane, so the lifts are a convex function; and a point is hidden if its lift is
not beneath the cell that holds it. (3) The rest is computed from the triangulation, in fractions.
Ties are free: points on a facet, on an edge or on a cell's power circle may be vertices or not.
"""

import argparse
import bisect
import math
import sys
from fractions import Fraction

from result_files import Wrong, read_case, require

flat_of = lambda rows: [x for row in rows or () for x in (row if isinstance(row, tuple) else (row,))]
sides_of = lambda ring: zip(ring, [*ring[1:], *ring[:1]])
turned = lambda ring: (*ring[ring.index(min(ring)) :], *ring[: ring.index(min(ring))]) if ring else ()
minus = lambda a, b: tuple(x - y for x, y in zip(a, b))
cross = lambda u, v: (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
dot = lambda u, v: u[0] * v[0] + u[1] * v[1] + u[2] * v[2]
turn = lambda a, b, c: (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


class Exact:
    """Coordinates and weights as integers: multiples of one power of two."""

    def __init__(self, case):
        self.columns = len(case["points"][0]) if case["points"] else 3
        given = [0.0] * len(case["points"]) if case.get("weights") is None else flat_of(case["weights"])
        if len(given) != len(case["points"]) or self.columns not in (2, 3):
            raise ValueError("points have 2 or 3 coordinates, and there are as many weights as points")
        for name in ("apex", "box", "corners", "edge_alphas", "vertex_alphas"):
            for x in flat_of(case.get(name)):
                require(math.isfinite(x) or ("alpha" in name and x == x), f"{name} has {x} among its numbers")
        keep = [all(map(math.isfinite, (*row, w))) for row, w in zip(case["points"], given)]
        rows = [row for row, k in zip(case["points"], keep) if k] + list(case.get("apex") or [])
        rows += [flat_of(case.get("box"))]
        bits = lambda x: x.as_integer_ratio()[1].bit_length() - 1
        self.shift = max([0, *(bits(x) for row in rows for x in row)])
        self.shift = max([self.shift, *((bits(w) + 1) // 2 for w, k in zip(given, keep) if k)])
        self.points = [self.scaled(row) if k else None for row, k in zip(case["points"], keep)]
        self.weights = [self.scaled((w,), 2)[0] if k else 0 for w, k in zip(given, keep)]
        self.ids = [i for i, k in enumerate(keep) if k]

    def scaled(self, row, power=1):
        return tuple((n << power * self.shift) // d for n, d in (x.as_integer_ratio() for x in row))

    def in_plane(self):
        """Also positions in the plane, and lifts, (x, y, x^2 + y^2 - w)."""
        self.plane = [p and p[:2] for p in self.points]
        self.lift = [p and (p[0], p[1], p[0] * p[0] + p[1] * p[1] - w) for p, w in zip(self.points, self.weights)]
        return self

    def above(self, cell, id):
        """Positive: a point's lift is above the plane of a cell's; zero on it; negative beneath it."""
        a, b, c, p = (self.lift[i] for i in (*cell[:3], id))
        return dot(cross(minus(b, a), minus(c, a)), minus(p, a))

    def rounded(self, x):
        """The double nearest to an exact coordinate."""
        return x.numerator / (x.denominator << self.shift)


def independent(points, ids):
    """Up to four of the ids, of points that span what all of them span."""
    found, origin, rest = [], None, None
    for i in ids:
        p = (*points[i], 0)[:3]
        if not found:
            origin = p
        elif len(found) == 1 and p != origin:
            rest = minus(p, origin)
        elif len(found) == 2 and any(cross(rest, minus(p, origin))):
            rest = cross(rest, minus(p, origin))
        elif len(found) != 3 or not dot(rest, minus(p, origin)):
            continue
        found.append(i)
        if len(found) == 4:
            break
    return found


def in_fan(ring, sign):
    """Is a point in a convex polygon? sign(u, v): positive on the left of the side from corner u to v."""
    low, high = 1, len(ring) - 1
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if sign(ring[0], ring[middle]) >= 0 else (low, middle)
    return sign(ring[low], ring[high]) >= 0 and sign(ring[0], ring[low]) >= 0 and sign(ring[high], ring[0]) >= 0


class Cells:
    """Cells whose corners are ids; and for each edge, from u to v, the cell that has it."""

    def __init__(self, case, exact, least):
        self.cells, self.across = [tuple(cell) for cell in case["cells"]], {}
        for number, cell in enumerate(self.cells):
            require(len(cell) >= least and len(set(cell)) == len(cell), f"cell {number} has the corners {cell}")
            right = all(0 <= id < len(exact.points) and exact.points[id] is not None for id in cell)
            require(right, f"cell {number} has the corners {cell}, which are not all finite points")
            for edge in sides_of(cell) if least > 2 else ():
                before = self.across.setdefault(edge, number)
                require(before == number, f"the edge from {edge[0]} to {edge[1]} is in the cells {before} and {number}")
        self.corners = {id for cell in self.cells for id in cell}
        self.named = case.get("certificate")
        require(self.named is None or len(self.named) == len(exact.points), "a certificate has an entry a point")
        for id, number in enumerate(self.named or ()):
            right = -1 <= number < len(self.cells)
            right = right and (id not in self.corners or (number >= 0 and id in self.cells[number]))
            require(right, f"the certificate names cell {number} for point {id}")

    def each_edge(self):
        """Of each cell each edge (u, v), the cell across, and that cell's corner after the edge; None at the border."""
        for (u, v), number in self.across.items():
            other = self.across.get((v, u))
            ring = () if other is None else self.cells[other]
            yield number, u, v, other, ring[(ring.index(u) + 1) % len(ring)] if ring else None

    def neighbours(self):
        """Of each corner those at the other ends of its edges."""
        near = {id: set() for id in self.corners}
        for u, v in (side for cell in self.cells if len(cell) > 1 for side in sides_of(cell)):
            near[u].add(v)
            near[v].add(u)
        return near

    def holding(self, id, sign, start):
        """The cell that holds a point: the certificate's, or found by walking. sign(u, v) is that of in_fan."""
        if self.named is not None:
            number = self.named[id]
            if number < 0 or not in_fan(self.cells[number], sign):
                raise Wrong(f"point {id} is not in cell {number}, which the certificate names")
            return number
        while out := next(((v, u) for u, v in sides_of(self.cells[start]) if sign(u, v) < 0), None):
            require(out in self.across, f"no cell holds point {id}")
            start = self.across[out]
        return start


def check_hull(case):
    exact = Exact(case)
    span = independent(exact.points, exact.ids)
    if len(span) > 2:
        return check_solid(case, exact) if len(span) == 4 else check_polygon(case, exact, span)
    cells = Cells(case, exact, len(span)).cells
    right = [len(cell) for cell in cells] == [len(span)] * bool(span)
    require(right, f"the points span dimension {len(span) - 1}, and the cells are {cells[:3]}")
    ends = sorted(exact.points[id] for cell in cells for id in cell)
    for id in exact.ids:
        require(ends[0] <= exact.points[id] <= ends[-1], f"point {id} is outside of the cell {cells[0]}")


def check_polygon(case, exact, span):
    """Of points in a plane: seen along an axis, in which the polygon turns left."""
    shadow = lambda p, q: {id: (exact.points[id][p], exact.points[id][q]) for id in exact.ids}
    shadows = (shadow(p, q) for p, q in ([(0, 1), (2, 0), (1, 2)] if exact.columns == 3 else [(0, 1)]))
    plane = next(s for s in shadows if turn(*(s[id] for id in span)))
    cells, start = Cells(case, exact, 3), 0
    check_cover(plane, cells)
    for id in exact.ids:
        start = cells.holding(id, lambda u, v: turn(plane[u], plane[v], plane[id]), start)


def check_solid(case, exact):
    cells, points = Cells(case, exact, 3), exact.points
    apexes = [exact.scaled(row) for row in case.get("apex") or []]
    apexes = apexes or [points[i] for i in independent(points, sorted(cells.corners))] or [(0, 0, 0)]
    apex = tuple(map(sum, zip(*apexes)))
    seen = lambda id: tuple(len(apexes) * x - s for x, s in zip(points[id], apex))  # from the apex
    rays, planes = {id: seen(id) for id in cells.corners}, []
    require(cells.cells, "there is no facet")
    for number, cell in enumerate(cells.cells):
        corners = [rays[id] for id in cell]
        normal = cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]))
        height = dot(normal, corners[0])
        require(height > 0, f"the apex is not beneath facet {number}, {cell}")
        for i in range(len(cell)) if len(cell) > 3 else ():
            u, v, w = corners[i - 2], corners[i - 1], corners[i]
            require(dot(normal, w) == height, f"the corner {cell[i]} of facet {number} is not in its plane")
            right = dot(cross(u, v), w) > 0 and (i < 2 or dot(cross(corners[0], v), w) > 0)
            require(right, f"facet {number}, {cell}, is not convex at its corner {cell[i - 1]}")
        planes.append((normal, height))
    for number, u, v, other, corner in cells.each_edge():
        require(other is not None, f"the edge from {u} to {v} of facet {number} has no facet on its other side")
        if dot(planes[number][0], rays[corner]) > planes[number][1]:
            raise Wrong(f"the edge from {u} to {v} is not convex: point {corner} is above facet {number}")
    ray = tuple(map(sum, zip(*(rays[id] for id in cells.cells[0]))))
    for number in range(1, len(cells.cells)):
        if in_fan(cells.cells[number], lambda u, v: dot(cross(rays[u], rays[v]), ray)):
            raise Wrong(f"the surface winds more than once: facet {number} is in front of facet 0, or behind it")
    start = 0
    for id in exact.ids:
        if id not in cells.corners:
            ray = seen(id)
            start = cells.holding(id, lambda u, v: dot(cross(rays[u], rays[v]), ray), start)
            if dot(planes[start][0], ray) > planes[start][1]:
                raise Wrong(f"point {id} is outside: above facet {start}, {cells.cells[start]}")


def check_cover(plane, cells):
    """The cells cover one convex polygon, once."""
    for number, cell in enumerate(cells.cells):
        for i in range(len(cell)):
            a, u, v, w = (plane[cell[j]] for j in (0, i - 2, i - 1, i))
            if turn(u, v, w) <= 0 or (i > 1 and turn(a, v, w) <= 0):
                raise Wrong(f"cell {number}, {cell}, does not turn left at its corner {cell[i - 1]}")
    following = {}
    for u, v in cells.across:
        if (v, u) not in cells.across:
            require(u not in following, f"the border has two edges from {u}")
            following[u] = v
    require(following, "there is no cell")
    first = u = next(iter(following))
    count = least = 0
    while count == 0 or u != first:
        v = following[u]
        require(v in following and count < len(following), f"the border is no loop at {v}")
        a, b, c = plane[u], plane[v], plane[following[v]]
        require(turn(a, b, c) > 0 or (turn(a, b, c) == 0 and (a < b) == (b < c)), f"the border is not convex at {v}")
        least += b < a and b < c
        u, count = v, count + 1
    require(count == len(following) and least == 1, "the border is not one convex loop")


def check_triangulation(case, constrained=False):
    exact = Exact(case).in_plane()
    dimension = len(independent(exact.plane, exact.ids)) - 1
    cells = Cells(case, exact, dimension + 1)
    fixed = fixed_edges(case, exact, cells) if constrained else {}
    if dimension == 2:
        check_plane(exact, cells, fixed, constrained)
    elif dimension == 1:
        check_chain(exact, cells)
    elif [len(cell) for cell in cells.cells] != [1] * (dimension + 1):
        raise Wrong(f"the points span dimension {dimension}, and the cells are {cells.cells[:3]}")
    for id in exact.ids if dimension == 0 else ():
        require(exact.lift[id] >= exact.lift[cells.cells[0][0]], f"point {id} hides point {cells.cells[0][0]}")
    hidden = sorted(set(exact.ids) - cells.corners)
    given = hidden if case.get("hidden") is None else sorted(case["hidden"])
    odd = min(set(hidden) ^ set(given), default=None)
    require(given == hidden, f"the hidden points are not those that no cell has, each once: see point {odd}")
    return exact, cells, dimension, fixed


def check_plane(exact, cells, fixed, constrained):
    check_cover(exact.plane, cells)
    for number, cell in enumerate(cells.cells):
        for id in cell[3:]:
            require(not exact.above(cell, id), f"the corner {id} of cell {number} is not on its power circle")
    for number, u, v, other, corner in cells.each_edge():
        if other is not None and (u, v) not in fixed and exact.above(cells.cells[number], corner) < 0:
            raise Wrong(f"the edge from {u} to {v} is not regular: {corner} is in the power circle of cell {number}")
    start, positions = 0, {exact.plane[id] for id in cells.corners}
    for id in exact.ids:
        p = exact.plane[id]
        if id in cells.corners or (constrained and p in positions):
            continue
        require(not constrained, f"point {id} is no corner")
        start = cells.holding(id, lambda u, v: turn(exact.plane[u], exact.plane[v], p), start)
        if exact.above(cells.cells[start], id) < 0:
            raise Wrong(f"point {id} is not hidden: it is in the power circle of cell {start}, which holds it")


def check_chain(exact, cells):
    """Of points on a line."""
    along = lambda id: exact.plane[id]
    chain = sorted(cells.corners, key=along)
    links = sorted(tuple(sorted(cell, key=along)) for cell in cells.cells)
    require(len(chain) > 1 and links == sorted(zip(chain, chain[1:])), "the cells are no chain along the points' line")
    positions = [along(id) for id in chain]
    axis = int(positions[0][0] == positions[-1][0])
    flat = lambda id: (exact.lift[id][axis], exact.lift[id][2])
    for u, v, w in zip(chain, chain[1:], chain[2:]):
        require(turn(flat(u), flat(v), flat(w)) >= 0, f"point {v} is above the chord of its neighbours: it is hidden")
    for id in exact.ids:
        require(positions[0] <= along(id) <= positions[-1], f"point {id} is outside of the chain")
        i = max(1, bisect.bisect_left(positions, along(id)))
        if turn(flat(chain[i - 1]), flat(chain[i]), flat(id)) < 0:
            raise Wrong(f"point {id} is not hidden: it is beneath the chord of {chain[i - 1]} and {chain[i]}")


def fixed_edges(case, exact, cells):
    """The edges that constraints run along, in both directions; of each the features that it is a side of, oddly."""
    if any(case.get("weights") or ()):
        raise ValueError("constraints take no weights")
    plane, near, fixed = exact.plane, cells.neighbours(), {}
    at, constraints = {plane[id]: id for id in cells.corners}, case.get("constraints") or []
    sides = case.get("sides") or 0
    require(0 <= sides <= len(constraints), f"{sides} of {len(constraints)} constraints are sides")
    features = [0] * sides if case.get("features") is None else case["features"]
    require(len(features) == sides, f"there are {len(features)} features of {sides} sides")
    of = [set()] * (len(constraints) - sides) + [{feature} for feature in features]
    for number, ends in enumerate(constraints):
        right = all(0 <= id < len(plane) and plane[id] in at for id in ends)
        require(right, f"constraint {number} ends where no corner is: {ends}")
        u, end = (at[plane[id]] for id in ends)
        while u != end:
            a, b = plane[u], plane[end]
            on = lambda p: turn(a, p, b) == 0 and (a < p <= b or b <= p < a)
            v = next((v for v in near[u] if on(plane[v])), None)
            require(v is not None, f"constraint {number}, from {ends[0]} to {ends[1]}, is no edge at point {u}")
            fixed[u, v] = fixed.get((u, v), set()) ^ of[number]
            fixed.setdefault((v, u), set())
            u = v
    return fixed


def check_constrained(case):
    """Constraints are edges, all others Delaunay; cells kept are inside any feature, of each by the even-odd rule."""
    _, cells, dimension, fixed = check_triangulation(case, constrained=True)
    if case.get("kept") is None:
        return
    parity, queue = {None: set()}, []  # of each cell the features that it is inside of
    crossed = lambda u, v: fixed.get((u, v), set()) ^ fixed.get((v, u), set())
    for number, u, v, other, _ in cells.each_edge():
        if other is None:
            parity[number] = crossed(u, v)
            queue.append(number)
    while queue:
        number = queue.pop()
        for u, v in sides_of(cells.cells[number]):
            other = cells.across.get((v, u))
            beyond = parity[number] ^ crossed(u, v)
            if other not in parity:
                parity[other] = beyond
                queue.append(other)
            require(parity[other] == beyond, f"the sides of a feature are not closed: see the edge from {u} to {v}")
    if dimension < 2:  # on a line nothing is outside
        parity = dict.fromkeys(range(len(cells.cells)), {0})
    inside, kept = {turned(cells.cells[n]) for n, odd in parity.items() if odd}, [turned(cell) for cell in case["kept"]]
    odd = min(set(kept) ^ inside, default=None)
    require(odd is None and len(kept) == len(inside), f"the cells kept are not those inside: see cell {odd}")


def circle_of(exact, ids):
    """The least circle of power distance 0 from one to three corners: its centre, and the square of its radius."""
    (ax, ay), weights = exact.plane[ids[0]], exact.weights
    rest = [minus(exact.plane[i], (ax, ay)) for i in ids[1:3]]
    rise = [p[0] * p[0] + p[1] * p[1] - weights[i] + weights[ids[0]] for i, p in zip(ids[1:3], rest)]
    x = y = Fraction(0)
    if len(rest) == 1:
        x, y = (Fraction(rise[0] * t, 2 * (rest[0][0] ** 2 + rest[0][1] ** 2)) for t in rest[0])
    elif rest:
        (bx, by), (cx, cy) = rest
        twice = 2 * (bx * cy - by * cx)
        x, y = Fraction(cy * rise[0] - by * rise[1], twice), Fraction(bx * rise[1] - cx * rise[0], twice)
    return ax + x, ay + y, x * x + y * y - weights[ids[0]]


def check_alpha(case):
    """A simplex is in if its circle is at most alpha and no other corner is in that; or if a larger one has it."""
    exact, cells, dimension, _ = check_triangulation(case)
    signed = lambda a: a if math.isinf(a) else Fraction(a) * abs(Fraction(a)) * (1 << 2 * exact.shift)
    limit = signed(case["alpha"])
    within = [circle_of(exact, cell)[2] <= limit for cell in cells.cells]
    odd = next((n for n, pair in enumerate(zip(case["within"], within)) if bool(pair[0]) != pair[1]), None)
    require(odd is None and len(case["within"]) == len(within), f"cell {odd} is in, or out, and should not be")

    def own(simplex, others):
        x, y, square = circle = circle_of(exact, simplex)
        reach = lambda p, w: (p[0] - x) ** 2 + (p[1] - y) ** 2 - w - square
        free = all(reach(exact.plane[id], exact.weights[id]) >= 0 for id in others)
        return [(simplex, circle[2])] if free and square <= limit else []

    at_edge, near, edges, vertices = {}, cells.neighbours(), [], []
    for number, u, v, _, _ in cells.each_edge():
        at_edge.setdefault((min(u, v), max(u, v)), []).append(number)
    for edge, numbers_of in at_edge.items():
        if not any(within[number] for number in numbers_of):
            edges += own(edge, {id for number in numbers_of for id in cells.cells[number]} - set(edge))
    touched = {id for cell, used in zip(cells.cells, within) if used for id in cell}
    touched |= {id for edge, _ in edges for id in edge}
    for id in cells.corners - touched if dimension > 0 else ():
        vertices += own((id,), near[id])
    for name, right, least in (("edges", edges, "edge_alphas"), ("vertices", vertices, "vertex_alphas")):
        found = [row if isinstance(row, tuple) else (row,) for row in case.get(name) or ()]
        is_same = name not in case or found == sorted(simplex for simplex, _ in right)
        require(is_same, f"the single {name} are not those of the complex")
        alphas = case.get(least) or [] if least in case else None
        require(alphas is None or len(alphas) == len(right), f"{least} are not as many as the single {name}")
        for (simplex, square), a in zip(sorted(right), alphas or ()):
            is_least = signed(a) >= square > signed(math.nextafter(a, -math.inf))
            require(is_least, f"{a} is not the least alpha of {simplex}")


def clipped(ring, a, b, c):
    """The part of a convex polygon where a x + b y <= c."""
    kept = []
    for p, q in sides_of(ring):
        s, t = a * p[0] + b * p[1] - c, a * q[0] + b * q[1] - c
        if s <= 0:
            kept.append(p)
        if (s < 0 < t) or (t < 0 < s):
            share = Fraction(s) / (s - t)
            kept.append((p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1])))
    return [p for p, q in sides_of(kept) if p != q]


def true_cells(exact, cells, domain):
    """Of each site the power cell in the domain, its corners rounded at the end alone."""
    near, found = cells.neighbours(), {}
    for id in sorted(cells.corners):
        (x, y, height), ring = exact.lift[id], [exact.scaled(p) for p in domain]
        for u, v, far in (exact.lift[other] for other in near[id]):
            ring = clipped(ring, 2 * (u - x), 2 * (v - y), far - height)
        if ring:  # also without an inside: rounding may give it to a neighbour
            corners = [tuple(exact.rounded(Fraction(t)) for t in p) for p in ring]
            found[id] = turned([p for p, q in sides_of(corners) if p != q] or corners[:1])
    return found


def check_diagram(case):
    """Each cell is the true one, its corners rounded; mended where that is not convex, edges of four units merged."""
    exact, cells, _, _ = check_triangulation(case)
    domain = list(case["box"])
    if not isinstance(domain[0], tuple):
        domain = [(domain[i], domain[j]) for i, j in ((0, 2), (1, 2), (1, 3), (0, 3))]
    turns_right = sum(turn((0, 0), p, q) for p, q in sides_of([exact.scaled(p) for p in domain])) < 0
    wanted = true_cells(exact, cells, domain[::-1] if turns_right else domain)
    used = {i for ring in case["rings"] for i in ring}
    require(used == set(range(len(case["corners"]))), "the corners are not those that cells have")
    require(len(set(case["corners"])) == len(case["corners"]), "two corners are one position")
    rings = [turned([tuple(case["corners"][i]) for i in ring]) for ring in case["rings"]]
    found = dict(zip(case["sites"], rings))
    require(len(found) == len(rings) == len(case["sites"]), "there are not as many sites as cells")
    exactly = lambda p: tuple(map(Fraction, p))
    turns = lambda ring: [turn(*map(exactly, (ring[i - 2], ring[i - 1], p))) for i, p in enumerate(ring)]
    gap = lambda p, q: max(map(abs, minus(p, q))) / math.ulp(max(map(abs, (*p, *q))))
    moved = lambda p, ring: min((q for q in ring if gap(p, q) <= 4), key=lambda q: gap(p, q), default=())
    has_inside = lambda ring: len(ring) > 2 and min(turns(ring)) >= 0 < max(turns(ring))
    bent = {p for ring in wanted.values() if not has_inside(ring) for p in ring}
    true = {p for ring in wanted.values() for p in ring}
    other = {id: wanted.get(id, ()) for id in {*wanted, *found} if wanted.get(id, ()) != found.get(id, ())}
    merged = lambda ring, right: ring == turned([p for p, q in sides_of([moved(p, ring) for p in right]) if p != q])
    may_be = lambda ring, right: true.issuperset(ring) and (bent & set(right) or (ring and merged(ring, right)))
    # What is mended at one cell may need mending at the next.
    while mended := [id for id, right in other.items() if may_be(found.get(id, ()), right)]:
        bent.update(p for id in mended for p in other.pop(id))
    for id in sorted(other):
        raise Wrong(f"the cell of point {id} is not the true one, rounded: {found.get(id)}, not {other[id]}")


KINDS = {kind: globals()["check_" + kind] for kind in ("hull", "triangulation", "constrained", "alpha", "diagram")}


def main(arguments):
    parser = argparse.ArgumentParser(description="Checks a result exactly: 0 right, 1 wrong, 2 unreadable.")
    parser.add_argument("kind", choices=list(KINDS))
    parser.add_argument("result", help=".npz, or .vtp of the result")
    parser.add_argument("points", nargs="?", help=".vtp of the input")
    parser.add_argument("--weights", help="name of the input's point array of weights")
    parser.add_argument("--triangulation", help=".vtp of the triangulation, for a diagram")
    parser.add_argument("--box", type=float, nargs=4, help="x0 x1 y0 y1, for a diagram")
    given = parser.parse_args(arguments)
    try:
        case = read_case(given)
        KINDS[given.kind](case)
    except Wrong as wrong:
        print(f"{given.result}: wrong: {wrong}")
        return 1
    except Exception as error:  # a file of another form
        print(f"{given.result}: cannot be read: {type(error).__name__}: {error}", file=sys.stderr)
        return 2
    print(f"{given.result}: right: {given.kind} of {len(case['points'])} points, {len(case['cells'])} cells")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
