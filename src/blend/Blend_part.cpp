// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Blend_part.h"

#include "base/Disjoint_sets.h"
#include "blend/Blend_stage.h"
#include "blend/mirror_images.h"
#include "blend/pair_boxes.h"
#include "blend/unlike_pairs.h"

#include <algorithm>
#include <set>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

const Eigen::Matrix3Xi& Blend_part::triangles(int surface) const
{
  return morph ? morph->triangles(surface) : retreat->triangles();
}

Points Blend_part::points(int surface, double progress, double remaining) const
{
  Points result = morph ? morph->points(surface, progress) : retreat->points(remaining);
  return is_reflected ? mirrored(std::move(result)) : std::move(result);
}

Carried_point Blend_part::carried(int at_end, const Point& p) const
{
  const Point own = is_reflected ? mirrored(p) : p;
  if (!morph) return {{own, own}, {Point::Zero(), Point::Zero()}};
  const Point k = morph->coordinates(at_end, own), offset = own - morph->place(k, at_end);
  return {{k, k}, {offset, offset}};
}

Carried_point Blend_part::carried(const Point& source, const Point& target) const
{
  const Carried_point from = carried(0, source), to = carried(1, target);
  return {{from.coordinates[0], to.coordinates[1]}, {from.offsets[0], to.offsets[1]}};
}

Point Blend_part::place(const Carried_point& p, double progress, double remaining) const
{
  const auto between = [&](const std::array<Point, 2>& ends) -> Point {
    return (1 - progress) * ends[0] + progress * ends[1];
  };
  const Point result = morph ? Point(morph->place(between(p.coordinates), progress) + between(p.offsets))
                             : retreat->place(p.coordinates[0], remaining);
  return is_reflected ? mirrored(result) : result;
}

void append(Part_mesh& all, const Part_mesh& mesh)
{
  const Eigen::Index points = all.points.cols(), triangles = all.triangles.cols();
  all.points.conservativeResize(3, points + mesh.points.cols());
  all.points.rightCols(mesh.points.cols()) = mesh.points;
  all.triangles.conservativeResize(3, triangles + mesh.triangles.cols());
  all.triangles.rightCols(mesh.triangles.cols()) = mesh.triangles.array() + int(points);
}

void Blend_part::set_ends()
{
  stands = true;
  height = 0;
  for (int surface = 0; surface < number_of_surfaces(); ++surface) {
    const auto change = [&](int number) { return morph->changes()[std::size_t(number)]; };
    const double time = surface == 0                         ? 0
                        : surface + 1 < number_of_surfaces() ? (change(surface - 1) + change(surface)) / 2
                                                             : 1;
    const Points at_rest = points(surface, time);
    trees.push_back(tree_of(at_rest, triangles(surface)));
    rests.emplace_back(at_rest, triangles(surface));
  }
  for (int at_end : {0, 1}) {
    if (!is_at(at_end)) continue;
    const Points points = end_points(at_end);
    size = std::max(size, trees[std::size_t(end_surface(at_end))].box().diagonal().norm());
    height += points.row(1).mean() / (morph ? 2 : 1);
    foot[std::size_t(at_end)] = points.row(1).minCoeff();
    stands = stands && foot[std::size_t(at_end)] <= on_ground;
  }
  if (!morph) foot[std::size_t(1 - end())] = foot[std::size_t(end())];
}

std::vector<std::size_t> parts_of(const std::vector<Blend_part>& parts, int end, std::size_t given)
{
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Blend_task& task = parts[i].task;
    const std::vector<std::size_t>& others = end == 0 ? task.other_sources : task.other_targets;
    if ((end == 0 ? task.source : task.target) == given ||
        std::find(others.begin(), others.end(), given) != others.end())
      result.push_back(i);
  }
  return result;
}

namespace {

/// The axes of a part's box, for mirror images alike.
Eigen::Matrix3d axes_of_box(const Blend_stage& stage, int end, std::size_t part)
{
  const auto e = std::size_t(end);
  const auto axes = [&](std::size_t i) {
    return box_axes(stage.meshes[e][i].points, stage.charted[e].charts[i].axes());
  };
  const Eigen::Matrix3d upright = Eigen::Matrix3d::Identity();
  const std::size_t image = stage.images[e][part];
  if (image == Mirror_images::none) return axes(part);
  return image == part || axes(image) == upright ? upright : axes(part);
}

/// Points with the mirror images of those of the mirror image.
std::vector<Point> with_mirrored(std::vector<Point> points, const std::vector<Point>& of_image)
{
  for (const Point& p : of_image)
    points.push_back(mirrored(p));
  return points;
}

std::vector<Point> places_of(const Carried_part& part)
{
  std::vector<Point> result;
  for (const Root& root : part.roots)
    result.push_back(root.at);
  return result;
}

/// The part of a shape that goes.
/// \param image its mirror image, if that goes, too: both draw back alike
Blend_part unmatched_part(const Blend_stage& stage, int end, const Carried_part& carried, const Carried_part* image,
                          const std::vector<Blend_part>& parts)
{
  const auto e = std::size_t(end);
  Blend_part result;
  const std::string& name = structure(stage.graphs[e]).parts[carried.part].name;
  result.name = end == 0 ? name + '~' : '~' + name;
  result.task.type = end == 0 ? Blend_task_type::SHRINK : Blend_task_type::GROW;
  (end == 0 ? result.task.source : result.task.target) = carried.part;
  for (const Root& root : carried.roots)
    result.roots.push_back({root.at, root.carriers.empty() ? root.carriers : parts_of(parts, end, root.carriers[0])});
  const Part_mesh& mesh = stage.meshes[e][carried.part];
  result.retreat = std::make_shared<Retreating_part>(
      mesh, axes_of_box(stage, end, carried.part),
      with_mirrored(places_of(carried), image ? places_of(*image) : std::vector<Point>()));
  result.set_ends();
  return result;
}

/// Of an unmatched part, its mirror image if that is one, too.
void set_image(const Blend_stage& stage, std::size_t number, std::vector<Blend_part>& parts)
{
  Blend_part& part = parts[number];
  const int end = part.end();
  const std::size_t image = stage.images[std::size_t(end)][part.given()];
  if (image == Mirror_images::none) return;
  const std::vector<std::size_t> made = parts_of(parts, end, image);
  if (!made.empty() && parts[made[0]].retreat) part.image = made[0];
}

/// Groups of parts that come and go at one time, so that each takes the place of the other: chains and those that they
/// correspond to, mirror images, what takes up one place, and what else a shape needs to stand or to hang together.
class Change_groups
{
public:
  Change_groups(const Blend_stage& stage, const Part_pairs& unlike)
      : stage_(stage), sources_(stage.meshes[0].size()), sets_(sources_ + stage.meshes[1].size())
  {
    for (const auto& [s, t] : unlike)
      sets_.unite(s, sources_ + t);
  }

  void add(int end, const Carried_part& part, bool stands)
  {
    const std::size_t number = number_of(end, part.part), image = stage_.images[std::size_t(end)][part.part];
    sets_.unite(number, number_of(end, part.chain));
    if (image != Mirror_images::none) sets_.unite(number, number_of(end, image));
    if (stands) standing_.push_back(number);
    if (part.joins) joining_.push_back(number);
    going_[std::size_t(end)].push_back(part.part);
  }

  /// To be called when all are added.
  void find()
  {
    for (std::size_t source : going_[0])
      for (std::size_t target : going_[1])
        if (are_in_one_place(stage_, source, target)) sets_.unite(source, sources_ + target);
    unite(standing_);
    std::array<std::set<std::size_t>, 2> groups; // by end
    for (int end : {0, 1})
      for (std::size_t part : going_[std::size_t(end)])
        groups[std::size_t(end)].insert(sets_[number_of(end, part)]);
    std::vector<std::size_t> alone; // that have no others in their place
    for (std::size_t number : joining_)
      if (groups[0].count(sets_[number]) + groups[1].count(sets_[number]) == 1) alone.push_back(number);
    unite(alone);
  }

  std::size_t operator()(const Blend_part& part) { return sets_[number_of(part.end(), part.given())]; }

private:
  void unite(const std::vector<std::size_t>& numbers)
  {
    for (std::size_t number : numbers)
      sets_.unite(number, numbers[0]);
  }
  std::size_t number_of(int end, std::size_t part) const { return end == 0 ? part : sources_ + part; }

  const Blend_stage& stage_;
  std::size_t sources_;
  Disjoint_sets sets_;                            ///< of the parts of the source, then those of the target
  std::vector<std::size_t> standing_, joining_;   ///< parts that stand, or join what nothing else joins
  std::array<std::vector<std::size_t>, 2> going_; ///< by end
};

} // namespace

void add_unmatched_parts(const Blend_stage& stage, const Part_pairs& unlike, std::vector<Blend_part>& parts)
{
  const std::size_t matched = parts.size();
  Change_groups groups(stage, unlike);
  for (int end : {0, 1}) {
    std::vector<char> stays(stage.meshes[std::size_t(end)].size()), corresponds(stays.size(), 0);
    for (std::size_t part = 0; part < stays.size(); ++part)
      stays[part] = !parts_of(parts, end, part).empty();
    for (const auto& [s, t] : unlike)
      corresponds[end == 0 ? s : t] = 1;
    const std::vector<Carried_part> going = carried_parts(stage, end, stays);
    std::vector<const Carried_part*> by_number(stays.size());
    for (const Carried_part& carried : going)
      by_number[carried.part] = &carried;
    std::vector<char> is_unlike(stays.size(), 0); // by chain, which goes as a whole
    const std::size_t first = parts.size();
    for (const Carried_part& carried : going) {
      const std::size_t image = stage.images[std::size_t(end)][carried.part];
      parts.push_back(
          unmatched_part(stage, end, carried, image == Mirror_images::none ? nullptr : by_number[image], parts));
      groups.add(end, carried, parts.back().stands);
      is_unlike[carried.chain] = is_unlike[carried.chain] || corresponds[carried.part];
    }
    for (std::size_t i = 0; i < going.size(); ++i)
      if (is_unlike[going[i].chain]) parts[first + i].task.obstacle = Blend_obstacle::UNLIKE;
  }
  groups.find();
  for (std::size_t i = matched; i < parts.size(); ++i) {
    set_image(stage, i, parts);
    parts[i].group = groups(parts[i]);
  }
}

} // namespace CGAL::Shape_correspondence::internal
