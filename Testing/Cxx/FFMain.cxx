// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
// Runs the tests of the filters that are named, or all, one after the other in one process. It
// prints the name of each before its messages.
#include "FFTest.h"

#include <cstdlib>
#include <map>

#define FF_TEST(name) int name(int, char*[]);
#include "FFTests.inc"
#undef FF_TEST

int main(int argc, char* argv[])
{
  const std::map<std::string, int (*)(int, char*[])> tests{
#define FF_TEST(name) { #name, name },
#include "FFTests.inc"
#undef FF_TEST
  };
  std::vector<std::string> names(argv + 1, argv + argc);
  for (auto test = tests.begin(); argc == 1 && test != tests.end(); ++test)
  {
    names.push_back(test->first);
  }
  std::vector<std::string> failed;
  for (const std::string& name : names)
  {
    const auto test = tests.find(name);
    if (test == tests.end())
    {
      std::cerr << "there is no test " << name << "\n";
      return EXIT_FAILURE;
    }
    std::cout << name << std::endl;
    fftest::failures() = 0;
    if (test->second(argc, argv) != EXIT_SUCCESS)
    {
      failed.push_back(name);
    }
  }
  for (const std::string& name : failed)
  {
    std::cerr << "FAILED: " << name << "\n";
  }
  return failed.empty() ? EXIT_SUCCESS : EXIT_FAILURE;
}
