# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""A recorded run as a tree of tasks: its work, its span, and its time on so many workers."""
import heapq
import itertools
import json
import math
import os
import re
from collections import Counter, deque
from dataclasses import dataclass, field

SORTED_AT_ONCE = 500  # elements: fewer are no tasks of oneTBB's parallel_sort


@dataclass
class Fork:
    """Tasks that may run at the same time; what follows waits for all of them."""

    place: str
    tasks: list


@dataclass
class Task:
    """A stretch of nanoseconds, a fork, a stretch, ..., a stretch."""

    stretches: list
    forks: list = field(default_factory=list)


@dataclass
class Record:
    what: str
    threads: int
    run: Task


def _nested(text, begin):
    """What stands before the bracket that ends the list of arguments, or a comma of that list."""
    depth = 0
    for end in range(begin, len(text)):
        letter = text[end]
        depth -= letter in ">)"
        if depth < 0 or (depth == 0 and letter == ","):
            return text[begin:end]
        depth += letter in "<("
    return text[begin:]


def _owner(body):
    """The function that a lambda was written in, its number there, and that function's first
    template argument; None for any other type."""
    flat, depth = "", 0
    for letter in body:
        depth -= letter in ">)"
        flat += letter if depth == 0 else ""
        depth += letter in "<("
    owner = re.search(r"(\w+)[<>()]*(?: const)?::\{lambda\(\)(#\d+)\}$", flat)
    if not owner:
        return None
    name, number = owner.groups()
    begin = body.find(f"{name}<")
    argument = _nested(body, begin + len(name) + 1) if begin >= 0 else ""
    return name, number, argument


def _words(mangled):
    """The functions that a mangled name tells of: what the demangler leaves so, is read roughly."""
    length = re.compile(r"\d+")
    words, at = [], 0
    while number := length.search(mangled, at):
        at = number.end() + int(number.group())
        word = mangled[number.end() : at]
        if word[:1].islower() and word != "flipflop" and word not in words:
            words.append(word)
    return words


# They call a body, and tell nothing of their own.
PASSED_THROUGH = ("eachTask", "eachRun")


def place_name(place):
    """`file:line function`, and who called a function that only passes bodies on, and so forth.

    #2 is the second lambda of the function before it.
    """
    function = re.match(r"\w*", place["function"]).group()
    names, body = [], place["body"]
    while owner := _owner(body):
        if names or owner[0] != function:
            names.append(owner[0] + owner[1])
        elif not owner[2]:
            break
        body = owner[2]
    if not names and body.startswith("ZN"):
        names = _words(body)
    told = [name for name in names if name.partition("#")[0] not in PASSED_THROUGH]
    if told and function in PASSED_THROUGH:
        return " of ".join(told)
    return f"{os.path.basename(place['file'])}:{place['line']} {' of '.join([function] + told)}"


def sort_task(work, count, place):
    """A sort as oneTBB shares it: one thread parts the elements, then each half is a task.

    A comparison costs the same everywhere, and each pivot halves: so parting takes one of the
    log2(count) rounds that the whole takes.
    """
    if count <= SORTED_AT_ONCE:
        return Task([work])
    part = work / math.log2(count)
    halves = [sort_task((work - part) / 2, count / 2, place) for _ in range(2)]
    return Task([part, 0], [Fork(place, halves)])


def _task(data, places):
    if isinstance(data, (int, float)):
        return Task([data])
    return Task(data[::2], [_fork(fork, places) for fork in data[1::2]])


def _fork(data, places):
    kind, place = places[data["place"]]
    tasks = [_task(task, places) for task in data["tasks"]]
    if kind == "sort":
        tasks = [sort_task(work(task), data["calls"], place) for task in tasks]
    return Fork(place, tasks)


def parse(data):
    """A Record of what a program wrote (TaskGraph/RecordFile.h)."""
    names = [place_name(place) for place in data["places"]]
    count = Counter()
    places = []
    for place, name in zip(data["places"], names):
        count[name] += 1
        unique = f"{name} ({count[name]})" if count[name] > 1 else name
        places.append((place["kind"], unique))
    return Record(data["what"], data["threads"], _task(data["run"], places))


def load(paths):
    """One record; of several of the same run, the least time of each stretch."""
    records = []
    for path in paths:
        with open(path, encoding="utf-8") as file:
            records.append(parse(json.load(file)))
    least = records[0]
    for other in records[1:]:
        if (other.what, other.threads) != (least.what, least.threads):
            raise ValueError(f"{other.what} is not {least.what}")
        _take_least(least.run, other.run)
    return least


def _take_least(task, other):
    if [(f.place, len(f.tasks)) for f in task.forks] != [
        (f.place, len(f.tasks)) for f in other.forks
    ]:
        raise ValueError("the runs forked differently")
    task.stretches = [min(pair) for pair in zip(task.stretches, other.stretches)]
    for mine, theirs in zip(task.forks, other.forks):
        for pair in zip(mine.tasks, theirs.tasks):
            _take_least(*pair)


def tasks_below(task):
    """How many tasks are forked, all in all."""
    return sum(1 + tasks_below(child) for fork in task.forks for child in fork.tasks)


def work(task):
    return sum(task.stretches) + sum(work(child) for fork in task.forks for child in fork.tasks)


def span(task):
    """The time on as many workers as there are tasks, which cost nothing."""
    return sum(task.stretches) + sum(
        max(span(child) for child in fork.tasks) for fork in task.forks
    )


def stretch_name(owner, task, index):
    """Where a stretch is: the fork whose task it is in, and the forks before and after it."""
    if not task.forks:
        return owner
    before = task.forks[index - 1].place if index else "begin"
    after = task.forks[index].place if index < len(task.forks) else "end"
    return f"{owner}: {before} .. {after}"


def longest_path(task, owner="run"):
    """(name, nanoseconds) of each stretch that the span is the sum of."""
    path = []
    for index, stretch in enumerate(task.stretches):
        path.append((stretch_name(owner, task, index), stretch))
        if index < len(task.forks):
            fork = task.forks[index]
            paths = (longest_path(child, fork.place) for child in fork.tasks)
            path += max(paths, key=lambda steps: sum(time for _, time in steps))
    return path


class _Frame:
    """A task under way: its next stretch, and how many tasks its last fork waits for."""

    __slots__ = ("task", "owner", "parent", "next", "missing", "cost")

    def __init__(self, task, owner, parent, cost):
        self.task, self.owner, self.parent, self.cost = task, owner, parent, cost
        self.next = self.missing = 0


def _follow(frame, cost):
    """What may run when a frame's stretch has ended, the first of it last."""
    if frame.next < len(frame.task.forks):
        fork = frame.task.forks[frame.next]
        frame.next += 1
        frame.missing = len(fork.tasks)
        return [_Frame(task, fork.place, frame, cost) for task in reversed(fork.tasks)]
    if frame.parent:
        frame.parent.missing -= 1
        if frame.parent.missing == 0:
            return [frame.parent]
    return []


def play(run, workers, cost):
    """The run on so many workers; each task that is forked costs so much more.

    A worker goes on with what it forked last; one that has nothing takes the oldest of whoever has
    most waiting. What follows a fork is done by whoever ends its last task.

    Returns when all has ended, and by place how long workers had nothing to do while a stretch was
    running there: their time, divided by the number of workers.
    """
    waiting = [deque() for _ in range(workers)]
    waiting[0].append(_Frame(run, "run", None, 0))
    ready = 1
    idle = list(range(workers))
    busy = []  # (when it ends, a number to order by, worker, frame, the idle time at its begin)
    numbers = itertools.count()
    idle_for = Counter()
    now = shared = 0  # shared: the idle workers' time so far, divided among the busy ones
    while True:
        while ready and idle:
            worker = idle.pop()
            own = waiting[worker]
            frame = own.pop() if own else max(waiting, key=len).popleft()
            ready -= 1
            end = now + frame.task.stretches[frame.next] + frame.cost
            frame.cost = 0
            heapq.heappush(busy, (end, next(numbers), worker, frame, shared))
        if not busy:
            return now, idle_for
        share = (workers - len(busy)) / len(busy)
        end, _, worker, frame, before = heapq.heappop(busy)
        shared += (end - now) * share
        now = end
        name = stretch_name(frame.owner, frame.task, frame.next)
        idle_for[name] += (shared - before) / workers
        ready_now = _follow(frame, cost)
        waiting[worker] += ready_now
        ready += len(ready_now)
        idle.append(worker)  # the first to choose
