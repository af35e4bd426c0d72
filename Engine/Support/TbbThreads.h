// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The threads that Parallel.h requests, by oneTBB. Its headers are TbbThreads.cxx's alone: they
/// take half a second to compile, and nearly every source has loops.
#ifndef flipflop_TbbThreads_h
#define flipflop_TbbThreads_h

#include "Support/SortByHalves.h"

#include <cstddef>
#include <functional>
#include <memory>

namespace flipflop
{

namespace tbbThreads
{

/// One of a single thread is no arena of oneTBB's: its loops are plain ones. So runs on one thread
/// do not start oneTBB, which takes half a millisecond.
class Arena
{
public:
  explicit Arena(int threads);
  ~Arena();

  template <class Body>
  void execute(Body&& body)
  {
    this->run(std::ref(body));
  }

private:
  void run(const std::function<void()>& body);

  struct Inner;
  const std::unique_ptr<Inner> inner;
};

int allowed();

class Allowance
{
public:
  explicit Allowance(int threads);
  ~Allowance();

private:
  struct Inner;
  const std::unique_ptr<Inner> inner;
};

void forEach(std::size_t count, const std::function<void(std::size_t)>& body);
void forEachAlone(std::size_t count, const std::function<void(std::size_t)>& body);
void isolate(const std::function<void()>& body);
void invokeBoth(const std::function<void()>& first, const std::function<void()>& second);

template <class Body>
void each(std::size_t count, const Body& body)
{
  forEach(count, std::cref(body));
}

template <class Body>
void eachAlone(std::size_t count, const Body& body)
{
  forEachAlone(count, std::cref(body));
}

template <class Body>
void isolated(const Body& body)
{
  isolate(std::cref(body));
}

template <class First, class Second>
void invoke(const First& first, const Second& second)
{
  invokeBoth(std::cref(first), std::cref(second));
}

template <class Iterator, class Less>
void sort(Iterator first, Iterator last, const Less& less)
{
  sortByHalves(
    first, last, less, [](const auto& low, const auto& high) { tbbThreads::invoke(low, high); });
}

}

namespace threads = tbbThreads;

}

#endif
