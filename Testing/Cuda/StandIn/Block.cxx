// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Block.h"

#include "Memory.h"

#include <ucontext.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <random>
#include <vector>

#if defined(__SANITIZE_THREAD__)
#include <sanitizer/tsan_interface.h>
#endif

namespace standin
{

namespace
{

constexpr std::size_t StackBytes = std::size_t(1) << 18;

/// What ThreadSanitizer has to be told: threads of a block take turns here, but are not ordered by
/// that; only a barrier orders them.
class Sanitizer
{
public:
#if defined(__SANITIZE_THREAD__)
  static void* self()
  {
    return __tsan_get_current_fiber();
  }
  static void* create()
  {
    return __tsan_create_fiber(0);
  }
  static void destroy(void* fiber)
  {
    __tsan_destroy_fiber(fiber);
  }
  static void enter(void* fiber)
  {
    __tsan_switch_to_fiber(fiber, __tsan_switch_to_fiber_no_sync);
  }
  static void arrive(void* barrier)
  {
    __tsan_release(barrier);
  }
  static void leave(void* barrier)
  {
    __tsan_acquire(barrier);
  }
#else
  static void* self()
  {
    return nullptr;
  }
  static void* create()
  {
    return nullptr;
  }
  static void destroy(void*) {}
  static void enter(void*) {}
  static void arrive(void*) {}
  static void leave(void*) {}
#endif
};

class Block
{
public:
  Block(ptx::Kernel code, const void* const* given, unsigned block, unsigned blocks, unsigned count)
    : kernel(code)
    , arguments(given)
    , threads(count)
    , home(Sanitizer::self())
  {
    for (unsigned i = 0; i < count; ++i)
    {
      Thread& thread = this->threads[i];
      thread.launch = { block, blocks, i, count, &Block::wait };
      thread.stack.reset(new char[StackBytes]);
      thread.fiber = Sanitizer::create();
      require(getcontext(&thread.context) == 0, "a thread of a block");
      thread.context.uc_stack.ss_sp = thread.stack.get();
      thread.context.uc_stack.ss_size = StackBytes;
      thread.context.uc_link = nullptr;
      makecontext(&thread.context, &Block::start, 0);
    }
  }
  Block(const Block&) = delete;
  Block& operator=(const Block&) = delete;
  ~Block()
  {
    for (Thread& thread : this->threads)
    {
      Sanitizer::destroy(thread.fiber);
    }
  }

  void run(unsigned seed)
  {
    Block* const outer = current;
    current = this;
    std::mt19937 random(seed);
    std::vector<unsigned> order(this->threads.size());
    std::iota(order.begin(), order.end(), 0u);
    Sanitizer::arrive(this);
    while (!order.empty())
    {
      std::shuffle(order.begin(), order.end(), random);
      for (const unsigned i : order)
      {
        this->running = &this->threads[i];
        Sanitizer::enter(this->running->fiber);
        swapcontext(&this->main, &this->running->context);
      }
      // Those that have ended count as waiting at every barrier.
      order.erase(std::remove_if(order.begin(), order.end(),
                    [this](unsigned i) { return this->threads[i].ended; }),
        order.end());
    }
    Sanitizer::leave(this);
    current = outer;
  }

private:
  struct Thread
  {
    ptx::Launch launch{};
    std::unique_ptr<char[]> stack;
    ucontext_t context;
    void* fiber = nullptr;
    bool ended = false;
  };

  static void start()
  {
    Block& block = *current;
    Sanitizer::leave(&block);
    block.kernel(block.arguments, block.running->launch);
    block.running->ended = true;
    Sanitizer::arrive(&block);
    block.goHome();
  }

  static void wait()
  {
    Sanitizer::arrive(current);
    current->goHome();
    Sanitizer::leave(current);
  }

  void goHome()
  {
    Thread& thread = *this->running;
    Sanitizer::enter(this->home);
    swapcontext(&thread.context, &this->main);
  }

  static thread_local Block* current;

  ptx::Kernel kernel;
  const void* const* arguments;
  std::vector<Thread> threads;
  ucontext_t main;
  void* home;
  Thread* running = nullptr;
};

thread_local Block* Block::current = nullptr;

}

void runBlock(ptx::Kernel kernel, const void* const* arguments, unsigned block, unsigned blocks,
  unsigned threads, unsigned seed)
{
  Block(kernel, arguments, block, blocks, threads).run(seed);
}

}
