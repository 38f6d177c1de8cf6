// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "kinds.h"
#include "supports.h"

namespace CGAL::Shape_correspondence::generator {

namespace {

// Proportions of a table: half sizes of the top, heights of its lower and upper side.
struct Table
{
  double x, z, low, high;

  Carried carried() const { return {x, z, low}; }
};

Table table_proportions(Sketch& s)
{
  Table at;
  at.x = s.in(.2, 1.2);
  at.z = s.chance(.3) ? at.x : at.x * s.in(.3, 1);
  at.high = s.chance(.35) ? s.in(.25, .55) : s.in(.55, 1.1);
  at.low = at.high - (s.chance(.85) ? s.in(.012, .07) : s.in(.07, .15));
  return at;
}

void add_top(Sketch& s, const Table& at, bool is_round)
{
  const double y = (at.low + at.high) / 2, thickness = at.high - at.low;
  if (!is_round && s.chance(.12)) {
    const int count = s.count(2, 6);
    const double step = 2 * at.z / count;
    return s.add_several("tabletop",
                         row(s.block({0, y, 0}, {2 * at.x, thickness, .96 * step}), {0, 0, -at.z + step / 2},
                             {0, 0, at.z - step / 2}, count),
                         "", Place::none, .2);
  }
  if (s.chance(.12)) {
    const double frame = at.z * s.in(.08, .25);
    if (is_round)
      s.add("tabletop", torus({0, y, 0}, Point::UnitY(), at.x - frame / 2, round_section(frame / 2, 8), 24),
            "tabletop_frame");
    else
      s.add("tabletop",
            joined({s.block({at.x - frame / 2, y, 0}, {frame, thickness, 2 * at.z}),
                    s.block({-at.x + frame / 2, y, 0}, {frame, thickness, 2 * at.z}),
                    s.block({0, y, at.z - frame / 2}, {2 * at.x, thickness, frame}),
                    s.block({0, y, -at.z + frame / 2}, {2 * at.x, thickness, frame})}),
            "tabletop_frame");
    return s.add("tabletop",
                 Sketch::block({0, y, 0}, {2 * (at.x - frame), thickness * .5, 2 * (at.z - frame)}, is_round ? 1 : .06),
                 "glass_pane");
  }
  const Solid top = is_round ? Sketch::block({0, y, 0}, {2 * at.x, thickness, 2 * at.z}, s.in(.4, 1))
                             : s.block({0, y, 0}, {2 * at.x, thickness, 2 * at.z});
  const Solid round = transformed(disc(disc_profile(at.x, -thickness / 2, thickness / 2, thickness * .2), at.x, 0, 24),
                                  Eigen::Isometry3d(Eigen::Translation3d(0, y, 0)));
  s.add("tabletop", is_round && at.x == at.z ? round : top);
  if (s.chance(.08)) s.add("tabletop", s.block({0, at.high + .01, 0}, {1.7 * at.x, .02, 1.7 * at.z}));
}

// Adds a drawer or door that faces +z, with or without a handle.
void add_drawer(Sketch& s, const Point& middle, const Point& size, const std::string& role, bool has_handle)
{
  s.add(role, s.block(middle, size));
  if (has_handle)
    s.add("handle", handle(s, middle + Point(0, 0, size.z() / 2), s.in(.2, .5) * size.x()),
          role == "drawer" ? "drawer_handle" : "door_handle");
}

void add_drawers_under_top(Sketch& s, const Table& at)
{
  const int count = s.count(1, 3);
  const double width = 1.7 * at.x / count, height = s.in(.08, .16), depth = at.z * s.in(.1, 1.6);
  const bool has_handles = s.chance(.5);
  for (int i = 0; i < count; ++i)
    add_drawer(s, {-.85 * at.x + (i + .5) * width, at.low - height / 2, at.z * .95 - depth / 2},
               {.94 * width, height, depth}, "drawer", has_handles);
}

// Adds the pedestal of a desk at one side: boards or a body, with drawers or a door. \param side 1: left, -1: right
void add_cabinet(Sketch& s, const Table& at, double side, double width, bool is_of_boards)
{
  const double low = s.in(0, .1), height = at.low - low, x = side * (at.x - width / 2), board = .02,
               y = low + height / 2, depth = 1.8 * at.z;
  if (is_of_boards) {
    for (const double end : {-1., 1.})
      s.add("cabinet", s.block({x + end * (width - board) / 2, y, 0}, {board, height, depth}),
            end == side ? "cabinet_side_outer" : "cabinet_side_inner");
    s.add("cabinet", s.block({x, low + board / 2, 0}, {width - 2 * board, board, depth}), "cabinet_bottom");
    if (s.chance(.6)) s.add("cabinet", s.block({x, y, -depth / 2}, {width, height, board}), "cabinet_back");
  } else {
    s.add("cabinet", s.block({x, y, -.02}, {width, height, depth - .04}), "cabinet_body");
  }
  const int count = s.count(1, 4);
  const bool has_handles = s.chance(.6);
  const double deep = is_of_boards ? depth * s.in(.05, .95) : .03, step = height / count;
  for (int i = 0; i < count; ++i)
    add_drawer(s, {x, low + (i + .5) * step, depth / 2 - deep / 2 + (is_of_boards ? 0 : .01)},
               {width - 2 * board, .92 * step, deep}, count == 1 ? "door" : "drawer", has_handles);
}

// Adds one block below the top, or boards of one thickness: a cube, a bridge, a C.
void add_box(Sketch& s, const Table& at)
{
  if (s.chance(.35))
    return s.add("leg", s.block({0, at.low / 2, 0}, {2 * at.x * s.in(.4, 1), at.low, 2 * at.z * s.in(.4, 1)}),
                 s.any({"", "pedestal"}));
  const double thickness = s.in(.015, .08), x = at.x - thickness / 2;
  const Solid side = s.block({x, at.low / 2, 0}, {thickness, at.low, 2 * at.z});
  if (s.chance(.3)) {
    s.add("leg", side, "", Place::side);
    return s.add(s.chance(.5) ? "leg" : "shelf",
                 s.block({0, thickness / 2, 0}, {2 * at.x - 2 * thickness, thickness, 2 * at.z}), "bottom");
  }
  s.add_pair("leg", side, s.chance(.4) ? "side_panel" : "");
  if (s.chance(.5))
    s.add("shelf", s.block({0, at.low * s.in(.05, .6), 0}, {2 * (at.x - thickness), thickness, 2 * at.z}),
          s.any({"", "lower_shelf"}));
  if (s.chance(.4))
    s.add("panel", s.block({0, at.low / 2, -at.z + thickness / 2}, {2 * (at.x - thickness), at.low, thickness}),
          "back_panel");
}

// Adds three or four slanted legs about the middle, which may cross.
void add_spread_legs(Sketch& s, const Table& at)
{
  const double reach = std::min(at.x, at.z) * s.in(.5, 1), width = reach * s.in(.05, .15), top = s.in(-.8, 1) * reach;
  s.add_several("leg", ring(s.stick({0, 0, reach}, {0, at.low, top}, width), s.count(3, 4)), "", Place::none, .2);
  if (s.chance(.3))
    s.add("stretcher",
          torus({0, at.low * s.in(.2, .8), 0}, Point::UnitY(), reach * .6, round_section(width * .4, 6), 24));
}

void add_desk(Sketch& s, const Table& at)
{
  const double width = at.x * s.in(.35, .6);
  const bool is_of_boards = s.chance(.5);
  add_cabinet(s, at, 1, width, is_of_boards);
  if (s.chance(.4)) {
    add_cabinet(s, at, -1, width, is_of_boards);
  } else if (s.chance(.5)) {
    s.add("leg", s.block({-at.x + .02, at.low / 2, 0}, {.03, at.low, 1.8 * at.z}), "side_panel");
  } else {
    const Solid one = leg(s, {-at.x + .04, 0, at.z - .04}, {-at.x + .04, at.low, at.z - .04}, s.in(.03, .07));
    s.add("leg", one, "", Place::corner);
    s.add("leg", mirrored(snapped(one), 2), "", Place::corner);
  }
  if (s.chance(.5))
    s.add("panel", s.block({0, at.low * .7, -at.z * .8}, {2 * at.x - width, at.low * .5, .02}), "modesty_panel");
  if (s.chance(.2)) s.add("shelf", s.block({-width / 2, at.low - .08, at.z * .4}, {at.x, .02, at.z}), "keyboard_tray");
}

// Adds a shelf between the legs, or one above the top on two boards.
void add_shelves(Sketch& s, const Table& at)
{
  const double inset = s.in(.75, 1), y = at.low * s.in(.12, .6);
  if (s.chance(.8))
    return s.add("shelf", s.block({0, y, 0}, {2 * at.x * inset, s.in(.015, .04), 2 * at.z * inset}),
                 s.chance(.2) ? "lower_shelf" : "");
  const double height = s.in(.15, .5), depth = at.z * s.in(.3, .8);
  s.add("shelf", s.block({0, at.high + height, -at.z + depth / 2}, {2 * at.x * inset, .025, depth}), "upper_shelf");
  s.add_pair("panel", s.block({at.x * inset - .02, at.high + height / 2, -at.z + depth / 2}, {.025, height, depth}),
             "shelf_support");
  if (s.chance(.5))
    s.add("panel", s.block({0, at.high + height / 2, -at.z + .01}, {2 * at.x * inset, height, .02}), "back_panel");
}

} // namespace

void draw_table(Sketch& s)
{
  const Table at = table_proportions(s);
  const bool is_round = s.chance(at.x == at.z ? .6 : .15), is_desk = !is_round && at.high > .6 && s.chance(.22);
  add_top(s, at, is_round);
  if (is_desk) return add_desk(s, at);
  const Carried under{at.x * (is_round ? .72 : 1), at.z * (is_round ? .72 : 1), at.low};
  switch (s.count(0, 10)) {
  case 9:
    add_box(s, at);
    break;
  case 10:
    add_spread_legs(s, {under.half_width, under.half_depth, at.low, at.high});
    break;
  case 0:
  case 1:
    add_column(s, under);
    break;
  case 2:
    add_sides(s, under);
    break;
  case 3:
    add_leg_frame(s, under);
    break;
  default:
    add_legs(s, under);
    if (s.chance(.4)) add_rails(s, under, "apron");
    if (!is_round && s.chance(.25)) add_drawers_under_top(s, at);
    if (s.chance(.25)) add_shelves(s, at);
  }
}

} // namespace CGAL::Shape_correspondence::generator
