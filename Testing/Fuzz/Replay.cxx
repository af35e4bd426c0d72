// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Feeds files to a fuzzer's entry, with any compiler: the corpus as an ordinary test.
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
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

}

/// @param argv files, and folders of files
int main(int argc, char* argv[])
{
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
    std::cerr << "usage: replay FILE|FOLDER...: there is no input\n";
    return 2;
  }
  return std::all_of(paths.begin(), paths.end(), feed) ? 0 : 1;
}
