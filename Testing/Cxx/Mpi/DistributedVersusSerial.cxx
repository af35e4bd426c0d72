// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DistributedVersusSerial.h"

#include "Shares.h"

#include "vtkCommunicator.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkPFFHullFilter.h"

#include <flipflop/Statistics.h>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace fftest
{

//------------------------------------------------------------------------------
int rank()
{
  return vtkMultiProcessController::GetGlobalController()->GetLocalProcessId();
}

//------------------------------------------------------------------------------
int processes()
{
  return vtkMultiProcessController::GetGlobalController()->GetNumberOfProcesses();
}

//------------------------------------------------------------------------------
bool allWell()
{
  int own = failures();
  int sum = 0;
  vtkMultiProcessController::GetGlobalController()->AllReduce(
    &own, &sum, 1, vtkCommunicator::SUM_OP);
  if (own > 0)
  {
    std::cerr << "process " << rank() << ": " << own << " check(s) failed\n";
  }
  return sum == 0;
}

namespace
{

/// Without the file, the line and the object that VTK puts before it.
std::string sentence(const std::string& message)
{
  const std::size_t end = message.find("): ");
  return end == std::string::npos ? message : message.substr(end + 3);
}

std::vector<std::string> sentencesOf(const ErrorObserver* errors)
{
  std::vector<std::string> sentences;
  for (const std::string& message : errors->Messages)
  {
    sentences.push_back(sentence(message));
  }
  return sentences;
}

bool isNothing(vtkDataObject* output)
{
  return output->GetNumberOfElements(vtkDataObject::POINT) == 0 &&
    output->GetNumberOfElements(vtkDataObject::CELL) == 0;
}

/// The data sets in place, of which null ones are left out.
std::vector<vtkPolyData*> leavesOf(vtkDataObject* data)
{
  if (!vtkDataObjectTree::SafeDownCast(data))
  {
    return { vtkPolyData::SafeDownCast(data) };
  }
  std::vector<vtkPolyData*> all;
  vtkSmartPointer<vtkDataObjectTreeIterator> leaves;
  leaves.TakeReference(vtkDataObjectTree::SafeDownCast(data)->NewTreeIterator());
  for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
  {
    all.push_back(vtkPolyData::SafeDownCast(leaves->GetCurrentDataObject()));
  }
  return all;
}

/// Who did which work differs where there are several processes.
void removeReasons(vtkDataObject* data)
{
  for (vtkPolyData* leaf : leavesOf(data))
  {
    vtkFieldData* const fields = leaf->GetFieldData();
    fields->RemoveArray("FlipFlopEngineReason");
    fields->RemoveArray("FlipFlopThreads");
    flipflop::Statistics::eachField(
      [&](const char* member, auto)
      {
        std::string name = std::string("FlipFlop") + member;
        name[8] = static_cast<char>(std::toupper(name[8]));
        if (name != "FlipFlopPoints" && name != "FlipFlopNonFinite")
        {
          fields->RemoveArray(name.c_str());
        }
      });
  }
}

/// What a filter found, of all that does not depend on who did the work.
std::string reportOf(vtkFFAlgorithm* filter)
{
  std::istringstream lines(printedReport(filter));
  std::string report;
  for (std::string line; std::getline(lines, line);)
  {
    report += line.find("EngineReason") == std::string::npos ? line + "\n" : "";
  }
  return report;
}

}

//------------------------------------------------------------------------------
DistributedVersusSerial::DistributedVersusSerial(
  vtkFFAlgorithm* distributed, vtkFFAlgorithm* serial)
  : Distributed(distributed)
  , Serial(serial)
{
  const auto observe = [](vtkFFAlgorithm* filter, vtkCommand* errors, vtkCommand* warnings)
  {
    filter->AddObserver(vtkCommand::ErrorEvent, errors);
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
    filter->AddObserver(vtkCommand::WarningEvent, warnings);
  };
  observe(distributed, this->Errors, this->Warnings);
  observe(serial, this->SerialErrors, this->SerialWarnings);
}

//------------------------------------------------------------------------------
bool DistributedVersusSerial::Run(const std::string& what, const Pieces& pieces)
{
  return this->Run(what, pieces[static_cast<std::size_t>(rank())], append(pieces));
}

//------------------------------------------------------------------------------
bool DistributedVersusSerial::Run(const std::string& what, const std::vector<Pieces>& leaves)
{
  return this->Run(what, pieceOfBlocks(leaves), appendBlocks(leaves));
}

//------------------------------------------------------------------------------
bool DistributedVersusSerial::Run(
  const std::string& what, vtkDataObject* piece, vtkDataObject* whole)
{
  this->Update(piece);
  return this->Compare(what, whole);
}

//------------------------------------------------------------------------------
bool DistributedVersusSerial::Run(
  const std::string& what, vtkAlgorithm* source, vtkDataObject* whole)
{
  this->Update(source);
  return this->Compare(what, whole);
}

//------------------------------------------------------------------------------
void DistributedVersusSerial::Update(vtkDataObject* piece)
{
  this->Errors->Clear();
  this->Warnings->Clear();
  this->Distributed->SetInputDataObject(piece);
  this->Distributed->Modified();
  this->Distributed->Update();
}

//------------------------------------------------------------------------------
void DistributedVersusSerial::Update(vtkAlgorithm* source)
{
  this->Errors->Clear();
  this->Warnings->Clear();
  this->Distributed->SetInputConnection(source->GetOutputPort());
  this->Distributed->Modified();
  this->Distributed->UpdatePiece(rank(), processes(), 0);
}

//------------------------------------------------------------------------------
bool DistributedVersusSerial::Compare(const std::string& what, vtkDataObject* whole)
{
  this->SerialErrors->Clear();
  this->SerialWarnings->Clear();
  if (rank() == 0)
  {
    this->Serial->SetInputDataObject(whole);
    this->Serial->Modified();
    this->Serial->Update();
  }
  bool good = this->CheckReport(what);
  for (const std::string& warning : this->SerialWarnings->Messages)
  {
    good = this->Warnings->Has(sentence(warning)) && good;
  }
  for (int port = 0; port < this->Distributed->GetNumberOfOutputPorts(); ++port)
  {
    good =
      this->CheckOutput(what + ", port " + std::to_string(port),
        this->Distributed->GetOutputDataObject(port), this->Serial->GetOutputDataObject(port)) &&
      good;
  }
  if (!good)
  {
    std::cerr << what << " (process " << rank() << " of " << processes() << ")\n";
    ++failures();
  }
  return good;
}

//------------------------------------------------------------------------------
bool DistributedVersusSerial::Fails(
  const std::string& what, vtkDataObject* piece, const std::string& part)
{
  this->Update(piece);
  return this->CheckFailure(what, part);
}

//------------------------------------------------------------------------------
bool DistributedVersusSerial::Fails(
  const std::string& what, vtkAlgorithm* source, const std::string& part)
{
  this->Update(source);
  return this->CheckFailure(what, part);
}

//------------------------------------------------------------------------------
bool DistributedVersusSerial::CheckFailure(const std::string& what, const std::string& part)
{
  bool good = part.empty() == (this->Distributed->GetErrorCode() == vtkErrorCode::NoError);
  for (int port = 0; port < this->Distributed->GetNumberOfOutputPorts(); ++port)
  {
    good = isNothing(this->Distributed->GetOutputDataObject(port)) && good;
  }
  const bool speaks = rank() == 0 && !part.empty();
  good = this->Errors->Messages.size() == std::size_t(speaks) && good;
  good = (!speaks || this->Errors->Has(part)) && good;
  if (!good)
  {
    std::cerr << what << " does not fail as it should (process " << rank() << " of " << processes()
              << ")\n";
    ++failures();
  }
  return good;
}

//------------------------------------------------------------------------------
bool DistributedVersusSerial::HasShares() const
{
  // A warning says when process 0 has gathered all points of a triangulation.
  auto* hull = vtkPFFHullFilter::SafeDownCast(this->Distributed);
  const bool spreads = hull
    ? hull->GetResultMode() == vtkPFFHullFilter::RESULT_DISTRIBUTED
    : std::none_of(this->Warnings->Messages.begin(), this->Warnings->Messages.end(),
        [](const std::string& warning)
        { return warning.find("are gathered on one") != std::string::npos; });
  int shares = spreads && processes() > 1;
  vtkMultiProcessController::GetGlobalController()->Broadcast(&shares, 1, 0);
  return shares != 0;
}

//------------------------------------------------------------------------------
bool DistributedVersusSerial::HasResult() const
{
  int has = this->Serial->GetErrorCode() == vtkErrorCode::NoError ||
    !isNothing(this->Serial->GetOutputDataObject(0));
  vtkMultiProcessController::GetGlobalController()->Broadcast(&has, 1, 0);
  return has != 0;
}

//------------------------------------------------------------------------------
bool DistributedVersusSerial::CheckOutput(
  const std::string& what, vtkDataObject* own, vtkDataObject* serial)
{
  if (!this->HasResult())
  {
    return isNothing(own);
  }
  if (!this->HasShares())
  {
    if (rank() > 0)
    {
      return isNothing(own);
    }
    removeReasons(own);
    removeReasons(serial);
    return isIdentical(own, serial, what);
  }
  const std::vector<vtkPolyData*> shares = leavesOf(own);
  const std::vector<vtkPolyData*> wholes =
    rank() == 0 ? leavesOf(serial) : std::vector<vtkPolyData*>(shares.size());
  bool good = shares.size() == wholes.size();
  FF_CHECK(good); // else a process waits
  for (std::size_t leaf = 0; leaf < shares.size() && leaf < wholes.size(); ++leaf)
  {
    good = areSharesOf(shares[leaf], wholes[leaf], what) && good;
    if (rank() == 0)
    {
      removeReasons(shares[leaf]);
      removeReasons(wholes[leaf]);
      vtkNew<vtkPolyData> fields[2]; // those of process 0
      fields[0]->SetFieldData(shares[leaf]->GetFieldData());
      fields[1]->SetFieldData(wholes[leaf]->GetFieldData());
      good = isIdentical(fields[0], fields[1], what) && good;
    }
  }
  return good;
}

//------------------------------------------------------------------------------
bool DistributedVersusSerial::CheckReport(const std::string& what)
{
  const bool hasShares = this->HasShares();
  const bool areShares = this->HasResult() && hasShares;
  auto* controller = vtkMultiProcessController::GetGlobalController();
  vtkIdType expected[2] = { static_cast<vtkIdType>(this->Serial->GetErrorCode()),
    this->Serial->GetDimension() };
  controller->Broadcast(expected, 2, 0);
  bool good = static_cast<vtkIdType>(this->Distributed->GetErrorCode()) == expected[0];
  // Each process reports its share. Without shares, on the others both have nothing to report.
  good = good && (!areShares || this->Distributed->GetDimension() == expected[1]);
  if (rank() == 0 || !areShares)
  {
    good = good && reportOf(this->Distributed) == reportOf(this->Serial);
  }
  const std::string reason = this->Distributed->GetEngineReason();
  good = good && (rank() > 0 || hasShares || reason == this->Serial->GetEngineReason());
  good = good && sentencesOf(this->Errors) == sentencesOf(this->SerialErrors);
  if (!good)
  {
    std::cerr << what << ": another report: error " << this->Distributed->GetErrorCode() << ", not "
              << expected[0] << "; " << reportOf(this->Distributed) << "not\n"
              << reportOf(this->Serial) << this->Errors->Messages.size() << " error(s)\n";
  }
  return good;
}

}
