// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/change_groups.h"

#include "base/Disjoint_sets.h"
#include "blend/Blend_stage.h"
#include "blend/unlike_pairs.h"

#include <array>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// Unites an unmatched part with the unmatched ones of the other end that are in the same place, and with the matched
/// ones that it is inside of at either end.
void unite_in_place(const Blend_stage& stage, const std::vector<Blend_part>& parts, std::size_t part,
                    Disjoint_sets& sets)
{
  constexpr double inside = 0.8; // of its own place: with less it is beside a matched part
  const int end = parts[part].end();
  const std::size_t given = parts[part].given(end);
  const auto is_inside = [&](const Blend_part& other, int at_end) {
    return shared_place(stage, {std::size_t(end), given}, {std::size_t(at_end), other.given(at_end)}) > inside;
  };
  const auto is_in_place = [&](const Blend_part& other) {
    if (other.is_matched()) return is_inside(other, 0) || is_inside(other, 1);
    const std::size_t there = other.given(1 - end);
    return (end == 0 ? shared_place(stage, given, there) : shared_place(stage, there, given)) > same_place;
  };
  for (std::size_t other = 0; other < parts.size(); ++other)
    if (parts[other].is_at(1 - end) && is_in_place(parts[other])) sets.unite(part, other);
}

/// The set of each number.
std::vector<std::size_t> numbers(const Disjoint_sets& sets)
{
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < sets.size(); ++i)
    result.push_back(sets[i]);
  return result;
}

} // namespace

std::vector<std::size_t> change_groups(const Blend_stage& stage, const Part_pairs& unlike,
                                       const std::vector<Blend_part>& parts, const std::vector<Touch>& touches)
{
  Disjoint_sets sets(parts.size());
  const auto part_of = [&](int end, std::size_t given) { return parts_of(parts, end, given).front(); };
  for (const auto& [s, t] : unlike)
    sets.unite(part_of(0, s), part_of(1, t));
  std::size_t standing = Blend_task::no_part; // the first part that stands
  for (std::size_t part = 0; part < parts.size(); ++part) {
    if (parts[part].is_matched()) continue;
    const int end = parts[part].end();
    if (const auto image = stage.images[std::size_t(end)][parts[part].given(end)])
      sets.unite(part, part_of(end, *image));
    if (parts[part].end_tree(end).box().min().y() <= Blend_part::on_ground) {
      if (standing == Blend_task::no_part) standing = part;
      sets.unite(part, standing);
    }
    unite_in_place(stage, parts, part, sets);
  }
  const std::vector<std::size_t> groups = numbers(sets);
  std::vector<std::array<bool, 2>> is_at(parts.size(), {false, false}); // by group and end
  for (std::size_t part = 0; part < parts.size(); ++part)
    for (int end : {0, 1})
      is_at[groups[part]][std::size_t(end)] |= parts[part].is_at(end);
  const auto takes_a_place = [&](std::size_t part) { return is_at[groups[part]][0] && is_at[groups[part]][1]; };
  for (const auto& [pair, gaps] : touches)
    if (!takes_a_place(pair[0]) && !takes_a_place(pair[1])) sets.unite(pair[0], pair[1]);
  return numbers(sets);
}

} // namespace CGAL::Shape_correspondence::internal
