// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Unmatched_chain.h"

#include "base/Disjoint_sets.h"
#include "blend/Blend_stage.h"
#include "blend/unlike_pairs.h"

#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// Finds the chains of the parts of an end that become no part.
class Chain_finder
{
public:
  /// \param parts those that are matched
  Chain_finder(const Blend_stage& stage, int end, const std::vector<Blend_part>& parts)
      : stage_(stage), end_(end), parts_(parts), joined_(stage.meshes[std::size_t(end)].size())
  {
    for (std::size_t part = 0; part < joined_.size(); ++part)
      stays_.push_back(!parts_of(parts, end, part).empty());
    for (const Contact& contact : contacts())
      if (!stays_[contact.parts[0]] && !stays_[contact.parts[1]]) joined_.unite(contact.parts[0], contact.parts[1]);
  }

  /// By the number of a chain, its parts.
  std::map<std::size_t, std::vector<std::size_t>> chains() const
  {
    std::map<std::size_t, std::vector<std::size_t>> result;
    for (std::size_t part = 0; part < stays_.size(); ++part)
      if (!stays_[part]) result[joined_[part]].push_back(part);
    return result;
  }

  /// Where a chain touches matched parts.
  std::vector<Anchor> anchors(std::size_t chain) const
  {
    std::vector<Anchor> result;
    for (const Contact& contact : contacts())
      for (std::size_t i : {0u, 1u}) {
        const std::size_t carrier = contact.parts[1 - i];
        if (stays_[contact.parts[i]] || !stays_[carrier] || joined_[contact.parts[i]] != chain) continue;
        for (const Point& at : stage_.places_of(end_, contact))
          result.push_back(anchor(at, parts_of(parts_, end_, carrier)));
      }
    return result;
  }

private:
  const std::vector<Contact>& contacts() const { return structure(stage_.graphs[std::size_t(end_)]).contacts; }

  /// On the surface of the nearest of the pieces of a part.
  Anchor anchor(const Point& place, const std::vector<std::size_t>& pieces) const
  {
    Anchor result;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t piece : pieces) {
      const Blend_part& part = parts_[piece];
      std::size_t triangle = 0;
      const Point at = part.trees[std::size_t(part.end_surface(end_))].nearest(place, triangle);
      const double distance = (at - place).norm();
      if (distance < least) least = distance, result = {at, piece, part.morph->coordinates(end_, at)};
    }
    return result;
  }

  const Blend_stage& stage_;
  int end_;
  const std::vector<Blend_part>& parts_;
  std::vector<char> stays_;
  Disjoint_sets joined_; ///< chains of parts that go
};

/// Groups of parts that come and go at one time, so that each takes the place of the other: chains and those that they
/// correspond to, mirror images, what takes up one place, and what stands.
class Change_groups
{
public:
  Change_groups(const Blend_stage& stage, const Part_pairs& unlike)
      : stage_(stage), sources_(stage.meshes[0].size()), sets_(sources_ + stage.meshes[1].size())
  {
    for (const auto& [s, t] : unlike)
      sets_.unite(s, sources_ + t);
  }

  void add(int end, const std::vector<std::size_t>& chain, bool stands)
  {
    const std::size_t first = number_of(end, chain[0]);
    if (stands && standing_ == Blend_task::no_part) standing_ = first;
    if (stands) sets_.unite(first, standing_);
    for (std::size_t part : chain) {
      const std::size_t image = stage_.images[std::size_t(end)][part];
      sets_.unite(first, number_of(end, part));
      if (image != Mirror_images::none) sets_.unite(number_of(end, part), number_of(end, image));
      going_[std::size_t(end)].push_back(part);
    }
  }

  /// To be called when all are added.
  void find()
  {
    for (std::size_t source : going_[0])
      for (std::size_t target : going_[1])
        if (are_in_one_place(stage_, source, target)) sets_.unite(source, sources_ + target);
  }

  std::size_t operator()(const Blend_part& part) { return sets_[number_of(part.end(), part.given())]; }

private:
  std::size_t number_of(int end, std::size_t part) const { return end == 0 ? part : sources_ + part; }

  const Blend_stage& stage_;
  std::size_t sources_;
  std::size_t standing_ = Blend_task::no_part;    ///< one that stands
  Disjoint_sets sets_;                            ///< of the parts of the source, then those of the target
  std::array<std::vector<std::size_t>, 2> going_; ///< by end
};

Blend_obstacle obstacle_of(int end, std::size_t given, const Unlike_pairs& unlike)
{
  Blend_obstacle result = Blend_obstacle::NONE;
  for (const auto& pair : unlike.all) {
    if ((end == 0 ? pair.first : pair.second) != given) continue;
    if (unlike.torn.count(pair) > 0) return Blend_obstacle::TORN;
    result = Blend_obstacle::UNLIKE;
  }
  return result;
}

Blend_part unmatched_part(const Blend_stage& stage, int end, std::size_t given, const Unlike_pairs& unlike)
{
  const auto e = std::size_t(end);
  Blend_part result;
  const std::string& name = structure(stage.graphs[e]).parts[given].name;
  result.name = end == 0 ? name + '~' : '~' + name;
  result.task.type = end == 0 ? Blend_task_type::SHRINK : Blend_task_type::GROW;
  result.task.obstacle = obstacle_of(end, given, unlike);
  (end == 0 ? result.task.source : result.task.target) = given;
  result.mesh = stage.meshes[e][given];
  result.set_ends();
  return result;
}

/// Where a chain is held: the middle of its anchors, or of its foot if it has none.
Point root_of(const Unmatched_chain& chain)
{
  if (chain.anchors.empty()) return {chain.box.center().x(), chain.box.min().y(), chain.box.center().z()};
  Point sum = Point::Zero();
  for (const Anchor& anchor : chain.anchors)
    sum += anchor.at;
  return sum / double(chain.anchors.size());
}

} // namespace

std::vector<Unmatched_chain> add_unmatched_parts(const Blend_stage& stage, const Unlike_pairs& unlike,
                                                 std::vector<Blend_part>& parts)
{
  const std::size_t matched = parts.size();
  std::vector<Unmatched_chain> result;
  Change_groups groups(stage, unlike.all);
  for (int end : {0, 1}) {
    const Chain_finder finder(stage, end, parts);
    for (const auto& [number, given] : finder.chains()) {
      Unmatched_chain chain{end, {}, finder.anchors(number), {}, {}};
      for (std::size_t part : given) {
        chain.parts.push_back(parts.size());
        parts.push_back(unmatched_part(stage, end, part, unlike));
        chain.box.extend(parts.back().trees[0].box());
      }
      chain.root = root_of(chain);
      groups.add(end, given, chain.stands());
      result.push_back(std::move(chain));
    }
  }
  groups.find();
  for (std::size_t i = matched; i < parts.size(); ++i)
    parts[i].group = groups(parts[i]);
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
