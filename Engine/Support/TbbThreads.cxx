// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/TbbThreads.h"

#include "Support/FloatingPointEnvironment.h"
#include <flipflop/Error.h>

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <utility>

namespace flipflop
{

namespace tbbThreads
{

namespace
{

/// Is this thread in an arena of one thread?
bool& isAlone()
{
  thread_local bool alone = false;
  return alone;
}

class Enter
{
public:
  explicit Enter(bool alone)
    : before(std::exchange(isAlone(), alone))
  {
  }
  Enter(const Enter&) = delete;
  Enter& operator=(const Enter&) = delete;
  ~Enter() { isAlone() = this->before; }

private:
  const bool before;
};

/// Of a loop whose tasks have the floating-point environment of the thread that calls it. By
/// default they have that of the thread that first used the arena.
class LoopContext
{
public:
  /// @throw Error Aborted: the loop is within another one of which a task threw. oneTBB then leaves
  ///        out the tasks that have not begun, and says nothing here. The other's exception is what
  ///        its caller gets.
  void checkComplete()
  {
    if (this->context.is_group_execution_cancelled())
    {
      throw Error(ErrorCode::Aborted);
    }
  }

  tbb::task_group_context context{ tbb::task_group_context::bound,
    tbb::task_group_context::default_traits | tbb::task_group_context::fp_settings };
};

/// @return false: this thread is not alone
bool loopAlone(std::size_t count, const std::function<void(std::size_t)>& body)
{
  for (std::size_t i = 0; isAlone() && i < count; ++i)
  {
    body(i);
  }
  return isAlone();
}

}

struct Arena::Inner
{
  tbb::task_arena arena;
};

Arena::Arena(int threads)
  : inner(threads == 1 ? nullptr : new Inner{ tbb::task_arena(threads) })
{
}

Arena::~Arena() = default;

void Arena::run(const std::function<void()>& body)
{
  if (!this->inner)
  {
    const Enter enter(true);
    body();
    return;
  }
  this->inner->arena.execute(
    [&body]
    {
      const Enter enter(false);
      // oneTBB sets that of the thread that first used the arena.
      const DefaultFloatingPointEnvironment environment;
      body();
    });
}

int allowed()
{
  return static_cast<int>(
    tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

struct Allowance::Inner
{
  explicit Inner(int threads)
    : control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads))
  {
  }

  tbb::global_control control;
};

Allowance::Allowance(int threads)
  : inner(new Inner(threads))
{
}

Allowance::~Allowance() = default;

void forEach(std::size_t count, const std::function<void(std::size_t)>& body)
{
  if (!loopAlone(count, body))
  {
    LoopContext loop;
    tbb::parallel_for(std::size_t(0), count, body, loop.context);
    loop.checkComplete();
  }
}

void forEachAlone(std::size_t count, const std::function<void(std::size_t)>& body)
{
  if (!loopAlone(count, body))
  {
    LoopContext loop;
    tbb::parallel_for(std::size_t(0), count, body, tbb::simple_partitioner(), loop.context);
    loop.checkComplete();
  }
}

void isolate(const std::function<void()>& body)
{
  tbb::this_task_arena::isolate(body);
}

void invokeBoth(const std::function<void()>& first, const std::function<void()>& second)
{
  if (isAlone())
  {
    first();
    second();
    return;
  }
  LoopContext loop;
  tbb::parallel_invoke(first, second, loop.context);
  loop.checkComplete();
}

}

}
