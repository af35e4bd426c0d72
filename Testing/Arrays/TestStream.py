# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""stream(): all files together are the call in memory, bit for bit, of any input; what pieces may be; their errors."""

import numpy as np
import pytest

from streams import blocks_of, check, digest, joined, tried
from TestLas import las
from vtkflipflop.arrays import InputError, read_las, stream

RANDOM = np.random.default_rng(26)
POINTS = RANDOM.random((3000, 3))
WEIGHTS = RANDOM.random(3000) * 0.002
BALL = RANDOM.standard_normal((2000, 3))
SPHERE = np.round(BALL / np.linalg.norm(BALL, axis=1)[:, None] * 2.0**20) / 2.0**20
GRID = np.stack(np.meshgrid(*[np.arange(12.0)] * 3, indexing="ij"), -1).reshape(-1, 3)[RANDOM.permutation(12**3)]
LINE = np.arange(300.0)[RANDOM.permutation(300)][:, None] * [1.0, 2.0, 3.0]

INPUTS = {
    "random": POINTS,
    "sphere": SPHERE,
    "single precision": POINTS.astype(np.float32),
    "grid": GRID,
    "grid in a plane": GRID * [1, 1, 0],
    "line": LINE,
    "duplicates": np.repeat(POINTS[:200], 4, axis=0)[RANDOM.permutation(800)],
    "one position": np.full((900, 3), 0.25),
    "signed zeros": np.where(GRID == 0, -0.0, GRID - 5),
    "two": POINTS[:2],
    "one": POINTS[:1],
}


@pytest.mark.parametrize("facets", ["triangles", "polygons"])
@pytest.mark.parametrize("kind", ["delaunay", "regular", "hull"])
@pytest.mark.parametrize("name", INPUTS)
def test_all_files_are_the_result_in_memory(tmp_path, name, kind, facets):
    points = INPUTS[name]
    weights = WEIGHTS[: len(points)] if kind == "regular" else None
    digests = set()
    for threads in (1, 2):
        folder = tmp_path / str(threads)
        streamed = tried(folder, kind, points, weights, facets=facets, threads=threads, block_points=150)
        assert len(streamed.files) > 4 or len(points) < 600
        digests.add(digest(folder))
    assert len(digests) == 1
    if name == "random":
        assert kind == "hull" or streamed.statistics["points_received"] > 0
        assert streamed.statistics["bytes_written"] > points.nbytes


@pytest.mark.parametrize("kind", ["delaunay", "regular", "hull"])
def test_pieces_and_blocks_of_any_size(tmp_path, kind):
    weights = WEIGHTS if kind == "regular" else None
    for number, (pieces, block) in enumerate([(1, None), (1, 100), (100, 1000), (4000, 3000), (7, 10_000)]):
        tried(tmp_path / str(number), kind, POINTS, weights, pieces=pieces, block_points=block, memory=2**20)


@pytest.mark.parametrize("columns", [2, 3])
@pytest.mark.parametrize("kind", ["delaunay", "regular"])
def test_coordinates_that_do_not_count_are_kept(tmp_path, kind, columns):
    points = POINTS[:, :columns].astype(np.float32)
    if columns == 3:
        points[::7, 2] = [np.nan] * len(points[::7])
    weights = WEIGHTS.astype(np.float32) if kind == "regular" else None
    tried(tmp_path, kind, points, weights, block_points=400)


@pytest.mark.parametrize("kind", ["delaunay", "regular", "hull"])
@pytest.mark.parametrize("dtype", ["i1", "u2", "i4", "i8", "f2", "?"])
def test_points_and_weights_keep_their_type(tmp_path, kind, dtype):
    points = RANDOM.integers(0, 100, (900, 3)).astype(dtype)
    points = np.unique(points, axis=0)[::-1]
    weights = points[:, 2].copy() if kind == "regular" else None
    tried(tmp_path, kind, points, weights, block_points=150)


WHOLE = GRID.astype(np.int64)[:900]
LATER = {
    "masked": np.ma.array(WHOLE),
    "rows masked": np.ma.array(WHOLE, mask=np.repeat(np.arange(900) % 9 == 4, 3)),
    "a list": WHOLE.tolist(),
    "objects": WHOLE.astype(object),
    "wider": WHOLE.astype(np.uint64),
    "narrower": WHOLE.astype(np.int8),
}


@pytest.mark.parametrize("kind", ["delaunay", "regular", "hull"])
@pytest.mark.parametrize("first", [np.int16, np.int64, np.float32, float])
@pytest.mark.parametrize("name", LATER)
def test_any_integers_that_the_first_type_holds(tmp_path, name, first, kind):
    later = LATER[name]
    points = [WHOLE.astype(first)[:, ::-1] + 20, later]
    pieces = [{"points": one, "weights": [0] * 900} if kind == "regular" else one for one in points]
    streamed = stream(pieces, tmp_path, kind=kind, block_points=400)
    blocks = blocks_of(streamed)
    assert {block["points"].dtype for block in blocks} == {np.dtype(first)}
    plain = np.ma.vstack([points[0], np.ma.array(WHOLE, mask=np.ma.getmaskarray(later))])
    left_out = int(np.ma.getmaskarray(plain)[:, 0].sum())
    for block in blocks:
        assert np.ma.is_masked(plain[block["ids"]]) is False and np.array_equal(block["points"], plain[block["ids"]])
    assert streamed[1:3] == (1800, left_out) and left_out == (100 if name == "rows masked" else 0)


@pytest.mark.parametrize("kind", ["delaunay", "regular", "hull"])
@pytest.mark.parametrize("pieces", [[], [[]], [[], np.empty((0, 3)), []]], ids=range(3))
def test_no_point(tmp_path, kind, pieces):
    streamed = stream(pieces, tmp_path, kind=kind)
    check(streamed, kind, np.empty((0, 3)))
    (block,) = blocks_of(streamed)
    assert streamed.dimension == -1 and block["simplices"].shape == (0, 0)
    assert ("weights" in block) == (kind == "regular")


def test_pieces_without_a_point(tmp_path):
    """They need no attributes; also where they come first, and in the form of points of another type."""
    pieces = [[], np.empty((0, 2), np.float32), {"points": POINTS, "n": np.arange(3000)}, {"points": []}, [],
              {"points": POINTS[::-1], "n": np.arange(3000)}]  # fmt: skip
    streamed = stream(pieces, tmp_path, block_points=500)
    check(streamed, "delaunay", joined([POINTS, POINTS[::-1]]), None, {"n": np.tile(np.arange(3000), 2)})


ATTRIBUTES = {
    "bytes": RANDOM.integers(0, 256, (3000, 3)).astype(np.uint8),
    "big-endian": RANDOM.random(3000).astype(">f4"),
    "flag": RANDOM.random(3000) < 0.5,
    "when": np.datetime64("2026-11-26T15:00", "s") + np.arange(3000),
    "text é": np.array([f"point {i}" for i in range(3000)]),
    "raw": np.array([b"%d" % i for i in range(3000)], "S5"),
    "wave": RANDOM.random((3000, 2, 3)) + 1j,
    "record": np.zeros(3000, np.dtype([("a", "i1"), ("b", "f8")], align=True)),
    "opaque": np.arange(3000, dtype="<u4").view("V4"),
    "nothing": np.empty((3000, 0)),
    "strided": np.arange(6000)[::2],
    "a/b": np.arange(3000, dtype=np.longdouble),
    "file": np.arange(3000, dtype=np.float16),
    "allow_pickle": np.arange(3000),
    "z": np.arange(3000),
}
ATTRIBUTES["record"]["a"] = np.arange(3000) % 99
ATTRIBUTES["record"]["b"] = RANDOM.random(3000)


@pytest.mark.parametrize("kind", ["delaunay", "regular", "hull"])
def test_attributes_of_every_type(tmp_path, kind):
    points = SPHERE[:2000] if kind == "hull" else POINTS[:2000]
    attributes = {name: values[:2000] for name, values in ATTRIBUTES.items()}
    weights = WEIGHTS[:2000] if kind == "regular" else None
    streamed = tried(tmp_path / "all", kind, points, weights, attributes, block_points=300)
    assert len(streamed.files) == 7
    for name in ("nothing", "flag"):
        tried(tmp_path / name, kind, points, weights, {name: attributes[name]}, block_points=300)


def test_what_a_piece_may_be(tmp_path):
    """Arrays of all types of numbers, mappings, and files; made when they are asked for, each once."""
    parts = np.split((POINTS * 1000).round(), 6)
    np.save(tmp_path / "a.npy", parts[3])
    np.savez_compressed(tmp_path / "b.NPZ.npz", points=parts[4])
    forms = [parts[0].tolist(), parts[1].astype(np.int64), {"points": parts[2].astype(">f8")}, str(tmp_path / "a.npy"),
             tmp_path / "b.NPZ.npz", np.asfortranarray(parts[5])]  # fmt: skip
    asked = []

    class Lazy:
        def __len__(self):
            return 6

        def __getitem__(self, number):
            asked.append(number)
            return forms[number]

    check(stream(Lazy(), tmp_path / "out", block_points=400), "delaunay", joined(parts))
    assert asked == list(range(6))


def test_las_files(tmp_path):
    for name, kind in (("a.las", 3), ("b.LAS", 3)):
        (tmp_path / name).write_bytes(las(kind))
    points, attributes = read_las(tmp_path / "a.las")
    streamed = stream([tmp_path / "a.las", str(tmp_path / "b.LAS"), read_las(tmp_path / "a.las")], tmp_path / "out")
    three = {name: np.concatenate([values] * 3) for name, values in attributes.items()}
    assert set(three) > {"colors", "gps_time", "classification"}
    check(streamed, "delaunay", np.concatenate([points] * 3), None, three)


@pytest.mark.parametrize("kind", ["delaunay", "regular", "hull"])
def test_what_is_not_finite(tmp_path, kind):
    points, weights = POINTS.copy(), WEIGHTS.copy()
    points[[5, 1700], 0] = np.inf, np.nan
    weights[2999] = np.nan

    def pieces(points, weights):
        parts = slice(0, 1000), slice(1000, 3000)
        return [{"points": points[part], **({"weights": weights[part]} if kind == "regular" else {})} for part in parts]

    given = pieces(points, weights)
    words = "a coordinate or weight is NaN or infinite: first at point"
    with pytest.raises(InputError, match=rf"^piece 0: {words} 5, 1 such point\(s\) in all$"):
        stream(given, tmp_path / "refused", kind=kind)
    with pytest.raises(InputError, match=f"^piece 1: {words} 700, {1 + (kind == 'regular')} such") as caught:
        stream([pieces(POINTS, WEIGHTS)[0], given[1]], tmp_path / "refused", kind=kind)
    assert (caught.value.code, caught.value.index) == ("non_finite", 700)
    streamed = stream(given, tmp_path / "ignored", kind=kind, non_finite="ignore", block_points=300)
    assert streamed.non_finite == (3 if kind == "regular" else 2)
    check(streamed, kind, points, weights if kind == "regular" else None)
    # What is masked is left out in any case.
    masked = pieces(np.ma.masked_invalid(points), np.ma.masked_invalid(weights))
    other = stream(masked, tmp_path / "masked", kind=kind, block_points=300)
    check(other, kind, points, weights if kind == "regular" else None)
    if kind == "regular":
        other = stream(pieces(POINTS, np.ma.masked_invalid(weights)), tmp_path / "weights", kind=kind)
        check(other, kind, POINTS, weights)


FIRST = {"points": POINTS[:10], "n": np.arange(10), "flag": np.zeros(10, bool)}
WRONG = {
    "no points": ({"n": np.arange(10)}, "there are no 'points' among 'n'"),
    "an attribute less": ({"points": POINTS[:5], "n": np.arange(5)},
                          "there is no attribute 'flag', which the first piece has"),
    "one more": (FIRST | {"m": np.arange(10)}, "there is an attribute 'm', which the first piece has not"),
    "another type": (FIRST | {"n": np.arange(10.0)},
                     "attribute 'n': the type is float64, and int64 in the first piece"),
    "another order of bytes": (FIRST | {"n": np.arange(10, dtype=">i8")}, "attribute 'n': the type is >i8, and int64"),
    "another shape": (FIRST | {"n": np.zeros((10, 2), int)},
                      r"attribute 'n': a point has the shape \(2,\), and \(\) in"),
    "too few values": (FIRST | {"n": np.arange(9)},
                       r"attribute 'n' has a value for each of 10 points, and not the shape \(9,\)"),
    "one value": (FIRST | {"n": 3}, r"attribute 'n' has a value for each of 10 points, and not the shape \(\)"),
    "objects": (FIRST | {"n": np.array([None] * 10)},
                "attribute 'n' has values of a fixed size, and not of type object"),
    "masked": (FIRST | {"n": np.ma.array(np.arange(10), mask=np.arange(10) == 4)},
               r"attribute 'n': entry \[4\] is masked"),
    "a name of the file's": (FIRST | {"ids": np.arange(10)},
                             "an attribute's name is text, and none of points, .*; it is 'ids'"),
    "a file's name": (FIRST | {"points.npy": np.arange(10)},
                      "an attribute's name .* has no .npy at its end; it is 'points.npy'"),
    "a name that ends": (FIRST | {"a\0b": np.arange(10)}, "an attribute's name is text, "),
    "half of a pair": (FIRST | {"\ud800": np.arange(10)}, "an attribute's name is text, "),
    "a number as a name": (FIRST | {3: np.arange(10)}, "an attribute's name is text, .*; it is 3"),
    "weights": (FIRST | {"weights": np.arange(10)},
                "there are 'weights', which kind='delaunay' does not know: take kind='regular'"),
    "too wide for integers": (FIRST | {"points": [[2**31, 0, 0]] * 10},
                              "points: the type is int64, and int32 in the first piece, which does not hold 2147"),
    "floats after integers": (FIRST | {"points": POINTS[:10]},
                              "points: the type is float64, and int64 in the first piece"),
    "other points": (FIRST | {"points": POINTS[:10].astype(np.float32)},
                     "points: the type is float32, and float64 in the first piece"),
    "two coordinates": (FIRST | {"points": POINTS[:10, :2]},
                        r"points: a point has the shape \(2,\), and \(3,\) in the first piece"),
    "not of this shape": (FIRST | {"points": POINTS[0]},
                          "points are an array of n by 3 or n by 2 coordinates, not of shape"),
    "text": (FIRST | {"points": "text"}, "coordinates are an array or a list of numbers, not of type str"),
    "a number": (7, "coordinates are an array or a list of numbers, not of type int"),
    "inexact": ([[2**53 + 1, 0, 0.5]], "a coordinate is no number that a double holds, .*: first at point 0"),
}


@pytest.mark.parametrize("name", WRONG)
def test_a_piece_at_fault_is_named(tmp_path, name):
    piece, words = WRONG[name]
    with pytest.raises((InputError, TypeError, ValueError), match=f"^piece 2: {words}"):
        whole = np.arange(30, dtype=np.int32 if "wide" in name else np.int64).reshape(10, 3)
        first = FIRST | {"points": whole} if "integers" in name else FIRST
        stream([first, first, piece], tmp_path)
    assert not list(tmp_path.glob("*.npz"))


@pytest.mark.parametrize("kind, piece, words", [
    ("regular", POINTS,
     "piece 0: there are no 'weights', which kind='regular' needs; without them, take kind='delaunay'"),
    ("regular", {"points": POINTS, "weights": WEIGHTS[1:]},
     "piece 0: there are not as many weights as points: 3000 points, 2999"),
    ("regular", {"points": POINTS, "weights": POINTS}, "piece 0: weights are n numbers, one for each point"),
    ("hull", POINTS[:, :2], "piece 0: a hull of pieces is of points of three coordinates, not of two"),
])  # fmt: skip
def test_a_first_piece_at_fault_leaves_no_folder(tmp_path, kind, piece, words):
    with pytest.raises(ValueError, match=f"^{words}"):
        stream([piece], tmp_path / "out", kind=kind)
    assert not (tmp_path / "out").exists()


def test_files_at_fault(tmp_path):
    np.save(tmp_path / "objects.npy", np.array([None]), allow_pickle=True)
    (tmp_path / "no.npz").write_bytes(b"no zip")
    (tmp_path / "no.las").write_bytes(b"no LAS")
    for name, kind, words in (
        ("absent.npy", FileNotFoundError, "absent.npy"),
        ("absent.las", FileNotFoundError, "absent.las"),
        ("objects.npy", ValueError, "allow_pickle"),
        ("no.npz", ValueError, "pickled|zip"),
        ("no.las", InputError, "is no LAS file"),
        ("points.txt", InputError, "a file of points is .npy, .npz or .las, not .*points.txt"),
    ):
        with pytest.raises(kind, match=words) as caught:
            stream([POINTS, tmp_path / name], tmp_path / "out")
        assert caught.value.__notes__ == [f"This is of piece 1 of 2, {tmp_path / name}."]


@pytest.mark.parametrize("keywords, error, words", [
    ({"kind": "terrain"}, ValueError, "^kind is one of 'delaunay', 'regular', 'hull', not 'terrain'$"),
    ({"kind": None}, TypeError, "^kind is one of 'delaunay', 'regular', 'hull', not None$"),
    ({"memory": 1000}, ValueError, "^memory is 1048576 or more, not 1000$"),
    ({"memory": 1e9}, TypeError, "^memory is an integer, not 1000000000.0$"),
    ({"block_points": 0}, ValueError, "^block_points is 1 or more, not 0$"),
    ({"block_points": 2**63}, ValueError, "^block_points is 1 or more, not"),
    ({"facets": "squares"}, ValueError, "^facets is one of 'triangles', 'polygons', not 'squares'$"),
    ({"non_finite": "drop"}, ValueError, "^non_finite is one of 'error', 'ignore', not 'drop'$"),
    ({"threads": -1}, ValueError, "^threads is 0 .all. or more, not -1$"),
    ({"progress": 3}, TypeError, "^progress is a callable, True or None, not 3$"),
    ({"engine": "cuda"}, TypeError, "unexpected keyword argument 'engine'"),
])  # fmt: skip
def test_arguments(tmp_path, keywords, error, words):
    with pytest.raises(error, match=words):
        stream([POINTS], tmp_path / "out", **keywords)
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("pieces", ["tiles", b"tiles", {0: POINTS}, iter([POINTS]), 3, None], ids=range(6))
def test_what_is_no_sequence(tmp_path, pieces):
    with pytest.raises(TypeError,
                       match="^pieces are a sequence, or an object with __len__ and __getitem__, not of type"):
        stream(pieces, tmp_path)
