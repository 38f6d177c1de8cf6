// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "kinds.h"
#include "supports.h"

namespace CGAL::Shape_correspondence::generator {

namespace {

// Proportions of a shelf or cupboard: half width, half depth, heights of bottom and top, thickness of boards.
struct Case
{
  double x, z, low, high, board;

  double width() const { return 2 * x; }
  double depth() const { return 2 * z; }
  double height() const { return high - low; }
};

// A rectangle of the front that boards, doors or drawers fill: its middle and size.
struct Field
{
  double x, y, width, height;
};

Case case_proportions(Sketch& s)
{
  Case at;
  at.x = s.in(.2, .9);
  at.z = s.in(.12, .32);
  at.low = s.chance(.4) ? 0 : s.in(.04, .25);
  at.high = at.low + s.in(.35, 2);
  at.board = s.in(.012, .05);
  return at;
}

void add_carcass(Sketch& s, const Case& at, bool is_of_boards)
{
  const double y = (at.low + at.high) / 2, b = at.board;
  const Solid side = s.block({at.x - b / 2, y, 0}, {b, at.height(), at.depth()});
  const double over = s.chance(.5) ? 0 : s.in(0, .06);
  const Solid top = s.block({0, at.high + (over > 0 ? b / 2 : -b / 2), over / 2},
                            {at.width() + 2 * over, b * s.in(.8, 1.6), at.depth() + over});
  const Solid bottom = s.block({0, at.low + b / 2, 0}, {at.width() - 2 * b, b, at.depth()});
  const Solid back = s.block({0, y, -at.z + b / 4}, {at.width() - b, at.height() - b, b / 2});
  if (is_of_boards) {
    s.add_pair("side", side);
    if (s.chance(.93)) s.add("top", top);
    if (s.chance(.85)) s.add("bottom", bottom);
    if (s.chance(.65)) s.add("back", back);
    return;
  }
  if (s.chance(.3)) return s.add("body", s.block({0, y, 0}, {at.width(), at.height(), at.depth()}));
  Solids all{side, mirrored(side), bottom, back};
  if (s.chance(.35))
    s.add("top", top);
  else
    all.push_back(top);
  s.add("body", joined(all));
}

void add_doors(Sketch& s, const Case& at, const Field& field, bool has_handles)
{
  const int count = field.width > .7 * field.height || s.chance(.3) ? 2 : 1;
  const double width = field.width / count, thickness = s.in(.012, .03);
  for (int i = 0; i < count; ++i) {
    const double x = field.x - field.width / 2 + (i + .5) * width,
                 hinge = count == 2 ? (i == 0 ? 1 : -1) : s.any({-1., 1.});
    const Point middle(x, field.y, at.z + thickness / 2);
    s.add("door", s.block(middle, {.97 * width, .97 * field.height, thickness}), "", Place::side);
    if (s.chance(.15))
      s.add("door", s.block(middle + Point(0, 0, .01), {.7 * width, .8 * field.height, thickness * .4}), "door_glass");
    const Point at_hand = middle + Point(hinge * .4 * width, field.height * s.in(-.2, .2), thickness / 2);
    if (has_handles)
      s.add("handle", handle(s, at_hand, s.in(.05, .2)), s.chance(.4) ? "door_handle" : "",
            s.chance(.4) ? Place::side : Place::none);
  }
}

void add_drawers(Sketch& s, const Case& at, const Field& field, bool has_handles, bool is_deep)
{
  const int count = std::max(1, int(field.height / s.in(.12, .3))), columns = field.width > 1 && s.chance(.7) ? 2 : 1;
  const double height = field.height / count, width = field.width / columns, depth = is_deep ? at.depth() * .9 : .025;
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < columns; ++k) {
      const Point middle(field.x - field.width / 2 + (k + .5) * width, field.y - field.height / 2 + (i + .5) * height,
                         at.z + .02 - depth / 2);
      s.add("drawer", s.block(middle, {.95 * width, .92 * height, depth}));
      if (!has_handles) continue;
      const bool is_pair = width > .6 && s.chance(.3);
      for (const double off : is_pair ? std::vector<double>{-.25, .25} : std::vector<double>{0})
        s.add("handle", handle(s, middle + Point(off * width, 0, depth / 2), s.in(.04, .3) * width));
    }
}

void add_boards(Sketch& s, const Case& at, const Field& field)
{
  const int count = std::max(1, int(field.height / s.in(.2, .5)));
  const double step = field.height / (count + 1);
  const Solid one =
      s.block({field.x, field.y - field.height / 2 + step, 0}, {field.width * .98, at.board, at.depth() * s.in(.8, 1)});
  s.add_several("shelf", row(one, Point::Zero(), {0, (count - 1) * step, 0}, count), "", Place::none, .1);
}

// Divides the inside into fields one above the other or side by side, and fills each with boards, doors or drawers.
void fill(Sketch& s, const Case& at, bool is_of_boards)
{
  const int count = s.count(1, 3);
  const bool side_by_side = s.chance(.4), has_handles = s.chance(.75), is_deep = is_of_boards && s.chance(.5);
  const double w = at.width() - 2 * at.board, h = at.height() - 2 * at.board, y = (at.low + at.high) / 2;
  const int kind = s.count(0, 4); // 0 to 2: the same filling in all fields; 3, 4: drawn for each field
  for (int i = 0; i < count; ++i) {
    const double t = (i + .5) / count - .5;
    const Field field = side_by_side ? Field{t * w, y, w / count, h} : Field{0, y + t * h, w, h / count};
    switch (kind > 2 ? s.count(0, 2) : kind) {
    case 0:
      add_boards(s, at, field);
      break;
    case 1:
      add_doors(s, at, field, has_handles);
      if (s.chance(.3)) add_boards(s, at, field);
      break;
    default:
      add_drawers(s, at, field, has_handles, is_deep);
    }
    if (i == 0 || !s.chance(.6)) continue;
    const double at_border = double(i) / count - .5;
    if (side_by_side)
      s.add("divider", s.block({at_border * w, y, 0}, {at.board, h, at.depth() * .97}));
    else
      s.add("shelf", s.block({0, y + at_border * h, 0}, {w, at.board, at.depth() * .97}));
  }
}

void add_feet(Sketch& s, const Case& at)
{
  if (at.low == 0) return;
  if (s.chance(.4))
    return s.add("plinth",
                 s.block({0, at.low / 2, s.chance(.5) ? 0 : at.z * .9},
                         {at.width() * s.in(.85, 1), at.low, s.chance(.6) ? at.depth() * s.in(.8, 1) : .03}),
                 s.chance(.2) ? "plinth_front" : "");
  if (s.chance(.15)) return add_leg_frame(s, {at.x, at.z, at.low});
  add_legs(s, {at.x, at.z, at.low}, false);
}

void add_extras(Sketch& s, const Case& at)
{
  const double height = s.in(.03, .12);
  if (s.chance(.12))
    s.add("cornice",
          s.block({0, at.high + height / 2, .01}, {at.width() + 2 * height, height, at.depth() + 2 * height}));
  if (at.high < 1.1 && s.chance(.08)) {
    const double size = s.in(.4, .9);
    s.add("mirror", s.block({0, at.high + size / 2, -at.z}, {at.x * s.in(1, 1.8), size, .02}));
  }
  if (at.high < 1.1 && s.chance(.05))
    s.add("backsplash", s.block({0, at.high + height, -at.z}, {at.width(), 2 * height, .02}));
}

// A rack: boards between four posts, at times with rails.
void draw_rack(Sketch& s, const Case& at)
{
  const double width = s.in(.015, .05), x = at.x - width / 2, z = at.z - width / 2;
  const Solid post = s.stick({x, 0, z}, {x, at.high, z}, width);
  s.add_four(s.chance(.7) ? "post" : "leg", post);
  const int count = s.count(2, 6);
  s.add_several("shelf",
                row(s.block({0, at.high * .08, 0}, {at.width(), s.in(.012, .04), at.depth()}), Point::Zero(),
                    {0, at.high * s.in(.8, .9), 0}, count),
                "", Place::none, .05);
  if (!s.chance(.45)) return;
  const double y = at.high * s.in(.85, 1);
  s.add("rail", s.stick({-x, y, -z}, {x, y, -z}, width * .7));
  if (s.chance(.6)) s.add_pair("rail", s.stick({x, y, -z}, {x, y, z}, width * .7), "rail", Place::none);
  if (s.chance(.4)) s.add_pair("rail", s.stick({x, .1, -z}, {x, .1, z}, width * .7), "rail", Place::none);
}

// One or more boards on brackets, on a wall.
void draw_wall_shelf(Sketch& s, const Case& at)
{
  const int count = s.count(1, 3);
  for (int i = 0; i < count; ++i) {
    const double y = .4 * i, height = at.z * s.in(.5, 1.2);
    s.add("shelf", s.block({0, y, 0}, {at.width(), at.board, at.depth()}));
    const double x = at.x * s.in(.5, .9);
    const Solid arm = s.chance(.5) ? s.block({x, y - height / 2, -.1 * at.z}, {.02, height, 1.6 * at.z})
                                   : joined({s.stick({x, y - height, -at.z}, {x, y, -at.z}, .02),
                                             s.stick({x, y - height, -at.z}, {x, y - .02, at.z * .6}, .02)});
    s.add_pair("bracket", arm, "bracket", Place::none);
  }
  if (s.chance(.4)) s.add("back", s.block({0, .2 * (count - 1), -at.z}, {at.width(), .4 * count, .02}));
}

} // namespace

void draw_shelf(Sketch& s)
{
  const Case at = case_proportions(s);
  if (s.chance(.14)) return draw_rack(s, at);
  if (s.chance(.05)) return draw_wall_shelf(s, at);
  const bool is_of_boards = s.chance(.55);
  add_carcass(s, at, is_of_boards);
  fill(s, at, is_of_boards);
  add_feet(s, at);
  add_extras(s, at);
}

} // namespace CGAL::Shape_correspondence::generator
