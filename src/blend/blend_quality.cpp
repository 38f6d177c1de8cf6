// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/In_between_shape.h"

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence {

const std::vector<Blend_measure>& blend_measures()
{
  static const std::vector<Blend_measure> measures = {
      {"height", &Blend_quality::height, Shape_blend::height_tolerance, "share by which the shape is too high or low"},
      {"hull", &Blend_quality::hull, Shape_blend::hull_tolerance,
       "share by which its convex hull is too large or small"},
      {"volume", &Blend_quality::volume, Shape_blend::volume_tolerance,
       "share by which its volume is too large or small"},
      {"support", &Blend_quality::support, Shape_blend::support_tolerance,
       "share of the parts on the ground that is missing"},
      {"gone", &Blend_quality::gone, Shape_blend::gone_tolerance,
       "share by which a part that stays is too large or small"},
      {"rotation", &Blend_quality::rotation, Shape_blend::rotation_tolerance,
       "radians by which a part turns more than it has to"},
      {"travel", &Blend_quality::travel, Shape_blend::travel_tolerance, "distance of a part from its straight way"},
      {"gap", &Blend_quality::gap, Shape_blend::contact_tolerance,
       "how much wider than due the gap is of parts that touch at both ends"},
      {"apart", &Blend_quality::apart, Shape_blend::apart_tolerance,
       "how much wider gaps it takes to join all parts than there"},
      {"asymmetry", &Blend_quality::asymmetry, Shape_blend::symmetry_tolerance,
       "how much farther the shape is from its mirror image than the ends"},
      {"torn", &Blend_quality::torn, Shape_blend::torn_tolerance, "share of the surface that is torn or folded"},
      {"overlap", &Blend_quality::overlap, Shape_blend::overlap_tolerance,
       "share of the surface that lies inside other parts"}};
  return measures;
}

namespace internal {
namespace {

/// A measure of a shape, and the parts where it is worst.
struct Worst_parts
{
  double value = 0;
  std::array<std::size_t, 2> parts{}; ///< the same twice where it is a measure of one
  double sum = 0;                     ///< over all parts

  void improve(double other, std::size_t a, std::size_t b)
  {
    sum += other;
    if (other > value) value = other, parts = {a, b};
  }
};

/// By which share something is larger, or smaller, than is due.
double off_due(double value, double due) { return due > 0 ? std::abs(value / due - 1) : 0; }

/// Measures a shape, as a whole and part by part.
class Shape_measure
{
public:
  explicit Shape_measure(const In_between_shape& shape)
      : shape_(shape), blend_(shape.blend), seen_(shape.seen()), look_(seen_)
  {
    for (const Seen_surface& surface : seen_)
      trees_.push_back(&surface.tree);
  }

  /// In the order of `blend_measures()`, with what is said of a measure that exceeds its tolerance: capitals stand for
  /// the measure and for the parts where it is worst.
  std::vector<std::pair<std::string, Worst_parts>> worst() const
  {
    const auto& [source, target] = blend_.looks;
    const double supports = due(source.supports, target.supports);
    return {
        {"The shape is higher or lower than is due by SHARE.", {off_due(look_.height, shape_.due_height())}},
        {"The convex hull is larger or smaller than is due by SHARE.",
         {off_due(look_.hull, due_volume(source.hull, target.hull))}},
        {"The volume is larger or smaller than is due by SHARE.",
         {off_due(look_.volume, due_volume(source.volume, target.volume))}},
        {"Of the parts that are due to stand on the ground, SHARE do not.",
         {supports > 0 ? std::max(0., 1 - look_.supports / supports) : 0}},
        {"FIRST, which both ends have, is larger or smaller than is due by SHARE.", gone()},
        {"FIRST turns by NUMBER radians more than it has to.",
         worst_matched([](const Seen_surface& seen) { return seen.part.needless_turn; })},
        {"FIRST is NUMBER of the height off its way.", travel()},
        {"The contact of FIRST and SECOND is open by NUMBER of the height.", gap()},
        {"Parts are farther from all others than at the ends by NUMBER of the height.", {apart()}},
        {"It is farther from its mirror image than the ends by NUMBER of the height, most of all FIRST.", asymmetry()},
        {"SHARE of the surface are torn or folded, most of all at FIRST.", torn()},
        {"SHARE of the surface have gone into other parts, most of all FIRST into SECOND.", overlap()}};
  }

private:
  /// What is due between the ends.
  template <typename Value>
  Value due(const Value& source, const Value& target) const
  {
    return (1 - shape_.time) * source + shape_.time * target;
  }
  /// Between volumes, as if lengths were between.
  double due_volume(double source, double target) const
  {
    return std::pow(due(std::cbrt(source), std::cbrt(target)), 3);
  }

  template <typename Measure>
  Worst_parts worst_matched(const Measure& measure) const
  {
    Worst_parts worst;
    for (const Seen_surface& seen : seen_)
      if (seen.part.is_matched()) worst.improve(measure(seen), seen.number, seen.number);
    return worst;
  }

  Worst_parts gone() const
  {
    const auto across = [](const contacts::Triangle_tree& tree) { return tree.box().diagonal().norm(); };
    return worst_matched([&](const Seen_surface& seen) {
      return off_due(across(seen.tree), due(across(seen.part.end_tree(0)), across(seen.part.end_tree(1))));
    });
  }

  /// From the straight way.
  Worst_parts travel() const
  {
    const auto middle = [](const contacts::Triangle_tree& tree) -> Point { return tree.box().center(); };
    return worst_matched([&](const Seen_surface& seen) {
      return (middle(seen.tree) - due(middle(seen.part.end_tree(0)), middle(seen.part.end_tree(1)))).norm();
    });
  }

  Worst_parts gap() const
  {
    Worst_parts worst;
    for (const Touch& contact : blend_.touches) {
      if (!contact.is_kept()) continue;
      const auto [a, b] = contact.parts; // matched, so that they are there and come first
      const double allowed = due(contact.gaps[0], contact.gaps[1]);
      worst.improve(std::max(0., std::sqrt(seen_[a].tree.nearly_closest(seen_[b].tree, allowed).squared) - allowed), a,
                    b);
    }
    return worst;
  }

  double apart() const
  {
    const auto& [source, target] = blend_.stage.widest_gap;
    const double at_ends = std::max(source, target), enough = at_ends + Shape_blend::contact_tolerance,
                 widest = widest_gap(trees_, enough);
    return widest > enough ? widest - at_ends : 0;
  }

  Worst_parts asymmetry() const
  {
    Worst_parts worst;
    if (!blend_.stage.are_symmetric) return worst;
    std::vector<const Points*> points;
    for (const Seen_surface& seen : seen_) {
      points.push_back(&seen.points);
      worst.improve(mirror_residual({&seen.points}, trees_), seen.number, seen.number);
    }
    const auto& [source, target] = blend_.stage.asymmetry;
    worst.value = std::max(0., mirror_residual(points, trees_) - std::max(source, target));
    return worst;
  }

  /// Areas as a share of the whole surface.
  Worst_parts share(Worst_parts areas) const
  {
    areas.value = look_.area > 0 ? areas.sum / look_.area : 0;
    return areas;
  }

  Worst_parts torn() const
  {
    return share(worst_matched([](const Seen_surface& seen) { return seen.rest.torn_area(seen.points); }));
  }

  /// How much of the surface is inside other parts, more than at the ends; what comes or goes may be.
  Worst_parts overlap() const
  {
    constexpr double least_share = 0.1; // of a part's surface, less may be the samples' chance
    Worst_parts worst;
    for (const auto& [pair, inside] : look_.overlaps) {
      double more = inside;
      for (const Shape_look& end : blend_.looks)
        if (const auto found = end.overlaps.find(pair); found != end.overlaps.end())
          more = std::min(more, inside - found->second);
      if (more >= least_share) worst.improve(more * seen_[pair[0]].extent.area, pair[0], pair[1]);
    }
    return share(worst);
  }

  const In_between_shape& shape_;
  const Blend_structure& blend_;
  const std::vector<Seen_surface> seen_; ///< in the order of parts
  const Shape_look look_;
  Tree_pointers trees_; ///< of these
};

/// A sentence with a measure and the parts where it is worst.
std::string filled_in(std::string sentence, const Worst_parts& worst, const Blend_structure& blend)
{
  std::ostringstream number;
  number << std::setprecision(2) << worst.value;
  const auto quoted = [&](std::size_t part) { return '\'' + blend.parts[part].name + '\''; };
  boost::replace_first(sentence, "SHARE", std::to_string(std::lround(100 * worst.value)) + " %");
  boost::replace_first(sentence, "NUMBER", number.str());
  boost::replace_first(sentence, "SECOND", quoted(worst.parts[1]));
  boost::replace_first(sentence, "FIRST", quoted(worst.parts[0]));
  return sentence;
}

} // namespace

Blend_check In_between_shape::check() const
{
  auto measure = blend_measures().begin();
  Blend_check result;
  for (const auto& [sentence, worst] : Shape_measure(*this).worst()) {
    result.quality.*measure->value = worst.value;
    if (worst.value > measure->tolerance) result.faults.push_back(filled_in(sentence, worst, blend));
    ++measure;
  }
  return result;
}

} // namespace internal
} // namespace CGAL::Shape_correspondence
