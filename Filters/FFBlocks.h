// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The data sets of a composite input, one by one: for all filters.
 *
 * VTK's executive would have a filter work on one data set after another. Here a filter gets the
 * composite as a whole, and small data sets are worked on side by side. Each has a run of its own:
 * its results, its report and its failure are values, so one at fault costs only itself.
 */

#ifndef FFBlocks_h
#define FFBlocks_h

#include "vtkFFMarks.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
class vtkDataObject;
class FFRun;
class vtkInformation;
class vtkInformationVector;

class FFBlocks
{
public:
  /**
   * A data set of an input, and, if it is a block of a composite, its flat index there.
   */
  struct PieceType
  {
    vtkDataObject* Data;
    unsigned int FlatIndex = 0;
    bool IsBlock = false;
  };

  /**
   * The data sets of an input: itself, or all of a composite, by ascending flat index.
   */
  static std::vector<PieceType> PiecesOf(vtkDataObject* input);

  /**
   * A port accepts data sets, and composites as a whole.
   */
  static void AcceptWhole(vtkInformation* port);

  /**
   * Answer REQUEST_DATA_OBJECT: each output is of that type, and for a composite input a composite
   * of the same structure, unless its data sets are joined. Of an AMR, it is a
   * vtkMultiBlockDataSet.
   *
   * @param type a class's name; null: the type of the input
   */
  static int MakeOutputs(vtkAlgorithm* filter, const char* type, bool isJoined,
    vtkInformationVector** inputVector, vtkInformationVector* outputVector);

  /**
   * The outputs of all ports, or results for them. The input's field data, which the executive has
   * passed, goes without the report of a filter upstream.
   */
  using Results = std::vector<vtkDataObject*>;
  static Results DataOf(vtkInformationVector* outputVector);

  /**
   * Work on a data set: its results, one for each port, are there and have its field data.
   */
  using Work = std::function<void(vtkDataObject* data, const Results& results, FFRun& run)>;

  /**
   * RequestData(): work on the input, or on each data set of a composite, if the outputs are
   * composites. Finishes the run.
   *
   * @param type         of the results, as above
   * @param isConcurrent small data sets can be worked on side by side
   */
  static int Run(FFRun& run, const char* type, bool isConcurrent,
    vtkInformationVector** inputVector, vtkInformationVector* outputVector, const Work& work);
};
VTK_ABI_NAMESPACE_END

#endif
