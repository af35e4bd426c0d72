// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Twins.h"

#include "Shares.h"

#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkFFConstrainedDelaunayFilter.h"
#include "vtkFFHullAlgorithm.h"
#include "vtkFFPowerDiagramFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkPFFHullFilter.h"
#include "vtkPointData.h"

#include <flipflop/Statistics.h>

#include <algorithm>
#include <cctype>

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

bool isNothing(vtkDataObject* output)
{
  auto* data = vtkPolyData::SafeDownCast(output);
  return data ? isEmpty(data)
              : output->GetNumberOfElements(vtkDataObject::POINT) == 0 &&
      output->GetNumberOfElements(vtkDataObject::CELL) == 0;
}

/// Changes each data set, or a copy of it in a composite.
void eachLeaf(vtkDataObject* data, const std::function<void(vtkDataObject*)>& change)
{
  change(data);
  if (auto* tree = vtkDataObjectTree::SafeDownCast(data))
  {
    vtkSmartPointer<vtkDataObjectTreeIterator> leaves;
    leaves.TakeReference(tree->NewTreeIterator());
    for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
    {
      vtkSmartPointer<vtkDataObject> copy;
      copy.TakeReference(leaves->GetCurrentDataObject()->NewInstance());
      copy->ShallowCopy(leaves->GetCurrentDataObject());
      change(copy);
      tree->SetDataSet(leaves, copy);
    }
  }
}

/// Which process counts a point is another matter, too: marks of that are in shares alone.
void removeMarks(vtkDataObject* data)
{
  eachLeaf(data,
    [](vtkDataObject* leaf)
    {
      auto* points = vtkPolyData::SafeDownCast(leaf);
      const char* name = vtkDataSetAttributes::GhostArrayName();
      vtkDataArray* given = points ? points->GetPointData()->GetArray(name) : nullptr;
      if (!given)
      {
        return;
      }
      vtkSmartPointer<vtkDataArray> marks;
      marks.TakeReference(given->NewInstance());
      marks->DeepCopy(given);
      bool isMarked = false;
      for (vtkIdType i = 0; i < marks->GetNumberOfTuples(); ++i)
      {
        const int others =
          static_cast<int>(marks->GetTuple1(i)) & ~vtkDataSetAttributes::DUPLICATEPOINT;
        marks->SetTuple1(i, others);
        isMarked = isMarked || others != 0;
      }
      points->GetPointData()->AddArray(marks);
      if (!isMarked)
      {
        points->GetPointData()->RemoveArray(name);
      }
    });
}

/// Who did which work is another matter where there are several processes.
void removeReasons(vtkDataObject* data)
{
  eachLeaf(data,
    [](vtkDataObject* leaf)
    {
      vtkFieldData* fields = leaf->GetFieldData();
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
    });
}

/// What a filter found, of all that does not depend on who did the work.
std::vector<double> reportOf(vtkFFAlgorithm* filter)
{
  std::vector<double> values{ double(filter->GetEngineUsed()), double(filter->GetDimension()),
    double(filter->GetNumberOfInputPoints()), double(filter->GetNumberOfNonFinitePoints()) };
  if (auto* hull = vtkFFHullAlgorithm::SafeDownCast(filter))
  {
    values.push_back(hull->GetVolume());
    values.push_back(hull->GetArea());
  }
  if (auto* triangulation = vtkFFRegularTriangulationFilter::SafeDownCast(filter))
  {
    values.push_back(static_cast<double>(triangulation->GetNumberOfHiddenPoints()));
    values.push_back(static_cast<double>(triangulation->GetNumberOfDroppedCells()));
  }
  if (auto* diagram = vtkFFPowerDiagramFilter::SafeDownCast(filter))
  {
    values.push_back(static_cast<double>(diagram->GetNumberOfHiddenPoints()));
  }
  if (auto* delaunay = vtkFFConstrainedDelaunayFilter::SafeDownCast(filter))
  {
    values.push_back(static_cast<double>(delaunay->GetNumberOfDroppedCells()));
  }
  return values;
}

}

//------------------------------------------------------------------------------
Twins::Twins(vtkFFAlgorithm* distributed, vtkFFAlgorithm* plain)
  : Distributed(distributed)
  , Plain(plain)
{
  distributed->AddObserver(vtkCommand::ErrorEvent, this->Errors);
  distributed->AddObserver(vtkCommand::WarningEvent, this->Warnings);
  distributed->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Errors);
  plain->AddObserver(vtkCommand::ErrorEvent, this->PlainErrors);
  plain->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->PlainErrors);
  plain->AddObserver(vtkCommand::WarningEvent, this->PlainWarnings);
}

//------------------------------------------------------------------------------
bool Twins::Run(const std::string& what, const Pieces& pieces)
{
  return this->Run(what, pieces[static_cast<std::size_t>(rank())], append(pieces));
}

//------------------------------------------------------------------------------
bool Twins::Run(const std::string& what, const std::vector<Pieces>& leaves)
{
  return this->Run(what, pieceOfBlocks(leaves), appendBlocks(leaves));
}

//------------------------------------------------------------------------------
bool Twins::Run(const std::string& what, vtkDataObject* piece, vtkDataObject* whole)
{
  this->Errors->Clear();
  this->Warnings->Clear();
  this->PlainErrors->Clear();
  this->PlainWarnings->Clear();
  this->Distributed->SetInputDataObject(piece);
  this->Distributed->Modified();
  this->Distributed->Update();
  if (rank() == 0)
  {
    this->Plain->SetInputDataObject(whole);
    this->Plain->Modified();
    this->Plain->Update();
  }
  // What the plain filter's error code is, is for all.
  auto code = static_cast<vtkIdType>(this->Plain->GetErrorCode());
  vtkMultiProcessController::GetGlobalController()->Broadcast(&code, 1, 0);
  bool good = static_cast<vtkIdType>(this->Distributed->GetErrorCode()) == code;
  if (!good)
  {
    std::cerr << what << ": the error code is " << this->Distributed->GetErrorCode() << ", not "
              << code << "\n";
  }
  for (const std::string& warning : this->PlainWarnings->Messages)
  {
    if (!this->Warnings->Has(sentence(warning)))
    {
      std::cerr << what << ": there is no warning " << sentence(warning);
      good = false;
    }
  }
  good = this->CheckOutputs(what) && good;
  good = this->CheckReports(what) && good;
  if (!good)
  {
    std::cerr << "  (process " << rank() << " of " << processes() << ")\n";
    ++failures();
  }
  return good;
}

//------------------------------------------------------------------------------
bool Twins::Fails(const std::string& what, vtkDataObject* piece, const std::string& part)
{
  this->Errors->Clear();
  this->Distributed->SetInputDataObject(piece);
  this->Distributed->Modified();
  this->Distributed->Update();
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
bool Twins::HasShares() const
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
bool Twins::HasResult() const
{
  int has = this->Plain->GetErrorCode() == vtkErrorCode::NoError ||
    !isNothing(this->Plain->GetOutputDataObject(0));
  vtkMultiProcessController::GetGlobalController()->Broadcast(&has, 1, 0);
  return has != 0;
}

//------------------------------------------------------------------------------
bool Twins::CheckShares(const std::string& what)
{
  bool good = true;
  const int ports = vtkFFRegularTriangulationFilter::SafeDownCast(this->Distributed) ? 2 : 1;
  for (int port = 0; port < ports; ++port)
  {
    const auto joined = joinShares(this->Distributed->GetOutputDataObject(port));
    if (rank() == 0)
    {
      vtkDataObject* plain = this->Plain->GetOutputDataObject(port);
      vtkSmartPointer<vtkDataObject> expected;
      expected.TakeReference(plain->NewInstance());
      expected->ShallowCopy(plain);
      removeReasons(joined);
      removeReasons(expected);
      removeMarks(joined);
      removeMarks(expected);
      good = isIdentical(joined, expected, what + ", port " + std::to_string(port)) && good;
    }
  }
  for (int port = ports; port < this->Distributed->GetNumberOfOutputPorts(); ++port)
  {
    good = isNothing(this->Distributed->GetOutputDataObject(port)) && good;
  }
  return good;
}

//------------------------------------------------------------------------------
bool Twins::CheckOutputs(const std::string& what)
{
  bool good = true;
  const bool hasResult = this->HasResult();
  if (this->HasShares() && hasResult)
  {
    return this->CheckShares(what);
  }
  for (int port = 0; port < this->Distributed->GetNumberOfOutputPorts(); ++port)
  {
    const std::string where = what + ", port " + std::to_string(port);
    vtkDataObject* output = this->Distributed->GetOutputDataObject(port);
    if (rank() > 0 || !hasResult)
    {
      if (!isNothing(output))
      {
        std::cerr << where << " is not empty\n";
        good = false;
      }
    }
    if (rank() == 0)
    {
      vtkDataObject* plain = this->Plain->GetOutputDataObject(port);
      removeReasons(output);
      removeReasons(plain);
      good = isIdentical(output, plain, where) && good;
    }
  }
  return good;
}

//------------------------------------------------------------------------------
bool Twins::CheckReports(const std::string& what)
{
  bool good = true;
  const bool hasShares = this->HasShares();
  const bool hasResult = this->HasResult();
  std::vector<std::string> expected;
  if (rank() == 0)
  {
    for (const std::string& message : this->PlainErrors->Messages)
    {
      expected.push_back(sentence(message));
    }
    if (!hasShares &&
      std::string(this->Distributed->GetEngineReason()) != this->Plain->GetEngineReason())
    {
      std::cerr << what
                << ": another reason for the engine: " << this->Distributed->GetEngineReason()
                << "\n";
      good = false;
    }
  }
  std::vector<std::string> found;
  for (const std::string& message : this->Errors->Messages)
  {
    found.push_back(sentence(message));
  }
  if (found != expected)
  {
    std::cerr << what << ": " << found.size() << " error(s), not " << expected.size() << ": "
              << (found.empty() ? "-" : found[0]) << "; " << (expected.empty() ? "-" : expected[0])
              << "\n";
    good = false;
  }
  // On the other processes, the plain filter has not run and has nothing to report. Those that have
  // a share report it.
  const auto report = reportOf(this->Distributed);
  auto expectedReport = reportOf(this->Plain);
  if (hasShares && hasResult)
  {
    int dimension = this->Plain->GetDimension();
    vtkMultiProcessController::GetGlobalController()->Broadcast(&dimension, 1, 0);
    if (this->Distributed->GetDimension() != dimension)
    {
      std::cerr << what << ": the dimension is " << this->Distributed->GetDimension() << "\n";
      good = false;
    }
    expectedReport = rank() > 0 ? report : expectedReport;
  }
  for (std::size_t i = 0; i < report.size(); ++i)
  {
    if (report[i] != expectedReport[i])
    {
      std::cerr << what << ": value " << i << " of the report is " << report[i] << ", not "
                << expectedReport[i] << "\n";
      good = false;
    }
  }
  return good;
}

}
