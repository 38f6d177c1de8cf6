// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/Disjoint_sets.h"
#include "base/Nearest_points.h"
#include "base/directions.h"
#include "base/limits.h"
#include "structure/Symmetry_candidate.h"
#include "structure/reflections_and_rings.h"

#include <CGAL/Shape_correspondence/abstract_part.h>
#include <CGAL/Shape_correspondence/detect_symmetry_groups.h>

#include <list>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

namespace CGAL::Shape_correspondence {
using namespace internal;
using namespace internal::symmetry;

namespace {

constexpr double uneven_spacing = 0.3; ///< largest deviation of a step of a row from the mean step, over the mean
constexpr double crookedness = 0.1; ///< greatest distance of a member from the row's line, over the length of the row

/// Parts of which each is a translated copy of another one, and the tree of their centres.
struct Copies
{
  std::vector<std::size_t> members;
  Nearest_points centres;

  Copies(const Part_relations& parts, std::vector<std::size_t> of)
      : members(std::move(of)), centres(centres_of(parts, members))
  {}

private:
  static Points centres_of(const Part_relations& parts, const std::vector<std::size_t>& members)
  {
    Points result(3, members.size());
    for (std::size_t i = 0; i < members.size(); ++i)
      result.col(Eigen::Index(i)) = parts[members[i]].centre;
    return result;
  }
};

/// The sets of three or more translated copies among the parts `free`.
std::list<Copies> translated_copies(const Part_relations& parts, const std::vector<std::size_t>& free)
{
  Disjoint_sets sets(parts.size());
  for (std::size_t i : free)
    for (std::size_t j : free)
      if (j > i && parts.related(i, j, TRANSLATED)) sets.unite(i, j);
  std::map<std::size_t, std::vector<std::size_t>> members;
  for (std::size_t i : free)
    members[sets[i]].push_back(i);
  std::list<Copies> result; // trees are not movable
  for (auto& [set, of_set] : members)
    if (of_set.size() >= 3) result.emplace_back(parts, std::move(of_set));
  return result;
}

/// The copy nearest to the next place in a row, if it is near enough.
std::optional<std::size_t> next_in_row(const Part_relations& parts, std::size_t last, const Point& step,
                                       const Copies& copies)
{
  const Point place = parts[last].centre + step;
  const double largest = uneven_spacing * step.norm();
  const Eigen::Index nearest = copies.centres.nearest_within(place, largest);
  if (nearest < 0) return std::nullopt;
  if (const std::size_t k = copies.members[std::size_t(nearest)]; parts.related(last, k, TRANSLATED)) return k;
  std::optional<std::size_t> best; // the nearest of those related to `last` directly, not only by way of others
  double least = largest;
  for (std::size_t k : copies.members) {
    const double distance = (parts[k].centre - place).norm();
    if (distance >= least || !parts.related(last, k, TRANSLATED)) continue;
    least = distance;
    best = k;
  }
  return best;
}

bool is_even_and_straight(const Part_relations& parts, const std::vector<std::size_t>& row, const Point& step)
{
  const double gap = step.norm();
  const Point direction = step / gap;
  for (std::size_t i = 0; i + 1 < row.size(); ++i) {
    const double along = (parts[row[i + 1]].centre - parts[row[i]].centre).dot(direction);
    if (std::abs(along - gap) > uneven_spacing * gap) return false;
  }
  for (std::size_t member : row) {
    const Point d = parts[member].centre - parts[row.front()].centre;
    const double off = (d - d.dot(direction) * direction).norm();
    if (off > std::max(crookedness * gap * (double(row.size()) - 1), parts.position_tolerance(member))) return false;
  }
  return true;
}

/// The row that starts with two given parts, continued as long as there is a next member.
std::vector<std::size_t> follow_row(const Part_relations& parts, std::size_t first, std::size_t second,
                                    const Copies& copies)
{
  std::vector<std::size_t> row = {first, second};
  while (true) {
    const Point mean_step = (parts[row.back()].centre - parts[first].centre) / (double(row.size()) - 1);
    const auto next = next_in_row(parts, row.back(), mean_step, copies);
    if (!next || std::find(row.begin(), row.end(), *next) != row.end()) return row;
    row.push_back(*next);
  }
}

/// Adds rows of three or more parts: a translation maps each to the next. O(n² log n) for n copies in
/// rows that are far apart.
void add_rows(const Part_relations& parts, const Copies& copies, Largest_candidates& result)
{
  std::set<std::vector<std::size_t>> seen;
  for (std::size_t i : copies.members)
    for (std::size_t j : copies.members) {
      if (i == j || !parts.related(i, j, TRANSLATED)) continue;
      const Point first_step = parts[j].centre - parts[i].centre;
      if (first_step.norm() <= least_position_tolerance || is_backward(first_step)) continue;
      Symmetry_candidate row;
      row.members = follow_row(parts, i, j, copies);
      if (row.members.size() < 3 || !result.takes(row.members.size()) || !seen.insert(row.members).second) continue;
      const Point step =
          (parts[row.members.back()].centre - parts[row.members.front()].centre) / (double(row.members.size()) - 1);
      if (!is_even_and_straight(parts, row.members, step)) continue;
      row.preference = Preference::ROW;
      row.symmetry.type = Symmetry_type::TRANSLATION;
      row.symmetry.point = parts[row.members.front()].centre;
      row.symmetry.direction = step;
      row.cost = rounded(step.norm());
      for (std::size_t k = 0; k + 1 < row.members.size(); ++k)
        row.links.push_back({k, k + 1, matrix_of(TRANSLATED), true});
      result.add(std::move(row));
    }
}

/// Takes the best candidates one after the other until every part is in a group.
class Group_finder
{
public:
  Group_finder(Part_relations& parts, const Symmetry_options& options) : parts_(parts), options_(options)
  {
    free_.resize(parts.size());
    std::iota(free_.begin(), free_.end(), 0);
  }

  std::vector<Symmetry_candidate> operator()()
  {
    take_while_found([this] { add_sets(); });
    take_while_found([this] { add_pairs(); });
    for (std::size_t part : free_) {
      Symmetry_candidate single;
      single.members = {part};
      single.symmetry = self_symmetry(parts_, part);
      groups_.push_back(single);
    }
    return std::move(groups_);
  }

  bool are_all_rows_found() const { return row_beginnings_ <= most_row_beginnings; }

private:
  void add_sets()
  {
    if (options_.rotation) add_rings(parts_, free_, found_);
    if (options_.reflection) add_orbits_of_four(parts_, free_, found_);
    if (!options_.translation) return;
    for (const Copies& copies : translated_copies(parts_, free_)) {
      row_beginnings_ += copies.members.size() * copies.members.size();
      if (are_all_rows_found()) add_rows(parts_, copies, found_);
    }
  }

  void add_pairs()
  {
    if (!options_.reflection && !options_.rotation && !options_.translation) return;
    for (std::size_t i : free_)
      for (std::size_t j : free_) {
        if (j <= i || parts_.are_at_different_ends(i, j)) continue;
        for (const Basic_map map : {MIRRORED_X, MIRRORED_Z}) {
          if (options_.reflection) add_pair_in_plane(parts_, i, j, map, found_);
          if (options_.rotation) add_turned_pair(parts_, i, j, map, found_);
        }
        if (options_.translation) add_translated_pair(parts_, i, j, found_);
        if (options_.reflection) add_pair_mirrored_anyhow(parts_, i, j, found_);
      }
  }

  bool is_free(const Symmetry_candidate& candidate) const
  {
    return std::all_of(candidate.members.begin(), candidate.members.end(),
                       [this](std::size_t i) { return std::binary_search(free_.begin(), free_.end(), i); });
  }

  void take(Symmetry_candidate candidate)
  {
    candidate.symmetry.residual = link_residual(parts_, candidate);
    for (std::size_t member : candidate.members)
      free_.erase(std::lower_bound(free_.begin(), free_.end(), member));
    groups_.push_back(std::move(candidate));
  }

  /// Collects candidates among the free parts and takes the best, until there are none. Candidates are collected anew
  /// after the largest ones of a round, since a row that lost members to a better group may leave a shorter row.
  template <typename Collect>
  void take_while_found(const Collect& collect)
  {
    while (true) {
      collect();
      std::vector<Symmetry_candidate> largest = found_.take_out();
      if (largest.empty()) return;
      for (Symmetry_candidate& candidate : largest) {
        if (!is_free(candidate)) continue;
        if (confirm(parts_, candidate))
          take(std::move(candidate));
        else
          found_.reject(candidate);
      }
    }
  }

  Part_relations& parts_;
  Symmetry_options options_;
  std::vector<std::size_t> free_; ///< ascending
  std::vector<Symmetry_candidate> groups_;
  Largest_candidates found_;
  std::size_t row_beginnings_ = 0; ///< number of pairs of copies from which rows were followed
};

/// An order of the parts that does not depend on the file: by rounded position of the centre along a direction, size
/// and, for parts that cross each other, support function.
std::vector<std::size_t> canonical_order(const std::vector<Part_signature>& signatures)
{
  constexpr double quantum = 1e-5;
  const auto key = [&](std::size_t i) {
    const Part_signature& s = signatures[i];
    std::vector<double> result = {generic_direction().dot(s.centre), s.width, s.diagonal};
    result.insert(result.end(), s.support.begin(), s.support.end());
    for (double& x : result)
      x = std::round(x / quantum);
    return result;
  };
  std::vector<std::vector<double>> keys;
  for (std::size_t i = 0; i < signatures.size(); ++i)
    keys.push_back(key(i));
  std::vector<std::size_t> order(signatures.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
  return order;
}

Symmetry to_world(Symmetry symmetry, const Shape_frame& frame)
{
  symmetry.point = frame.to_world(symmetry.point);
  symmetry.direction = frame.axes * symmetry.direction;
  if (symmetry.type == Symmetry_type::TRANSLATION) symmetry.direction *= frame.height;
  return symmetry;
}

double hull_volume_of_union(const std::vector<Part_abstraction>& parts, const std::vector<std::size_t>& members)
{
  if (members.size() == 1 && parts[members[0]].hull_volume > 0) return parts[members[0]].hull_volume;
  Points all(3, 0);
  for (std::size_t member : members) {
    const Part_abstraction& part = parts[member];
    const Points& points = part.hull.cols() > 0 ? part.hull : part.control_points();
    const Eigen::Index before = all.cols();
    all.conservativeResize(3, before + points.cols());
    all.rightCols(points.cols()) = points;
  }
  return convex_hull_volume(all);
}

Part_group make_group(const std::vector<Part_abstraction>& parts, std::vector<std::size_t> members,
                      const Symmetry& symmetry)
{
  Part_group group;
  group.parts = std::move(members);
  group.symmetry = symmetry;
  for (std::size_t member : group.parts)
    group.volume += parts[member].volume;
  group.hull_volume = hull_volume_of_union(parts, group.parts);
  return group;
}

void sort_by_first_part(std::vector<Part_group>& groups)
{
  const auto first = [](const Part_group& group) { return *std::min_element(group.parts.begin(), group.parts.end()); };
  std::sort(groups.begin(), groups.end(),
            [&](const Part_group& a, const Part_group& b) { return first(a) < first(b); });
}

} // namespace

std::vector<Part_group> detect_symmetry_groups(const std::vector<Part_abstraction>& parts, const Shape_frame& frame,
                                               const Symmetry_options& options, std::vector<std::string>* warnings)
{
  std::vector<Part_signature> signatures;
  for (const Part_abstraction& part : parts)
    signatures.push_back(make_signature(part, frame));
  const std::vector<std::size_t> order = canonical_order(signatures);
  std::vector<Part_signature> sorted;
  for (std::size_t part : order)
    sorted.push_back(std::move(signatures[part]));
  Symmetry_options kinds = options;
  if (!options.enabled) kinds.reflection = kinds.rotation = kinds.translation = false;

  Part_relations relations(std::move(sorted), frame, options.tolerance);
  Group_finder finder(relations, kinds);
  std::vector<Part_group> groups;
  for (Symmetry_candidate& candidate : finder()) {
    for (std::size_t& member : candidate.members)
      member = order[member];
    groups.push_back(make_group(parts, std::move(candidate.members), to_world(candidate.symmetry, frame)));
  }
  sort_by_first_part(groups);
  if (!finder.are_all_rows_found() && warnings)
    warnings->push_back("So many of the " + std::to_string(parts.size()) +
                        " parts are alike that not all rows of them were looked for; the longest ones are groups.");
  return groups;
}

} // namespace CGAL::Shape_correspondence
