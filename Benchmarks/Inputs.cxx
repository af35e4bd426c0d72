// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Program.h"

#include "Testing/Engine/Inputs/InputsInUse.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include <sys/wait.h>
#include <unistd.h>

namespace flipflop
{
namespace
{

const std::string FilePrefix = "file:";

/// The head of what a process sends that makes an input.
struct Sent
{
  std::size_t numbers = 0, ends = 0, error = 0;
  bool isWeighted = false, hasCrossings = false;
};

template <class Scalar>
void readScalars(std::FILE* file, Coordinates& xyz)
{
  Scalar point[3];
  while (std::fread(point, sizeof(point), 1, file) == 1)
  {
    xyz.insert(xyz.end(), point, point + 3);
  }
}

/// In the plane z is left out.
Coordinates readPoints(const std::string& path, bool isPlane)
{
  const std::string ending = path.size() > 4 ? path.substr(path.size() - 4) : "";
  if (ending != ".f32" && ending != ".f64")
  {
    throw std::invalid_argument("neither .f32 nor .f64: " + path);
  }
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(
    std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file)
  {
    throw std::invalid_argument("cannot read " + path);
  }
  Coordinates xyz;
  ending == ".f32" ? readScalars<float>(file.get(), xyz) : readScalars<double>(file.get(), xyz);
  for (std::size_t i = 2; isPlane && i < xyz.size(); i += 3)
  {
    xyz[i] = 0;
  }
  return xyz;
}

}

Input makeInput(const std::string& family, bool isPlane, std::int64_t count, std::uint64_t seed)
{
  Input input;
  input.family = family;
  input.plannedCount = count;
  input.seed = seed;
  input.isPlane = isPlane;
  if (family.compare(0, FilePrefix.size(), FilePrefix) == 0)
  {
    input.xyz = readPoints(family.substr(FilePrefix.size()), isPlane);
    return input;
  }
  const test::Cloud cloud = test::makeCloud(family, isPlane, static_cast<int>(count), seed);
  input.xyz.reserve(3 * cloud.size());
  for (const test::Point& p : cloud)
  {
    input.xyz.insert(input.xyz.end(), p.begin(), p.end());
    input.isWeighted = input.isWeighted || (isPlane && p[2] != 0);
  }
  return input;
}

Input makeApart(const std::function<Input()>& make)
{
  int ends[2];
  if (pipe(ends) != 0)
  {
    throw std::runtime_error("no pipe");
  }
  std::fflush(nullptr);
  const pid_t process = fork();
  const auto open = [&](const char* mode) { return fdopen(ends[*mode == 'w' ? 1 : 0], mode); };
  if (process == 0)
  {
    close(ends[0]);
    std::FILE* const file = open("w");
    Sent sent;
    std::string error;
    Input input;
    try
    {
      input = make();
      sent = { input.xyz.size(), input.ends.size(), 0, input.isWeighted, input.hasCrossings };
    }
    catch (const std::exception& problem)
    {
      error = problem.what();
      sent.error = error.size();
    }
    std::fwrite(&sent, sizeof(sent), 1, file);
    std::fwrite(error.data(), 1, error.size(), file);
    std::fwrite(input.xyz.data(), sizeof(double), sent.numbers, file);
    std::fwrite(input.ends.data(), sizeof(std::int64_t), sent.ends, file);
    std::fclose(file);
    _exit(0);
  }
  close(ends[1]);
  std::FILE* const file = open("r");
  Sent sent;
  Input input;
  std::string error = "no process makes the input";
  bool isRead = process > 0 && std::fread(&sent, sizeof(sent), 1, file) == 1;
  if (isRead)
  {
    input.xyz.resize(sent.numbers);
    input.ends.resize(sent.ends);
    error.resize(sent.error);
    isRead = std::fread(&error[0], 1, sent.error, file) == sent.error &&
      std::fread(input.xyz.data(), sizeof(double), sent.numbers, file) == sent.numbers &&
      std::fread(input.ends.data(), sizeof(std::int64_t), sent.ends, file) == sent.ends;
  }
  std::fclose(file);
  waitpid(process, nullptr, 0);
  if (!isRead || !error.empty())
  {
    throw std::invalid_argument(error);
  }
  input.isWeighted = sent.isWeighted;
  input.hasCrossings = sent.hasCrossings;
  return input;
}

}
