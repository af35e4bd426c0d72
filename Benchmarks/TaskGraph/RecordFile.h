// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A recording as JSON, for play-tasks.py.
///
///     { "what": text, "threads": number, "places": [PLACE, ...], "run": TASK }
///     PLACE: { "kind": "for", "invoke" or "sort", "file", "line", "function", "body" }
///     TASK:  nanoseconds, or [nanoseconds, FORK, nanoseconds, ..., nanoseconds]
///     FORK:  { "place": index, "calls": number, "tasks": [TASK, ...] }
#ifndef flipflop_tasks_RecordFile_h
#define flipflop_tasks_RecordFile_h

#include "Recording.h"

#include <iosfwd>
#include <string>

namespace flipflop_tasks
{

/// @param what the run, in words
/// @param threads as many as the recording pretended to have
void write(std::ostream& stream, const std::string& what, int threads, const Task& run);

}

#endif
