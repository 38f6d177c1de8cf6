// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/visible_quality.h"

#include "blend/exchange_reason.h"

#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <utility>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// Measures a shape part by part.
class Visible_measure
{
public:
  Visible_measure(const In_between_shape& shape, const In_between_shape::Trees& trees)
      : shape_(shape), trees_(trees), extents_(shape.number_of_parts()), others_(shape.number_of_parts())
  {
    for (std::size_t part = 0; part < extents_.size(); ++part) {
      if (!shape.is_there(part)) continue;
      extents_[part] = rest(part).extent(shape.points(part));
      area_ += extents_[part].area;
      if (shape.has_other(part)) add_other(part);
    }
  }

  Visible_quality quality() const
  {
    Visible_quality result;
    result.area = excess([](const Rest_surface&, const Surface_extent& extent) { return extent.area; },
                         std::max(look(0).area, look(1).area));
    result.volume = excess([](const Rest_surface& rest,
                              const Surface_extent& extent) { return rest.is_closed() ? std::abs(extent.volume) : 0; },
                           std::max(look(0).volume, look(1).volume));
    result.torn = torn();
    result.overlap = overlap();
    for (std::size_t part = 0; part < extents_.size(); ++part) {
      if (!shape_.is_there(part)) continue;
      improve(result.thinning, thinning(part), part);
      improve(result.wobble, wobble(part), part);
    }
    return result;
  }

private:
  /// The other surface of an exchange.
  struct Other_surface
  {
    Surface_extent extent;
    Points samples;
    contacts::Triangle_tree tree;
    double seen, others_seen; ///< shares of it, and of the one that is there as a whole
  };

  void add_other(std::size_t i)
  {
    const Points& points = shape_.other_points(i);
    const Rest_surface& own = other_rest(i);
    others_[i].emplace(Other_surface{own.extent(points), own.samples(points),
                                     *part(i).trees[std::size_t(1 - shape_.surface(i))], 1, 1});
    Other_surface& other = *others_[i];
    const Eigen::Matrix3Xi& triangles = part(i).triangles(1 - shape_.surface(i));
    other.tree.move([&](std::size_t t) { return triangle_of(points, triangles, t); });
    area_ += other.extent.area;
    other.seen = 1 - hidden_share(other.samples, *trees_[i], true);
    other.others_seen = 1 - hidden_share(rest(i).samples(shape_.points(i)), other.tree, false);
  }

  Seen_surface seen_surface(std::size_t i) const
  {
    return {i, rest(i).samples(shape_.points(i)), &*trees_[i], rest(i).is_closed(), extents_[i].volume > 0};
  }

  const Blend_part& part(std::size_t part) const { return shape_.part(part); }
  const Rest_surface& rest(std::size_t part) const
  {
    return *shape_.part(part).rests[std::size_t(shape_.surface(part))];
  }
  const Rest_surface& other_rest(std::size_t part) const
  {
    return *shape_.part(part).rests[std::size_t(1 - shape_.surface(part))];
  }
  const End_look& look(std::size_t end) const { return shape_.blend().looks[end]; }

  static void improve(Worst_parts& worst, double value, std::size_t part)
  {
    if (value > worst.value) worst = {value, {part, part}};
  }

  /// By what share the sum of a measure of surfaces is over that at the ends, with the part that is over its own most.
  template <typename Measure>
  Worst_parts excess(const Measure& measure, double most) const
  {
    Worst_parts worst;
    double sum = 0;
    for (std::size_t i = 0; i < extents_.size(); ++i) {
      if (!shape_.is_there(i)) continue;
      double own = measure(rest(i), extents_[i]);
      if (others_[i])
        own = others_[i]->others_seen * own + others_[i]->seen * measure(other_rest(i), others_[i]->extent);
      double at_ends = 0;
      for (const std::optional<Rest_surface>& surface : part(i).rests)
        if (surface) at_ends = std::max(at_ends, measure(*surface, surface->extent()));
      improve(worst, own - at_ends, i);
      sum += own;
    }
    worst.value = most > 0 ? std::max(0., sum / most - 1) : 0;
    return worst;
  }

  /// By what share a part is thinner than at the end where it is thinnest, or than what is left of it would be.
  double thinning(std::size_t i) const
  {
    constexpr double least_remaining = 0.1; // what is smaller is hardly seen
    return shape_.remaining(i) < least_remaining ? 0 : thinning_of(part(i), extents_[i], shape_.remaining(i));
  }

  Worst_parts torn() const
  {
    Worst_parts worst;
    double sum = 0;
    for (std::size_t i = 0; i < extents_.size(); ++i) {
      if (!shape_.is_there(i)) continue;
      double area = rest(i).torn_area(shape_.points(i), extents_[i]);
      if (others_[i]) area += other_rest(i).torn_area(shape_.other_points(i), others_[i]->extent);
      improve(worst, area, i);
      sum += area;
    }
    worst.value = area_ > 0 ? sum / area_ : 0;
    return worst;
  }

  /// How much of the surface is inside other parts, more than at the ends.
  Worst_parts overlap() const
  {
    constexpr double least_share = 0.1; // of a part's surface, less may be the samples' chance
    std::vector<Seen_surface> surfaces;
    for (std::size_t i = 0; i < extents_.size(); ++i)
      if (shape_.is_there(i)) surfaces.push_back(seen_surface(i));
    Worst_parts worst;
    double sum = 0;
    for (const auto& [pair, share] : overlaps_of(surfaces)) {
      if (is_attached(pair[0], pair[1]) || is_attached(pair[1], pair[0])) continue;
      double known = 0;
      for (std::size_t end : {0u, 1u}) {
        const auto found = look(end).overlaps.find(pair);
        if (found != look(end).overlaps.end()) known = std::max(known, found->second);
      }
      if (share - known < least_share) continue;
      const double area = (share - known) * extents_[pair[0]].area;
      if (area > worst.value) worst = {area, pair};
      sum += area;
    }
    worst.value = area_ > 0 ? sum / area_ : 0;
    return worst;
  }

  /// Whether a part shrinks to, or grows out of, another one, and so into it.
  bool is_attached(std::size_t a, std::size_t b) const
  {
    const std::vector<Attachment>& attachments = part(a).attachments;
    return std::any_of(attachments.begin(), attachments.end(), [&](const Attachment& on) { return on.part == b; });
  }

  const contacts::Box& end_box(std::size_t i, int end) const
  {
    return part(i).trees[std::size_t(part(i).end_surface(end))]->box();
  }

  double moved(std::size_t i) const { return (trees_[i]->box().center() - end_box(i, 0).center()).norm(); }

  /// How much farther a part that is the same at both ends has moved than those that it touches.
  double wobble(std::size_t i) const
  {
    constexpr double same = 0.02; // of the height
    if (!part(i).morph) return 0;
    const contacts::Box &from = end_box(i, 0), &to = end_box(i, 1);
    if ((to.min() - from.min()).norm() + (to.max() - from.max()).norm() > same) return 0;
    double sum = 0;
    int count = 0;
    for (const Contact_constraint& contact : shape_.blend().contacts) {
      if (contact.parts[0] != i && contact.parts[1] != i) continue;
      sum += moved(contact.parts[contact.parts[0] == i ? 1 : 0]);
      ++count;
    }
    return std::max(0., moved(i) - (count > 0 ? sum / count : 0));
  }

  const In_between_shape& shape_;
  const In_between_shape::Trees& trees_;
  std::vector<Surface_extent> extents_; ///< by part
  std::vector<std::optional<Other_surface>> others_;
  double area_ = 0;
};

std::string percent(double share) { return std::to_string(std::lround(100 * share)) + " %"; }

} // namespace

Visible_quality visible_quality(const In_between_shape& shape, const In_between_shape::Trees& trees)
{
  return Visible_measure(shape, trees).quality();
}

std::vector<std::string> visible_faults(const Visible_quality& quality, const In_between_shape& shape)
{
  std::vector<std::string> result;
  const auto add = [&](const Worst_parts& worst, double tolerance, const auto& sentence) {
    if (worst.value > tolerance) result.push_back(sentence(quoted(shape, worst.parts[0]), worst.value));
  };
  add(quality.thinning, Shape_blend::thinning_tolerance, [](const std::string& part, double value) {
    return part + " is thinner than at the ends by " + percent(value) + '.';
  });
  add(quality.area, Shape_blend::area_tolerance, [](const std::string& part, double value) {
    return "The surface is larger than at the ends by " + percent(value) + ", most of all that of " + part + '.';
  });
  add(quality.volume, Shape_blend::volume_tolerance, [](const std::string& part, double value) {
    return "The volume is larger than at the ends by " + percent(value) + ", most of all that of " + part + '.';
  });
  add(quality.torn, Shape_blend::torn_tolerance, [](const std::string& part, double value) {
    return percent(value) + " of the surface are torn or folded, most of all at " + part + '.';
  });
  add(quality.overlap, Shape_blend::overlap_tolerance, [&](const std::string& part, double value) {
    return percent(value) + " of the surface have gone into other parts, most of all " + part + " into " +
           quoted(shape, quality.overlap.parts[1]) + '.';
  });
  add(quality.wobble, Shape_blend::wobble_tolerance, [](const std::string& part, double value) {
    return part + ", which is the same at both ends, has moved farther than its neighbours by " + two_digits(value) +
           " of the height.";
  });
  return result;
}

std::string quoted(const In_between_shape& shape, std::size_t part) { return '\'' + shape.part(part).name + '\''; }

std::string two_digits(double value)
{
  std::ostringstream text;
  text << std::setprecision(2) << value;
  return text.str();
}

} // namespace CGAL::Shape_correspondence::internal
