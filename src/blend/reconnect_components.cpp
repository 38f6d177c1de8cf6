// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Affine_motion.h"
#include "blend/in_between_steps.h"
#include "blend/mirror_images.h"
#include "blend/surface_components.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace {

class Component_mover
{
public:
  explicit Component_mover(In_between_shape& shape)
      : shape_(shape),
        allowed_(allowed_gap(shape)),
        present_(present_parts(shape)),
        components_(trees_of(shape, present_), allowed_)
  {}

  bool reconnect()
  {
    constexpr int most_tries = 5;
    std::map<std::size_t, int> tries; // by component, to join it without moving it across the mirror plane
    bool any = false;
    while (const std::optional<std::size_t> component = components_.smallest()) {
      const Surface_components::Connection connection = components_.shortest_connection(*component);
      const double gap = std::sqrt(connection.closest.squared), excess = std::max(0., gap - allowed_);
      shape_.add_disconnection(excess);
      if (excess > 0 && std::isfinite(excess)) {
        any = true;
        const Point step = excess / gap * (connection.closest.second - connection.closest.first);
        const bool is_along_mirror = std::abs(step.x()) < step.norm() / 2 && tries[*component]++ < most_tries;
        if (!move(*component, present_[connection.to], connection.closest.first, step, is_along_mirror)) continue;
      }
      components_.unite(connection.from, connection.to);
    }
    return any;
  }

private:
  static double allowed_gap(const In_between_shape& shape)
  {
    const double t = shape.time();
    const std::array<double, 2>& ends = shape.blend().widest_gap;
    return (1 - t) * ends[0] + t * ends[1] + In_between_shape::widest_connected_gap;
  }

  static std::vector<std::size_t> present_parts(const In_between_shape& shape)
  {
    std::vector<std::size_t> result;
    for (std::size_t part = 0; part < shape.number_of_parts(); ++part)
      if (shape.is_there(part)) result.push_back(part);
    return result;
  }

  static std::vector<const contacts::Triangle_tree*> trees_of(In_between_shape& shape,
                                                              const std::vector<std::size_t>& parts)
  {
    std::vector<const contacts::Triangle_tree*> result;
    for (std::size_t part : parts)
      result.push_back(&shape.tree(part));
    return result;
  }

  /// Moves a component by a step to a part, and mirror images of its parts alike. Returns whether it goes all of the
  /// way.
  /// \param from where it is nearest to the part
  /// \param is_along_mirror whether it may need another step: what is its own image is not moved across the mirror plane
  bool move(std::size_t component, std::size_t to, const Point& from, Point step, bool is_along_mirror)
  {
    std::vector<char> moves(shape_.number_of_parts(), 0), image_moves(shape_.number_of_parts(), 0);
    for (std::size_t i = 0; i < present_.size(); ++i) {
      if (components_.component_of(i) != component) continue;
      moves[present_[i]] = 1;
      const Blend_part& part = shape_.part(present_[i]);
      if (part.has_image()) image_moves[part.image] = 1;
    }
    if (image_moves[to]) step /= 2; // they move towards each other
    // What is its own image gets as much wider on both sides, unless that were more than twice as wide
    const bool is_own_image = moves == image_moves;
    const bool is_widened = is_own_image && std::abs(step.x()) <= std::abs(from.x());
    bool is_whole = true;
    for (std::size_t i = 0; i < present_.size(); ++i) {
      const std::size_t part = present_[i];
      if (!moves[part] && !image_moves[part]) continue;
      Affine_motion motion;
      motion.translation = moves[part] ? step : mirrored(step);
      if (is_widened) {
        motion.translation.x() = 0;
        motion.gradient(0, 0) = step.x() != 0 ? step.x() / from.x() : 0;
      } else if (moves[part] && image_moves[part] && (is_along_mirror || is_own_image)) {
        is_whole = is_whole && (!is_along_mirror || std::abs(motion.translation.x()) <= In_between_shape::closed_gap);
        motion.translation.x() = 0;
      }
      shape_.stretch(motion, part);
      shape_.tree(part); // moves it to the part
    }
    return is_whole;
  }

  In_between_shape& shape_;
  double allowed_; ///< the widest gap in a component
  std::vector<std::size_t> present_;
  Surface_components components_; ///< of the parts that are present
};

} // namespace

bool reconnect_components(In_between_shape& shape) { return Component_mover(shape).reconnect(); }

} // namespace CGAL::Shape_correspondence::internal
