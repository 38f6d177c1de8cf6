// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_ABSTRACT_PART_H
#define CGAL_SHAPE_CORRESPONDENCE_ABSTRACT_PART_H

#include <CGAL/Shape_correspondence/Part_abstraction.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/Shape_frame.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence {

struct Abstraction_options;

/// \ingroup PkgShapeCorrespondenceOptions
/// Kind of abstraction of a part.
enum class Abstraction_kind {
  AUTOMATIC, ///< a sheet if the part is wide for its length and thin for its width, else a curve
  CURVE,     ///< a `Curve`
  SHEET      ///< a `Sheet`
};

/// \ingroup PkgShapeCorrespondenceAbstraction
/// Abstracts prisms, bodies of revolution and blocks by their axis or middle layer, and fits other sheets and straight
/// curves to the medial axis, the rest to the skeleton found by mean curvature flow (paper, section 3; Tagliasacchi et
/// al. 2012). Parts that cannot be skeletonized get `Bounding_box_abstraction`; the report gives the reason.
/// \cgalModels `PartAbstractor`
struct Fitted_abstraction
{
  /// The abstraction of a part, see `PartAbstractor::operator()()`.
  Part_abstraction operator()(const Shape_part& part, const Abstraction_options& options) const;
};

/// \ingroup PkgShapeCorrespondenceAbstraction
/// Finds curves and sheets by `CGAL::Mean_curvature_flow_skeletonization`, as in the paper: a curve is the longest
/// path, or the cycle, of the converged skeleton; a sheet is fitted to the meso-skeleton, the surface when the fraction
/// `Abstraction_options::stop_volume` of the volume is left. The area and the geodesic extents of the meso-skeleton
/// determine the kind. Parts that cannot be skeletonized get `Bounding_box_abstraction`; the report gives the reason.
/// \cgalModels `PartAbstractor`
struct Mean_curvature_abstraction
{
  /// The abstraction of a part, see `PartAbstractor::operator()()`.
  Part_abstraction operator()(const Shape_part& part, const Abstraction_options& options) const;
};

/// \ingroup PkgShapeCorrespondenceAbstraction
/// Takes the medial line or rectangle of the part's bounding box, which is oriented or parallel to the coordinate axes.
/// A rough approximation that takes microseconds.
/// \cgalModels `PartAbstractor`
struct Bounding_box_abstraction
{
  /// The abstraction of a part, see `PartAbstractor::operator()()`.
  Part_abstraction operator()(const Shape_part& part, const Abstraction_options& options) const;
};

/// \ingroup PkgShapeCorrespondenceOptions
/// Options of `abstract_part()` and `abstract_parts()`. Lengths are relative to the part's diagonal.
struct Abstraction_options
{
  /// Function object that finds the curve or sheet of a part: a model of `PartAbstractor`.
  std::function<Part_abstraction(const Shape_part&, const Abstraction_options&)> abstractor = Fitted_abstraction();
  Abstraction_kind kind = Abstraction_kind::AUTOMATIC; ///< kind of abstraction of all parts
  std::map<std::string, Abstraction_kind> part_kinds;  ///< kinds of single parts, by name; override `kind`
  double edge_length = 0.02;                           ///< edge length of the remeshed part, more than 0
  int triangles = 1500;      ///< approximate limit for triangles of the remeshed part, at least 100; lengthens edges
  double stop_volume = 0.02; ///< fraction of the volume at which the flow is stopped to detect sheets and hollow parts
  int maximum_iterations = 300; ///< limit for the iterations of the flow; parts that need more get their bounding box
  /// Limit in seconds for one part; parts that need more get their bounding box, which the report states. Default: no
  /// limit, so that results do not depend on the speed of the machine.
  double time_limit = std::numeric_limits<double>::infinity();
  int curve_points = 16; ///< control points of a curve, from 2 to 1000; as many more for each full turn that it makes
  int sheet_points = 8;  ///< control points along each side of a sheet, from 2 to 1000
  /// Called after every part with the number of parts done and their total; from one thread at a time.
  std::function<void(std::size_t, std::size_t)> progress;

  /// The kind of abstraction of a part of this name.
  Abstraction_kind kind_of(const std::string& part) const;
};

/// \ingroup PkgShapeCorrespondenceAbstraction
/// Finds the curve or sheet of one part by the abstractor in the options, and its hull, area and surface samples. The
/// abstractors of this package succeed on every part that `Segmented_shape` accepts. Deterministic.
/// \param part the part
/// \param options the options of the abstraction
/// \throw Invalid_input if an option, the mesh or the abstractor's result is invalid; its exceptions are passed on
Part_abstraction abstract_part(const Shape_part& part, const Abstraction_options& options = {});

/// \ingroup PkgShapeCorrespondenceAbstraction
/// Finds the abstractions of all parts of a shape, in world coordinates. They are computed in the frame `frame`, so
/// that the result does not depend on the orientation. Of parts that are congruent under a rigid motion or a
/// reflection, one is abstracted, and its abstraction is moved to the others.
/// \tparam ConcurrencyTag `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result is bitwise identical
/// \param shape the shape
/// \param frame its frame
/// \param options the options of the abstraction
/// \throw Invalid_input if an option or the abstractor's result is invalid; exceptions of the abstractor are passed on
template <typename ConcurrencyTag = CGAL::Sequential_tag>
std::vector<Part_abstraction> abstract_parts(const Segmented_shape& shape, const Shape_frame& frame,
                                             const Abstraction_options& options = {});

/// \ingroup PkgShapeCorrespondenceAbstraction
/// `n` points spread evenly over a surface. Deterministic. \throw Invalid_input if it is empty or a number is invalid
Points sample_surface(const Part_mesh& mesh, std::size_t n);

/// \ingroup PkgShapeCorrespondenceAbstraction
/// Volume of the convex hull of points; 0 if they are flat. \throw Invalid_input if a coordinate is not finite
double convex_hull_volume(const Points& points);

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_ABSTRACT_PART_H
