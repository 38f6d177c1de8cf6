// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "abstraction/Solid_abstractor.h"
#include "abstraction/bounding_box.h"
#include "abstraction/fit_curve.h"
#include "abstraction/fit_sheet.h"
#include "abstraction/intrinsic_extent.h"
#include "abstraction/skeletonize.h"
#include "abstraction/spatial_graph.h"

#include <CGAL/Shape_correspondence/abstract_part.h>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

/// What the meso-skeleton of a part is like when it is measured along itself.
enum class Meso_kind { CURVE, SHEET, BLOB };

/// \param extents of the meso-skeleton, longest first
/// \param area_kept of the part's surface
Meso_kind meso_kind(const Eigen::Vector3d& extents, double area_kept)
{
  // Set on 62 parts that were abstracted by hand
  const double least_width = 0.2; // of a sheet, over its length
  const double least_depth = 0.5; // of a blob, over its width
  const double least_area = 0.1;  // of a sheet, over that of the part's surface
  if (extents[1] <= least_width * extents[0]) return Meso_kind::CURVE;
  if (extents[2] >= least_depth * extents[1]) return Meso_kind::BLOB;
  return area_kept > least_area ? Meso_kind::SHEET : Meso_kind::CURVE;
}

/// Finds curves on the converged skeleton, sheets on the meso-skeleton.
class Mean_curvature_abstractor : public Solid_abstractor
{
  using Solid_abstractor::Solid_abstractor;

  void find_geometry(const Part_mesh& solid) override
  {
    Stepwise_flow flow(solid, options().maximum_iterations, deadline());
    flow.run_to_volume(options().stop_volume);
    const Part_mesh meso_skeleton = flow.meso_skeleton();
    const Meso_kind kind = meso_kind(extents_of(meso_skeleton), flow.area_kept());
    flow.run_to_convergence();
    report().iterations = flow.iterations();
    report().phases.flow = lap();
    const Fitted_curve curve = skeleton_curve(flow.curve_skeleton(), solid, options().curve_points);
    const bool is_ring = curve.curve.closed && curve.coverage >= least_coverage;
    if (wanted_kind() == Abstraction_kind::SHEET ||
        (wanted_kind() == Abstraction_kind::AUTOMATIC && kind == Meso_kind::SHEET && !is_ring)) {
      use_sheet(fit_sheet(meso_skeleton.points, meso_skeleton.points, options().sheet_points), Method::MESO_SKELETON);
    } else if (kind == Meso_kind::BLOB && !is_ring) {
      use_axis(medial_curve(oriented_box(mesh().points), options().curve_points));
    } else {
      use_curve(curve, Method::SKELETON);
    }
  }

  static Eigen::Vector3d extents_of(const Part_mesh& meso_skeleton)
  {
    const Spatial_graph graph = edge_graph(meso_skeleton);
    return intrinsic_layout(Spatial_graph_view(graph)).extents;
  }
};

} // namespace

Part_abstraction Mean_curvature_abstraction::operator()(const Shape_part& part,
                                                        const Abstraction_options& options) const
{
  return Mean_curvature_abstractor(part, options).run();
}

} // namespace CGAL::Shape_correspondence
