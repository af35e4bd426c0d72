// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeasuredRun.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <type_traits>

#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

namespace flipflop
{
namespace
{

static_assert(std::is_trivially_copyable<Measurement>::value, "sent through a pipe");

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void say(Measurement& measurement, const char* text)
{
  std::snprintf(measurement.message, sizeof(measurement.message), "%s", text);
}

/// A field of /proc/self/status in bytes, -1 where there is none.
std::int64_t memoryField(const char* field)
{
  std::FILE* file = std::fopen("/proc/self/status", "r");
  if (!file)
  {
    return -1;
  }
  std::int64_t bytes = -1;
  char line[256];
  const std::size_t length = std::strlen(field);
  while (std::fgets(line, sizeof(line), file))
  {
    if (std::strncmp(line, field, length) == 0 && line[length] == ':')
    {
      bytes = std::strtoll(line + length + 1, nullptr, 10) * 1024;
    }
  }
  std::fclose(file);
  return bytes;
}

/// Let VmHWM start again at what is resident now, and return that.
std::int64_t resetPeak()
{
  const int file = open("/proc/self/clear_refs", O_WRONLY);
  if (file < 0)
  {
    return -1;
  }
  const bool done = write(file, "5", 1) == 1;
  close(file);
  return done ? memoryField("VmRSS") : -1;
}

/// Touch as much memory as contenders are known to take, 2 GiB at most, and give it back. A virtual
/// machine's host hands memory out when it is first touched, at a twentieth of the usual speed:
/// without this, whoever runs first pays for all.
void touchMemory(const Coordinates& xyz)
{
  constexpr std::size_t BytesAPoint = 800;
  constexpr std::size_t Most = std::size_t(1) << 31;
  constexpr std::size_t Page = 4096;
  const auto available = static_cast<std::size_t>(sysconf(_SC_AVPHYS_PAGES)) * Page;
  const std::size_t bytes = std::min({ xyz.size() / 3 * BytesAPoint, Most, available / 2 });
  void* const memory =
    mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory != MAP_FAILED)
  {
    madvise(memory, bytes, MADV_HUGEPAGE);
    for (std::size_t at = 0; at < bytes; at += Page)
    {
      static_cast<volatile char*>(memory)[at] = 1;
    }
    munmap(memory, bytes);
  }
}

/// The contender's run on @p xyz; it keeps its result.
Measurement runHere(Contender& contender, const Coordinates& xyz)
{
  Measurement result;
  touchMemory(xyz);
  contender.prepare(xyz);

  const std::int64_t before = resetPeak();
  const Clock::time_point start = Clock::now();
  contender.run();
  result.seconds = secondsSince(start);
  const std::int64_t peak = memoryField("VmHWM");

  result.peakBytes = before < 0 || peak < 0 ? -1 : peak - before;
  result.outcome = contender.outcome();
  if (result.outcome.seconds >= 0)
  {
    result.seconds = result.outcome.seconds;
    result.peakBytes = result.outcome.peakBytes;
  }
  result.status = Status::Ok;
  return result;
}

void judgeHere(Measurement& result, const Contender& contender)
{
  const Clock::time_point start = Clock::now();
  const Verdict verdict = contender.judge();
  result.judgingSeconds = secondsSince(start);
  result.status = verdict.right ? Status::Ok : Status::Wrong;
  say(result, verdict.text.c_str());
}

/// Send back what the run comes to and, if @p judge, once more with the verdict.
[[noreturn]] void child(int pipe, const Coordinates& xyz, const Coordinates& few,
  const ContenderFactory& factory, bool judge)
{
  Measurement result;
  const auto send = [&]
  { return write(pipe, &result, sizeof(result)) == static_cast<ssize_t>(sizeof(result)); };
  bool sent = true;
  try
  {
    {
      const std::unique_ptr<Contender> warm = factory();
      warm->prepare(few);
      warm->run();
    }
    const std::unique_ptr<Contender> contender = factory();
    result = runHere(*contender, xyz);
    if (judge)
    {
      sent = send();
      judgeHere(result, *contender);
    }
  }
  catch (const std::exception& error)
  {
    result.status = Status::Failed;
    say(result, error.what());
  }
  sent = send() && sent;
  // Skip destructors and exit handlers: they belong to the parent.
  _exit(sent ? 0 : 1);
}

/// What the child sends next.
Measurement receive(int pipe)
{
  Measurement received;
  if (read(pipe, &received, sizeof(received)) != static_cast<ssize_t>(sizeof(received)))
  {
    received = Measurement();
    say(received, "the process ended without a result");
  }
  return received;
}

}

const char* name(Status status)
{
  switch (status)
  {
    case Status::Ok:
      return "ok";
    case Status::Wrong:
      return "wrong";
    case Status::Failed:
      return "failed";
    case Status::Timeout:
      return "timeout";
    case Status::Skipped:
      return "skipped";
  }
  return "unknown";
}

Measurement measure(const Coordinates& xyz, const Coordinates& few, const ContenderFactory& factory,
  double limitSeconds, bool judge)
{
  Measurement result;
  int ends[2];
  if (pipe(ends) != 0)
  {
    say(result, "no pipe");
    return result;
  }
  std::fflush(nullptr);
  const pid_t process = fork();
  if (process < 0)
  {
    say(result, "no process");
    close(ends[0]);
    close(ends[1]);
    return result;
  }
  if (process == 0)
  {
    close(ends[0]);
    child(ends[1], xyz, few, factory, judge);
  }
  close(ends[1]);

  pollfd wait = { ends[0], POLLIN, 0 };
  const int limit = limitSeconds > 0 ? static_cast<int>(limitSeconds * 1000) : -1;
  if (poll(&wait, 1, limit) == 0)
  {
    kill(process, SIGKILL);
    result.status = Status::Timeout;
    result.seconds = limitSeconds;
  }
  else
  {
    result = receive(ends[0]);
    if (judge && result.done())
    {
      result = receive(ends[0]);
    }
  }
  close(ends[0]);
  waitpid(process, nullptr, 0);
  return result;
}

}
