// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "roles/Part_model.h"
#include "base/for_each_index.h"
#include "base/quantized.h"
#include "roles/part_features.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <ostream>
#include <random>
#include <set>
#include <utility>

namespace CGAL::Shape_correspondence::internal {

namespace {

constexpr Boosting_options affinity_options{150, 16, 0.1, 5, 0.5, 1}, partness_options{60, 12, 0.15, 5, 0.3, 1};
constexpr double pure_enough = 0.85; // least share of a node's area in one true part, for a node to learn from
constexpr std::size_t most_pairs_of_shape = 250; // limit of the pairs of nodes to learn from
constexpr double worth_unit = 0.01;              // unit of `Part_model::Category::worth` in a file

// Examples of pairs of nodes, and whether they are of one part.
struct Node_pairs
{
  std::vector<Merge_features> features;
  std::vector<bool> are_same;
};

// The pairs of nodes in contact while the nodes of each true part are merged, near and small ones first.
Node_pairs pairs_of(const Part_example& example)
{
  const auto owner = [&](const Part_node& node) {
    Eigen::RowVectorXd areas = Eigen::RowVectorXd::Zero(example.areas.cols());
    for (std::size_t patch : node.patches)
      areas += example.areas.row(Eigen::Index(patch));
    Eigen::Index part = 0;
    const double most = areas.maxCoeff(&part);
    return std::pair(part, most / std::max(areas.sum(), 1e-12));
  };
  Node_pairs result;
  part_tree(example.surface, [&](const Part_node& a, const Part_node& b, const Merge_features& features) {
    const auto [part_a, share_a] = owner(a);
    const auto [part_b, share_b] = owner(b);
    if (std::min(share_a, share_b) >= pure_enough) {
      result.features.push_back(features);
      result.are_same.push_back(part_a == part_b);
    }
    const double growth =
        (a.box.merged(b.box).diagonal().norm() - std::max(a.box.diagonal().norm(), b.box.diagonal().norm()));
    const double size = std::sqrt(std::min(a.moments.area, b.moments.area) / example.surface.area);
    return part_a == part_b ? std::max(0., 1 - (growth + size / 2) / 2) : -1;
  });
  return result;
}

Boosted_trees learned_affinity(const std::vector<const Node_pairs*>& shapes)
{
  std::vector<const Merge_features*> rows;
  std::vector<double> targets, weights;
  for (const Node_pairs* pairs : shapes) {
    std::vector<std::size_t> order(pairs->features.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::mt19937_64 random(1);
    for (std::size_t k = order.size(); k > 1; --k)
      std::swap(order[k - 1], order[random() % k]);
    order.resize(std::min(order.size(), most_pairs_of_shape));
    for (std::size_t k : order) {
      rows.push_back(&pairs->features[k]);
      targets.push_back(pairs->are_same[k]);
      weights.push_back(1 / std::sqrt(double(order.size())));
    }
  }
  Byte_rows features(Eigen::Index(rows.size()), Eigen::Index(merge_feature_count));
  for (std::size_t k = 0; k < rows.size(); ++k)
    std::copy(rows[k]->begin(), rows[k]->end(), &features(Eigen::Index(k), 0));
  return Boosted_trees(features, targets, weights, affinity_options);
}

// The nodes of a shape, and for each one how far it is a true part, from 0 to 1.
struct Judged_nodes
{
  std::vector<Part_node> nodes;
  Byte_rows features;
  std::vector<double> targets;
};

Judged_nodes judged_nodes(const Part_example& example, const Part_model& model)
{
  std::vector<Part_node> nodes = part_candidates(example.surface, model);
  const Eigen::MatrixXd overlaps = example.overlaps_of(nodes);
  Judged_nodes result{{}, part_features(example.surface, nodes, 0), {}};
  result.nodes = std::move(nodes);
  for (Eigen::Index i = 0; i < overlaps.rows(); ++i) {
    const double overlap = overlaps.row(i).maxCoeff();
    result.targets.push_back(((overlap >= same_part_overlap) + overlap) / 2);
  }
  return result;
}

Boosted_trees learned_partness(const std::vector<const Judged_nodes*>& shapes)
{
  Eigen::Index count = 0;
  for (const Judged_nodes* shape : shapes)
    count += shape->features.rows();
  Byte_rows features(count, part_feature_count);
  std::vector<double> targets, weights;
  Eigen::Index next = 0;
  for (const Judged_nodes* shape : shapes) {
    features.middleRows(next, shape->features.rows()) = shape->features;
    next += shape->features.rows();
    targets.insert(targets.end(), shape->targets.begin(), shape->targets.end());
    weights.insert(weights.end(), shape->targets.size(), 1 / std::sqrt(double(shape->targets.size())));
  }
  return Boosted_trees(features, targets, weights, partness_options);
}

Boosted_trees partness_of(const std::vector<Judged_nodes>& shapes, const std::function<bool(std::size_t)>& is_seen)
{
  std::vector<const Judged_nodes*> training;
  for (std::size_t i = 0; i < shapes.size(); ++i)
    if (is_seen(i)) training.push_back(&shapes[i]);
  return training.empty() ? Boosted_trees() : learned_partness(training);
}

// Chooses `worth` for a category, by the mean quality of the parts found with it, over `Part_example::source`.
class Worth_choice
{
public:
  // \param unseen model of one category with `worth` 0, learned without shapes of the example's source
  void add(const Part_example& example, const Judged_nodes& judged, const Part_model& unseen)
  {
    const Eigen::MatrixXd overlaps = example.overlaps_of(judged.nodes);
    const std::vector<double> of_none = part_values(judged.nodes, judged.features, unseen, &unseen.categories[0]);
    Sums& sums = sources_[example.source];
    ++sums.shapes;
    for (std::size_t w = 0; w < worths.size(); ++w) {
      std::vector<double> values = of_none;
      for (double& value : values)
        value -= worths[w];
      const std::vector<std::size_t> cut = best_cut(judged.nodes, values);
      std::set<Eigen::Index> recovered;
      for (std::size_t i : cut)
        for (Eigen::Index part = 0; part < overlaps.cols(); ++part)
          if (overlaps(Eigen::Index(i), part) >= same_part_overlap) recovered.insert(part);
      const double parts = double(overlaps.cols()), found = double(cut.size()), right = double(recovered.size());
      sums.quality[w] += right / (2 * parts) + right / (parts + found);
      sums.ratio[w] += found / parts;
    }
  }

  // The best worth; the usual one unless another is clearly better across sources.
  double best() const
  {
    // Number of standard errors that are subtracted from the mean gain; greatest ratio of found parts to true ones
    constexpr double standard_errors = 1.5, most_divided = 1.25;
    if (sources_.empty()) return usual_worth_of_part;
    double best = 0, result = usual_worth_of_part;
    for (std::size_t w = 0; w < worths.size(); ++w) {
      double sum = 0, weights = 0, variance = 0, ratio = 0, shapes = 0;
      for (const auto& [source, sums] : sources_) {
        sum += std::sqrt(sums.shapes) * sums.gain(w);
        weights += std::sqrt(sums.shapes);
        ratio += sums.ratio[w];
        shapes += sums.shapes;
      }
      for (const auto& [source, sums] : sources_)
        variance += sums.shapes * std::pow(sums.gain(w) - sum / weights, 2);
      const double few = double(sources_.size()) / std::max(1., double(sources_.size()) - 1);
      const double score = (sum - standard_errors * std::sqrt(variance * few)) / weights;
      if (ratio > most_divided * shapes || quantized(score) <= quantized(best)) continue;
      best = score;
      result = worths[w];
    }
    return result;
  }

private:
  static constexpr std::array<double, 12> worths{usual_worth_of_part, .05, .1, .15, .2, .25, .3, .35, .4, .5, .55, .6};

  struct Sums
  {
    double shapes = 0;
    std::array<double, worths.size()> quality{}; // sum over the shapes: mean of recall and F1
    std::array<double, worths.size()> ratio{};   // sum over the shapes: found parts over true ones

    double gain(std::size_t w) const { return (quality[w] - quality[0]) / shapes; }
  };

  std::map<std::string, Sums> sources_;
};

} // namespace

std::vector<Part_node> part_candidates(const Surface_patches& surface, const Part_model& model)
{
  return part_tree(surface, [&](const Part_node&, const Part_node&, const Merge_features& features) {
    return model.affinity.probability(features.data());
  });
}

std::vector<double> part_values(const std::vector<Part_node>& nodes, const Byte_rows& features, const Part_model& model,
                                const Part_model::Category* category)
{
  struct Mean
  {
    double sum = 0;
    int count = 0;
  };
  std::map<std::vector<std::size_t>, Mean> copies;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::uint8_t* const row = &features(Eigen::Index(i), 0);
    double logit = model.partness.logit(row);
    if (category) logit = (logit + category->partness.logit(row)) / 2;
    Mean& mean = copies[nodes[i].shapes];
    mean.sum += 1 / (1 + std::exp(-logit));
    ++mean.count;
  }
  std::vector<double> result;
  for (const Part_node& node : nodes) {
    const Mean& mean = copies[node.shapes];
    result.push_back(mean.sum / mean.count - (category ? category->worth : usual_worth_of_part));
  }
  return result;
}

std::vector<std::size_t> likeliest_parts(const Surface_patches& surface, const std::vector<Part_node>& nodes,
                                         const Part_model& model, const Part_model::Category* category)
{
  std::vector<std::size_t> best;
  Steps most = 0;
  for (int turn = 0; turn < 4; ++turn) {
    const std::vector<double> values = part_values(nodes, part_features(surface, nodes, turn), model, category);
    const std::vector<std::size_t> cut = best_cut(nodes, values);
    double sum = 0;
    for (std::size_t i : cut)
      sum += values[i];
    if (!best.empty() && quantized(sum) <= most) continue;
    most = quantized(sum);
    best = cut;
  }
  return best;
}

Eigen::MatrixXd Part_example::areas_of(const std::vector<Part_node>& nodes) const
{
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(Eigen::Index(nodes.size()), areas.cols());
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (std::size_t patch : nodes[i].patches)
      result.row(Eigen::Index(i)) += areas.row(Eigen::Index(patch));
  return result;
}

Eigen::MatrixXd Part_example::overlaps_of(const std::vector<Part_node>& nodes) const
{
  const Eigen::MatrixXd common = areas_of(nodes);
  const Eigen::VectorXd of_nodes = common.rowwise().sum();
  const Eigen::RowVectorXd of_parts = areas.colwise().sum();
  Eigen::MatrixXd result = common;
  for (Eigen::Index i = 0; i < result.rows(); ++i)
    for (Eigen::Index j = 0; j < result.cols(); ++j)
      result(i, j) /= std::max(of_nodes[i] + of_parts[j] - common(i, j), 1e-12);
  return result;
}

Part_example part_example(const Segmented_shape& objects, const std::vector<std::vector<std::size_t>>& parts,
                          std::string category, std::string source)
{
  Part_example result{
      std::move(category), std::move(source), surface_patches(objects, Eigen::Matrix3d::Identity()), {}};
  std::size_t count = 0;
  for (const std::vector<std::size_t>& of_object : parts)
    for (std::size_t part : of_object)
      count = std::max(count, part + 1);
  result.areas.setZero(Eigen::Index(result.surface.patches.size()), Eigen::Index(count));
  for (std::size_t o = 0; o < parts.size(); ++o) {
    const Part_mesh& mesh = objects.parts()[o].mesh;
    for (std::size_t t = 0; t < parts[o].size(); ++t) {
      const auto corner = [&](int k) -> Point { return mesh.points.col(mesh.triangles(k, Eigen::Index(t))); };
      result.areas(Eigen::Index(result.surface.of_triangles[o][t]), Eigen::Index(parts[o][t])) +=
          (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm() / 2;
    }
  }
  result.areas *= result.surface.area / result.areas.sum();
  return result;
}

void Part_model::write(std::ostream& out) const
{
  affinity.write(out);
  partness.write(out);
  out.put(char(categories.size()));
  for (const Category& category : categories) {
    out.put(char(category.name.size()));
    out << category.name;
    out.put(char(std::lround(category.worth / worth_unit)));
    category.partness.write(out);
  }
}

bool Part_model::read(Stored_bytes& bytes)
{
  if (!affinity.read(bytes, int(merge_feature_count)) || !partness.read(bytes, part_feature_count)) return false;
  if (bytes.size() < 1) return false;
  categories.resize(*bytes.next++);
  for (Category& category : categories) {
    if (bytes.size() < 1 || bytes.size() < 1u + *bytes.next) return false;
    const std::size_t length = *bytes.next++;
    category.name.assign(reinterpret_cast<const char*>(bytes.next), length);
    bytes.next += length;
    if (bytes.size() < 1) return false;
    category.worth = *bytes.next++ * worth_unit;
    if (!category.partness.read(bytes, part_feature_count)) return false;
  }
  return true;
}

std::map<std::string, std::size_t> folds_of_sources(const std::vector<std::string>& sources)
{
  std::map<std::string, std::size_t> count;
  for (const std::string& source : sources)
    ++count[source];
  std::vector<std::pair<std::size_t, std::string>> order;
  for (const auto& [source, n] : count)
    order.push_back({n, source});
  std::sort(order.rbegin(), order.rend());
  std::array<std::size_t, training_folds> load{};
  std::map<std::string, std::size_t> result;
  for (const auto& [n, source] : order) {
    const auto least = std::min_element(load.begin(), load.end());
    result[source] = std::size_t(least - load.begin());
    *least += n;
  }
  return result;
}

Part_model train_part_model(const std::vector<Part_example>& examples)
{
  std::vector<std::string> sources;
  for (const Part_example& example : examples)
    sources.push_back(example.source);
  const std::map<std::string, std::size_t> folds = folds_of_sources(sources);
  std::vector<Node_pairs> pairs(examples.size());
  for_each_index(examples.size(), true, [&](std::size_t i) { pairs[i] = pairs_of(examples[i]); });
  std::vector<Part_model> by_fold(training_folds + 1); // the last one is learned from all
  for_each_index(by_fold.size(), true, [&](std::size_t fold) {
    std::vector<const Node_pairs*> training;
    for (std::size_t i = 0; i < examples.size(); ++i)
      if (folds.at(examples[i].source) != fold) training.push_back(&pairs[i]);
    by_fold[fold].affinity = learned_affinity(training);
  });
  std::vector<Judged_nodes> nodes(examples.size());
  for_each_index(examples.size(), true, [&](std::size_t i) {
    const Part_model& unseen = by_fold[folds.at(examples[i].source)];
    nodes[i] = judged_nodes(examples[i], unseen.is_empty() ? by_fold.back() : unseen);
  });
  Part_model result = std::move(by_fold.back());
  std::set<std::string> names;
  for (const Part_example& example : examples)
    names.insert(example.category);
  for (const std::string& name : names)
    result.categories.push_back({name, {}});
  const auto fold_of = [&](std::size_t i) { return folds.at(examples[i].source); };
  for_each_index(result.categories.size() + 1 + training_folds, true, [&](std::size_t c) {
    if (c < result.categories.size())
      result.categories[c].partness =
          partness_of(nodes, [&](std::size_t i) { return examples[i].category == result.categories[c].name; });
    else if (c == result.categories.size())
      result.partness = partness_of(nodes, [](std::size_t) { return true; });
    else
      by_fold[c - result.categories.size() - 1].partness =
          partness_of(nodes, [&](std::size_t i) { return fold_of(i) + result.categories.size() + 1 != c; });
  });
  for_each_index(result.categories.size(), true, [&](std::size_t c) {
    Part_model::Category& category = result.categories[c];
    Worth_choice choice;
    for (std::size_t fold = 0; fold < training_folds; ++fold) {
      const auto is_known = [&](std::size_t i) { return examples[i].category == category.name && fold_of(i) != fold; };
      Part_model unseen;
      unseen.partness = by_fold[fold].partness;
      unseen.categories.push_back({category.name, partness_of(nodes, is_known), 0});
      if (unseen.partness.is_empty() || unseen.categories[0].partness.is_empty()) continue;
      for (std::size_t i = 0; i < examples.size(); ++i)
        if (examples[i].category == category.name && fold_of(i) == fold && examples[i].surface.of_triangles.size() == 1)
          choice.add(examples[i], nodes[i], unseen); // a model of one object, which only probabilities divide
    }
    category.worth = choice.best();
  });
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
