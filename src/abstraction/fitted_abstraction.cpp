// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "abstraction/Solid_abstractor.h"
#include "abstraction/curve_and_sheet_geometry.h"
#include "abstraction/fit_curve.h"
#include "abstraction/fit_sheet.h"
#include "abstraction/inside_test.h"
#include "abstraction/medial_poles.h"
#include "abstraction/recognize_prism.h"
#include "abstraction/skeletonize.h"
#include "abstraction/spatial_graph.h"
#include "base/Nearest_points.h"
#include "base/eigen_system.h"

#include <CGAL/Shape_correspondence/Part_abstraction.h>
#include <CGAL/Shape_correspondence/abstract_part.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

struct Revolution_axis
{
  Point centre;
  Point direction;
  double height = 0;      ///< height of most of the surface, without thin axles
  double slenderness = 0; ///< height over the diameter of most of the surface
  double deviation = 0;   ///< distance by which rotation moves the surface off itself, over the largest radius

  /// The segment of the axis within the extent of the points.
  Curve curve(const Points& points, int control_points) const
  {
    const Eigen::RowVectorXd heights = direction.transpose() * (points.colwise() - centre);
    Curve result;
    result.points.resize(3, control_points);
    for (int i = 0; i < control_points; ++i) {
      const double t = i / (control_points - 1.);
      result.points.col(i) = centre + ((1 - t) * heights.minCoeff() + t * heights.maxCoeff()) * direction;
    }
    return result;
  }
};

double quantile(Eigen::RowVectorXd values, double fraction)
{
  std::sort(values.data(), values.data() + values.size());
  return values[Eigen::Index(fraction * double(values.size() - 1))];
}

/// Candidate directions of an axis of revolution: the coordinate axes, the principal axes and, since principal axes of
/// a compact body may be arbitrary, the direction of its skewness.
std::vector<Point> axis_candidates(const Points& centred)
{
  std::vector<Point> result{Point::UnitY(), Point::UnitX(), Point::UnitZ()};
  const Eigen::Matrix3d principal_axes = eigen_system(scatter_matrix(centred)).vectors;
  for (int k = 0; k < 3; ++k)
    result.push_back(principal_axes.col(k));
  const Point skewness = centred * centred.colwise().squaredNorm().transpose();
  if (skewness.norm() > 0) result.push_back(skewness.normalized());
  return result;
}

/// The axis about which rotation changes the surface least; none if it always changes much. A hexagonal prism passes, a
/// square one does not. \param surface evenly spread points \param spacing their distance
std::optional<Revolution_axis> revolution_axis(const Points& surface, double spacing)
{
  // Largest distance by which rotation moves points off the surface, over the largest radius
  const double tolerance = 0.16;
  const double clearly = 0.02; // least decrease of this ratio for which a direction replaces an earlier one
  const double gap = 0.6;      // allowance for the distance of samples from each other, over the spacing
  const double turns[] = {double(2 * EIGEN_PI / 5), double(2 * EIGEN_PI / 4)};
  const Point centre = surface.rowwise().mean();
  const Points centred = surface.colwise() - centre;
  const Nearest_points points(centred);
  std::optional<Revolution_axis> result;
  double least = tolerance;
  for (const Point& direction : axis_candidates(centred)) {
    const Eigen::RowVectorXd heights = direction.transpose() * centred;
    const Eigen::RowVectorXd radii = (centred - direction * heights).colwise().norm();
    const double most = (least - clearly) * radii.maxCoeff() + gap * spacing;
    double deviation = 0;
    for (double turn : turns) {
      const Eigen::Matrix3d rotation = Eigen::AngleAxisd(turn, direction).toRotationMatrix();
      // Strides make successive angles differ much, so that parts that are not round are rejected early
      const Eigen::Index strides = 16;
      for (Eigen::Index first = 0; first < strides; ++first) {
        for (Eigen::Index i = first; i < centred.cols() && deviation <= most; i += strides)
          deviation = std::max(deviation, points.distance(rotation * centred.col(i)));
      }
    }
    if (deviation <= most) {
      least = std::max(0., deviation - gap * spacing) / radii.maxCoeff();
      const double few = 0.1; // share of the points left out at either end
      const double height = quantile(heights, 1 - few) - quantile(heights, few);
      result = {centre, direction, height, height / (2 * quantile(radii, 1 - few)), least};
    }
  }
  return result;
}

struct Line
{
  Point centre;
  Point direction;

  Points offsets(const Points& points) const
  {
    const Points relative = points.colwise() - centre;
    return relative - direction * (direction.transpose() * relative);
  }
};

Line principal_line(const Points& points)
{
  const Point centre = points.rowwise().mean();
  return {centre, eigen_system(scatter_matrix(points.colwise() - centre)).vectors.col(2)};
}

constexpr int sections_of_a_rod = 12;

/// The medial axis of a rod, divided into sections along a line.
struct Rod_sections
{
  Points centres = Points::Zero(3, sections_of_a_rod);
  Eigen::ArrayXd radii = Eigen::ArrayXd::Zero(sections_of_a_rod); ///< mean distances of the surface from the axis
  /// Root mean square distances of the axis from the sections' centres.
  Eigen::ArrayXd spreads = Eigen::ArrayXd::Zero(sections_of_a_rod);
  Eigen::ArrayXd counts = Eigen::ArrayXd::Zero(sections_of_a_rod);
};

Rod_sections rod_sections(const Points& axis, const Points& surface, const Line& line)
{
  const Eigen::RowVectorXd heights = line.direction.transpose() * (axis.colwise() - line.centre);
  const double low = heights.minCoeff(), height = heights.maxCoeff() - low;
  const auto section = [&](Eigen::Index v) {
    return clamped_cell((heights[v] - low) / height * sections_of_a_rod, sections_of_a_rod - 1);
  };
  Rod_sections result;
  for (Eigen::Index v = 0; v < axis.cols(); ++v) {
    result.centres.col(section(v)) += axis.col(v);
    result.radii[section(v)] += (axis.col(v) - surface.col(v)).norm();
    ++result.counts[section(v)];
  }
  const Eigen::ArrayXd counts = result.counts.max(1);
  result.centres.array().rowwise() /= counts.transpose();
  result.radii /= counts;
  for (Eigen::Index v = 0; v < axis.cols(); ++v) {
    const Point offset = axis.col(v) - result.centres.col(section(v));
    result.spreads[section(v)] += (offset - line.direction.dot(offset) * line.direction).squaredNorm();
  }
  result.spreads = (result.spreads / counts).sqrt();
  return result;
}

/// The curve of a straight rod of any profile: the line through the centres of its medial axis, extended to the
/// surface. None if the part is bent, branches, or is too wide for its thickness.
/// \param axis the medial poles of the vertices of `solid`
/// \param is_convex whether the solid is convex: it then has no branches, and may be wide for its thickness
std::optional<Fitted_curve> straight_curve(const Points& axis, const Part_mesh& solid, int control_points,
                                           bool is_convex)
{
  // Limits of offset and spread, over the section's radius; of the offset of a convex part, over radius plus spread
  const double most_offset = 0.1; // greatest distance of a section's centre from the line
  const double most_spread = 1;   // greatest spread of the medial axis about the centre
  const double fewest = 3;        // least number of points in a section
  const Rod_sections sections = rod_sections(axis, solid.points, principal_line(axis));
  if (sections.counts.minCoeff() < fewest || !(is_convex || (sections.spreads <= most_spread * sections.radii).all()))
    return std::nullopt;
  const Line line = principal_line(sections.centres);
  const Eigen::ArrayXd offsets = line.offsets(sections.centres).colwise().norm().transpose();
  // Centres of wide sections are uncertain, since samples are uneven
  const Eigen::ArrayXd sizes = is_convex ? Eigen::ArrayXd(sections.radii + sections.spreads) : sections.radii;
  if (!(offsets <= most_offset * sizes).all()) return std::nullopt;
  const Eigen::RowVectorXd heights = line.direction.transpose() * (sections.centres.colwise() - line.centre);
  Fitted_curve result;
  result.curve.points.resize(3, 2);
  result.curve.points.col(0) = line.centre + heights.minCoeff() * line.direction;
  result.curve.points.col(1) = line.centre + heights.maxCoeff() * line.direction;
  const Nearest_points surface(solid.points);
  const Inside_test is_inside(solid);
  extend_end(result.curve, false, surface, is_inside);
  extend_end(result.curve, true, surface, is_inside);
  result.curve.points = sample(result.curve, control_points);
  result.residual = std::sqrt(offsets.square().mean());
  return result;
}

/// Whether the medial axis of a part is a layer, as in a thick cushion. That of a block has sheets towards the edges;
/// that of a pebble is hardly more than a point.
bool is_layer(const Intrinsic_layout& layout, double thickness)
{
  const double most_depth = 0.28;        // largest depth of the medial axis, over its width
  const double most_thickness = 2. / 3.; // largest half thickness of the part, over the length of the medial axis
  return layout.extents[2] < most_depth * layout.extents[1] && thickness < most_thickness * layout.extents[0];
}

/// The proportions of a part, measured along its medial axis. A blade is long, but far wider than thick; a block is
/// compact and so thick that its medial axis has no clear direction.
enum class Intrinsic_kind { ELONGATED, BLADE, FLAT, COMPACT, BLOCK };

/// \param layout the layout of the medial axis; the extents of an even layer are 1 / √12 of its sides
/// \param thickness mean distance of the surface from the medial axis
/// \param box extents of the bounding box, longest first
Intrinsic_kind intrinsic_kind(const Intrinsic_layout& layout, double thickness, const Eigen::Vector3d& box)
{
  const double least_width = 0.21;        // width of a sheet, over its length
  const double least_depth = 0.5;         // depth of a compact part, over its width
  const double least_blade_width = 0.075; // width of a blade, over its length
  const double blade_thickness = 0.253; // largest thickness over the width; blades are over 7.8 times as wide as thick
  const double least_thickness = 0.3;   // thickness of a block, over its length
  // Least heights of a block's bounding box, over its length and over its width
  const double least_height = 0.32, plate_height = 0.45;
  const Eigen::Vector3d& extents = layout.extents;
  if (extents[1] <= least_width * extents[0]) {
    const bool is_blade = extents[1] > least_blade_width * extents[0] && thickness < blade_thickness * extents[1];
    return is_blade ? Intrinsic_kind::BLADE : Intrinsic_kind::ELONGATED;
  }
  if (!is_layer(layout, thickness) && thickness > least_thickness * extents[0] && box[2] > least_height * box[0] &&
      box[2] > plate_height * box[1]) {
    return Intrinsic_kind::BLOCK;
  }
  return extents[2] >= least_depth * extents[1] ? Intrinsic_kind::COMPACT : Intrinsic_kind::FLAT;
}

/// Whether a body of revolution is abstracted by its axis rather than by a disc. With a hole through it, only a
/// thin-walled tube is; other such bodies are rings.
bool is_slender(const Revolution_axis& axis, double thickness, bool has_handle)
{
  const double least_slenderness = has_handle ? 0.15 : 1. / 3; // height over diameter
  const double thin_wall = 0.25;                               // largest thickness of the wall, over the height
  return axis.slenderness >= least_slenderness && (!has_handle || 2 * thickness <= thin_wall * axis.height);
}

/// Whether a body of revolution counts as round. Only one with a layer as medial axis, such as a cushion, may not.
bool is_round(const Revolution_axis& axis, const Intrinsic_layout& layout, double thickness)
{
  const double most_deviation = 0.03; // largest deviation, over the radius; a wheel with twelve sides has less
  return !is_layer(layout, thickness) || axis.deviation < most_deviation;
}

/// Whether a part has compact proportions only because it is hollow, like a carcass of boards.
bool is_carcass(const Intrinsic_layout& layout, double thickness)
{
  const double thin_wall = 0.2; // largest half thickness, over the depth
  return thickness < thin_wall * layout.extents[2];
}

/// Euler characteristic: 2 for a connected surface without handles, less 2 for each handle.
Eigen::Index euler_characteristic(const Part_mesh& closed)
{
  return closed.points.cols() - closed.triangles.cols() / 2;
}

/// Finds the curve or sheet of one part: sheets and straight rods from the medial axis, other curves from the skeleton.
class Fitter : public Solid_abstractor
{
  using Solid_abstractor::Solid_abstractor;

  bool find_geometry_from_faces(const Repaired_part& repaired) override
  {
    if (wanted_kind() != Abstraction_kind::AUTOMATIC || repaired.repair == Abstraction_report::Repair::WRAP)
      return false;
    const auto prism = recognize_prism(repaired.mesh, repaired.volume, options().curve_points, options().sheet_points);
    if (prism) use_prism(*prism);
    return prism.has_value();
  }

  void find_geometry(const Part_mesh& solid) override
  {
    const Points poles = medial_poles(solid);
    const Spatial_graph axis = medial_graph(solid, poles);
    const double thickness = (axis.points - solid.points).colwise().norm().mean();
    const Intrinsic_layout layout = layout_of(axis);
    const Oriented_box box = oriented_box(mesh().points);
    const bool has_handle = euler_characteristic(solid) < 2;
    const Intrinsic_kind measured = intrinsic_kind(layout, thickness, box.extents);
    const std::optional<Revolution_axis> revolution = axis_of_revolution(solid, measured);
    report().phases.fit = lap();
    if (revolution && is_slender(*revolution, thickness, has_handle) && is_round(*revolution, layout, thickness)) {
      report().tube = has_handle;
      use_axis(revolution->curve(mesh().points, options().curve_points));
      return;
    }
    // Parts that are flat as a whole, though their medial axes are not: discs on long axles, and flat carcasses
    const bool is_disc = revolution && !has_handle && measured != Intrinsic_kind::FLAT;
    const bool is_flat_carcass =
        measured == Intrinsic_kind::COMPACT && is_carcass(layout, thickness) && is_flat(box.extents);
    const Intrinsic_kind kind = is_disc || is_flat_carcass ? Intrinsic_kind::FLAT : measured;
    const auto sheet = [&] {
      return is_disc ? sheet_seen_across(axis.points, box)
             : is_flat_carcass
                 ? fit_flat_sheet({box.centre, box.axes}, axis.points, mesh().points, options().sheet_points)
                 : fitted_sheet(axis.points, layout, thickness, box);
    };
    if (wanted_kind() == Abstraction_kind::SHEET) {
      use_sheet(sheet(), Method::MEDIAL_AXIS);
      return;
    }
    if (kind == Intrinsic_kind::BLOCK && !has_handle) {
      use_axis(medial_curve(box, options().curve_points, distinct_axis(box)));
      return;
    }
    // Largest residual of a fit. A blade with branching arms has more, and so has a net, which no single curve follows
    const double most = 0.02 * diagonal_of_part();
    if (wanted_kind() == Abstraction_kind::AUTOMATIC && !has_handle &&
        (kind == Intrinsic_kind::FLAT || kind == Intrinsic_kind::BLADE)) {
      const Fitted_sheet fitted = sheet();
      if (kind == Intrinsic_kind::FLAT || fitted.residual < most) {
        use_sheet(fitted, Method::MEDIAL_AXIS);
        return;
      }
    }
    if (kind == Intrinsic_kind::ELONGATED && !has_handle) {
      if (const std::optional<Fitted_curve> straight =
              straight_curve(axis.points, solid, options().curve_points, is_convex())) {
        use_curve(*straight, Method::MEDIAL_AXIS);
        return;
      }
    }
    const Fitted_curve fitted = contracted_curve(solid, axis.points);
    // Half of that limit for rings, whose skeletons have no branches off the curve
    const bool is_net = fitted.residual > (fitted.curve.closed ? 0.5 : 1.) * most;
    if (wanted_kind() == Abstraction_kind::AUTOMATIC &&
        (report().tube || (is_net && is_flat(box.extents)) || (kind == Intrinsic_kind::FLAT && !fitted.curve.closed))) {
      use_sheet(sheet(), Method::MEDIAL_AXIS); // includes propellers and pedals
    } else if ((is_net && fitted.curve.closed) || (is_point(fitted) && !is_flat(box.extents))) {
      use_axis(medial_curve(box, options().curve_points, distinct_axis(box))); // includes cages and open boxes
    } else {
      report().blob = (kind == Intrinsic_kind::COMPACT || kind == Intrinsic_kind::BLOCK) && !fitted.curve.closed;
      use_curve(fitted, Method::SKELETON);
    }
  }

private:
  /// Whether the part is nearly convex: a connected surface, not wrapped, that fills almost all of its convex hull.
  bool is_convex()
  {
    const double least_solidity = 0.97;
    return !report().several_components && report().repair != Abstraction_report::Repair::WRAP &&
           volume() > least_solidity * hull_volume();
  }

  /// The curve found by the flow. Also finds whether the part is a tube.
  Fitted_curve contracted_curve(const Part_mesh& solid, const Points& axis)
  {
    const double tube_area = 0.5; // least share of the area that a tube keeps when its volume is gone
    Stepwise_flow flow(solid, options().maximum_iterations, deadline());
    flow.run_to_volume(options().stop_volume);
    const double area_kept = flow.area_kept();
    flow.run_to_convergence();
    report().iterations = flow.iterations();
    report().phases.flow = lap();
    const Fitted_curve result = fit_curve(flow.curve_skeleton(), axis, solid, options().curve_points);
    report().tube = result.curve.closed && area_kept > tube_area;
    return result;
  }

  Intrinsic_layout layout_of(const Spatial_graph& axis) const
  {
    Spatial_graph_view layer(axis);
    layer.connect_near(edge_length());
    return intrinsic_layout(layer);
  }

  /// The axis of a body of revolution that is not elongated: a skeleton of it might have any direction.
  std::optional<Revolution_axis> axis_of_revolution(const Part_mesh& solid, Intrinsic_kind kind) const
  {
    if (wanted_kind() == Abstraction_kind::SHEET || kind == Intrinsic_kind::ELONGATED) return std::nullopt;
    return revolution_axis(solid.points, edge_length());
  }

  /// A sheet as a height field over the principal plane of the medial axis or, for a part that was wrapped, of its box:
  /// the medial axis of a wrap differs with the version of CGAL, which could turn the sheet of a wheel with spokes.
  Fitted_sheet sheet_seen_across(const Points& axis, const Oriented_box& box) const
  {
    return report().repair == Abstraction_report::Repair::WRAP
               ? fit_sheet({box.centre, box.axes}, axis, mesh().points, options().sheet_points)
               : fit_sheet(axis, mesh().points, options().sheet_points);
  }

  /// A sheet as a height field or, if the part is bent too much for that, along the part itself.
  Fitted_sheet fitted_sheet(const Points& axis, const Intrinsic_layout& layout, double thickness,
                            const Oriented_box& box) const
  {
    const double bent = 0.4; // least depth over width of a medial axis that may be too bent
    const Fitted_sheet seen = sheet_seen_across(axis, box);
    const Eigen::Vector3d extents = principal_variances(axis).cwiseSqrt();
    if (extents[2] < bent * extents[1]) return seen;
    const Fitted_sheet along =
        fit_bent_sheet(axis, layout.coordinates, thickness, mesh().points, options().sheet_points);
    return along.residual < seen.residual ? along : seen;
  }
};

} // namespace

Part_abstraction Fitted_abstraction::operator()(const Shape_part& part, const Abstraction_options& options) const
{
  return Fitter(part, options).run();
}

} // namespace CGAL::Shape_correspondence
