// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numeric>
#include <thread>
#include <utility>

namespace flipflop
{
namespace
{

/// The statistics that are reported, by name.
using Count = std::pair<const char*, std::int64_t Statistics::*>;
using Stage = std::pair<const char*, double Statistics::*>;

constexpr std::array<Count, 9> counts = { {
  { "culled", &Statistics::culled },
  { "insertions", &Statistics::insertions },
  { "flips22", &Statistics::flips22 },
  { "flips31", &Statistics::flips31 },
  { "flips_v", &Statistics::flipsV },
  { "flips_d", &Statistics::flipsD },
  { "labelled", &Statistics::labelled },
  { "edge_checks", &Statistics::edgeChecks },
  { "exact_calls", &Statistics::exactCalls },
} };

constexpr std::array<Stage, 5> stages = { {
  { "seconds_scan", &Statistics::secondsScan },
  { "seconds_locate", &Statistics::secondsLocate },
  { "seconds_grow", &Statistics::secondsGrow },
  { "seconds_flip", &Statistics::secondsFlip },
  { "seconds_finish", &Statistics::secondsFinish },
} };

/// The median over the rounds of a stage's time.
double stageSeconds(const Row& row, double Statistics::*stage)
{
  std::vector<double> values;
  for (const Outcome& outcome : row.outcomes)
  {
    values.push_back(outcome.statistics.*stage);
  }
  return Summary::of(values).median;
}

/// A number, or nothing where there is none.
void csvNumber(std::FILE* file, double value)
{
  if (std::isfinite(value))
  {
    std::fprintf(file, ",%.6g", value);
  }
  else
  {
    std::fputc(',', file);
  }
}

void jsonNumber(std::FILE* file, const char* key, double value)
{
  if (std::isfinite(value))
  {
    std::fprintf(file, ", \"%s\": %.9g", key, value);
  }
  else
  {
    std::fprintf(file, ", \"%s\": null", key);
  }
}

std::string quoted(const std::string& text)
{
  std::string result = "\"";
  for (const char c : text)
  {
    if (c == '"' || c == '\\')
    {
      result += '\\';
    }
    result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return result + '"';
}

std::string processor()
{
  std::FILE* file = std::fopen("/proc/cpuinfo", "r");
  std::string result = "unknown";
  char line[256];
  while (file && std::fgets(line, sizeof(line), file))
  {
    const char* colon = std::strchr(line, ':');
    if (std::strncmp(line, "model name", 10) == 0 && colon && colon[1] != 0)
    {
      result.assign(colon + 2, std::strcspn(colon + 2, "\n"));
      break;
    }
  }
  if (file)
  {
    std::fclose(file);
  }
  return result;
}

void jsonRow(std::FILE* file, const Suite& suite, const Row& row, const Case& one)
{
  const Summary time = Summary::of(row.seconds);
  std::fprintf(file, "        {\"contender\": \"%s\", \"threads\": %d, \"status\": \"%s\"",
    row.contender.c_str(), row.threads, name(row.status));
  if (!row.message.empty())
  {
    std::fprintf(file, ", \"message\": %s", quoted(row.message).c_str());
  }
  std::fprintf(file, ", \"seconds\": [");
  for (std::size_t i = 0; i < row.seconds.size(); ++i)
  {
    std::fprintf(file, "%s%.6f", i ? ", " : "", row.seconds[i]);
  }
  std::fputc(']', file);
  jsonNumber(file, "seconds_median", time.median);
  if (!row.seconds.empty())
  {
    const Outcome& outcome = row.typical();
    std::fprintf(file, ", \"vertices\": %lld, \"facets\": %lld",
      static_cast<long long>(outcome.vertices), static_cast<long long>(outcome.facets));
    jsonNumber(
      file, "peak_bytes", row.peakBytes < 0 ? std::nan("") : static_cast<double>(row.peakBytes));
    if (row.contender == "flipflop")
    {
      for (const Peer& peer : suite.peers)
      {
        const Row* other = one.find(peer.name);
        if (other && !other->seconds.empty())
        {
          jsonNumber(file, ("ratio_" + peer.name).c_str(), row.ratio(*other).median);
        }
      }
      for (const Count& count : counts)
      {
        std::fprintf(file, ", \"%s\": %lld", count.first,
          static_cast<long long>(outcome.statistics.*count.second));
      }
      for (const Stage& stage : stages)
      {
        jsonNumber(file, stage.first, stageSeconds(row, stage.second));
      }
    }
  }
  std::fputc('}', file);
}

int nameWidth(const Suite& suite)
{
  std::size_t width = 10;
  for (const Peer& peer : suite.peers)
  {
    width = std::max(width, peer.name.size());
  }
  return static_cast<int>(width);
}

int ratioWidth(const Peer& peer)
{
  return static_cast<int>(std::max<std::size_t>(8, peer.title.size() + 2));
}

}

Summary Summary::of(std::vector<double> values)
{
  if (values.empty())
  {
    return { std::nan(""), std::nan(""), std::nan("") };
  }
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  const double median =
    values.size() % 2 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
  return { median, values.front(), values.back() };
}

void Row::add(const Measurement& measurement)
{
  // A verdict stands for the rounds after it, which nobody judges.
  if (measurement.status != Status::Ok || measurement.message[0] != 0)
  {
    this->status = measurement.status;
    this->message = measurement.message;
  }
  if (measurement.done())
  {
    this->seconds.push_back(measurement.seconds);
    this->outcomes.push_back(measurement.outcome);
    this->peakBytes = std::max(this->peakBytes, measurement.peakBytes);
  }
}

Summary Row::ratio(const Row& peer) const
{
  std::vector<double> ratios;
  for (std::size_t i = 0; i < std::min(this->seconds.size(), peer.seconds.size()); ++i)
  {
    ratios.push_back(peer.seconds[i] / this->seconds[i]);
  }
  return Summary::of(ratios);
}

const Outcome& Row::typical() const
{
  std::vector<std::size_t> order(this->seconds.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::sort(order.begin(), order.end(),
    [this](std::size_t a, std::size_t b) { return this->seconds[a] < this->seconds[b]; });
  return this->outcomes[order[order.size() / 2]];
}

const Row* Case::find(const std::string& contender) const
{
  const auto found = std::find_if(this->rows.begin(), this->rows.end(),
    [&](const Row& row) { return row.contender == contender; });
  return found == this->rows.end() ? nullptr : &*found;
}

void printHeader(std::FILE* file, const Suite& suite)
{
  std::fprintf(file, "%-25s %10s  %-*s %9s %9s %9s", "points", "n", nameWidth(suite), "contender",
    "median s", "min", "max");
  for (const Peer& peer : suite.peers)
  {
    std::fprintf(file, " %*s", ratioWidth(peer), ("x " + peer.title).c_str());
  }
  std::fprintf(file, " %10s %10s %9s  %s\n", "vertices", "facets", "B/point", "status");
}

void printCase(std::FILE* file, const Suite& suite, const Case& one)
{
  for (const Row& row : one.rows)
  {
    std::string contender = row.contender;
    if (contender == "flipflop")
    {
      contender += " " + std::to_string(row.threads);
    }
    std::fprintf(file, "%-25s %10lld  %-*s", one.distribution.label().c_str(),
      static_cast<long long>(one.points), nameWidth(suite), contender.c_str());
    const bool done = !row.seconds.empty();
    if (done)
    {
      const Summary time = Summary::of(row.seconds);
      std::fprintf(file, " %9.4f %9.4f %9.4f", time.median, time.least, time.greatest);
    }
    else
    {
      std::fprintf(file, " %9s %9s %9s", "-", "-", "-");
    }
    for (const Peer& peer : suite.peers)
    {
      const Row* other = one.find(peer.name);
      if (done && row.contender == "flipflop" && other && !other->seconds.empty())
      {
        std::fprintf(file, " %*.2f", ratioWidth(peer), row.ratio(*other).median);
      }
      else
      {
        std::fprintf(file, " %*s", ratioWidth(peer), "");
      }
    }
    if (done)
    {
      const Outcome& outcome = row.typical();
      std::fprintf(file, " %10lld %10lld %9.1f", static_cast<long long>(outcome.vertices),
        static_cast<long long>(outcome.facets),
        static_cast<double>(row.peakBytes) / static_cast<double>(one.points));
    }
    else
    {
      std::fprintf(file, " %10s %10s %9s", "-", "-", "-");
    }
    std::fprintf(
      file, "  %s%s%s\n", name(row.status), row.message.empty() ? "" : ": ", row.message.c_str());
  }
  std::fflush(file);
}

void writeCsv(std::FILE* file, const Suite& suite, const std::vector<Case>& cases)
{
  std::fprintf(file,
    "distribution,parameter,n,contender,threads,status,rounds,seconds_median,seconds_min,"
    "seconds_max");
  for (const Peer& peer : suite.peers)
  {
    const char* of = peer.name.c_str();
    std::fprintf(file, ",ratio_%s,ratio_%s_min,ratio_%s_max", of, of, of);
  }
  std::fprintf(file, ",vertices,facets,peak_bytes,bytes_per_point");
  for (const Count& count : counts)
  {
    std::fprintf(file, ",%s", count.first);
  }
  for (const Stage& stage : stages)
  {
    std::fprintf(file, ",%s", stage.first);
  }
  std::fprintf(file, ",message\n");

  for (const Case& one : cases)
  {
    for (const Row& row : one.rows)
    {
      const bool ours = row.contender == "flipflop";
      const bool done = !row.seconds.empty();
      std::fprintf(file, "%s", one.distribution.name.c_str());
      csvNumber(file, one.distribution.hasParameter() ? one.distribution.parameter : std::nan(""));
      std::fprintf(file, ",%lld,%s,%d,%s,%zu", static_cast<long long>(one.points),
        row.contender.c_str(), row.threads, name(row.status), row.seconds.size());
      const Summary time = Summary::of(row.seconds);
      csvNumber(file, time.median);
      csvNumber(file, time.least);
      csvNumber(file, time.greatest);
      for (const Peer& peer : suite.peers)
      {
        const Row* other = one.find(peer.name);
        const Summary ratio = ours && other ? row.ratio(*other) : Summary::of({});
        csvNumber(file, ratio.median);
        csvNumber(file, ratio.least);
        csvNumber(file, ratio.greatest);
      }
      if (done)
      {
        std::fprintf(file, ",%lld,%lld", static_cast<long long>(row.typical().vertices),
          static_cast<long long>(row.typical().facets));
      }
      else
      {
        std::fprintf(file, ",,");
      }
      if (done && row.peakBytes >= 0)
      {
        std::fprintf(file, ",%lld,%.1f", static_cast<long long>(row.peakBytes),
          static_cast<double>(row.peakBytes) / static_cast<double>(one.points));
      }
      else
      {
        std::fprintf(file, ",,");
      }
      for (const Count& count : counts)
      {
        std::fputc(',', file);
        if (ours && done)
        {
          std::fprintf(
            file, "%lld", static_cast<long long>(row.typical().statistics.*count.second));
        }
      }
      for (const Stage& stage : stages)
      {
        csvNumber(file, ours ? stageSeconds(row, stage.second) : std::nan(""));
      }
      std::fprintf(file, ",%s\n", row.message.empty() ? "" : quoted(row.message).c_str());
    }
  }
}

void writeJson(
  std::FILE* file, const Suite& suite, const std::vector<Case>& cases, const Plan& plan)
{
  std::fprintf(file, "{\n  \"processor\": %s,\n  \"cores\": %u,\n  \"compiler\": %s,\n",
    quoted(processor()).c_str(), std::thread::hardware_concurrency(), quoted(__VERSION__).c_str());
  for (const auto& version : suite.versions)
  {
    std::fprintf(
      file, "  %s: %s,\n", quoted(version.first).c_str(), quoted(version.second).c_str());
  }
  std::fprintf(
    file, "  \"seed\": %llu,\n  \"cases\": [\n", static_cast<unsigned long long>(plan.seed));
  for (std::size_t c = 0; c < cases.size(); ++c)
  {
    const Case& one = cases[c];
    std::fprintf(file, "    {\"distribution\": \"%s\"", one.distribution.name.c_str());
    if (one.distribution.hasParameter())
    {
      jsonNumber(file, "parameter", one.distribution.parameter);
    }
    std::fprintf(file, ", \"n\": %lld, \"rows\": [\n", static_cast<long long>(one.points));
    for (std::size_t r = 0; r < one.rows.size(); ++r)
    {
      jsonRow(file, suite, one.rows[r], one);
      std::fprintf(file, "%s\n", r + 1 < one.rows.size() ? "," : "");
    }
    std::fprintf(file, "    ]}%s\n", c + 1 < cases.size() ? "," : "");
  }
  std::fprintf(file, "  ]\n}\n");
}

}
