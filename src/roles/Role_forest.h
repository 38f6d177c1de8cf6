// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/Once.h"
#include "roles/Stored_bytes.h"
#include "roles/role_features.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <iosfwd>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

// A labelled part: its features, the index of the role that trees vote for, and its weight in the training.
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
// the features; a leaf has one role unless equal features have several. Copies of a forest share their trees.
class Role_forest
{
public:
  Role_forest() : trees_(std::make_shared<Trees>()) {}
  // \param drawn sets of further examples; each tree sees `drawn_per_tree` of them, drawn at random
  // \pre examples and sets are sorted, and there is an example
  Role_forest(const std::vector<Role_example>& examples, int trees, std::uint64_t seed,
              const std::vector<std::vector<Role_example>>& drawn = {}, std::size_t drawn_per_tree = 0);

  // The number of trees that vote for each role: part × role.
  Eigen::MatrixXi votes(const Role_features& parts, int roles) const;

  void write(std::ostream& out) const;
  // Checks all nodes; trees are built of them when votes are first asked for. \return false if the bytes are not a
  // forest of this number of trees and at most this number of roles
  bool read(Stored_bytes& bytes, int trees, int roles);

private:
  struct Node
  {
    std::uint8_t feature;    // index; `leaf` at a leaf
    std::uint8_t value;      // threshold: up to it, parts go left; at a leaf, the role
    std::uint32_t right = 0; // index of the right child; the left one is next
  };
  static constexpr std::uint8_t leaf = 255; // marks a leaf in place of a feature
  // A node has two bytes in a file, feature and value; but a leaf of one of the first roles has one, the number of
  // features plus the role.
  static constexpr int roles_in_one_byte = leaf - ROLE_FEATURE_COUNT;

  struct Trees
  {
    std::vector<Node> nodes; // those of a tree in the order root, left subtree, right subtree
    std::vector<std::uint32_t> roots;
    Stored_bytes stored{}; // nodes that were read; none if the trees were grown
    Once are_made;         // whether `nodes` and `roots` are made, of `stored`
  };

  class Builder;

  // The examples that a tree sees.
  static std::vector<Role_example> seen(std::vector<Role_example> examples,
                                        const std::vector<std::vector<Role_example>>& drawn, std::size_t count,
                                        std::uint64_t seed);
  // Reads the next node; none if the bytes end before.
  static std::optional<Node> taken_node(Stored_bytes& bytes);
  static void make_trees(Trees& trees);
  const Trees& trees() const;

  std::shared_ptr<Trees> trees_;
};

} // namespace CGAL::Shape_correspondence::internal
