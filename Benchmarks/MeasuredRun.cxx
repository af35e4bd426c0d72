// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeasuredRun.h"

#include "ProcessMemory.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <exception>
#include <sstream>

#include <csignal>
#include <poll.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

namespace flipflop
{
namespace
{

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Touch as much memory as programs are known to take, 2 GiB at most, and give it back. A virtual
/// machine's host hands memory out when it is first touched, at a twentieth of the usual speed:
/// without this, the first run pays for all.
void touchMemory(std::int64_t points)
{
  constexpr std::size_t BytesPerPoint = 800;
  constexpr std::size_t Most = std::size_t(1) << 31;
  constexpr std::size_t Page = 4096;
  const auto available = static_cast<std::size_t>(sysconf(_SC_AVPHYS_PAGES)) * Page;
  const std::size_t bytes =
    std::min({ static_cast<std::size_t>(points) * BytesPerPoint, Most, available / 2 });
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

/// Moves a metric that replaces a measured value.
void takeMetric(Metrics& metrics, const char* name, double& value)
{
  const auto found = std::find_if(
    metrics.begin(), metrics.end(), [&](const auto& metric) { return metric.first == name; });
  if (found != metrics.end())
  {
    value = found->second;
    metrics.erase(found);
  }
}

Measurement runHere(Program& program, const Input& input)
{
  Measurement result;
  touchMemory(input.count());
  program.prepare(input);
  const double before = resetPeakMemory();
  const Clock::time_point start = Clock::now();
  program.run();
  result.seconds = secondsSince(start);
  result.peakBytes = peakMemory() - before;
  result.metrics = program.metrics();
  takeMetric(result.metrics, "seconds", result.seconds);
  takeMetric(result.metrics, "peak_bytes", result.peakBytes);
  result.status = Status::Ok;
  return result;
}

void checkHere(Measurement& result, const Program& program)
{
  const Clock::time_point start = Clock::now();
  const CheckResult check = program.check();
  result.checkSeconds = secondsSince(start);
  result.status = check.isRight ? Status::Ok : Status::Wrong;
  result.message = check.text;
}

/// The run, and its check; @p publish is called before the check begins.
template <class Publish>
Measurement runAndCheck(const RunRequest& request, const Publish& publish)
{
  Measurement result;
  try
  {
    if (request.warmUp)
    {
      const std::unique_ptr<Program> warm = request.make();
      warm->prepare(*request.warmUp);
      warm->run();
    }
    const std::unique_ptr<Program> program = request.make();
    result = runHere(*program, *request.input);
    if (request.check)
    {
      publish(result);
      checkHere(result, *program);
    }
  }
  catch (const std::exception& error)
  {
    result.status = Status::Failed;
    result.message = error.what();
  }
  return result;
}

/// A length, and so many bytes of text: numbers, metrics line by line, the message.
void send(int pipe, const Measurement& measurement)
{
  std::ostringstream text;
  text.precision(17);
  // Streams do not read NaN.
  const auto orMissing = [](double value) { return std::isnan(value) ? -1 : value; };
  text << static_cast<int>(measurement.status) << ' ' << orMissing(measurement.seconds) << ' '
       << orMissing(measurement.peakBytes) << ' ' << measurement.checkSeconds << ' '
       << measurement.metrics.size() << '\n';
  for (const auto& [name, value] : measurement.metrics)
  {
    text << orMissing(value) << ' ' << name << '\n';
  }
  text << measurement.message;
  const std::string bytes = text.str();
  const std::size_t size = bytes.size();
  const bool isSent = write(pipe, &size, sizeof(size)) == sizeof(size) &&
    write(pipe, bytes.data(), size) == static_cast<ssize_t>(size);
  if (!isSent)
  {
    _exit(1);
  }
}

bool readAll(int pipe, void* to, std::size_t bytes)
{
  for (std::size_t at = 0; at < bytes;)
  {
    const ssize_t got = read(pipe, static_cast<char*>(to) + at, bytes - at);
    if (got <= 0)
    {
      return false;
    }
    at += static_cast<std::size_t>(got);
  }
  return true;
}

Measurement receive(int pipe)
{
  Measurement result;
  std::size_t size = 0;
  std::string bytes;
  if (readAll(pipe, &size, sizeof(size)))
  {
    bytes.resize(size);
  }
  if (size == 0 || !readAll(pipe, &bytes[0], size))
  {
    result.message = "the process ended without a result";
    return result;
  }
  std::istringstream text(bytes);
  int status = 0;
  std::size_t metrics = 0;
  text >> status >> result.seconds >> result.peakBytes >> result.checkSeconds >> metrics;
  result.status = static_cast<Status>(status);
  for (double* value : { &result.seconds, &result.peakBytes })
  {
    *value = *value < 0 ? std::nan("") : *value;
  }
  for (std::size_t i = 0; i < metrics; ++i)
  {
    double value = 0;
    std::string name;
    text >> value >> std::ws;
    std::getline(text, name);
    result.metrics.emplace_back(name, value);
  }
  text >> std::ws;
  std::getline(text, result.message, '\0');
  return result;
}

Measurement failed(const char* message)
{
  Measurement result;
  result.message = message;
  return result;
}

}

const char* name(Status status)
{
  const char* const names[] = { "ok", "wrong", "failed", "timeout", "skipped" };
  return names[static_cast<int>(status)];
}

Measurement measure(const RunRequest& request)
{
  if (!request.isolate)
  {
    return runAndCheck(request, [](const Measurement&) {});
  }
  int ends[2];
  if (pipe(ends) != 0)
  {
    return failed("no pipe");
  }
  std::fflush(nullptr);
  const pid_t process = fork();
  if (process == 0)
  {
    close(ends[0]);
    send(ends[1], runAndCheck(request, [&](const Measurement& early) { send(ends[1], early); }));
    // Skip destructors and exit handlers: they belong to the parent.
    _exit(0);
  }
  close(ends[1]);
  Measurement result = failed("no process");
  if (process > 0)
  {
    pollfd wait = { ends[0], POLLIN, 0 };
    const int limit = request.limitSeconds > 0 ? static_cast<int>(request.limitSeconds * 1000) : -1;
    if (poll(&wait, 1, limit) == 0)
    {
      kill(process, SIGKILL);
      result = failed("");
      result.status = Status::Timeout;
    }
    else
    {
      result = receive(ends[0]);
      if (request.check && result.isDone())
      {
        result = receive(ends[0]);
      }
    }
    waitpid(process, nullptr, 0);
  }
  close(ends[0]);
  return result;
}

}
