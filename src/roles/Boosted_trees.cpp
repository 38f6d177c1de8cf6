// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "roles/Boosted_trees.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <ostream>
#include <random>

namespace CGAL::Shape_correspondence::internal {

namespace {

constexpr double ridge = 1;               // added to the sum of curvatures of a leaf (regularization)
constexpr double logit_unit = 1. / 4096;  // unit of logits in a file
constexpr double largest_logit = 7.9;     // limit of the absolute logit of a leaf
constexpr std::size_t most_nodes = 65535; // limit of the offset of a child, which has 16 bits

double logistic(double logit) { return 1 / (1 + std::exp(-logit)); }

} // namespace

// Grows trees one after the other.
class Boosted_trees::Builder
{
public:
  Builder(const Byte_rows& rows, const std::vector<double>& targets, const std::vector<double>& weights,
          const Boosting_options& options, Boosted_trees& result)
      : rows_(rows), options_(options), result_(result), random_(options.seed)
  {
    const double mean = std::accumulate(weights.begin(), weights.end(), 0.) / double(weights.size());
    double sum = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      weights_.push_back(weights[i] / mean);
      sum += weights_[i] * targets[i];
    }
    const double share = std::clamp(sum / double(weights.size()), 1e-3, 1 - 1e-3);
    result.base_ = float(std::round(std::log(share / (1 - share)) / logit_unit) * logit_unit);
    logits_.assign(weights.size(), double(result.base_));
    gradients_.resize(weights.size());
    curvatures_.resize(weights.size());
    for (int tree = 0; tree < options.trees; ++tree) {
      for (std::size_t i = 0; i < targets.size(); ++i) {
        const double p = logistic(logits_[i]);
        gradients_[i] = weights_[i] * (targets[i] - p);
        curvatures_[i] = weights_[i] * std::max(p * (1 - p), 1e-6);
      }
      grow();
    }
  }

private:
  using Indices = std::vector<std::uint32_t>;

  struct Sum
  {
    double gradient = 0, curvature = 0, weight = 0;
    double gain() const { return gradient * gradient / (curvature + ridge); }
    Sum operator-(const Sum& other) const
    {
      return {gradient - other.gradient, curvature - other.curvature, weight - other.weight};
    }
    void operator+=(const Sum& other)
    {
      gradient += other.gradient;
      curvature += other.curvature;
      weight += other.weight;
    }
  };

  // A node of the tree that grows. Its best split sends examples with at most `value` of `feature` to the left.
  struct Growing
  {
    Indices examples;
    Sum sum;
    int feature = -1; // -1: there is no split
    int value = 0;
    double gain = 0;           // gain of the best split
    int left = -1, right = -1; // indices of the children; -1: not split yet
  };

  void find_split(Growing& node) const
  {
    for (int feature : features_) {
      std::array<Sum, 256> bins{};
      for (std::uint32_t i : node.examples)
        bins[rows_(Eigen::Index(i), feature)] += {gradients_[i], curvatures_[i], weights_[i]};
      Sum left;
      for (int value = 0; value < 255; ++value) {
        left += bins[std::size_t(value)];
        const Sum right = node.sum - left;
        if (left.weight < options_.least_weight) continue;
        if (right.weight < options_.least_weight) break;
        const double gain = left.gain() + right.gain() - node.sum.gain();
        if (gain > node.gain + 1e-9) {
          node.gain = gain;
          node.feature = feature;
          node.value = value;
        }
      }
    }
  }

  Growing grown(Indices examples) const
  {
    Growing node;
    node.examples = std::move(examples);
    for (std::uint32_t i : node.examples)
      node.sum += {gradients_[i], curvatures_[i], weights_[i]};
    find_split(node);
    return node;
  }

  void draw_features()
  {
    features_.resize(std::size_t(rows_.cols()));
    std::iota(features_.begin(), features_.end(), 0);
    const auto count = std::size_t(std::ceil(options_.share_of_features * double(features_.size())));
    for (std::size_t k = 0; k < count; ++k)
      std::swap(features_[k], features_[k + random_() % (features_.size() - k)]);
    features_.resize(count);
  }

  void grow()
  {
    draw_features();
    Indices all(std::size_t(rows_.rows()));
    std::iota(all.begin(), all.end(), 0);
    std::vector<Growing> nodes{grown(std::move(all))};
    for (int leaves = 1; leaves < options_.leaves; ++leaves) {
      const auto best = std::max_element(nodes.begin(), nodes.end(), [](const Growing& a, const Growing& b) {
        return (a.left < 0 ? a.gain : -1) < (b.left < 0 ? b.gain : -1);
      });
      if (best->left >= 0 || best->feature < 0) break;
      const auto index = std::size_t(best - nodes.begin());
      Indices left, right;
      for (std::uint32_t i : best->examples)
        (rows_(Eigen::Index(i), best->feature) <= best->value ? left : right).push_back(i);
      nodes[index].examples.clear();
      nodes[index].left = int(nodes.size());
      nodes[index].right = int(nodes.size()) + 1;
      Growing grown_left = grown(std::move(left)), grown_right = grown(std::move(right));
      nodes.push_back(std::move(grown_left));
      nodes.push_back(std::move(grown_right));
    }
    result_.roots_.push_back(std::uint32_t(result_.nodes_.size()));
    store(nodes, 0);
  }

  void store(const std::vector<Growing>& nodes, std::size_t index)
  {
    const Growing& node = nodes[index];
    const std::size_t at = result_.nodes_.size();
    result_.nodes_.emplace_back();
    if (node.left < 0) {
      const double logit = options_.rate * node.sum.gradient / (node.sum.curvature + ridge);
      const double stored = std::round(std::clamp(logit, -largest_logit, largest_logit) / logit_unit) * logit_unit;
      result_.nodes_[at].logit = float(stored);
      for (std::uint32_t i : node.examples)
        logits_[i] += stored;
      return;
    }
    result_.nodes_[at].feature = std::uint8_t(node.feature);
    result_.nodes_[at].value = std::uint8_t(node.value);
    store(nodes, std::size_t(node.left));
    result_.nodes_[at].right = std::uint16_t(result_.nodes_.size() - at);
    store(nodes, std::size_t(node.right));
  }

  const Byte_rows& rows_;
  const Boosting_options& options_;
  Boosted_trees& result_;
  std::mt19937_64 random_;
  std::vector<double> weights_, logits_, gradients_, curvatures_; // indexed by example
  std::vector<int> features_;                                     // features that the next tree may use
};

Boosted_trees::Boosted_trees(const Byte_rows& rows, const std::vector<double>& targets,
                             const std::vector<double>& weights, const Boosting_options& options)
{
  if (rows.rows() > 0) Builder(rows, targets, weights, options, *this);
}

double Boosted_trees::logit(const std::uint8_t* features) const
{
  double sum = double(base_);
  for (std::uint32_t root : roots_) {
    const Node* node = &nodes_[root];
    while (node->feature != leaf)
      node += features[node->feature] <= node->value ? 1 : node->right;
    sum += double(node->logit);
  }
  return sum;
}

double Boosted_trees::probability(const std::uint8_t* features) const { return logistic(logit(features)); }

namespace {

void write_number(std::ostream& out, std::uint32_t value, int bytes)
{
  for (int k = 0; k < bytes; ++k)
    out.put(char(value >> 8 * k & 255));
}

// Reads a little-endian number. \pre there are `bytes` bytes
std::uint32_t taken_number(Stored_bytes& from, int bytes)
{
  std::uint32_t result = 0;
  for (int k = 0; k < bytes; ++k)
    result |= std::uint32_t(*from.next++) << 8 * k;
  return result;
}

constexpr std::int32_t zero_logit = 1 << 15; // stored number of logit 0: logits are unsigned numbers of 16 bits

std::uint32_t stored_logit(float logit) { return std::uint32_t(std::lround(double(logit) / logit_unit) + zero_logit); }
float logit_of_stored(std::uint32_t stored) { return float((std::int32_t(stored) - zero_logit) * logit_unit); }

} // namespace

// A node has two bytes, feature and value; a leaf three, of which two are the logit.
void Boosted_trees::write(std::ostream& out) const
{
  write_number(out, std::uint32_t(roots_.size()), 4);
  write_number(out, stored_logit(base_), 2);
  for (const Node& node : nodes_) {
    out.put(char(node.feature));
    if (node.feature == leaf)
      write_number(out, stored_logit(node.logit), 2);
    else
      out.put(char(node.value));
  }
}

bool Boosted_trees::read(Stored_bytes& bytes, int features)
{
  if (bytes.size() < 6) return false;
  const std::uint32_t trees = taken_number(bytes, 4);
  base_ = logit_of_stored(taken_number(bytes, 2));
  for (std::uint32_t tree = 0; tree < trees; ++tree) {
    roots_.push_back(std::uint32_t(nodes_.size()));
    std::vector<std::size_t> parents; // parents whose right children are to come
    do {
      if (bytes.size() < 3) return false;
      Node node;
      node.feature = *bytes.next++;
      if (node.feature == leaf)
        node.logit = logit_of_stored(taken_number(bytes, 2));
      else if (node.feature < features)
        node.value = *bytes.next++;
      else
        return false;
      if (node.feature != leaf) {
        parents.push_back(nodes_.size());
      } else if (!parents.empty()) {
        const std::size_t offset = nodes_.size() + 1 - parents.back();
        if (offset > most_nodes) return false;
        nodes_[parents.back()].right = std::uint16_t(offset);
        parents.pop_back();
        nodes_.push_back(node);
        continue;
      }
      nodes_.push_back(node);
      if (node.feature == leaf) break;
    } while (true);
  }
  return true;
}

} // namespace CGAL::Shape_correspondence::internal
