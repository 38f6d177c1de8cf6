// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Affine_motion.h"
#include "blend/ease.h"
#include "blend/in_between_steps.h"
#include "blend/mirror_images.h"

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// How far parts are to be symmetric: wholly from the end of the first quarter to the begin of the last one.
double mirror_share(const In_between_shape& shape)
{
  const double t = time_of(shape.time());
  return std::min({1., 4 * t, 4 * (1 - t)});
}

/// Whether a part and its mirror image are both there.
bool has_image(const In_between_shape& shape, std::size_t part)
{
  return shape.part(part).has_image() && shape.is_there(part) && shape.is_there(shape.part(part).image);
}

/// Root mean square, as that of what is left of a part.
double thickness(const In_between_shape& shape, std::size_t part)
{
  return shape.remaining(part) * shape.part(part).rests[std::size_t(shape.surface(part))]->extent().spread();
}

/// Moves points half of the way to the mirror image of a surface.
/// \param triangles by point, those of the surface to begin with; then the nearest ones
void move_to_image(Points& points, const contacts::Triangle_tree& surface, double share,
                   std::vector<std::size_t>& triangles)
{
  const bool is_first = triangles.empty();
  triangles.resize(std::size_t(points.cols()), 0);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (is_first && i > 0) triangles[i] = triangles[i - 1];
    auto p = points.col(Eigen::Index(i));
    p += share / 2 * (mirrored(surface.nearest(mirrored(Point(p)), triangles[i])) - p);
  }
}

} // namespace

void symmetrise_boxes(In_between_shape& shape, bool of_matched)
{
  const double share = mirror_share(shape);
  std::vector<contacts::Box> boxes(shape.number_of_parts());
  for (std::size_t part = 0; part < boxes.size(); ++part)
    if (shape.is_there(part)) boxes[part] = box_of(shape.points(part));
  for (std::size_t part = 0; part < boxes.size(); ++part) {
    if (!has_image(shape, part) || bool(shape.part(part).morph) != of_matched) continue;
    const contacts::Box& image = boxes[shape.part(part).image];
    const Point middle = boxes[part].center(), size = boxes[part].sizes();
    const Point translation = share / 2 * (mirrored(Point(image.center())) - middle);
    const Point growth = share / 2 * (image.sizes() - size).cwiseQuotient(size.cwiseMax(least_stretched_size));
    shape.apply(Affine_motion{middle, translation, growth.asDiagonal()}, part);
  }
}

void symmetrise(In_between_shape& shape)
{
  symmetrise_boxes(shape, true);
  for (std::size_t part = 0; part < shape.number_of_parts(); ++part)
    symmetrise_surfaces(shape, part);
}

void symmetrise_surfaces(In_between_shape& shape, std::size_t part)
{
  constexpr double alike = 5e-4;     // of the height: so near that nothing needs to be done
  constexpr double most_moved = 0.5; // of the thickness
  constexpr int most_rounds = 4;
  constexpr Eigen::Index most_points = 5000; // ornaments have no nearest points that they could go to
  if (!has_image(shape, part)) return;
  const std::size_t image = shape.part(part).image;
  if (image < part || shape.points(part).cols() + shape.points(image).cols() > most_points) return;
  const double share = mirror_share(shape);
  std::array<std::vector<std::size_t>, 2> triangles;
  for (int round = 0; round < most_rounds; ++round) {
    const contacts::Triangle_tree &own = shape.tree(part), &others = shape.tree(image);
    const double distance =
        std::max(mirror_distance(shape.points(part), others), mirror_distance(shape.points(image), own));
    if (distance <= alike || distance > most_moved * std::min(thickness(shape, part), thickness(shape, image))) return;
    move_to_image(shape.moving_points(part), others, share, triangles[0]);
    if (image != part) move_to_image(shape.moving_points(image), own, share, triangles[1]);
  }
}

} // namespace CGAL::Shape_correspondence::internal
