// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "box_shapes.h"
#include "generated_shapes.h"

#include <CGAL/Shape_correspondence/detect_symmetry_groups.h>

#include <catch2/catch.hpp>

#include <Eigen/Geometry>

#include <map>

using namespace box_shapes;

namespace {

/// The groups of at least two parts, as sets of names, with their kinds.
std::map<Names, Symmetry_type> named(const std::vector<Part_abstraction>& parts, const std::vector<Part_group>& groups)
{
  std::map<Names, Symmetry_type> result;
  for (const Part_group& group : groups) {
    Names names;
    for (std::size_t part : group.parts)
      names.insert(parts[part].name);
    if (names.size() > 1) result[names] = group.symmetry.type;
  }
  return result;
}

std::map<Names, Symmetry_type> groups_of(const Segmented_shape& shape)
{
  const std::vector<Part_abstraction> parts = quick_parts(shape);
  return named(parts, detect_symmetry_groups(parts, frame_of(parts)));
}

const Part_group& group_with(const std::vector<Part_abstraction>& parts, const std::vector<Part_group>& groups,
                             const std::string& name)
{
  for (const Part_group& group : groups)
    for (std::size_t part : group.parts)
      if (parts[part].name == name) return group;
  throw std::logic_error("no group has " + name);
}

/// The symmetry of a group, whose generator moves with the shape, and the names of the parts in their order.
struct Named_group
{
  Symmetry symmetry;
  std::vector<std::string> order;
};

using Named_groups = std::map<Names, Named_group>;

Named_groups groups_found(const Segmented_shape& shape)
{
  const std::vector<Part_abstraction> parts = quick_parts(shape);
  Named_groups result;
  for (const Part_group& group : detect_symmetry_groups(parts, frame_of(parts))) {
    Named_group named{group.symmetry, {}};
    for (std::size_t part : group.parts)
      named.order.push_back(parts[part].name);
    result[Names(named.order.begin(), named.order.end())] = named;
  }
  return result;
}

Symmetry_type type_of(generated_shapes::gen::Symmetry symmetry)
{
  using generated_shapes::gen::Symmetry;
  return symmetry == Symmetry::reflection ? Symmetry_type::REFLECTION
         : symmetry == Symmetry::rotation ? Symmetry_type::ROTATION
         : symmetry == Symmetry::self     ? Symmetry_type::SELF
                                          : Symmetry_type::TRANSLATION;
}

Named_groups groups_stated(const generated_shapes::gen::Assembly& assembly)
{
  Named_groups result;
  for (const auto& group : assembly.groups) {
    Named_group named{{type_of(group.symmetry), group.point, group.direction}, group.parts};
    if (named.symmetry.type == Symmetry_type::ROTATION) named.symmetry.order = static_cast<int>(group.parts.size());
    if (group.mirror_symmetric)
      named.symmetry.direction = Point::UnitX();
    else if (named.symmetry.type == Symmetry_type::SELF)
      named.symmetry.type = Symmetry_type::NONE;
    result[Names(group.parts.begin(), group.parts.end())] = named;
  }
  return result;
}

constexpr double ANGLE = 0.02;    // angle, in radians, below which directions are parallel
constexpr double DISTANCE = 0.01; // distance, over the shape's diagonal, below which generators are the same

bool are_parallel(const Point& a, const Point& b) { return a.cross(b).norm() < ANGLE * a.norm() * b.norm(); }

/// Whether two generators are the same plane, axis or vector, up to sign.
bool is_same_generator(const Symmetry& a, const Symmetry& b, double diagonal)
{
  const double limit = DISTANCE * diagonal;
  switch (a.type) {
  case Symmetry_type::TRANSLATION:
    return std::min((a.direction - b.direction).norm(), (a.direction + b.direction).norm()) < limit;
  case Symmetry_type::ROTATION:
    return a.order == b.order && are_parallel(a.direction, b.direction) &&
           (a.point - b.point).cross(b.direction).norm() < limit;
  default:
    return are_parallel(a.direction, b.direction) && std::abs((a.point - b.point).dot(b.direction)) < limit;
  }
}

/// Whether two orders are equal up to the first member and the sense of rotation of a ring, or the direction of a row.
bool is_same_order(const Named_group& a, std::vector<std::string> order)
{
  if (a.symmetry.type == Symmetry_type::REFLECTION) return true; // pairs have a fixed order: front or left first
  for (int sense = 0; sense < 2; ++sense) {
    for (std::size_t start = 0; start < order.size(); ++start) {
      if (a.order == order) return true;
      if (a.symmetry.type != Symmetry_type::ROTATION) break;
      std::rotate(order.begin(), order.begin() + 1, order.end());
    }
    std::reverse(order.begin(), order.end());
  }
  return false;
}

double diagonal_of(const Segmented_shape& shape)
{
  Eigen::AlignedBox3d box;
  for (const Shape_part& part : shape.parts())
    for (const auto& p : part.mesh.points.colwise())
      box.extend(Point(p));
  return box.diagonal().norm();
}

/// Whether a plane is vertical and goes through the expected centre: a square shape has further mirror planes.
bool is_other_plane(const Symmetry& a, const Symmetry& expected, double diagonal)
{
  Point apart = a.point - expected.point;
  return std::abs(a.direction.y()) < ANGLE && std::abs(apart.dot(a.direction)) < DISTANCE * diagonal;
}

/// Checks that groups, kinds, orders and generators are the same. A single part may have a mirror plane through its own
/// centre where none is expected. \param square whether a quarter turn changes the shape little
void check_same(const Named_groups& found, const Named_groups& expected, double diagonal, bool square)
{
  for (const auto& [names, group] : expected) {
    CAPTURE(*names.begin(), names.size());
    const auto other = found.find(names);
    CHECK(other != found.end());
    if (other == found.end()) continue;
    const Symmetry &symmetry = other->second.symmetry, &wanted = group.symmetry;
    if (wanted.type == Symmetry_type::NONE) continue;
    CHECK(symmetry.type == wanted.type);
    const bool is_plane = wanted.type == Symmetry_type::REFLECTION || wanted.type == Symmetry_type::SELF;
    CHECK((is_same_generator(symmetry, wanted, diagonal) ||
           (square && is_plane && is_other_plane(symmetry, wanted, diagonal))));
    CHECK(is_same_order(other->second, group.order));
  }
  CHECK(found.size() == expected.size());
}

bool is_square(const std::string& model) { return model == "stool" || model == "table_pedestal"; }

Named_groups moved_groups(Named_groups groups, const Motion& motion)
{
  for (auto& [names, group] : groups) {
    Symmetry& s = group.symmetry;
    const Point to = motion(s.point + s.direction);
    s.point = motion(s.point);
    s.direction = to - s.point;
    if (s.type != Symmetry_type::TRANSLATION && !s.direction.isZero()) s.direction.normalize();
  }
  return groups;
}

const std::map<Names, Symmetry_type> TABLE_GROUPS = {{{"leg_1", "leg_2", "leg_3", "leg_4"}, Symmetry_type::REFLECTION}};
const std::map<Names, Symmetry_type> CHAIR_GROUPS = {
    {{"front_leg_l", "front_leg_r"}, Symmetry_type::REFLECTION},
    {{"back_leg_l", "back_leg_r"}, Symmetry_type::REFLECTION},
    {{"stretcher_l", "stretcher_r"}, Symmetry_type::REFLECTION},
    {{"slat_0", "slat_1", "slat_2", "slat_3", "slat_4"}, Symmetry_type::TRANSLATION}};
const std::map<Names, Symmetry_type> STAR_GROUPS = {
    {{"foot_0", "foot_1", "foot_2", "foot_3", "foot_4"}, Symmetry_type::ROTATION}};

} // namespace

TEST_CASE("Groups of shapes made of boxes are those of their construction")
{
  CHECK(groups_of(table()) == TABLE_GROUPS);
  CHECK(groups_of(chair()) == CHAIR_GROUPS);
  CHECK(groups_of(star_stool()) == STAR_GROUPS);
}

TEST_CASE("Groups do not depend on pose, scale and order of parts")
{
  std::mt19937 random(1);
  for (int i = 0; i < 8; ++i) {
    CAPTURE(i);
    const auto again = [&](const Segmented_shape& shape) {
      return groups_of(moved(shape, random_motion(random), random_order(shape.parts().size(), random)));
    };
    CHECK(again(table()) == TABLE_GROUPS);
    CHECK(again(chair()) == CHAIR_GROUPS);
    CHECK(again(star_stool()) == STAR_GROUPS);
  }
}

TEST_CASE("Noise of half a percent changes no group")
{
  std::mt19937 random(2);
  for (int i = 0; i < 4; ++i) {
    CAPTURE(i);
    CHECK(groups_of(noisy(table(), 0.005, random)) == TABLE_GROUPS);
    CHECK(groups_of(noisy(star_stool(), 0.005, random)) == STAR_GROUPS);
  }
}

TEST_CASE("The generator carries each member into the next")
{
  std::mt19937 random(3);
  const Motion motion = random_motion(random);
  const auto check = [&](const Segmented_shape& original, const std::string& name) {
    const Segmented_shape shape = moved(original, motion, random_order(original.parts().size(), random));
    const std::vector<Part_abstraction> parts = quick_parts(shape);
    const std::vector<Part_group> groups = detect_symmetry_groups(parts, frame_of(parts));
    const Part_group& group = group_with(parts, groups, name);
    const Symmetry& s = group.symmetry;
    for (std::size_t k = 0; k + 1 < group.parts.size(); ++k) {
      // The plane of a group of four mirrors its first member into the second, its third into the fourth
      if (s.type == Symmetry_type::REFLECTION && k % 2 == 1) continue;
      const Point from = shape.parts()[group.parts[k]].mesh.points.rowwise().mean();
      const Point to = shape.parts()[group.parts[k + 1]].mesh.points.rowwise().mean();
      Point image = from + s.direction;
      if (s.type == Symmetry_type::REFLECTION) image = from - 2 * s.direction.dot(from - s.point) * s.direction;
      if (s.type == Symmetry_type::ROTATION)
        image = Eigen::AngleAxisd(2 * 3.14159265358979 / s.order, s.direction) * (from - s.point) + s.point;
      CHECK((image - to).norm() < 0.01 * motion.scale);
    }
    CHECK(s.residual < 0.005);
  };
  check(table(), "leg_1");
  check(chair(), "slat_0");
  check(chair(), "stretcher_l");
  check(star_stool(), "foot_0");
}

TEST_CASE("Groups have the order, the volume and the hull of their parts")
{
  std::vector<Part_abstraction> parts = quick_parts(table());
  for (Part_abstraction& part : parts)
    part.volume = 0.01;
  const std::vector<Part_group> groups = detect_symmetry_groups(parts, frame_of(parts));
  REQUIRE(groups.size() == 2);
  CHECK(groups[0].parts == std::vector<std::size_t>{0});
  CHECK(groups[0].symmetry.type == Symmetry_type::SELF);
  CHECK(groups[0].hull_volume == Approx(1.6 * 0.05 * 0.9));
  CHECK(groups[1].volume == Approx(0.04));
  CHECK(groups[1].hull_volume == Approx(1.48 * 0.95 * 0.78));
  CHECK(groups[1].parts.size() == 4);
}

TEST_CASE("Parts that differ are in no group")
{
  const Segmented_shape original = table();
  Segmented_shape shape("table with one thick leg");
  for (const Shape_part& part : original.parts())
    shape.add_part(part.name, part.name == "leg_4" ? box({-0.7, 0.475, -0.35}, {0.2, 0.95, 0.2}) : part.mesh);
  const auto groups = groups_of(shape);
  for (const auto& [names, type] : groups)
    CHECK(names.count("leg_4") == 0);
  CHECK(groups.size() == 1);
}

TEST_CASE("A copy with another mesh is a copy")
{
  const Segmented_shape original = table();
  Segmented_shape shape("table with a fine leg");
  for (const Shape_part& part : original.parts())
    shape.add_part(part.name, part.name == "leg_4" ? box({-0.7, 0.475, -0.35}, {0.08, 0.95, 0.08}, 0, 7) : part.mesh);
  CHECK(groups_of(shape) == TABLE_GROUPS);
}

TEST_CASE("Three unevenly spaced parts are no row, slightly uneven ones are")
{
  const auto shelf = [](double middle) {
    Segmented_shape shape("shelf");
    shape.add_part("side", box({0, 0.5, 0}, {0.02, 1, 0.3}));
    for (const double y : {0.1, middle, 0.9})
      shape.add_part("board_" + std::to_string(y), box({0.26, y, 0}, {0.5, 0.02, 0.28}));
    return shape;
  };
  CHECK(groups_of(shelf(0.53)).begin()->first.size() == 3);
  CHECK(groups_of(shelf(0.25)).begin()->first.size() == 2);
}

TEST_CASE("Detection of groups, and of single kinds of symmetry, can be switched off")
{
  const std::vector<Part_abstraction> parts = quick_parts(chair());
  Symmetry_options options;
  options.enabled = false;
  CHECK(detect_symmetry_groups(parts, frame_of(parts), options).size() == parts.size());
  options.enabled = true;
  options.translation = false;
  for (const Part_group& group : detect_symmetry_groups(parts, frame_of(parts), options))
    CHECK(group.symmetry.type != Symmetry_type::TRANSLATION);
}

TEST_CASE("Parts without surface are judged by their abstractions")
{
  std::vector<Part_abstraction> parts = quick_parts(chair());
  const Shape_frame frame = frame_of(parts);
  for (Part_abstraction& part : parts) {
    part.surface.resize(3, 0);
    part.hull.resize(3, 0);
  }
  const auto groups = named(parts, detect_symmetry_groups(parts, frame));
  CHECK(groups.count({"stretcher_l", "stretcher_r"}) == 1);
  CHECK(groups.count({"slat_0", "slat_1", "slat_2", "slat_3", "slat_4"}) == 1);
}

TEST_CASE("Groups and generators of the models in data are those that they were made with")
{
  for (const auto& model : generated_shapes::gen::models()) {
    INFO(model.name);
    const auto assembly = model.make();
    const Segmented_shape shape = generated_shapes::shape_of(assembly);
    check_same(groups_found(shape), groups_stated(assembly), diagonal_of(shape), is_square(model.name));
  }
}

TEST_CASE("Groups and generators of the models in data move with them")
{
  std::mt19937 random(4);
  for (const auto& model : generated_shapes::gen::models()) {
    const auto assembly = model.make();
    const Segmented_shape shape = generated_shapes::shape_of(assembly);
    const Motion motion = random_motion(random);
    INFO(model.name << ", turned by " << motion.yaw);
    const Segmented_shape other = moved(shape, motion, random_order(shape.parts().size(), random));
    check_same(groups_found(other), moved_groups(groups_stated(assembly), motion), diagonal_of(other),
               is_square(model.name));
  }
}

TEST_CASE("Noise of half a percent of the diagonal changes no group of the models in data")
{
  const unsigned seed = GENERATE(5, 6, 7);
  std::mt19937 random(seed);
  CAPTURE(seed);
  for (const auto& model : generated_shapes::gen::models()) {
    INFO(model.name);
    const auto assembly = model.make();
    const auto found = groups_found(noisy(generated_shapes::shape_of(assembly), 0.005, random));
    for (const auto& [names, group] : groups_stated(assembly)) {
      CAPTURE(*names.begin(), names.size());
      const auto other = found.find(names);
      CHECK(other != found.end());
      if (other == found.end() || group.symmetry.type == Symmetry_type::NONE) continue;
      CHECK(other->second.symmetry.type == group.symmetry.type);
    }
  }
}
