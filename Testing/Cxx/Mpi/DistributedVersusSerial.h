// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the tests of several processes share: data in pieces, and a distributed filter compared
/// with the serial one: their results, reports and errors must be the same.
#ifndef DistributedVersusSerial_h
#define DistributedVersusSerial_h

#include "FFTest.h"

#include "vtkCommand.h"
#include "vtkFFAlgorithm.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataObject;
class vtkMultiBlockDataSet;

namespace fftest
{

///@{
/// Which process this is, and how many there are.
int rank();
int processes();
///@}

/// A piece for each process, the same on all: tests make all of them and use their own.
using Pieces = std::vector<vtkSmartPointer<vtkPolyData>>;

/// The process that gets a point.
using Owner = std::function<int(int)>;

/// Each process in turn.
int byTurns(int i);

/// Ways to deal so many points out; with some, processes get nothing.
std::vector<std::pair<std::string, Owner>> dealings(std::size_t count);

/// Points by an owner for each, as so many pieces of the type; some may be empty.
Pieces split(const std::vector<Point>& points, const Owner& owner, int type = VTK_DOUBLE,
  int count = processes());

/// The pieces as arrays of arrays of every kind: attributes, names of components, strings, wide
/// integers, NaN. Each value tells of piece and point.
void decorate(const Pieces& pieces);

/// The points of all pieces, one after another, with the point data that all have.
vtkSmartPointer<vtkPolyData> append(const Pieces& pieces);

/// A composite of four leaves, two of them nested (flat indices 1, 3, 4 and 5); any may be null.
vtkSmartPointer<vtkMultiBlockDataSet> makeBlocks(const Pieces& leaves);

/// What is in pieces by leaf (a process may have null for a leaf), as it is whole.
vtkSmartPointer<vtkMultiBlockDataSet> appendBlocks(const std::vector<Pieces>& leaves);

/// What a process has of it.
vtkSmartPointer<vtkMultiBlockDataSet> pieceOfBlocks(const std::vector<Pieces>& leaves);

/// A distributed filter on each process, and on process 0 the serial one. Where each process has a
/// share of the output, their union is compared.
class DistributedVersusSerial
{
public:
  /// Which takes over both.
  DistributedVersusSerial(vtkFFAlgorithm* distributed, vtkFFAlgorithm* serial);

  /// Do the same to both.
  template <class FilterT, class Change>
  void Set(Change&& change)
  {
    for (vtkFFAlgorithm* filter : { this->Distributed.Get(), this->Serial.Get() })
    {
      change(FilterT::SafeDownCast(filter));
    }
  }

  /// Runs both, the serial one for @p whole, and compares all that they give and report. Where the
  /// serial filter has an error, it must be all processes' error. Collective.
  bool Run(const std::string& what, vtkDataObject* piece, vtkDataObject* whole);
  /// Each process asks the source for its share of pieces.
  bool Run(const std::string& what, vtkAlgorithm* source, vtkDataObject* whole);
  bool Run(const std::string& what, const Pieces& pieces);
  bool Run(const std::string& what, const std::vector<Pieces>& leaves);

  /// Runs the distributed filter alone, which must fail: one error on process 0 with this part, or
  /// none for an empty part (an abort). Collective.
  bool Fails(const std::string& what, vtkDataObject* piece, const std::string& part);
  bool Fails(const std::string& what, vtkAlgorithm* source, const std::string& part);

  vtkSmartPointer<vtkFFAlgorithm> Distributed;
  vtkSmartPointer<vtkFFAlgorithm> Serial;

  /// Of the last run, of the distributed filter.
  ///@{
  vtkNew<ErrorObserver> Errors;
  vtkNew<ErrorObserver> Warnings;
  ///@}

private:
  void Update(vtkDataObject* piece);
  void Update(vtkAlgorithm* source);
  bool Compare(const std::string& what, vtkDataObject* whole);
  bool CheckFailure(const std::string& what, const std::string& part);

  /// Whether each process has a share of the output. Otherwise process 0 has it whole. Collective.
  bool HasShares() const;

  /// Whether the serial filter has a result, maybe with an error. Collective.
  bool HasResult() const;
  bool CheckOutput(const std::string& what, vtkDataObject* own, vtkDataObject* serial);
  bool CheckReport(const std::string& what);

  vtkNew<ErrorObserver> SerialErrors;
  vtkNew<ErrorObserver> SerialWarnings;
};

/// The comparison of a filter with the serial one.
template <class DistributedT, class SerialT>
DistributedVersusSerial compare()
{
  return DistributedVersusSerial(
    vtkSmartPointer<DistributedT>::New(), vtkSmartPointer<SerialT>::New());
}

/// Whether no process has found anything wrong so far. Collective.
bool allWell();

}

/// The tests, one a file. Collective.
///@{
void testErrors();
void testFaults();
void testHull();
void testHullComposite();
void testHullShares();
void testHullStreamed();
void testRandomPartitions();
void testShares();
void testTriangulation();
///@}

#endif
