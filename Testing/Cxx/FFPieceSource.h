// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A source that delivers its data in pieces, and watches who asks for them and how long they live.
#ifndef FFPieceSource_h
#define FFPieceSource_h

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace fftest
{

class PieceSource : public vtkAlgorithm
{
public:
  static PieceSource* New();
  vtkTypeMacro(PieceSource, vtkAlgorithm);

  /// The data of piece k of n; null: the source fails.
  using Maker = std::function<vtkSmartPointer<vtkDataObject>(int k, int n)>;
  void SetMaker(Maker make, const char* type = "vtkPolyData");

  /// Ranges of the points, with their point data.
  void SetWhole(vtkPolyData* whole);

  /// One data object for each piece; nothing where there are more.
  void SetPieces(std::vector<vtkSmartPointer<vtkDataObject>> pieces);

  bool CanHandlePieces = true;

  /// The pieces asked for, in their order: which, of how many.
  std::vector<std::pair<int, int>> Asked;

  /// How many points of pieces exist now, and the most at a time so far; those of the largest
  /// piece.
  struct Lives
  {
    vtkIdType Now = 0;
    vtkIdType Most = 0;
    vtkIdType Largest = 0;
  };
  std::shared_ptr<Lives> Points = std::make_shared<Lives>();

  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

protected:
  PieceSource();
  int FillOutputPortInformation(int port, vtkInformation* info) override;

private:
  void Watch(vtkDataObject* data);

  Maker Make;
  std::string Type = "vtkPolyData";
};

/// Some points of a data set, with their data, in memory of their own.
vtkSmartPointer<vtkPolyData> cut(vtkPolyData* whole, vtkIdType begin, vtkIdType end);

/// Points with arrays of several kinds; each value tells of its point.
vtkSmartPointer<vtkPolyData> makeDecorated(
  const std::vector<std::array<double, 3>>& points, int type = VTK_DOUBLE, int number = 0);

}

#endif
