// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFFRegularTriangulationFilter
 * @brief   the exact Delaunay triangulation in the plane, with weights or with given edges
 *
 * vtkFFRegularTriangulationFilter computes the Delaunay triangulation of the points of any data
 * set; of weighted points, it is the regular triangulation, the dual of vtkFFPowerDiagramFilter's
 * diagram. Cells of the input are ignored. vtkFFPlanarAlgorithm says in which plane, and how to
 * give weights. A second input has constraints: lines and polygons that are to be edges. The
 * triangulation is exact for every finite input. At most 2^32 - 2 points can be given, about 5e8 if
 * nearly all appear.
 *
 * The algorithm is ffRT of the paper named in vtkFFAlgorithm. A point appears if its lift is a
 * strictly extreme vertex of the lower hull; all others are hidden, also ties. Without weights,
 * only duplicates are hidden, by the lowest id.
 *
 * Port 0, the triangulation, has the points that appear, by ascending id, with their original
 * position, type and bits, and the point array vtkOriginalPointIds (a vtkIdTypeArray). Triangles
 * are counter-clockwise as seen from the plane's upper side, none without area. Each cell starts
 * at its lowest id; all are in lexicographic order. Points on a line give a chain of lines, one
 * position gives a vertex. Port 1 has a vertex for each hidden point, by ascending id. Port 2 is
 * the border of the cells: see SetGenerateBoundary(). Port 3 has a line for each edge that a
 * constraint runs along, with the points of port 0, and the cell array ConstraintCellIds (a
 * vtkIdTypeArray): the first such cell.
 *
 * @sa
 * vtkFFPlanarAlgorithm vtkFFPowerDiagramFilter vtkPFFRegularTriangulationFilter vtkDelaunay2D
 */

#ifndef vtkFFRegularTriangulationFilter_h
#define vtkFFRegularTriangulationFilter_h

#include "vtkFFMarks.h" // For VTK_MARSHALAUTO
#include "vtkFFPlanarAlgorithm.h"
#include "vtkFiltersFlipFlopModule.h" // For export macro

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithmOutput;

class VTKFILTERSFLIPFLOP_EXPORT VTK_MARSHALAUTO vtkFFRegularTriangulationFilter
  : public vtkFFPlanarAlgorithm
{
public:
  ///@{
  /// Standard methods for instantiation, type information and printing.
  static vtkFFRegularTriangulationFilter* New();
  vtkTypeMacro(vtkFFRegularTriangulationFilter, vtkFFPlanarAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /// How the polygons of the source define what is inside.
  enum PolygonRuleType
  {
    EVEN_ODD = 0,
    DIRECTION = 1
  };

  ///@{
  /**
   * Set/Get alpha, a length: port 0 has the alpha complex of the triangulation. 0 by default: all
   * of it. As in vtkDelaunay2D, a triangle stays if its circumcircle has at most the radius Alpha;
   * that is decided exactly. With weights, it is the circle of power distance 0 from the corners,
   * by the squares of both; the circle's may be negative. A negative number and NaN are errors.
   *
   * AlphaLines adds the edges of no triangle that stays, whose own least circle has at most the
   * radius Alpha and no point in it (with constraints: no corner of the cells at the edge), as
   * lines; AlphaVerts adds the points that are left as vertices. GenerateAlphas adds the cell array
   * Alpha (vtkDoubleArray): the least Alpha for which a cell stays, rounded up (negative for a
   * negative square), for a vtkThreshold. All are off by default.
   */
  vtkSetMacro(Alpha, double);
  vtkGetMacro(Alpha, double);
  vtkSetMacro(AlphaLines, bool);
  vtkGetMacro(AlphaLines, bool);
  vtkBooleanMacro(AlphaLines, bool);
  vtkSetMacro(AlphaVerts, bool);
  vtkGetMacro(AlphaVerts, bool);
  vtkBooleanMacro(AlphaVerts, bool);
  vtkSetMacro(GenerateAlphas, bool);
  vtkGetMacro(GenerateAlphas, bool);
  vtkBooleanMacro(GenerateAlphas, bool);
  ///@}

  ///@{
  /**
   * Set/Get the length of the longest edge, in the plane, that a triangle or line of port 0 may
   * have, of those that Alpha leaves. 0 by default: any. One as long stays: that is decided
   * exactly. Of a polygon, the border counts. All points stay. A negative number and NaN are
   * errors.
   */
  vtkSetMacro(MaximumEdgeLength, double);
  vtkGetMacro(MaximumEdgeLength, double);
  ///@}

  ///@{
  /**
   * Set/Get whether port 2 gives the border of the cells of port 0 as closed polylines, with cells
   * on the left of each. Off by default. None passes a point twice; they may meet in points. Each
   * starts at its lowest id; they are in lexicographic order.
   */
  vtkSetMacro(GenerateBoundary, bool);
  vtkGetMacro(GenerateBoundary, bool);
  vtkBooleanMacro(GenerateBoundary, bool);
  ///@}

  ///@{
  /**
   * Set/Get the second input, on port 1, a vtkPolyData: the constraints. None by default. Its
   * lines, polylines and polygons become edges; all other edges are Delaunay as far as the
   * constraints let points see each other. Their order does not matter. A constraint through points
   * is parted there, and one that ends at a duplicate ends at the lowest id of that position.
   *
   * The CPU engine does the work. A composite of several data sets on port 0, weights, and asking
   * for the CUDA engine are errors then. So is a constraint whose point is not there or is left
   * out.
   */
  void SetSourceData(vtkDataObject* source) { this->SetInputData(1, source); }
  void SetSourceConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void RemoveSource() { this->SetSourceConnection(nullptr); }
  vtkDataObject* GetSource() { return this->GetSecondInput(); }
  ///@}

  ///@{
  /**
   * Set/Get whose points the cells of the source name. Points are compared before a transform.
   *
   * - AUTOMATIC_POINTS (the default): the input's, if the source has
   *   no points, or if at all ids that its cells name its points are
   *   the input's, in all three coordinates. Otherwise its own.
   * - INPUT_POINTS: the input's, by id, as in vtkDelaunay2D. If the
   *   source has points, others at these ids are an error (XY_PLANE:
   *   by x and y).
   * - OWN_POINTS: the source's.
   *
   * Own points that cells name join the input's, after them, with the point data of the same name
   * and number of components (NaN or 0 where the source has none) and -1 in vtkOriginalPointIds. At
   * the position of a point of the input, in the plane, that point is used; of several own points
   * at one position, the first.
   *
   * With own points, or if crossing constraints are split, the output has the point array
   * PointOrigin (a vtkUnsignedCharArray): 0 for points of the input, 1 for those that the source
   * adds, 2 for those where constraints cross. For XY_PLANE it also has HeightRange, a
   * vtkDoubleArray of two components: the lowest and the highest z that is given for a point, by
   * itself, by points of the source at its position, and by the lines that end there or run through
   * it. GetNumberOfHeightDifferences() returns at how many points these differ.
   */
  vtkSetClampMacro(SourcePoints, int, AUTOMATIC_POINTS, OWN_POINTS);
  vtkGetMacro(SourcePoints, int);
  void SetSourcePointsToAutomaticPoints() { this->SetSourcePoints(AUTOMATIC_POINTS); }
  void SetSourcePointsToInputPoints() { this->SetSourcePoints(INPUT_POINTS); }
  void SetSourcePointsToOwnPoints() { this->SetSourcePoints(OWN_POINTS); }
  ///@}

  ///@{
  /**
   * Set/Get whether constraints are split where they cross between points. Off by default: they
   * are an error that names both cells.
   *
   * The output then has a new point at each crossing, after the others, at the double nearest to it
   * in the plane: constraints bend there by half a unit in the last place at most, and stay on the
   * points that are on them. Its position in space and its point data are interpolated along the
   * first of the constraints that cross there; data that cannot be is not passed then. Points are
   * double, and new ones have -1 in vtkOriginalPointIds.
   */
  vtkSetMacro(SplitCrossingConstraints, bool);
  vtkGetMacro(SplitCrossingConstraints, bool);
  vtkBooleanMacro(SplitCrossingConstraints, bool);
  ///@}

  ///@{
  /**
   * Set/Get how polygons of the source define what is inside. Cells outside are left out and
   * counted. Without polygons, and where all points are on one line, all cells stay.
   *
   * - EVEN_ODD (the default): inside is where a way from outside
   *   crosses an odd number of sides. So a polygon in one is a hole.
   * - DIRECTION: as in vtkDelaunay2D, what is on the left of a side,
   *   as seen from the plane's upper side, is inside: holes run
   *   clockwise. Polygons that disagree are an error that names two
   *   of them, and which to reverse.
   */
  vtkSetClampMacro(PolygonRule, int, EVEN_ODD, DIRECTION);
  vtkGetMacro(PolygonRule, int);
  void SetPolygonRuleToEvenOdd() { this->SetPolygonRule(EVEN_ODD); }
  void SetPolygonRuleToDirection() { this->SetPolygonRule(DIRECTION); }
  ///@}

  ///@{
  /**
   * Set/Get whether closed lines of the source are polygons, too. Off by default. Lines are joined
   * end to end first, at positions where exactly two of their ends are. One that then ends where it
   * begins is closed, unless it encloses nothing, or runs all the way along the outline of the
   * source's polygons and of the closed lines before it.
   */
  vtkSetMacro(ClosedLinesAsBorders, bool);
  vtkGetMacro(ClosedLinesAsBorders, bool);
  vtkBooleanMacro(ClosedLinesAsBorders, bool);
  ///@}

  ///@{
  /**
   * Get how many points the last run added: where constraints cross, and of the source; and at how
   * many points several heights were given that differ.
   */
  vtkIdType GetNumberOfSplitPoints() { return this->Report.NumberOfSplitPoints; }
  vtkIdType GetNumberOfAddedPoints() { return this->Report.NumberOfAddedPoints; }
  vtkIdType GetNumberOfHeightDifferences() { return this->Report.NumberOfHeightDifferences; }
  ///@}

protected:
  vtkFFRegularTriangulationFilter();
  ~vtkFFRegularTriangulationFilter() override = default;

  void Execute(vtkDataObject* data, vtkInformationVector** inputVector,
    const std::vector<vtkDataObject*>& results, FFRun& run) override;
  const char* GetTitle() const override { return "Delaunay triangulation"; }

  double Alpha = 0.0;
  bool AlphaLines = false;
  bool AlphaVerts = false;
  bool GenerateAlphas = false;
  double MaximumEdgeLength = 0.0;
  bool GenerateBoundary = false;
  int SourcePoints = AUTOMATIC_POINTS;
  bool SplitCrossingConstraints = false;
  int PolygonRule = EVEN_ODD;
  bool ClosedLinesAsBorders = false;

private:
  vtkFFRegularTriangulationFilter(const vtkFFRegularTriangulationFilter&) = delete;
  void operator=(const vtkFFRegularTriangulationFilter&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
