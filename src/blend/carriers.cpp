// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/carriers.h"

#include "base/Disjoint_sets.h"
#include "blend/Blend_part.h"
#include "blend/Blend_stage.h"

#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <limits>
#include <optional>
#include <utility>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// The parts that go, found outwards from those that stay.
class Carrier_search
{
public:
  Carrier_search(const Blend_stage& stage, int end, const std::vector<char>& stays)
      : stage_(stage), end_(end), stays_(stays), is_found_(stays), joined_(stays.size()), joins_(stays.size(), 0)
  {
    for (const Contact& contact : contacts())
      if (stays[contact.parts[0]] == stays[contact.parts[1]]) joined_.unite(contact.parts[0], contact.parts[1]);
    find_joining_chains();
    for (const Part_mesh& mesh : stage.meshes[std::size_t(end)])
      boxes_.push_back(box_of(mesh.points));
  }

  std::vector<Carried_part> carried_parts()
  {
    add_all_carried(large);
    add_grounded(Blend_part::on_ground);
    add_all_carried(large);
    add_all_carried(0);
    add_grounded(std::numeric_limits<double>::infinity());
    for (Carried_part& found : found_) {
      found.chain = joined_[found.part];
      found.joins = joins_[found.chain];
    }
    return std::move(found_);
  }

private:
  static constexpr double large = 0.4; ///< the size of a carrier, of what it carries

  /// Chains that touch parts that stay and are not joined otherwise.
  void find_joining_chains()
  {
    std::vector<std::optional<std::size_t>> touched(stays_.size()); // by chain
    for (const Contact& contact : contacts())
      for (std::size_t i : {0u, 1u}) {
        if (stays_[contact.parts[i]] || !stays_[contact.parts[1 - i]]) continue;
        const std::size_t chain = joined_[contact.parts[i]], other = joined_[contact.parts[1 - i]];
        if (!touched[chain]) touched[chain] = other;
        if (*touched[chain] != other) joins_[chain] = 1;
      }
  }

  const std::vector<Contact>& contacts() const { return structure(stage_.graphs[std::size_t(end_)]).contacts; }
  double size(std::size_t part) const { return boxes_[part].diagonal().norm(); }

  void add_all_carried(double least_size)
  {
    while (add_carried(least_size)) {
    }
  }

  /// Adds what touches parts that are found.
  /// \param least_size of a carrier, of what it carries
  /// \return whether there is some
  bool add_carried(double least_size)
  {
    std::vector<Carried_part> next(stays_.size());
    for (const Contact& contact : contacts())
      for (std::size_t i : {0u, 1u}) {
        const std::size_t part = contact.parts[i], carrier = contact.parts[1 - i];
        if (is_found_[part] || !is_found_[carrier] || size(carrier) < least_size * size(part)) continue;
        for (const Point& place : stage_.places_of(end_, contact))
          next[part].roots.push_back({place, {carrier}});
      }
    return add(next);
  }

  /// Adds what is no higher than this above the ground.
  void add_grounded(double height)
  {
    std::vector<Carried_part> next(stays_.size());
    for (std::size_t part = 0; part < next.size(); ++part) {
      const contacts::Box& box = boxes_[part];
      if (!is_found_[part] && box.min().y() <= height)
        next[part].roots = {{{box.center().x(), box.min().y(), box.center().z()}, {}}};
    }
    add(next);
  }

  bool add(std::vector<Carried_part>& next)
  {
    bool result = false;
    for (std::size_t part = 0; part < next.size(); ++part) {
      if (next[part].roots.empty()) continue;
      next[part].part = part;
      is_found_[part] = 1;
      found_.push_back(std::move(next[part]));
      result = true;
    }
    return result;
  }

  const Blend_stage& stage_;
  int end_;
  const std::vector<char>& stays_;
  std::vector<char> is_found_; ///< or stays
  Disjoint_sets joined_;       ///< parts that stay, and chains of parts that go
  std::vector<char> joins_;    ///< by chain, whether it joins parts that nothing else joins
  std::vector<contacts::Box> boxes_;
  std::vector<Carried_part> found_;
};

} // namespace

std::vector<Carried_part> carried_parts(const Blend_stage& stage, int end, const std::vector<char>& stays)
{
  return Carrier_search(stage, end, stays).carried_parts();
}

} // namespace CGAL::Shape_correspondence::internal
