// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_INTERNAL_CONTACTS_TRIANGLE_TREE_H
#define CGAL_SHAPE_CORRESPONDENCE_INTERNAL_CONTACTS_TRIANGLE_TREE_H

#include <CGAL/Shape_correspondence/internal/contacts/triangle_distance.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {
namespace contacts {

using Box = Eigen::AlignedBox3d;

inline Box box_of(const Triangle& t)
{
  return Box(t[0].cwiseMin(t[1]).cwiseMin(t[2]), t[0].cwiseMax(t[1]).cwiseMax(t[2]));
}

/// A tree of boxes around triangles, for distances between whole surfaces, which CGAL's AABB tree does not have.
class Triangle_tree
{
public:
  explicit Triangle_tree(std::vector<Triangle> triangles) : triangles_(std::move(triangles))
  {
    nodes_.reserve(2 * triangles_.size() + 1);
    build(0, triangles_.size());
  }

  /// The triangles, in the order of the tree.
  const std::vector<Triangle>& triangles() const { return triangles_; }
  const Box& box() const { return nodes_[0].box; }

  /// The closest points of two surfaces, where they are closer than `best`.
  void improve_closest(const Triangle_tree& other, Closest_pair& best) const { improve_closest(0, other, 0, best); }

  /// Whether `p` is nearer than the root of `squared`.
  bool is_near(const Point& p, double squared) const
  {
    return any_triangle(
        [&](const Box& box) { return box.squaredExteriorDistance(p); },
        [&](const Triangle& t) { return (nearest_on_triangle(p, t) - p).squaredNorm() < squared; }, squared);
  }

  /// For every triangle, whether it is within the root of `squared` of a triangle of the other tree.
  std::vector<char> near_triangles(const Triangle_tree& other, double squared) const
  {
    std::vector<char> result(triangles_.size(), 0);
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      const Box box = box_of(triangles_[t]);
      result[t] = other.any_triangle(
          [&](const Box& node) { return node.squaredExteriorDistance(box); },
          [&](const Triangle& u) {
            return box.squaredExteriorDistance(box_of(u)) <= squared && are_within(triangles_[t], u, squared);
          },
          squared);
    }
    return result;
  }

  /// The number of triangles that a ray goes through.
  int crossings(const Point& from, const Point& direction) const { return crossings(0, from, direction); }

private:
  static constexpr std::size_t LEAF = 2;

  struct Node
  {
    Box box;
    std::size_t begin, end; ///< triangles
    std::size_t right = 0;  ///< the second child; the first comes next; 0 for a leaf
  };

  bool is_leaf(std::size_t node) const { return nodes_[node].right == 0; }

  /// Splits at the median of the middles along the longest side.
  void build(std::size_t begin, std::size_t end)
  {
    const std::size_t node = nodes_.size();
    nodes_.push_back({{}, begin, end});
    Box middles;
    for (std::size_t t = begin; t < end; ++t) {
      nodes_[node].box.extend(box_of(triangles_[t]));
      middles.extend(middle(triangles_[t]));
    }
    if (end - begin <= LEAF) return;
    Eigen::Index axis;
    middles.sizes().maxCoeff(&axis);
    const std::size_t half = (begin + end) / 2;
    const auto first = triangles_.begin();
    std::nth_element(first + begin, first + half, first + end,
                     [&](const Triangle& a, const Triangle& b) { return middle(a)[axis] < middle(b)[axis]; });
    build(begin, half);
    nodes_[node].right = nodes_.size();
    build(half, end);
  }

  static Point middle(const Triangle& t) { return t[0] + t[1] + t[2]; } // three times the middle

  /// The pairs of nodes that a pair is split into: the larger of the two is.
  std::array<std::pair<std::size_t, std::size_t>, 2> split(std::size_t node, const Triangle_tree& other,
                                                           std::size_t other_node) const
  {
    const Node &a = nodes_[node], &b = other.nodes_[other_node];
    const bool split_own =
        b.right == 0 || (a.right != 0 && a.box.diagonal().squaredNorm() > b.box.diagonal().squaredNorm());
    if (split_own) return {{{node + 1, other_node}, {a.right, other_node}}};
    return {{{node, other_node + 1}, {node, b.right}}};
  }

  double squared_distance(std::size_t node, const Triangle_tree& other, std::size_t other_node) const
  {
    return nodes_[node].box.squaredExteriorDistance(other.nodes_[other_node].box);
  }

  void improve_closest(std::size_t node, const Triangle_tree& other, std::size_t other_node, Closest_pair& best) const
  {
    if (is_leaf(node) && other.is_leaf(other_node)) {
      for (std::size_t t = nodes_[node].begin; t < nodes_[node].end; ++t)
        for (std::size_t u = other.nodes_[other_node].begin; u < other.nodes_[other_node].end; ++u)
          if (box_of(triangles_[t]).squaredExteriorDistance(box_of(other.triangles_[u])) < best.squared)
            improve_by_triangles(triangles_[t], other.triangles_[u], best);
      return;
    }
    auto pairs = split(node, other, other_node);
    std::array<double, 2> bounds;
    for (int i = 0; i < 2; ++i)
      bounds[i] = squared_distance(pairs[i].first, other, pairs[i].second);
    if (bounds[1] < bounds[0]) {
      std::swap(pairs[0], pairs[1]);
      std::swap(bounds[0], bounds[1]);
    }
    for (int i = 0; i < 2; ++i)
      if (bounds[i] < best.squared) improve_closest(pairs[i].first, other, pairs[i].second, best);
  }

  // Whether a triangle passes a test; nodes farther than the root of `squared` have none. The nearer node first.
  template <typename SquaredDistance, typename Test>
  bool any_triangle(const SquaredDistance& squared_distance, const Test& test, double squared,
                    std::size_t node = 0) const
  {
    if (is_leaf(node))
      return std::any_of(triangles_.begin() + nodes_[node].begin, triangles_.begin() + nodes_[node].end, test);
    std::array<std::pair<double, std::size_t>, 2> children;
    children[0] = {squared_distance(nodes_[node + 1].box), node + 1};
    children[1] = {squared_distance(nodes_[nodes_[node].right].box), nodes_[node].right};
    if (children[1].first < children[0].first) std::swap(children[0], children[1]);
    for (const auto& [bound, child] : children)
      if (bound <= squared && any_triangle(squared_distance, test, squared, child)) return true;
    return false;
  }

  int crossings(std::size_t node, const Point& from, const Point& direction) const
  {
    if (!is_crossed(nodes_[node].box, from, direction)) return 0;
    if (!is_leaf(node)) return crossings(node + 1, from, direction) + crossings(nodes_[node].right, from, direction);
    int result = 0;
    for (std::size_t t = nodes_[node].begin; t < nodes_[node].end; ++t) {
      const std::optional<double> at = crossing(from, direction, triangles_[t]);
      result += at && *at > 0;
    }
    return result;
  }

  /// \pre no coordinate of the direction is 0
  static bool is_crossed(const Box& box, const Point& from, const Point& direction)
  {
    const Eigen::Array3d a = (box.min() - from).array() / direction.array();
    const Eigen::Array3d b = (box.max() - from).array() / direction.array();
    return std::max(0.0, a.min(b).maxCoeff()) <= a.max(b).minCoeff();
  }

  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
};

} // namespace contacts
} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_INTERNAL_CONTACTS_TRIANGLE_TREE_H
