// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RecordFile.h"

#include <cstdlib>
#include <map>
#include <memory>
#include <ostream>
#include <tuple>

#include <cxxabi.h>

namespace flipflop_tasks
{
namespace
{

std::string quoted(const std::string& text)
{
  std::string result = "\"";
  for (const char c : text)
  {
    result += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  }
  return result + "\"";
}

/// A type's name as people write it.
std::string demangled(const char* name)
{
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> text(
    abi::__cxa_demangle(name, nullptr, nullptr, &status), &std::free);
  return status == 0 ? text.get() : name;
}

/// The places, numbered as they first come.
class Places
{
public:
  explicit Places(const Task& run) { this->add(run); }

  std::size_t number(const Place& place) const { return this->numbers.at(key(place)); }

  void write(std::ostream& stream) const
  {
    for (std::size_t i = 0; i < this->inOrder.size(); ++i)
    {
      const Place& place = this->inOrder[i];
      stream << (i == 0 ? "[\n" : ",\n") << "{\"kind\": " << quoted(place.kind)
             << ", \"file\": " << quoted(place.file) << ", \"line\": " << place.line
             << ", \"function\": " << quoted(place.function)
             << ", \"body\": " << quoted(demangled(place.body)) << "}";
    }
    stream << (this->inOrder.empty() ? "[]" : "]");
  }

private:
  using Key = std::tuple<std::string, int, std::string>;

  static Key key(const Place& place) { return { place.file, place.line, place.body }; }

  void add(const Task& task)
  {
    for (const Fork& fork : task.forks)
    {
      if (this->numbers.emplace(key(fork.place), this->inOrder.size()).second)
      {
        this->inOrder.push_back(fork.place);
      }
      for (const Task& child : fork.tasks)
      {
        this->add(child);
      }
    }
  }

  std::map<Key, std::size_t> numbers;
  std::vector<Place> inOrder;
};

void write(std::ostream& stream, const Places& places, const Task& task)
{
  if (task.forks.empty())
  {
    stream << task.stretches[0];
    return;
  }
  stream << "[" << task.stretches[0];
  for (std::size_t i = 0; i < task.forks.size(); ++i)
  {
    const Fork& fork = task.forks[i];
    stream << ",\n{\"place\": " << places.number(fork.place) << ", \"calls\": " << fork.calls
           << ", \"tasks\": ";
    const char* before = "[";
    for (const Task& child : fork.tasks)
    {
      stream << before;
      write(stream, places, child);
      before = ",";
    }
    stream << "]}, " << task.stretches[i + 1];
  }
  stream << "]";
}

}

void write(std::ostream& stream, const std::string& what, int threads, const Task& run)
{
  const Places places(run);
  stream << "{\"what\": " << quoted(what) << ", \"threads\": " << threads << ", \"places\": ";
  places.write(stream);
  stream << ",\n\"run\": ";
  write(stream, places, run);
  stream << "}\n";
}

}
