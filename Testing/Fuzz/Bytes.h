// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A fuzzer's input as a sequence of decisions.
#ifndef flipflop_fuzz_Bytes_h
#define flipflop_fuzz_Bytes_h

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace flipflop
{
namespace fuzz
{

/// Each draw takes bytes from the front; past the end every byte is 0. So any sequence of bytes is
/// an input, a shorter one is a simpler one, and the same bytes are always the same input.
class Bytes
{
public:
  Bytes(const std::uint8_t* data, std::size_t size)
    : Next(data)
    , End(data + size)
  {
  }

  bool empty() const { return this->Next == this->End; }

  std::uint8_t byte() { return this->empty() ? std::uint8_t(0) : *this->Next++; }

  /// 0 to @p count - 1, of at most 256.
  int below(int count) { return this->byte() % count; }

  /// True for one of so many, and never past the end.
  bool oneOf(int count) { return this->below(count) == count - 1; }

  bool flag() { return (this->byte() & 1) != 0; }

  /// The bits of a number of the type.
  template <class T>
  T raw()
  {
    std::uint8_t bytes[sizeof(T)];
    for (std::uint8_t& b : bytes)
    {
      b = this->byte();
    }
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return value;
  }

  /// An integer that is often small, now and then any.
  std::int64_t integer()
  {
    switch (this->below(8))
    {
      case 6:
        return this->raw<std::int32_t>();
      case 7:
        return this->raw<std::int64_t>();
      default:
        return this->raw<std::int8_t>();
    }
  }

  /// A number that is often a small integer, sometimes one with awkward bits or size, and now and
  /// then any 64 bits: NaN, infinite, denormal.
  double number();

private:
  const std::uint8_t* Next;
  const std::uint8_t* End;
};

}
}

#endif
