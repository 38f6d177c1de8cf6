// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "shape/triangle_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {
namespace contacts {

using Box = Eigen::AlignedBox3d;

inline Box box_of(const Triangle& t)
{
  return Box(t[0].cwiseMin(t[1]).cwiseMin(t[2]), t[0].cwiseMax(t[1]).cwiseMax(t[2]));
}

/// Squared distance of a point from a box: `box.squaredExteriorDistance(p)` without branches.
inline double squared_distance(const Box& box, const Point& p)
{
  return (box.min() - p).cwiseMax(p - box.max()).cwiseMax(0).squaredNorm();
}

/// A bounding volume hierarchy of triangles. Written here since distances between two surfaces need two trees that are
/// traversed at once: CGAL's AABB_tree finds the nearest point of one surface, which for all vertices is slower and
/// misses pairs of points within edges (`benchmark_parts` compares them).
class Triangle_tree
{
public:
  explicit Triangle_tree(std::vector<Triangle> triangles) : triangles_(std::move(triangles)), given_(triangles_.size())
  {
    nodes_.reserve(2 * triangles_.size() + 1);
    std::iota(given_.begin(), given_.end(), std::size_t(0));
    build(0, triangles_.size());
    std::vector<Triangle> in_order;
    in_order.reserve(triangles_.size());
    for (std::size_t t : given_)
      in_order.push_back(triangles_[t]);
    triangles_.swap(in_order);
  }

  /// Moves the triangles and refits the boxes; `place(t)` is the new place of the triangle given with index t. Faster
  /// than a new tree, and as good where neighbours stay neighbours.
  template <typename Place>
  void move(const Place& place)
  {
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      triangles_[t] = place(given_[t]);
    for (std::size_t node = nodes_.size(); node-- > 0;) { // children come after their parents
      Box& box = nodes_[node].box;
      box.setEmpty();
      if (!is_leaf(node)) {
        box = nodes_[node + 1].box.merged(nodes_[nodes_[node].right].box);
        continue;
      }
      for (std::size_t t = nodes_[node].begin; t < nodes_[node].end; ++t)
        box.extend(box_of(triangles_[t]));
    }
  }

  /// The triangles, in the order of the tree.
  const std::vector<Triangle>& triangles() const { return triangles_; }
  /// The index with which a triangle of the tree was given.
  std::size_t given_number(std::size_t t) const { return given_[t]; }
  const Box& box() const { return nodes_[0].box; }

  /// The point nearest to `p`, if it is nearer than the root of `squared`, which is set to the squared distance.
  /// \param triangle set to the index in the tree of the triangle that it is on
  bool improve_nearest(const Point& p, Point& nearest, double& squared, std::size_t& triangle) const
  {
    return improve_nearest(0, p, nearest, squared, triangle);
  }

  /// The point nearest to `p`.
  /// \param triangle index of a triangle that is likely to be near, a start that saves time; set to the one that
  /// the point is on
  Point nearest(const Point& p, std::size_t& triangle) const
  {
    constexpr double rounding = 1 + 1e-9, some = 1e-30; // enlarge the start's distance, so that it is found as well
    double squared = (nearest_on_triangle(p, triangles_[triangle]) - p).squaredNorm() * rounding + some;
    Point result = p;
    improve_nearest(p, result, squared, triangle);
    return result;
  }

  /// Replaces `best` by the closest points of two surfaces if these are closer.
  void improve_closest(const Triangle_tree& other, Closest_pair& best) const
  {
    Closest_search search(best, 0, 1);
    improve_closest(0, other, 0, search);
  }

  /// A point of each surface, nearly the closest: if their distance d is more than `enough`, no other pair is closer
  /// than d - (d - enough) / 10. For faces that lie flat on each other, much faster than to find the closest points.
  Closest_pair nearly_closest(const Triangle_tree& other, double enough = 0) const
  {
    Closest_pair best;
    Closest_search search(best, enough, nearly);
    improve_closest(0, other, 0, search);
    return best;
  }

  /// Whether two surfaces are within the root of `squared` of each other.
  bool is_within(const Triangle_tree& other, double squared) const { return is_within(0, other, 0, squared); }

  /// Whether the distance of `p` from the surface is less than the root of `squared`.
  bool is_near(const Point& p, double squared) const
  {
    return any_triangle([&](const Box& box) { return contacts::squared_distance(box, p); },
                        [&](const Triangle& t) { return (nearest_on_triangle(p, t) - p).squaredNorm() < squared; },
                        squared);
  }

  /// For every triangle, whether it is within the root of `squared` of a triangle of the other tree.
  std::vector<char> near_triangles(const Triangle_tree& other, double squared) const
  {
    std::vector<char> result(triangles_.size(), 0);
    mark_near(0, other, squared, result);
    return result;
  }

  /// The number of triangles that a ray crosses.
  int crossings(const Point& from, const Point& direction) const { return crossings(0, from, direction); }

private:
  static constexpr std::size_t leaf_size = 2; ///< greatest number of triangles of a leaf
  static constexpr double nearly = 0.9;       ///< the `share` of `nearly_closest()`

  struct Node
  {
    Box box;
    std::size_t begin, end; ///< range of its triangles
    std::size_t right = 0;  ///< index of the second child, 0 for a leaf; the first child is the next node
  };

  bool is_leaf(std::size_t node) const { return nodes_[node].right == 0; }

  /// Splits at the median of the triangles' centroids along the longest side.
  void build(std::size_t begin, std::size_t end)
  {
    const std::size_t node = nodes_.size();
    nodes_.push_back({{}, begin, end});
    Box middles;
    for (std::size_t t = begin; t < end; ++t) {
      nodes_[node].box.extend(box_of(triangles_[given_[t]]));
      middles.extend(middle(triangles_[given_[t]]));
    }
    const auto first = given_.begin();
    if (end - begin <= leaf_size) {
      std::sort(first + std::ptrdiff_t(begin), first + std::ptrdiff_t(end));
      return;
    }
    Eigen::Index axis;
    middles.sizes().maxCoeff(&axis);
    const std::size_t half = (begin + end) / 2;
    // Ties are broken, so that the tree does not depend on the standard library
    const auto place = [&](std::size_t t) { return std::pair(middle(triangles_[t])[axis], t); };
    std::nth_element(first + std::ptrdiff_t(begin), first + std::ptrdiff_t(half), first + std::ptrdiff_t(end),
                     [&](std::size_t a, std::size_t b) { return place(a) < place(b); });
    build(begin, half);
    nodes_[node].right = nodes_.size();
    build(half, end);
  }

  static Point middle(const Triangle& t) { return t[0] + t[1] + t[2]; } // three times the centroid

  bool improve_nearest(std::size_t node, const Point& p, Point& nearest, double& squared, std::size_t& triangle) const
  {
    bool improved = false;
    if (is_leaf(node)) {
      for (std::size_t t = nodes_[node].begin; t < nodes_[node].end; ++t) {
        const Point candidate = nearest_on_triangle(p, triangles_[t]);
        if ((candidate - p).squaredNorm() >= squared) continue;
        squared = (candidate - p).squaredNorm();
        nearest = candidate;
        triangle = t;
        improved = true;
      }
      return improved;
    }
    std::array<std::pair<double, std::size_t>, 2> children;
    children[0] = {contacts::squared_distance(nodes_[node + 1].box, p), node + 1};
    children[1] = {contacts::squared_distance(nodes_[nodes_[node].right].box, p), nodes_[node].right};
    if (children[1].first < children[0].first) std::swap(children[0], children[1]);
    for (const auto& [bound, child] : children)
      if (bound < squared) improved = improve_nearest(child, p, nearest, squared, triangle) || improved;
    return improved;
  }

  /// The pairs of nodes that a pair of nodes is split into: the larger node is replaced by its children.
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

  /// A search for the closest points of two trees.
  class Closest_search
  {
  public:
    /// \param best closest points so far
    /// \param enough distance at which the search may end
    /// \param share points count as closer only if their distance less `enough` is at most this share of the best one's
    Closest_search(Closest_pair& best, double enough, double share) : best_(best), enough_(enough), share_(share)
    {
      set_limit();
    }

    /// The squared distance from which on a pair of nodes is left out.
    double limit() const { return limit_; }

    void compare(const Triangle_tree& a, std::size_t t, const Triangle_tree& b, std::size_t u)
    {
      const Triangle &first = a.triangles_[t], &second = b.triangles_[u];
      if (box_of(first).squaredExteriorDistance(box_of(second)) >= limit_) return;
      const double before = best_.squared;
      improve_by_triangles(first, second, best_, limit_);
      if (best_.squared < before) set_limit();
    }

  private:
    void set_limit()
    {
      const double distance = std::sqrt(best_.squared);
      const double share = share_ + (1 - share_) * enough_ / distance;
      limit_ = distance > enough_ ? share * share * best_.squared : 0;
    }

    Closest_pair& best_;
    double enough_, share_, limit_ = 0;
  };

  void improve_closest(std::size_t node, const Triangle_tree& other, std::size_t other_node,
                       Closest_search& search) const
  {
    if (is_leaf(node) && other.is_leaf(other_node)) {
      for (std::size_t t = nodes_[node].begin; t < nodes_[node].end; ++t)
        for (std::size_t u = other.nodes_[other_node].begin; u < other.nodes_[other_node].end; ++u)
          search.compare(*this, t, other, u);
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
      if (bounds[i] < search.limit()) improve_closest(pairs[i].first, other, pairs[i].second, search);
  }

  bool is_within(std::size_t node, const Triangle_tree& other, std::size_t other_node, double squared) const
  {
    if (squared_distance(node, other, other_node) > squared) return false;
    if (is_leaf(node) && other.is_leaf(other_node)) {
      for (std::size_t t = nodes_[node].begin; t < nodes_[node].end; ++t)
        for (std::size_t u = other.nodes_[other_node].begin; u < other.nodes_[other_node].end; ++u)
          if (box_of(triangles_[t]).squaredExteriorDistance(box_of(other.triangles_[u])) <= squared &&
              are_within(triangles_[t], other.triangles_[u], squared))
            return true;
      return false;
    }
    const auto pairs = split(node, other, other_node);
    const bool second_is_nearer = squared_distance(pairs[1].first, other, pairs[1].second) <
                                  squared_distance(pairs[0].first, other, pairs[0].second);
    const auto& near = pairs[second_is_nearer ? 1 : 0];
    const auto& far = pairs[second_is_nearer ? 0 : 1];
    return is_within(near.first, other, near.second, squared) || is_within(far.first, other, far.second, squared);
  }

  // Whether any triangle passes a test; skips nodes beyond the root of `squared`, and visits the nearer child first.
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

  void mark_near(std::size_t node, const Triangle_tree& other, double squared, std::vector<char>& result) const
  {
    if (nodes_[node].box.squaredExteriorDistance(other.box()) > squared) return;
    if (!is_leaf(node)) {
      mark_near(node + 1, other, squared, result);
      mark_near(nodes_[node].right, other, squared, result);
      return;
    }
    for (std::size_t t = nodes_[node].begin; t < nodes_[node].end; ++t) {
      const Box box = box_of(triangles_[t]);
      result[t] = other.any_triangle([&](const Box& node_box) { return node_box.squaredExteriorDistance(box); },
                                     [&](const Triangle& u) {
                                       return box.squaredExteriorDistance(box_of(u)) <= squared &&
                                              are_within(triangles_[t], u, squared);
                                     },
                                     squared);
    }
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

  /// Whether a ray meets a box. \pre no coordinate of the direction is 0
  static bool is_crossed(const Box& box, const Point& from, const Point& direction)
  {
    const Eigen::Array3d a = (box.min() - from).array() / direction.array();
    const Eigen::Array3d b = (box.max() - from).array() / direction.array();
    return std::max(0.0, a.min(b).maxCoeff()) <= a.max(b).minCoeff();
  }

  std::vector<Triangle> triangles_;
  std::vector<std::size_t> given_; ///< indexed by triangle of the tree: the index with which it was given
  std::vector<Node> nodes_;
};

} // namespace contacts

inline contacts::Triangle_tree tree_of(const Points& points, const Eigen::Matrix3Xi& triangles)
{
  return contacts::Triangle_tree(triangles_of(points, triangles));
}

} // namespace CGAL::Shape_correspondence::internal
