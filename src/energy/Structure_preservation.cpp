// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "energy/Structure_preservation.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace CGAL::Shape_correspondence {

namespace {

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

Structure_preservation::Structure_preservation(const Aligned_shape& shape)
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
double Structure_preservation::place(std::size_t group, const std::vector<char>& matched,
                                     const std::vector<std::array<Point, 2>>& contact_displacement,
                                     Points& displacement)
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

void Structure_preservation::operator()(const std::vector<char>& matched,
                                        const std::vector<std::array<Point, 2>>& contact_displacement,
                                        Points& displacement)
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

} // namespace CGAL::Shape_correspondence
