// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_BLEND_BLEND_STAGE_H
#define CGAL_SHAPE_CORRESPONDENCE_BLEND_BLEND_STAGE_H

#include "blend/Blend_scene.h"

#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

/// Root mean square distance of points, mirrored in x = 0, from a set of surfaces.
inline double mirror_residual(const std::vector<const Points*>& surfaces, const Blend_scene::Trees& trees)
{
  constexpr Eigen::Index samples = 24; // of a surface
  double sum = 0;
  int count = 0;
  for (const Points* points : surfaces) {
    const Eigen::Index n = std::min(points->cols(), samples);
    for (Eigen::Index i = 0; i < n; ++i) {
      Point p = mirrored(Point(points->col(i * points->cols() / n))), nearest;
      std::size_t triangle;
      double squared = std::numeric_limits<double>::infinity();
      for (const auto& tree : trees)
        if (tree && tree->box().squaredExteriorDistance(p) < squared)
          tree->improve_nearest(p, nearest, squared, triangle);
      sum += squared;
      ++count;
    }
  }
  return std::sqrt(sum / count);
}

/// A blend without its schedule.
class Blend_stage
{
public:
  using Times = Blend_scene::Times;

  Blend_stage(const Blend_side& source, const Blend_side& target, const Correspondence& correspondence,
              double contact_tolerance)
      : cast_(source, target, correspondence, contact_tolerance), end_quality_{quality_of(0), quality_of(1)}
  {}

  const std::vector<Blend_actor>& actors() const { return cast_.actors; }
  const Eigen::Matrix3Xi& triangles(std::size_t actor, int surface) const { return cast_.triangles(actor, surface); }
  /// The shapes of the ends as they were given.
  const Segmented_shape& end(int side) const { return cast_.shapes[std::size_t(side)]; }
  const Blend_quality& end_quality(int side) const { return end_quality_[std::size_t(side)]; }

  /// \param t strictly between 0 and 1
  Blend_scene scene(const Times& times, double t) const { return Blend_scene(cast_, times, t); }
  /// \param trees of the scene
  Blend_quality quality(const Blend_scene& scene, const Blend_scene::Trees& trees) const;
  /// By actor, how far it is from the mirror image of the shape; not there: 0.
  std::vector<double> asymmetries(const Blend_scene& scene, const Blend_scene::Trees& trees) const;
  /// From the common frame to the place that the shape has at `t`.
  Points to_world(const Points& points, double t) const;
  Point up(double t) const;

private:
  Blend_quality quality_of(std::size_t side) const;

  Blend_cast cast_;
  std::array<Blend_quality, 2> end_quality_;
};

inline Blend_quality Blend_stage::quality(const Blend_scene& scene, const Blend_scene::Trees& trees) const
{
  Blend_quality result;
  result.gap = scene.widest_contact(trees).gap;
  result.apart = scene.apart();
  result.ground = std::abs(scene.worst_foot().height);
  if (!cast_.mirror) return result;
  std::vector<const Points*> surfaces;
  for (std::size_t a = 0; a < actors().size(); ++a)
    if (scene.is_there(a)) surfaces.push_back(&scene.points(a, scene.surface(a)));
  result.asymmetry = mirror_residual(surfaces, trees);
  return result;
}

inline std::vector<double> Blend_stage::asymmetries(const Blend_scene& scene, const Blend_scene::Trees& trees) const
{
  std::vector<double> result(actors().size(), 0);
  for (std::size_t a = 0; a < actors().size(); ++a)
    if (scene.is_there(a)) result[a] = mirror_residual({&scene.points(a, scene.surface(a))}, trees);
  return result;
}

inline Blend_quality Blend_stage::quality_of(std::size_t side) const
{
  Blend_quality result;
  if (!cast_.mirror) return result;
  std::vector<const Points*> surfaces;
  for (const Part_mesh& mesh : cast_.ends.meshes[side])
    surfaces.push_back(&mesh.points);
  const std::vector<contacts::Triangle_tree> trees = trees_of(cast_.ends.meshes[side]);
  result.asymmetry = mirror_residual(surfaces, Blend_scene::Trees(trees.begin(), trees.end()));
  return result;
}

inline Points Blend_stage::to_world(const Points& points, double t) const
{
  const Eigen::Quaterniond from(cast_.frames[0].axes), to(cast_.frames[1].axes);
  const Eigen::Matrix3d axes = from.slerp(t, to).toRotationMatrix();
  const double height = (1 - t) * cast_.frames[0].height + t * cast_.frames[1].height;
  const Point origin = (1 - t) * cast_.frames[0].origin + t * cast_.frames[1].origin;
  return (axes * height * points).colwise() + origin;
}

inline Point Blend_stage::up(double t) const
{
  const Point between = (1 - t) * cast_.shapes[0].up() + t * cast_.shapes[1].up();
  return unit_or(between, cast_.shapes[0].up());
}

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_BLEND_BLEND_STAGE_H
