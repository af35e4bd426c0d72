// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plan.h"

#include "Testing/Engine/Inputs/InputsInUse.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <stdexcept>

namespace flipflop
{
namespace
{

using Values = std::map<std::string, std::string>;

std::string trimmed(const std::string& text)
{
  const std::size_t begin = text.find_first_not_of(" \t\r");
  const std::size_t end = text.find_last_not_of(" \t\r");
  return begin == std::string::npos ? "" : text.substr(begin, end + 1 - begin);
}

std::vector<std::string> split(const std::string& list)
{
  std::vector<std::string> entries;
  for (std::size_t begin = 0; begin <= list.size();)
  {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    entries.push_back(trimmed(list.substr(begin, end - begin)));
    if (entries.back().empty())
    {
      throw std::invalid_argument("an empty entry in: " + list);
    }
    begin = end + 1;
  }
  return entries;
}

double number(const std::string& text, double least, double most)
{
  std::size_t used = 0;
  double value = std::nan("");
  try
  {
    value = std::stod(text, &used);
  }
  catch (const std::exception&)
  {
    used = std::string::npos;
  }
  if (used != text.size() || !(value >= least && value <= most))
  {
    throw std::invalid_argument("not a number in its range: " + text);
  }
  return value;
}

template <class Int>
std::vector<Int> numbers(const std::string& list, double least, double most)
{
  std::vector<Int> result;
  for (const std::string& entry : split(list))
  {
    result.push_back(static_cast<Int>(std::llround(number(entry, least, most))));
  }
  return result;
}

bool yesOrNo(const std::string& text)
{
  if (text != "yes" && text != "no")
  {
    throw std::invalid_argument("neither yes nor no: " + text);
  }
  return text == "yes";
}

std::vector<std::string> families(const std::string& list, bool isPlane)
{
  std::vector<std::string> result;
  for (const std::string& entry : split(list))
  {
    if (entry != "in-use")
    {
      result.push_back(entry);
      continue;
    }
    const std::vector<std::string> all = test::withShuffled(test::namesInUse(isPlane));
    result.insert(result.end(), all.begin(), all.end());
  }
  return result;
}

void set(Plan& plan, const std::string& key, const std::string& value)
{
  const auto seconds = [&] { return number(value, 0, 1e6); };
  if (key == "families")
  {
    plan.families = families(value, plan.problem->isPlane);
  }
  else if (key == "counts")
  {
    plan.counts = numbers<std::int64_t>(value, 1, 2e9);
  }
  else if (key == "programs")
  {
    plan.programs.clear();
    for (const std::string& name : split(value))
    {
      plan.programs.push_back(&plan.problem->find(name));
    }
  }
  else if (key == "threads" || key == "parts")
  {
    (key == "threads" ? plan.threads : plan.parts) = numbers<int>(value, 0, 1e6);
  }
  else if (key == "repetitions")
  {
    plan.repetitions = static_cast<int>(number(value, 1, 1000));
  }
  else if (key == "max-peer-seconds")
  {
    plan.maxPeerSeconds = seconds();
  }
  else if (key == "max-case-seconds")
  {
    plan.maxCaseSeconds = seconds();
  }
  else if (key == "max-seconds")
  {
    plan.maxSeconds = seconds();
  }
  else if (key == "seed")
  {
    plan.seed = static_cast<std::uint64_t>(number(value, 0, 0x1p53));
  }
  else if (key == "check" || key == "isolate")
  {
    (key == "check" ? plan.check : plan.isolate) = yesOrNo(value);
  }
  else if (key == "output")
  {
    plan.output = value;
  }
  else
  {
    throw std::invalid_argument("unknown key: " + key);
  }
}

Plan makePlan(const std::string& section, Values values)
{
  Plan plan;
  plan.section = section;
  values.emplace("problem", section);
  plan.problem = &findProblem(values["problem"]);
  values.erase("problem");
  for (const auto& [key, value] : values)
  {
    set(plan, key, value);
  }
  if (plan.families.empty() || plan.counts.empty() || plan.programs.empty())
  {
    throw std::invalid_argument("[" + section + "] lacks families, counts or programs");
  }
  return plan;
}

/// `key = value`, or an empty key where there is no "=".
std::pair<std::string, std::string> keyAndValue(const std::string& text)
{
  const std::size_t equals = text.find('=');
  return equals == std::string::npos
    ? std::pair<std::string, std::string>()
    : std::make_pair(trimmed(text.substr(0, equals)), trimmed(text.substr(equals + 1)));
}

/// The sections in their order, each with the values that hold for all.
std::vector<std::pair<std::string, Values>> readSections(const std::string& path)
{
  std::ifstream file(path);
  if (!file)
  {
    throw std::invalid_argument("cannot read " + path);
  }
  Values common;
  std::vector<std::pair<std::string, Values>> sections;
  std::string line;
  for (int at = 1; std::getline(file, line); ++at)
  {
    line = trimmed(line.substr(0, line.find('#')));
    if (line.empty())
    {
      continue;
    }
    if (line.front() == '[' && line.back() == ']')
    {
      sections.emplace_back(line.substr(1, line.size() - 2), common);
      continue;
    }
    const auto [key, value] = keyAndValue(line);
    if (key.empty() || value.empty())
    {
      throw std::invalid_argument(path + ", line " + std::to_string(at) + ": " + line);
    }
    (sections.empty() ? common : sections.back().second)[key] = value;
  }
  return sections;
}

}

std::vector<Plan> readPlans(const std::vector<std::string>& arguments)
{
  if (arguments.empty())
  {
    throw std::invalid_argument("no plan");
  }
  const auto sections = readSections(arguments[0]);
  std::vector<std::string> chosen;
  Values replaced;
  for (std::size_t i = 1; i < arguments.size(); ++i)
  {
    const auto [key, value] = keyAndValue(arguments[i]);
    key.empty() ? chosen.push_back(arguments[i]) : void(replaced[key] = value);
  }
  std::vector<Plan> plans;
  for (const auto& [name, values] : sections)
  {
    if (chosen.empty() || std::find(chosen.begin(), chosen.end(), name) != chosen.end())
    {
      Values all = replaced;
      all.insert(values.begin(), values.end());
      plans.push_back(makePlan(name, all));
    }
  }
  for (const std::string& name : chosen)
  {
    if (std::none_of(
          plans.begin(), plans.end(), [&](const Plan& plan) { return plan.section == name; }))
    {
      throw std::invalid_argument("the plan has no section " + name);
    }
  }
  return plans;
}

}
