// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_TRANSFER_APPEARANCE_H
#define CGAL_SHAPE_CORRESPONDENCE_TRANSFER_APPEARANCE_H

#include <CGAL/Shape_correspondence/Correspondence.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/Shape_appearance.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>
#include <CGAL/Shape_correspondence/split_parts.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceOptions
/// Options of `transfer_appearance()` and `transfer_labels()`.
struct Transfer_options
{
  int size = 1024;              ///< width and height of the texture in pixels, at least 16, at most 8192
  int margin = 4;               ///< number of pixels by which colours extend past the border of a chart, from 1 to 64
  int samples = 2;              ///< n, from 1 to 8: the colour of a pixel is the mean of n × n points
  bool new_coordinates = false; ///< whether to compute new texture coordinates even if those of the target are usable
  Eigen::Vector3d neutral = {0.45, 0.45, 0.45}; ///< linear colour of parts without appearance
};

/// \ingroup PkgShapeCorrespondenceAppearance
/// The origin of the appearance (materials, textures and colours) of a target part.
enum class Appearance_origin {
  SOURCE,    ///< a corresponding part of the source
  NEIGHBOUR, ///< a neighbouring part of the target, since it has no counterpart
  TARGET,    ///< the target itself: it has no counterpart, and another material than its neighbours
  NEUTRAL    ///< none: the part is grey
};

/// \ingroup PkgShapeCorrespondenceAppearance
/// The result of a transfer for a target part.
struct Transferred_part
{
  Appearance_origin origin = Appearance_origin::NEUTRAL; ///< origin of its appearance
  /// The source parts to which it is mapped; after `transfer_appearance()`, the first one is the origin.
  std::vector<std::size_t> sources;
  std::size_t neighbour = 0; ///< for `Appearance_origin::NEIGHBOUR`: index of the neighbour in the target
  std::vector<int> labels;   ///< label of each triangle, set by `transfer_labels()`; -1: none
};

/// \ingroup PkgShapeCorrespondenceAppearance
/// The result of `transfer_appearance()` and `transfer_labels()`.
struct Transferred_appearance
{
  Shape_appearance appearance; ///< appearance of the target: one material with one texture, without `Texture::bytes`
  std::vector<Transferred_part> parts; ///< indexed by target part
  bool has_given_coordinates = false;  ///< whether the texture coordinates are those of the target
};

/// \ingroup PkgShapeCorrespondenceAppearance
/// Transfers colours and textures from the source to the target along a correspondence: they are baked, pixel by pixel,
/// into one texture of the target. A point of the target gets the colour of the point of the source to which it is
/// mapped, as in `Surface_map`. A part that corresponds to several gets the appearance of the one of largest area, or
/// of the highest one with at least .8 of this area, so that it does not show bands. A part without counterpart gets
/// the appearance of its largest neighbour among those that share a material with it in the target, or among all
/// neighbours if the target has no appearance for it; this is repeated, so that an appearance may spread over several
/// parts. If there is no such neighbour, the part keeps its own appearance, or is grey.
///
/// The texture has the texture coordinates of the target if all of its parts have them, within [0, 1], and no two
/// triangles overlap. Otherwise new ones are computed: a part is cut into charts of triangles of similar orientation,
/// which are projected in parallel and packed at one scale. O(p log n) for p pixels and n triangles.
/// \param source,target the structural graphs
/// \param source_shape,target_shape the models that the graphs were built from
/// \param source_appearance,target_appearance appearance of the models, with decoded textures
/// \param correspondence correspondence of the graphs
/// \param options options of the texture
/// \throw Invalid_input if a model lacks parts of its graph, the source has no appearance, or an option is out of range
Transferred_appearance transfer_appearance(const Structural_graph& source, const Segmented_shape& source_shape,
                                           const Shape_appearance& source_appearance, const Structural_graph& target,
                                           const Segmented_shape& target_shape,
                                           const Shape_appearance& target_appearance,
                                           const Correspondence& correspondence, const Transfer_options& options = {});

/// \ingroup PkgShapeCorrespondenceAppearance
/// Transfers labels of the source's parts, each with a colour. A part that corresponds to several is divided among
/// them; one without counterpart has no label, and keeps its own appearance, or is grey. The label of a triangle is the
/// most frequent one of its points, smoothed in three rounds to the most frequent one of its neighbours in the part, so
/// that borders of labels are smooth.
/// \param source,target the structural graphs
/// \param source_shape,target_shape the models that the graphs were built from
/// \param labels labels, by source part
/// \param colours linear colours, by label
/// \param target_appearance appearance of the target, with decoded textures
/// \param correspondence correspondence of the graphs
/// \param options options of the texture
/// \throw Invalid_input if a model lacks parts of its graph, a label has no colour, or an option is out of range
Transferred_appearance transfer_labels(const Structural_graph& source, const Segmented_shape& source_shape,
                                       const std::vector<int>& labels, const std::vector<Eigen::Vector3d>& colours,
                                       const Structural_graph& target, const Segmented_shape& target_shape,
                                       const Shape_appearance& target_appearance, const Correspondence& correspondence,
                                       const Transfer_options& options = {});

/// \ingroup PkgShapeCorrespondenceAppearance
/// Transfers the appearance of a mesh to another mesh on the same surface, such as a piece or a subdivision of it: a
/// triangle gets the material of the triangle nearest to its centroid, whose texture coordinates and colours are
/// interpolated. O(n log n).
/// \param mesh, appearance the mesh with the appearance
/// \param on_it the other mesh
Part_appearance appearance_on(const Part_mesh& mesh, const Part_appearance& appearance, const Part_mesh& on_it);

/// \ingroup PkgShapeCorrespondenceAppearance
/// The appearance of the parts that `split_parts()` made of objects.
/// \param objects, appearance the model and its appearance
/// \param split its parts
Shape_appearance appearance_of_parts(const Segmented_shape& objects, const Shape_appearance& appearance,
                                     const Part_split& split);

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_TRANSFER_APPEARANCE_H
