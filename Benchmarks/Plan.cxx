// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Plan.h"

#include "ShapesInUse.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace flipflop
{
namespace
{

std::vector<std::string> split(const std::string& text)
{
  std::vector<std::string> parts;
  std::size_t begin = 0;
  while (begin <= text.size())
  {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    if (end == begin)
    {
      throw std::invalid_argument("an empty entry in: " + text);
    }
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
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
    used = text.size() + 1;
  }
  if (used != text.size() || !(value >= least && value <= most))
  {
    throw std::invalid_argument("not a number in its range: " + text);
  }
  return value;
}

std::vector<Distribution> distributions(const std::string& text, Family family)
{
  std::vector<Distribution> result;
  for (const std::string& part : split(text))
  {
    if (part == "in-use")
    {
      const std::vector<Distribution> all = distributionsInUse(family);
      result.insert(result.end(), all.begin(), all.end());
      continue;
    }
    result.push_back(Distribution::parse(part, family));
  }
  return result;
}

std::vector<std::int64_t> sizes(const std::string& text)
{
  std::vector<std::int64_t> result;
  for (const std::string& part : split(text))
  {
    result.push_back(std::llround(number(part, 8, 2e9)));
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<int> threads(const std::string& text)
{
  std::vector<int> result;
  for (const std::string& part : split(text))
  {
    result.push_back(static_cast<int>(number(part, 1, 4096)));
  }
  return result;
}

std::vector<Peer> peers(const std::string& text, const Suite& suite)
{
  std::vector<Peer> result;
  for (const std::string& part : split(text))
  {
    const Peer* peer = suite.find(part);
    if (!peer && part != "none")
    {
      throw std::invalid_argument("unknown peer: " + part);
    }
    if (peer)
    {
      result.push_back(*peer);
    }
  }
  return result;
}

std::string joined(const std::vector<std::string>& names, const char* between)
{
  std::string result;
  for (const std::string& name : names)
  {
    result += (result.empty() ? "" : between) + name;
  }
  return result;
}

/// In lines as wide as the usage's.
std::string wrapped(const std::vector<std::string>& names)
{
  const std::string begin = "\n" + std::string(26, ' ');
  std::string result;
  std::size_t width = 0;
  for (const std::string& name : names)
  {
    width += name.size() + 2;
    const bool full = width > 74;
    result += result.empty() ? name : (full ? "," + begin : ", ") + name;
    width = full ? name.size() + 2 : width;
  }
  return result;
}

std::string peerNames(const Suite& suite, const char* between)
{
  std::vector<std::string> names;
  for (const Peer& peer : suite.peers)
  {
    names.push_back(peer.name);
  }
  return joined(names, between);
}

}

Plan Plan::parse(const Suite& suite, int argc, const char* const* argv)
{
  Plan plan;
  plan.distributions = flipflop::distributions(suite.distributions, suite.family);
  plan.peers = suite.peers;
  plan.sizes = { 100000, 1000000, 10000000 };
  for (int i = 1; i < argc; ++i)
  {
    std::string option = argv[i];
    if (option == "--help" || option == "-h")
    {
      plan.help = true;
      continue;
    }
    if (option == "--validate")
    {
      plan.validate = true;
      continue;
    }
    std::string value;
    const std::size_t equals = option.find('=');
    if (equals != std::string::npos)
    {
      value = option.substr(equals + 1);
      option.resize(equals);
    }
    else if (i + 1 < argc)
    {
      value = argv[++i];
    }
    if (value.empty())
    {
      throw std::invalid_argument("unknown option, or one without its value: " + option);
    }
    if (option == "--distributions")
    {
      plan.distributions = flipflop::distributions(value, suite.family);
    }
    else if (option == "--sizes")
    {
      plan.sizes = flipflop::sizes(value);
    }
    else if (option == "--threads")
    {
      plan.threads = flipflop::threads(value);
    }
    else if (option == "--peers")
    {
      plan.peers = flipflop::peers(value, suite);
    }
    else if (option == "--repetitions")
    {
      plan.repetitions = static_cast<int>(number(value, 1, 1000));
    }
    else if (option == "--max-peer-seconds")
    {
      plan.maxPeerSeconds = number(value, 0, 1e6);
    }
    else if (option == "--max-case-seconds")
    {
      plan.maxCaseSeconds = number(value, 0, 1e6);
    }
    else if (option == "--seed")
    {
      plan.seed = static_cast<std::uint64_t>(number(value, 0, 0x1p53));
    }
    else if (option == "--csv")
    {
      plan.csv = value;
    }
    else if (option == "--json")
    {
      plan.json = value;
    }
    else
    {
      throw std::invalid_argument("unknown option: " + option);
    }
  }
  return plan;
}

std::string Plan::usage(const Suite& suite)
{
  return suite.program + ": " + suite.what + R"(, side by side

  --distributions LIST    )" +
    suite.distributionHelp + R"(
                          and the shapes in use, of ShapesInUse.h; also shuffled
                          (NAME-shuffled), and all of them by one word (in-use):
                          )" +
    wrapped(shapesInUse(suite.family == Family::Space)) + R"(
  --sizes LIST            numbers of points (1e5,1e6,1e7)
  --threads LIST          thread counts to run FlipFlop with (1,2)
  --peers LIST            of )" +
    peerNames(suite, ", ") + "; or none (" + peerNames(suite, ",") + R"()
  --repetitions N         rounds of each case; a round runs every contender once (5)
  --max-peer-seconds S    end a peer's run after so long, and skip the peer at a size where its time
                          at the size before lets expect more; 0: no limit (120)
  --max-case-seconds S    begin no further round of a case after so long, judging left out;
                          0: no limit (0)
  --seed N                of the random points (2013)
  --validate              judge every result exactly, outside the clock: FlipFlop's, and peers'
                          that have a judge
  --csv FILE, --json FILE write the results
  --help                  this text

Each run is a process of its own that holds the input in memory before the clock starts; the clock
stops at the complete result. Ratios are taken round by round, then their median.
)";
}

}
