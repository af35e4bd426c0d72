// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The files of a vtkFFStreamedWriter.
 *
 * Each file is whole or absent. All functions throw std::filesystem::filesystem_error.
 */

#ifndef FFStreamedFiles_h
#define FFStreamedFiles_h

#include "vtkFFMarks.h"

#include <flipflop/StreamedRun.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;

/**
 * What is written: a file, and a folder of blocks beside it.
 */
class FFStreamedFiles
{
public:
  /**
   * @throw FFBadSetting for a name without its ending
   */
  explicit FFStreamedFiles(const char* fileName);

  const std::filesystem::path& GetFile() const { return this->File; }

  ///@{
  /**
   * Paths as VTK writes them, in UTF-8.
   */
  static std::string ToText(const std::filesystem::path& path);
  static std::filesystem::path ToPath(const std::string& text);
  ///@}

  /**
   * Write a block. The file that lists the blocks of an earlier writing is removed before.
   */
  void WriteBlock(std::int64_t block, vtkPolyData* data) const;

  /**
   * Write the file that lists so many blocks, and remove further ones of an earlier writing.
   */
  void WriteList(std::int64_t blocks) const;

private:
  std::filesystem::path GetBlock(std::int64_t block) const;
  void RemoveBlocks(std::int64_t begin) const;

  std::filesystem::path File;
  std::filesystem::path Folder;
};

/**
 * The folder where points wait, with a list of the pieces that were taken: what the points were
 * when a run that was stopped goes on.
 */
class FFWorkFolder
{
public:
  /**
   * @param name none: beside the file
   */
  FFWorkFolder(const char* name, const FFStreamedFiles& files);

  const std::filesystem::path& GetPath() const { return this->Folder; }

  /**
   * Go on with what is in the folder, if it is of these settings and pieces; otherwise, empty it.
   *
   * @param read gives a piece again
   * @throw FFBadSetting where files of others are in it; whatever @p read throws
   */
  void Begin(const std::string& settings,
    const std::function<flipflop::StreamPiece(std::int64_t piece)>& read);

  /**
   * List a piece, which is not stored yet.
   */
  void Add(std::int64_t number, const flipflop::StreamPiece& piece);

  /**
   * Remove the folder.
   */
  void Finish() const;

private:
  static std::string HashOf(const flipflop::StreamPiece& piece);

  std::filesystem::path Folder;
  std::filesystem::path List; // a line with a hash of the settings, and one of each piece
  std::int64_t Listed = 0;    // pieces
};
VTK_ABI_NAMESPACE_END

#endif
