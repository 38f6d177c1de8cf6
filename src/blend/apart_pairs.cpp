// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/apart_pairs.h"

#include "base/Disjoint_sets.h"
#include "base/quantized.h"
#include "blend/Blend_stage.h"
#include "blend/schedules.h"
#include "blend/unlike_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// Finds parts that come apart. What moves by itself is a *mover*: a chain, or a matched part.
class Apart_finder
{
public:
  explicit Apart_finder(const Blend_structure& blend)
      : blend_(blend),
        times_(times_in_turn(blend, true)),
        tolerance_(gap_tolerance * std::max(1., (blend.boxes[0].sizes() + blend.boxes[1].sizes()).maxCoeff() / 2))
  {
    std::vector<std::size_t> movers(blend.parts.size()); // by part
    const auto add = [&](const std::vector<std::size_t>& parts) {
      sizes_.push_back(0);
      for (std::size_t part : parts) {
        movers[part] = members_.size();
        sizes_.back() = std::max(sizes_.back(), blend.parts[part].size);
      }
      members_.push_back(parts);
    };
    for (const Unmatched_chain& chain : blend.chains)
      add(chain.parts);
    for (std::size_t part = 0; part < movers.size(); ++part)
      if (blend.parts[part].is_matched()) add({part});
    for (const Touch& touch : blend.touches) {
      const auto [a, b] = std::minmax(movers[touch.parts[0]], movers[touch.parts[1]]);
      if (a == b) continue;
      Touch& found = touches_.try_emplace({a, b}, Touch{{a, b}}).first->second;
      for (std::size_t end : {0u, 1u})
        found.gaps[end] = std::min(found.gaps[end], touch.gaps[end]);
    }
  }

  /// Of the matched parts that come apart at `t`, and those that they touch, the one to which most happens, or
  /// `Blend_task::no_part`.
  std::size_t loosest_at(double t) const
  {
    const In_between_shape::Trees trees = trees_at(t);
    Disjoint_sets joined(members_.size());
    std::vector<Movers> open;
    for (const auto& [movers, touch] : touches_) {
      const double gap = gap_between(movers, trees);
      const auto [less, more] = std::minmax(sizes_[movers[0]], sizes_[movers[1]]);
      if (gap <= tolerance_ + due_gap(touch))
        joined.unite(movers[0], movers[1]);
      else if (gap < Touch::none && is_due(touch) && gap - due_gap(touch) > open_share * more &&
               less > large_share * more)
        open.push_back(movers);
    }
    const std::vector<Movers> apart = apart_movers(trees, joined);
    open.insert(open.end(), apart.begin(), apart.end());
    const std::size_t loose = loosest(open, true);
    return loose != Blend_task::no_part ? loose : loosest(apart, false);
  }

private:
  using Movers = std::array<std::size_t, 2>; // the smaller one first

  static constexpr double gap_tolerance = 0.02; // of half the longest side of the shapes
  static constexpr double open_share = 0.07;    // of the larger mover: narrower gaps are hardly seen
  static constexpr double large_share = 0.5;    // of the larger mover: for what is smaller, none is given up
  static constexpr double hung_share = 0.03;    // of the smaller mover: that far it may be from what carries it

  static double due_gap(const Touch& touch)
  {
    double result = 0;
    for (std::size_t end : {0u, 1u})
      if (touch.is_at(end)) result = std::max(result, touch.gaps[end]);
    return result;
  }

  /// Of what is there, but for chains that come or go just then.
  In_between_shape::Trees trees_at(double t) const
  {
    In_between_shape::Trees result = In_between_shape(blend_, times_, t).trees();
    for (const Unmatched_chain& chain : blend_.chains)
      for (std::size_t part : chain.parts)
        if (t > times_[part][0] && t < times_[part][1]) result[part].reset();
    return result;
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

  /// Whether two movers that are there are due to touch: matched parts that touch at one end only come apart evenly.
  bool is_due(const Touch& touch) const { return touch.is_kept() || touch.parts[0] < blend_.chains.size(); }

  /// Movers that are apart from the largest set of those that hang together, and what they touch at the ends.
  /// \param joined movers that touch
  std::vector<Movers> apart_movers(const In_between_shape::Trees& trees, Disjoint_sets& joined) const
  {
    const double near = std::max(tolerance_, 1.2 * std::max(blend_.widest_gap[0], blend_.widest_gap[1]));
    for (std::size_t a = 0; a < members_.size(); ++a)
      for (std::size_t b = a + 1; b < members_.size(); ++b)
        if (joined[a] != joined[b] &&
            gap_between({a, b}, trees) <= std::max(near, hung_share * std::min(sizes_[a], sizes_[b])))
          joined.unite(a, b);
    std::vector<double> there(members_.size(), 0); // by set of movers
    for (std::size_t mover = 0; mover < members_.size(); ++mover)
      for (std::size_t part : members_[mover])
        if (trees[part]) there[joined[mover]] += blend_.parts[part].size;
    const auto rest = std::size_t(std::max_element(there.begin(), there.end()) - there.begin());
    const auto is_apart = [&](std::size_t mover) { return there[joined[mover]] > 0 && joined[mover] != rest; };
    std::vector<Movers> result;
    for (const auto& [movers, touch] : touches_)
      if (joined[movers[0]] != joined[movers[1]] && (is_apart(movers[0]) || is_apart(movers[1])))
        result.push_back(movers);
    return result;
  }

  /// The matched part to which most happens.
  /// \param loose whether only those count to which much happens
  std::size_t loosest(const std::vector<Movers>& pairs, bool loose) const
  {
    const auto& parts = blend_.parts;
    std::size_t result = Blend_task::no_part;
    for (const Movers& movers : pairs)
      for (std::size_t mover : movers) {
        const std::size_t part = members_[mover][0];
        if (!parts[part].is_matched() || (loose && !parts[part].is_loose)) continue;
        if (result == Blend_task::no_part || quantized(parts[part].difference) > quantized(parts[result].difference))
          result = part;
      }
    return result;
  }

  const Blend_structure& blend_;
  Task_times times_;
  double tolerance_;                              ///< of a gap
  std::vector<std::vector<std::size_t>> members_; ///< by mover, its parts; chains come first
  std::vector<double> sizes_;                     ///< by mover, of its largest part
  std::map<Movers, Touch> touches_;               ///< of movers
};

} // namespace

bool take_apart_pairs(const Blend_stage& stage, const Blend_structure& blend, Unlike_pairs& unlike)
{
  constexpr int samples = 15;
  const auto& parts = blend.parts;
  const auto is_matched = [](const Blend_part& part) { return part.is_matched(); };
  if (std::none_of(parts.begin(), parts.end(), is_matched)) return false;
  const Apart_finder finder(blend);
  for (int i = 1; i <= samples; ++i) {
    const std::size_t part = finder.loosest_at(double(i) / (samples + 1));
    if (part == Blend_task::no_part) continue;
    Part_pairs both = {{parts[part].task.source, parts[part].task.target}};
    add_mirrored(both, stage.images[0], stage.images[1]);
    const std::size_t known = unlike.apart.size();
    unlike.apart.insert(both.begin(), both.end());
    return unlike.apart.size() > known;
  }
  return false;
}

} // namespace CGAL::Shape_correspondence::internal
