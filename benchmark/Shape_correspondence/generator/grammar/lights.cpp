// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "lights.h"

namespace CGAL::Shape_correspondence::generator {

Solid hood(Sketch& s, double low, double high, double low_radius, double high_radius)
{
  const double wall = std::max(low_radius, high_radius) * .03, power = s.chance(.5) ? 1 : s.in(.3, 2.2);
  Profile outer, inner;
  constexpr int steps = 6;
  for (int i = 0; i <= steps; ++i) {
    const double t = double(i) / steps,
                 r = std::max(high_radius + std::pow(1 - t, power) * (low_radius - high_radius), 2 * wall);
    outer.push_back({r, low + t * (high - low)});
    inner.push_back({r - wall, low + t * (high - low) - (i == steps ? 2 * wall : 0)});
  }
  Profile all{{0, inner.back().y()}};
  all.insert(all.end(), inner.rbegin(), inner.rend());
  all.insert(all.end(), outer.begin(), outer.end());
  all.push_back({0, high});
  return post(all, s.is_square() && s.chance(.3) ? 4 : 16);
}

Solid globe(const Point& middle, double radius) { return Sketch::block(middle, Point::Constant(2 * radius), 1); }

namespace {

// The solids of a shade from the origin up to `height`; for a hanging light, the caller mirrors them.
Solids drawn_shades(Sketch& s, double size, double height, bool opens_up)
{
  const double wide = size * s.in(.8, 1.3), narrow = wide * s.in(.1, 1);
  const Point middle(0, height / 2, 0);
  switch (s.count(0, 11)) {
  case 0:
    return {globe({0, size, 0}, size)};
  case 1:
    return {Sketch::block(middle, {2 * wide, height, 2 * wide}, s.in(.3, 1))};
  case 2:
    return {s.block(middle, {2 * wide, height, 2 * wide * s.in(.5, 1)})};
  case 3: { // long, as around fluorescent tubes
    const double thickness = size * s.in(.1, .5);
    return {s.block({0, thickness / 2, 0}, {size * s.in(2, 5), thickness, size * s.in(.3, 1)})};
  }
  case 4: { // rings or plates above each other
    const int count = s.count(1, 4);
    const Solid one = s.chance(.4) ? torus({0, 0, 0}, Point::UnitY(), wide, round_section(size * s.in(.04, .15), 8), 24)
                                   : Sketch::block({0, 0, 0}, {2 * wide, size * .15, 2 * wide}, .5);
    return row(one, {0, size * .1, 0}, {0, height, 0}, count);
  }
  case 5: // a shade within another one
    return {hood(s, 0, height, wide, narrow), Sketch::block(middle, {wide, height * .6, wide}, s.in(.3, 1))};
  case 6: // a tube of glass or metal
    return {s.turned({0, 0, 0}, {0, height, 0}, size * .3, size * s.in(.4, .9))};
  default:
    return {opens_up ? translated(mirrored(hood(s, 0, height, wide, narrow), 1), {0, height, 0})
                     : hood(s, 0, height, wide, narrow)};
  }
}

} // namespace

Light drawn_light(Sketch& s, double size, bool hangs, bool has_bulb, bool has_socket)
{
  Light result;
  const double height = size * s.in(.5, 2.2), sign = hangs ? -1 : 1;
  const bool is_bare = has_bulb && s.chance(.15), opens_down = hangs ? s.chance(.85) : s.chance(.7);
  if (!is_bare)
    for (const Solid& one : drawn_shades(s, size, height, opens_down == hangs))
      result.shades.push_back(hangs ? mirrored(one, 1) : one);
  const double radius = size * s.in(.15, .4), y = sign * height * s.in(.3, .8);
  if (has_bulb)
    result.bulbs = {s.chance(.6) ? globe({0, y, 0}, radius)
                                 : s.turned({0, y - radius, 0}, {0, y + radius, 0}, radius * .3, radius)};
  if (has_socket || is_bare) result.sockets = {s.stick({0, hangs ? 0 : -height * .1, 0}, {0, y * .6, 0}, radius)};
  return result;
}

Light drawn_candle(Sketch& s, double size)
{
  const double height = size * s.in(.8, 2.5), radius = size * s.in(.12, .3);
  Light result{{}, {s.turned({0, height, 0}, {0, height + size * s.in(.4, .9), 0}, radius * .3, radius * 1.2)}, {}};
  result.sockets = {s.stick({0, 0, 0}, {0, height, 0}, 2 * radius)};
  if (s.chance(.5)) result.sockets.push_back(s.turned({0, -size * .1, 0}, {0, size * .1, 0}, radius, radius * 3));
  return result;
}

void add_light(Sketch& s, const Light& light, const std::vector<Eigen::Isometry3d>& places, double chance_of_one)
{
  const auto placed = [&](const Solids& solids) {
    Solids result;
    for (const Eigen::Isometry3d& place : places)
      for (const Solid& one : solids)
        result.push_back(transformed(one, place));
    return result;
  };
  if (!light.shades.empty()) s.add_several("shade", placed(light.shades), "", Place::none, chance_of_one);
  if (!light.bulbs.empty()) s.add_several("bulb", placed(light.bulbs), "", Place::none, chance_of_one);
  if (!light.sockets.empty()) s.add_several("body", placed(light.sockets), "bulb_socket", Place::none, chance_of_one);
}

} // namespace CGAL::Shape_correspondence::generator
