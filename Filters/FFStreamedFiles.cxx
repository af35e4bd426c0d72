// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FFStreamedFiles.h"

#include "FFRun.h"

#include "Support/ByteHash.h"

#include "vtkCallbackCommand.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLPolyDataWriter.h"

#include <cerrno>
#include <fstream>
#include <system_error>

VTK_ABI_NAMESPACE_BEGIN
namespace fs = std::filesystem;

namespace
{

constexpr const char* ending = ".vtpd";
constexpr const char* unfinished = ".part";

[[noreturn]] void fail(int number, const fs::path& path)
{
  throw fs::filesystem_error(
    "", path, std::error_code(number != 0 ? number : EIO, std::generic_category()));
}

/// Has @p write make a file, which is there in the end, whole, or not at all.
void writeWhole(const fs::path& file, const std::function<void(const fs::path&)>& write)
{
  fs::path part = file;
  part += unfinished;
  try
  {
    write(part);
    fs::rename(part, file);
  }
  catch (...)
  {
    std::error_code ignored;
    fs::remove(part, ignored);
    throw;
  }
}

/// Text, by @p print(stream).
template <class Print>
void writeText(const fs::path& file, std::ios::openmode mode, const Print& print)
{
  errno = 0;
  std::ofstream stream(file, std::ios::binary | mode);
  print(stream);
  stream.close();
  if (!stream)
  {
    fail(errno, file);
  }
}

void writePolyData(vtkPolyData* data, const fs::path& file)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  vtkNew<vtkCallbackCommand> silence; // the run has a message of its own
  writer->AddObserver(vtkCommand::ErrorEvent, silence);
  writer->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, silence);
  writer->SetFileName(FFStreamedFiles::ToText(file).c_str());
  writer->SetInputData(data);
  writer->SetHeaderTypeToUInt64();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToLZ4(); // zlib takes several times as long as all else
  errno = 0;
  const int isWritten = writer->Write();
  const int number = errno;
  const unsigned long code = writer->GetErrorCode();
  if (!isWritten || code != vtkErrorCode::NoError)
  {
    const bool isSystems = code != vtkErrorCode::NoError && code < vtkErrorCode::FirstVTKErrorCode;
    fail(isSystems                                  ? static_cast<int>(code)
        : number != 0                               ? number
        : code == vtkErrorCode::OutOfDiskSpaceError ? ENOSPC
                                                    : EIO,
      file);
  }
}

vtkSmartPointer<vtkXMLDataElement> makeElement(const char* name)
{
  auto element = vtkSmartPointer<vtkXMLDataElement>::New();
  element->SetName(name);
  return element;
}

/// Removes the files of a folder whose name is so.
template <class Is>
void removeEach(const fs::path& folder, const Is& is)
{
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
  {
    if (is(FFStreamedFiles::ToText(entry.path().filename())))
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

//------------------------------------------------------------------------------
FFStreamedFiles::FFStreamedFiles(const char* fileName)
  : File(fs::absolute(ToPath(fileName)))
  , Folder(File)
{
  if (this->File.extension() != ending || this->File.stem().empty())
  {
    throw FFBadSetting(
      std::string("File Name is ") + fileName + "; it must end with " + ending + ".");
  }
  this->Folder.replace_extension();
}

//------------------------------------------------------------------------------
std::string FFStreamedFiles::ToText(const fs::path& path)
{
  const auto text = path.u8string(); // of another type in C++20
  return { text.begin(), text.end() };
}

//------------------------------------------------------------------------------
fs::path FFStreamedFiles::ToPath(const std::string& text)
{
#ifdef __cpp_char8_t
  return { std::u8string(text.begin(), text.end()) };
#else
  return fs::u8path(text);
#endif
}

//------------------------------------------------------------------------------
fs::path FFStreamedFiles::GetBlock(std::int64_t block) const
{
  fs::path name = this->Folder.filename();
  name += "_" + std::to_string(block) + ".vtp";
  return this->Folder / name;
}

//------------------------------------------------------------------------------
void FFStreamedFiles::WriteBlock(std::int64_t block, vtkPolyData* data) const
{
  fs::remove(this->File);
  fs::create_directory(this->Folder);
  writeWhole(this->GetBlock(block), [&](const fs::path& part) { writePolyData(data, part); });
}

//------------------------------------------------------------------------------
void FFStreamedFiles::WriteList(std::int64_t blocks) const
{
  const auto set = makeElement("vtkPartitionedDataSet");
  for (std::int64_t block = 0; block < blocks; ++block)
  {
    const fs::path file = this->GetBlock(block);
    if (!fs::exists(file))
    {
      fail(ENOENT, file); // somebody has removed it since
    }
    const auto element = makeElement("DataSet");
    element->SetAttribute("index", std::to_string(block).c_str());
    const std::string name = ToText(this->Folder.filename()) + "/" + ToText(file.filename());
    element->SetAttribute("file", name.c_str());
    set->AddNestedElement(element);
  }
  this->RemoveBlocks(blocks);
  const auto root = makeElement("VTKFile");
  root->SetAttribute("type", "vtkPartitionedDataSet");
  root->SetAttribute("version", "1.0");
  root->AddNestedElement(set);
  const auto print = [&](std::ostream& stream)
  {
    stream << "<?xml version=\"1.0\"?>\n";
    root->PrintXML(stream, vtkIndent());
  };
  writeWhole(this->File, [&](const fs::path& part) { writeText(part, std::ios::trunc, print); });
}

//------------------------------------------------------------------------------
void FFStreamedFiles::RemoveBlocks(std::int64_t begin) const
{
  const std::string prefix = ToText(this->Folder.filename()) + "_";
  removeEach(this->Folder,
    [&](const std::string& name)
    {
      const std::string digits = name.compare(0, prefix.size(), prefix) == 0
        ? name.substr(
            prefix.size(), name.find_first_not_of("0123456789", prefix.size()) - prefix.size())
        : std::string();
      if (digits.empty() || digits.size() > 18)
      {
        return false;
      }
      const std::int64_t block = std::stoll(digits);
      const std::string file = ToText(this->GetBlock(block).filename());
      return block >= begin && (name == file || name == file + unfinished);
    });
}

//------------------------------------------------------------------------------
FFWorkFolder::FFWorkFolder(const char* name, const FFStreamedFiles& files)
{
  if (name && *name)
  {
    this->Folder = fs::absolute(FFStreamedFiles::ToPath(name));
  }
  else
  {
    this->Folder = files.GetFile();
    this->Folder.replace_extension(".work");
  }
  this->List = this->Folder / "pieces.txt";
}

//------------------------------------------------------------------------------
void FFWorkFolder::Begin(
  const std::string& settings, const std::function<flipflop::StreamPiece(std::int64_t piece)>& read)
{
  fs::create_directories(this->Folder);
  fs::remove(fs::path(this->List) += unfinished);
  std::vector<std::string> before;
  if (fs::exists(this->List))
  {
    std::ifstream stream(this->List);
    for (std::string line; std::getline(stream, line) && !stream.eof();) // the last may be cut off
    {
      before.push_back(line);
    }
  }
  else if (!fs::is_empty(this->Folder))
  {
    throw FFBadSetting(
      "The work folder " + FFStreamedFiles::ToText(this->Folder) + " has other files in it.");
  }
  std::vector<std::string> now{ std::to_string(
    flipflop::byteHash(settings.data(), settings.size())) };
  bool isSame = !before.empty() && before[0] == now[0];
  for (std::size_t i = 1; i < before.size() && isSame; ++i)
  {
    now.push_back(HashOf(read(static_cast<std::int64_t>(i) - 1)));
    isSame = now[i] == before[i];
  }
  if (!isSame)
  {
    now.resize(1);
    flipflop::removeStreamedRun(this->Folder);
    fs::create_directories(this->Folder);
  }
  this->Listed = static_cast<std::int64_t>(now.size()) - 1;
  const auto print = [&](std::ostream& stream)
  {
    for (const std::string& line : now)
    {
      stream << line << "\n";
    }
  };
  writeWhole(this->List, [&](const fs::path& part) { writeText(part, std::ios::trunc, print); });
}

//------------------------------------------------------------------------------
void FFWorkFolder::Add(std::int64_t number, const flipflop::StreamPiece& piece)
{
  if (number >= this->Listed) // what was listed may not have been stored
  {
    writeText(
      this->List, std::ios::app, [&](std::ostream& stream) { stream << HashOf(piece) << "\n"; });
    ++this->Listed;
  }
}

//------------------------------------------------------------------------------
std::string FFWorkFolder::HashOf(const flipflop::StreamPiece& piece)
{
  const std::uint64_t parts[] = { flipflop::byteHash(piece.positions.data(),
                                    piece.positions.size() * sizeof(double)),
    flipflop::byteHash(piece.records.data(), piece.records.size()), piece.positions.size() };
  return std::to_string(flipflop::byteHash(parts, sizeof(parts)));
}

//------------------------------------------------------------------------------
void FFWorkFolder::Finish() const
{
  fs::remove(this->List);
  if (fs::is_empty(this->Folder))
  {
    fs::remove(this->Folder);
  }
}
VTK_ABI_NAMESPACE_END
