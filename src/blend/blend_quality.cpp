// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/blend_quality.h"

#include "base/quantized.h"
#include "blend/mirror_images.h"
#include "blend/surface_components.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <optional>
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
       "distance of the shape from its mirror image"},
      {"torn", &Blend_quality::torn, Shape_blend::torn_tolerance, "share of the surface that is torn or folded"},
      {"overlap", &Blend_quality::overlap, Shape_blend::overlap_tolerance,
       "share of the surface that lies inside other parts"}};
  return measures;
}

namespace internal {
namespace {

/// What is said of each measure that exceeds its tolerance, in the order of `blend_measures()`: capitals stand for the
/// measure and for the parts where it is worst.
constexpr const char* sentences[] = {
    "The shape is higher or lower than is due by SHARE.",
    "The convex hull is larger or smaller than is due by SHARE.",
    "The volume is larger or smaller than is due by SHARE.",
    "Of the parts that are due to stand on the ground, SHARE do not.",
    "FIRST, which both ends have, is larger or smaller than is due by SHARE.",
    "FIRST turns by NUMBER radians more than it has to.",
    "FIRST is NUMBER of the height off its way.",
    "The contact of FIRST and SECOND is open by NUMBER of the height.",
    "Parts are farther from all others than at the ends by NUMBER of the height.",
    "It is farther from its mirror image than the ends by NUMBER of the height, most of all FIRST.",
    "SHARE of the surface are torn or folded, most of all at FIRST.",
    "SHARE of the surface have gone into other parts, most of all FIRST into SECOND."};

/// A measure of a shape, and the parts where it is worst.
struct Worst_parts
{
  double value = 0;
  std::array<std::size_t, 2> parts{}; ///< the same twice where it is a measure of one
  double sum = 0;                     ///< over all parts

  void improve(double other, std::size_t a, std::size_t b)
  {
    sum += other;
    if (std::abs(other) > std::abs(value)) value = other, parts = {a, b};
  }
};

/// By which share something is larger, or smaller, than is due.
double off_due(double value, double due) { return due > 0 ? std::abs(value / due - 1) : 0; }

/// Measures a shape part by part.
class Shape_measure
{
public:
  explicit Shape_measure(const In_between_shape& shape)
      : shape_(shape), trees_(shape.trees()), extents_(shape.number_of_parts())
  {
    for (std::size_t part = 0; part < extents_.size(); ++part) {
      if (!shape.is_there(part)) continue;
      extents_[part] = rest(part).extent(shape.points(part));
      area_ += extents_[part].area;
    }
    worst_ = {{off_due(box().sizes().y(), shape.due_box().sizes().y())},
              {off_due(hull_volume(surfaces()), due_volume(look(0).hull, look(1).hull))},
              {off_due(volume(), due_volume(look(0).volume, look(1).volume))},
              {support()},
              gone(),
              rotation(),
              travel(),
              gap(),
              {apart()},
              asymmetry(),
              torn(),
              overlap()};
  }

  Blend_quality quality() const
  {
    Blend_quality result;
    for (std::size_t i = 0; i < worst_.size(); ++i)
      result.*blend_measures()[i].value = std::abs(worst_[i].value);
    return result;
  }

  std::vector<std::string> faults() const;

private:
  const Blend_structure& blend() const { return shape_.blend(); }
  const Blend_part& part(std::size_t part) const { return shape_.part(part); }
  const Rest_surface& rest(std::size_t part) const
  {
    return shape_.part(part).rests[std::size_t(shape_.surface(part))];
  }
  const End_look& look(std::size_t end) const { return blend().looks[end]; }
  const contacts::Box& end_box(std::size_t i, int end) const
  {
    return part(i).trees[std::size_t(part(i).end_surface(end))].box();
  }

  /// What is due between the ends.
  template <typename Value>
  Value due(const Value& source, const Value& target) const
  {
    return (1 - shape_.time()) * source + shape_.time() * target;
  }
  /// Between volumes, as if lengths were between.
  double due_volume(double source, double target) const
  {
    return std::pow(due(std::cbrt(source), std::cbrt(target)), 3);
  }

  std::vector<const Points*> surfaces() const
  {
    std::vector<const Points*> result;
    for (std::size_t i = 0; i < extents_.size(); ++i)
      if (shape_.is_there(i)) result.push_back(&shape_.points(i));
    return result;
  }

  contacts::Box box() const
  {
    contacts::Box result;
    for (const std::optional<contacts::Triangle_tree>& tree : trees_)
      if (tree) result.extend(tree->box());
    return result;
  }

  double volume() const
  {
    double sum = 0;
    for (std::size_t i = 0; i < extents_.size(); ++i)
      if (shape_.is_there(i) && rest(i).is_closed()) sum += std::abs(extents_[i].volume);
    return sum;
  }

  double support() const
  {
    double standing = 0;
    for (std::size_t i = 0; i < extents_.size(); ++i)
      if (shape_.is_there(i)) standing += trees_[i]->box().min().y() <= Blend_part::on_ground;
    const double supports = due(look(0).supports, look(1).supports);
    return supports > 0 ? std::max(0., 1 - standing / supports) : 0;
  }

  template <typename Measure>
  Worst_parts worst_matched(const Measure& measure) const
  {
    Worst_parts worst;
    for (std::size_t i = 0; i < extents_.size(); ++i)
      if (part(i).morph) worst.improve(measure(i), i, i);
    return worst;
  }

  Worst_parts gone() const
  {
    const auto across = [](const contacts::Box& box) { return box.diagonal().norm(); };
    return worst_matched([&](std::size_t i) {
      return off_due(across(trees_[i]->box()), due(across(end_box(i, 0)), across(end_box(i, 1))));
    });
  }

  Worst_parts rotation() const
  {
    return worst_matched([&](std::size_t i) { return part(i).needless_turn; });
  }

  /// From the straight way.
  Worst_parts travel() const
  {
    return worst_matched([&](std::size_t i) {
      const Point at_source = end_box(i, 0).center(), at_target = end_box(i, 1).center();
      return (trees_[i]->box().center() - due(at_source, at_target)).norm();
    });
  }

  Worst_parts gap() const
  {
    Worst_parts worst;
    for (const Touch& contact : blend().touches) {
      if (!contact.is_kept()) continue;
      const auto [a, b] = contact.parts;
      const double allowed = contact.allowed_gap(shape_.time());
      worst.improve(std::max(0., std::sqrt(trees_[a]->nearly_closest(*trees_[b], allowed).squared) - allowed), a, b);
    }
    return worst;
  }

  /// Of the parts that are there.
  Tree_pointers pointers() const
  {
    Tree_pointers result;
    for (const std::optional<contacts::Triangle_tree>& tree : trees_)
      if (tree) result.push_back(&*tree);
    return result;
  }

  double apart() const
  {
    const double at_ends = std::max(blend().widest_gap[0], blend().widest_gap[1]);
    const double enough = at_ends + Shape_blend::contact_tolerance, widest = widest_gap(pointers(), enough);
    return widest > enough ? widest - at_ends : 0;
  }

  Worst_parts asymmetry() const
  {
    Worst_parts worst;
    if (!blend().is_symmetric) return worst;
    const Tree_pointers trees = pointers();
    for (std::size_t i = 0; i < extents_.size(); ++i)
      if (shape_.is_there(i)) worst.improve(mirror_residual({&shape_.points(i)}, trees), i, i);
    worst.value = mirror_residual(surfaces(), trees);
    return worst;
  }

  /// Areas as a share of the whole surface.
  Worst_parts share(Worst_parts areas) const
  {
    areas.value = area_ > 0 ? areas.sum / area_ : 0;
    return areas;
  }

  Worst_parts torn() const
  {
    return share(worst_matched([&](std::size_t i) { return rest(i).torn_area(shape_.points(i), extents_[i]); }));
  }

  /// How much of the surface is inside other parts, more than at the ends; what comes or goes may be.
  Worst_parts overlap() const
  {
    constexpr double least_share = 0.1; // of a part's surface, less may be the samples' chance
    std::vector<Seen_surface> seen;
    for (std::size_t i = 0; i < extents_.size(); ++i)
      if (part(i).morph)
        seen.push_back(
            {i, rest(i).samples(shape_.points(i)), &*trees_[i], rest(i).is_closed(), extents_[i].volume > 0});
    Worst_parts worst;
    for (const auto& [pair, inside] : overlaps_of(seen)) {
      double more = inside;
      for (std::size_t end : {0u, 1u})
        if (const auto found = look(end).overlaps.find(pair); found != look(end).overlaps.end())
          more = std::min(more, inside - found->second);
      if (more >= least_share) worst.improve(more * extents_[pair[0]].area, pair[0], pair[1]);
    }
    return share(worst);
  }

  std::string fault(std::size_t measure) const;
  std::string quoted(std::size_t i) const { return '\'' + part(i).name + '\''; }

  const In_between_shape& shape_;
  const In_between_shape::Trees trees_;
  std::vector<Surface_extent> extents_; ///< by part
  double area_ = 0;
  std::vector<Worst_parts> worst_; ///< by measure
};

std::string two_digits(double value)
{
  std::ostringstream text;
  text << std::setprecision(2) << value;
  return text.str();
}

/// What the ends have of a measure themselves, which is no fault.
double at_ends(const Blend_measure& measure, const Blend_structure& blend)
{
  const bool is_asymmetry = measure.value == &Blend_quality::asymmetry;
  return is_asymmetry ? std::max(blend.end_asymmetry[0], blend.end_asymmetry[1]) : 0;
}

bool is_fault(const Blend_measure& measure, const Blend_quality& quality, const Blend_structure& blend)
{
  return quality.*measure.value - at_ends(measure, blend) > measure.tolerance;
}

std::string Shape_measure::fault(std::size_t measure) const
{
  const Worst_parts& worst = worst_[measure];
  const double value = std::abs(worst.value) - at_ends(blend_measures()[measure], blend());
  std::string result = sentences[measure];
  const auto put = [&](const std::string& word, const std::string& text) {
    if (const std::size_t at = result.find(word); at != std::string::npos) result.replace(at, word.size(), text);
  };
  put("SHARE", std::to_string(std::lround(100 * value)) + " %");
  put("NUMBER", two_digits(value));
  put("SECOND", quoted(worst.parts[1]));
  put("FIRST", quoted(worst.parts[0]));
  return result;
}

std::vector<std::string> Shape_measure::faults() const
{
  std::vector<std::string> result;
  const Blend_quality measured = quality();
  for (std::size_t i = 0; i < worst_.size(); ++i)
    if (is_fault(blend_measures()[i], measured, blend())) result.push_back(fault(i));
  return result;
}

} // namespace

Blend_quality quality(const In_between_shape& shape) { return Shape_measure(shape).quality(); }

std::size_t number_of_faults(const Blend_quality& quality, const Blend_structure& blend)
{
  const std::vector<Blend_measure>& measures = blend_measures();
  return std::size_t(std::count_if(measures.begin(), measures.end(),
                                   [&](const Blend_measure& measure) { return is_fault(measure, quality, blend); }));
}

Blend_check check(const In_between_shape& shape)
{
  const Shape_measure measure(shape);
  return {measure.quality(), measure.faults()};
}

} // namespace internal
} // namespace CGAL::Shape_correspondence
