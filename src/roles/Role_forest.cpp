// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "roles/Role_forest.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <ostream>
#include <random>

namespace CGAL::Shape_correspondence::internal {

namespace {

constexpr int tried_features = ROLE_FEATURE_COUNT / 3; // features tried at each split

using Random = std::mt19937_64; // the same numbers on all machines, unlike the distributions of the standard library

// A number from 0 to n - 1; the bias is n / 2^64.
std::size_t random_below(std::size_t n, Random& random) { return std::size_t(random() % n); }

} // namespace

// Grows one tree.
class Role_forest::Builder
{
public:
  Builder(const std::vector<Role_example>& examples, int roles, std::uint64_t seed, std::vector<Node>& nodes)
      : examples_(examples), random_(seed), nodes_(nodes), left_(std::size_t(roles)), right_(std::size_t(roles))
  {
    std::vector<std::uint32_t> all(examples.size());
    std::iota(all.begin(), all.end(), 0);
    grow(all.data(), all.data() + all.size());
  }

private:
  using Iterator = std::uint32_t*;

  struct Split
  {
    int feature = -1;
    int value = 0;
    double purity = -1; // Σ (weight of a role)² / weight of all, summed over both sides
  };

  const Role_example& example(std::uint32_t index) const { return examples_[index]; }

  bool is_pure(Iterator begin, Iterator end) const
  {
    return std::all_of(begin, end, [&](std::uint32_t e) { return example(e).role == example(*begin).role; });
  }

  std::uint8_t heaviest_role(Iterator begin, Iterator end)
  {
    std::fill(left_.begin(), left_.end(), 0.);
    for (Iterator e = begin; e != end; ++e)
      left_[example(*e).role] += example(*e).weight;
    return std::uint8_t(std::max_element(left_.begin(), left_.end()) - left_.begin());
  }

  static double purity(const std::vector<double>& weights)
  {
    double sum = 0, squares = 0;
    for (double w : weights) {
      sum += w;
      squares += w * w;
    }
    return sum > 0 ? squares / sum : 0;
  }

  double purity(Iterator begin, Iterator end, int feature, int value)
  {
    std::fill(left_.begin(), left_.end(), 0.);
    std::fill(right_.begin(), right_.end(), 0.);
    for (Iterator e = begin; e != end; ++e) {
      const Role_example& x = example(*e);
      (x.features[std::size_t(feature)] <= value ? left_ : right_)[x.role] += x.weight;
    }
    return purity(left_) + purity(right_);
  }

  // The best split by a few features that differ among the examples, each at a random threshold; none if none differs.
  Split best_split(Iterator begin, Iterator end)
  {
    std::array<int, ROLE_FEATURE_COUNT> features;
    std::iota(features.begin(), features.end(), 0);
    Split best;
    int tried = 0;
    for (std::size_t left = features.size(); left > 0 && tried < tried_features; --left) {
      std::swap(features[random_below(left, random_)], features[left - 1]);
      const int feature = features[left - 1];
      const auto [least, most] = std::minmax_element(begin, end, [&](std::uint32_t a, std::uint32_t b) {
        return example(a).features[std::size_t(feature)] < example(b).features[std::size_t(feature)];
      });
      const int low = example(*least).features[std::size_t(feature)],
                high = example(*most).features[std::size_t(feature)];
      if (low == high) continue;
      ++tried;
      const int value = low + int(random_below(std::size_t(high - low), random_));
      const double p = purity(begin, end, feature, value);
      if (p > best.purity) best = {feature, value, p};
    }
    return best;
  }

  void grow(Iterator begin, Iterator end)
  {
    const std::size_t node = nodes_.size();
    nodes_.push_back({leaf, 0});
    const Split split = is_pure(begin, end) ? Split() : best_split(begin, end);
    if (split.feature < 0) {
      nodes_[node].value = heaviest_role(begin, end);
      return;
    }
    const Iterator middle = std::partition(
        begin, end, [&](std::uint32_t e) { return example(e).features[std::size_t(split.feature)] <= split.value; });
    grow(begin, middle);
    nodes_[node] = {std::uint8_t(split.feature), std::uint8_t(split.value), std::uint32_t(nodes_.size())};
    grow(middle, end);
  }

  const std::vector<Role_example>& examples_;
  Random random_;
  std::vector<Node>& nodes_;
  std::vector<double> left_, right_; // weights of the examples on each side of a split, by role
};

std::vector<Role_example> Role_forest::seen(std::vector<Role_example> examples,
                                            const std::vector<std::vector<Role_example>>& drawn, std::size_t count,
                                            std::uint64_t seed)
{
  std::vector<std::size_t> order(drawn.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  Random random(seed);
  for (std::size_t i = 0; i < std::min(count, order.size()); ++i) {
    std::swap(order[i], order[i + random_below(order.size() - i, random)]);
    examples.insert(examples.end(), drawn[order[i]].begin(), drawn[order[i]].end());
  }
  std::sort(examples.begin(), examples.end());
  return examples;
}

Role_forest::Role_forest(const std::vector<Role_example>& examples, int trees, std::uint64_t seed,
                         const std::vector<std::vector<Role_example>>& drawn, std::size_t drawn_per_tree)
    : Role_forest()
{
  for (std::uint64_t tree = 0; tree < std::uint64_t(trees); ++tree) {
    const std::vector<Role_example> all = seen(examples, drawn, drawn_per_tree, seed + tree);
    int roles = 0;
    for (const Role_example& example : all)
      roles = std::max(roles, example.role + 1);
    trees_->roots.push_back(std::uint32_t(trees_->nodes.size()));
    Builder(all, roles, seed + tree, trees_->nodes);
  }
}

Eigen::MatrixXi Role_forest::votes(const Role_features& parts, int roles) const
{
  const std::vector<Node>& nodes = trees().nodes;
  Eigen::MatrixXi result = Eigen::MatrixXi::Zero(parts.rows(), roles);
  for (const std::uint32_t root : trees().roots) // a tree stays in the cache for all parts
    for (Eigen::Index part = 0; part < parts.rows(); ++part) {
      const std::uint8_t* const features = &parts(part, 0);
      const Node* node = &nodes[root];
      while (node->feature != leaf)
        node = features[node->feature] <= node->value ? node + 1 : &nodes[node->right];
      ++result(part, node->value);
    }
  return result;
}

void Role_forest::write(std::ostream& out) const
{
  for (const Node& node : trees().nodes) {
    if (node.feature == leaf && node.value < roles_in_one_byte) {
      out.put(char(ROLE_FEATURE_COUNT + node.value));
      continue;
    }
    out.put(char(node.feature));
    out.put(char(node.value));
  }
}

std::optional<Role_forest::Node> Role_forest::taken_node(Stored_bytes& bytes)
{
  if (bytes.size() == 0) return std::nullopt;
  const std::uint8_t first = *bytes.next++;
  if (first >= ROLE_FEATURE_COUNT && first < leaf) return Node{leaf, std::uint8_t(first - ROLE_FEATURE_COUNT)};
  if (bytes.size() == 0) return std::nullopt;
  return Node{first, *bytes.next++};
}

bool Role_forest::read(Stored_bytes& bytes, int trees, int roles)
{
  const std::uint8_t* const begin = bytes.next;
  bool is_right = true;
  for (int tree = 0; tree < trees; ++tree)
    for (std::size_t to_come = 1; to_come > 0;) { // nodes of the tree that are left to read
      const std::optional<Node> node = taken_node(bytes);
      if (!node) return false;
      is_right &= node->feature != leaf || node->value < roles;
      to_come += node->feature == leaf ? std::size_t(-1) : 1;
    }
  trees_ = std::make_shared<Trees>();
  trees_->stored = {begin, bytes.next, bytes.owner};
  return is_right;
}

void Role_forest::make_trees(Trees& trees)
{
  std::vector<std::uint32_t> parents; // parents whose right children are to come
  bool is_root = true;
  for (Stored_bytes stored = trees.stored; const std::optional<Node> taken = taken_node(stored);) {
    const auto node = std::uint32_t(trees.nodes.size());
    if (is_root) trees.roots.push_back(node);
    trees.nodes.push_back(*taken);
    is_root = false;
    if (taken->feature != leaf) {
      parents.push_back(node);
    } else if (parents.empty()) {
      is_root = true;
    } else {
      trees.nodes[parents.back()].right = node + 1;
      parents.pop_back();
    }
  }
}

const Role_forest::Trees& Role_forest::trees() const
{
  trees_->are_made([this] { make_trees(*trees_); });
  return *trees_;
}

} // namespace CGAL::Shape_correspondence::internal
