// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the tests of the filters share: checks that count, an observer of errors, inputs, oracles.
#ifndef FFTest_h
#define FFTest_h

#include "vtkCommand.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <iostream>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataArray;
class vtkDataObject;
class vtkDataSet;
class vtkFFAlgorithm;
class vtkFFRegularTriangulationFilter;
class vtkPointSet;

namespace fftest
{

/// Checks that failed so far in this test.
int& failures();

/// EXIT_SUCCESS when none did, or EXIT_FAILURE.
int result();

#define FF_CHECK(condition)                                                                        \
  do                                                                                               \
  {                                                                                                \
    if (!(condition))                                                                              \
    {                                                                                              \
      std::cerr << __FILE__ << ":" << __LINE__ << ": not so: " #condition "\n";                    \
      ++fftest::failures();                                                                        \
    }                                                                                              \
  } while (false)

#define FF_CHECK_EQUAL(found, expected)                                                            \
  do                                                                                               \
  {                                                                                                \
    const auto ffFound = (found);                                                                  \
    const decltype(ffFound) ffExpected = (expected);                                               \
    if (!(ffFound == ffExpected))                                                                  \
    {                                                                                              \
      std::cerr << __FILE__ << ":" << __LINE__ << ": " #found " is " << ffFound << ", not "        \
                << ffExpected << "\n";                                                             \
      ++fftest::failures();                                                                        \
    }                                                                                              \
  } while (false)

/// Keeps the messages of an object's errors and warnings, and so keeps them off the terminal. Those
/// of a filter's executive are among them: a failure is one message.
class ErrorObserver : public vtkCommand
{
public:
  static ErrorObserver* New() { return new ErrorObserver; }
  vtkTypeMacro(ErrorObserver, vtkCommand);

  /// A new observer of the object's errors, and of its executive's.
  static vtkSmartPointer<ErrorObserver> Of(vtkObject* object);

  void Execute(vtkObject* caller, unsigned long event, void* data) override;

  bool Has(const std::string& part) const;
  void Clear() { this->Messages.clear(); }

  std::vector<std::string> Messages;
};

/// Whether an update of the filter goes well: no message, no error code.
bool succeeds(vtkAlgorithm* filter);

/// Whether an update of the filter ends with one message, which has all the parts, and with this
/// code of vtkFFErrorCode. Says what is not so.
bool failsInPart(vtkAlgorithm* filter, unsigned long code, const std::vector<std::string>& parts);

/// The same, and nothing is left on the outputs and in the report.
bool fails(vtkFFAlgorithm* filter, unsigned long code, const std::vector<std::string>& parts);

/// Keeps the progress reported, and asks the filter to stop once it reaches a mark.
class ProgressObserver : public vtkCommand
{
public:
  static ProgressObserver* New() { return new ProgressObserver; }
  vtkTypeMacro(ProgressObserver, vtkCommand);

  void Execute(vtkObject* caller, unsigned long event, void* data) override;

  /// Whether the filter itself got somewhere, and not to its end.
  bool StoppedOnTheWay() const;

  double AbortAt = 2.0;
  std::vector<double> Values;
  std::vector<std::string> Texts; ///< without repetitions in a row
};

/// It goes from somewhere to 1, in some steps, and never back.
void checkProgress(const std::vector<double>& values);

using Point = std::array<double, 3>;

/// A poly data of points without cells, in an array of the type (VTK_DOUBLE, VTK_FLOAT,
/// VTK_INT...).
vtkSmartPointer<vtkPolyData> makePoints(const std::vector<Point>& points, int type = VTK_DOUBLE);

/// The same with an array of one's own.
vtkSmartPointer<vtkPolyData> makePoints(vtkDataArray* array);

/// A poly data of polygons.
vtkSmartPointer<vtkPolyData> makeSurface(const std::vector<Point>& points,
  const std::vector<std::vector<vtkIdType>>& polygons, int type = VTK_DOUBLE);

/// The outer triangles of unit cubes at integer places, all outward; no two may touch in an edge or
/// a corner alone.
vtkSmartPointer<vtkPolyData> makeVoxels(const std::vector<std::array<int, 3>>& cubes);

/// Points with coordinates in [-1, 1), the same on every machine.
std::vector<Point> randomPoints(int count, unsigned int seed);

/// Points on the unit sphere, but for rounding.
std::vector<Point> spherePoints(int count, unsigned int seed);

/// The eight corners of the unit cube, ids 0 to 7: x changes fastest.
std::vector<Point> cubeCorners();

/// Whether the filter's output is the hull that the engine gives for the points, with ids and with
/// points of the same type and bits.
bool isHullOf(vtkPointSet* input, vtkPolyData* output, int dimension);

/// The same points with an array of weights, of the type.
vtkSmartPointer<vtkPolyData> makeWeighted(const std::vector<Point>& points,
  const std::vector<double>& weights, int type = VTK_DOUBLE, const char* name = "weights");

/// Random points with small weights.
vtkSmartPointer<vtkPolyData> randomWeighted(int count, unsigned int seed, int type = VTK_DOUBLE);

/// Gives the data the array vtkGhostType with these marks, over and over for all points; or once.
void markPoints(vtkDataSet* data, const std::vector<int>& marks, bool again = true);

/// Have the filter take its weights from the point array.
void useWeights(vtkAlgorithm* filter, const char* name = "weights");

/// Whether the first two outputs of a filter that ran are the regular triangulation that the engine
/// gives for its input in the XY plane, with ids and with points of the same type and bits. Null:
/// no weights.
bool isTriangulationOf(vtkPointSet* input, const char* weights,
  vtkFFRegularTriangulationFilter* filter, int dimension = 2);

/// Whether two outputs are the same, bit for bit: points, cells and original ids.
bool isSame(vtkPolyData* a, vtkPolyData* b);

/// Whether all is the same, bit for bit: class, structure, points, cells (of other data than poly
/// data, their number), point, cell and field data (of the reports in it, not what is measured or
/// depends on the threads). Says what is not.
bool isIdentical(vtkDataObject* found, vtkDataObject* expected, const std::string& what);

/// A number of the report in an output's field data, such as "Flips22"; NaN if it is not there.
double reported(vtkDataObject* output, const std::string& name);

/// Whether there are neither points nor cells.
bool isEmpty(vtkDataObject* output);

/// Whether the filter's outputs are empty, and all that it prints of a run is as before any, but
/// for points that are not finite.
bool hasForgotten(vtkFFAlgorithm* filter);

/// What a filter reports of its last run: the engine, the dimension and the
/// numbers.
std::string printedReport(vtkAlgorithm* algorithm);

/// The array vtkOriginalPointIds.
std::vector<vtkIdType> originalIds(vtkPolyData* output);

/// The cells of one kind, each as its corners' original ids.
std::vector<std::vector<vtkIdType>> cellsByOriginalIds(vtkPolyData* output, vtkCellArray* cells);

}

#endif
