// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Sketch.h"

#include "../surface_distance.h"

#include <map>

namespace CGAL::Shape_correspondence::generator {

Sketch::Sketch(const std::string& category, std::uint64_t seed)
    : random_(seed), shape_("", category), is_square_(chance(.5)), roundness_(chance(.6) ? in(.05, .15) : in(.15, .5))
{}

void Sketch::add(const std::string& role, const Solid& solid, const std::string& fine, Place place)
{
  shape_.parts.push_back({role + "_" + std::to_string(shape_.parts.size()), {role, ""}, snapped(solid)});
  words_.push_back({fine.empty() && place != Place::none ? role : fine, place});
}

void Sketch::add_pair(const std::string& role, const Solid& solid, const std::string& fine, Place place)
{
  add(role, solid, fine, place);
  add(role, mirrored(snapped(solid)), fine, place);
}

void Sketch::add_four(const std::string& role, const Solid& solid, const std::string& fine)
{
  add_pair(role, solid, fine, Place::corner);
  add_pair(role, mirrored(snapped(solid), 2), fine, Place::corner);
}

void Sketch::add_several(const std::string& role, const Solids& solids, const std::string& fine, Place place,
                         double chance_of_one)
{
  if (chance(chance_of_one)) return add(role, joined(solids), fine);
  for (const Solid& solid : solids)
    add(role, solid, solids.size() == 1 || place != Place::none ? fine : "", place);
}

Solid Sketch::stick(const Point& from, const Point& to, double from_width, double to_width)
{
  return beam(from, to,
              is_square_ ? bar({from_width, from_width}, {to_width, to_width})
                         : round_section(from_width / 2, to_width / 2, 8),
              3);
}

Solid Sketch::rod(const Path& knots, double width)
{
  return tube(spline(knots, 3), is_square_ ? bar(width, width) : round_section(width / 2, 8));
}

Solid Sketch::block(const Point& middle, const Point& size, double roundness)
{
  constexpr int steps = 16, rings = 6;
  const auto flattened = [=](double x) { return std::copysign(std::pow(std::abs(x), roundness), x); };
  std::vector<Path> all;
  for (int i = 0; i < rings; ++i) {
    const double up = pi * ((i + .5) / rings - .5);
    Path path;
    for (int j = 0; j < steps; ++j) {
      const double about = 2 * pi * (j + .5) / steps, out = flattened(std::cos(up));
      const Point p(out * flattened(std::sin(about)), flattened(std::sin(up)), out * flattened(std::cos(about)));
      path.push_back(middle + p.cwiseProduct(size) / 2);
    }
    all.push_back(path);
  }
  const Point half(0, size.y() / 2, 0);
  return {loft(all, false, middle - half, middle + half), Kind::curve, line(middle - half, middle + half)};
}

Solid Sketch::turned(const Point& from, const Point& to, double least_radius, double most_radius)
{
  const double length = (to - from).norm();
  const int count = this->count(3, 7);
  Path knots;
  for (int i = 0; i <= count; ++i)
    knots.push_back({in(least_radius, most_radius), length * i / count, 0});
  Profile profile{{0, 0}};
  for (const Point& p : spline(knots, 3))
    profile.push_back({std::max(p.x(), least_radius), p.y()});
  profile.push_back({0, length});
  return transformed(post(profile), stand_on(from, to));
}

void Sketch::turn_quarter()
{
  for (Part& part : shape_.parts)
    part.solid = mapped(part.solid, [](const Point& p) { return Point(p.z(), p.y(), -p.x()); });
}

Assembly Sketch::finished(const std::string& name) const
{
  Assembly result = shape_;
  result.name = name;
  Box bounds;
  std::map<std::string, int> of_role, of_label;
  for (const Part& part : result.parts) {
    bounds.extend(box_of(part.solid.mesh.points));
    ++of_role[part.label.coarse];
  }
  const auto third = [&](const Point& p, int axis) {
    constexpr double margin = .08; // over the shape's size: what is nearer to its middle is "mid" or "center"
    const double off = (p[axis] - bounds.center()[axis]) / std::max(bounds.sizes()[axis], grid_step);
    return off > margin ? 2 : off < -margin ? 0 : 1;
  };
  for (std::size_t i = 0; i < result.parts.size(); ++i) {
    Part& part = result.parts[i];
    const Word& word = words_[i];
    part.label.fine = word.fine;
    const Point middle = box_of(part.solid.mesh.points).center();
    if (word.place == Place::corner)
      part.label.fine += std::vector<std::string>{"_back", "_mid", "_front"}[third(middle, 2)];
    const int side = third(middle, 0);
    if (word.place == Place::corner || (word.place == Place::side && side != 1))
      part.label.fine += std::vector<std::string>{"_right", "_center", "_left"}[side];
    ++of_label[part.label.fine];
  }
  for (std::size_t i = 0; i < result.parts.size(); ++i) {
    Label& label = result.parts[i].label;
    const bool is_alone = of_role[label.coarse] == 1 && words_[i].place != Place::none;
    if (is_alone || of_label[label.fine] > 1) label.fine.clear();
  }
  return result;
}

Solid joined(const Solids& solids)
{
  Solid result = solids.at(0);
  for (std::size_t i = 1; i < solids.size(); ++i)
    append(result.mesh, solids[i].mesh);
  return result;
}

Solids row(const Solid& first, const Point& from, const Point& to, int count)
{
  Solids result;
  for (int i = 0; i < count; ++i)
    result.push_back(translated(first, between(from, to, count == 1 ? .5 : double(i) / (count - 1))));
  return result;
}

Solids ring(const Solid& first, int count, const Point& centre)
{
  Solids result;
  for (int i = 0; i < count; ++i)
    result.push_back(transformed(first, rotation_about(centre, Point::UnitY(), 2 * pi * i / count)));
  return result;
}

} // namespace CGAL::Shape_correspondence::generator
