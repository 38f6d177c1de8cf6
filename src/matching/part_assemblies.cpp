// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/part_assemblies.h"
#include "structure/Shape_layout.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

constexpr std::size_t no_surface = std::size_t(-1);

// Finds the assemblies (`Part_assemblies`) of a shape, one kind after the other.
class Assembly_finder
{
public:
  Assembly_finder(const Aligned_shape& shape, const Part_matching_options& options)
      : shape_(shape), options_(options), layout_(shape, options.tolerance), main_surface_(main_surface())
  {}

  Part_assemblies run() const
  {
    Part_assemblies result;
    if (main_surface_ != no_surface) result.support = support();
    result.legs = legs(result.support);
    result.is_on_ground = layout_.is_on_ground;
    result.is_in_chain.assign(shape_.parts.size(), 0);
    const std::vector<std::vector<std::size_t>> all_chains = chains();
    for (const std::vector<std::size_t>& chain : all_chains)
      for (std::size_t ring : chain)
        result.is_in_chain[ring] = 1;
    for (const Part_group& group : groups(shape_))
      if (is_row(group) && !result.is_in_chain[group.parts[0]]) add_panel(group.parts, result.panels);
    for (const std::vector<std::size_t>& chain : all_chains)
      add_panel(chain, result.panels);
    if (main_surface_ != no_surface) add_side_panels(result.support, result.panels);
    return result;
  }

private:
  bool is_row(const Part_group& group) const
  {
    return group.symmetry.type == Symmetry_type::TRANSLATION && group.parts.size() >= options_.repetition;
  }

  // Whether two parts are rings, neither twice as large as the other nor around it (a wheel and its tyre).
  bool may_be_chained(std::size_t ring, std::size_t next) const
  {
    if (shape_.parts[next].kind != Sampled_part::Kind::CLOSED_CURVE) return false;
    const Axis_box &a = layout_.boxes[ring], &b = layout_.boxes[next];
    const double a_size = a.sides().maxCoeff(), b_size = b.sides().maxCoeff();
    return is_less(std::max(a_size, b_size), 2 * std::min(a_size, b_size)) &&
           is_less(options_.tolerance * std::max(a_size, b_size), (a.centre() - b.centre()).matrix().norm());
  }

  std::vector<std::vector<std::size_t>> chains() const
  {
    std::vector<std::vector<std::size_t>> result;
    std::vector<char> is_seen(shape_.parts.size(), 0);
    for (std::size_t part = 0; part < shape_.parts.size(); ++part) {
      if (is_seen[part] || shape_.parts[part].kind != Sampled_part::Kind::CLOSED_CURVE) continue;
      std::vector<std::size_t> chain =
          layout_.connected(part, [&](std::size_t ring, std::size_t next) { return may_be_chained(ring, next); });
      for (std::size_t ring : chain)
        is_seen[ring] = 1;
      if (chain.size() >= options_.repetition) result.push_back(std::move(chain));
    }
    return result;
  }

  // The lowest flat part that covers much of the shape.
  std::size_t main_surface() const
  {
    std::size_t lowest = no_surface;
    const double shape_cover = layout_.bounds.sides().x() * layout_.bounds.sides().z();
    for (std::size_t part = 0; part < layout_.boxes.size(); ++part) {
      const Eigen::Array3d sides = layout_.boxes[part].sides();
      const double cover = sides.x() * sides.z();
      if (layout_.is_on_ground[part] || !is_less(0, cover) || is_less(cover, options_.main_surface * shape_cover) ||
          is_less(options_.main_surface * std::min(sides.x(), sides.z()), sides.y()))
        continue;
      if (lowest == no_surface || is_less(layout_.boxes[part].low.y(), layout_.boxes[lowest].low.y())) lowest = part;
    }
    return lowest;
  }

  // For each part, whether it is connected to the main surface by paths that avoid the part left out.
  std::vector<char> connected_to_main_surface(std::size_t left_out = no_surface) const
  {
    std::vector<char> result(layout_.boxes.size(), 0);
    for (std::size_t part :
         layout_.connected(main_surface_, [&](std::size_t, std::size_t next) { return next != left_out; }))
      result[part] = 1;
    return result;
  }

  // Whether the part stands on the ground, or is needed to connect such a part to the main surface.
  bool supports(std::size_t part, const std::vector<char>& is_connected) const
  {
    if (layout_.is_on_ground[part]) return true;
    if (part == main_surface_ || is_less(layout_.boxes[main_surface_].middle(), layout_.boxes[part].middle()))
      return false;
    const std::vector<char> without = connected_to_main_surface(part);
    for (std::size_t other = 0; other < layout_.boxes.size(); ++other)
      if (layout_.is_on_ground[other] && is_connected[other] && !without[other]) return true;
    return false;
  }

  std::vector<std::size_t> support() const
  {
    const std::vector<char> is_connected = connected_to_main_surface();
    std::vector<std::size_t> result;
    for (std::size_t part = 0; part < layout_.boxes.size(); ++part)
      if (supports(part, is_connected)) result.push_back(part);
    return result;
  }

  bool is_wall(std::size_t part) const
  {
    const Eigen::Array3d sides = layout_.boxes[part].sides(), all = layout_.bounds.sides();
    return layout_.is_on_ground[part] &&
           (is_less(options_.wall_width * all.x(), sides.x()) || is_less(options_.wall_width * all.z(), sides.z()));
  }

  std::vector<std::size_t> legs(const std::vector<std::size_t>& support) const
  {
    std::vector<std::size_t> result;
    for (std::size_t part : support)
      if (!is_wall(part)) result.push_back(part);
    const bool has_legs =
        std::any_of(result.begin(), result.end(), [&](std::size_t part) { return bool(layout_.is_on_ground[part]); });
    return has_legs ? result : support;
  }

  // Adds a panel, united with those that share parts with it.
  static void add_panel(std::vector<std::size_t> panel, std::vector<std::vector<std::size_t>>& panels)
  {
    for (std::size_t k = panels.size(); k-- > 0;) {
      std::vector<std::size_t> both;
      std::set_union(panel.begin(), panel.end(), panels[k].begin(), panels[k].end(), std::back_inserter(both));
      if (both.size() == panel.size() + panels[k].size()) continue;
      panel = std::move(both);
      panels.erase(panels.begin() + std::ptrdiff_t(k));
    }
    panels.push_back(std::move(panel));
  }

  bool is_in_side(std::size_t part, Eigen::Index axis, double side) const
  {
    const double depth = options_.side_depth * layout_.bounds.sides()[axis];
    return !is_less(depth, layout_.boxes[part].sides()[axis]) &&
           !is_less(depth, std::abs(layout_.boxes[part].centre()[axis] - side));
  }

  // For each part, whether it lies flat in this side of the shape, above the main surface.
  std::vector<char> parts_in_side(Eigen::Index axis, double side) const
  {
    std::vector<char> result(layout_.boxes.size(), 0);
    for (std::size_t part = 0; part < layout_.boxes.size(); ++part)
      result[part] = part != main_surface_ && !layout_.is_on_ground[part] && is_in_side(part, axis, side) &&
                     is_less(layout_.boxes[main_surface_].low.y(), layout_.boxes[part].middle());
    return result;
  }

  void add_side_panels(const std::vector<std::size_t>& support, std::vector<std::vector<std::size_t>>& panels) const
  {
    for (Eigen::Index axis : {0, 2})
      for (double side : {layout_.bounds.low[axis], layout_.bounds.high[axis]}) {
        std::vector<char> is_in = parts_in_side(axis, side), may_connect = is_in;
        for (std::size_t part : support)
          may_connect[part] = 1;
        for (std::size_t first = 0; first < layout_.boxes.size(); ++first) {
          if (!is_in[first]) continue;
          std::vector<std::size_t> panel;
          for (std::size_t part :
               layout_.connected(first, [&](std::size_t, std::size_t next) { return may_connect[next]; }))
            if (is_in[part]) {
              panel.push_back(part);
              is_in[part] = 0;
            }
          if (panel.size() > 1) add_panel(std::move(panel), panels);
        }
      }
  }

  const Aligned_shape& shape_;
  const Part_matching_options& options_;
  Shape_layout layout_;
  std::size_t main_surface_;
};

} // namespace

Part_assemblies part_assemblies(const Aligned_shape& shape, const Part_matching_options& options)
{
  return Assembly_finder(shape, options).run();
}

} // namespace CGAL::Shape_correspondence
