// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Feeds a fuzzer's entry, with any compiler, as an ordinary test: files, or random bytes.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace
{

bool feed(const std::filesystem::path& path)
{
  std::ifstream file(path, std::ios::binary);
  const std::vector<char> bytes{ std::istreambuf_iterator<char>(file), {} };
  if (!file)
  {
    std::cerr << path << " cannot be read\n";
    return false;
  }
  // Before the run: what it ends with is then the culprit.
  std::cout << path.filename().string() << std::endl;
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  return true;
}

/// So many inputs, each by a seed of its own, from this one on.
int feedRandom(std::uint64_t count, std::uint64_t seed)
{
  for (std::uint64_t i = 0; i < count; ++i)
  {
    std::cout << "seed " << seed + i << std::endl; // before the run, as above
    std::mt19937_64 random(seed + i);
    std::vector<std::uint8_t> bytes(64 + random() % 1024);
    std::generate(bytes.begin(), bytes.end(), [&] { return static_cast<std::uint8_t>(random()); });
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
  }
  return 0;
}

}

/// @param argv files, and folders of files; or --random, how many, and the first seed
int main(int argc, char* argv[])
{
  if (argc == 4 && argv[1] == std::string("--random"))
  {
    return feedRandom(std::strtoull(argv[2], nullptr, 10), std::strtoull(argv[3], nullptr, 10));
  }
  std::vector<std::filesystem::path> paths;
  for (int i = 1; i < argc; ++i)
  {
    if (!std::filesystem::is_directory(argv[i]))
    {
      paths.emplace_back(argv[i]);
      continue;
    }
    for (const auto& entry : std::filesystem::directory_iterator(argv[i]))
    {
      paths.push_back(entry.path());
    }
  }
  std::sort(paths.begin(), paths.end());
  if (paths.empty())
  {
    std::cerr << "usage: replay FILE|FOLDER... | --random COUNT SEED: there is no input\n";
    return 2;
  }
  return std::all_of(paths.begin(), paths.end(), feed) ? 0 : 1;
}
