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
// the features, leaves are pure as far as the features tell. A tree votes for one role. Copies share their trees.
class Role_forest
{
public:
  Role_forest() : trees_(std::make_shared<Trees>()) {}
  // \pre the examples are sorted, and there are some
  Role_forest(const std::vector<Role_example>& examples, int trees, std::uint64_t seed);

  // How many trees vote for each role: part × role.
  Eigen::MatrixXi votes(const Role_features& parts, int roles) const;

  void write(std::ostream& out) const;
  // Verifies all nodes, but makes trees of them only when somebody asks for votes, which most forests of a model are
  // never asked for. \return false if what is read is no forest for so many roles
  bool read(Stored_bytes& bytes, int trees, int roles);

private:
  struct Node
  {
    std::uint8_t feature;    // `leaf` of a leaf
    std::uint8_t value;      // parts with at most this much of the feature go left; of a leaf, the role
    std::uint32_t right = 0; // index of the right child; the left one is next
  };
  static constexpr std::uint8_t leaf = 255;
  static constexpr std::size_t node_size = 2; // bytes in a file: feature and value

  struct Trees
  {
    std::vector<Node> nodes; // in the order root, left subtree, right subtree
    std::vector<std::uint32_t> roots;
    Stored_bytes stored{}; // nodes that were read; none if the trees were grown
    Once are_made;         // of what is stored
  };

  class Builder;

  static void make_trees(Trees& trees);
  const Trees& trees() const;

  std::shared_ptr<Trees> trees_;
};

} // namespace CGAL::Shape_correspondence::internal
