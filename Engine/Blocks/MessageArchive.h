// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Values as the bytes of messages, of saved blocks and of files, and values of such bytes.
///
/// An archive writes, or reads, values in a row: plain values as they are in memory; vectors; and
/// objects of classes that list their members, once for both directions:
///
///     template <class Self, class Archive>
///     static void visit(Self& self, Archive& archive)
///     {
///       archive(self.first, self.second);
///       if constexpr (Archive::IsReader) { ... }  // what follows from them
///     }
#ifndef flipflop_MessageArchive_h
#define flipflop_MessageArchive_h

#include "Support/ByteHash.h"
#include <flipflop/BlockRun.h>
#include <flipflop/Error.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

namespace flipflop
{

class MessageWriter
{
public:
  static constexpr bool IsReader = false;

  template <class... Values>
  void operator()(const Values&... values)
  {
    (this->add(values), ...);
  }

  BlockMessage message;

private:
  void addBytes(const void* bytes, std::size_t size)
  {
    const auto* const begin = static_cast<const char*>(bytes);
    this->message.insert(this->message.end(), begin, begin + size);
  }

  template <class Value>
  void add(const Value& value)
  {
    if constexpr (std::is_trivially_copyable_v<Value>)
    {
      this->addBytes(&value, sizeof(Value));
    }
    else
    {
      Value::visit(value, *this);
    }
  }

  template <class Value>
  void add(const std::vector<Value>& values)
  {
    this->add(values.size());
    if constexpr (std::is_trivially_copyable_v<Value>)
    {
      this->addBytes(values.data(), values.size() * sizeof(Value));
    }
    else
    {
      for (const Value& value : values)
      {
        this->add(value);
      }
    }
  }
};

/// Takes nothing for granted: a message may be damaged. All throw Error Internal if it ends before.
class MessageReader
{
public:
  static constexpr bool IsReader = true;

  explicit MessageReader(const BlockMessage& message)
    : MessageReader(message.data(), message.size())
  {
  }
  MessageReader(const char* bytes, std::size_t size)
    : next(bytes)
    , remaining(size)
  {
  }

  template <class... Values>
  void operator()(Values&... values)
  {
    (this->read(values), ...);
  }

  bool atEnd() const { return this->remaining == 0; }

private:
  void readBytes(void* to, std::size_t size)
  {
    ensure(size <= this->remaining);
    if (size > 0)
    {
      std::memcpy(to, this->next, size);
    }
    this->next += size;
    this->remaining -= size;
  }

  template <class Value>
  void read(Value& value)
  {
    if constexpr (std::is_trivially_copyable_v<Value>)
    {
      this->readBytes(&value, sizeof(Value));
    }
    else
    {
      Value::visit(value, *this);
    }
  }

  template <class Value>
  void read(std::vector<Value>& values)
  {
    std::size_t count = 0;
    this->read(count);
    values.clear();
    if constexpr (std::is_trivially_copyable_v<Value>)
    {
      ensure(count <= this->remaining / sizeof(Value));
      values.resize(count);
      this->readBytes(static_cast<void*>(values.data()), count * sizeof(Value));
    }
    else
    {
      for (; count > 0; --count)
      {
        this->read(values.emplace_back());
      }
    }
  }

  const char* next;
  std::size_t remaining;
};

template <class... Values>
BlockMessage toBytes(const Values&... values)
{
  MessageWriter writer;
  writer(values...);
  return std::move(writer.message);
}

/// All that the message has.
/// @throw Error Internal if it is damaged
template <class... Values>
void fromBytes(const BlockMessage& message, Values&... values)
{
  MessageReader reader(message);
  reader(values...);
  ensure(reader.atEnd());
}

template <class Value>
Value valueOf(const BlockMessage& message)
{
  Value value;
  fromBytes(message, value);
  return value;
}

/// Of what visit() functions list. Saved blocks and files of another version are refused.
constexpr std::uint64_t ArchiveVersion = 2;

/// With a hash behind it, by which hashedBytes() finds that a byte has changed.
inline BlockMessage withHash(BlockMessage&& message)
{
  const std::uint64_t hash = byteHash(message.data(), message.size(), ArchiveVersion);
  const auto* const bytes = reinterpret_cast<const char*>(&hash);
  message.insert(message.end(), bytes, bytes + sizeof(hash));
  return std::move(message);
}

/// Reads what comes before the hash.
/// @throw Error Internal if a byte has changed, or the version is another
inline MessageReader hashedBytes(const BlockMessage& message)
{
  std::uint64_t hash;
  ensure(message.size() >= sizeof(hash));
  const std::size_t size = message.size() - sizeof(hash);
  std::memcpy(&hash, message.data() + size, sizeof(hash));
  ensure(hash == byteHash(message.data(), size, ArchiveVersion));
  return { message.data(), size };
}

}

#endif
