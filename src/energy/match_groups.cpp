// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "energy/match_groups.h"
#include "base/Disjoint_sets.h"
#include "base/optimal_assignment.h"
#include "energy/cut_parts.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

std::size_t place_of(const Aligned_shape& shape, std::size_t part)
{
  return std::size_t(std::find(shape.original.begin(), shape.original.end(), part) - shape.original.begin());
}

namespace {

std::string name_of(const Part_pair& pair)
{
  return "part number " + std::to_string(pair.source) + " of the source and number " + std::to_string(pair.target) +
         " of the target";
}

// The columns assigned to each row: an optimal one-to-one assignment; each remaining column goes to its nearest row.
std::vector<std::vector<std::size_t>> assign_members(const Eigen::MatrixXd& cost)
{
  std::vector<std::vector<std::size_t>> cols_of(cost.rows());
  std::vector<char> taken(cost.cols(), 0);
  const std::vector<std::size_t> first = optimal_assignment(cost);
  for (std::size_t row = 0; row < first.size(); ++row) {
    cols_of[row].push_back(first[row]);
    taken[first[row]] = 1;
  }
  for (Eigen::Index col = 0; col < cost.cols(); ++col) {
    if (taken[col]) continue;
    Eigen::Index nearest;
    cost.col(col).minCoeff(&nearest);
    cols_of[nearest].push_back(std::size_t(col));
  }
  for (auto& cols : cols_of)
    std::sort(cols.begin(), cols.end());
  return cols_of;
}

// Number added to the distance of parts that must not correspond; greater than any distance in unit boxes.
constexpr double forbidden_distance = 1e3;

Group_label match_members(const Aligned_shape& source, std::size_t source_group, const Aligned_shape& target,
                          std::size_t target_group, const Match_constraints& constraints)
{
  const auto& from = source.group(source_group).parts;
  const auto& to = target.group(target_group).parts;
  Group_label label;
  label.target_group = target_group;
  label.operation = topological_operation(from.size(), to.size());
  label.solidity_ratio = solidity_ratio(source.group(source_group), target.group(target_group));
  label.images.resize(from.size());
  if (from.size() == 1 || to.size() == 1) {
    for (std::size_t i = 0; i < from.size(); ++i)
      for (std::size_t part : to)
        label.images[i].push_back({{from[i]}, {part}});
    return label;
  }

  const Unit_box from_box(source.boxes[source_group]), to_box(target.boxes[target_group]);
  Eigen::MatrixXd cost(from.size(), to.size());
  for (Eigen::Index i = 0; i < cost.rows(); ++i)
    for (Eigen::Index j = 0; j < cost.cols(); ++j) {
      const std::size_t a = from[std::size_t(i)], b = to[std::size_t(j)];
      cost(i, j) = quantized_distance(from_box(source.parts[a].centroid), to_box(target.parts[b].centroid)) +
                   (constraints.allows(a, b) ? 0 : forbidden_distance);
    }
  const bool has_more = from.size() > to.size();
  if (has_more) cost.transposeInPlace();
  const auto assigned = assign_members(cost);
  for (std::size_t row = 0; row < assigned.size(); ++row)
    for (std::size_t column : assigned[row]) {
      const std::size_t i = has_more ? column : row, j = has_more ? row : column;
      label.images[i].push_back({{from[i]}, {to[j]}});
    }
  return label;
}

} // namespace

Match_constraints::Match_constraints(const Aligned_shape& source, const Aligned_shape& target,
                                     const Energy_options& options)
{
  if (options.pinned.empty() && options.forbidden.empty()) return;
  const std::size_t n = source.parts.size(), m = target.parts.size();
  pinned_.resize(n);
  allowed_.assign(n, std::vector<char>(m, 1));
  std::vector<char> is_pinned_target(m, 0);
  for (const Part_pair& pair : options.pinned) {
    const std::size_t i = place_of(source, pair.source), j = place_of(target, pair.target);
    if (i == n || j == m)
      throw Invalid_input(
          "find_correspondence: " + name_of(pair) +
          " are pinned, but not both of them take part in the match; let both take part, or do not pin them");
    pinned_[i].insert(j);
    is_pinned_target[j] = 1;
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < m; ++j)
      if (!pinned_[i].empty() || is_pinned_target[j]) allowed_[i][j] = 0;
    for (std::size_t j : pinned_[i])
      allowed_[i][j] = 1;
  }
  for (const Part_pair& pair : options.forbidden) {
    const std::size_t i = place_of(source, pair.source), j = place_of(target, pair.target);
    if (i == n || j == m) continue; // the part is not in the aligned shape
    if (pinned_[i].count(j) > 0)
      throw Invalid_input("find_correspondence: " + name_of(pair) + " are pinned and forbidden; choose one of the two");
    allowed_[i][j] = 0;
  }
}

Pinned_sets pinned_sets(const std::vector<Part_pair>& pins)
{
  // Maps the indices of pinned parts, unchecked so far, to consecutive numbers
  std::map<std::size_t, std::size_t> sources, targets;
  for (const Part_pair& pin : pins)
    sources[pin.source], targets[pin.target];
  std::size_t place = 0;
  for (auto* places : {&sources, &targets})
    for (auto& part : *places)
      part.second = place++;
  Disjoint_sets joined(place);
  for (const Part_pair& pin : pins)
    joined.unite(sources[pin.source], targets[pin.target]);
  std::map<std::size_t, std::array<std::set<std::size_t>, 2>> sets;
  for (const Part_pair& pin : pins) {
    auto& [source, target] = sets[joined[sources[pin.source]]];
    source.insert(pin.source);
    target.insert(pin.target);
  }
  Pinned_sets result;
  for (const auto& [name, parts] : sets) {
    result.source.emplace_back(parts[0].begin(), parts[0].end());
    result.target.emplace_back(parts[1].begin(), parts[1].end());
  }
  return result;
}

Energy_options reversed(Energy_options options)
{
  for (auto* pairs : {&options.pinned, &options.forbidden})
    for (Part_pair& pair : *pairs)
      std::swap(pair.source, pair.target);
  options.role_costs.transposeInPlace();
  return options;
}

} // namespace CGAL::Shape_correspondence::internal

namespace CGAL::Shape_correspondence {
using namespace internal;

bool overlap(const Piece& a, const Piece& b)
{
  if (a.part != b.part) return false;
  const auto meet = [](double low, double high, double other_low, double other_high) {
    return low < other_high && other_low < high;
  };
  // Compares segments of curves, then rectangles of sheets; a whole part covers both
  return meet(a.index * b.count, (a.index + 1) * b.count, b.index * a.count, (b.index + 1) * a.count) &&
         meet(a.low[0], a.high[0], b.low[0], b.high[0]) && meet(a.low[1], a.high[1], b.low[1], b.high[1]);
}

Operation topological_operation(std::size_t source_size, std::size_t target_size)
{
  if (source_size == target_size) return Operation::MATCH;
  if (source_size > target_size) return Operation::MERGE;
  return source_size == 1 ? Operation::SPLIT : Operation::DUPLICATE;
}

double solidity_ratio(const Part_group& source, const Part_group& target)
{
  const bool one_to_one = source.parts.size() == target.parts.size();
  const bool rotational =
      source.symmetry.type == Symmetry_type::ROTATION || target.symmetry.type == Symmetry_type::ROTATION;
  if (one_to_one || rotational) return 1;
  const double before = solidity(source.volume, source.hull_volume);
  const double after = solidity(target.volume, target.hull_volume);
  return std::min(before, after) / std::max(before, after);
}

bool may_match(const Part_group& source, const Part_group& target)
{
  return source.parts.size() == 1 || target.parts.size() > 1 || target.symmetry.type == Symmetry_type::SELF;
}

Group_label match_groups(const Aligned_shape& source, std::size_t source_group, const Aligned_shape& target,
                         std::size_t target_group, const Match_constraints& constraints)
{
  Group_label label = match_members(source, source_group, target, target_group, constraints);
  divide_sheets(source, target, label);
  return label;
}

std::vector<std::size_t> image_parts(const Group_label& label)
{
  std::vector<std::size_t> parts;
  for (const auto& images : label.images)
    for (const Piece_image& image : images)
      if (parts.empty() || parts.back() != image.target.part) parts.push_back(image.target.part);
  std::sort(parts.begin(), parts.end());
  parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
  return parts;
}

bool is_allowed(const Group_label& label, const Match_constraints& constraints)
{
  for (const std::vector<Piece_image>& images : label.images)
    for (const Piece_image& image : images)
      if (!constraints.allows(image.source.part, image.target.part)) return false;
  return true;
}

Group_label pinned_label(const Aligned_shape& source, std::size_t source_group, const Aligned_shape& target,
                         const Match_constraints& constraints)
{
  Group_label label;
  for (std::size_t part : source.group(source_group).parts) {
    label.images.emplace_back();
    for (std::size_t image : constraints.pinned(part))
      label.images.back().push_back({{part}, {image}});
  }
  label.target_group = target.group_of[label.images[0][0].target.part];
  label.operation = topological_operation(label.images.size(), target.group(label.target_group).parts.size());
  divide_sheets(source, target, label);
  return label;
}

} // namespace CGAL::Shape_correspondence
