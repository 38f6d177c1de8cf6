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

namespace CGAL {
namespace Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceOptions
/// Options of `transfer_appearance()` and `transfer_labels()`.
struct Transfer_options
{
  int size = 1024; ///< width and height of the texture in pixels, at least 16, at most 8192
  int margin = 4;  ///< pixels by which the colours of a chart are continued past its border, at least 1, at most 64
  int samples = 2; ///< n, from 1 to 8: the colour of a pixel is the mean of n × n points
  bool new_coordinates = false; ///< lay out texture coordinates anew, also where those of the target can be used
  Eigen::Vector3d neutral = {0.45, 0.45, 0.45}; ///< linear colour of parts without looks
};

/// \ingroup PkgShapeCorrespondenceAppearance
/// Where the looks (materials, textures and colours) of a target part come from.
enum class Looks_origin {
  SOURCE,    ///< the part of the source that it corresponds to, one of several
  NEIGHBOUR, ///< as those of a part that it touches: it has no counterpart
  TARGET,    ///< the target: it has no counterpart, and another material than what it touches
  NEUTRAL    ///< unknown: the part is grey
};

/// \ingroup PkgShapeCorrespondenceAppearance
/// What was transferred to a target part.
struct Transferred_part
{
  Looks_origin origin = Looks_origin::NEUTRAL; ///< where its looks are from
  /// The source parts that it is mapped to; of `transfer_appearance()`, the one whose looks it has is the first.
  std::vector<std::size_t> sources;
  std::size_t neighbour = 0; ///< of `Looks_origin::NEIGHBOUR`: the target part that it touches
  std::vector<int> labels;   ///< by triangle, of `transfer_labels()`; -1: none
};

/// \ingroup PkgShapeCorrespondenceAppearance
/// The result of `transfer_appearance()` and `transfer_labels()`.
struct Transferred_appearance
{
  Shape_appearance appearance;         ///< of the target: one material with one texture, which is decoded only
  std::vector<Transferred_part> parts; ///< by target part
  bool has_given_coordinates = false;  ///< whether the texture coordinates are those of the target
};

/// \ingroup PkgShapeCorrespondenceAppearance
/// Transfers colours and textures from the source to the target along a correspondence: they are baked, pixel by pixel,
/// into one texture of the target. A point of the target gets the colour of the point of the source that it is mapped
/// to, as in `Surface_map`. A part that corresponds to several has the looks of the one of largest area, or of the
/// highest of those of at least .8 of this area, so that it is not in bands. A part without counterpart has the looks
/// of the largest part that it touches of those that have a material of its own in the target; of all that it touches,
/// if the target has no looks for it. What it touches may have its looks in this way, too. If there is no such part, it
/// keeps its own looks, or is grey.
///
/// The texture has the texture coordinates of the target if all of its parts have them, within [0, 1], and no two
/// triangles overlap. Otherwise they are laid out anew: a part is cut into charts of triangles of similar orientation,
/// which are projected in parallel and packed at one scale. O(p log n) for p pixels and n triangles.
/// \param source,target the structural graphs
/// \param source_shape,target_shape the models that the graphs were built from
/// \param source_appearance,target_appearance the looks of the models, textures decoded
/// \param correspondence of the graphs
/// \param options the texture
/// \throw Invalid_input if a model does not have the parts of its graph, the source has no looks, or an option is out
/// of its range
Transferred_appearance transfer_appearance(const Structural_graph& source, const Segmented_shape& source_shape,
                                           const Shape_appearance& source_appearance, const Structural_graph& target,
                                           const Segmented_shape& target_shape,
                                           const Shape_appearance& target_appearance,
                                           const Correspondence& correspondence, const Transfer_options& options = {});

/// \ingroup PkgShapeCorrespondenceAppearance
/// The same for labels of the source's parts, each of which has a colour. A part that corresponds to several is divided
/// among them; one without counterpart has no label, and keeps its own looks, or is grey. The label of a triangle is
/// that of most of its points, smoothed in three rounds to the label of most of its neighbours in the part, so that
/// borders of labels are smooth.
/// \param source,target the structural graphs
/// \param source_shape,target_shape the models that the graphs were built from
/// \param labels by source part
/// \param colours linear, by label
/// \param target_appearance the looks of the target, textures decoded
/// \param correspondence of the graphs
/// \param options the texture
/// \throw Invalid_input if a model does not have the parts of its graph, a label has no colour, or an option is out of
/// its range
Transferred_appearance transfer_labels(const Structural_graph& source, const Segmented_shape& source_shape,
                                       const std::vector<int>& labels, const std::vector<Eigen::Vector3d>& colours,
                                       const Structural_graph& target, const Segmented_shape& target_shape,
                                       const Shape_appearance& target_appearance, const Correspondence& correspondence,
                                       const Transfer_options& options = {});

/// \ingroup PkgShapeCorrespondenceAppearance
/// Transfers the appearance of a mesh to another mesh on the same surface, such as a piece or a subdivision of it: a
/// triangle gets the material of the triangle nearest to its centroid, whose texture coordinates and colours are
/// interpolated. O(n log n).
/// \param mesh, appearance the mesh and its appearance
/// \param on_it the mesh on the same surface
Part_appearance appearance_on(const Part_mesh& mesh, const Part_appearance& appearance, const Part_mesh& on_it);

/// \ingroup PkgShapeCorrespondenceAppearance
/// The appearance of the parts that `split_parts()` made of objects.
/// \param objects, appearance the model and its appearance
/// \param split its parts
Shape_appearance appearance_of_parts(const Segmented_shape& objects, const Shape_appearance& appearance,
                                     const Part_split& split);

} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_TRANSFER_APPEARANCE_H
