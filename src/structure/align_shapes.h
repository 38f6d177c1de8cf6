// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <Eigen/Geometry>

#include <boost/graph/adjacency_list.hpp>
#include <boost/range/adaptor/transformed.hpp>
#include <boost/range/iterator_range.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence {

/// The paper's e: a curve has e samples, a sheet e × e (the authors' value).
constexpr int samples_per_side = 6;

/// How many points of a part's surface the matching looks at.
constexpr int surface_samples = 32;

/// A part as the search sees it: the samples of its abstraction in the common frame.
struct Sampled_part
{
  enum class Kind { CURVE, CLOSED_CURVE, SHEET };

  Kind kind = Kind::CURVE;
  Points samples; ///< e, or e × e row by row
  Point centroid; ///< mean of the samples
  Points surface; ///< at most `surface_samples` points spread over the surface; the samples where it is unknown
};

/// A pair of connected parts, once however many regions they touch in.
struct Sampled_contact
{
  std::array<std::size_t, 2> parts;   ///< ascending
  std::array<std::size_t, 2> samples; ///< the sample of either part nearest to the (first) contact
};

/// A shape in the common frame (paper, section 5, "Initial alignment"): it stands on the ground, centred, has height 1.
/// It is the structural graph with samples in the place of parts, and it is what is searched. Parts, groups and
/// contacts are in an order that depends on their places alone, not on the file, so that whatever is settled by an
/// index is settled alike for a shape that was moved or shuffled.
struct Aligned_shape
{
  using Contact = Sampled_contact;
  /// Vertices are symmetry groups, edges are groups in contact, as in `Structural_graph`; the parts and contacts that
  /// they name are the ones here.
  using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Part_group, Group_contact>;

  Graph graph;
  std::vector<Eigen::AlignedBox3d> boxes; ///< of every group, around its parts' samples
  std::vector<Sampled_part> parts;
  std::vector<std::size_t> original; ///< of every part, its index in the structural graph
  std::vector<double> prominence;    ///< of every part, its volume (an estimate where unknown)
  std::vector<std::size_t> group_of; ///< of every part, its vertex
  std::vector<Contact> contacts;     ///< those inside of groups, too, which have no edge

  std::size_t number_of_groups() const { return num_vertices(graph); }
  const Part_group& group(std::size_t vertex) const { return graph[vertex]; }
};

/// The groups of a shape, in their order.
inline auto groups(const Aligned_shape& shape)
{
  return boost::make_iterator_range(vertices(shape.graph)) |
         boost::adaptors::transformed(
             [&shape](std::size_t vertex) -> const Part_group& { return shape.graph[vertex]; });
}

/// Whether the parts of a group touch nothing, not even each other.
bool is_isolated(const Aligned_shape& shape, std::size_t group);

/// Samples a shape in its own frame, turned by quarter turns about the up axis (counter-clockwise seen from above).
Aligned_shape align_shape(const Structural_graph& graph, int quarter_turns = 0);

/// The shape with a group for every part.
Aligned_shape ungrouped(Aligned_shape shape);

/// The shape with sets of parts as groups of their own, without a symmetry and with solidity 1; what else was in their
/// groups stays together.
/// \param sets disjoint, of indices in the structural graph; those that the aligned shape does not have are left out
Aligned_shape regrouped(Aligned_shape shape, const std::vector<std::vector<std::size_t>>& sets);

/// The shape with fewer parts: those kept, their groups as far as kept, their contacts.
Aligned_shape restricted(const Aligned_shape& shape, const std::vector<char>& is_kept);

/// By part, whether it belongs to the most prominent groups of at most `count` parts in all; at least one group does
/// (the paper's coarse correspondence, Figure 11).
std::vector<char> most_prominent_parts(const Aligned_shape& shape, std::size_t count);

/// The quarter turns that bring a shape from its own frame nearest to the orientation that it was given in.
int given_quarter_turns(const Shape_frame& frame);

/// The quarter turns of the target that bring it into the source's frame, best guess first: the ones nearest to the
/// orientation that the shapes were given in, so that turning either by less than 45° as it was given changes nothing.
/// Where both shapes have one mirror plane, half turns only.
std::vector<int> alignment_turns(const Shape_frame& source, const Shape_frame& target);

} // namespace CGAL::Shape_correspondence
