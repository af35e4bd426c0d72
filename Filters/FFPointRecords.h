// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Points and their data as records of one size.
 *
 * FFPointRecords writes a point as so many bytes: its coordinates, and its values of each array,
 * in their own types. What the arrays are is taken from one data set; others have the same. Arrays
 * of strings, and others that hold no numbers, are in no record.
 */

#ifndef FFPointRecords_h
#define FFPointRecords_h

#include "vtkFFMarks.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <cstddef>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPointSet;
class vtkPolyData;

class FFPointRecords
{
public:
  /**
   * Records like these points.
   *
   * @param withData whether point data is in them
   */
  FFPointRecords(vtkPointSet* kind, bool withData);

  FFPointRecords(const FFPointRecords&) = delete;
  void operator=(const FFPointRecords&) = delete;

  /// The bytes of a record.
  std::size_t GetSize() const { return this->Size; }

  /// All that a record has, in words; two are the same if their records are.
  std::string Describe() const;

  /// The names of arrays that are in no record.
  const std::vector<std::string>& GetLeftOut() const { return this->LeftOut; }

  /**
   * A record for each point.
   *
   * @throw std::runtime_error for an array that is missing or of another kind, or points of another
   *        type, unless the type is double
   */
  std::vector<char> Pack(vtkPointSet* points) const;

  /// The points of these records, and their data, become those of the output.
  void Unpack(const std::vector<char>& records, vtkPolyData* output) const;

private:
  int PointType;
  vtkNew<vtkPointData> Like; // without a point
  std::vector<std::string> LeftOut;
  std::size_t Size = 0;
};
VTK_ABI_NAMESPACE_END

#endif
