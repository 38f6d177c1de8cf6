// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Blend_structure.h"

#include "base/quantized.h"
#include "blend/Blend_stage.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace CGAL::Shape_correspondence::internal {
namespace {

Eigen::Array3i lattice_cells(const contacts::Box& box)
{
  constexpr double least_side = 0.06; // least side of a cell, over the height
  constexpr double most_cells = 4000;
  const Point sizes = box.sizes().cwiseMax(least_side);
  const double side = std::max(least_side, std::cbrt(sizes.prod() / most_cells));
  return (sizes.array() / side).ceil().cast<int>();
}

/// The nodes of a lattice over a box; the last axis runs fastest.
Points lattice_nodes(const contacts::Box& box, const Eigen::Array3i& cells)
{
  Points result(3, (cells + 1).prod());
  Eigen::Index at = 0;
  for (int i = 0; i <= cells[0]; ++i)
    for (int j = 0; j <= cells[1]; ++j)
      for (int k = 0; k <= cells[2]; ++k)
        result.col(at++) = box.min().array() + Eigen::Array3d(i, j, k) / cells.cast<double>() * box.sizes().array();
  return result;
}

/// The box with a minimum thickness, since points in a plane do not determine a motion of space.
contacts::Box thickened(const contacts::Box& box)
{
  constexpr double thin = 0.01; // least extent of the box along an axis, over the height
  const Point half = box.sizes().cwiseMax(thin) / 2;
  return {box.center() - half, box.center() + half};
}

/// Points of a surface, each the farthest from those before.
Points spread_points(const Points& surface, Eigen::Index count)
{
  Points result(3, std::min(count, surface.cols()));
  Eigen::RowVectorXd distances = (surface.colwise() - surface.rowwise().mean()).colwise().squaredNorm();
  for (Eigen::Index i = 0; i < result.cols(); ++i) {
    Eigen::Index farthest = 0;
    for (Eigen::Index j = 1; j < distances.size(); ++j)
      if (quantized(distances[j]) > quantized(distances[farthest])) farthest = j;
    result.col(i) = surface.col(farthest);
    const Eigen::RowVectorXd to_it = (surface.colwise() - result.col(i)).colwise().squaredNorm();
    distances = i == 0 ? to_it : Eigen::RowVectorXd(distances.cwiseMin(to_it));
  }
  return result;
}

contacts::Box box_around(const Blend_stage& stage, std::size_t end, const std::vector<std::size_t>& parts)
{
  contacts::Box result;
  for (std::size_t part : parts)
    result.extend(box_of(stage.meshes[end][part].points));
  return result;
}

Part_chart chart_of(const contacts::Box& box)
{
  Points corners(3, 2);
  corners << box.min(), box.max();
  return Part_chart::box(corners, Eigen::Matrix3d::Identity());
}

/// The matrix from the coefficients of a motion to displacements along an axis: one row for each point, one column for
/// each control, and four for an affine map.
Eigen::MatrixXd kernels(const Points& points, const Points& controls, std::size_t axis)
{
  constexpr double across = 0.35; // weight of distances along the other two axes
  Point metric = Point::Constant(across);
  metric[axis] = 1;
  const Points scaled = metric.asDiagonal() * points, scaled_controls = metric.asDiagonal() * controls;
  const Eigen::Index n = controls.cols();
  Eigen::MatrixXd result(points.cols(), n + 4);
  for (Eigen::Index i = 0; i < n; ++i)
    result.col(i) = -(scaled.colwise() - scaled_controls.col(i)).colwise().norm().transpose();
  result.col(n).setOnes();
  result.rightCols(3) = points.transpose();
  return result;
}

/// Numbers of samples of an unmatched part along each axis of its chart, and in all, without its contacts.
constexpr int steps = 3, lattice = steps * steps * steps;

Points mapped(const Eigen::Matrix<double, 3, 4>& affine, const Points& points)
{
  return (affine.leftCols<3>() * points).colwise() + affine.col(3);
}

/// The linear map without shear: it takes the first axis, and the plane of the first two, to where `linear` takes them,
/// and keeps the right angles between the axes.
Eigen::Matrix3d without_shear(const Eigen::Matrix3d& linear, const Eigen::Matrix3d& axes)
{
  const Eigen::HouseholderQR<Eigen::Matrix3d> qr(linear * axes); // turned axes and, on the diagonal, their lengths
  const Eigen::Matrix3d turned = qr.householderQ();
  return turned * qr.matrixQR().diagonal().asDiagonal() * axes.transpose();
}

} // namespace

Space_warp::Space_warp(const Blend_stage& stage, const std::vector<Blend_part>& parts, const Part_pairs& unlike,
                       int end)
    : end_(end), box_(stage.boxes[std::size_t(end)]), cells_(lattice_cells(box_))
{
  // `Control::smoothing` for the box of the whole: small on the ground, so that the warp keeps to it, large elsewhere
  constexpr double on_ground = 0.02, elsewhere = 0.3;
  add_box(stage.boxes, 2, Point::Constant(elsewhere)); // includes the centre of the ground
  for (Control& control : controls_)
    if (control.at.y() <= box_.min().y()) control.smoothing[1] = on_ground;
  add_surfaces(stage, parts);
  add_sets(stage, unlike);
  const auto n = Eigen::Index(controls_.size());
  Points at(3, n), smoothing(3, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    at.col(i) = controls_[std::size_t(i)].at;
    smoothing.col(i) = controls_[std::size_t(i)].smoothing;
  }
  const Points nodes = lattice_nodes(box_, cells_);
  for (std::size_t axis : {0u, 1u, 2u}) {
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + 4, n + 4);
    system.topRows(n) = kernels(at, at, axis);
    system.diagonal().head(n) += smoothing.row(axis).transpose();
    system.bottomLeftCorner(4, n) = system.topRightCorner(n, 4).transpose();
    solvers_[axis].compute(system);
    node_kernels_[axis] = kernels(nodes, at, axis);
  }
}

/// Adds control points on the upper and lower face of a box: a grid of `cells` × `cells` cells.
void Space_warp::add_box(const std::array<contacts::Box, 2>& boxes, int cells, const Point& smoothing)
{
  const auto points = [&](int end) { return lattice_nodes(thickened(boxes[std::size_t(end)]), {cells, 1, cells}); };
  const Points at = points(end_), at_other_end = points(1 - end_);
  for (Eigen::Index i = 0; i < at.cols(); ++i)
    controls_.push_back({at.col(i), at_other_end.col(i), smoothing});
}

/// Adds a control point: the point nearest to `near` on a part of the shape, which is matched as a whole or in pieces.
void Space_warp::add_surface_point(const std::vector<Blend_part>& parts, std::size_t given, const Point& near)
{
  constexpr double smoothing = 0.005; // over the height, see `Control::smoothing`
  Control control;
  Steps least = std::numeric_limits<Steps>::max();
  for (std::size_t part : parts_of(parts, end_, given)) {
    std::size_t triangle = 0;
    const Point nearest = parts[part].end_tree(end_).nearest(near, triangle);
    const Steps distance = quantized((nearest - near).norm());
    if (distance < least) least = distance, control = {nearest, nearest, Point::Constant(smoothing), part};
  }
  control.place = nearest_place(parts[control.part].end_tree(end_), near);
  controls_.push_back(control);
}

/// Adds control points on matched parts and, so that the warp of symmetric shapes is symmetric, their mirror images.
void Space_warp::add_surfaces(const Blend_stage& stage, const std::vector<Blend_part>& parts)
{
  // Numbers of points: of all parts together, least and most of a part, limit for all, which bounds the time
  constexpr Eigen::Index all = 400, least = 16, most = 48, too_many = 1000;
  const auto end = std::size_t(end_);
  const Eigen::Index matched =
      std::max<Eigen::Index>(1, std::count_if(parts.begin(), parts.end(), std::mem_fn(&Blend_part::is_matched)));
  const Eigen::Index count =
      std::min(std::clamp(all / matched, least, most), std::max<Eigen::Index>(too_many / matched, 2));
  for (const Blend_part& part : parts) {
    if (!part.is_matched()) continue;
    const std::size_t given = part.given(end_);
    const auto image = stage.images[end][given];
    const bool has_image = image && parts[parts_of(parts, end_, *image)[0]].is_matched();
    const Points points = spread_points(part.end_points(end_), has_image ? count / 2 : count);
    for (const auto& at : points.colwise()) {
      add_surface_point(parts, given, at);
      if (has_image) add_surface_point(parts, *image, mirrored(at));
    }
  }
}

/// Adds control points on the boxes of sets of parts that correspond but do not morph.
void Space_warp::add_sets(const Blend_stage& stage, const Part_pairs& unlike)
{
  // `Control::smoothing` for the boxes of sets that keep their shape, and of others
  const Point alike(0.05, 0.3, 0.05), other(0.1, 0.5, 0.1);
  for (const Connected_parts& set : connected_parts(unlike, stage.meshes[0].size(), stage.meshes[1].size())) {
    const std::array<contacts::Box, 2> boxes = {box_around(stage, 0, set.source), box_around(stage, 1, set.target)};
    const Difference difference(stage, {chart_of(boxes[0]), chart_of(boxes[1])});
    if (difference.stays_near()) add_box(boxes, 1, difference.keeps_shape() ? alike : other);
  }
}

Points Space_warp::ways(const std::vector<Blend_part>& parts, const std::vector<Points>& surfaces, double t) const
{
  const double done = end_ == 0 ? t : 1 - t;
  const auto n = Eigen::Index(controls_.size());
  Eigen::MatrixX3d due = Eigen::MatrixX3d::Zero(n + 4, 3);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Control& control = controls_[std::size_t(i)];
    const bool is_free = control.part == Blend_task::no_part;
    const Point to = is_free ? (1 - done) * control.at + done * control.at_other_end
                             : control.place.of(surfaces[control.part], parts[control.part].triangles(end_));
    due.row(i) = (to - control.at).transpose();
  }
  Points result(3, node_kernels_[0].rows());
  for (std::size_t axis : {0u, 1u, 2u}) {
    const Eigen::VectorXd coefficients = solvers_[axis].solve(due.col(axis));
    result.row(axis) = (node_kernels_[axis] * coefficients).transpose();
  }
  return result;
}

Points Space_warp::moved(const Points& points, const Points& ways) const
{
  constexpr double flat = 1e-6; // thickness, over the height, up to which all points are in the first layer of cells
  const Eigen::Array3d sizes = box_.sizes().array().max(flat), cells = cells_.cast<double>();
  Points result = points;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Array3d along = (points.col(i) - box_.min()).array() / sizes * cells,
                         cell = along.floor().max(0).min(cells - 1), share = along - cell;
    for (int corner = 0; corner < 8; ++corner) {
      double weight = 1;
      Eigen::Index node = 0;
      for (int axis = 0; axis < 3; ++axis) {
        const int upper = corner >> axis & 1;
        weight *= upper ? share[axis] : 1 - share[axis];
        node = node * (cells_[axis] + 1) + Eigen::Index(cell[axis]) + upper;
      }
      result.col(i) += weight * ways.col(node);
    }
  }
  return result;
}

Straight_motion::Straight_motion(const Part_chart& chart, const Points& contacts, bool stands, const Space_warp& warp,
                                 const Points& ways)
    : axes_(chart.axes()), samples_(3, lattice + contacts.cols()), stands_(stands)
{
  constexpr double most = 0.015; // largest distance of a contact from where the warp takes it, over the height
  const auto coordinate = [](int i) { return 2. * (i % steps) / (steps - 1) - 1; };
  for (int i = 0; i < lattice; ++i)
    samples_.col(i) = chart({coordinate(i / steps / steps), coordinate(i / steps), coordinate(i)});
  samples_.rightCols(contacts.cols()) = contacts;
  const Points due = warp.moved(contacts, ways);
  const auto is_off = [&] {
    Points off = mapped(fitted(warp, ways), contacts) - due;
    if (stands) off(0, off.cols() - 1) = off(2, off.cols() - 1) = 0;
    return off.cols() > 0 && off.colwise().norm().maxCoeff() > most;
  };
  if (is_off()) kind_ = Kind::TURN;
  if (kind_ == Kind::TURN && is_off()) kind_ = Kind::FREE;
}

/// The map of the kind that is nearest to the warp at the samples. Contacts weigh more than the lattice; a foot on the
/// ground may slide on it.
Straight_motion::Affine Straight_motion::fitted(const Space_warp& warp, const Points& ways) const
{
  constexpr double thin = 0.002; // extent, over the height, up to which a part is hardly stretched along it
  constexpr double firmly = 5;   // weight of contacts, over that of the lattice
  const Points ways_of_samples = warp.moved(samples_, ways) - samples_;
  const Eigen::Index contacts = samples_.cols() - lattice;
  Eigen::Matrix3d linear = Eigen::Matrix3d::Identity(), middles;
  Point means;
  for (int axis = 0; axis < 3; ++axis) {
    Eigen::VectorXd weights = Eigen::VectorXd::Constant(samples_.cols(), 1. / lattice);
    weights.tail(contacts).setConstant(firmly / double(std::max<Eigen::Index>(contacts, 1)));
    if (stands_ && axis != 1) weights[weights.size() - 1] = 0;
    weights /= weights.sum();
    const Eigen::VectorXd way = ways_of_samples.row(axis).transpose();
    middles.col(axis) = samples_ * weights;
    means[axis] = middles(axis, axis) + way.dot(weights);
    const Points off = samples_.colwise() - Point(middles.col(axis)), weighed = off * weights.asDiagonal();
    const Eigen::Matrix3d spread = weighed * off.transpose() + thin * thin / firmly * Eigen::Matrix3d::Identity();
    const Point product = weighed * way;
    if (kind_ == Kind::STRETCH)
      linear(axis, axis) += product[axis] / spread(axis, axis);
    else
      linear.row(axis) += (spread.inverse() * product).transpose();
  }
  if (kind_ == Kind::TURN) linear = without_shear(linear, axes_);
  Affine result;
  result << linear, means - (linear * middles).diagonal();
  return result;
}

Points Straight_motion::moved(const Points& points, const Space_warp& warp, const Points& ways) const
{
  return kind_ == Kind::FREE ? warp.moved(points, ways) : mapped(fitted(warp, ways), points);
}

} // namespace CGAL::Shape_correspondence::internal
