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

namespace CGAL {
namespace Shape_correspondence {

namespace internal {
class Blend_structure;
}

/// \ingroup PkgShapeCorrespondenceMaps
/// A surface that exists during a part of a blend; closed if the surface of the input is.
struct Blend_surface
{
  std::string name; ///< `s~t`: of source part s that becomes t; `s~`: of s that vanishes; `~t`: of t that grows
  Blend_task task;  ///< the task that the surface belongs to
  Eigen::Matrix3Xi triangles; ///< one triangle in each column: indices into the points of the surface
  double begin = 0; ///< the surface exists at times t with `begin` <= t < `end`; what grows is a point at first
  double end = 1;   ///< see `begin`
  int side = 0;     ///< of the blend, whose materials it has: 0, the source, or 1, the target
};

/// \ingroup PkgShapeCorrespondenceMaps
/// Blends two shapes along their part correspondence, also where their topologies differ (paper, Figure 12; Alhashim et
/// al., Topology-Varying 3D Shape Creation via Structural Blending, 2014, whose terms are used: a *task* is what
/// happens to a part, a *schedule* says when each task takes place, and an *in-between shape* is the shape at a time).
///
/// - *Stage*: every shape stands on the ground with the middle of its box, or its mirror plane, above the origin, in
///   the axes of the source; the source and the target are the inputs, moved there.
/// - *Layout*: every matched part has a box at either end, and goes straight from the one to the other in place, size
///   and rotation; the axes of boxes are paired for the least rotation. The whole stands, and is as high as is due
///   between the ends.
/// - *Matched parts* morph in their boxes: in coordinates relative to cross-sections, the source's surface moves
///   smoothly onto the target's, which takes over from it at .45 of the time. A part that corresponds to many is cut
///   into closed pieces, one for each.
/// - *Unmatched parts* have no counterpart, or would be torn on the way to it, or have quite another surface, or would
///   have to change their proportions, to travel or to be cut up too much (`Blend_obstacle`). Two that are
///   alike in place and size become each other (`Blend_task_type::EXCHANGE`). Unmatched parts ride on a warp of the
///   space around their end, a smoothing spline: it moves with the surfaces of matched parts, with the boxes of parts
///   that correspond, and with the box around the whole, and smoothly between these, so that parts hold on to what they
///   touch. Old parts go as what takes their place comes, in an instant; before that, others quickly shrink to where
///   they are held, and after it, they grow from there.
/// - If both shapes have the mirror plane in common, the *mirror image* of a part becomes the mirror image of what the
///   part becomes, also where the correspondence has only one of the two.
///
/// In a *schedule*, old parts are exchanged for new ones in two steps or at one time. In two steps, so that there is a
/// mixed shape between them, is the best one, unless parts come apart in it, most of what is to stand is missing
/// (`Blend_quality`); if no mixed shape is good, both are the same. Deterministic.
/// \pre for all members: the blend was not moved from
///
/// Functions that do not change a blend may be called by several threads at once.
class Shape_blend
{
public:
  /// Prepares a blend. O(v log v) for v vertices of the subdivided models (a box of 8 vertices gets some hundreds).
  /// \param source,target the structural graphs
  /// \param source_shape,target_shape the models that the graphs were built from
  /// \param correspondence of the graphs
  /// \param options the tolerance of contacts, the size, and how schedules are rated
  /// \throw Invalid_input if a model does not have the parts of its graph, there is no such schedule, or an option is
  /// out of range
  Shape_blend(const Structural_graph& source, const Segmented_shape& source_shape, const Structural_graph& target,
              const Segmented_shape& target_shape, const Correspondence& correspondence,
              const Blend_options& options = {});

  /// The shape at `t` in [0, 1] (earlier and later, that at the ends), on the stage: the source at 0 and the target at
  /// 1, of the sizes that `Blend_options::size` asks for; in between, its parts are the surfaces that exist at `t`. All
  /// motions are even.
  Segmented_shape operator()(double t) const;

  /// The schedules, the best first, which is the one of the blend.
  const std::vector<Blend_schedule>& schedules() const { return schedules_; }

  /// The shape at `t` as one closed surface that looks outwards, for printing and Boolean operations: it is wrapped
  /// (`CGAL::alpha_wrap_3()`).
  /// \param t the time, in [0, 1]
  /// \param detail size of the smallest hollows that the wrap goes into, as a fraction of the diagonal of the shape's
  /// box, in [0.001, 1]
  /// \throw Invalid_input if it is out of range
  Part_mesh solid(double t, double detail = 0.01) const;

  /// The names of all schedules.
  static std::vector<std::string> schedule_names();

  /// The same blend by each of the schedules that make different in-between shapes, the best first (Alhashim et al.
  /// 2014, section 6).
  std::vector<Shape_blend> different_blends() const;

  /// The quality of the shape at `t`.
  Blend_quality quality(double t) const;

  /// All surfaces of the blend, for animations.
  std::vector<Blend_surface> surfaces() const;
  /// The points of each of `surfaces()` at `t`; for a surface that does not exist at `t`, its motion is continued.
  std::vector<Points> points(double t) const;

private:
  std::shared_ptr<const internal::Blend_structure> blend_;
  std::vector<Blend_schedule> schedules_;
};

} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_BLEND_SHAPES_H
