// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Files of a run whose process may end at any time: each is whole or absent, and what is read is
/// what was written, apart from single rows.
#ifndef flipflop_WorkFolder_h
#define flipflop_WorkFolder_h

#include <flipflop/Error.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace flipflop
{

/// A file's name.
std::string nameOf(const std::string& prefix, std::int64_t number);

/// Part of a file.
struct FileSection
{
  std::int64_t key = 0;
  std::uint64_t offset = 0;
  std::uint64_t size = 0;
  std::uint64_t hash = 0;
};

/// The sections of a file, ascending by key.
using FileSections = std::vector<FileSection>;

/// The section of that key; null if there is none.
const FileSection* sectionOf(const FileSections& sections, std::int64_t key);

class WorkFolder
{
public:
  /// Made if it is not there. A file that was not whole is removed.
  /// @throw std::filesystem::filesystem_error as all functions do
  explicit WorkFolder(std::filesystem::path folder);

  bool has(const std::string& name) const;

  /// An error if files that a run goes on with are missing. None goes but by other hands.
  /// @param names of these files, which may have a * in it
  void requireAll(bool areThere, const std::string& names) const;

  /// The names of all files that begin so, by the number that follows.
  std::map<std::int64_t, std::string> numbered(const std::string& prefix) const;

  /// Write a file, or replace it.
  void write(const std::string& name, const std::map<std::int64_t, std::vector<char>>& sections);
  void write(const std::string& name, std::vector<char>&& onlySection);

  /// A file that is damaged is an error, too.
  FileSections sections(const std::string& name) const;
  std::vector<char> read(const std::string& name, const FileSection& section) const;
  std::vector<char> read(const std::string& name, std::int64_t key = 0) const;

  /// Reads rows of a section; these are not checked.
  class Rows
  {
  public:
    Rows(const WorkFolder& folder, const std::string& name, const FileSection& section);
    void read(std::size_t row, std::size_t size, char* to);

  private:
    const WorkFolder& folder;
    const std::filesystem::path path;
    const FileSection section;
    std::ifstream file;
  };

  void remove(const std::string& name);
  void removeNumbered(const std::string& prefix);

  /// All files.
  void removeFiles();

  /// All files; and the folder, if nothing else is in it.
  void removeAll();

  std::int64_t bytesWritten() const { return this->written; }
  std::int64_t bytesRead() const { return this->taken; }

private:
  std::filesystem::path fileOf(const std::string& name) const;
  void removeEach(const std::string& suffix);
  std::ifstream open(const std::filesystem::path& path) const;
  void take(std::ifstream& file, const std::filesystem::path& path, std::uint64_t offset,
    std::size_t size, char* to) const;

  const std::filesystem::path path;
  std::atomic<std::int64_t> written{ 0 };
  mutable std::atomic<std::int64_t> taken{ 0 };
};

/// Called before each write to a file and each renaming of one. Tests let it throw.
inline std::function<void()>& beforeFileStep()
{
  static std::function<void()> function;
  return function;
}

}

#endif
