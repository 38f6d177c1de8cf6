// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "roles/Stored_bytes.h"

#include <Eigen/Core>

#include <cstdint>
#include <iosfwd>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

// Features in bytes, one row for each example.
using Byte_rows = Eigen::Array<std::uint8_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

struct Boosting_options
{
  int trees = 150;
  int leaves = 16;                // number of leaves of a tree
  double rate = 0.1;              // learning rate: factor of the values of a tree
  double least_weight = 5;        // least sum of the weights of the examples of a leaf; the mean weight is 1
  double share_of_features = 0.5; // share of the features that is tried at each split
  std::uint64_t seed = 1;
};

// The logit of a probability as a sum of regression trees, each grown on the gradient of the logistic loss (Friedman
// 2001), with bytes as thresholds.
class Boosted_trees
{
public:
  Boosted_trees() = default;
  // Learns from examples. \param targets probabilities to predict \param weights of the examples
  Boosted_trees(const Byte_rows& rows, const std::vector<double>& targets, const std::vector<double>& weights,
                const Boosting_options& options);

  double logit(const std::uint8_t* features) const;
  double probability(const std::uint8_t* features) const;
  bool is_empty() const { return nodes_.empty(); }

  void write(std::ostream& out) const;
  // Reads what `write()` has written. \return false if the bytes are not trees for this number of features
  bool read(Stored_bytes& bytes, int features);

private:
  static constexpr std::uint8_t leaf = 255; // marks a leaf in place of a feature

  struct Node
  {
    std::uint8_t feature = leaf;
    std::uint8_t value = 0;  // threshold: examples up to it go left, to the next node
    std::uint16_t right = 0; // offset of the right child from this node
    float logit = 0;         // value of a leaf; added up over the trees
  };

  class Builder;

  float base_ = 0; // logit to which the trees are added
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> roots_;
};

} // namespace CGAL::Shape_correspondence::internal
