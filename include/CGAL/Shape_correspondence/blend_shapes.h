// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_BLEND_SHAPES_H
#define CGAL_SHAPE_CORRESPONDENCE_BLEND_SHAPES_H

#include <CGAL/Shape_correspondence/Blend_options.h>
#include <CGAL/Shape_correspondence/Blend_schedule.h>
#include <CGAL/Shape_correspondence/Correspondence.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <memory>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence {

namespace internal {
class Blend_structure;
}

/// \ingroup PkgShapeCorrespondenceMaps
/// A surface that exists for a part of the time of a blend; closed if the surface of the input is.
struct Blend_surface
{
  std::string name; ///< `s~t` for a source part s that becomes t; `s~` for s that vanishes; `~t` for t that grows
  Blend_task task;  ///< the task to which the surface belongs
  Eigen::Matrix3Xi triangles; ///< one triangle in each column: indices into the points of the surface
  double begin = 0; ///< it exists at times t with `begin` <= t < `end`; a growing surface starts as a point or line
  double end = 1;   ///< see `begin`
  int side = 0;     ///< the shape whose materials it has: 0, the source, or 1, the target
};

/// \ingroup PkgShapeCorrespondenceMaps
/// Blends two shapes along their part correspondence, also where their topologies differ (paper, Figure 12; Alhashim et
/// al., Topology-Varying 3D Shape Creation via Structural Blending, 2014, whose terms are used: a *task* is the change
/// of one part, a *schedule* gives the time of each task, and an *in-between shape* is the shape at one time).
///
/// - *Stage*: every shape stands on the ground with the centre of its bounding box, or its mirror plane, above the
///   origin, in the axes of the source; the source and the target are the inputs, moved there.
/// - *Layout*: every matched part has a box in the source and one in the target; position, size and rotation are
///   interpolated between the two, whose axes are paired by the least rotation. The shape stands on the ground with the
///   interpolated height.
/// - *Matched parts* morph in their boxes, or along their curves. Either surface moves with its box and, where that
///   brings it nearer to the other one, with a smooth change of space by the outlines of cross-sections. The target's
///   surface replaces the source's at time .45. A part that corresponds to many is cut into closed pieces, one for
///   each.
/// - *Unmatched parts* have no counterpart, or cannot morph to it (`Blend_obstacle`). Two with similar place and size
///   become each other (`Blend_task_type::EXCHANGE`). Unmatched parts follow a warp of the space around their shape,
///   a smoothing spline: it follows the surfaces of matched parts, the boxes of parts that correspond, and the bounding
///   box of the whole shape, so that parts stay in contact with their neighbours. Where their contacts allow it, they
///   are stretched, or turned and stretched, so that what is straight stays straight. They come and go along their own
///   curve or sheet: from the place where they are attached, or from the line between several such places. Old parts
///   (of the source) are replaced by the new ones in their place in an instant, one place after the other; other old
///   parts vanish before that, and other new parts grow after it, parts after those that carry them.
/// - If x = 0 is a mirror plane of both shapes on the stage, the *mirror image* of a part becomes the mirror image of
///   its counterpart, even if only one of the two pairs is in the correspondence.
///
/// In a *schedule*, old parts are exchanged for new ones in two steps or at one time. Two steps, with a mixed shape
/// between them, are preferred unless parts come apart in the mixed shape or most of its supports are missing
/// (`Blend_quality`); if no mixed shape is good, both schedules are the same. Deterministic.
/// \pre for all members: the object has not been moved from (`std::move()`)
///
/// Functions that do not change a blend may be called by several threads at once.
class Shape_blend
{
public:
  /// Prepares a blend. O(v log v) for v vertices of the subdivided models (a box of 8 vertices gets some hundreds).
  /// \param source,target the structural graphs
  /// \param source_shape,target_shape the models that the graphs were built from
  /// \param correspondence correspondence of the graphs
  /// \param options the tolerance of contacts, the size, and how schedules are rated
  /// \throw Invalid_input if a model lacks parts of its graph, the schedule does not exist, or an option is out of
  /// range
  Shape_blend(const Structural_graph& source, const Segmented_shape& source_shape, const Structural_graph& target,
              const Segmented_shape& target_shape, const Correspondence& correspondence,
              const Blend_options& options = {});

  /// The shape at `t`, clamped to [0, 1], on the stage: the source at 0 and the target at 1, of the sizes given by
  /// `Blend_options::size`; in between, its parts are the surfaces that exist at `t`. All motions are uniform.
  Segmented_shape operator()(double t) const;

  /// The schedules, the best first; the blend uses the first.
  const std::vector<Blend_schedule>& schedules() const { return schedules_; }

  /// The shape at `t` wrapped (`CGAL::alpha_wrap_3()`) to one closed, outward oriented surface, for printing and
  /// Boolean operations.
  /// \param t the time, in [0, 1]
  /// \param detail size of the smallest hollows that the wrap enters, over the shape's diagonal, in [0.001, 1]
  /// \throw Invalid_input if `detail` is out of range
  Part_mesh solid(double t, double detail = 0.01) const;

  /// The names that `Blend_options::schedule` may have.
  static std::vector<std::string> schedule_names();

  /// The blends by schedules with different in-between shapes, the best first (Alhashim et al. 2014, section 6).
  std::vector<Shape_blend> different_blends() const;

  /// The quality of the shape at `t`.
  Blend_quality quality(double t) const;

  /// All surfaces of the blend, as for animations.
  std::vector<Blend_surface> surfaces() const;
  /// The points of each of `surfaces()` at `t`; the motion of surfaces that do not exist at `t` is extrapolated.
  std::vector<Points> points(double t) const;

private:
  std::shared_ptr<const internal::Blend_structure> blend_;
  std::vector<Blend_schedule> schedules_;
};

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_BLEND_SHAPES_H
