// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A part that is made when it is first requested, by whichever thread is first.
#ifndef flipflop_Lazy_h
#define flipflop_Lazy_h

#include <memory>
#include <mutex>

namespace flipflop
{

template <class T>
class Lazy
{
public:
  /// @param make std::unique_ptr<T> (); what it throws comes out, and the next call makes it again
  template <class Make>
  const T& get(const Make& make) const
  {
    const std::lock_guard<std::mutex> lock(this->mutex);
    if (!this->part)
    {
      this->part = make();
    }
    return *this->part;
  }

private:
  mutable std::mutex mutex;
  mutable std::unique_ptr<const T> part;
};

}

#endif
