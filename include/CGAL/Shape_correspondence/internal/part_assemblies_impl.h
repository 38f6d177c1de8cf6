// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_PART_ASSEMBLIES_IMPL_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_PART_ASSEMBLIES_IMPL_H

#include <CGAL/Shape_correspondence/part_assemblies.h>

#include <CGAL/Shape_correspondence/internal/quantized.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

constexpr double ground_tolerance = 0.03; // of the height: a part that starts lower stands on the ground

// All set on one half of the development set, by source family, and on the generated shapes
constexpr double deck_cover = 0.3;      // of the shape as seen from above, that a deck covers
constexpr double deck_flatness = 0.3;   // its height, over its shorter side
constexpr double wall_width = 0.7;      // of the shape's: what is wider is a wall, not a leg
constexpr double upright_limit = 0.7;   // the vertical component of an upright row's normal is less
constexpr double planarity = 2;         // so much further than across its plane a row spreads in it, at least
constexpr double frame_thickness = 5;   // of the row's: a row and its frame are no thicker
constexpr double frame_allowance = 0.1; // of the height: or than this
constexpr double frame_reach = 1.25;    // of the row's extents: by this a frame may be larger, in the plane

constexpr double side_depth = 0.1;   // of the shape's: by this a part in one of its sides is thick, and off it
constexpr double link_ratio = 1.25;  // of their longest sides: links of a chain are no more unlike
constexpr double link_offset = 0.25; // of a link's longest side: the next one is farther off than wheel and tyre

struct Axis_box
{
  Eigen::Array3d low, high;

  Eigen::Array3d sides() const { return high - low; }
  Eigen::Array3d centre() const { return (low + high) / 2; }
  double middle() const { return (low.y() + high.y()) / 2; }
};

inline Axis_box box_of(const Points& points) { return {points.rowwise().minCoeff(), points.rowwise().maxCoeff()}; }

inline Axis_box joined(const Axis_box& a, const Axis_box& b) { return {a.low.min(b.low), a.high.max(b.high)}; }

inline bool is_less(double a, double b) { return quantized(a) < quantized(b); }

// The sets of the shape's parts, one after the other.
class Assembly_finder
{
public:
  explicit Assembly_finder(const Aligned_shape& shape) : shape_(shape), neighbours_(shape.parts.size())
  {
    for (const Sampled_part& part : shape.parts)
      boxes_.push_back(box_of(part.surface));
    whole_ = boxes_.front();
    for (const Axis_box& box : boxes_)
      whole_ = joined(whole_, box);
    for (const Axis_box& box : boxes_)
      is_on_ground_.push_back(is_less(box.low.y() - whole_.low.y(), ground_tolerance * whole_.sides().y()));
    for (const Aligned_shape::Contact& contact : shape.contacts) {
      neighbours_[contact.parts[0]].push_back(contact.parts[1]);
      neighbours_[contact.parts[1]].push_back(contact.parts[0]);
    }
    deck_ = deck();
    find_chains();
  }

  Part_assemblies run() const
  {
    Part_assemblies result;
    result.has_deck = deck_ != none;
    if (result.has_deck) result.support = support();
    result.legs = legs(result.support);
    result.is_on_ground = is_on_ground_;
    result.is_link = is_link_;
    for (const Aligned_shape::Group& group : shape_.groups)
      if (is_row(group) && !is_link_[group.parts[0]]) add_panel(framed(group.parts), result.panels);
    for (const std::vector<std::size_t>& chain : chains_)
      add_panel(chain, result.panels);
    if (result.has_deck) add_side_panels(result.support, result.panels);
    return result;
  }

private:
  static constexpr std::size_t none = std::size_t(-1);

  std::size_t deck() const
  {
    std::size_t lowest = none;
    const double whole_cover = whole_.sides().x() * whole_.sides().z();
    for (std::size_t part = 0; part < boxes_.size(); ++part) {
      const Eigen::Array3d sides = boxes_[part].sides();
      const double cover = sides.x() * sides.z();
      if (is_on_ground_[part] || !is_less(0, cover) || is_less(cover, deck_cover * whole_cover) ||
          is_less(deck_flatness * std::min(sides.x(), sides.z()), sides.y()))
        continue;
      if (lowest == none || is_less(boxes_[part].low.y(), boxes_[lowest].low.y())) lowest = part;
    }
    return lowest;
  }

  // The part and what is connected to it by steps from one part to the next that are allowed, ascending.
  template <typename Is_step>
  std::vector<std::size_t> connected(std::size_t first, const Is_step& is_step) const
  {
    std::vector<char> is_reached(boxes_.size(), 0);
    std::vector<std::size_t> result{first};
    is_reached[first] = 1;
    for (std::size_t k = 0; k < result.size(); ++k)
      for (std::size_t next : neighbours_[result[k]])
        if (!is_reached[next] && is_step(result[k], next)) {
          is_reached[next] = 1;
          result.push_back(next);
        }
    std::sort(result.begin(), result.end());
    return result;
  }

  // By part, whether it is connected to the deck by other parts than the one left out.
  std::vector<char> connected_to_deck(std::size_t left_out = none) const
  {
    std::vector<char> result(boxes_.size(), 0);
    for (std::size_t part : connected(deck_, [&](std::size_t, std::size_t next) { return next != left_out; }))
      result[part] = 1;
    return result;
  }

  bool carries(std::size_t part, const std::vector<char>& is_connected) const
  {
    if (is_on_ground_[part]) return true;
    if (part == deck_ || is_less(boxes_[deck_].middle(), boxes_[part].middle())) return false;
    const std::vector<char> without = connected_to_deck(part);
    for (std::size_t other = 0; other < boxes_.size(); ++other)
      if (is_on_ground_[other] && is_connected[other] && !without[other]) return true;
    return false;
  }

  std::vector<std::size_t> support() const
  {
    const std::vector<char> is_connected = connected_to_deck();
    std::vector<std::size_t> result;
    for (std::size_t part = 0; part < boxes_.size(); ++part)
      if (carries(part, is_connected)) result.push_back(part);
    return result;
  }

  bool is_wall(std::size_t part) const
  {
    const Eigen::Array3d sides = boxes_[part].sides(), all = whole_.sides();
    return is_on_ground_[part] &&
           (is_less(wall_width * all.x(), sides.x()) || is_less(wall_width * all.z(), sides.z()));
  }

  std::vector<std::size_t> legs(const std::vector<std::size_t>& support) const
  {
    std::vector<std::size_t> result;
    for (std::size_t part : support)
      if (!is_wall(part)) result.push_back(part);
    const bool has_legs =
        std::any_of(result.begin(), result.end(), [&](std::size_t part) { return bool(is_on_ground_[part]); });
    return has_legs ? result : support;
  }

  static bool is_row(const Aligned_shape::Group& group)
  {
    return group.symmetry.type == Symmetry_type::TRANSLATION && group.parts.size() >= whole_group_size;
  }

  // May a part frame a row, by its role? Knobs in a row do not frame the drawers that they are on.
  bool may_frame(std::size_t part, bool row_is_on_ground, bool row_is_above_deck) const
  {
    if (is_link_[part] || is_row(shape_.groups[shape_.group_of[part]])) return false;
    if (is_on_ground_[part] && !row_is_on_ground) return false;
    return !row_is_above_deck || is_less(boxes_[deck_].middle(), boxes_[part].middle());
  }

  // The row and the connected parts in its plane, farther and farther away.
  std::vector<std::size_t> framed(const std::vector<std::size_t>& row) const
  {
    std::vector<std::size_t> result = row;
    const Eigen::Matrix3d axes = plane_of(row);
    if (axes.isZero()) return result;
    const auto box_in_plane = [&](std::size_t part) { return box_of(axes.transpose() * shape_.parts[part].surface); };
    Axis_box of_row = box_in_plane(row[0]);
    double middle = 0;
    bool is_on_ground = false;
    for (std::size_t part : row) {
      of_row = joined(of_row, box_in_plane(part));
      middle += boxes_[part].middle() / double(row.size());
      is_on_ground = is_on_ground || is_on_ground_[part];
    }
    const bool is_above_deck = deck_ != none && is_less(boxes_[deck_].middle(), middle);
    const Eigen::Array3d row_sides = of_row.sides(),
                         most{std::max(frame_thickness * row_sides.x(), frame_allowance * whole_.sides().y()),
                              (1 + frame_reach) * row_sides.y(), (1 + frame_reach) * row_sides.z()};

    std::vector<char> is_in(boxes_.size(), 0);
    for (std::size_t part : row)
      is_in[part] = 1;
    for (std::size_t k = 0; k < result.size(); ++k)
      for (std::size_t part : neighbours_[result[k]]) {
        if (is_in[part] || !may_frame(part, is_on_ground, is_above_deck)) continue;
        const Eigen::Array3d sides = joined(of_row, box_in_plane(part)).sides();
        if (is_less(most.x(), sides.x()) || is_less(most.y(), sides.y()) || is_less(most.z(), sides.z())) continue;
        is_in[part] = 1;
        result.push_back(part);
      }
    std::sort(result.begin(), result.end());
    return result;
  }

  // Normal, level and rising axis of an upright row's plane; zero if it is not upright, or not in a plane.
  Eigen::Matrix3d plane_of(const std::vector<std::size_t>& row) const
  {
    Eigen::Index n = 0;
    for (std::size_t part : row)
      n += shape_.parts[part].surface.cols();
    Points points(3, n);
    for (std::size_t part : row) {
      const Points& surface = shape_.parts[part].surface;
      points.middleCols(points.cols() - n, surface.cols()) = surface;
      n -= surface.cols();
    }
    points.colwise() -= points.rowwise().mean().eval();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(points * points.transpose() / double(points.cols()));
    const Eigen::Vector3d spread = eigen.eigenvalues().cwiseMax(0).cwiseSqrt(), normal = eigen.eigenvectors().col(0);
    Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();
    if (is_less(std::abs(normal.y()), upright_limit) && is_less(planarity * spread[0], spread[1])) {
      const Eigen::Vector3d level = normal.cross(Eigen::Vector3d::UnitY()).normalized();
      axes << normal, level, normal.cross(level);
    }
    return axes;
  }

  // Panels that share parts are one.
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
    const double depth = side_depth * whole_.sides()[axis];
    return !is_less(depth, boxes_[part].sides()[axis]) && !is_less(depth, std::abs(boxes_[part].centre()[axis] - side));
  }

  // By part, whether it is a flat one in this side of the shape, above the deck.
  std::vector<char> parts_in_side(Eigen::Index axis, double side) const
  {
    std::vector<char> result(boxes_.size(), 0);
    for (std::size_t part = 0; part < boxes_.size(); ++part)
      result[part] = part != deck_ && !is_on_ground_[part] && is_in_side(part, axis, side) &&
                     is_less(boxes_[deck_].low.y(), boxes_[part].middle());
    return result;
  }

  void add_side_panels(const std::vector<std::size_t>& support, std::vector<std::vector<std::size_t>>& panels) const
  {
    for (Eigen::Index axis : {0, 2})
      for (double side : {whole_.low[axis], whole_.high[axis]}) {
        std::vector<char> is_in = parts_in_side(axis, side), may_connect = is_in;
        for (std::size_t part : support)
          may_connect[part] = 1;
        for (std::size_t first = 0; first < boxes_.size(); ++first) {
          if (!is_in[first]) continue;
          std::vector<std::size_t> panel;
          for (std::size_t part : connected(first, [&](std::size_t, std::size_t next) { return may_connect[next]; }))
            if (is_in[part]) {
              panel.push_back(part);
              is_in[part] = 0;
            }
          if (panel.size() > 1) add_panel(std::move(panel), panels);
        }
      }
  }

  // Are the two closed curves of like size, and not around one another?
  bool are_linked(std::size_t part, std::size_t next) const
  {
    if (shape_.parts[next].kind != Sampled_part::Kind::CLOSED_CURVE) return false;
    const double a = boxes_[part].sides().maxCoeff(), b = boxes_[next].sides().maxCoeff();
    const double apart = (boxes_[part].centre() - boxes_[next].centre()).matrix().norm();
    return is_less(std::max(a, b), link_ratio * std::min(a, b)) && is_less(link_offset * std::max(a, b), apart);
  }

  void find_chains()
  {
    is_link_.assign(boxes_.size(), 0);
    for (std::size_t part = 0; part < boxes_.size(); ++part) {
      if (is_link_[part] || shape_.parts[part].kind != Sampled_part::Kind::CLOSED_CURVE) continue;
      std::vector<std::size_t> chain =
          connected(part, [&](std::size_t link, std::size_t next) { return are_linked(link, next); });
      if (chain.size() < whole_group_size) continue;
      for (std::size_t link : chain)
        is_link_[link] = 1;
      chains_.push_back(std::move(chain));
    }
  }

  const Aligned_shape& shape_;
  std::vector<Axis_box> boxes_;
  Axis_box whole_;
  std::vector<char> is_on_ground_;
  std::vector<std::vector<std::size_t>> neighbours_;
  std::size_t deck_;
  std::vector<std::vector<std::size_t>> chains_;
  std::vector<char> is_link_; // by part, whether it is in a chain
};

} // namespace internal

CGAL_SHAPE_CORRESPONDENCE_INLINE Part_assemblies part_assemblies(const Aligned_shape& shape)
{
  return internal::Assembly_finder(shape).run();
}

} // namespace Shape_correspondence
} // namespace CGAL

#endif
