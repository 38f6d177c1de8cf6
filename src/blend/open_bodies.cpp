// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Blend_layout.h"
#include "blend/In_between_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// Finds bodies that come apart from what they touch. What moves by itself is a *mover*: a body, by its number, or else
/// a single part.
class Open_bodies
{
public:
  Open_bodies(const Blend_structure& blend, const Blend_layout& layout, Exchanged_bodies& bodies)
      : blend_(blend),
        layout_(layout),
        bodies_(bodies),
        tolerance_(gap_tolerance * std::max(1., (blend.boxes[0].sizes() + blend.boxes[1].sizes()).maxCoeff() / 2)),
        members_(bodies.size())
  {
    std::vector<std::size_t> movers; // by part
    for (std::size_t part = 0; part < blend.parts.size(); ++part) {
      const std::size_t body = bodies.of(part);
      movers.push_back(body == bodies.none ? members_.size() : body);
      if (body == bodies.none) members_.emplace_back();
      members_[movers.back()].push_back(part);
    }
    for (const Touch& touch : blend.touches) {
      const auto [a, b] = std::minmax(movers[touch.parts[0]], movers[touch.parts[1]]);
      if (a == b) continue;
      Touch& found = touches_.try_emplace({a, b}, Touch{{a, b}}).first->second;
      for (std::size_t end : {0u, 1u})
        found.gaps[end] = std::min(found.gaps[end], touch.gaps[end]);
    }
  }

  /// Unites those that are open at `t`. \return whether there are any
  bool unite_at(double t)
  {
    const In_between_shape shape(blend_, layout_, t);
    const In_between_shape::Trees trees = shape.trees();
    Disjoint_sets joined(members_.size());
    bool is_open = false;
    for (const auto& [movers, touch] : touches_) {
      const double gap = gap_between(movers, trees);
      const double allowed =
          touch.is_kept() ? std::max(touch.gaps[0], touch.gaps[1]) : touch.gaps[touch.is_at(0) ? 0 : 1];
      if (gap <= tolerance_ + allowed)
        joined.unite(movers[0], movers[1]);
      else if (gap < Touch::none && is_due(touch, shape))
        is_open = unite(movers) || is_open;
    }
    return is_open || unite_with_the_rest(trees, joined);
  }

private:
  using Movers = std::array<std::size_t, 2>; // the smaller one first

  static constexpr double gap_tolerance = 0.012; // of half the longest side of the shapes

  /// \return whether there is a body among them
  bool unite(const Movers& movers)
  {
    if (movers[0] >= bodies_.size()) return false;
    bodies_.unite(movers[0], movers[1] < bodies_.size() ? movers[1] : bodies_.none);
    return true;
  }

  /// The least distance of what there is of two movers.
  double gap_between(const Movers& movers, const In_between_shape::Trees& trees) const
  {
    double least = Touch::none;
    for (std::size_t a : members_[movers[0]])
      for (std::size_t b : members_[movers[1]])
        if (trees[a] && trees[b] && trees[a]->box().exteriorDistance(trees[b]->box()) < least)
          least = std::min(least, std::sqrt(trees[a]->nearly_closest(*trees[b], tolerance_ / 2).squared));
    return least;
  }

  /// Whether two movers are due to touch: they do so at both ends, or are what they are at an end where they do.
  bool is_due(const Touch& touch, const In_between_shape& shape) const
  {
    const auto is_as_at = [&](std::size_t mover, int end) {
      const auto is_of_end = [&](std::size_t i) { return shape.is_there(i) && blend_.parts[i].is_at(end); };
      return std::any_of(members_[mover].begin(), members_[mover].end(), is_of_end);
    };
    const int end = touch.is_at(0) ? 0 : 1;
    return touch.is_kept() || (is_as_at(touch.parts[0], end) && is_as_at(touch.parts[1], end));
  }

  /// Unites bodies that are apart from the largest connected part of the shape with what they touch at the ends.
  /// \param joined movers that touch
  bool unite_with_the_rest(const In_between_shape::Trees& trees, Disjoint_sets& joined)
  {
    const double near = std::max(tolerance_, 1.2 * std::max(blend_.widest_gap[0], blend_.widest_gap[1]));
    std::vector<double> there(members_.size(), 0), sizes(members_.size(), 0); // by mover, and by set
    for (std::size_t mover = 0; mover < members_.size(); ++mover)
      for (std::size_t i : members_[mover])
        if (trees[i]) there[mover] += blend_.parts[i].size;
    for (std::size_t a = 0; a < members_.size(); ++a)
      for (std::size_t b = a + 1; b < members_.size(); ++b)
        if (joined[a] != joined[b] && gap_between({a, b}, trees) <= near) joined.unite(a, b);
    for (std::size_t mover = 0; mover < members_.size(); ++mover)
      sizes[joined[mover]] += there[mover];
    const auto rest = std::size_t(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
    const auto is_apart = [&](std::size_t mover) { return sizes[joined[mover]] > 0 && joined[mover] != rest; };
    bool is_open = false;
    for (const auto& [movers, touch] : touches_)
      if (joined[movers[0]] != joined[movers[1]] && (is_apart(movers[0]) || is_apart(movers[1])))
        is_open = unite(movers) || is_open;
    return is_open;
  }

  const Blend_structure& blend_;
  const Blend_layout& layout_;
  Exchanged_bodies& bodies_;
  double tolerance_;                              ///< of a gap
  std::vector<std::vector<std::size_t>> members_; ///< by mover, its parts
  std::map<Movers, Touch> touches_;               ///< of movers
};

} // namespace

bool unite_open_bodies(const Blend_structure& blend, const Blend_layout& layout, Exchanged_bodies& bodies)
{
  constexpr int samples = 15;
  if (bodies.size() == 0) return false;
  Open_bodies open(blend, layout, bodies);
  for (int i = 1; i <= samples; ++i)
    if (open.unite_at(double(i) / (samples + 1))) {
      bodies.renumber();
      return true;
    }
  return false;
}

} // namespace CGAL::Shape_correspondence::internal
