// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Exchanged_bodies.h"

#include "base/quantized.h"
#include "blend/Blend_structure.h"
#include "blend/unlike_pairs.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// Whether boxes differ so much, as shares of the boxes around the shapes, that what is in them does not take the place
/// of each other.
bool are_different(const Exchanged_bodies::Boxes& boxes, const Exchanged_bodies::Boxes& wholes)
{
  constexpr double most_change = 0.6; // of the extents, in logarithms
  constexpr double thin = 0.05;       // how much larger is hardly seen
  std::array<Point, 2> sizes, places;
  for (std::size_t end : {0u, 1u}) {
    const Point whole = wholes[end].sizes().cwiseMax(2 * Part_chart::least_half_extent);
    sizes[end] = boxes[end].sizes().cwiseQuotient(whole).array() + thin;
    places[end] = (boxes[end].center() - wholes[end].min()).cwiseQuotient(whole);
  }
  const double changes = sizes[0].cwiseQuotient(sizes[1]).array().log().abs().maxCoeff();
  const double size = std::max(boxes[0].sizes().maxCoeff(), boxes[1].sizes().maxCoeff());
  return changes > most_change || is_far(places[1] - places[0], size, wholes);
}

/// Whether one of two bodies is inside the other at both ends, as the windows of a car are.
bool are_nested(const Exchanged_bodies::Boxes& a, const Exchanged_bodies::Boxes& b)
{
  constexpr double around = 0.03, most = 0.8; // makes plates boxes; of the smaller one
  for (std::size_t end : {0u, 1u}) {
    const contacts::Box first(a[end].min().array() - around, a[end].max().array() + around),
        second(b[end].min().array() - around, b[end].max().array() + around);
    if (!first.intersects(second)) return false;
    if (first.intersection(second).volume() < most * std::min(first.volume(), second.volume())) return false;
  }
  return true;
}

} // namespace

Exchanged_bodies::Exchanged_bodies(const Blend_structure& blend, const Part_pairs& unlike)
    : blend_(blend), sets_(blend.parts.size()), is_exchanged_(blend.parts.size(), 0)
{
  for (const auto& [source, target] : unlike) {
    const std::size_t s = parts_of(blend.parts, 0, source).front(), t = parts_of(blend.parts, 1, target).front();
    if (blend.parts[s].is_matched() || blend.parts[t].is_matched()) continue;
    sets_.unite(s, t);
    is_exchanged_[s] = is_exchanged_[t] = 1;
  }
  renumber();
  while (unite_nested())
    renumber();
}

/// Unites bodies of which one is inside the other. \return whether there are any
bool Exchanged_bodies::unite_nested()
{
  bool result = false;
  for (std::size_t a = 0; a < size(); ++a)
    for (std::size_t b = a + 1; b < size(); ++b)
      if (are_nested(boxes_[a], boxes_[b])) {
        unite(a, b);
        result = true;
      }
  return result;
}

void Exchanged_bodies::unite(std::size_t a, std::size_t b)
{
  const auto member = [&](std::size_t body) {
    return std::size_t(std::find(bodies_.begin(), bodies_.end(), body) - bodies_.begin());
  };
  if (b != none)
    sets_.unite(member(a), member(b));
  else
    for (std::size_t part = 0; part < bodies_.size(); ++part)
      if (bodies_[part] == a) is_exchanged_[part] = 0;
}

void Exchanged_bodies::renumber()
{
  std::map<std::size_t, Boxes> boxes; // by set
  for (std::size_t part = 0; part < sets_.size(); ++part)
    if (is_exchanged_[part])
      boxes[sets_[part]][std::size_t(blend_.parts[part].end())].extend(blend_.parts[part].trees[0].box());
  bodies_.assign(sets_.size(), none);
  boxes_.clear();
  for (const auto& [set, both] : boxes) {
    if (both[0].isEmpty() || both[1].isEmpty() || are_different(both, blend_.boxes)) continue;
    for (std::size_t part = 0; part < sets_.size(); ++part)
      if (is_exchanged_[part] && sets_[part] == set) bodies_[part] = boxes_.size();
    boxes_.push_back(both);
  }
  put_in_order();
}

/// Numbers bodies in the order in which they are placed.
void Exchanged_bodies::put_in_order()
{
  std::vector<std::set<std::size_t>> touched(size());
  std::vector<char> is_held(size(), 0), is_placed(size(), 0);
  for (const Touch& touch : blend_.touches)
    for (std::size_t i : {0u, 1u}) {
      const std::size_t body = of(touch.parts[i]), other = touch.parts[1 - i];
      if (body == none) continue;
      if (of(other) != none) touched[body].insert(of(other));
      if (blend_.parts[other].is_matched()) is_held[body] = 1;
    }
  const auto rank = [&](std::size_t body) {
    const Point middle = boxes_[body][0].center() + boxes_[body][1].center();
    return std::tuple(is_placed[body], !is_held[body],
                      -quantized(boxes_[body][0].diagonal().norm() + boxes_[body][1].diagonal().norm()),
                      quantized(middle.x()), quantized(middle.y()), quantized(middle.z()));
  };
  std::vector<std::size_t> numbers(size());
  std::vector<Boxes> boxes;
  while (boxes.size() < size()) {
    std::size_t first = 0;
    for (std::size_t body = 1; body < size(); ++body)
      if (rank(body) < rank(first)) first = body;
    numbers[first] = boxes.size();
    boxes.push_back(boxes_[first]);
    is_placed[first] = 1;
    for (std::size_t body : touched[first])
      is_held[body] = 1;
  }
  boxes_ = boxes;
  for (std::size_t& body : bodies_)
    if (body != none) body = numbers[body];
}

} // namespace CGAL::Shape_correspondence::internal
