// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFFKeptTriangulation.h"

#include "vtkFFPlanarAlgorithm.h"
#include "vtkFFPlanarInput.h"
#include "vtkFFRun.h"

#include "vtkAbstractTransform.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN
namespace
{

template <class To, class From>
flipflop::Buffer<To> copyOf(const flipflop::Buffer<From>& from)
{
  flipflop::Buffer<To> to(from.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(from.size()), 1 << 16,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::transform(from.data() + begin, from.data() + end, to.data() + begin,
        [](From index) { return static_cast<To>(index); });
    });
  return to;
}

}

//------------------------------------------------------------------------------
vtkFFStamp vtkFFKeptTriangulation::StampOf(
  vtkFFPlanarAlgorithm* filter, const vtkFFPlanarInput& input)
{
  vtkFFStamp stamp(filter, input.GetData());
  if (filter->GetProjectionPlaneMode() == vtkFFPlanarAlgorithm::TRANSFORM_PLANE)
  {
    stamp.Add(filter->GetTransform());
  }
  stamp.Add(input.GetWeightArray());
  if (input.GetWeightArray())
  {
    stamp.Add(filter->GetWeightMode());
    stamp.Add(filter->GetWeightFactor());
  }
  return stamp;
}

//------------------------------------------------------------------------------
bool vtkFFKeptTriangulation::Keeps(vtkFFPlanarAlgorithm* filter, const vtkFFRun& run)
{
  return !run.IsInComposite() && !filter->GetReleaseDataFlag();
}

//------------------------------------------------------------------------------
flipflop::Triangulation vtkFFKeptTriangulation::Triangulate(vtkFFPlanarAlgorithm* filter,
  const vtkFFPlanarInput& input, vtkFFRun& run, std::shared_ptr<vtkFFKeptTriangulation>& kept)
{
  const flipflop::FacetMode facets = run.Options.facets;
  const bool keeps = Keeps(filter, run);
  const vtkFFStamp stamp = keeps ? StampOf(filter, input) : vtkFFStamp();
  if (kept && kept->IsOf(stamp, facets))
  {
    run.Report = kept->Report;
    return kept->Copy(facets);
  }
  kept.reset();
  flipflop::Triangulation triangulation = flipflop::regularTriangulation(
    input.GetPlane(), input.GetWeights(), run.Options, run.Engine, run.Report);
  if (keeps && triangulation.connectivity.size() <= std::numeric_limits<std::uint32_t>::max())
  {
    kept.reset(new vtkFFKeptTriangulation(triangulation, stamp, facets, run.Report));
  }
  return triangulation;
}

//------------------------------------------------------------------------------
vtkFFKeptTriangulation::vtkFFKeptTriangulation(const flipflop::Triangulation& triangulation,
  const vtkFFStamp& stamp, flipflop::FacetMode facets, const flipflop::EngineReport& report)
  : Stamp(stamp)
  , Facets(facets)
  , Report(report)
  , Dimension(triangulation.dimension)
  , CellSize(triangulation.cellSize)
  , Statistics(triangulation.statistics)
  , PointIds(copyOf<std::uint32_t>(triangulation.pointIds))
  , HiddenIds(copyOf<std::uint32_t>(triangulation.hiddenIds))
  , Connectivity(copyOf<std::uint32_t>(triangulation.connectivity))
  , Offsets(copyOf<std::uint32_t>(triangulation.offsets))
{
}

//------------------------------------------------------------------------------
bool vtkFFKeptTriangulation::IsOf(const vtkFFStamp& stamp, flipflop::FacetMode facets) const
{
  return this->Stamp == stamp &&
    (this->Facets == facets || this->Facets == flipflop::FacetMode::Polygons);
}

//------------------------------------------------------------------------------
flipflop::Triangulation vtkFFKeptTriangulation::Copy(flipflop::FacetMode facets) const
{
  flipflop::Triangulation triangulation;
  triangulation.dimension = this->Dimension;
  triangulation.cellSize = this->CellSize;
  triangulation.statistics = this->Statistics;
  triangulation.pointIds = copyOf<std::int64_t>(this->PointIds);
  triangulation.hiddenIds = copyOf<std::int64_t>(this->HiddenIds);
  triangulation.connectivity = copyOf<std::int64_t>(this->Connectivity);
  triangulation.offsets = copyOf<std::int64_t>(this->Offsets);
  if (facets == flipflop::FacetMode::Triangles)
  {
    flipflop::fanPolygons(triangulation);
  }
  return triangulation;
}
VTK_ABI_NAMESPACE_END
