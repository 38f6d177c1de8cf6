// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/Disjoint_sets.h"
#include "base/Nearest_points.h"
#include "structure/Symmetry_candidate.h"

#include <list>
#include <map>
#include <optional>
#include <set>

namespace CGAL::Shape_correspondence::internal {
namespace symmetry {

constexpr double uneven_spacing = 0.3; ///< deviation of a step of a row from the mean step, over the mean
constexpr double crookedness = 0.1;    ///< distance of a member from the row's line, over the length of the row

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

/// The parts of `free` by what they are copies of, where there are three or more.
inline std::list<Copies> translated_copies(const Part_relations& parts, const std::vector<std::size_t>& free)
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
inline std::optional<std::size_t> next_in_row(const Part_relations& parts, std::size_t last, const Point& step,
                                              const Copies& copies)
{
  const Point place = parts[last].centre + step;
  const double largest = uneven_spacing * step.norm();
  const Eigen::Index nearest = copies.centres.nearest_within(place, largest);
  if (nearest < 0) return std::nullopt;
  if (const std::size_t k = copies.members[std::size_t(nearest)]; parts.related(last, k, TRANSLATED)) return k;
  std::optional<std::size_t> best; // of copies that are alike by others only
  double least = largest;
  for (std::size_t k : copies.members) {
    const double distance = (parts[k].centre - place).norm();
    if (distance >= least || !parts.related(last, k, TRANSLATED)) continue;
    least = distance;
    best = k;
  }
  return best;
}

inline bool is_even_and_straight(const Part_relations& parts, const std::vector<std::size_t>& row, const Point& step)
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
inline std::vector<std::size_t> follow_row(const Part_relations& parts, std::size_t first, std::size_t second,
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

/// Adds rows of three or more parts, each of which a translation carries into the next. O(n² log n) for n copies in
/// rows that are far apart.
inline void add_rows(const Part_relations& parts, const Copies& copies, Largest_candidates& result)
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

} // namespace symmetry
} // namespace CGAL::Shape_correspondence::internal
