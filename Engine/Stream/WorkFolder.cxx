// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Stream/WorkFolder.h"

#include "Blocks/MessageArchive.h"
#include "Support/ByteHash.h"
#include "Support/StrictArithmetic.h"

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

namespace flipflop
{

namespace
{

namespace fs = std::filesystem;

/// What files begin with, as text; and the digit behind it, their version's.
constexpr std::uint64_t Name = 0x776f6c66504c46;
constexpr std::uint64_t Magic = Name | ('0' + ArchiveVersion) << 56;

/// What files of a run end with, so that no other is touched; and those that are being written.
const std::string Suffix = ".flipflop";
const std::string Unfinished = Suffix + ".part";

bool endsWith(const std::string& name, const std::string& end)
{
  return name.size() >= end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
}

[[noreturn]] void fail(const char* what, const fs::path& path)
{
  const int number = errno != 0 ? errno : EIO;
  throw fs::filesystem_error(what, path, std::error_code(number, std::generic_category()));
}

void require(bool isGood, const char* what, const fs::path& path)
{
  if (!isGood)
  {
    throw fs::filesystem_error(what, path, std::make_error_code(std::errc::io_error));
  }
}

/// Its machine may have stopped before the system had written it.
void requireWhole(bool isWhole, const fs::path& path)
{
  require(isWhole, "a file of a streamed run is damaged: remove its folder", path);
}

/// What a file begins with.
struct Head
{
  std::uint64_t magic;
  std::uint64_t sections;
  std::uint64_t hash; ///< of the sections' list
};

void step()
{
  if (beforeFileStep())
  {
    beforeFileStep()();
  }
}

void put(std::ofstream& file, const void* bytes, std::size_t size, const fs::path& path)
{
  step();
  errno = 0;
  if (size > 0 && !file.write(static_cast<const char*>(bytes), static_cast<std::streamsize>(size)))
  {
    fail("cannot write a file", path);
  }
}

}

std::string nameOf(const std::string& prefix, std::int64_t number)
{
  return prefix + std::to_string(number);
}

const FileSection* sectionOf(const FileSections& sections, std::int64_t key)
{
  const auto found = std::lower_bound(sections.begin(), sections.end(), key,
    [](const FileSection& section, std::int64_t wanted) { return section.key < wanted; });
  return found != sections.end() && found->key == key ? &*found : nullptr;
}

WorkFolder::WorkFolder(fs::path folder)
  : path(std::move(folder))
{
  fs::create_directories(this->path);
  this->removeEach(Unfinished);
}

fs::path WorkFolder::fileOf(const std::string& name) const
{
  return this->path / (name + Suffix);
}

void WorkFolder::requireAll(bool areThere, const std::string& names) const
{
  if (!areThere)
  {
    throw fs::filesystem_error("files of a streamed run are missing: remove their folder",
      this->fileOf(names), std::make_error_code(std::errc::no_such_file_or_directory));
  }
}

bool WorkFolder::has(const std::string& name) const
{
  return fs::exists(this->fileOf(name));
}

std::map<std::int64_t, std::string> WorkFolder::numbered(const std::string& prefix) const
{
  std::map<std::int64_t, std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(this->path))
  {
    std::string name = entry.path().filename().string();
    if (endsWith(name, Suffix) && name.compare(0, prefix.size(), prefix) == 0)
    {
      name.resize(name.size() - Suffix.size());
      names.emplace(std::stoll(name.substr(prefix.size())), name);
    }
  }
  return names;
}

void WorkFolder::write(
  const std::string& name, const std::map<std::int64_t, std::vector<char>>& sections)
{
  FileSections list;
  std::uint64_t offset = sizeof(Head) + sections.size() * sizeof(FileSection);
  for (const auto& [key, bytes] : sections)
  {
    list.push_back({ key, offset, bytes.size(), byteHash(bytes.data(), bytes.size()) });
    offset += bytes.size();
  }
  const std::size_t listSize = list.size() * sizeof(FileSection);
  const Head head{ Magic, list.size(), byteHash(list.data(), listSize) };

  const fs::path part = this->path / (name + Unfinished);
  try
  {
    errno = 0;
    std::ofstream file(part, std::ios::binary | std::ios::trunc);
    if (!file)
    {
      fail("cannot make a file", part);
    }
    put(file, &head, sizeof(head), part);
    put(file, list.data(), listSize, part);
    for (const auto& section : sections)
    {
      put(file, section.second.data(), section.second.size(), part);
    }
    file.close();
    if (!file)
    {
      fail("cannot write a file", part);
    }
    step();
    fs::rename(part, this->fileOf(name));
  }
  catch (...)
  {
    std::error_code ignored;
    fs::remove(part, ignored);
    throw;
  }
  this->written += static_cast<std::int64_t>(offset);
}

std::ifstream WorkFolder::open(const fs::path& file) const
{
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
  {
    fail("cannot read a file", file);
  }
  return stream;
}

void WorkFolder::take(
  std::ifstream& file, const fs::path& from, std::uint64_t offset, std::size_t size, char* to) const
{
  errno = 0;
  file.seekg(static_cast<std::streamoff>(offset));
  if (size > 0 && !file.read(to, static_cast<std::streamsize>(size)))
  {
    requireWhole(!file.eof(), from); // it was longer
    fail("cannot read a file", from);
  }
  this->taken += static_cast<std::int64_t>(size);
}

void WorkFolder::write(const std::string& name, std::vector<char>&& onlySection)
{
  std::map<std::int64_t, std::vector<char>> sections;
  sections.emplace(0, std::move(onlySection));
  this->write(name, sections);
}

FileSections WorkFolder::sections(const std::string& name) const
{
  const fs::path from = this->fileOf(name);
  std::ifstream file = this->open(from);
  Head head;
  this->take(file, from, 0, sizeof(head), reinterpret_cast<char*>(&head));
  require(head.magic == Magic || head.magic << 8 != Name << 8,
    "a file of a streamed run is of another version: remove its folder", from);
  requireWhole(
    head.magic == Magic && head.sections <= fs::file_size(from) / sizeof(FileSection), from);
  FileSections list(static_cast<std::size_t>(head.sections));
  const std::size_t size = list.size() * sizeof(FileSection);
  this->take(file, from, sizeof(head), size, reinterpret_cast<char*>(list.data()));
  requireWhole(head.hash == byteHash(list.data(), size), from);
  return list;
}

std::vector<char> WorkFolder::read(const std::string& name, const FileSection& section) const
{
  const fs::path from = this->fileOf(name);
  std::ifstream file = this->open(from);
  std::vector<char> bytes(static_cast<std::size_t>(section.size));
  this->take(file, from, section.offset, bytes.size(), bytes.data());
  requireWhole(section.hash == byteHash(bytes.data(), bytes.size()), from);
  return bytes;
}

std::vector<char> WorkFolder::read(const std::string& name, std::int64_t key) const
{
  const FileSections list = this->sections(name);
  const FileSection* const found = sectionOf(list, key);
  requireWhole(found != nullptr, this->fileOf(name));
  return this->read(name, *found);
}

WorkFolder::Rows::Rows(
  const WorkFolder& inFolder, const std::string& name, const FileSection& ofRows)
  : folder(inFolder)
  , path(inFolder.fileOf(name))
  , section(ofRows)
  , file(inFolder.open(this->path))
{
}

void WorkFolder::Rows::read(std::size_t row, std::size_t size, char* to)
{
  ensure((row + 1) * size <= this->section.size);
  this->folder.take(this->file, this->path, this->section.offset + row * size, size, to);
}

void WorkFolder::remove(const std::string& name)
{
  fs::remove(this->fileOf(name));
}

void WorkFolder::removeNumbered(const std::string& prefix)
{
  for (const auto& file : this->numbered(prefix))
  {
    this->remove(file.second);
  }
}

void WorkFolder::removeFiles()
{
  this->removeEach(Suffix);
}

void WorkFolder::removeAll()
{
  this->removeFiles();
  if (fs::is_empty(this->path))
  {
    fs::remove(this->path);
  }
}

void WorkFolder::removeEach(const std::string& suffix)
{
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(this->path))
  {
    if (endsWith(entry.path().filename().string(), suffix))
    {
      files.push_back(entry.path());
    }
  }
  for (const fs::path& file : files)
  {
    fs::remove(file);
  }
}

}
