#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
# SPDX-License-Identifier: BSD-3-Clause
"""Predict a recorded run's time on so many threads, and tell what limits it.

    play-tasks.py RECORD.json...
    play-tasks.py --threads 1,2,4,16,64 --cost 0.5 --top 10 --alone RECORD.json RECORD.json...

Several records of one run (the same points and number of threads) are taken as one: each stretch
takes its least time. Documentation/TaskGraph.md tells what the model leaves out.
"""
import argparse
from collections import defaultdict

from task_graph import load, longest_path, play, span, tasks_below, work


def milliseconds(time):
    return f"{time / 1e6:10.3f}"


def print_path(run, top):
    """The span, by place."""
    times = defaultdict(list)
    for name, time in longest_path(run):
        times[name].append(time)
    whole = span(run)
    print("\nThe span, by place:\n        ms  share  stretches  longest ms")
    for name, all_times in sorted(times.items(), key=lambda item: -sum(item[1]))[:top]:
        total = sum(all_times)
        print(
            f"{milliseconds(total)} {total / max(whole, 1):6.1%} {len(all_times):10}"
            f"  {milliseconds(max(all_times))}  {name}"
        )


def print_idle(threads, seconds, idle_for, top):
    """What kept workers without work, by place."""
    print(f"\n{threads} threads have nothing to do, by what runs meanwhile:\n        ms  share")
    for name, time in idle_for.most_common(top):
        print(f"{milliseconds(time)} {time / max(seconds, 1):6.1%}  {name}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("records", nargs="+", help="what record-tasks wrote")
    parser.add_argument("--threads", default="1,2,4,16,64", help="numbers of threads to play on")
    parser.add_argument("--cost", type=float, default=0.5, help="of forking a task, microseconds")
    parser.add_argument("--alone", help="of the run cut for 1 thread: speed-ups are over its work")
    parser.add_argument("--top", type=int, default=10, help="how many places to list")
    arguments = parser.parse_args()

    record = load(arguments.records)
    whole, longest = work(record.run), span(record.run)
    tasks = tasks_below(record.run)
    print(f"{record.what}, cut for {record.threads} threads")
    print(
        f"work {whole / 1e6:.3f} ms, span {longest / 1e6:.3f} ms:"
        f" {whole / max(longest, 1):.1f} times; {tasks} tasks"
    )
    alone = work(load([arguments.alone]).run) if arguments.alone else whole
    print("\nthreads  ms          speed-up")
    played = {}
    for threads in map(int, arguments.threads.split(",")):
        played[threads] = play(record.run, threads, arguments.cost * 1e3)
        time = played[threads][0]
        print(f"{threads:7}{milliseconds(time)} {alone / max(time, 1):10.2f}")
    print_path(record.run, arguments.top)
    if record.threads in played and record.threads > 1:
        print_idle(record.threads, *played[record.threads], arguments.top)


if __name__ == "__main__":
    main()
