// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_GEOTOPO_TRANSFORM_H
#define CGAL_SHAPE_CORRESPONDENCE_GEOTOPO_TRANSFORM_H

#include <CGAL/Shape_correspondence/Correspondence.h>
#include <CGAL/Shape_correspondence/align_shapes.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {

/// What a source group becomes: a target group, the operation, and the target parts that each member turns into.
struct Group_label
{
  std::size_t target_group;
  Operation operation;
  std::vector<std::vector<std::size_t>> images; ///< by member of the source group; ascending, at least one each
  double solidity_ratio = 1;                    ///< S_i of Eq. 5
};

/// Deform-to-fit (paper, section 5): the samples of `source` after it took the shape of `target`. Centres are aligned,
/// then extremities are matched by proximity: of the 2 directions of a curve, the 8 of a sheet, the 2 e of a closed
/// curve the one with the least sum of squared distances. Where one part is a sheet, the curve counts as a sheet of e
/// equal columns, and the result has e × e samples (compare with `lifted_samples()`).
Points deform_to_fit(const Sampled_part& source, const Sampled_part& target);

/// The part's samples, those of a curve repeated e times each when `count` asks for a sheet's.
Points lifted_samples(const Sampled_part& part, Eigen::Index count);

/// Matches the members of two groups (paper, section 5): centroids in the groups' unit boxes, matched one to one by
/// optimal assignment as far as numbers allow; every member left over goes to the nearest one of the other side. So no
/// target part stays free while another is taken twice without need.
Group_label match_members(const Aligned_shape& source, std::size_t source_group, const Aligned_shape& target,
                          std::size_t target_group);

/// Structure preservation (paper, section 5): how far the parts of unmatched groups move. A part follows the points
/// where it touches parts that moved already, breadth-first from the matched ones; the members of a group follow their
/// representative by the group's generator.
/// \param displacement a column a part; those of matched parts are read for the contact points below, others written
/// \param matched by group
/// \param contact_displacement by contact, the movement of the contact point on the first and on the second part where
/// that part is matched
void propagate(const Aligned_shape& shape, const std::vector<char>& matched,
               const std::vector<std::array<Point, 2>>& contact_displacement, Points& displacement);

} // namespace Shape_correspondence
} // namespace CGAL

#ifndef CGAL_SHAPE_CORRESPONDENCE_COMPILED
#include <CGAL/Shape_correspondence/internal/Geotopo_transform_impl.h>
#endif

#endif // CGAL_SHAPE_CORRESPONDENCE_GEOTOPO_TRANSFORM_H
