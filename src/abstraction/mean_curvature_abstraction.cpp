// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "abstraction/Solid_abstractor.h"
#include "abstraction/curve_and_sheet_geometry.h"
#include "abstraction/fit_curve.h"
#include "abstraction/fit_sheet.h"
#include "abstraction/skeletonize.h"
#include "abstraction/spatial_graph.h"
#include "abstraction/surface_samples.h"

#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/abstract_part.h>

#include <cmath>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

enum class Meso_kind { CURVE, SHEET, BLOB };

/// Measures of a meso-skeleton after most of the part's volume is gone.
struct Meso_measures
{
  double area_kept = 0; ///< area of the meso-skeleton over that of the part
  /// Intrinsic extents, as if its points were spread evenly in a box; longest first.
  Eigen::Vector3d extents = Eigen::Vector3d::Zero();
  double thickness = 0; ///< thickness of the part: its volume over half of its area
};

Meso_measures meso_measures(const Part_mesh& meso_skeleton, double area_kept, double thickness)
{
  const double box_over_root_mean_square = std::sqrt(12.);
  const Spatial_graph graph = edge_graph(meso_skeleton);
  return {area_kept, box_over_root_mean_square * intrinsic_layout(Spatial_graph_view(graph)).extents, thickness};
}

/// The kind of a part whose flow stopped at 2 % of its volume. Thresholds were chosen on parts of known kinds.
Meso_kind meso_kind(const Meso_measures& measures)
{
  const double sheet_area = 0.36; // share of the area that only sheets keep; that of a rod falls as √volume, to 0.14
  const double thin_sheet_area = 0.14; // share of the area that thin sheets keep: the flow draws their rims far inwards
  const double thin_sheet_width = 5;   // least width of a thin sheet, over its thickness
  const double blob_width = 0.2;       // least width of a blob, over its length
  const double blob_depth = 0.5;       // least depth of a blob, over its width
  const Eigen::Vector3d& extents = measures.extents;
  const bool is_thin_sheet = measures.area_kept > thin_sheet_area && extents[1] > thin_sheet_width * measures.thickness;
  if (is_thin_sheet || measures.area_kept > sheet_area) return Meso_kind::SHEET;
  return extents[1] > blob_width * extents[0] && extents[2] >= blob_depth * extents[1] ? Meso_kind::BLOB
                                                                                       : Meso_kind::CURVE;
}

/// Finds curves on the converged skeleton, sheets on the meso-skeleton.
class Mean_curvature_abstractor : public Solid_abstractor
{
  using Solid_abstractor::Solid_abstractor;

  void find_geometry(const Part_mesh& solid) override
  {
    Stepwise_flow flow(solid, options().maximum_iterations, deadline());
    flow.set_weights(slow_flow);
    flow.run_to_volume(options().stop_volume);
    const Part_mesh meso_skeleton = flow.meso_skeleton();
    const double thickness = 2 * volume() / surface_area(solid);
    const Meso_kind kind = meso_kind(meso_measures(meso_skeleton, flow.area_kept(), thickness));
    flow.set_weights(Flow_weights());
    flow.run_to_convergence();
    report().iterations = flow.iterations();
    report().phases.flow = lap();
    const Fitted_curve curve = skeleton_curve(flow.curve_skeleton(), solid, options().curve_points);
    const bool is_ring = curve.curve.closed && curve.coverage >= least_coverage;
    if (wanted_kind() == Abstraction_kind::SHEET ||
        (wanted_kind() == Abstraction_kind::AUTOMATIC && kind == Meso_kind::SHEET && !is_ring)) {
      use_sheet(fit_sheet(meso_skeleton.points, meso_skeleton.points, options().sheet_points), Method::MESO_SKELETON);
    } else if ((kind == Meso_kind::BLOB && !is_ring) || is_point(curve)) {
      const Oriented_box box = oriented_box(mesh().points);
      use_axis(medial_curve(box, options().curve_points, distinct_axis(box)));
    } else {
      use_curve(curve, Method::SKELETON);
    }
  }
};

} // namespace

Part_abstraction Mean_curvature_abstraction::operator()(const Shape_part& part,
                                                        const Abstraction_options& options) const
{
  return Mean_curvature_abstractor(part, options).run();
}

} // namespace CGAL::Shape_correspondence
