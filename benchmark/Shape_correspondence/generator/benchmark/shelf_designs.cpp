// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shelf_designs.h"

#include "../chairs.h"
#include "random.h"

#include <string>

namespace CGAL {
namespace Shape_correspondence {
namespace generator {
namespace {

enum class Carcass { boards, body, posts };
enum class Shelf_base { none, legs, plinth };

struct Shelf_design
{
  const char* name;
  Carcass carcass;
  Shelf_base base;
  double width, height, depth; ///< before they are varied
  int shelves = 0, dividers = 0;
  int doors = 0; ///< side by side, below the drawers
  int drawer_rows = 0, drawer_columns = 1;
  bool back = true, knobs = false;
  bool wide_top = false; ///< overhangs the sides
};

struct Shelf_frame
{
  double width, height, depth, low, wood;

  Shelf_frame(const Shelf_design& design, Random& random)
      : width(random.about(design.width)),
        height(random.about(design.height)),
        depth(random.about(design.depth)),
        low(design.base == Shelf_base::none   ? 0
            : design.base == Shelf_base::legs ? random.between(.08, .18)
                                              : random.between(.05, .1)),
        wood(random.between(.016, .03))
  {}

  double x() const { return width / 2; }
  double z() const { return depth / 2; }
  double inner_width() const { return width - 2 * wood; }
  /// Where the k-th of n columns has its middle.
  double column(int k, int n) const { return inner_width() * ((k + .5) / n - .5); }
};

Solid crosswise(const Shelf_frame& f, double y, double overhang = 0)
{
  return board({0, y, overhang / 2}, f.width + 2 * overhang, f.depth + overhang, f.wood, {5, 6, 0, .2});
}

/// A box that is open in front, of one piece.
Solid open_box(const Shelf_frame& f)
{
  constexpr int pieces = 4; // of a side
  const auto ring = [&](double inset, double z) {
    const double x = f.x() - inset, low = f.low + inset, high = f.height - inset;
    const Point corners[] = {{-x, low, z}, {x, low, z}, {x, high, z}, {-x, high, z}};
    Path result;
    for (int side = 0; side < 4; ++side)
      for (int i = 0; i < pieces; ++i)
        result.push_back(between(corners[side], corners[(side + 1) % 4], double(i) / pieces));
    return result;
  };
  const Mesh mesh = loft({ring(0, -f.z()), ring(0, f.z()), ring(f.wood, f.z()), ring(f.wood, f.wood - f.z())});
  return {mesh, Kind::curve, line({0, f.low, 0}, {0, f.height, 0})};
}

void add_legs(Assembly& shelf, const Shelf_frame& f, bool turned)
{
  const Point foot(f.x() - .05, 0, f.z() - .05), head(f.x() - .05, f.low, f.z() - .05);
  shelf.add_four({"leg_fl", "leg_fr", "leg_bl", "leg_br"}, leg_label("front"), leg_label("back"),
                 turned ? turned_leg(foot, head, .024) : beam(foot, head, bar(.045, .045)));
}

/// Separate boards at both sides, above, below, and at the back.
void add_boards(Assembly& shelf, const Shelf_frame& f, const Shelf_design& design)
{
  const double overhang = design.wide_top ? .02 : 0;
  shelf.add_pair({"side_l", "side_r"}, {"side", "side"},
                 slab(flat({f.x() - f.wood / 2, f.low, -f.z()}, {0, f.height - f.wood - f.low, 0}, {0, 0, f.depth}),
                      f.wood, {7, 5, 0, .2}));
  shelf.add("top", {"top", ""}, crosswise(f, f.height - f.wood / 2, overhang));
  shelf.add("bottom", {"bottom", ""},
            board({0, f.low + f.wood / 2, 0}, f.inner_width(), f.depth - .01, f.wood, {5, 6, 0, .2}));
  if (design.back)
    shelf.add("back", {"back", ""},
              slab(flat({-f.x() + f.wood / 2, f.low, -f.z() - .004}, {f.width - f.wood, 0, 0},
                        {0, f.height - f.low - f.wood, 0}),
                   .008, {6, 7, 0, .2}));
}

/// One piece, which may have a top of its own.
void add_body(Assembly& shelf, const Shelf_frame& f, const Shelf_design& design)
{
  shelf.add("body", {"body", ""}, open_box(f));
  if (design.wide_top) shelf.add("top", {"top", ""}, crosswise(f, f.height + f.wood / 2, .025));
}

/// Four posts that carry the shelves, and rails from the front to the back.
void add_posts(Assembly& shelf, const Shelf_frame& f, const Shelf_design& design)
{
  const double post = .035;
  const Solid front = beam({f.x(), 0, f.z()}, {f.x(), f.height, f.z()}, bar(post, post), 8);
  shelf.add_four({"post_fl", "post_fr", "post_bl", "post_br"}, {"post", "post_front"}, {"post", "post_back"}, front);
  for (int i = 0; i < design.shelves; ++i) {
    const double y = f.low + .1 + (f.height - f.low - .12) * i / (design.shelves - 1);
    const std::string number = std::to_string(i + 1);
    shelf.add_pair({"rail_l" + number, "rail_r" + number}, {"rail", ""},
                   beam({f.x(), y - .02, -f.z()}, {f.x(), y - .02, f.z()}, bar(.03, .03)));
  }
}

/// Above each other in every column, between `low` and `high`.
void add_shelves(Assembly& shelf, const Shelf_frame& f, const Shelf_design& design, double low, double high)
{
  const bool on_posts = design.carcass == Carcass::posts;
  const int columns = on_posts ? 1 : design.dividers + 1, n = design.shelves;
  const double width = on_posts ? f.width : f.inner_width() / columns - (columns > 1 ? f.wood : .002);
  const double step = on_posts ? (f.height - f.low - .12) / (n - 1) : (high - low) / (n + 1);
  const double first = on_posts ? f.low + .1 : low + step;
  for (int k = 0; k < columns; ++k)
    shelf.add_row(numbered("shelf_" + std::to_string(k + 1) + "_", n), {"shelf", ""},
                  board({on_posts ? 0 : f.column(k, columns), first, 0}, width, f.depth - .02, f.wood, {5, 6, 0, .2}),
                  {0, step, 0});
}

void add_dividers(Assembly& shelf, const Shelf_frame& f, int dividers, double low, double high)
{
  const double step = f.inner_width() / (dividers + 1);
  shelf.add_row(numbered("divider_", dividers), {"divider", ""},
                slab(flat({-f.inner_width() / 2 + step, low, -f.z()}, {0, high - low, 0}, {0, 0, f.depth - .02}),
                     f.wood, {7, 5, 0, .2}),
                {step, 0, 0});
}

Solid handle(const Point& at, bool knob, bool upright)
{
  const Point half = upright ? Point(0, .06, 0) : Point(.06, 0, 0);
  const Point bar(at - Point(0, 0, .012));
  if (!knob) return beam(bar - half, bar + half, round_section(.007));
  const Solid turned = post({{0, 0}, {.007, 0}, {.007, .012}, {.016, .018}, {.016, .026}, {.01, .032}, {0, .034}}, 10);
  return transformed(turned, stand_on(at - Point(0, 0, .02), at + Point(0, 0, 1)));
}

void add_doors(Assembly& shelf, const Shelf_frame& f, const Shelf_design& design, double low, double high)
{
  const double width = f.width / design.doors, gap = .004, front = f.z() + f.wood / 2;
  const auto door = [&](double x) {
    return slab(flat({x - width / 2 + gap, low + gap, front}, {width - 2 * gap, 0, 0}, {0, high - low - 2 * gap, 0}),
                f.wood, {5, 7, 0, .2});
  };
  const auto grip = [&](double x) {
    return handle({x, low + .6 * (high - low), front + f.wood / 2 + .018}, design.knobs, true);
  };
  if (design.doors == 2) {
    shelf.add_pair({"door_l", "door_r"}, {"door", "door"}, door(width / 2));
    shelf.add_pair({"door_handle_l", "door_handle_r"}, {"handle", "door_handle"}, grip(.06));
    return;
  }
  const double first = (width - f.width) / 2;
  shelf.add_row(numbered("door_", design.doors), {"door", ""}, door(first), {width, 0, 0});
  shelf.add_row(numbered("door_handle_", design.doors), {"handle", design.doors == 1 ? "door_handle" : ""},
                grip(first + width / 2 - .06), {width, 0, 0});
}

void add_drawers(Assembly& shelf, const Shelf_frame& f, const Shelf_design& design, double low, double high, bool boxes)
{
  const int rows = design.drawer_rows, columns = design.drawer_columns;
  const double height = (high - low) / rows, width = (boxes ? f.inner_width() : f.width) / columns, gap = .002;
  const double depth = boxes ? .85 * f.depth : f.wood, front = f.z() + f.wood;
  for (int k = 0; k < columns; ++k) {
    const std::string column = std::to_string(k + 1) + "_";
    const double x = width * (k + .5 - columns / 2.), y = low + height / 2;
    shelf.add_row(numbered("drawer_" + column, rows), {"drawer", ""},
                  boxes ? board({x, y, front - depth / 2}, width - 2 * gap, depth, height - 2 * gap, {5, 6, 0, .05})
                        : slab(flat({x - width / 2 + gap, low + gap, front - depth / 2}, {width - 2 * gap, 0, 0},
                                    {0, height - 2 * gap, 0}),
                               depth, {6, 5, 0, .2}),
                  {0, height, 0});
    shelf.add_row(numbered("handle_" + column, rows), {"handle", ""}, handle({x, y, front + .018}, design.knobs, false),
                  {0, height, 0});
  }
}

Assembly shelf(const Shelf_design& design, std::uint64_t seed)
{
  Random random(seed);
  const Shelf_frame f(design, random);
  Assembly result(design.name, "shelf");
  if (design.base == Shelf_base::legs && design.carcass != Carcass::posts) add_legs(result, f, design.knobs);
  if (design.base == Shelf_base::plinth)
    result.add("plinth", {"plinth", ""}, board({0, f.low / 2, -.01}, f.width - .04, f.depth - .04, f.low - .004));
  if (design.carcass == Carcass::boards) add_boards(result, f, design);
  if (design.carcass == Carcass::body) add_body(result, f, design);
  if (design.carcass == Carcass::posts) add_posts(result, f, design);
  const double bottom = f.low + f.wood, top = f.height - f.wood;
  const bool has_both = design.doors > 0 && design.drawer_rows > 0;
  const double doors_end = has_both ? bottom + random.between(.5, .75) * (top - bottom) : top;
  const double drawers_begin = has_both ? doors_end : bottom;
  if (design.doors > 0) add_doors(result, f, design, bottom, doors_end);
  if (design.drawer_rows > 0) {
    const double high = has_both || design.shelves == 0 ? top : bottom + .4 * (top - bottom);
    add_drawers(result, f, design, drawers_begin, high, random.below(2) == 0);
    if (design.shelves > 0 && !has_both) {
      if (design.dividers > 0) add_dividers(result, f, design.dividers, high, top);
      add_shelves(result, f, design, high, top);
      return result;
    }
  }
  if (design.dividers > 0) add_dividers(result, f, design.dividers, bottom, top);
  if (design.shelves > 0) add_shelves(result, f, design, bottom, doors_end);
  return result;
}

const std::vector<Shelf_design>& shelf_designs()
{
  using C = Carcass;
  using B = Shelf_base;
  static const std::vector<Shelf_design> designs{
      {"shelf_bookcase", C::boards, B::none, .8, 2., .3, 5},
      {"shelf_bookcase_open", C::boards, B::legs, .7, 1.4, .32, 3, 0, 0, 0, 1, false},
      {"shelf_bookcase_plinth", C::boards, B::plinth, .9, 1.9, .3, 4, 0, 0, 0, 1, true, false, true},
      {"shelf_compartments", C::boards, B::none, 1.5, 1.5, .4, 2, 2, 0, 0, 1, false},
      {"shelf_low", C::boards, B::legs, 1.2, .5, .4, 1, 1, 0, 0, 1, true},
      {"shelf_cabinet", C::boards, B::plinth, .8, 1.2, .4, 2, 0, 2},
      {"shelf_body_shelves", C::body, B::none, .9, 1.8, .35, 4},
      {"shelf_chest", C::body, B::legs, 1., .9, .45, 0, 0, 0, 4, 1, true, true, true},
      {"shelf_chest_wide", C::body, B::plinth, 1.5, .8, .45, 0, 0, 0, 3, 2, true, false, true},
      {"shelf_wardrobe", C::body, B::plinth, 1., 2., .6, 0, 0, 2, 1, 1},
      {"shelf_wardrobe_wide", C::body, B::none, 2., 2.1, .6, 0, 2, 4, 0, 1},
      {"shelf_night_stand", C::body, B::legs, .45, .55, .4, 0, 0, 0, 2, 1, true, true},
      {"shelf_sideboard", C::boards, B::legs, 1.6, .8, .45, 0, 0, 2, 1, 3, true, false, true},
      {"shelf_posts", C::posts, B::none, .9, 1.8, .4, 5},
      {"shelf_drawers_below", C::boards, B::plinth, .8, 1.8, .35, 3, 0, 0, 2, 1, true, true},
      {"shelf_bench", C::boards, B::legs, 1.3, .45, .4, 0, 0, 0, 0, 1, false},
      {"shelf_media", C::boards, B::legs, 1.5, .5, .42, 1, 0, 0, 0, 1, false},
      {"shelf_media_back", C::boards, B::plinth, 1.6, .45, .4, 1, 2},
      {"shelf_media_drawers", C::boards, B::legs, 1.6, .5, .42, 1, 0, 0, 1, 2, true, false, true},
      {"shelf_cubes", C::boards, B::none, .8, .8, .38, 1, 1, 0, 0, 1, false},
      {"shelf_narrow", C::boards, B::none, .4, 1.9, .3, 5, 0, 0, 0, 1, false},
      {"shelf_body_legs", C::body, B::legs, 1., 1.2, .35, 3},
      {"shelf_posts_low", C::posts, B::none, 1.2, .8, .4, 2}};
  return designs;
}

} // namespace

std::vector<Assembly> shelves(std::uint64_t seed) { return shapes_of(shelf_designs(), seed, shelf); }

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL
