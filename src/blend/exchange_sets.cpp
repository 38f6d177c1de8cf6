// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/exchange_sets.h"

#include "base/Disjoint_sets.h"
#include "blend/Blend_part.h"
#include "blend/Blend_stage.h"

#include <algorithm>
#include <map>
#include <utility>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// Whether boxes, made a little larger as plates have none, overlap by much of the smaller one.
bool are_in_one_place(contacts::Box a, contacts::Box b)
{
  constexpr double around = 0.03, much = 0.4;
  for (contacts::Box* box : {&a, &b}) {
    box->min().array() -= around;
    box->max().array() += around;
  }
  return a.intersects(b) && a.intersection(b).volume() > much * std::min(a.volume(), b.volume());
}

/// The parts of both ends that do not morph, numbered, and the sets of those that give way to each other.
class Leftovers
{
public:
  Leftovers(const Blend_stage& stage, const Part_pairs& paired, const Part_pairs& unlike) : stage_(stage)
  {
    for (std::size_t end : {0u, 1u})
      add_end(end, paired);
    sets_ = Disjoint_sets(all_.size());
    unite_corresponding(unlike);
    for (std::size_t s = 0; s < all_.size(); ++s)
      for (std::size_t t = s; t < all_.size(); ++t)
        if (all_[s].end < all_[t].end && are_in_one_place(all_[s].box, all_[t].box)) sets_.unite(s, t);
    while (join_what_it_touches()) {
    }
  }

  std::vector<Exchange_set> sets() const
  {
    std::map<std::size_t, Exchange_set> found;
    for (std::size_t i = 0; i < all_.size(); ++i)
      if (changes(i)) add(found[has_both_ends(i) ? sets_[i] : all_.size()], i);
    std::vector<Exchange_set> result;
    for (auto& [number, set] : found) {
      if (number == all_.size()) set.boxes = stage_.boxes; // their counterparts are elsewhere
      result.push_back(std::move(set));
    }
    return result;
  }

private:
  struct Leftover
  {
    std::size_t end, part;
    contacts::Box box; ///< in units of the box around the whole
    bool corresponds = false;
  };

  void add_end(std::size_t end, const Part_pairs& paired)
  {
    const contacts::Box& whole = stage_.boxes[end];
    const Point low = whole.min(), sizes = whole.sizes().cwiseMax(2 * Part_chart::least_half_extent);
    numbers_[end].assign(stage_.meshes[end].size(), 0);
    for (const auto& [source, target] : paired)
      numbers_[end][end == 0 ? source : target] = morphs;
    for (std::size_t part = 0; part < numbers_[end].size(); ++part) {
      if (numbers_[end][part] == morphs) continue;
      numbers_[end][part] = all_.size();
      const contacts::Box box = box_of(stage_.meshes[end][part].points);
      all_.push_back(
          {end, part, {(box.min() - low).cwiseQuotient(sizes), (box.max() - low).cwiseQuotient(sizes)}, false});
    }
  }

  /// Unites what corresponds and is together near its counterparts.
  void unite_corresponding(const Part_pairs& unlike)
  {
    constexpr double near = 0.3; // of the whole, between the middles of boxes
    Disjoint_sets corresponding(all_.size());
    for (const auto& [source, target] : unlike) {
      const std::size_t s = numbers_[0][source], t = numbers_[1][target];
      if (s != morphs) all_[s].corresponds = true;
      if (t != morphs) all_[t].corresponds = true;
      if (s != morphs && t != morphs) corresponding.unite(s, t);
    }
    std::vector<std::array<contacts::Box, 2>> around(all_.size());
    for (std::size_t i = 0; i < all_.size(); ++i)
      around[corresponding[i]][all_[i].end].extend(all_[i].box);
    for (std::size_t i = 0; i < all_.size(); ++i) {
      const auto& [from, to] = around[corresponding[i]];
      if (!from.isEmpty() && !to.isEmpty() && (from.center() - to.center()).norm() < near)
        sets_.unite(i, corresponding[i]);
    }
  }

  /// Parts that touch nothing that morphs come and go with what carries them. \return whether there are some
  bool join_what_it_touches()
  {
    bool result = false;
    for (std::size_t i = 0; i < all_.size(); ++i) {
      if (changes(i)) continue;
      std::vector<std::size_t> carriers;
      bool touches_morphing = false;
      for (const Contact& contact : structure(stage_.graphs[all_[i].end]).contacts) {
        const auto [a, b] = contact.parts;
        if (a != all_[i].part && b != all_[i].part) continue;
        const std::size_t other = numbers_[all_[i].end][a == all_[i].part ? b : a];
        if (other == morphs)
          touches_morphing = true;
        else if (changes(other))
          carriers.push_back(other);
      }
      if (touches_morphing || carriers.empty()) continue;
      for (std::size_t carrier : carriers) // all of them, so that it stays between them
        sets_.unite(i, carrier);
      result = true;
    }
    return result;
  }

  template <typename Predicate>
  bool any_in_set(std::size_t i, const Predicate& predicate) const
  {
    for (std::size_t k = 0; k < all_.size(); ++k)
      if (sets_[k] == sets_[i] && predicate(all_[k])) return true;
    return false;
  }

  bool has_both_ends(std::size_t i) const
  {
    return any_in_set(i, [&](const Leftover& other) { return other.end != all_[i].end; });
  }

  bool changes(std::size_t i) const
  {
    return has_both_ends(i) || any_in_set(i, [](const Leftover& other) { return other.corresponds; });
  }

  void add(Exchange_set& set, std::size_t i) const
  {
    const Leftover& one = all_[i];
    set.parts[one.end].push_back(one.part);
    set.boxes[one.end].extend(box_of(stage_.meshes[one.end][one.part].points));
    if (one.corresponds) set.reason = Blend_exchange::UNLIKE;
  }

  static constexpr std::size_t morphs = std::size_t(-1);

  const Blend_stage& stage_;
  std::array<std::vector<std::size_t>, 2> numbers_; ///< by end and part
  std::vector<Leftover> all_;
  Disjoint_sets sets_;
};

} // namespace

std::vector<Exchange_set> exchange_sets(const Blend_stage& stage, const Part_pairs& paired, const Part_pairs& unlike)
{
  return Leftovers(stage, paired, unlike).sets();
}

} // namespace CGAL::Shape_correspondence::internal
