// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/blend_quality.h"

#include "base/quantized.h"
#include "blend/mirror_images.h"
#include "blend/surface_components.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <numeric>
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
       "how much wider than due the gap is of parts that touch at an end"},
      {"apart", &Blend_quality::apart, Shape_blend::apart_tolerance,
       "how much wider gaps it takes to join all parts than there"},
      {"asymmetry", &Blend_quality::asymmetry, Shape_blend::symmetry_tolerance,
       "distance of the shape from its mirror image"},
      {"ground", &Blend_quality::ground, Shape_blend::ground_tolerance, "distance of the feet from the ground"},
      {"thinning", &Blend_quality::thinning, Shape_blend::thinning_tolerance,
       "share by which a part is thinner than in the source and the target"},
      {"area", &Blend_quality::area, Shape_blend::area_tolerance, "share by which the surface is larger"},
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

  void improve(double other, std::size_t a, std::size_t b)
  {
    if (other > value) value = other, parts = {a, b};
  }
  void improve(double other, std::size_t part) { improve(other, part, part); }
};

/// By which share something is larger, or smaller, than is due.
double off_due(double value, double due) { return due > 0 ? std::abs(value / due - 1) : 0; }

/// Between volumes, as if lengths were between.
double due_volume(double a, double b, double t) { return std::pow((1 - t) * std::cbrt(a) + t * std::cbrt(b), 3); }

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
  }

  Blend_quality quality() const
  {
    Blend_quality result;
    const double t = shape_.progress();
    result.height = off_due(box().sizes().y(), shape_.due_box().sizes().y());
    result.hull = off_due(hull_volume(surfaces()), due_volume(look(0).hull, look(1).hull, t));
    result.volume = off_due(volume(), due_volume(look(0).volume, look(1).volume, t));
    result.support = support();
    result.gone = gone().value;
    result.rotation = rotation().value;
    result.travel = travel().value;
    result.gap = gap().value;
    result.apart = apart();
    if (blend().is_symmetric) result.asymmetry = mirror_residual(surfaces(), trees_);
    result.ground = std::abs(lifted_foot().value);
    result.thinning = thinning().value;
    result.area = area().value;
    result.torn = torn().value;
    result.overlap = overlap().value;
    return result;
  }

  std::vector<std::string> faults(const Blend_quality& quality) const;

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
    const double due = (1 - shape_.progress()) * look(0).supports + shape_.progress() * look(1).supports;
    return due > 0 ? std::max(0., 1 - standing / due) : 0;
  }

  Worst_parts gone() const
  {
    Worst_parts worst;
    for (std::size_t i = 0; i < extents_.size(); ++i) {
      if (!part(i).morph) continue;
      const auto across = [](const contacts::Box& box) { return box.diagonal().norm(); };
      const double t = shape_.progress(), due = (1 - t) * across(end_box(i, 0)) + t * across(end_box(i, 1));
      worst.improve(off_due(across(trees_[i]->box()), due), i);
    }
    return worst;
  }

  Worst_parts rotation() const
  {
    Worst_parts worst;
    for (std::size_t i = 0; i < extents_.size(); ++i)
      worst.improve(part(i).needless_turn, i);
    return worst;
  }

  /// Of matched parts, from the way between their places in the boxes of the shapes.
  Worst_parts travel() const
  {
    Worst_parts worst;
    for (std::size_t i = 0; i < extents_.size(); ++i) {
      if (!part(i).morph) continue;
      const double t = shape_.progress();
      const Point due = (1 - t) * end_box(i, 0).center() + t * end_box(i, 1).center();
      worst.improve((trees_[i]->box().center() - due).norm(), i);
    }
    return worst;
  }

  /// Of two parts that are left over, the one that becomes the other need not keep contacts.
  Worst_parts gap() const
  {
    const auto stays = [&](std::size_t i) { return part(i).morph && part(i).task.type != Blend_task_type::EXCHANGE; };
    Worst_parts worst;
    for (const Kept_contact& contact : blend().contacts) {
      const auto [a, b] = contact.parts;
      if (!stays(a) || !stays(b)) continue;
      const double allowed = contact.allowed_gap(shape_.progress());
      worst.improve(std::sqrt(trees_[a]->nearly_closest(*trees_[b], allowed).squared) - allowed, a, b);
    }
    return worst;
  }

  double apart() const
  {
    std::vector<const contacts::Triangle_tree*> there;
    for (const std::optional<contacts::Triangle_tree>& tree : trees_)
      if (tree) there.push_back(&*tree);
    return std::max(0., widest_gap(there) - std::max(blend().widest_gap[0], blend().widest_gap[1]));
  }

  /// How far a part that stands at both ends is above the height of its foot there, or below (negative).
  Worst_parts lifted_foot() const
  {
    Worst_parts worst;
    for (std::size_t i = 0; i < extents_.size(); ++i) {
      if (!part(i).morph || !part(i).stands) continue;
      const double t = shape_.progress(i), due = (1 - t) * part(i).foot[0] + t * part(i).foot[1];
      const double lifted = trees_[i]->box().min().y() - due;
      if (std::abs(lifted) > std::abs(worst.value)) worst = {lifted, {i, i}};
    }
    return worst;
  }

  Worst_parts thinning() const
  {
    Worst_parts worst;
    for (std::size_t i = 0; i < extents_.size(); ++i)
      if (part(i).morph) worst.improve(thinning_of(part(i).rests.front(), part(i).rests.back(), extents_[i]), i);
    return worst;
  }

  /// By what share the surface is larger than at the ends, with the part that is over its own most.
  Worst_parts area() const
  {
    Worst_parts worst;
    double sum = 0;
    for (std::size_t i = 0; i < extents_.size(); ++i) {
      if (!shape_.is_there(i)) continue;
      const double at_ends = std::max(part(i).rests.front().extent().area, part(i).rests.back().extent().area);
      worst.improve(extents_[i].area - at_ends, i);
      sum += extents_[i].area;
    }
    const double most = std::max(look(0).area, look(1).area);
    worst.value = most > 0 ? std::max(0., sum / most - 1) : 0;
    return worst;
  }

  Worst_parts torn() const
  {
    Worst_parts worst;
    double sum = 0;
    for (std::size_t i = 0; i < extents_.size(); ++i) {
      if (!shape_.is_there(i) || !part(i).morph) continue;
      const double area = rest(i).torn_area(shape_.points(i), extents_[i]);
      worst.improve(area, i);
      sum += area;
    }
    worst.value = area_ > 0 ? sum / area_ : 0;
    return worst;
  }

  /// How much of the surface is inside other parts, more than at the ends; what thins or thickens may be.
  Worst_parts overlap() const
  {
    constexpr double least_share = 0.1; // of a part's surface, less may be the samples' chance
    std::vector<Seen_surface> seen;
    for (std::size_t i = 0; i < extents_.size(); ++i)
      if (part(i).morph)
        seen.push_back(
            {i, rest(i).samples(shape_.points(i)), &*trees_[i], rest(i).is_closed(), extents_[i].volume > 0});
    Worst_parts worst;
    double sum = 0;
    for (const auto& [pair, share] : overlaps_of(seen)) {
      double known = 0;
      for (std::size_t end : {0u, 1u}) {
        const auto found = look(end).overlaps.find(pair);
        if (found != look(end).overlaps.end()) known = std::max(known, found->second);
      }
      if (share - known < least_share) continue;
      const double area = (share - known) * extents_[pair[0]].area;
      worst.improve(area, pair[0], pair[1]);
      sum += area;
    }
    worst.value = area_ > 0 ? sum / area_ : 0;
    return worst;
  }

  std::string most_asymmetric() const;
  std::string quoted(std::size_t i) const { return '\'' + part(i).name + '\''; }

  const In_between_shape& shape_;
  const In_between_shape::Trees trees_;
  std::vector<Surface_extent> extents_; ///< by part
  double area_ = 0;
};

std::string percent(double share) { return std::to_string(std::lround(100 * share)) + " %"; }

std::string two_digits(double value)
{
  std::ostringstream text;
  text << std::setprecision(2) << value;
  return text.str();
}

double end_asymmetry(const Blend_structure& blend) { return std::max(blend.end_asymmetry[0], blend.end_asymmetry[1]); }

/// The parts that are farthest from the mirror image of the shape, and how far.
std::string Shape_measure::most_asymmetric() const
{
  constexpr std::size_t most_named = 3;
  std::vector<double> asymmetry(extents_.size(), 0);
  for (std::size_t i = 0; i < asymmetry.size(); ++i)
    if (shape_.is_there(i)) asymmetry[i] = mirror_residual({&shape_.points(i)}, trees_);
  std::vector<std::size_t> order(asymmetry.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return quantized(asymmetry[a]) > quantized(asymmetry[b]); });
  std::string result;
  for (std::size_t i = 0; i < std::min(most_named, order.size()); ++i) {
    if (asymmetry[order[i]] <= end_asymmetry(blend()) + Shape_blend::symmetry_tolerance) break;
    result += (i > 0 ? ", " : "") + quoted(order[i]) + " by " + two_digits(asymmetry[order[i]]);
    if (!part(order[i]).has_image()) result += " (it has no mirror image)";
  }
  return result;
}

std::vector<std::string> Shape_measure::faults(const Blend_quality& quality) const
{
  std::vector<std::string> result;
  const auto is_over = [&](double Blend_quality::*value) {
    const auto& all = blend_measures();
    const auto measure = std::find_if(all.begin(), all.end(), [&](const auto& other) { return other.value == value; });
    const double most = measure->tolerance + (value == &Blend_quality::asymmetry ? end_asymmetry(blend()) : 0);
    return quality.*value > most;
  };
  const auto add = [&](const std::string& fault) { result.push_back(fault); };
  if (is_over(&Blend_quality::height))
    add("The shape is higher or lower than is due by " + percent(quality.height) + '.');
  if (is_over(&Blend_quality::hull))
    add("The convex hull is larger or smaller than is due by " + percent(quality.hull) + '.');
  if (is_over(&Blend_quality::volume))
    add("The volume is larger or smaller than is due by " + percent(quality.volume) + '.');
  if (is_over(&Blend_quality::support))
    add("Of the parts that are due to stand on the ground, " + percent(quality.support) + " do not.");
  if (is_over(&Blend_quality::gone))
    add(quoted(gone().parts[0]) + ", which both ends have, is larger or smaller than is due by " +
        percent(quality.gone) + '.');
  if (is_over(&Blend_quality::rotation))
    add(quoted(rotation().parts[0]) + " turns by " + two_digits(quality.rotation) + " radians more than it has to.");
  if (is_over(&Blend_quality::travel))
    add(quoted(travel().parts[0]) + " is " + two_digits(quality.travel) + " of the height off its way.");
  if (is_over(&Blend_quality::gap)) {
    const auto [a, b] = gap().parts;
    add("The contact of " + quoted(a) + " and " + quoted(b) + " is open by " + two_digits(quality.gap) +
        " of the height.");
  }
  if (is_over(&Blend_quality::apart))
    add("Parts are farther from all others than at the ends by " + two_digits(quality.apart) + " of the height.");
  if (is_over(&Blend_quality::asymmetry))
    add("It is farther from its mirror image than the ends by " +
        two_digits(quality.asymmetry - end_asymmetry(blend())) + " of the height, most of all " + most_asymmetric() +
        '.');
  if (is_over(&Blend_quality::ground)) {
    const Worst_parts foot = lifted_foot();
    add("The foot of " + quoted(foot.parts[0]) + " is " + two_digits(std::abs(foot.value)) + " of the height " +
        (foot.value > 0 ? "above" : "below") + " its place on the ground.");
  }
  if (is_over(&Blend_quality::thinning))
    add(quoted(thinning().parts[0]) + " is thinner than at the ends by " + percent(quality.thinning) + '.');
  if (is_over(&Blend_quality::area))
    add("The surface is larger than at the ends by " + percent(quality.area) + ", most of all that of " +
        quoted(area().parts[0]) + '.');
  if (is_over(&Blend_quality::torn))
    add(percent(quality.torn) + " of the surface are torn or folded, most of all at " + quoted(torn().parts[0]) + '.');
  if (is_over(&Blend_quality::overlap)) {
    const auto [a, b] = overlap().parts;
    add(percent(quality.overlap) + " of the surface have gone into other parts, most of all " + quoted(a) + " into " +
        quoted(b) + '.');
  }
  return result;
}

} // namespace

Blend_quality quality(const In_between_shape& shape) { return Shape_measure(shape).quality(); }

Blend_check check(const In_between_shape& shape)
{
  const Shape_measure measure(shape);
  const Blend_quality quality = measure.quality();
  return {quality, measure.faults(quality)};
}

double cost_of(const Blend_quality& quality, const Blend_structure& blend)
{
  double result = 0;
  for (const Blend_measure& measure : blend_measures()) {
    const double own = measure.value == &Blend_quality::asymmetry ? end_asymmetry(blend) : 0;
    result += std::max(0., quality.*measure.value - own) / measure.tolerance;
  }
  return result;
}

} // namespace internal
} // namespace CGAL::Shape_correspondence
