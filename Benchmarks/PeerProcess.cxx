// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PeerProcess.h"

#include <cstdlib>
#include <sstream>
#include <stdexcept>

#include <csignal>
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace flipflop
{
namespace
{

/// In the new process: become Python.
[[noreturn]] void becomePython(int commands, int replies, const std::vector<std::string>& arguments)
{
  // A parent that is killed at its limit runs no destructor.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  dup2(commands, STDIN_FILENO);
  dup2(replies, STDOUT_FILENO);
  const char* const named = std::getenv("FLIPFLOP_PEER_PYTHON");
  const char* const python = named ? named : "python3";
  std::vector<char*> words;
  const auto add = [&words](const char* word) { words.push_back(const_cast<char*>(word)); };
  add(python);
  add("-B");
  add(FLIPFLOP_PEERS_SCRIPT);
  for (const std::string& argument : arguments)
  {
    add(argument.c_str());
  }
  words.push_back(nullptr);
  execvp(python, words.data()); // returns if there is no such program
  _exit(127);
}

}

PeerProcess::PeerProcess(const std::vector<std::string>& arguments)
{
  int down[2];
  int up[2];
  if (pipe2(down, O_CLOEXEC) != 0 || pipe2(up, O_CLOEXEC) != 0)
  {
    throw std::runtime_error("no pipe to Python");
  }
  // Writing to one that has ended is an error like others.
  std::signal(SIGPIPE, SIG_IGN);
  this->process = fork();
  if (this->process < 0)
  {
    throw std::runtime_error("no process for Python");
  }
  if (this->process == 0)
  {
    becomePython(down[0], up[1], arguments);
  }
  close(down[0]);
  close(up[1]);
  this->commands = fdopen(down[1], "w");
  this->replies = fdopen(up[0], "r");
}

PeerProcess::~PeerProcess()
{
  std::fclose(this->commands);
  std::fclose(this->replies);
  waitpid(this->process, nullptr, 0);
}

void PeerProcess::setPoints(const Coordinates& xyz)
{
  this->write("points " + std::to_string(xyz.size() / 3), xyz.data(), xyz.size() * sizeof(double));
  const std::string line = this->readLine();
  if (line != "ready")
  {
    this->fail(line);
  }
}

PeerRun PeerProcess::run()
{
  this->write("run", nullptr, 0);
  const std::string line = this->readLine();
  std::istringstream words(line);
  std::string done;
  PeerRun result;
  std::size_t points = 0;
  std::size_t cells = 0;
  std::size_t corners = 0;
  PeerOutput& output = result.output;
  words >> done >> result.seconds >> result.peakBytes >> output.rounded >> points >> cells >>
    corners;
  if (!words || done != "done")
  {
    this->fail(line);
  }
  output.points.resize(3 * points);
  output.offsets.resize(cells + 1);
  output.connectivity.resize(corners);
  this->read(output.points.data(), output.points.size() * sizeof(double));
  this->read(output.offsets.data(), output.offsets.size() * sizeof(std::int64_t));
  this->read(output.connectivity.data(), output.connectivity.size() * sizeof(std::int64_t));
  return result;
}

std::string PeerProcess::readLine()
{
  std::string line;
  for (int c = std::fgetc(this->replies); c != '\n'; c = std::fgetc(this->replies))
  {
    if (c == EOF)
    {
      this->fail(line);
    }
    line += static_cast<char>(c);
  }
  return line;
}

void PeerProcess::write(const std::string& line, const void* data, std::size_t bytes)
{
  const std::string whole = line + "\n";
  if (std::fputs(whole.c_str(), this->commands) < 0 ||
    std::fwrite(data, 1, bytes, this->commands) != bytes || std::fflush(this->commands) != 0)
  {
    this->fail("");
  }
}

void PeerProcess::read(void* data, std::size_t bytes)
{
  if (std::fread(data, 1, bytes, this->replies) != bytes)
  {
    this->fail("");
  }
}

void PeerProcess::fail(const std::string& line)
{
  if (!line.empty())
  {
    throw std::runtime_error(line);
  }
  kill(this->process, SIGKILL);
  throw std::runtime_error("Python ended");
}

}
