// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "energy/Structure_preservation.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace CGAL::Shape_correspondence {

namespace {

// What the generator of a group makes of directions at its representative, for another member.
Eigen::Matrix3d generated_directions(const Symmetry& symmetry, const Point& representative, const Point& member)
{
  switch (symmetry.type) {
  case Symmetry_type::REFLECTION: {
    // Members on the same side move alike
    const double side = symmetry.direction.dot(representative - symmetry.point);
    if (side * symmetry.direction.dot(member - symmetry.point) >= 0) break;
    return Eigen::Matrix3d::Identity() - 2 * symmetry.direction * symmetry.direction.transpose();
  }
  case Symmetry_type::ROTATION: {
    const Point axis = symmetry.direction;
    const Point from = representative - symmetry.point - axis * axis.dot(representative - symmetry.point);
    const Point to = member - symmetry.point - axis * axis.dot(member - symmetry.point);
    const double angle = std::atan2(axis.dot(from.cross(to)), from.dot(to));
    return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
  }
  default:
    break;
  }
  return Eigen::Matrix3d::Identity();
}

} // namespace

Structure_preservation::Structure_preservation(const Aligned_shape& shape)
    : shape_(shape),
      touches_(shape.groups.size()),
      displacement_(Points::Zero(3, Eigen::Index(shape.parts.size()))),
      placed_(shape.groups.size())
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
    handles_.push_back(handles(group));
  }
}

Structure_preservation::Handles Structure_preservation::handles(std::size_t group) const
{
  const std::vector<Touch>& touches = touches_[group];
  Handles result;
  result.representative = shape_.groups[group].parts[0];
  for (std::size_t begin = 0, end = 0; begin < touches.size(); begin = end) {
    while (end < touches.size() && touches[end].part == touches[begin].part)
      ++end;
    if (end - begin <= result.end - result.begin) continue;
    result.representative = touches[begin].part;
    result.begin = begin;
    result.end = end;
  }
  if (result.begin == result.end) return result;

  const Sampled_part& part = shape_.parts[result.representative];
  Points points(3, Eigen::Index(result.end - result.begin));
  for (std::size_t i = result.begin; i < result.end; ++i) {
    const std::size_t sample = shape_.contacts[touches[i].contact].samples[std::size_t(1 - touches[i].other_side)];
    points.col(Eigen::Index(i - result.begin)) = part.samples.col(Eigen::Index(sample)) - part.centroid;
  }
  result.middle = points.rowwise().mean();
  points.colwise() -= result.middle;
  const double scatter = (part.samples.colwise() - part.centroid).squaredNorm() / double(part.samples.cols());
  const Eigen::Matrix3d weight =
      points * points.transpose() + stiffness * std::max(scatter, 1e-12) * Eigen::Matrix3d::Identity();
  const Points slopes = weight.inverse() * points;
  for (const auto& slope : slopes.colwise())
    result.slopes.emplace_back(slope);
  return result;
}

// Places a group by the parts that it touches and that are placed; returns how far its representative moved.
double Structure_preservation::place(std::size_t group, const std::vector<char>& matched,
                                     const std::vector<std::array<Point, 2>>& contact_displacement)
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
                                  : Point(displacement_.col(Eigen::Index(other)));
      ++count;
    }
    if (count > most) most = count, representative = part, moved = sum / count;
  }
  const double change = (displacement_.col(Eigen::Index(representative)) - moved).cwiseAbs().maxCoeff();
  for (std::size_t part : shape_.groups[group].parts)
    displacement_.col(Eigen::Index(part)) =
        generated_directions(shape_.groups[group].symmetry, shape_.parts[representative].centroid,
                             shape_.parts[part].centroid) *
        moved;
  return change;
}

// Displaces and deforms a group by all that its representative touches. Two unmatched parts meet half-way.
void Structure_preservation::stretch(std::size_t group, const std::vector<char>& matched,
                                     const std::vector<std::array<Point, 2>>& contact_displacement,
                                     std::vector<Part_motion>& motions) const
{
  const Handles& handles = handles_[group];
  const std::size_t representative = handles.representative;
  Part_motion motion;
  for (std::size_t i = handles.begin; i < handles.end; ++i) {
    const Touch& touch = touches_[group][i];
    const Point moved =
        matched[shape_.group_of[touch.other]]
            ? contact_displacement[touch.contact][std::size_t(touch.other_side)]
            : Point((displacement_.col(Eigen::Index(representative)) + displacement_.col(Eigen::Index(touch.other))) /
                    2);
    motion.shift += moved;
    motion.stretch += moved * handles.slopes[i - handles.begin].transpose();
  }
  motion.shift /= double(handles.end - handles.begin);
  motion.shift -= motion.stretch * handles.middle;
  for (std::size_t part : shape_.groups[group].parts) {
    const Eigen::Matrix3d directions = generated_directions(
        shape_.groups[group].symmetry, shape_.parts[representative].centroid, shape_.parts[part].centroid);
    motions[part] = {directions * motion.shift, directions * motion.stretch * directions.transpose()};
  }
}

void Structure_preservation::operator()(const std::vector<char>& matched,
                                        const std::vector<std::array<Point, 2>>& contact_displacement,
                                        std::vector<Part_motion>& motions)
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
      place(order_[i], matched, contact_displacement);
    for (std::size_t i = begin; i < end; ++i)
      placed_[order_[i]] = 1;
  }
  for (std::size_t group = 0; group < matched.size(); ++group)
    if (!placed_[group])
      for (std::size_t part : shape_.groups[group].parts)
        motions[part] = {};

  double change = 1;
  for (int sweep = 0; sweep < maximum_sweeps && change > tolerance; ++sweep) {
    change = 0;
    for (std::size_t group : order_)
      change = std::max(change, place(group, matched, contact_displacement));
  }
  for (std::size_t group : order_)
    stretch(group, matched, contact_displacement, motions);
}

} // namespace CGAL::Shape_correspondence
