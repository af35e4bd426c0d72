// SPDX-FileCopyrightText: Copyright (c) 2026 the FlipFlop authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// CGAL's Delaunay_triangulation_2, with a hierarchy for positions anywhere, and
/// Regular_triangulation_2. Near the last point, its face is the hint.
#include "Edits.h"
#include "Problems.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_2.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_hierarchy_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <memory>

namespace flipflop
{
namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using HierarchyVertex =
  CGAL::Triangulation_hierarchy_vertex_base_2<CGAL::Triangulation_vertex_base_2<Kernel>>;
using Hierarchy = CGAL::Triangulation_hierarchy_2<
  CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<HierarchyVertex>>>;

template <class Triangulation, class Site>
class CgalEdits final : public Program
{
public:
  void prepare(const Input& given) override
  {
    this->points = EditedPoints(given);
    std::vector<std::size_t> order(static_cast<std::size_t>(given.count()));
    std::vector<Kernel::Point_2> positions;
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      order[i] = i;
      positions.emplace_back(given.xyz[3 * i], given.xyz[3 * i + 1]);
    }
    const auto map = CGAL::make_property_map(positions);
    CGAL::spatial_sort(
      order.begin(), order.end(), CGAL::Spatial_sort_traits_adapter_2<Kernel, decltype(map)>(map));
    this->handles.resize(order.size());
    Face hint;
    for (const std::size_t i : order)
    {
      this->handles[i] = this->triangulation.insert(siteOf(given.xyz.data() + 3 * i), hint);
      hint = this->handles[i]->face();
    }
  }
  void run() override
  {
    const std::size_t count = this->points.count;
    this->times.time("insert_far", count,
      [&]
      {
        for (std::size_t i = 0; i < count; ++i)
        {
          this->triangulation.insert(siteOf(&this->points.far[3 * i]));
        }
      });
    std::vector<Handle> near;
    this->times.time("insert_near", count,
      [&]
      {
        for (std::size_t i = 0; i < count; ++i)
        {
          near.push_back(this->triangulation.insert(
            siteOf(&this->points.near[3 * i]), near.empty() ? Face() : near.back()->face()));
        }
      });
    this->times.time("remove_near", count,
      [&]
      {
        for (std::size_t i = count; i-- > 0;)
        {
          this->triangulation.remove(near[i]);
        }
      });
    std::vector<Handle> gone;
    for (const std::size_t i : this->points.gone)
    {
      if (this->handles[i] != Handle())
      {
        gone.push_back(this->handles[i]);
        this->handles[i] = Handle();
      }
    }
    this->times.time("remove_far", gone.size(),
      [&]
      {
        for (const Handle& handle : gone)
        {
          this->triangulation.remove(handle);
        }
      });
    std::vector<Site> many;
    for (std::size_t i = 0; i < count; ++i)
    {
      many.push_back(siteOf(&this->points.many[3 * i]));
    }
    this->times.time(
      "insert_many", count, [&] { this->triangulation.insert(many.begin(), many.end()); });
  }
  Metrics metrics() const override { return this->times.metrics(); }

private:
  using Handle = typename Triangulation::Vertex_handle;
  using Face = typename Triangulation::Face_handle;

  static Site siteOf(const double* x)
  {
    if constexpr (std::is_same_v<Site, Kernel::Point_2>)
    {
      return Site(x[0], x[1]);
    }
    else
    {
      return Site(Kernel::Point_2(x[0], x[1]), x[2]);
    }
  }

  EditedPoints points;
  Triangulation triangulation;
  std::vector<Handle> handles; ///< of the points at the beginning
  EditTimes times;
};

using DelaunayEdits = CgalEdits<Hierarchy, Kernel::Point_2>;
using RegularEdits = CgalEdits<CGAL::Regular_triangulation_2<Kernel>, Kernel::Weighted_point_2>;

}

std::vector<ProgramKind> cgalEditsPrograms()
{
  return { ProgramKind::exactPeer(
             "cgal-delaunay", [](const Settings&) { return std::make_unique<DelaunayEdits>(); })
             .withoutWeights(),
    ProgramKind::exactPeer(
      "cgal-regular", [](const Settings&) { return std::make_unique<RegularEdits>(); }) };
}

}
