// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The filters, for the tests of what they have in common.
#ifndef FFCases_h
#define FFCases_h

#include "FFTest.h"

#include "vtkFFConvexifyFilter.h"
#include "vtkFFHullFilter.h"
#include "vtkFFPointsToImage.h"
#include "vtkFFPowerDiagramFilter.h"
#include "vtkFFRegularTriangulationFilter.h"
#include "vtkFFTerrainMeshFilter.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

namespace fftest
{

/// A filter, and what is its own.
struct FilterCase
{
  std::function<vtkSmartPointer<vtkFFAlgorithm>()> New;
  bool TakesSurface; ///< or points
  bool IsWeighted;   ///< by the array "weights", which New() chooses
  std::string Title; ///< of its progress
  std::vector<std::string> Steps;
  std::vector<std::string> Settings; ///< that it prints, besides those of vtkFFAlgorithm
  std::vector<std::string> Report;   ///< arrays of field data, besides those of vtkFFAlgorithm
  bool MakesImage = false;           ///< or poly data, of points with ids
};

template <class FilterT>
vtkSmartPointer<vtkFFAlgorithm> makeFilter()
{
  return vtkSmartPointer<FilterT>::New();
}

template <class FilterT>
vtkSmartPointer<vtkFFAlgorithm> makeWeightedFilter()
{
  auto filter = vtkSmartPointer<FilterT>::New();
  useWeights(filter);
  return filter;
}

inline vtkSmartPointer<vtkFFAlgorithm> makeHullOfAllBlocks()
{
  auto filter = vtkSmartPointer<vtkFFHullFilter>::New();
  filter->SetCompositeMode(vtkFFHullFilter::HULL_OF_ALL_BLOCKS);
  return filter;
}

inline vtkSmartPointer<vtkFFAlgorithm> makeFilterOfImages()
{
  auto filter = vtkSmartPointer<vtkFFPointsToImage>::New();
  filter->SetDimensions(12, 9);
  useWeights(filter);
  return filter;
}

inline std::vector<FilterCase> filterCases()
{
  const std::string planar[] = { "ProjectionPlaneMode", "Transform", "WeightMode", "WeightFactor",
    "GenerateCellMeasures" };
  const auto withPlanar = [&](std::vector<std::string> own)
  {
    own.insert(own.end(), std::begin(planar), std::end(planar));
    return own;
  };
  const std::vector<std::string> hullSettings{ "CompositeMode", "NumberOfStreamDivisions" };
  const std::vector<std::string> hullSteps{ "Convex hull: scanning", "Convex hull: sorting",
    "Convex hull: finishing" };
  const std::vector<std::string> hullReport{ "FlipFlopVolume", "FlipFlopArea" };
  const std::vector<std::string> triangulationSteps{ "Delaunay triangulation: scanning",
    "Delaunay triangulation: finishing" };
  const std::vector<std::string> triangulationSettings = withPlanar({ "Alpha", "AlphaLines",
    "AlphaVerts", "GenerateAlphas", "MaximumEdgeLength", "GenerateBoundary", "SourcePoints",
    "SplitCrossingConstraints", "PolygonRule", "ClosedLinesAsBorders" });
  const std::vector<std::string> triangulationReport{ "FlipFlopHiddenPoints",
    "FlipFlopDroppedCells" };
  return {
    { makeFilter<vtkFFHullFilter>, false, false, "Convex hull", hullSteps, hullSettings,
      hullReport },
    { makeHullOfAllBlocks, false, false, "Convex hull", hullSteps, hullSettings, hullReport },
    { makeFilter<vtkFFConvexifyFilter>, true, false, "Convexify",
      { "Convexify: flipping", "Convexify: finishing" }, { "KernelPoint", "UseKernelPoint" },
      hullReport },
    { makeWeightedFilter<vtkFFRegularTriangulationFilter>, false, true, "Delaunay triangulation",
      triangulationSteps, triangulationSettings, triangulationReport },
    { makeFilter<vtkFFRegularTriangulationFilter>, false, false, "Delaunay triangulation",
      triangulationSteps, triangulationSettings, triangulationReport },
    { makeWeightedFilter<vtkFFPowerDiagramFilter>, false, true, "Power diagram",
      { "Power diagram: scanning", "Power diagram: making cells" },
      withPlanar({ "PowerDiagramBounds", "PowerDiagramBoxMode" }), { "FlipFlopHiddenPoints" } },
    { makeFilter<vtkFFTerrainMeshFilter>, false, false, "Terrain mesh",
      { "Terrain mesh: scanning", "Terrain mesh: inserting", "Terrain mesh: finishing" },
      { "Tolerance", "MaximumNumberOfVertices", "SourcePoints" },
      { "FlipFlopTolerance", "FlipFlopGreatestError", "FlipFlopPointsBeyond",
        "FlipFlopUnreachablePoints", "FlipFlopSplitPoints", "FlipFlopAddedPoints",
        "FlipFlopHeightDifferences" } },
    { makeFilterOfImages, false, true, "Image of points",
      { "Image of points: scanning", "Image of points: finishing" },
      withPlanar({ "SizeMode", "Dimensions", "Spacing", "UseInputBounds", "SamplingBounds",
        "InterpolationMode", "NullPointsStrategy", "NullValue", "ValidPointsMaskArrayName",
        "InterpolateZ", "ZArrayName" }),
      { "FlipFlopHiddenPoints" }, true },
  };
}

/// Those that take points, whatever cells these have.
inline std::vector<FilterCase> casesOfPoints()
{
  std::vector<FilterCase> cases;
  for (const FilterCase& one : filterCases())
  {
    if (!one.TakesSurface)
    {
      cases.push_back(one);
    }
  }
  return cases;
}

}

#endif
