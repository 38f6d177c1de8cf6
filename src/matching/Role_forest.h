// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "matching/role_features.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <iosfwd>
#include <tuple>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

// A labelled part. `role`: index of what trees vote for.
struct Role_example
{
  std::array<std::uint8_t, ROLE_FEATURE_COUNT> features;
  std::uint8_t role;
  double weight;

  friend bool operator<(const Role_example& a, const Role_example& b)
  {
    return std::tie(a.features, a.role, a.weight) < std::tie(b.features, b.role, b.weight);
  }
};

// Extremely randomised trees (Geurts, Ernst, Wehenkel 2006): each split is the best of thresholds drawn for a third of
// the features, leaves are pure as far as the features tell. A tree votes for one role.
class Role_forest
{
public:
  Role_forest() = default;
  // \pre the examples are sorted, and there are some
  Role_forest(const std::vector<Role_example>& examples, int trees, std::uint64_t seed);

  int number_of_trees() const { return int(roots_.size()); }
  // How many trees vote for each role: part × role.
  Eigen::MatrixXi votes(const Role_features& parts, int roles) const;

  void write(std::ostream& out) const;
  // \return false if what is read is no forest for so many roles
  bool read(std::streambuf& in, int trees, int roles);

private:
  // In the order root, left subtree, right subtree.
  struct Node
  {
    std::uint8_t feature;    // `leaf` of a leaf
    std::uint8_t value;      // parts with at most this much of the feature go left; of a leaf, the role
    std::uint32_t right = 0; // index of the right child; the left one is next
  };
  static constexpr std::uint8_t leaf = 255;

  class Builder;

  bool read_subtree(std::streambuf& in, int roles, int depth);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> roots_;
};

} // namespace CGAL::Shape_correspondence::internal
