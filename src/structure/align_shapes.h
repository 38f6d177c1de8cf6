// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "structure/Sampled_part.h"

#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <Eigen/Geometry>

#include <boost/graph/adjacency_list.hpp>
#include <boost/range/adaptor/transformed.hpp>
#include <boost/range/iterator_range.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence {

/// A pair of connected parts; one contact stands for all regions where they touch.
struct Sampled_contact
{
  std::array<std::size_t, 2> parts;   ///< indices, ascending
  std::array<std::size_t, 2> samples; ///< for each of the two parts, the sample nearest to the contact's largest region
};

/// The structural graph of a shape in the common frame (paper, section 5, "Initial alignment"), with parts replaced by
/// samples: the shape stands on the ground, is centred and has height 1. The search works on it. The order of parts,
/// groups and contacts depends on geometry alone, so that ties are broken alike for a moved or shuffled shape.
struct Aligned_shape
{
  using Contact = Sampled_contact;
  /// The graph as in `Structural_graph`: vertices are symmetry groups, edges are pairs of groups in contact. Indices
  /// refer to `parts` and `contacts`.
  using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Part_group, Group_contact>;

  Graph graph;
  std::vector<Eigen::AlignedBox3d> boxes; ///< bounding boxes of the samples, by group
  std::vector<Sampled_part> parts;
  std::vector<std::size_t> original; ///< index in the structural graph, by part
  std::vector<double> prominence;    ///< volume of each part, or an estimate of it
  std::vector<std::size_t> group_of; ///< vertex of the graph, by part
  std::vector<Contact> contacts;     ///< includes contacts within a group, which have no edge

  std::size_t number_of_groups() const { return num_vertices(graph); }
  const Part_group& group(std::size_t vertex) const { return graph[vertex]; }
};

inline auto groups(const Aligned_shape& shape)
{
  return boost::make_iterator_range(vertices(shape.graph)) |
         boost::adaptors::transformed(
             [&shape](std::size_t vertex) -> const Part_group& { return shape.graph[vertex]; });
}

/// Whether the parts of a group touch no part, not even each other.
bool is_isolated(const Aligned_shape& shape, std::size_t group);

/// Samples a shape in its own frame, turned by quarter turns about the up axis (counter-clockwise seen from above).
Aligned_shape align_shape(const Structural_graph& graph, int quarter_turns = 0);

/// A copy in which every part is a group.
Aligned_shape ungrouped(Aligned_shape shape);

/// A copy in which each set is a group without symmetry, of solidity 1; remaining parts of a group stay together.
/// \param sets disjoint sets of indices in the structural graph; parts that the aligned shape lacks are ignored
Aligned_shape regrouped(Aligned_shape shape, const std::vector<std::vector<std::size_t>>& sets);

/// The shape reduced to the parts that are kept, the remainders of their groups, and the contacts between them.
Aligned_shape restricted(const Aligned_shape& shape, const std::vector<char>& is_kept);

/// Marks the `count` most prominent parts (the paper's coarse correspondence, Figure 11); all if the shape has no more.
/// Whole groups are taken, in the order of their most prominent part, as long as they fit; the remainder is filled with
/// parts of the groups that do not fit.
std::vector<char> most_prominent_parts(const Aligned_shape& shape, std::size_t count);

/// The quarter turns from a shape's own frame to the orientation nearest to that of its file.
int given_quarter_turns(const Shape_frame& frame);

/// The quarter turns of the target to try, best guess first: the one by which the orientations of the two files agree.
/// Turning a shape by less than 45° changes nothing. Only half turns if both shapes have one mirror plane.
std::vector<int> alignment_turns(const Shape_frame& source, const Shape_frame& target);

} // namespace CGAL::Shape_correspondence
