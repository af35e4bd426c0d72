// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Results.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace flipflop
{
namespace
{

double median(std::vector<double> values)
{
  if (values.empty())
  {
    return std::nan("");
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// How many times longer @p other took, round by round; NaN if there is no common round.
double medianRatio(const Entry& entry, const Entry& other)
{
  std::vector<double> ratios;
  for (std::size_t i = 0; i < std::min(entry.rounds.size(), other.rounds.size()); ++i)
  {
    if (entry.rounds[i].isDone() && other.rounds[i].isDone())
    {
      ratios.push_back(other.rounds[i].seconds / entry.rounds[i].seconds);
    }
  }
  return median(ratios);
}

const double* find(const Metrics& metrics, const std::string& name)
{
  for (const auto& metric : metrics)
  {
    if (metric.first == name)
    {
      return &metric.second;
    }
  }
  return nullptr;
}

std::string cell(double value)
{
  char text[32] = "";
  if (std::isfinite(value))
  {
    std::snprintf(text, sizeof(text), std::fabs(value) >= 1e6 ? "%.0f" : "%.7g", value);
  }
  return text;
}

std::string quoted(const std::string& text)
{
  std::string result;
  for (const char c : text)
  {
    result += c == '"' ? "'" : static_cast<unsigned char>(c) < 0x20 ? " " : std::string(1, c);
  }
  return result.find(',') == std::string::npos ? result : '"' + result + '"';
}

/// The names of all metrics, in the order in which they first occur.
std::vector<std::string> metricNames(const std::vector<Case>& cases)
{
  std::vector<std::string> names;
  for (const Case& one : cases)
  {
    for (const Entry& entry : one.entries)
    {
      for (const Measurement& round : entry.rounds)
      {
        for (const auto& metric : round.metrics)
        {
          if (std::find(names.begin(), names.end(), metric.first) == names.end())
          {
            names.push_back(metric.first);
          }
        }
      }
    }
  }
  return names;
}

}

double Entry::medianSeconds() const
{
  std::vector<double> seconds;
  for (const Measurement& round : this->rounds)
  {
    if (round.isDone())
    {
      seconds.push_back(round.seconds);
    }
  }
  return median(seconds);
}

void printCase(const Case& one, const Problem& problem)
{
  for (const Entry& entry : one.entries)
  {
    std::string program = entry.kind->name;
    program += entry.kind->hasThreads ? ", threads " + std::to_string(entry.settings.threads) : "";
    program += entry.settings.parts ? ", parts " + std::to_string(entry.settings.parts) : "";
    std::printf("%-24s %10lld  %-28s %10.5f s", one.family.c_str(),
      static_cast<long long>(one.count), program.c_str(), entry.medianSeconds());
    const Measurement& last = entry.rounds.back();
    for (const std::string& name : problem.agreed)
    {
      const double* const value = find(last.metrics, name);
      std::printf("  %s %.0f", name.c_str(), value ? *value : std::nan(""));
    }
    for (const Entry& other : one.entries)
    {
      const double ratio = medianRatio(entry, other);
      if (entry.kind->isOurs && !other.kind->isOurs && std::isfinite(ratio))
      {
        std::printf("  %.2f x %s", ratio, other.kind->name.c_str());
      }
    }
    const Measurement& first = entry.rounds.front();
    std::printf("  %s %s\n", name(first.isDone() ? first.status : last.status),
      (first.message.empty() ? last : first).message.c_str());
  }
  std::fflush(stdout);
}

void writeCsv(const std::string& path,
  const std::vector<std::pair<std::string, std::string>>& facts, const std::vector<Case>& cases)
{
  std::ofstream file(path);
  for (const auto& fact : facts)
  {
    file << "# " << fact.first << ": " << fact.second << "\n";
  }
  const std::vector<std::string> names = metricNames(cases);
  file << "family,count,program,threads,parts,round,status,seconds,peak_bytes";
  for (const std::string& name : names)
  {
    file << ',' << quoted(name);
  }
  file << ",message\n";
  for (const Case& one : cases)
  {
    for (const Entry& entry : one.entries)
    {
      for (std::size_t i = 0; i < entry.rounds.size(); ++i)
      {
        const Measurement& round = entry.rounds[i];
        file << quoted(one.family) << ',' << one.count << ',' << entry.kind->name << ','
             << entry.settings.threads << ',' << entry.settings.parts << ',' << i << ','
             << name(round.status) << ',' << cell(round.seconds) << ',' << cell(round.peakBytes);
        for (const std::string& name : names)
        {
          const double* const value = find(round.metrics, name);
          file << ',' << (value ? cell(*value) : "");
        }
        file << ',' << quoted(round.message) << '\n';
      }
    }
  }
  if (!file.flush())
  {
    throw std::runtime_error("cannot write " + path);
  }
}

}
