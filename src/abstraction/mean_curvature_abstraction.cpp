// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "abstraction/Solid_abstractor.h"
#include "abstraction/bounding_box.h"
#include "abstraction/fit_curve.h"
#include "abstraction/fit_sheet.h"
#include "abstraction/meso_kind.h"
#include "abstraction/skeletonize.h"
#include "abstraction/surface_samples.h"

#include <CGAL/Shape_correspondence/abstract_part.h>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

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
