// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFStreamedWriter.h"

#include "FFInput.h"
#include "FFOutput.h"
#include "FFPlanarInput.h"
#include "FFRun.h"
#include "FFStreamedFiles.h"
#include "FFStreamedInput.h"
#include "vtkFFErrorCode.h"

#include <flipflop/StreamedRun.h>

#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <cstdint>
#include <filesystem>
#include <ios>
#include <sstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkFFStreamedWriter);

namespace
{

/// A block as poly data.
vtkSmartPointer<vtkPolyData> makeBlock(
  flipflop::StreamedBlock& block, const FFPointRecords& records)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  records.Unpack(block.records, data);
  flipflop::CellComplex& cells = block.result.cells;
  FFOutput::AdoptCells(cells, data);
  FFOutput::AddIds(FFOutput::AdoptIds(cells.pointIds), data->GetPointData());
  return data;
}

/// A failure at a file.
void sayOfFile(const std::filesystem::filesystem_error& error, FFFailure& failure)
{
  const bool isFull =
    error.code() == std::errc::no_space_on_device || error.code() == std::errc::file_too_large;
  const bool mayBeDamaged =
    error.code() == std::errc::io_error || error.code() == std::errc::no_such_file_or_directory;
  failure.Say("The file " + FFStreamedFiles::ToText(error.path1()) +
      " cannot be written or read: " + error.code().message() +
      (mayBeDamaged ? "; if it is damaged or missing, remove its folder" : "") +
      ". Write again to go on.",
    isFull ? vtkErrorCode::OutOfDiskSpaceError : vtkErrorCode::CannotOpenFileError);
}

}

//------------------------------------------------------------------------------
vtkFFStreamedWriter::vtkFFStreamedWriter() = default;

//------------------------------------------------------------------------------
vtkFFStreamedWriter::~vtkFFStreamedWriter()
{
  this->SetFileName(nullptr);
  this->SetWorkFolder(nullptr);
}

//------------------------------------------------------------------------------
int vtkFFStreamedWriter::FillInputPortInformation(int, vtkInformation* info)
{
  FFBlocks::AcceptWhole(info);
  return 1;
}

//------------------------------------------------------------------------------
vtkTypeBool vtkFFStreamedWriter::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (request->Has(vtkStreamingDemandDrivenPipeline::REQUEST_UPDATE_EXTENT()))
  {
    vtkInformation* const input = inputVector[0]->GetInformationObject(0);
    FFInputPieces::Request(input, 0, FFInputPieces::Count(input, this->NumberOfPieces));
    return 1;
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkFFStreamedWriter::Write()
{
  this->IsTried = false;
  this->ForgetReport();
  const bool hasInput = this->GetNumberOfInputConnections(0) > 0;
  if (hasInput)
  {
    this->Superclass::Write();
  }
  if (!this->IsTried)
  {
    FFRun run(this, nullptr, this->NumberOfThreads,
      [this](const vtkFFReport&, unsigned long code) { this->ErrorCode = code; });
    vtkInformation* const input = hasInput ? this->GetInputInformation() : nullptr;
    run.Do(
      [&]
      {
        if (!hasInput)
        {
          throw std::runtime_error("There is no input. Set one.");
        }
        FFInputPieces::Check(input, false);
      });
    const int count = FFInputPieces::Count(input, this->NumberOfPieces);
    run.NameFailure(count > 1 ? FFInputPieces::Describe(0, count) : std::string());
    run.Finish({});
  }
  return this->IsWritten;
}

//------------------------------------------------------------------------------
int vtkFFStreamedWriter::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*)
{
  this->IsTried = true;
  this->ForgetReport();
  this->WriteData();
  return 1;
}

//------------------------------------------------------------------------------
void vtkFFStreamedWriter::ForgetReport()
{
  this->ErrorCode = vtkErrorCode::NoError;
  this->IsWritten = false;
  this->Report = vtkFFReport();
  this->NumberOfCells = 0;
  this->NumberOfBlocks = 0;
}

//------------------------------------------------------------------------------
void vtkFFStreamedWriter::WriteData()
{
  FFRun run(this, this->Shape == HULL ? "Streamed hull" : "Streamed triangulation",
    this->NumberOfThreads,
    [this](const vtkFFReport&, unsigned long code) { this->ErrorCode = code; });
  run.Options.facets = static_cast<flipflop::FacetMode>(this->FacetMode);
  run.Options.nonFinite = static_cast<flipflop::NonFinitePolicy>(this->NonFinitePoints);
  FFStreamedInput input(this, run, this->GetInputInformation());
  flipflop::StreamReport report;
  run.Do(
    [&]
    {
      try
      {
        report = this->WriteFiles(input, run);
      }
      catch (const flipflop::PieceError& error)
      {
        input.Current = static_cast<int>(error.piece());
        throw;
      }
      catch (const std::filesystem::filesystem_error& error)
      {
        sayOfFile(error, run.Failure);
      }
    });
  if (run.Failure && input.Current >= 0 && input.GetNumberOfPieces() > 1)
  {
    run.NameFailure(FFInputPieces::Describe(input.Current, input.GetNumberOfPieces()));
  }
  if (!run.Failure)
  {
    this->Report.NumberOfInputPoints = static_cast<vtkIdType>(report.points);
    this->Report.NumberOfNonFinitePoints = static_cast<vtkIdType>(report.nonFinite);
    this->Report.NumberOfHiddenPoints = static_cast<vtkIdType>(report.hidden);
    this->Report.Dimension = report.dimension;
    this->Report.Volume = report.volume;
    this->Report.Area = report.area;
    this->NumberOfCells = static_cast<vtkIdType>(report.cells);
    this->NumberOfBlocks = static_cast<vtkIdType>(report.blocks);
    this->IsWritten = true;
  }
  run.Finish({});
}

//------------------------------------------------------------------------------
flipflop::StreamReport vtkFFStreamedWriter::WriteFiles(FFStreamedInput& input, FFRun& run)
{
  if (!this->FileName || !*this->FileName)
  {
    run.Failure.Say("There is no File Name.", vtkErrorCode::NoFileNameError);
    return {};
  }
  FFFailure::CheckLength(this->MaximumEdgeLength, "Maximum Edge Length", "edges of any length");
  const FFStreamedFiles files(this->FileName);
  input.Begin();
  const FFPointRecords& records = input.GetRecords();
  this->WarnOfLeftOut(records.GetLeftOut());
  flipflop::StreamSettings settings;
  settings.shape = input.GetShape();
  settings.options = run.Options;
  settings.memory = static_cast<std::int64_t>(this->MemoryLimit) * 1024;
  settings.blockPoints = static_cast<std::int64_t>(this->PointsPerBlock);
  settings.recordSize = records.GetSize();
  FFWorkFolder folder(this->WorkFolder, files);
  settings.folder = folder.GetPath();
  settings.keepFiles = true;
  const double longest = this->Shape == HULL ? 0.0 : this->MaximumEdgeLength;
  std::ostringstream length;
  length << std::hexfloat << longest;
  std::string key =
    FFStreamedFiles::ToText(files.GetFile()) + " " + records.Describe() + " " + length.str();
  for (const int choice : { static_cast<int>(settings.shape), this->FacetMode,
         this->NonFinitePoints, input.GetNumberOfPieces() })
  {
    key += " " + std::to_string(choice);
  }
  folder.Begin(key,
    [&](std::int64_t piece)
    {
      FFRun::Look(run.Options);
      return input.Read(static_cast<int>(piece));
    });
  const auto read = [&](std::int64_t number)
  {
    flipflop::StreamPiece piece = input.Read(static_cast<int>(number));
    folder.Add(number, piece);
    return piece;
  };
  flipflop::Options quiet = run.Options; // who watches the whole run does so from another thread
  quiet.progress = nullptr;
  quiet.step = nullptr;
  const auto write = [&](flipflop::StreamedBlock&& block)
  {
    FFPlanarInput::WorkOnBlock(block.result,
      [&](const auto& points, auto& cells)
      { FFPlanarInput::DropLongCells(points, longest, quiet, cells); });
    files.WriteBlock(block.number, makeBlock(block, records));
  };
  const flipflop::StreamReport report =
    flipflop::streamedRun(settings, input.GetNumberOfPieces(), read, write);
  try
  {
    files.WriteList(report.blocks);
  }
  catch (const std::filesystem::filesystem_error& error)
  {
    if (error.code() == std::errc::no_such_file_or_directory)
    {
      flipflop::removeStreamedRun(settings.folder); // a block is gone: all are to be written again
    }
    throw;
  }
  flipflop::removeStreamedRun(settings.folder);
  folder.Finish();
  return report;
}

//------------------------------------------------------------------------------
void vtkFFStreamedWriter::WarnOfLeftOut(const std::vector<std::string>& names)
{
  std::string list;
  for (const std::string& name : names)
  {
    list += (list.empty() ? "\"" : ", \"") + name + "\"";
  }
  if (!list.empty())
  {
    vtkWarningMacro(<< "Point data " << list << " without numbers or a name is left out.");
  }
}

//------------------------------------------------------------------------------
void vtkFFStreamedWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto onOff = [](bool flag) { return flag ? "On" : "Off"; };
  const auto nameOf = [](const char* name) { return name ? name : "(none)"; };
  os << indent << "FileName: " << nameOf(this->FileName) << "\n";
  os << indent << "Shape: " << this->Shape << "\n";
  os << indent << "WeightMode: " << this->WeightMode << "\n";
  os << indent << "WeightFactor: " << this->WeightFactor << "\n";
  os << indent << "MaximumEdgeLength: " << this->MaximumEdgeLength << "\n";
  os << indent << "FacetMode: " << this->FacetMode << "\n";
  os << indent << "NumberOfPieces: " << this->NumberOfPieces << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "PointsPerBlock: " << this->PointsPerBlock << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "NonFinitePoints: " << this->NonFinitePoints << "\n";
  os << indent << "SkipGhostPoints: " << onOff(this->SkipGhostPoints) << "\n";
  os << indent << "PassPointData: " << onOff(this->PassPointData) << "\n";
  os << indent << "WorkFolder: " << nameOf(this->WorkFolder) << "\n";
}
VTK_ABI_NAMESPACE_END
