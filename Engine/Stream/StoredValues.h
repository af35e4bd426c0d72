// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Plain values as a file's bytes, and names of files.
#ifndef flipflop_StoredValues_h
#define flipflop_StoredValues_h

#include <flipflop/Error.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace flipflop
{

template <class Value>
std::vector<char> bytesOf(const Value* values, std::size_t count)
{
  std::vector<char> bytes(count * sizeof(Value));
  if (count > 0)
  {
    std::memcpy(bytes.data(), values, bytes.size());
  }
  return bytes;
}

template <class Value>
std::vector<Value> valuesOf(const std::vector<char>& bytes)
{
  ensure(bytes.size() % sizeof(Value) == 0);
  std::vector<Value> values(bytes.size() / sizeof(Value));
  if (!values.empty())
  {
    std::memcpy(static_cast<void*>(values.data()), bytes.data(), bytes.size());
  }
  return values;
}

template <class Value>
Value valueOf(const std::vector<char>& bytes)
{
  Value value;
  ensure(bytes.size() == sizeof(Value));
  std::memcpy(&value, bytes.data(), sizeof(Value));
  return value;
}

inline std::string nameOf(const std::string& prefix, std::int64_t number)
{
  return prefix + std::to_string(number);
}

}

#endif
