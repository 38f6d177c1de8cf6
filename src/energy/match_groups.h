// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/quantized.h"
#include "structure/align_shapes.h"

#include <CGAL/Shape_correspondence/Energy_options.h>
#include <CGAL/Shape_correspondence/Geotopo_operation.h>

#include <array>
#include <cstddef>
#include <set>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// Index in an aligned shape of a part of its structural graph; the shape's number of parts if it lacks that part.
std::size_t place_of(const Aligned_shape& shape, std::size_t part);

/// The parts of two aligned shapes that may and that must correspond, by `Energy_options::pinned` and `forbidden`.
class Match_constraints
{
public:
  Match_constraints() = default;

  /// Reads `options`. \throw Invalid_input if a pinned part is not in its aligned shape, or a pinned pair is forbidden
  Match_constraints(const Aligned_shape& source, const Aligned_shape& target, const Energy_options& options);

  bool empty() const { return pinned_.empty(); }

  bool allows(std::size_t source, std::size_t target) const { return empty() || allowed_[source][target]; }

  /// The target parts that a source part is pinned to, ascending.
  const std::set<std::size_t>& pinned(std::size_t source) const { return pinned_[source]; }

private:
  std::vector<std::set<std::size_t>> pinned_; // indexed by source part
  std::vector<std::vector<char>> allowed_;    // indexed by source part and target part
};

/// The connected components of the graph of pinned pairs, whose indices of parts they keep.
struct Pinned_sets
{
  std::vector<std::vector<std::size_t>> source, target;
};

Pinned_sets pinned_sets(const std::vector<Part_pair>& pins);

/// The options with source and target exchanged, for deforming the target into the source.
Energy_options reversed(Energy_options options);

} // namespace CGAL::Shape_correspondence::internal

namespace CGAL::Shape_correspondence {

namespace internal {

/// Maps points to the unit box of a group. An axis along which the group is flat maps to 0.5.
class Unit_box
{
public:
  explicit Unit_box(const Eigen::AlignedBox3d& box)
  {
    constexpr double least_extent = 0.02; // ratio to the shape's height; smaller extents count as flat
    for (int axis = 0; axis < 3; ++axis) {
      const double extent = box.sizes()[axis];
      const bool is_flat = extent < least_extent;
      scale_[axis] = is_flat ? 0 : 1 / extent;
      origin_[axis] = is_flat ? 0.5 : -box.min()[axis] / extent;
    }
  }

  Point operator()(const Point& p) const { return origin_ + scale_.cwiseProduct(p); }

private:
  Point scale_, origin_;
};

inline double quantized_distance(const Point& a, const Point& b) { return double(quantized((a - b).norm())); }

} // namespace internal

/// A piece of a part: the whole, one of `count` equally long segments of a curve, or a rectangle of a sheet.
struct Piece
{
  std::size_t part = 0;
  int index = 0, count = 1;
  std::array<double, 2> low{0, 0}, high{1, 1}; ///< corners of the rectangle in the sheet's parameters

  bool is_segment() const { return count > 1; }
  bool is_rectangle() const { return low[0] > 0 || low[1] > 0 || high[0] < 1 || high[1] < 1; }
  bool is_whole() const { return !is_segment() && !is_rectangle(); }

  friend bool operator==(const Piece& a, const Piece& b)
  {
    return a.part == b.part && a.index == b.index && a.count == b.count && a.low == b.low && a.high == b.high;
  }
};

/// Whether two pieces have more than a boundary in common.
bool overlap(const Piece& a, const Piece& b);

/// A piece of a source part and the target piece that it turns into.
struct Piece_image
{
  Piece source, target;
};

/// A candidate image of a source group: a target group, the operation, and the images of the members.
struct Group_label
{
  static constexpr std::size_t no_group = std::size_t(-1);

  std::size_t target_group = no_group; ///< `no_group`: the group is left unmatched
  Operation operation = Operation::NONE;
  std::vector<std::vector<Piece_image>> images; ///< indexed by member of the source group; empty if it is unmatched
  double solidity_ratio = 1;                    ///< S_i of Eq. 5, see `split_energy()`
};

/// The operation by the numbers of parts of two groups: match, split, duplicate or merge.
Operation topological_operation(std::size_t source_size, std::size_t target_size);

/// S_i of Eq. 5; 1 between groups of equal size, whose parts correspond one to one, and if one of them is rotational.
double solidity_ratio(const Part_group& source, const Part_group& target);

/// Whether a search may match two groups (paper, section 5): a group with a group or with a single self-symmetric part,
/// and a single part with anything.
bool may_match(const Part_group& source, const Part_group& target);

/// Group matching (paper, section 5): the members of a source and a target group, by their centroids in the groups'
/// unit boxes, are matched one to one by optimal assignment as far as their numbers allow; every remaining member goes
/// to the nearest one of the other group. Sheets that split or merge are divided (`divide_sheets()`). Pairs that the
/// constraints forbid are avoided where possible, see `is_allowed()`.
Group_label match_groups(const Aligned_shape& source, std::size_t source_group, const Aligned_shape& target,
                         std::size_t target_group, const internal::Match_constraints& constraints = {});

// The target parts of a label, ascending.
std::vector<std::size_t> image_parts(const Group_label& label);

bool is_allowed(const Group_label& label, const internal::Match_constraints& constraints);

/// The label of a group of pinned parts. \pre the group is one of `internal::pinned_sets()`
Group_label pinned_label(const Aligned_shape& source, std::size_t source_group, const Aligned_shape& target,
                         const internal::Match_constraints& constraints);

} // namespace CGAL::Shape_correspondence
