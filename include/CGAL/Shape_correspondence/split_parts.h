// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_SPLIT_PARTS_H
#define CGAL_SHAPE_CORRESPONDENCE_SPLIT_PARTS_H

#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/segment_mesh.h>

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceOptions
/// Ways to make parts of the objects of a model.
enum class Part_splitting {
  AUTO,       ///< every object is a part, but objects with unrelated loose pieces are split
  FILE,       ///< every object is a part
  COMPONENTS, ///< every loose piece is a part
  SEGMENTS    ///< every loose piece is a part; closed ones are divided by `segment_mesh()`
};

/// \ingroup PkgShapeCorrespondenceOptions
/// Options of `split_parts()`. Lengths are relative to the size of the model, which is about its diameter.
struct Part_splitting_options
{
  Part_splitting mode = Part_splitting::AUTO; ///< how parts are made
  double layer_distance = 0.015;     ///< a piece lies on another one if all of its points are within this distance
  double small_size = 0.04;          ///< largest size of a piece that joins a larger one in contact with it
  double touching_distance = 0.005;  ///< largest gap of pieces in contact
  std::size_t most_parts = 100;      ///< largest number of parts of one of several objects; with more it stays whole
  Segmentation_options segmentation; ///< options of `Part_splitting::SEGMENTS`, and for models of one piece
  /// Index of the material by object and triangle. Empty: a single material.
  std::vector<std::vector<int>> materials;
  bool divide_by_materials = true; ///< whether loose pieces also end at changes of the material
};

/// \ingroup PkgShapeCorrespondenceShapes
/// The part index of a piece that belongs to no part.
constexpr std::size_t no_part = std::size_t(-1);

/// \ingroup PkgShapeCorrespondenceShapes
/// A loose piece of an object: triangles connected through vertices, or a segment of them.
struct Model_piece
{
  std::string name;       ///< name of its object, with `#1`, `#2`, … if the object has several pieces
  std::size_t object = 0; ///< index of the object
  std::size_t part = 0;   ///< index of its part; `no_part` if it is left out
  bool closed = false;    ///< whether every edge has two triangles
  double size = 0;        ///< size of the piece over that of the model
  std::string reason;     ///< why it is in a part with other pieces; empty for the largest piece of a part
};

/// \ingroup PkgShapeCorrespondenceShapes
/// The result of `split_parts()`.
struct Part_split
{
  Segmented_shape shape;              ///< the parts
  std::vector<Model_piece> pieces;    ///< sorted by object, then by place along a direction of the frame
  std::vector<std::string> decisions; ///< for every object: the result, and its reason
  bool by_segments = false;           ///< whether loose pieces were divided, where possible, by `segment_mesh()`
  bool is_found = false;              ///< whether parts were found by their similarity to labelled parts
  /// The category and the number of parts of each role, in words, if parts were found and are clearly of a category.
  std::string found_roles = {};
  std::vector<std::string> patched_objects = {}; ///< objects whose pieces are patches between creases
  bool by_materials = false;                     ///< whether pieces also end at changes of the material
  /// If parts were found, the unions of pieces that may be parts. A union has two members: a number i below
  /// `pieces.size()` is the piece i, any other number the earlier union i - `pieces.size()`.
  std::vector<std::array<std::size_t, 2>> unions = {};
  std::size_t pieces_left_out = 0; ///< number of pieces without area
  /// Number of closed pieces that were not divided into segments, since they have no interior.
  std::size_t pieces_kept_whole = 0;

  /// Whether the parts differ from the objects.
  bool changes_objects() const;
  /// Whether the pieces of an object are in several parts.
  bool is_split(std::size_t object) const;
};

/// \ingroup PkgShapeCorrespondenceShapes
/// Makes parts of the objects of a model. An object may have pieces that only share a material, such as four legs, and
/// one part may have several pieces, such as the spokes of a wheel. In mode `Part_splitting::AUTO`
/// - one of several objects stays whole if the hull of its largest piece contains all others and that piece is smaller
///   than .5 of the model (a spoked wheel, a cushion with its piping), if it is smaller than .3 of the model and its
///   pieces touch, if it has more than 1000 pieces, or if it would become more than `most_parts` parts;
/// - in other objects every piece becomes a part, except that a piece joins a larger one on which it lies (a lining, a
///   screw), a small piece joins a larger one that it touches, and pieces that touch and are deep in each other's hulls
///   stay together;
/// - a model that would become one part is split into its pieces, and a model of one piece into its segments, unless
///   these are more than 30 or it has more than 200 000 triangles.
///
/// The result does not depend on position, size, rotation (except for rounding) and order. Parts have the name of their
/// object, with `#2`, `#3`, … after the first. An object that is not split keeps its mesh. Loose pieces without area
/// are left out and counted. O(n log n) in the number of triangles, and quadratic in the number of pieces of an object.
/// \param objects the model, whose parts are the objects
/// \param options the mode and its options
/// \throw Invalid_input if the model has no part, more than 10 000 pieces to be grouped, or materials that do not fit
/// its triangles
Part_split split_parts(const Segmented_shape& objects, const Part_splitting_options& options = {});

/// \ingroup PkgShapeCorrespondenceShapes
/// Splits a model into given parts.
/// \param objects the model
/// \param part_of_piece the name of the part for the name of every piece; an empty name leaves the piece out
/// \param by_segments whether pieces are those of `Part_splitting::SEGMENTS`
/// \param segmentation options for segments
/// \param materials as in `Part_splitting_options`
/// \param patched_objects see `Part_split`
/// \throw Invalid_input if a piece is missing, a name is not that of a piece, or materials do not fit the triangles
Part_split split_parts(const Segmented_shape& objects, const std::map<std::string, std::string>& part_of_piece,
                       bool by_segments = false, const Segmentation_options& segmentation = {},
                       const std::vector<std::vector<int>>& materials = {},
                       const std::vector<std::string>& patched_objects = {});

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_SPLIT_PARTS_H
