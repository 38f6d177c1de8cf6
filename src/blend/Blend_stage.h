// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Blend_part.h"
#include "map/Piece_pair.h"
#include "shape/Triangle_tree.h"

#include <CGAL/Shape_correspondence/Blend_options.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

using Tree_pointers = std::vector<const contacts::Triangle_tree*>;

Tree_pointers pointers_to(const std::vector<contacts::Triangle_tree>& trees);

/// The widest gap that has to be bridged to join all surfaces: the longest edge of a minimum spanning tree of their
/// distances, by Kruskal's algorithm. Distances are computed in the order of the distances of bounding boxes, which are
/// lower bounds, until all surfaces are joined: seldom more distances than there are surfaces.
/// \param enough gaps that are no wider count as this wide, which saves computing the distances of surfaces in contact
double widest_gap(const Tree_pointers& surfaces, double enough = 0);

/// The surface of a part that is present in a shape, at an end of a blend or in between.
struct Seen_surface
{
  /// \param number index of the part
  /// \param surface index of its present surface
  Seen_surface(const std::vector<Blend_part>& parts, std::size_t number, int surface, const Points& points);

  std::size_t number;
  const Blend_part& part;
  int surface; ///< index of the surface of the part
  Points points;
  contacts::Triangle_tree tree;
};

/// The share of the area of `a` that is inside `b`, estimated by samples.
double share_inside(const Seen_surface& a, const Seen_surface& b);

double number_of_supports(const std::vector<Seen_surface>& surfaces);

/// A shape to be blended, as it was given.
struct Blend_input
{
  const Structural_graph& graph;
  const Segmented_shape& shape;
  int quarter_turns; ///< turns about the up axis that align its frame with the stage
};

inline Point mirrored(const Point& p) { return {-p.x(), p.y(), p.z()}; }

/// Root mean square distance between points of some surfaces, mirrored in x = 0, and other surfaces.
double mirror_residual(const std::vector<const Points*>& surfaces, const Tree_pointers& trees);

/// For each part, its mirror image in x = 0, if it has one; a symmetric part is its own image.
using Mirror_images = std::vector<std::optional<std::size_t>>;

/// The source and the target (ends 0 and 1) in a common frame: both stand on the ground, y = 0, their bounding boxes
/// centred above the origin, with height 1, turned to their alignment. A shape with a mirror plane has it at x = 0.
struct Blend_stage
{
  Blend_stage(const std::array<Blend_input, 2>& inputs, Blend_size size);
  Blend_stage(const Blend_stage&) = delete;
  Blend_stage& operator=(const Blend_stage&) = delete;

  bool are_symmetric;                     ///< whether both have the mirror plane x = 0
  std::array<Structural_graph, 2> graphs; ///< the structural graphs, with the frames of the stage
  std::array<std::vector<Part_mesh>, 2> meshes;
  std::array<Charted_shape, 2> charted;
  std::array<Mirror_images, 2> images; ///< empty unless both ends are symmetric
  std::array<contacts::Box, 2> boxes;  ///< bounding boxes of the shapes
  std::array<double, 2> widest_gap;    ///< largest gap that has to be bridged to join all parts, see `widest_gap()`
  std::array<double, 2> heights;       ///< heights of the shapes in the world
  /// The shapes as given, but scaled to `heights` and rotated to the axes of the source.
  std::array<Segmented_shape, 2> shapes;

  /// Adds the pair of mirror images of every pair whose two parts have mirror images.
  void add_mirrored(Part_pairs& pairs) const;
  /// Maps points from the stage to the world, at a share `done` of the change of size on a logarithmic scale.
  Points to_world(const Points& points, double done) const;

private:
  Segmented_shape moved(const Blend_input& input, const Point& up, std::size_t end) const;
  void add(const Blend_input& input, std::size_t end);
};

/// The pairs of parts that correspond but do not morph.
struct Unlike_pairs
{
  Part_pairs all;
  /// `torn`: pairs, also of leftover parts, without a faithful morph, or whose part would come off what it touches;
  /// `detached`: the latter ones.
  std::set<Part_pairs::value_type> torn, detached;
};

/// The change needed for a part, a piece, or the box around parts to become another. Lengths are over the height.
struct Difference
{
  /// \param are_whole whether the charts are of whole parts: then extents relative to those of the shapes are compared,
  /// too, and the smaller of both changes counts
  Difference(const Blend_stage& stage, const std::array<Part_chart, 2>& charts, bool are_whole = true);

  /// Whether the proportions change little.
  bool keeps_shape() const;
  /// Whether proportions and position change little, so that pieces of parts may morph.
  bool is_little() const;
  /// Whether the displacement is small enough for a whole part to morph, if it does not come off what it touches.
  bool is_possible() const;
  /// Whether the position changes little enough for a `Space_warp` to take the box at one end to the box at the other.
  bool stays_near() const;

  double change;  ///< sum of the absolute log ratios of the extents
  double stretch; ///< absolute log ratio of the longest extents
  double way;     ///< distance of the centres relative to the shapes' bounding boxes, times their mean extents
  double size;    ///< longest extent of the two parts, pieces or boxes
  double whole;   ///< mean diagonal of the shapes' bounding boxes
};

/// The pairs of parts that morph to each other:
///  - Of the pairs that correspond, all but those whose parts would move far, or whose pieces would change their
/// proportions or positions much: legs cut up for a star base, slats across spindles. As a part is divided as a whole,
/// all other pairs of its parts, and their mirror images, are dropped with such a pair.
///  - Leftover pairs with similar position and size: two parts of a dropped pair, or two without counterparts, unless
/// one of the two shares its place nearly as much with a third part, in another such pair.
/// \param unlike its torn pairs are dropped; `all` is set
Part_pairs like_pairs(const Blend_stage& stage, const Part_pairs& paired, Unlike_pairs& unlike);

} // namespace CGAL::Shape_correspondence::internal
