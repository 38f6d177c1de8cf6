// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "shape/Surface_patches.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// A patch, or a union of patches that may be a part.
struct Part_node
{
  static constexpr std::size_t none = std::size_t(-1);

  Surface_moments moments;
  Eigen::AlignedBox3d box;
  std::vector<std::size_t> patches;
  std::vector<std::size_t> shapes;                      ///< `Surface_patch::shape` of each patch, sorted
  std::vector<std::size_t> sheets, components, objects; ///< as in `Surface_patch`, each number once, sorted
  std::array<std::size_t, 2> children{none, none};      ///< indices of nodes
  std::size_t parent = none;                            ///< index of a node
  double affinity = 1;                                  ///< probability that the children are of one part
  double gap = 0;                                       ///< distance between the children

  Point centre = Point::Zero(); ///< centre of the surface
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  Eigen::Vector3d lengths = Eigen::Vector3d::Zero(); ///< roots of the principal variances, the least first
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();

  bool is_leaf() const { return children[0] == none; }
};

/// The number of features of two nodes that may be merged; quarter turns about the up axis do not change them.
constexpr std::size_t merge_feature_count = 53;
using Merge_features = std::array<std::uint8_t, merge_feature_count>;

/// The probability that two nodes are of one part; below 0: they are not merged.
using Merge_affinity = std::function<double(const Part_node&, const Part_node&, const Merge_features&)>;

/// Merges nodes two by two, those of greatest affinity first, beginning with the patches. \return first a leaf for each
/// patch, in their order, then the unions, children before parents. O(n² log n) for n patches
std::vector<Part_node> part_tree(const Surface_patches& surface, const Merge_affinity& affinity);

/// The ascending indices of the nodes of largest total value that hold each patch once. \param values indexed by node
std::vector<std::size_t> best_cut(const std::vector<Part_node>& nodes, const std::vector<double>& values);

/// Writes a row of features, each scaled from its range to a byte, 0 … 254.
class Feature_bytes
{
public:
  explicit Feature_bytes(std::uint8_t* next) : next_(next) {}

  void share(double value);        ///< from 0 to 1
  void root(double share);         ///< from 0 to 1, written as its square root, which resolves small shares better
  void signed_share(double value); ///< from -1 to 1
  void ratio(double value);        ///< from 0 to ∞
  void count(std::size_t n);       ///< up to 255, on a logarithmic scale

  const std::uint8_t* next() const { return next_; }

private:
  std::uint8_t* next_;
};

} // namespace CGAL::Shape_correspondence::internal
