# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Beside other threads, with progress, and stopped."""

import signal
import sys
import threading
from types import SimpleNamespace

import numpy as np
import pytest

from vtkflipflop.arrays import AbortedError, convex_hull, convex_hulls, power_diagram, regular_triangulation

# All extreme, so a run takes a second.
SPHERE = np.random.default_rng(6).standard_normal((700_000, 3))
SPHERE /= np.linalg.norm(SPHERE, axis=1)[:, None]

CALLS = {
    "hull": lambda **keywords: convex_hull(SPHERE, **keywords),
    "triangulation": lambda **keywords: regular_triangulation(SPHERE, **keywords),
    "diagram": lambda **keywords: power_diagram(SPHERE, **keywords),
    "batch": lambda **keywords: convex_hulls(SPHERE, np.arange(0, 700_001, 1000), **keywords),
}


class Stop(Exception):
    pass


def test_other_threads_go_on():
    run = threading.Thread(target=CALLS["hull"], kwargs={"threads": 1})
    run.start()
    steps = 0
    while run.is_alive():
        steps += 1
    # With the interpreter held there would be a handful.
    assert steps > 10_000


@pytest.mark.parametrize("call", CALLS)
def test_progress_grows(call):
    fractions = []
    CALLS[call](progress=fractions.append)
    assert len(fractions) > 2
    assert 0 <= min(fractions) and max(fractions) <= 1
    if call != "diagram":  # which has two runs
        assert fractions == sorted(fractions)


@pytest.mark.parametrize("call", CALLS)
@pytest.mark.parametrize("false", [False, np.False_])
def test_progress_stops_the_run(call, false):
    with pytest.raises(AbortedError) as caught:
        CALLS[call](progress=lambda fraction: false)
    assert caught.value.code == "aborted"


@pytest.mark.parametrize("other", [None, 0, "", True, np.True_])
def test_what_else_progress_returns_stops_nothing(other):
    assert convex_hull(SPHERE[:300_000], progress=lambda fraction: other).dimension == 3


@pytest.mark.parametrize("call", CALLS)
def test_what_progress_raises_is_raised(call):
    def fail(fraction):
        raise Stop(fraction)

    with pytest.raises(Stop):
        CALLS[call](progress=fail)


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="this system has no timer to interrupt by")
@pytest.mark.parametrize("call", CALLS)
def test_an_interrupt_stops_the_run(call):
    """As Ctrl-C does: the handler's exception is that of the call."""

    def interrupt(*_):
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, interrupt)
    try:
        with pytest.raises(KeyboardInterrupt):
            signal.setitimer(signal.ITIMER_REAL, 0.03)
            CALLS[call](threads=1)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def test_a_bar(monkeypatch):
    """progress=True is tqdm's; a stand-in, so that the test needs none."""
    shown = []

    class Bar:
        n = 0

        def __init__(self, **_):
            shown.append("made")

        def update(self, step):
            self.n += step
            shown.append(self.n)

        def close(self):
            shown.append("closed")

    monkeypatch.setitem(sys.modules, "tqdm", SimpleNamespace())
    monkeypatch.setitem(sys.modules, "tqdm.auto", SimpleNamespace(tqdm=Bar))
    CALLS["hull"](progress=True)
    assert shown[0] == "made" and shown[-2:] == [100, "closed"] and len(shown) > 4


def test_no_bar(monkeypatch):
    monkeypatch.setitem(sys.modules, "tqdm", None)
    monkeypatch.setitem(sys.modules, "tqdm.auto", None)
    with pytest.raises(ModuleNotFoundError, match="progress=True shows tqdm's bar: pip install tqdm, or"):
        CALLS["hull"](progress=True)


def together(work):
    """What work() returns on eight threads that begin at once."""
    found = [None] * 8
    barrier = threading.Barrier(len(found))

    def run(i):
        barrier.wait()
        found[i] = work()

    threads = [threading.Thread(target=run, args=(i,)) for i in range(len(found))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    return found


@pytest.mark.parametrize("make", [convex_hull, lambda points: regular_triangulation(points[:, :2])])
def test_threads_share_a_result(make):
    """What is made when it is first asked for, on several threads at once: free-threaded Python holds no lock."""
    points = SPHERE[:2000]

    def everything(result):
        if hasattr(result, "contains"):
            answers = result.side(points), result.distance(points * 0.9), result.equations, result.neighbors
        else:
            answers = result.locate(points[:, :2] * 0.9), result.nearest(points[:, :2]), result.areas, result.alphas
        return [np.asarray(answer) for answer in answers]

    expected = everything(make(points))
    for _ in range(10):
        shared = make(points)
        for found in together(lambda shared=shared: everything(shared)):
            assert all(np.array_equal(one, other) for one, other in zip(found, expected, strict=True))
