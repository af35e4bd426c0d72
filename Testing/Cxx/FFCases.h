// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The filters, for the tests of what they have in common.
#ifndef FFCases_h
#define FFCases_h

#include "FFTest.h"

#include "vtkFFConstrainedDelaunayFilter.h"
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
  const std::vector<std::string> hullSettings{ "Volume", "Area", "CompositeMode",
    "NumberOfStreamDivisions", "GenerateCertificate" };
  const std::vector<std::string> hullSteps{ "Convex hull: scanning", "Convex hull: sorting",
    "Convex hull: finishing" };
  const std::vector<std::string> hullReport{ "FlipFlopVolume", "FlipFlopArea" };
  return {
    { makeFilter<vtkFFHullFilter>, false, false, "Convex hull", hullSteps, hullSettings,
      hullReport },
    { makeHullOfAllBlocks, false, false, "Convex hull", hullSteps, hullSettings, hullReport },
    { makeFilter<vtkFFConvexifyFilter>, true, false, "Convexify",
      { "Convexify: flipping", "Convexify: finishing" },
      { "Volume", "Area", "KernelPoint", "UseKernelPoint" }, hullReport },
    { makeWeightedFilter<vtkFFRegularTriangulationFilter>, false, true, "Regular triangulation",
      { "Regular triangulation: scanning", "Regular triangulation: finishing" },
      withPlanar({ "Alpha", "AlphaLines", "AlphaVerts", "GenerateAlphas", "GenerateBoundary",
        "GenerateCertificate", "MaximumEdgeLength", "NumberOfHiddenPoints",
        "NumberOfDroppedCells" }),
      { "FlipFlopHiddenPoints", "FlipFlopDroppedCells" } },
    { makeWeightedFilter<vtkFFPowerDiagramFilter>, false, true, "Power diagram",
      { "Power diagram: scanning", "Power diagram: making cells" },
      withPlanar({ "PowerDiagramBounds", "PowerDiagramBoxMode", "NumberOfHiddenPoints" }),
      { "FlipFlopHiddenPoints" } },
    { makeFilter<vtkFFConstrainedDelaunayFilter>, false, false,
      "Constrained Delaunay triangulation", {},
      withPlanar({ "MaximumEdgeLength", "SplitCrossingConstraints", "PolygonRule", "SourcePoints",
        "ClosedLinesAsBorders", "NumberOfDroppedCells", "NumberOfSplitPoints",
        "NumberOfAddedPoints", "NumberOfHeightDifferences" }),
      { "FlipFlopDroppedCells", "FlipFlopSplitPoints", "FlipFlopAddedPoints",
        "FlipFlopHeightDifferences" } },
    { makeFilter<vtkFFTerrainMeshFilter>, false, false, "Terrain mesh",
      { "Terrain mesh: scanning", "Terrain mesh: inserting", "Terrain mesh: finishing" },
      { "Tolerance", "MaximumNumberOfVertices", "GreatestError", "NumberOfPointsBeyond",
        "NumberOfUnreachablePoints", "SourcePoints", "NumberOfAddedPoints",
        "NumberOfHeightDifferences" },
      { "FlipFlopTolerance", "FlipFlopGreatestError", "FlipFlopPointsBeyond",
        "FlipFlopUnreachablePoints", "FlipFlopAddedPoints", "FlipFlopHeightDifferences" } },
    { makeFilterOfImages, false, true, "Image of points",
      { "Image of points: scanning", "Image of points: finishing" },
      withPlanar({ "SizeMode", "Dimensions", "Spacing", "UseInputBounds", "SamplingBounds",
        "InterpolationMode", "NullPointsStrategy", "NullValue", "ValidPointsMaskArrayName",
        "InterpolateZ", "ZArrayName", "NumberOfHiddenPoints", "NumberOfDroppedCells" }),
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
