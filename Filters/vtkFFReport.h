// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFReport
 * @brief   what a run of a Flip-Flop filter reports
 *
 * vtkFFReport has the figures that filters return: those of one data set, or the sums over those of
 * a composite. The Get functions of the filters say what they are.
 */

#ifndef vtkFFReport_h
#define vtkFFReport_h

#include "vtkFFMarks.h"
#include "vtkType.h" // For vtkIdType

#include <string> // For std::string

VTK_ABI_NAMESPACE_BEGIN
struct vtkFFReport
{
  int EngineUsed = -1;      ///< vtkFFAlgorithm::EngineType
  std::string EngineReason; ///< empty: none has run
  int Dimension = -1;
  vtkIdType NumberOfInputPoints = 0;
  vtkIdType NumberOfNonFinitePoints = 0;
  double Volume = 0.0;
  double Area = 0.0;
  vtkIdType NumberOfHiddenPoints = 0;
  vtkIdType NumberOfDroppedCells = 0;
  vtkIdType NumberOfSplitPoints = 0;
  vtkIdType NumberOfAddedPoints = 0;
  vtkIdType NumberOfHeightDifferences = 0;
  double GreatestError = 0.0;
  vtkIdType NumberOfPointsBeyond = 0;
  vtkIdType NumberOfUnreachablePoints = 0;
  vtkIdType NumberOfKeptSegments = 0;
  vtkIdType NumberOfKeptTriangles = 0;

  /**
   * Sums and greatest values. The reason is that of the last one whose engine was used.
   */
  void Add(const vtkFFReport& other)
  {
    if (other.EngineUsed >= this->EngineUsed && other.EngineUsed >= 0)
    {
      this->EngineUsed = other.EngineUsed;
      this->EngineReason = other.EngineReason;
    }
    this->Dimension = other.Dimension > this->Dimension ? other.Dimension : this->Dimension;
    this->GreatestError =
      other.GreatestError > this->GreatestError ? other.GreatestError : this->GreatestError;
    this->Volume += other.Volume;
    this->Area += other.Area;
    for (vtkIdType vtkFFReport::*number : { &vtkFFReport::NumberOfInputPoints,
           &vtkFFReport::NumberOfNonFinitePoints, &vtkFFReport::NumberOfHiddenPoints,
           &vtkFFReport::NumberOfDroppedCells, &vtkFFReport::NumberOfSplitPoints,
           &vtkFFReport::NumberOfAddedPoints, &vtkFFReport::NumberOfHeightDifferences,
           &vtkFFReport::NumberOfPointsBeyond, &vtkFFReport::NumberOfUnreachablePoints,
           &vtkFFReport::NumberOfKeptSegments, &vtkFFReport::NumberOfKeptTriangles })
    {
      this->*number += other.*number;
    }
  }
};
VTK_ABI_NAMESPACE_END

#endif
