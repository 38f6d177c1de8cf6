// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/optimal_assignment.h"
#include "base/quantized.h"
#include "energy/Geotopo_transform.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace CGAL {
namespace Shape_correspondence {
using namespace internal;

namespace {

constexpr int curve_samples = samples_per_side;
constexpr int sheet_samples = samples_per_side * samples_per_side;

using Permutation = std::vector<int>;

// The ways to run through the samples of a curve, or of a closed one from every start.
std::vector<Permutation> curve_orientations(bool closed)
{
  std::vector<Permutation> result;
  for (int start = 0; start < (closed ? curve_samples : 1); ++start)
    for (int step : {1, -1}) {
      Permutation p(curve_samples);
      for (int i = 0; i < curve_samples; ++i)
        p[i] = ((step > 0 ? i : curve_samples - 1 - i) + start) % curve_samples;
      result.push_back(p);
    }
  return result;
}

// The 8 ways to lay a square grid onto itself.
std::vector<Permutation> sheet_orientations()
{
  constexpr int e = samples_per_side;
  std::vector<Permutation> result;
  for (int transposed : {0, 1})
    for (int flip_u : {0, 1})
      for (int flip_v : {0, 1}) {
        Permutation p(sheet_samples);
        for (int i = 0; i < e; ++i)
          for (int j = 0; j < e; ++j) {
            const int u = flip_u ? e - 1 - i : i, v = flip_v ? e - 1 - j : j;
            p[i * e + j] = transposed ? v * e + u : u * e + v;
          }
        result.push_back(p);
      }
  return result;
}

const std::vector<Permutation>& orientations(const Sampled_part& source, const Sampled_part& target)
{
  static const std::vector<Permutation> open = curve_orientations(false), closed = curve_orientations(true),
                                        sheet = sheet_orientations();
  using Kind = Sampled_part::Kind;
  if (source.kind == Kind::SHEET || target.kind == Kind::SHEET) return sheet;
  return source.kind == Kind::CLOSED_CURVE || target.kind == Kind::CLOSED_CURVE ? closed : open;
}

// The samples that orientations are told apart by: the ends of a curve, the corners of a sheet, all of a closed curve.
const std::vector<int>& extremities(const Sampled_part& source, const Sampled_part& target)
{
  constexpr int last = samples_per_side - 1;
  static const std::vector<int> ends{0, last}, corners{0, last, sheet_samples - 1 - last, sheet_samples - 1},
      all{0, 1, 2, 3, 4, 5};
  using Kind = Sampled_part::Kind;
  if (source.kind == Kind::SHEET || target.kind == Kind::SHEET) return corners;
  return source.kind == Kind::CLOSED_CURVE || target.kind == Kind::CLOSED_CURVE ? all : ends;
}

// The unit box of a group: a direction in which the group has no extent counts as its middle.
class Unit_box
{
public:
  explicit Unit_box(const Aligned_shape::Group& group)
  {
    constexpr double flat_extent = 0.02; // of the shape's height
    for (int axis = 0; axis < 3; ++axis) {
      const double extent = group.box.sizes()[axis];
      const bool is_flat = extent < flat_extent;
      scale_[axis] = is_flat ? 0 : 1 / extent;
      origin_[axis] = is_flat ? 0.5 : -group.box.min()[axis] / extent;
    }
  }

  Point operator()(const Point& p) const { return origin_ + scale_.cwiseProduct(p); }

private:
  Point scale_, origin_;
};

double quantized_distance(const Point& a, const Point& b) { return double(quantized((a - b).norm())); }

// Columns of a row that no row has taken go to the nearest row.
std::vector<std::vector<std::size_t>> assign_members(const Eigen::MatrixXd& cost)
{
  std::vector<std::vector<std::size_t>> cols_of(cost.rows());
  std::vector<char> taken(cost.cols(), 0);
  const std::vector<std::size_t> first = optimal_assignment(cost);
  for (std::size_t row = 0; row < first.size(); ++row) {
    cols_of[row].push_back(first[row]);
    taken[first[row]] = 1;
  }
  for (Eigen::Index col = 0; col < cost.cols(); ++col) {
    if (taken[col]) continue;
    Eigen::Index nearest;
    cost.col(col).minCoeff(&nearest);
    cols_of[nearest].push_back(std::size_t(col));
  }
  for (auto& cols : cols_of)
    std::sort(cols.begin(), cols.end());
  return cols_of;
}

// What the generator of a group makes of a movement of one member, for the member `steps` further.
Point symmetric_displacement(const Symmetry& symmetry, const Point& displacement, const Point& representative,
                             const Point& member)
{
  switch (symmetry.type) {
  case Symmetry_type::REFLECTION: {
    // Members on the same side move alike
    const double side = symmetry.direction.dot(representative - symmetry.point);
    if (side * symmetry.direction.dot(member - symmetry.point) >= 0) return displacement;
    return displacement - 2 * symmetry.direction.dot(displacement) * symmetry.direction;
  }
  case Symmetry_type::ROTATION: {
    const Point axis = symmetry.direction;
    const Point from = representative - symmetry.point - axis * axis.dot(representative - symmetry.point);
    const Point to = member - symmetry.point - axis * axis.dot(member - symmetry.point);
    const double angle = std::atan2(axis.dot(from.cross(to)), from.dot(to));
    return Eigen::AngleAxisd(angle, axis) * displacement;
  }
  default:
    return displacement;
  }
}

} // namespace

const std::vector<int>& fitting_order(const Sampled_part& source, const Sampled_part& target)
{
  // A curve among sheets has e equal columns
  const bool sheets = source.kind == Sampled_part::Kind::SHEET || target.kind == Sampled_part::Kind::SHEET;
  const int from_lift = sheets && source.kind != Sampled_part::Kind::SHEET ? samples_per_side : 1;
  const int to_lift = sheets && target.kind != Sampled_part::Kind::SHEET ? samples_per_side : 1;
  const std::vector<int>& ends = extremities(source, target);
  using Ends = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, samples_per_side>;
  Ends from(3, Eigen::Index(ends.size())), to = from;
  for (Eigen::Index k = 0; k < from.cols(); ++k) {
    from.col(k) = source.samples.col(ends[std::size_t(k)] / from_lift) - source.centroid;
    to.col(k) = target.samples.col(ends[std::size_t(k)] / to_lift) - target.centroid;
  }
  const std::vector<int>* best = nullptr;
  long best_score = 0; // the sum of products: greatest where the sum of squared distances is least
  for (const std::vector<int>& candidate : orientations(source, target)) {
    double sum = 0;
    for (Eigen::Index k = 0; k < from.cols(); ++k) {
      const int end = candidate[std::size_t(ends[std::size_t(k)])]; // again one of the ends
      sum += from.col(k).dot(to.col(std::find(ends.begin(), ends.end(), end) - ends.begin()));
    }
    const long score = quantized(sum);
    if (!best || score > best_score) best = &candidate, best_score = score;
  }
  return *best;
}

Points deform_to_fit(const Sampled_part& source, const Sampled_part& target)
{
  const std::vector<int>& order = fitting_order(source, target);
  const Eigen::Index count = Eigen::Index(order.size()), lift = count / target.samples.cols();
  Points result(3, count);
  for (Eigen::Index i = 0; i < count; ++i)
    result.col(i) = target.samples.col(order[std::size_t(i)] / lift);
  return result;
}

Operation topological_operation(std::size_t source_size, std::size_t target_size)
{
  if (source_size == target_size) return Operation::MATCH;
  if (source_size > target_size) return Operation::MERGE;
  return source_size == 1 ? Operation::SPLIT : Operation::DUPLICATE;
}

double solidity_ratio(const Aligned_shape::Group& source, const Aligned_shape::Group& target)
{
  const bool single = source.parts.size() == 1 && target.parts.size() == 1;
  const bool rotational =
      source.symmetry.type == Symmetry_type::ROTATION || target.symmetry.type == Symmetry_type::ROTATION;
  if (single || rotational) return 1;
  return std::min(source.solidity, target.solidity) / std::max(source.solidity, target.solidity);
}

Group_label match_members(const Aligned_shape& source, std::size_t source_group, const Aligned_shape& target,
                          std::size_t target_group)
{
  using namespace internal;
  const auto& from = source.groups[source_group].parts;
  const auto& to = target.groups[target_group].parts;
  Group_label label;
  label.target_group = target_group;
  label.operation = topological_operation(from.size(), to.size());
  label.solidity_ratio = solidity_ratio(source.groups[source_group], target.groups[target_group]);
  label.images.resize(from.size());
  if (from.size() == 1 || to.size() == 1) {
    for (std::size_t i = 0; i < from.size(); ++i)
      for (std::size_t part : to)
        label.images[i].push_back({{from[i]}, {part}});
    return label;
  }

  const Unit_box from_box(source.groups[source_group]), to_box(target.groups[target_group]);
  Eigen::MatrixXd cost(from.size(), to.size());
  for (Eigen::Index i = 0; i < cost.rows(); ++i)
    for (Eigen::Index j = 0; j < cost.cols(); ++j)
      cost(i, j) = quantized_distance(from_box(source.parts[from[std::size_t(i)]].centroid),
                                      to_box(target.parts[to[std::size_t(j)]].centroid));
  if (from.size() <= to.size()) {
    const auto images = assign_members(cost);
    for (std::size_t i = 0; i < from.size(); ++i)
      for (std::size_t j : images[i])
        label.images[i].push_back({{from[i]}, {to[j]}});
  } else {
    const auto preimages = assign_members(cost.transpose());
    for (std::size_t j = 0; j < to.size(); ++j)
      for (std::size_t i : preimages[j])
        label.images[i].push_back({{from[i]}, {to[j]}});
  }
  return label;
}

namespace {

bool is_open_curve(const Sampled_part& part) { return part.kind == Sampled_part::Kind::CURVE; }

// Which segment of a curve each of several curves is, by optimal assignment of their places in the unit boxes.
std::vector<std::size_t> matching_segments(const Sampled_part& curve, const Unit_box& curve_box,
                                           const std::vector<Point>& centroids, const Unit_box& box)
{
  const int count = int(centroids.size());
  Eigen::MatrixXd cost(count, count);
  for (int j = 0; j < count; ++j) {
    const Point place = curve_box(segment(curve, j, count).centroid);
    for (int i = 0; i < count; ++i)
      cost(i, j) = quantized_distance(box(centroids[std::size_t(i)]), place);
  }
  return optimal_assignment(cost);
}

// Whether parts that are to follow each other as segments (part `i` is segment `segments[i]`) lie in a row.
bool is_chain(const Aligned_shape& shape, const std::vector<std::size_t>& parts,
              const std::vector<std::size_t>& segments)
{
  constexpr double widest_gap = 0.05; // between consecutive segments, of the shape's height
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t j = 0; j < parts.size(); ++j)
      if (segments[j] == segments[i] + 1 && shape.distance(Eigen::Index(parts[i]), Eigen::Index(parts[j])) > widest_gap)
        return false;
  return true;
}

} // namespace

Group_label cut_members(const Aligned_shape& source, std::size_t source_group, const Aligned_shape& target,
                        const Group_label& label)
{
  using namespace internal;
  const auto &from = source.groups[source_group].parts, &to = target.groups[label.target_group].parts;
  Group_label result = label;
  const auto centroids = [](const Aligned_shape& shape, const std::vector<std::size_t>& parts) {
    std::vector<Point> points;
    for (std::size_t part : parts)
      points.push_back(shape.parts[part].centroid);
    return points;
  };
  const auto all_curves = [](const Aligned_shape& shape, const std::vector<std::size_t>& parts) {
    return std::all_of(parts.begin(), parts.end(), [&](std::size_t part) { return is_open_curve(shape.parts[part]); });
  };
  const Unit_box from_box(source.groups[source_group]), to_box(target.groups[label.target_group]);

  for (std::vector<Image>& images : result.images) {
    const std::size_t part = images[0].source.part;
    std::vector<std::size_t> parts;
    for (const Image& image : images)
      parts.push_back(image.target.part);
    if (parts.size() < 2 || !is_open_curve(source.parts[part]) || !all_curves(target, parts)) continue;
    const auto segments = matching_segments(source.parts[part], from_box, centroids(target, parts), to_box);
    if (!is_chain(target, parts, segments)) continue;
    for (std::size_t i = 0; i < images.size(); ++i)
      images[i].source = {part, int(segments[i]), int(parts.size())};
    result.operation = Operation::CUT;
  }
  for (std::size_t part : to) {
    std::vector<std::size_t> members, parts;
    for (std::size_t i = 0; i < from.size(); ++i)
      if (result.images[i].size() == 1 && result.images[i][0].target.part == part)
        members.push_back(i), parts.push_back(from[i]);
    if (parts.size() < 2 || !is_open_curve(target.parts[part]) || !all_curves(source, parts)) continue;
    const auto segments = matching_segments(target.parts[part], to_box, centroids(source, parts), from_box);
    if (!is_chain(source, parts, segments)) continue;
    for (std::size_t i = 0; i < members.size(); ++i)
      result.images[members[i]][0].target = {part, int(segments[i]), int(parts.size())};
    result.operation = Operation::JOIN;
  }
  return result;
}

Propagation::Propagation(const Aligned_shape& shape)
    : shape_(shape), touches_(shape.groups.size()), placed_(shape.groups.size())
{
  order_.reserve(shape.groups.size());
  for (std::size_t group = 0; group < shape.groups.size(); ++group) {
    for (std::size_t c : shape.groups[group].contacts)
      for (int side : {0, 1}) {
        const auto& parts = shape.contacts[c].parts;
        if (shape.group_of[parts[side]] == group && shape.group_of[parts[1 - side]] != group)
          touches_[group].push_back({c, parts[side], parts[1 - side], 1 - side});
      }
    std::sort(touches_[group].begin(), touches_[group].end(),
              [](const Touch& a, const Touch& b) { return std::tie(a.part, a.contact) < std::tie(b.part, b.contact); });
  }
}

// Places a group by the parts that it touches and that are placed; returns how far its representative moved.
double Propagation::place(std::size_t group, const std::vector<char>& matched,
                          const std::vector<std::array<Point, 2>>& contact_displacement, Points& displacement)
{
  const std::vector<Touch>& touches = touches_[group];
  std::size_t representative = shape_.groups[group].parts[0];
  Point moved = Point::Zero();
  int most = 0;
  for (std::size_t i = 0; i < touches.size();) {
    const std::size_t part = touches[i].part;
    Point sum = Point::Zero();
    int count = 0;
    for (; i < touches.size() && touches[i].part == part; ++i) {
      const std::size_t other = touches[i].other, other_group = shape_.group_of[other];
      if (!placed_[other_group]) continue;
      sum += matched[other_group] ? contact_displacement[touches[i].contact][std::size_t(touches[i].other_side)]
                                  : Point(displacement.col(Eigen::Index(other)));
      ++count;
    }
    if (count > most) most = count, representative = part, moved = sum / count;
  }
  const double change = (displacement.col(Eigen::Index(representative)) - moved).cwiseAbs().maxCoeff();
  for (std::size_t part : shape_.groups[group].parts)
    displacement.col(Eigen::Index(part)) = symmetric_displacement(
        shape_.groups[group].symmetry, moved, shape_.parts[representative].centroid, shape_.parts[part].centroid);
  return change;
}

void Propagation::operator()(const std::vector<char>& matched,
                             const std::vector<std::array<Point, 2>>& contact_displacement, Points& displacement)
{
  // Breadth-first, a layer of groups at a time: what touches the layers before is the next one
  order_.clear();
  std::copy(matched.begin(), matched.end(), placed_.begin());
  for (std::size_t begin = 0, end = 1; begin != end;) {
    begin = order_.size();
    for (std::size_t group = 0; group < matched.size(); ++group) {
      if (placed_[group]) continue;
      const bool reached = std::any_of(touches_[group].begin(), touches_[group].end(),
                                       [&](const Touch& touch) { return placed_[shape_.group_of[touch.other]] != 0; });
      if (reached) order_.push_back(group);
    }
    end = order_.size();
    for (std::size_t i = begin; i < end; ++i)
      place(order_[i], matched, contact_displacement, displacement);
    for (std::size_t i = begin; i < end; ++i)
      placed_[order_[i]] = 1;
  }
  for (std::size_t group = 0; group < matched.size(); ++group)
    if (!placed_[group])
      for (std::size_t part : shape_.groups[group].parts)
        displacement.col(Eigen::Index(part)).setZero();

  double change = 1;
  for (int sweep = 0; sweep < maximum_sweeps && change > tolerance; ++sweep) {
    change = 0;
    for (std::size_t group : order_)
      change = std::max(change, place(group, matched, contact_displacement, displacement));
  }
}

} // namespace Shape_correspondence
} // namespace CGAL
