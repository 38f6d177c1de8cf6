// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "roles/role_features.h"
#include "base/eigen_system.h"
#include "base/quantized.h"
#include "structure/Shape_layout.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

namespace {

constexpr double ground_tolerance = 0.03; // share of the height: a part that begins lower stands on the ground
constexpr double side_margin = 0.025;     // share of the width: a part farther off the middle plane is on a side
constexpr double middle_margin = 0.05; // share of the width: a part that reaches farther over the middle plane spans it

double ratio(double a, double b) { return b > comparison_grid ? a / b : 0; }

// A part in the common frame and in the unit box.
struct Placed_part
{
  Axis_box box;             // box in the common frame
  Eigen::Array3d low, high; // corners in the unit box
  Eigen::Matrix3d spread;   // root of the covariance, of Frobenius norm 1
  Eigen::Array3d lengths;   // roots of the principal variances, the least first
  double area;              // share of the area of all parts

  Eigen::Array3d middle() const { return (low + high) / 2; }
};

std::vector<Placed_part> placed_parts(const Structural_graph& graph, const Aligned_shape& shape,
                                      const Shape_layout& layout)
{
  double area = 0;
  for (const Part_abstraction& part : structure(graph).parts)
    area += part.area;
  const Eigen::Array3d sides = (layout.bounds.sides() > comparison_grid).select(layout.bounds.sides(), 1.);
  std::vector<Placed_part> result;
  for (std::size_t i = 0; i < shape.parts.size(); ++i) {
    const Points& surface = shape.parts[i].surface;
    Placed_part part;
    part.box = layout.boxes[i];
    part.low = (part.box.low - layout.bounds.low) / sides;
    part.high = (part.box.high - layout.bounds.low) / sides;
    part.area = area > 0 ? structure(graph).parts[shape.original[i]].area / area : 0;
    const Points centred = surface.colwise() - surface.rowwise().mean();
    const Eigen_system eigen = eigen_system(scatter_matrix(centred) / double(surface.cols()));
    part.lengths = eigen.values.array().max(0.).sqrt();
    const double norm = std::max(part.lengths.matrix().norm(), comparison_grid);
    part.spread = eigen.vectors * (part.lengths / norm).matrix().asDiagonal() * eigen.vectors.transpose();
    result.push_back(part);
  }
  return result;
}

// The index of the part of most area; the first of equals.
template <typename Indices>
std::size_t largest(const Indices& indices, const std::vector<Placed_part>& parts)
{
  return *std::max_element(indices.begin(), indices.end(),
                           [&](std::size_t a, std::size_t b) { return is_less(parts[a].area, parts[b].area); });
}

double rank_in_height(const Placed_part& part, const std::vector<Placed_part>& parts)
{
  double rank = 0;
  for (const Placed_part& other : parts)
    rank += is_less(other.middle().y(), part.middle().y())   ? 1
            : is_less(part.middle().y(), other.middle().y()) ? 0
                                                             : 0.5;
  return rank / double(parts.size());
}

// Writes the features of a part as bytes.
class Feature_row
{
public:
  explicit Feature_row(std::uint8_t* row) : row_(row) {}
  void set(Role_feature feature, double value) { row_[feature] = byte(value); }
  void set_signed(Role_feature feature, double value) { row_[feature] = byte((value + 1) / 2); }

private:
  static std::uint8_t byte(double value)
  {
    return std::uint8_t(std::lround(254 * std::clamp(double(quantized(value)) * comparison_grid, 0., 1.)));
  }

  std::uint8_t* row_;
};

void set_place(const Placed_part& part, bool is_on_ground, Feature_row& row)
{
  const Eigen::Array3d middle = part.middle(), extent = part.high - part.low;
  row.set(ON_GROUND, is_on_ground);
  row.set(LOWEST_HEIGHT, part.low.y());
  row.set(HIGHEST_HEIGHT, part.high.y());
  row.set(MIDDLE_HEIGHT, middle.y());
  row.set(EXTENT_UP, extent.y());
  row.set(LOWEST_DEPTH, part.low.z());
  row.set(HIGHEST_DEPTH, part.high.z());
  row.set(MIDDLE_DEPTH, middle.z());
  row.set(EXTENT_DEPTH, extent.z());
  row.set(EXTENT_SIDEWAYS, extent.x());
  row.set(OFF_MIDDLE, 2 * std::abs(middle.x() - 0.5));
  row.set(FARTHEST_OFF_MIDDLE, 2 * std::max(0.5 - part.low.x(), part.high.x() - 0.5));
  row.set(SPANS_MIDDLE, is_less(part.low.x(), 0.5 - middle_margin) && is_less(0.5 + middle_margin, part.high.x()));
}

void set_shape(const Placed_part& part, const Axis_box& bounds, Feature_row& row)
{
  const double diagonal = bounds.sides().matrix().norm();
  Eigen::Array3d sides = part.box.sides();
  row.set(DIAGONAL, ratio(sides.matrix().norm(), diagonal));
  row.set(HEIGHT, ratio(sides.y(), diagonal));
  row.set(AREA, part.area);
  std::sort(sides.data(), sides.data() + 3);
  row.set(SECOND_SIDE, ratio(sides[1], sides[2]));
  row.set(THIRD_SIDE, ratio(sides[0], sides[2]));
  row.set(SECOND_LENGTH, ratio(part.lengths[1], part.lengths[2]));
  row.set(THIRD_LENGTH, ratio(part.lengths[0], part.lengths[2]));
  row.set(SPREAD_SIDEWAYS, part.spread(0, 0));
  row.set(SPREAD_UP, part.spread(1, 1));
  row.set(SPREAD_DEPTH, part.spread(2, 2));
  row.set(TILT_SIDEWAYS, std::abs(part.spread(0, 1)));
  row.set_signed(TILT_TO_FRONT, part.spread(1, 2));
  row.set(TILT_LEVEL, std::abs(part.spread(0, 2)));
  row.set(SHAPE_WIDTH, ratio(bounds.sides().x(), bounds.sides().x() + bounds.sides().y()));
  row.set(SHAPE_DEPTH, ratio(bounds.sides().z(), bounds.sides().z() + bounds.sides().y()));
}

} // namespace

Role_features role_features(const Structural_graph& graph, const Aligned_shape& shape)
{
  const Shape_layout layout(shape, ground_tolerance);
  const std::vector<Placed_part> parts = placed_parts(graph, shape, layout);
  std::vector<std::size_t> all(parts.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = i;
  const Placed_part& main = parts[largest(all, parts)];
  Role_features result(Eigen::Index(parts.size()), ROLE_FEATURE_COUNT);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Placed_part& part = parts[i];
    Feature_row row(&result(Eigen::Index(shape.original[i]), 0));
    set_place(part, layout.is_on_ground[i], row);
    set_shape(part, layout.bounds, row);
    row.set(RANK_IN_HEIGHT, rank_in_height(part, parts));
    const Eigen::Array3d off = part.middle() - main.middle();
    row.set(SIDEWAYS_OF_LARGEST, std::abs(off.x()));
    row.set_signed(UP_OF_LARGEST, off.y());
    row.set_signed(TO_FRONT_OF_LARGEST, off.z());
    const std::vector<std::size_t>& touching = layout.neighbours[i];
    const Placed_part& neighbour = touching.empty() ? part : parts[largest(touching, parts)];
    const Eigen::Array3d off_neighbour = part.middle() - neighbour.middle();
    row.set(SIDEWAYS_OF_NEIGHBOUR, std::abs(off_neighbour.x()));
    row.set_signed(UP_OF_NEIGHBOUR, off_neighbour.y());
    row.set_signed(TO_FRONT_OF_NEIGHBOUR, off_neighbour.z());
    row.set(SHARE_WITH_NEIGHBOUR, touching.empty() ? 1 : ratio(part.area, part.area + neighbour.area));
  }
  return result;
}

std::vector<Side> part_sides(const Aligned_shape& shape)
{
  const Shape_layout layout(shape, ground_tolerance);
  const double middle = layout.bounds.centre().x(), margin = side_margin * layout.bounds.sides().x();
  std::vector<Side> result(shape.parts.size(), Side::NEITHER);
  for (std::size_t i = 0; i < result.size(); ++i) {
    const double off = layout.boxes[i].centre().x() - middle;
    if (is_less(margin, std::abs(off))) result[shape.original[i]] = off > 0 ? Side::LEFT : Side::RIGHT;
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
