# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Recorded runs whose work, span and time on so many workers are known by hand."""

import contextlib
import io
import json
import os
import runpy
import sys
import tempfile
import unittest
from unittest import mock

from task_graph import (
    Fork,
    Task,
    load,
    longest_path,
    parse,
    place_name,
    play,
    sort_task,
    span,
    tasks_below,
    work,
)

CHAIN = Task([5])
# 2, ten tasks of 3, 4
EQUAL = Task([2, 4], [Fork("loop", [Task([3]) for _ in range(10)])])
# 1, then beside each other: (2, [3 | 4], 5) and 6; then 7
NESTED = Task(
    [1, 7],
    [Fork("outer", [Task([2, 5], [Fork("inner", [Task([3]), Task([4])])]), Task([6])])],
)


def time(run, workers, cost=0):
    return play(run, workers, cost)[0]


class TestPlay(unittest.TestCase):
    def test_a_chain(self):
        self.assertEqual((work(CHAIN), span(CHAIN), tasks_below(CHAIN)), (5, 5, 0))
        for workers in (1, 2, 64):
            self.assertEqual(play(CHAIN, workers, 100)[0], 5)

    def test_equal_tasks(self):
        self.assertEqual((work(EQUAL), span(EQUAL), tasks_below(EQUAL)), (36, 9, 10))
        # 6 and as many rounds of 3 as there are tens by workers, rounded up
        for workers, expected in ((1, 36), (2, 21), (3, 18), (4, 15), (5, 12), (10, 9), (64, 9)):
            self.assertEqual(time(EQUAL, workers), expected)

    def test_nested_forks(self):
        self.assertEqual((work(NESTED), span(NESTED), tasks_below(NESTED)), (28, 19, 4))
        self.assertEqual(time(NESTED, 1), 28)
        # One has 1, 2, 3, and at 6 goes on with 4: the other has 6 until 7. Then 5, 7.
        self.assertEqual(time(NESTED, 2), 1 + 2 + 3 + 4 + 5 + 7)
        # With three: 1, 2, 4, 5, 7.
        self.assertEqual(time(NESTED, 3), 19)
        self.assertEqual(time(NESTED, 64), 19)

    def test_a_task_costs(self):
        self.assertEqual(time(EQUAL, 1, 1), 46)
        self.assertEqual(time(EQUAL, 10, 1), 10)
        # Along 1, [1] 2, [1] 4, 5, 7.
        self.assertEqual(time(NESTED, 3, 1), 21)

    def test_no_worker_rests_while_a_task_waits(self):
        uneven = Task([0, 0], [Fork("loop", [Task([t]) for t in (9, 1, 1, 1, 1, 1, 1, 1, 1, 1)])])
        self.assertEqual(time(uneven, 2), 9)

    def test_idle_time_is_what_is_missing(self):
        for run in (CHAIN, EQUAL, NESTED):
            for workers in (1, 2, 3, 16):
                for cost in (0, 2):
                    seconds, idle_for = play(run, workers, cost)
                    busy = work(run) + cost * tasks_below(run)
                    self.assertAlmostEqual(seconds, busy / workers + sum(idle_for.values()))

    def test_idle_time_belongs_to_what_runs(self):
        idle_for = play(EQUAL, 4, 0)[1]
        self.assertAlmostEqual(idle_for["run: begin .. loop"], 2 * 3 / 4)
        self.assertAlmostEqual(idle_for["run: loop .. end"], 4 * 3 / 4)
        self.assertAlmostEqual(idle_for["loop"], 3 * 2 / 4)  # ten tasks: two rest in the last round

    def test_the_longest_path(self):
        self.assertEqual(
            longest_path(NESTED),
            [
                ("run: begin .. outer", 1),
                ("outer: begin .. inner", 2),
                ("inner", 4),
                ("outer: inner .. end", 5),
                ("run: outer .. end", 7),
            ],
        )


class TestSort(unittest.TestCase):
    def test_few_elements_are_no_tasks(self):
        self.assertEqual(sort_task(100, 500, "sort"), Task([100]))

    def test_work_is_kept(self):
        task = sort_task(1e6, 1 << 20, "sort")
        self.assertAlmostEqual(work(task), 1e6, places=3)

    def test_span(self):
        # Of 20 rounds the first is one thread's, the next two threads', ...: 1/20 (1 + 1/2 + ...),
        # down to parts of 256 elements, which take 8 of the rounds.
        expected = 1e6 / 20 * (sum(0.5**i for i in range(12)) + 8 * 0.5**12)
        self.assertAlmostEqual(span(sort_task(1e6, 1 << 20, "sort")), expected, places=3)


def place(kind, line, body="", function="each"):
    return {"kind": kind, "file": "../A.h", "line": line, "function": function, "body": body}


# 1, a loop of two tasks (2; 3, [4 | 5], 6), 7, a sort of few elements, 9
DATA = {
    "what": "hull cube",
    "threads": 4,
    "places": [place("for", 1), place("invoke", 2), place("sort", 3)],
    "run": [
        1,
        {
            "place": 0,
            "calls": 100,
            "tasks": [2, [3, {"place": 1, "calls": 2, "tasks": [4, 5]}, 6]],
        },
        7,
        {"place": 2, "calls": 10, "tasks": [8]},
        9,
    ],
}


def files(*records):
    folder = tempfile.TemporaryDirectory()
    paths = []
    for number, data in enumerate(records):
        paths.append(os.path.join(folder.name, f"{number}.json"))
        with open(paths[-1], "w", encoding="utf-8") as file:
            json.dump(data, file)
    return folder, paths


class TestRecords(unittest.TestCase):
    def test_a_record(self):
        record = parse(DATA)
        self.assertEqual((record.what, record.threads), ("hull cube", 4))
        inner = Task([3, 6], [Fork("A.h:2 each", [Task([4]), Task([5])])])
        loop = Fork("A.h:1 each", [Task([2]), inner])
        self.assertEqual(
            record.run, Task([1, 7, 9], [loop, Fork("A.h:3 each", [Task([8])])])
        )

    def test_the_least_times_of_several(self):
        other = json.loads(json.dumps(DATA).replace("[4, 5]", "[3, 50]").replace("8", "1"))
        folder, paths = files(DATA, other)
        with folder:
            run = load(paths).run
        self.assertEqual(work(run), work(parse(DATA).run) - 1 - 7)

    def test_different_runs_are_no_one_run(self):
        for other in (
            {**DATA, "what": "hull ball"},
            {**DATA, "threads": 5},
            {**DATA, "run": 5},
            json.loads(json.dumps(DATA).replace("[4, 5]", "[4, 5, 6]")),
        ):
            folder, paths = files(DATA, other)
            with folder, self.assertRaises(ValueError):
                load(paths)

    def test_names(self):
        scan = "flipflop::scan(flipflop::PointSource const&, int)::{lambda(unsigned int)#1}"
        self.assertEqual(place_name(place("for", 7, scan, "scan")), "A.h:7 scan")
        run = "flipflop::Level<int>::run(int, std::vector<int>&)::{lambda(long)#2}"
        each = f"flipflop::Level<int>::each<{run}>({run}&&) const::{{lambda(int)#1}}"
        self.assertEqual(place_name(place("for", 7, each, "each<X>")), "A.h:7 each of run#2")
        cut = f"flipflop::Level<int>::cut<{run}, int>({run} const&) const::{{lambda(long)#3}}"
        each = f"flipflop::Level<int>::each<{cut}>({cut}&&)::{{lambda(int)#1}}"
        self.assertEqual(
            place_name(place("for", 7, each, "each<X>")), "A.h:7 each of cut#3 of run#2"
        )

    def test_names_without_what_passes_bodies_on(self):
        scan = "flipflop::scan(flipflop::Points const&)::{lambda(long)#1}"
        self.assertEqual(place_name(place("for", 7, scan, "eachTask<X>")), "scan#1")
        run = "flipflop::(anonymous namespace)::Sorter::sort(int*) const::{lambda(long, long)#2}"
        inner = f"flipflop::(anonymous namespace)::eachRun<{run}>(long, {run}&&)::{{lambda(long)#1}}"
        outer = f"flipflop::eachRun<{inner}>(long, {inner} const&)::{{lambda(long)#1}}"
        self.assertEqual(place_name(place("for", 7, outer, "eachTask<X>")), "sort#2")
        mangled = "ZN8flipflop7eachRunIZNS_11numberFoundIZNS_14insertionOrderERKNS_11PointSourceE"
        self.assertEqual(
            place_name(place("for", 7, mangled, "eachTask<X>")), "numberFound of insertionOrder"
        )

    def test_places_of_one_name_are_told_apart(self):
        twice = {**DATA, "places": [place("for", 1), place("invoke", 1), place("sort", 3)]}
        run = parse(twice).run
        self.assertEqual(run.forks[0].place, "A.h:1 each")
        self.assertEqual(run.forks[0].tasks[1].forks[0].place, "A.h:1 each (2)")


def printed(*arguments):
    """The program's lines, as words."""
    output = io.StringIO()
    with contextlib.redirect_stdout(output):
        with mock.patch.object(sys, "argv", ["play-tasks.py", *arguments]):
            runpy.run_path(os.environ["FLIPFLOP_PLAY_TASKS"], run_name="__main__")
    return [line.split() for line in output.getvalue().splitlines()]


class TestProgram(unittest.TestCase):
    TASKS = {"place": 0, "calls": 2, "tasks": [2e6, 2e6]}

    def test_what_it_prints(self):
        folder, paths = files({**DATA, "run": [1e6, self.TASKS, 3e6]})
        with folder:
            lines = printed("--cost", "500", *paths)
        self.assertEqual(lines[0], "hull cube, cut for 4 threads".split())
        self.assertEqual(lines[1], "work 8.000 ms, span 6.000 ms: 1.3 times; 2 tasks".split())
        self.assertIn(["1", "9.000", "0.89"], lines)
        self.assertIn(["2", "6.500", "1.23"], lines)
        self.assertIn("3.000 50.0% 1 3.000 run: A.h:1 each .. end".split(), lines)
        # Three of four rest for 3 ms, of 6.5.
        self.assertIn("2.250 34.6% run: A.h:1 each .. end".split(), lines)

    def test_over_a_run_alone(self):
        folder, (many, alone) = files(
            {**DATA, "run": [1e6, self.TASKS, 3e6]}, {**DATA, "threads": 1, "run": 3e6}
        )
        with folder:
            lines = printed("--cost", "0", "--threads", "2", "--alone", alone, many)
        self.assertIn(["2", "6.000", "0.50"], lines)


if __name__ == "__main__":
    unittest.main()
