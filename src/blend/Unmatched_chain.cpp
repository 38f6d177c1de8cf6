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
#include <set>
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
      if (stays_[contact.parts[0]] == stays_[contact.parts[1]]) joined_.unite(contact.parts[0], contact.parts[1]);
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
    visit_carriers(chain, [&](const Contact& contact, std::size_t carrier) {
      for (const Point& at : stage_.places_of(end_, contact))
        result.push_back(anchor(at, parts_of(parts_, end_, carrier)));
    });
    return result;
  }

  /// Whether a chain touches matched parts that nothing else joins.
  bool joins(std::size_t chain) const
  {
    std::set<std::size_t> joined;
    visit_carriers(chain, [&](const Contact&, std::size_t carrier) { joined.insert(joined_[carrier]); });
    return joined.size() > 1;
  }

private:
  const std::vector<Contact>& contacts() const { return structure(stage_.graphs[std::size_t(end_)]).contacts; }

  template <typename Visit>
  void visit_carriers(std::size_t chain, const Visit& visit) const
  {
    for (const Contact& contact : contacts())
      for (std::size_t i : {0u, 1u})
        if (!stays_[contact.parts[i]] && stays_[contact.parts[1 - i]] && joined_[contact.parts[i]] == chain)
          visit(contact, contact.parts[1 - i]);
  }

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
      if (distance < least) least = distance, result = {at, piece, part.carried(end_, at)};
    }
    return result;
  }

  const Blend_stage& stage_;
  int end_;
  const std::vector<Blend_part>& parts_;
  std::vector<char> stays_;
  Disjoint_sets joined_; ///< parts that stay, and chains of parts that go
};

/// Groups of parts that come and go at one time, so that each takes the place of the other: chains and those that they
/// correspond to, mirror images, what takes up one place, and what else a shape needs to stand or to hang together.
class Change_groups
{
public:
  Change_groups(const Blend_stage& stage, const Part_pairs& unlike)
      : stage_(stage), sources_(stage.meshes[0].size()), sets_(sources_ + stage.meshes[1].size())
  {
    for (const auto& [s, t] : unlike)
      sets_.unite(s, sources_ + t);
  }

  void add(int end, const std::vector<std::size_t>& chain, bool stands, bool joins)
  {
    const std::size_t first = number_of(end, chain[0]);
    for (std::size_t part : chain) {
      const std::size_t image = stage_.images[std::size_t(end)][part];
      sets_.unite(first, number_of(end, part));
      if (image != Mirror_images::none) sets_.unite(first, number_of(end, image));
      going_[std::size_t(end)].push_back(part);
    }
    if (stands) standing_.push_back(first);
    if (joins) joining_.push_back(first);
  }

  /// To be called when all are added.
  void find()
  {
    for (std::size_t source : going_[0])
      for (std::size_t target : going_[1])
        if (are_in_one_place(stage_, source, target)) sets_.unite(source, sources_ + target);
    unite(standing_);
    std::array<std::set<std::size_t>, 2> groups; // by end
    for (int end : {0, 1})
      for (std::size_t part : going_[std::size_t(end)])
        groups[std::size_t(end)].insert(sets_[number_of(end, part)]);
    std::vector<std::size_t> alone; // that have no others in their place
    for (std::size_t number : joining_)
      if (groups[0].count(sets_[number]) + groups[1].count(sets_[number]) == 1) alone.push_back(number);
    unite(alone);
  }

  std::size_t operator()(const Blend_part& part) { return sets_[number_of(part.end(), part.given())]; }

private:
  void unite(const std::vector<std::size_t>& numbers)
  {
    for (std::size_t number : numbers)
      sets_.unite(number, numbers[0]);
  }
  std::size_t number_of(int end, std::size_t part) const { return end == 0 ? part : sources_ + part; }

  const Blend_stage& stage_;
  std::size_t sources_;
  Disjoint_sets sets_;                            ///< of the parts of the source, then those of the target
  std::vector<std::size_t> standing_, joining_;   ///< of a chain that stands, or joins what nothing else joins, a part
  std::array<std::vector<std::size_t>, 2> going_; ///< by end
};

Blend_part unmatched_part(const Blend_stage& stage, int end, std::size_t given, bool is_unlike)
{
  const auto e = std::size_t(end);
  Blend_part result;
  const std::string& name = structure(stage.graphs[e]).parts[given].name;
  result.name = end == 0 ? name + '~' : '~' + name;
  result.task.type = end == 0 ? Blend_task_type::SHRINK : Blend_task_type::GROW;
  if (is_unlike) result.task.obstacle = Blend_obstacle::UNLIKE;
  (end == 0 ? result.task.source : result.task.target) = given;
  result.mesh = stage.meshes[e][given];
  result.set_ends();
  return result;
}

/// Adds the mirror images of the anchors of its mirror image to every chain, so that both go alike.
void mirror_anchors(const std::vector<Blend_part>& parts, std::vector<Unmatched_chain>& chains)
{
  const std::vector<Unmatched_chain> given = chains;
  for (Unmatched_chain& chain : chains)
    for (const Unmatched_chain& other : given) {
      if (parts[other.parts[0]].image == Blend_task::no_part ||
          std::find(chain.parts.begin(), chain.parts.end(), parts[other.parts[0]].image) == chain.parts.end())
        continue;
      for (const Anchor& anchor : other.anchors)
        if (const std::size_t image = parts[anchor.carrier].image; image != Blend_task::no_part) {
          const Point at = mirrored(anchor.at);
          chain.anchors.push_back({at, image, parts[image].carried(chain.end, at)});
        }
    }
}

void set_root(Unmatched_chain& chain)
{
  Point sum = Point::Zero();
  contacts::Box held;
  for (const Anchor& anchor : chain.anchors) {
    sum += anchor.at;
    held.extend(anchor.at);
  }
  if (chain.anchors.empty()) {
    chain.root = Point(chain.box.center().x(), chain.box.min().y(), chain.box.center().z());
    return;
  }
  chain.root = sum / double(chain.anchors.size());
  // What is held at several ends, as a rod between two parts, becomes thin; what is held at all of them as small
  constexpr double apart = 0.5; // of the extent
  for (int axis = 0; axis < 3; ++axis)
    chain.is_held[std::size_t(axis)] = held.sizes()[axis] > apart * chain.box.sizes()[axis];
  if (chain.is_held == std::array{true, true, true}) chain.is_held = {};
}

} // namespace

Points Unmatched_chain::shrunk(const Points& points, double remaining) const
{
  constexpr double little = 0.1;
  if (remaining >= 1) return points;
  const auto factor = [&](std::size_t axis) { return is_held[axis] ? std::min(1., remaining / little) : remaining; };
  const Point factors(factor(0), factor(1), factor(2));
  return (factors.asDiagonal() * (points.colwise() - root)).colwise() + root;
}

std::vector<Unmatched_chain> add_unmatched_parts(const Blend_stage& stage, const Part_pairs& unlike,
                                                 std::vector<Blend_part>& parts)
{
  const std::size_t matched = parts.size();
  std::vector<Unmatched_chain> result;
  Change_groups groups(stage, unlike);
  for (int end : {0, 1}) {
    const Chain_finder finder(stage, end, parts);
    for (const auto& [number, given] : finder.chains()) {
      Unmatched_chain chain{end, {}, finder.anchors(number), {}, {}};
      const bool is_unlike = std::any_of(unlike.begin(), unlike.end(), [&, given = given](const auto& pair) {
        return std::binary_search(given.begin(), given.end(), end == 0 ? pair.first : pair.second);
      });
      for (std::size_t part : given) {
        chain.parts.push_back(parts.size());
        parts.push_back(unmatched_part(stage, end, part, is_unlike));
        chain.box.extend(parts.back().trees[0].box());
      }
      groups.add(end, given, chain.stands(), finder.joins(number));
      result.push_back(std::move(chain));
    }
  }
  groups.find();
  for (std::size_t i = matched; i < parts.size(); ++i) {
    const int end = parts[i].end();
    parts[i].group = groups(parts[i]);
    const std::size_t image = stage.images[std::size_t(end)][parts[i].given()];
    if (image == Mirror_images::none) continue;
    const std::size_t made = parts_of(parts, end, image).at(0);
    if (!parts[made].morph) parts[i].image = made;
  }
  mirror_anchors(parts, result);
  for (Unmatched_chain& chain : result)
    set_root(chain);
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
