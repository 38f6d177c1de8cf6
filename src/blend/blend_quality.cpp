// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/blend_quality.h"

#include "base/quantized.h"
#include "blend/mirror_images.h"
#include "blend/visible_quality.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

using Trees = In_between_shape::Trees;

/// By how much a contact that is to be kept is wider than it may be, at most, and between which parts.
struct Open_contact
{
  double gap = 0;
  std::array<std::size_t, 2> parts{};
};

Open_contact widest_contact(const In_between_shape& shape, const Trees& trees)
{
  Open_contact widest;
  for (const Contact_constraint& contact : shape.blend().contacts) {
    const auto [a, b] = contact.parts;
    const double allowed = contact.allowed_gap(shape.time());
    const double gap = std::sqrt(trees[a]->nearly_closest(*trees[b], allowed).squared) - allowed;
    if (gap > widest.gap) widest = {gap, contact.parts};
  }
  return widest;
}

/// How far a part that stands is above the place on the ground, or above it, that it has at the ends, or below it
/// (negative), where that is most.
struct Lifted_foot
{
  double height = 0;
  std::size_t part = 0;
};

Lifted_foot worst_foot(const In_between_shape& shape)
{
  Lifted_foot worst;
  for (std::size_t part = 0; part < shape.number_of_parts(); ++part) {
    const double height = shape.is_there(part) && shape.part(part).stands ? -shape.needed_rise(part) : 0;
    if (std::abs(height) > std::abs(worst.height)) worst = {height, part};
  }
  return worst;
}

double asymmetry(const In_between_shape& shape, const Trees& trees)
{
  std::vector<const Points*> surfaces;
  for (std::size_t part = 0; part < shape.number_of_parts(); ++part)
    if (shape.is_there(part)) surfaces.push_back(&shape.points(part));
  return mirror_residual(surfaces, trees);
}

/// By part, how far it is from the mirror image of the shape; not there: 0.
std::vector<double> asymmetries(const In_between_shape& shape, const Trees& trees)
{
  std::vector<double> result(shape.number_of_parts(), 0);
  for (std::size_t part = 0; part < result.size(); ++part)
    if (shape.is_there(part)) result[part] = mirror_residual({&shape.points(part)}, trees);
  return result;
}

Blend_quality quality(const In_between_shape& shape, const Trees& trees, const Visible_quality& seen)
{
  Blend_quality result;
  result.thinning = seen.thinning.value;
  result.area = seen.area.value;
  result.volume = seen.volume.value;
  result.torn = seen.torn.value;
  result.overlap = seen.overlap.value;
  result.wobble = seen.wobble.value;
  result.gap = widest_contact(shape, trees).gap;
  result.apart = shape.widest_disconnection();
  result.ground = std::abs(worst_foot(shape).height);
  if (shape.blend().is_symmetric) result.asymmetry = asymmetry(shape, trees);
  return result;
}

void add_contact_fault(const In_between_shape& shape, const Trees& trees, std::vector<std::string>& faults)
{
  const Open_contact contact = widest_contact(shape, trees);
  if (contact.gap <= Shape_blend::contact_tolerance) return;
  faults.push_back("The contact of " + quoted(shape, contact.parts[0]) + " and " + quoted(shape, contact.parts[1]) +
                   " is open by " + two_digits(contact.gap) + " of the height.");
}

void add_foot_fault(const In_between_shape& shape, std::vector<std::string>& faults)
{
  const Lifted_foot foot = worst_foot(shape);
  if (std::abs(foot.height) <= Shape_blend::ground_tolerance) return;
  faults.push_back("The foot of " + quoted(shape, foot.part) + " is " + two_digits(std::abs(foot.height)) +
                   " of the height " + (foot.height > 0 ? "above" : "below") + " its place on the ground.");
}

/// The parts that are farthest from the mirror image of the shape, and how far.
std::string most_asymmetric(const In_between_shape& shape, const Trees& trees)
{
  constexpr std::size_t most_named = 3;
  const std::vector<double> asymmetry = asymmetries(shape, trees);
  std::vector<std::size_t> order(asymmetry.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return quantized(asymmetry[a]) > quantized(asymmetry[b]); });
  std::string result;
  for (std::size_t i = 0; i < std::min(most_named, order.size()); ++i) {
    if (asymmetry[order[i]] <= end_asymmetry(shape.blend()) + Shape_blend::symmetry_tolerance) break;
    result += (i > 0 ? ", " : "") + quoted(shape, order[i]) + " by " + two_digits(asymmetry[order[i]]);
    if (!shape.part(order[i]).has_image()) result += " (it has no mirror image)";
  }
  return result;
}

/// \param asymmetry of the whole shape
void add_symmetry_fault(const In_between_shape& shape, const Trees& trees, double asymmetry,
                        std::vector<std::string>& faults)
{
  const double excess = asymmetry - end_asymmetry(shape.blend());
  if (excess <= Shape_blend::symmetry_tolerance) return;
  faults.push_back("It is farther from its mirror image than the ends by " + two_digits(excess) +
                   " of the height, most of all " + most_asymmetric(shape, trees) + '.');
}

} // namespace

Blend_quality quality(In_between_shape shape)
{
  const Trees& trees = shape.trees();
  return quality(shape, trees, visible_quality(shape, trees));
}

double end_asymmetry(const Blend_structure& blend) { return std::max(blend.end_asymmetry[0], blend.end_asymmetry[1]); }

Blend_check check(In_between_shape shape)
{
  const Trees& trees = shape.trees();
  const Visible_quality seen = visible_quality(shape, trees);
  Blend_check result{quality(shape, trees, seen), {}};
  add_contact_fault(shape, trees, result.faults);
  add_foot_fault(shape, result.faults);
  add_symmetry_fault(shape, trees, result.quality.asymmetry, result.faults);
  for (std::string& fault : visible_faults(seen, shape))
    result.faults.push_back(std::move(fault));
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
