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

// The linear part of the symmetry that takes the representative of a group to another of its members.
Eigen::Matrix3d generated_directions(const Part_group& group, const Point& representative, const Point& member)
{
  const Symmetry& symmetry = group.symmetry;
  Eigen::Matrix3d result = Eigen::Matrix3d::Identity();
  switch (symmetry.type) {
  case Symmetry_type::REFLECTION: {
    // Groups of more than two parts have a second, vertical mirror plane; members on one side of a plane move alike
    std::vector<Point> normals{symmetry.direction};
    if (group.parts.size() > 2) normals.push_back(symmetry.direction.cross(Point::UnitY()));
    for (const Point& normal : normals)
      if (normal.dot(representative - symmetry.point) * normal.dot(member - symmetry.point) < 0)
        result -= 2 * normal * normal.transpose();
    break;
  }
  case Symmetry_type::ROTATION: {
    const Point axis = symmetry.direction;
    const Point from = representative - symmetry.point - axis * axis.dot(representative - symmetry.point);
    const Point to = member - symmetry.point - axis * axis.dot(member - symmetry.point);
    const double angle = std::atan2(axis.dot(from.cross(to)), from.dot(to));
    result = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    break;
  }
  default:
    break;
  }
  return result;
}

} // namespace

Structure_preservation::Structure_preservation(const Aligned_shape& shape, bool has_hard_contacts)
    : shape_(shape),
      stiffness_(has_hard_contacts ? least_stiffness : stiffness),
      touches_(shape.number_of_groups()),
      displacement_(Points::Zero(3, Eigen::Index(shape.parts.size()))),
      placed_(shape.number_of_groups())
{
  order_.reserve(shape.number_of_groups());
  for (std::size_t group = 0; group < shape.number_of_groups(); ++group) {
    for (const auto& edge : boost::make_iterator_range(out_edges(group, shape.graph)))
      for (std::size_t c : shape.graph[edge].contacts) {
        const auto& parts = shape.contacts[c].parts;
        const std::size_t side = shape.group_of[parts[0]] == group ? 0 : 1;
        const std::size_t other = parts[1 - side];
        touches_[group].push_back({c, parts[side], other, shape.group_of[other], int(1 - side)});
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
  result.representative = shape_.group(group).parts[0];
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
  for (std::size_t member : shape_.group(group).parts)
    result.directions.push_back(
        generated_directions(shape_.group(group), part.centroid, shape_.parts[member].centroid));
  result.middle = points.rowwise().mean();
  points.colwise() -= result.middle;
  constexpr double least_scatter = 1e-12; // lower bound, so that the matrix of a part that is a point is invertible
  const double scatter = (part.samples.colwise() - part.centroid).squaredNorm() / double(part.samples.cols());
  const Eigen::Matrix3d weight =
      points * points.transpose() + stiffness_ * std::max(scatter, least_scatter) * Eigen::Matrix3d::Identity();
  const Points slopes = weight.inverse() * points;
  for (const auto& slope : slopes.colwise())
    result.slopes.emplace_back(slope);
  return result;
}

// Places a group by its contacts with groups that are already placed.
void Structure_preservation::place(std::size_t group, const std::vector<char>& matched,
                                   const std::vector<std::array<Point, 2>>& contact_displacement)
{
  const std::vector<Touch>& touches = touches_[group];
  std::size_t representative = shape_.group(group).parts[0];
  Point moved = Point::Zero();
  int most = 0;
  for (std::size_t i = 0; i < touches.size();) {
    const std::size_t part = touches[i].part;
    Point sum = Point::Zero();
    int count = 0;
    for (; i < touches.size() && touches[i].part == part; ++i) {
      const std::size_t other = touches[i].other, other_group = touches[i].other_group;
      if (!placed_[other_group]) continue;
      sum += matched[other_group] ? contact_displacement[touches[i].contact][std::size_t(touches[i].other_side)]
                                  : Point(displacement_.col(Eigen::Index(other)));
      ++count;
    }
    if (count > most) most = count, representative = part, moved = sum / count;
  }
  if (representative == handles_[group].representative) return displace(group, moved);
  for (std::size_t member : shape_.group(group).parts)
    displacement_.col(Eigen::Index(member)) =
        generated_directions(shape_.group(group), shape_.parts[representative].centroid,
                             shape_.parts[member].centroid) *
        moved;
}

// Displaces the members of a group as its representative is displaced.
void Structure_preservation::displace(std::size_t group, const Point& moved)
{
  const std::vector<std::size_t>& members = shape_.group(group).parts;
  if (members.size() == 1) { // the representative
    displacement_.col(Eigen::Index(members[0])) = moved;
    return;
  }
  for (std::size_t i = 0; i < members.size(); ++i)
    displacement_.col(Eigen::Index(members[i])) = handles_[group].directions[i] * moved;
}

// Collects pointers to the displacements that the representatives follow, after all groups are placed.
void Structure_preservation::gather(const std::vector<char>& matched,
                                    const std::vector<std::array<Point, 2>>& contact_displacement)
{
  followed_.clear();
  for (std::size_t group : order_)
    for (std::size_t i = handles_[group].begin; i < handles_[group].end; ++i) {
      const Touch& touch = touches_[group][i];
      const std::array<Point, 2>& displaced = contact_displacement[touch.contact];
      followed_.push_back(matched[touch.other_group] ? displaced[std::size_t(touch.other_side)].data()
                                                     : displacement_.col(Eigen::Index(touch.other)).data());
    }
}

// Places every group once more. \return the largest change of a coordinate
double Structure_preservation::sweep()
{
  double change = 0;
  const double* const* followed = followed_.data();
  for (std::size_t group : order_) {
    const Handles& handles = handles_[group];
    Point sum = Point::Zero();
    const std::size_t count = handles.end - handles.begin;
    for (std::size_t i = 0; i < count; ++i)
      sum += Eigen::Map<const Point>(*followed++);
    const Point moved = sum / double(count);
    change = std::max(change, (displacement_.col(Eigen::Index(handles.representative)) - moved).cwiseAbs().maxCoeff());
    displace(group, moved);
  }
  return change;
}

// Displaces and deforms a group by the contacts of its representative; two unmatched parts in contact meet midway.
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
        matched[touch.other_group]
            ? contact_displacement[touch.contact][std::size_t(touch.other_side)]
            : Point((displacement_.col(Eigen::Index(representative)) + displacement_.col(Eigen::Index(touch.other))) /
                    2);
    motion.shift += moved;
    motion.stretch += moved * handles.slopes[i - handles.begin].transpose();
  }
  motion.shift /= double(handles.end - handles.begin);
  motion.shift -= motion.stretch * handles.middle;
  const std::vector<std::size_t>& members = shape_.group(group).parts;
  if (members.size() == 1) { // the representative alone
    motions[members[0]] = motion;
    return;
  }
  for (std::size_t i = 0; i < members.size(); ++i) {
    const Eigen::Matrix3d& directions = handles.directions[i];
    motions[members[i]] = {directions * motion.shift, directions * motion.stretch * directions.transpose()};
  }
}

bool Structure_preservation::touches_placed(std::size_t group) const
{
  const std::vector<Touch>& touches = touches_[group];
  return std::any_of(touches.begin(), touches.end(), [&](const Touch& t) { return placed_[t.other_group] != 0; });
}

void Structure_preservation::operator()(const std::vector<char>& matched,
                                        const std::vector<std::array<Point, 2>>& contact_displacement,
                                        std::vector<Part_motion>& motions)
{
  std::copy(matched.begin(), matched.end(), placed_.begin());
  order_.clear();
  for (std::size_t begin = 0;; begin = order_.size()) { // one breadth-first layer in each round
    for (std::size_t group = 0; group < matched.size(); ++group)
      if (!placed_[group] && touches_placed(group)) order_.push_back(group);
    if (order_.size() == begin) break;
    std::for_each(order_.begin() + std::ptrdiff_t(begin), order_.end(),
                  [&](std::size_t group) { place(group, matched, contact_displacement); });
    std::for_each(order_.begin() + std::ptrdiff_t(begin), order_.end(), [&](std::size_t group) { placed_[group] = 1; });
  }
  for (std::size_t group = 0; group < matched.size(); ++group)
    if (!placed_[group])
      for (std::size_t part : shape_.group(group).parts)
        motions[part] = {};

  // All groups are placed now, so that the representatives are those of the handles
  gather(matched, contact_displacement);
  for (int sweeps = 0; sweeps < maximum_sweeps && sweep() > tolerance;)
    ++sweeps;
  for (std::size_t group : order_)
    stretch(group, matched, contact_displacement, motions);
}

} // namespace CGAL::Shape_correspondence
