// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "map/Charted_mesh.h"
#include "map/Part_chart.h"

#include <CGAL/Shape_correspondence/Correspondence.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/Part_correspondence.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// The parts of a shape, and their charts, in the common frame: height 1, standing on the ground.
struct Charted_shape
{
  std::vector<Points> surfaces; ///< vertices of the parts' meshes, or samples of their surfaces
  std::vector<Part_chart> charts;
  std::vector<Part_abstraction const*> parts;
};

Points to_common_frame(const Shape_frame& frame, int quarter_turns, const Points& world);

/// Charts all parts. \param surfaces points of the parts' surfaces, in the world; if empty: the control points
Charted_shape charted_shape(const Structural_graph& graph, int quarter_turns,
                            const std::vector<const Points*>& surfaces);

/// The parts of both shapes in a connected component of the graph whose edges are the pairs of parts.
struct Connected_parts
{
  std::vector<std::size_t> source, target;
};

/// The components that have parts of both shapes. \param sources, targets numbers of parts of the shapes
std::vector<Connected_parts> connected_parts(const Part_pairs& pairs, std::size_t sources, std::size_t targets);

/// The pairs of parts that are mapped to each other. If one part corresponds to several, these are the given pairs. If
/// several parts correspond to several, where a method may have paired every part with every other, they are matched by
/// their relative positions.
Part_pairs matched_members(const Charted_shape& source, const Charted_shape& target, const Part_pairs& pairs);

inline void check_model(const Structural_graph& graph, const Segmented_shape& shape)
{
  const auto& parts = structure(graph).parts;
  bool same = parts.size() == shape.parts().size();
  for (std::size_t i = 0; same && i < parts.size(); ++i)
    same = parts[i].name == shape.parts()[i].name;
  if (!same)
    throw Invalid_input(shape.name() + ": its parts are not those of the structural graph; take the graph that was " +
                        "built from this model");
}

using Chart_box = Eigen::AlignedBox3d;

inline Chart_box whole_chart() { return Chart_box(Point::Constant(-1), Point::Constant(1)); }
inline bool is_whole(const Chart_box& box) { return box.contains(whole_chart()); }

/// Two parts, or pieces of parts, that are mapped to each other.
struct Piece_pair
{
  std::size_t source = 0, target = 0;
  Chart_box source_piece = whole_chart(), target_piece = whole_chart(); ///< boxes in the chart coordinates of the parts
  /// Maps coordinates of the source's piece to those of the target's.
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
};

inline bool is_whole(const Piece_pair& pair) { return is_whole(pair.source_piece) && is_whole(pair.target_piece); }

/// Ways to align the charts of two parts.
enum class Pair_kind {
  SAME,       ///< two curves or two sheets: with each other
  LENGTHWISE, ///< a curve and a sheet: along the curve and the longer direction of the sheet
  BOXES       ///< a closed curve and any part: by their bounding boxes
};

/// The rotations of the cube to itself, the identity first.
std::vector<Eigen::Matrix3d> cube_rotations();

std::array<Part_chart, 2> piece_charts(const Piece_pair& pair, const Charted_shape& source,
                                       const Charted_shape& target);

/// How the charts of two parts are aligned.
Pair_kind pair_kind(const Piece_pair& pair, const Charted_shape& source, const Charted_shape& target);

/// The pairs of pieces for pairs of parts, in the same order.
std::vector<Piece_pair> piece_pairs(const Charted_shape& source, const Charted_shape& target, const Part_pairs& paired);

/// The pairs of pieces for a correspondence, ordered by source part, then target part.
std::vector<Piece_pair> piece_pairs(const Charted_shape& source, const Charted_shape& target,
                                    const Correspondence& correspondence);

/// The charts between which a pair of pieces is mapped: both of one kind, with corresponding coordinates.
struct Pair_charts
{
  Part_chart source, target;
};

Pair_charts pair_charts(const Piece_pair& pair, const Charted_shape& source, const Charted_shape& target,
                        const Points& source_piece, const Points& target_piece);

/// The vertices that represent the surfaces of a shape's parts.
std::vector<const Points*> mesh_surfaces(const Segmented_shape& shape);

/// The entire surfaces of both parts of a pair, in the charts between which their pieces are mapped.
struct Surface_pair
{
  Pair_charts charts;
  std::array<Charted_mesh, 2> meshes; ///< meshes with the triangles and vertices of the parts
};

Surface_pair surface_pair(const Piece_pair& pair, const std::array<Charted_shape, 2>& shapes,
                          const std::array<const Part_mesh*, 2>& meshes);

/// The piece of a part cut out by a box in its chart, closed if the part is closed. The whole part for the whole chart.
Part_mesh piece_of(const Part_mesh& part, const Part_chart& chart, const Chart_box& box);

/// A location on the surface of a part.
struct Part_place
{
  std::size_t part = 0;
  Eigen::Index triangle = 0;
  Eigen::Vector3d weights = Eigen::Vector3d::Zero(); ///< barycentric coordinates
};

/// The map of a `Surface_map` for any point of the target's surface, evaluated exactly between vertices, too.
class Point_map
{
public:
  Point_map(const Structural_graph& source, const Segmented_shape& source_shape, const Structural_graph& target,
            const Segmented_shape& target_shape, const Correspondence& correspondence);

  /// The location on the source for a point in a triangle of a part. O(log n) \pre the part has a counterpart
  Part_place operator()(std::size_t target_part, Eigen::Index triangle, const Eigen::Vector3d& weights) const;

  /// The source parts to which a target part is mapped.
  std::vector<std::size_t> sources(std::size_t target_part) const;

private:
  struct Piece
  {
    std::size_t source;
    Chart_box box; ///< box in the chart coordinates of the target part
    Surface_pair surfaces;
    std::array<Points, 2> normals;
    std::unique_ptr<Place_finder> finder; ///< finder of places on the source
  };

  Charted_shape target_;
  const Segmented_shape& target_shape_;
  std::vector<std::vector<std::unique_ptr<Piece>>> pieces_; ///< indexed by target part
};

} // namespace CGAL::Shape_correspondence::internal
