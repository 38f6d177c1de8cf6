// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_ENERGY_GEOTOPO_TRANSFORM_H
#define CGAL_SHAPE_CORRESPONDENCE_ENERGY_GEOTOPO_TRANSFORM_H

#include "structure/align_shapes.h"

#include <CGAL/Shape_correspondence/Geotopo_operation.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {

/// A piece of a part: the whole, or one of `count` equally long segments of a curve.
struct Piece
{
  std::size_t part = 0;
  int index = 0, count = 1;

  friend bool operator==(const Piece& a, const Piece& b)
  {
    return a.part == b.part && a.index == b.index && a.count == b.count;
  }
};

/// What a piece of a source part turns into.
struct Image
{
  Piece source, target;
};

/// What a source group becomes: a target group, the operation, and what each member turns into.
struct Group_label
{
  static constexpr std::size_t no_group = std::size_t(-1);

  std::size_t target_group = no_group; ///< `no_group` leaves the group unmatched
  Operation operation = Operation::NONE;
  std::vector<std::vector<Image>> images; ///< by member of the source group; at least one each, or none at all
  double solidity_ratio = 1;              ///< S_i of Eq. 5
};

/// How the samples of `source` are run through when it takes the shape of `target`: sample i goes to sample [i] of the
/// target. Centres are aligned, then extremities are matched by proximity (paper, section 5, "Deform-to-fit"): of the 2
/// directions of a curve, the 8 layouts of a sheet and the 2 e of a closed curve the one whose ends, corners or samples
/// have the least sum of squared distances. Where one part is a sheet, the curve counts as a sheet of e equal columns.
const std::vector<int>& fitting_order(const Sampled_part& source, const Sampled_part& target);

/// Deform-to-fit: the samples of `source` after it took the shape of `target`, in `fitting_order()`. Where one part is
/// a sheet, e × e samples (compare with `lifted_samples()`).
Points deform_to_fit(const Sampled_part& source, const Sampled_part& target);

/// What becomes of a group of so many parts that turns into a group of so many: match, split, duplicate or merge.
Operation topological_operation(std::size_t source_size, std::size_t target_size);

/// S_i of Eq. 5: 1 between single parts and where one side is a rotational group.
double solidity_ratio(const Aligned_shape::Group& source, const Aligned_shape::Group& target);

/// Matches the members of two groups (paper, section 5): centroids in the groups' unit boxes, matched one to one by
/// optimal assignment as far as numbers allow; every member left over goes to the nearest one of the other side. So no
/// target part stays free while another is taken twice without need.
Group_label match_members(const Aligned_shape& source, std::size_t source_group, const Aligned_shape& target,
                          std::size_t target_group);

/// The same with curves cut (paper, section 5): a source curve that turns into several curves is cut into as many
/// equally long segments, each of which turns into one (`Operation::CUT`); several curves that turn into one become its
/// segments (`Operation::JOIN`). Segments and curves are matched by their places in the groups' unit boxes, and the
/// curves must lie in a row. The label itself where there is nothing to cut.
Group_label cut_members(const Aligned_shape& source, std::size_t source_group, const Aligned_shape& target,
                        const Group_label& label);

/// Structure preservation (paper, section 5): how far the parts of unmatched groups move. A part follows the points
/// where it touches others, breadth-first from the matched ones; the members of a group follow their representative,
/// the one that touches most, by the group's generator. Then every unmatched group is placed anew by all that it
/// touches, until no part moves by more than `tolerance`.
class Propagation
{
public:
  static constexpr double tolerance = 1e-3; ///< of the shape's height
  static constexpr int maximum_sweeps = 20;

  explicit Propagation(const Aligned_shape& shape);

  /// Moves the parts of unmatched groups; makes no allocation.
  /// \param matched by group
  /// \param contact_displacement by contact, the movement of the contact point on the first and on the second part
  /// where that part is matched
  /// \param displacement a column a part; those of matched parts are left alone
  void operator()(const std::vector<char>& matched, const std::vector<std::array<Point, 2>>& contact_displacement,
                  Points& displacement);

private:
  struct Touch
  {
    std::size_t contact, part, other;
    int other_side;
  };

  double place(std::size_t group, const std::vector<char>& matched,
               const std::vector<std::array<Point, 2>>& contact_displacement, Points& displacement);

  const Aligned_shape& shape_;
  std::vector<std::vector<Touch>> touches_; // by group, to parts of other groups, those of a part together
  std::vector<char> placed_;
  std::vector<std::size_t> order_; // unmatched groups that something matched reaches, breadth-first
};

} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_ENERGY_GEOTOPO_TRANSFORM_H
