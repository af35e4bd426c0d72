# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""stream() is stopped, in every way and at many moments: what it says, and that the same call then goes on to the same
bits, with nothing left beside them.
"""

import errno
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

import vtkflipflop._stream as streams_module
from streams import digest
from vtkflipflop.arrays import AbortedError, InputError, stream

SEED = 11
COUNT, EACH = 12, 2500
CHOICES = {"kind": "regular", "block_points": 1500, "memory": 2**20, "threads": 2}


class Tiles:
    """Pieces that are made when they are asked for; at a number, act() comes first."""

    def __init__(self, at=None, act=None):
        self.at, self.act, self.asked = at, act, []

    def __len__(self):
        return COUNT

    def __getitem__(self, number):
        self.asked.append(number)
        if number == self.at:
            self.act()
        random = np.random.default_rng(SEED + number)
        points = random.random((EACH, 3)) + [number % 4, number // 4, 0]
        return {"points": points, "weights": random.random(EACH) * 1e-4, "tile": np.full(EACH, number, np.uint8)}


class Stop(Exception):
    pass


def fail():
    raise Stop("no such tile")


@pytest.fixture(scope="module")
def expected(tmp_path_factory):
    folder = tmp_path_factory.mktemp("whole")
    streamed = stream(Tiles(), folder, **CHOICES)
    assert len(streamed.files) == 20 and streamed.hidden > 0 and streamed.points == COUNT * EACH
    return digest(folder)


def goes_on(folder, expected, **other):
    streamed = stream(Tiles(), folder, **(CHOICES | other))
    assert sorted(folder.iterdir()) == list(streamed.files)
    assert digest(folder) == expected


def ends(folder, expected):
    """The same call goes on, unless the run has ended: all files are there, and an empty folder of work at most."""
    if (folder / "work" / "form.npz").exists() or not (folder / "block-00019.npz").exists():
        goes_on(folder, expected)
    elif (folder / "work").exists():
        (folder / "work").rmdir()
    assert digest(folder) == expected


def check_whole(folder):
    """No file is half there."""
    for path in folder.glob("*.npz"):
        with np.load(path) as file:
            assert file["simplices"].max() < len(file["ids"]) == len(file["points"])


@pytest.mark.parametrize("at", [0, 1, 7, COUNT - 1])
def test_a_piece_that_raises(tmp_path, expected, at):
    with pytest.raises(Stop) as caught:
        stream(Tiles(at, fail), tmp_path, **CHOICES)
    assert caught.value.__notes__ == [f"This is of piece {at} of {COUNT}."]
    assert (tmp_path / "work").exists() == (at > 0)
    goes_on(tmp_path, expected)


def test_pieces_are_not_read_again(tmp_path, expected):
    """Once they are stored; and with other memory, threads and reports."""
    with pytest.raises(AbortedError):
        stream(Tiles(), tmp_path, progress=lambda fraction: fraction < 0.3, **CHOICES)
    tiles = Tiles(0, fail)
    streamed = stream(tiles, tmp_path, **(CHOICES | {"threads": 1, "memory": 2**24, "progress": print}))
    assert tiles.asked == [] and len(streamed.files) == 20
    assert digest(tmp_path) == expected


def test_a_piece_that_is_mended(tmp_path, expected):
    class Spoilt(Tiles):
        def __getitem__(self, number):
            piece = super().__getitem__(number)
            piece["points"][2000, 1] = np.nan if number == 9 else piece["points"][2000, 1]
            return piece

    with pytest.raises(InputError, match="^piece 9: .* NaN or infinite: first at point 2000, 1 such"):
        stream(Spoilt(), tmp_path, **CHOICES)
    goes_on(tmp_path, expected)


def test_stopped_at_many_fractions(tmp_path, expected, monkeypatch):
    """By False, by an exception of the callable's, by Ctrl-C; and several times in one run."""

    def slow(function):
        def called(*arguments):
            time.sleep(0.022)  # reports are 20 ms apart
            return function(*arguments)

        return called

    monkeypatch.setattr(Tiles, "__getitem__", slow(Tiles.__getitem__))
    monkeypatch.setattr(streams_module, "write_arrays", slow(streams_module.write_arrays))
    fractions = []
    stream(Tiles(), tmp_path / "watched", progress=fractions.append, **CHOICES)
    assert fractions == sorted(fractions) and 0 <= fractions[0] and fractions[-1] <= 1
    moments = sorted(set(fractions))
    assert len(moments) > 15
    moments = moments[:: len(moments) // 8]
    stopped = 0
    for number, moment in enumerate(moments):
        kind = (AbortedError, Stop, KeyboardInterrupt)[number % 3]

        def report(fraction, kind=kind, moment=moment):
            if fraction >= moment:
                if kind is AbortedError:
                    return False
                raise kind
            return True

        folder = tmp_path / str(number)
        try:
            stream(Tiles(), folder, progress=report, **CHOICES)
        except kind:
            stopped += 1
            check_whole(folder)
            goes_on(folder, expected)
        else:  # nothing was reported late enough
            assert digest(folder) == expected
    assert stopped > 6
    for moment in [*moments, 1.0]:
        try:
            stream(Tiles(), tmp_path / "often", progress=lambda fraction, moment=moment: fraction <= moment, **CHOICES)
            break
        except AbortedError:
            check_whole(tmp_path / "often")
    assert digest(tmp_path / "often") == expected


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="this system has no timer to interrupt by")
def test_interrupts_at_any_moment(tmp_path, expected):
    """As Ctrl-C does: between two lines of Python on the calling thread, whatever the others do."""

    def interrupt(*_):
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, interrupt)
    interrupted = 0
    try:
        for number, after in enumerate(np.random.default_rng(SEED).uniform(0.01, 0.4, 20)):
            print("seed", SEED, "seconds", after)
            folder = tmp_path / str(number)
            try:
                signal.setitimer(signal.ITIMER_REAL, after)
                stream(Tiles(), folder, **CHOICES)
                signal.setitimer(signal.ITIMER_REAL, 0)
            except KeyboardInterrupt:
                interrupted += 1
            check_whole(folder)
            ends(folder, expected)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert interrupted > 5


@pytest.mark.parametrize("kind", [OSError, MemoryError, KeyboardInterrupt])
@pytest.mark.parametrize("at", [0, 1, 8, 20])
@pytest.mark.parametrize("what", ["arrays", "name"])
def test_a_file_that_cannot_be_written(tmp_path, expected, monkeypatch, kind, at, what):
    """In its midst, or as it gets its name. The first file is the form's."""
    writes = []
    write, replace = streams_module.write_arrays, os.replace
    error = kind(errno.ENOSPC, os.strerror(errno.ENOSPC))

    def write_part(path, arrays):
        writes.append(path)
        if len(writes) > at:
            path.write_bytes(b"half")
            raise error
        write(path, arrays)

    def rename(part, path):
        writes.append(path)
        if len(writes) > at:
            raise error
        replace(part, path)

    with monkeypatch.context() as patch:
        if what == "arrays":
            patch.setattr(streams_module, "write_arrays", write_part)
        else:
            patch.setattr(os, "replace", rename)
        with pytest.raises(kind) as caught:
            stream(Tiles(), tmp_path, **CHOICES)
    assert caught.value is error and len(writes) == at + 1
    if kind is OSError:
        assert caught.value.errno == errno.ENOSPC and Path(caught.value.filename).suffix == ".npz"
    assert not list(tmp_path.rglob("*.part")) and len(list(tmp_path.glob("*"))) == max(1, at)
    check_whole(tmp_path)
    goes_on(tmp_path, expected)


def test_a_limit_of_file_sizes(tmp_path, expected):
    """As on a full disk: the engine's own files, too, give an OSError that names one."""
    resource = pytest.importorskip("resource")
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    named = set()
    for number, limit in enumerate((100, 3000, 150_000)):
        folder = tmp_path / str(number)
        resource.setrlimit(resource.RLIMIT_FSIZE, (limit, hard))
        try:
            with pytest.raises(OSError) as caught:
                stream(Tiles(), folder, **CHOICES)
        finally:
            resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
        assert caught.value.errno == errno.EFBIG and str(folder) in caught.value.filename
        named.add(Path(caught.value.filename).name.split("-")[0])
        assert not list(tmp_path.rglob("*.npz.part"))
        goes_on(folder, expected)
    assert named == {"form.npz", "input"}


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="nothing is forbidden here")
def test_a_folder_that_is_forbidden(tmp_path):
    tmp_path.chmod(0o500)
    with pytest.raises(PermissionError, match="work"):
        stream(Tiles(), tmp_path, **CHOICES)
    tmp_path.chmod(0o700)


def test_a_folder_that_is_a_file(tmp_path, expected):
    """Also where the engine meets it."""
    (tmp_path / "out").write_bytes(b"")
    with pytest.raises(OSError) as caught:
        stream(Tiles(), tmp_path / "out", **CHOICES)
    assert str(tmp_path / "out") in caught.value.filename
    with pytest.raises(AbortedError):
        stream(Tiles(), tmp_path / "other", progress=lambda fraction: fraction < 0.3, **CHOICES)
    work = tmp_path / "other" / "work"
    (work / "counts.flipflop").rename(work / "kept")
    (work / "counts.flipflop").mkdir()
    with pytest.raises(OSError) as caught:
        stream(Tiles(), tmp_path / "other", **CHOICES)
    assert type(caught.value) is not OSError or caught.value.errno
    (work / "counts.flipflop").rmdir()
    (work / "kept").rename(work / "counts.flipflop")
    goes_on(tmp_path / "other", expected)


def test_a_file_of_work_that_is_damaged(tmp_path, expected, monkeypatch):
    with pytest.raises(AbortedError):
        stream(Tiles(), tmp_path, progress=lambda fraction: fraction < 0.3, **CHOICES)
    with monkeypatch.context() as context, pytest.raises(MemoryError):  # which is no damage
        context.setattr(np.lib.format, "read_array", lambda *_, **__: (_ for _ in ()).throw(MemoryError))
        stream(Tiles(), tmp_path, **CHOICES)
    for name in ("form.npz", "run.flipflop"):  # in the order in which they are read
        damaged = tmp_path / "work" / name
        whole = damaged.read_bytes()
        for harmed in (b"", b"damaged", whole[:-9], whole[:30]):
            damaged.write_bytes(harmed)
            with pytest.raises(OSError, match="if it is damaged or missing, remove its folder") as caught:
                stream(Tiles(), tmp_path, **CHOICES)
            assert caught.value.errno == errno.EIO and caught.value.filename == str(damaged)
        damaged.write_bytes(whole if name == "form.npz" else harmed)
    for path in [*(tmp_path / "work").iterdir(), tmp_path / "work", *tmp_path.glob("*.npz")]:
        path.rmdir() if path.is_dir() else path.unlink()
    goes_on(tmp_path, expected)


def test_a_folder_that_is_taken(tmp_path, expected):
    stream(Tiles(), tmp_path, **CHOICES)
    words = "this is there already, of no run to go on with: take it away, or choose another folder"
    with pytest.raises(FileExistsError, match=f"{words}.*block-00000.npz"):
        stream(Tiles(), tmp_path, **CHOICES)
    assert digest(tmp_path) == expected
    (tmp_path / "own" / "work").mkdir(parents=True)
    (tmp_path / "own" / "work" / "letter.txt").write_bytes(b"")
    with pytest.raises(FileExistsError, match=f"{words}.*letter.txt"):
        stream(Tiles(), tmp_path / "own", **CHOICES)
    other = tmp_path / "other"
    with pytest.raises(Stop):
        stream(Tiles(5, fail), other, **CHOICES)
    for choice, value in (("kind", "delaunay"), ("facets", "polygons"), ("non_finite", "ignore")):
        with pytest.raises(InputError, match=f"has a run that has not ended, of other arguments: .*{choice}.*, not "):
            stream(Tiles(), other, **(CHOICES | {choice: value}))
    with pytest.raises(InputError, match="of other arguments"):
        stream([Tiles()[0]], other, **CHOICES)
    goes_on(other, expected)


def test_another_attribute_when_it_goes_on(tmp_path, expected):
    with pytest.raises(Stop):
        stream(Tiles(5, fail), tmp_path, **CHOICES)

    class Others(Tiles):
        def __getitem__(self, number):
            return super().__getitem__(number) | {"tile": np.zeros(EACH)}

    with pytest.raises(InputError, match="attribute 'tile': the type is float64, and uint8 in the first piece"):
        stream(Others(), tmp_path, **CHOICES)
    goes_on(tmp_path, expected)


def test_blocks_of_a_run_that_began_again(tmp_path, expected):
    """The end came after the files of work had gone, and before the form had: fewer blocks replace the others."""
    stream(Tiles(), tmp_path, **(CHOICES | {"block_points": 500}))
    assert len(list(tmp_path.iterdir())) == 60
    with pytest.raises(Stop):
        stream(Tiles(1, fail), tmp_path / "form", **CHOICES)
    (tmp_path / "work").mkdir()
    (tmp_path / "form" / "work" / "form.npz").rename(tmp_path / "work" / "form.npz")
    (tmp_path / "work" / "npz.part").write_bytes(b"half")
    for path in sorted((tmp_path / "form").rglob("*"), reverse=True) + [tmp_path / "form"]:
        path.rmdir() if path.is_dir() else path.unlink()
    goes_on(tmp_path, expected)


def test_a_folder_of_work_that_remains(tmp_path, expected, monkeypatch):
    """Something of others' is in it, or the process ends just before it goes: the run has ended all the same."""

    def stop(*_):
        raise Stop

    foreign = tmp_path / "foreign"
    streamed = stream(Tiles(5, (foreign / "work" / ".DS_Store").touch), foreign, **CHOICES)
    assert sorted(foreign.iterdir()) == [*streamed.files, foreign / "work"]
    assert [one.name for one in (foreign / "work").iterdir()] == [".DS_Store"]
    ended = tmp_path / "ended"
    with monkeypatch.context() as patch:
        patch.setattr(Path, "rmdir", stop)
        with pytest.raises(Stop):
            stream(Tiles(), ended, **CHOICES)
    for folder in (foreign, ended):
        with pytest.raises(FileExistsError, match="of no run to go on with: .*block-00000.npz"):
            stream(Tiles(), folder, **CHOICES)
        (folder / "work" / ".DS_Store").unlink(missing_ok=True)
        ends(folder, expected)
    (ended / "work").mkdir()
    for path in ended.glob("*.npz"):
        path.unlink()
    goes_on(ended, expected)


# Ended ------------------------------------------------------------------------------------------------------------


def end_at(way, at, folder):
    """Streams, and ends this process there."""

    def end():
        os.kill(os.getpid(), signal.SIGKILL)

    write = streams_module.write_arrays
    if way == "write":
        written = []

        def write_part(path, arrays):
            write(path, arrays)
            written.append(path)
            if len(written) > at:
                os.truncate(path, 1000)
                end()

        streams_module.write_arrays = write_part
    watch = (lambda fraction: fraction < at or end()) if way == "fraction" else None
    print("begun", flush=True)
    stream(Tiles(at, end) if way == "piece" else Tiles(), folder, progress=watch, **CHOICES)


@pytest.mark.skipif(not hasattr(signal, "SIGKILL"), reason="this system ends processes otherwise")
def test_a_process_that_is_killed(tmp_path, expected):
    """At pieces, at fractions, at writes, and at moments of the clock; and again and again."""
    random = np.random.default_rng(SEED)
    program = f"import sys; sys.path.insert(0, {str(Path(__file__).parent)!r}); import TestStreamStops as t; "

    def killed(way, at, folder, after=None):
        command = [sys.executable, "-c", program + f"t.end_at({way!r}, {at!r}, {str(folder)!r})"]
        process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        assert process.stdout.readline() == "begun\n"
        if after is not None:
            time.sleep(after)
            process.kill()
        process.stdout.close()
        return process.wait() == -signal.SIGKILL

    ways = [("piece", 6), ("fraction", 0.25), ("fraction", 0.5), ("fraction", 0.7), ("fraction", 0.86), ("write", 1),
            ("write", 9)]
    for number, (way, at) in enumerate(ways):
        folder = tmp_path / str(number)
        if killed(way, at, folder):
            check_whole(folder)
            goes_on(folder, expected)
        else:  # nothing was reported late enough
            assert way == "fraction" and at > 0.5 and digest(folder) == expected
    often = tmp_path / "often"
    moments = random.uniform(0, 0.1, 12)
    print("seed", SEED, "seconds", moments)
    ended = sum(killed("clock", 0, often, moment) for moment in moments if not list(often.glob("block-00019.npz")))
    assert ended > 3
    ends(often, expected)
