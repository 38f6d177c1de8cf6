// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// How well the parts of labelled shapes are found again when their meshes are joined to one, with whole sources left out
// of the training.

#include "base/for_each_index.h"
#include "command_line.h"
#include "roles/part_features.h"

#include <CGAL/Shape_correspondence/IO/read_part_labels.h>
#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <map>
#include <mutex>
#include <numeric>
#include <random>
#include <set>

using namespace CGAL::Shape_correspondence;
using namespace CGAL::Shape_correspondence::internal;

namespace {

constexpr double found_share = 0.75; // of the union of two parts, from which on one is the other
constexpr double pure = 0.85;        // share of a node in one true part, from which on it is a fragment of it
constexpr std::size_t no_fold = std::size_t(-1);

const char* const usage =
    "Usage: validate_parts [--form one|objects] [--folds N] [--trees N] [--leaves N] [--general] [--turns] FOLDER...\n";

struct Shape
{
  std::string name, category, source;
  std::vector<std::string> roles; // by true part
  Surface_patches surface;
  Eigen::MatrixXd areas;    // patch × true part
  Eigen::VectorXd of_parts; // areas
  std::size_t fold = no_fold;
  double seconds = 0;

  std::vector<Part_node> nodes;
  Byte_rows features;
  Eigen::MatrixXd node_areas, overlaps; // node × true part; areas, and shares of the unions
};

struct Options
{
  std::string form = "one";
  std::size_t folds = 5;
  Boosting_options affinity{150, 16, 0.1, 5, 0.5, 1}, partness{150, 16, 0.08, 5, 0.3, 1};
  bool turns = false;
  std::vector<std::string> folders;
};

/// The parts as one object, or as three of parts with the same roles; and by object and triangle the part.
struct Joined
{
  Segmented_shape shape;
  std::vector<std::vector<std::size_t>> parts;
};

Joined joined(const Segmented_shape& labelled, const std::vector<std::string>& roles, bool one)
{
  std::set<std::string> known(roles.begin(), roles.end());
  std::vector<std::string> order(known.begin(), known.end());
  std::mt19937_64 random(std::hash<std::string>()(labelled.name()));
  for (std::size_t k = order.size(); k > 1; --k)
    std::swap(order[k - 1], order[random() % k]);
  std::map<std::string, std::size_t> object;
  for (std::size_t k = 0; k < order.size(); ++k)
    object[order[k]] = one ? 0 : k % 3;
  Joined result{Segmented_shape(labelled.name(), labelled.up()), {}};
  for (std::size_t o = 0; o < 3; ++o) {
    std::vector<Point> points;
    std::vector<Eigen::Vector3i> triangles;
    std::vector<std::size_t> parts;
    for (std::size_t i = 0; i < roles.size(); ++i) {
      if (object[roles[i]] != o) continue;
      const Part_mesh& mesh = labelled.parts()[i].mesh;
      for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
        triangles.push_back(mesh.triangles.col(t).array() + int(points.size()));
        parts.push_back(i);
      }
      for (Eigen::Index v = 0; v < mesh.points.cols(); ++v)
        points.push_back(mesh.points.col(v));
    }
    if (triangles.empty()) continue;
    Part_mesh mesh;
    mesh.points.resize(3, Eigen::Index(points.size()));
    mesh.triangles.resize(3, Eigen::Index(triangles.size()));
    for (std::size_t v = 0; v < points.size(); ++v)
      mesh.points.col(Eigen::Index(v)) = points[v];
    for (std::size_t t = 0; t < triangles.size(); ++t)
      mesh.triangles.col(Eigen::Index(t)) = triangles[t];
    result.shape.add_part("object_" + std::to_string(o), std::move(mesh));
    result.parts.push_back(std::move(parts));
  }
  return result;
}

double area_of(const Part_mesh& mesh, Eigen::Index t)
{
  const Point a = mesh.points.col(mesh.triangles(0, t)), b = mesh.points.col(mesh.triangles(1, t)),
              c = mesh.points.col(mesh.triangles(2, t));
  return (b - a).cross(c - a).norm() / 2;
}

Shape read_shape(const IO::Labelled_shape& labels, bool one)
{
  const Segmented_shape labelled =
      IO::read_segmented_shape((std::filesystem::path(labels.file).parent_path() / "parts").string());
  Shape result;
  result.name = labels.name;
  result.category = labels.category;
  result.source = labels.source.empty() ? labels.name : labels.source;
  for (const Shape_part& part : labelled.parts()) {
    const std::size_t i = labels.index(part.name);
    result.roles.push_back(i < labels.labels.size() ? labels.labels[i].coarse : "");
  }
  const Joined model = joined(labelled, result.roles, one);
  const auto begin = std::chrono::steady_clock::now();
  result.surface = surface_patches(model.shape, Eigen::Matrix3d::Identity());
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  result.areas.setZero(Eigen::Index(result.surface.patches.size()), Eigen::Index(result.roles.size()));
  for (std::size_t o = 0; o < model.parts.size(); ++o)
    for (std::size_t t = 0; t < model.parts[o].size(); ++t)
      result.areas(Eigen::Index(result.surface.of_triangles[o][t]), Eigen::Index(model.parts[o][t])) +=
          area_of(model.shape.parts()[o].mesh, Eigen::Index(t));
  result.areas *= result.surface.area / result.areas.sum();
  result.of_parts = result.areas.colwise().sum();
  return result;
}

/// The true part that a node is most of, and the share of the node in it.
std::pair<std::size_t, double> owner(const Shape& shape, const Part_node& node)
{
  Eigen::RowVectorXd areas = Eigen::RowVectorXd::Zero(shape.areas.cols());
  for (std::size_t patch : node.patches)
    areas += shape.areas.row(Eigen::Index(patch));
  Eigen::Index part = 0;
  const double most = areas.maxCoeff(&part);
  return {std::size_t(part), most / std::max(areas.sum(), 1e-12)};
}

/// Examples of pairs of nodes, and whether they are of one part.
struct Pairs
{
  std::vector<Merge_features> features;
  std::vector<bool> are_same;
};

/// What is met when pieces of the same part are merged, in some order.
Pairs pairs_of(const Shape& shape)
{
  Pairs result;
  part_tree(shape.surface, [&](const Part_node& a, const Part_node& b, const Merge_features& features) {
    const auto [part_a, share_a] = owner(shape, a);
    const auto [part_b, share_b] = owner(shape, b);
    const bool are_same = part_a == part_b;
    if (std::min(share_a, share_b) >= pure) {
      result.features.push_back(features);
      result.are_same.push_back(are_same);
    }
    // near ones and small ones first
    const double grow = features[12] / 254., gap = features[0] / 254. * 0.03, small = features[3] / 254.;
    return are_same ? std::max(0., 1 - (grow + 15 * gap + 0.5 * small) / 3) : -1;
  });
  return result;
}

Boosted_trees learned_affinity(const std::vector<Shape>& shapes, const std::vector<Pairs>& pairs, std::size_t fold,
                               const Boosting_options& options)
{
  std::vector<const Merge_features*> rows;
  std::vector<double> targets, weights;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (shapes[i].fold == fold || pairs[i].features.empty()) continue;
    constexpr std::size_t most = 250;
    std::vector<std::size_t> order(pairs[i].features.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::mt19937_64 random(1);
    for (std::size_t k = order.size(); k > 1; --k)
      std::swap(order[k - 1], order[random() % k]);
    order.resize(std::min(order.size(), most));
    for (std::size_t k : order) {
      rows.push_back(&pairs[i].features[k]);
      targets.push_back(pairs[i].are_same[k]);
      weights.push_back(1 / std::sqrt(double(order.size())));
    }
  }
  Byte_rows features(Eigen::Index(rows.size()), Eigen::Index(merge_feature_count));
  for (std::size_t k = 0; k < rows.size(); ++k)
    std::copy(rows[k]->begin(), rows[k]->end(), &features(Eigen::Index(k), 0));
  return Boosted_trees(features, targets, weights, options);
}

void grow_tree(Shape& shape, const Boosted_trees& affinity)
{
  const auto begin = std::chrono::steady_clock::now();
  shape.nodes = part_tree(shape.surface, [&](const Part_node&, const Part_node&, const Merge_features& features) {
    return affinity.probability(features.data());
  });
  shape.features = part_features(shape.surface, shape.nodes, 0);
  shape.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  shape.node_areas.setZero(Eigen::Index(shape.nodes.size()), shape.areas.cols());
  for (std::size_t i = 0; i < shape.nodes.size(); ++i)
    for (std::size_t patch : shape.nodes[i].patches)
      shape.node_areas.row(Eigen::Index(i)) += shape.areas.row(Eigen::Index(patch));
  shape.overlaps = shape.node_areas;
  const Eigen::VectorXd areas = shape.node_areas.rowwise().sum();
  for (Eigen::Index i = 0; i < shape.overlaps.rows(); ++i)
    for (Eigen::Index j = 0; j < shape.overlaps.cols(); ++j)
      shape.overlaps(i, j) /= std::max(areas[i] + shape.of_parts[j] - shape.node_areas(i, j), 1e-12);
}

Boosted_trees learned_partness(const std::vector<const Shape*>& shapes, const Boosting_options& options)
{
  Eigen::Index count = 0;
  for (const Shape* shape : shapes)
    count += shape->features.rows();
  Byte_rows features(count, part_feature_count);
  std::vector<double> targets, weights;
  Eigen::Index next = 0;
  for (const Shape* shape : shapes) {
    features.middleRows(next, shape->features.rows()) = shape->features;
    next += shape->features.rows();
    for (Eigen::Index i = 0; i < shape->features.rows(); ++i) {
      const double overlap = shape->overlaps.row(i).maxCoeff();
      targets.push_back(((overlap >= found_share) + overlap) / 2);
      weights.push_back(1 / std::sqrt(double(shape->features.rows())));
    }
  }
  return Boosted_trees(features, targets, weights, options);
}

std::vector<double> values_of(const Shape& shape, const Boosted_trees& partness)
{
  std::vector<double> p;
  for (Eigen::Index i = 0; i < shape.features.rows(); ++i)
    p.push_back(partness.probability(&shape.features(i, 0)));
  std::map<std::vector<std::size_t>, std::pair<double, int>> copies;
  for (std::size_t i = 0; i < p.size(); ++i) {
    auto& [sum, n] = copies[shape.nodes[i].shapes];
    sum += p[i];
    ++n;
  }
  std::vector<double> values;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto& [sum, n] = copies[shape.nodes[i].shapes];
    const double mean = std::clamp(sum / n, 0.02, 0.98);
    values.push_back(std::log(mean / (1 - mean)));
  }
  return values;
}

using Row = std::array<double, 5>; // recovered, overlap, found over true parts, in one true part, F1

Row measured(const Shape& shape, const std::vector<std::size_t>& cut)
{
  Row row{};
  std::vector<double> best(std::size_t(shape.of_parts.size()), 0);
  for (std::size_t i : cut) {
    for (std::size_t j = 0; j < best.size(); ++j)
      best[j] = std::max(best[j], shape.overlaps(Eigen::Index(i), Eigen::Index(j)));
    const double area = shape.node_areas.row(Eigen::Index(i)).sum();
    row[3] += shape.node_areas.row(Eigen::Index(i)).maxCoeff() >= 0.9 * area;
  }
  const double parts = double(best.size()), found = double(cut.size());
  double recovered = 0;
  for (double overlap : best) {
    recovered += overlap >= found_share;
    row[1] += overlap / parts;
  }
  row[0] = recovered / parts;
  row[2] = found / parts;
  row[3] /= found;
  row[4] = 2 * recovered / (parts + found);
  return row;
}

std::vector<double> true_values(const Shape& shape)
{
  std::vector<double> result;
  for (Eigen::Index i = 0; i < shape.overlaps.rows(); ++i)
    result.push_back((shape.overlaps.row(i).array() >= found_share).any() +
                     1e-3 * shape.overlaps.row(i).maxCoeff() * shape.node_areas.row(i).sum() / shape.surface.area);
  return result;
}

void print(const std::string& title, const std::map<std::string, std::vector<Row>>& rows)
{
  std::printf("\n%-24s shapes recovered   IoU  ratio  pure    F1\n", title.c_str());
  Row mean{};
  const auto print_row = [](const std::string& name, std::size_t n, const Row& row) {
    std::printf("%-24s %6zu %9.3f %6.3f %6.2f %6.3f %6.3f\n", name.c_str(), n, row[0], row[1], row[2], row[3], row[4]);
  };
  std::size_t count = 0;
  for (const auto& [category, of_category] : rows) {
    Row sum{};
    for (const Row& row : of_category)
      for (std::size_t k = 0; k < row.size(); ++k)
        sum[k] += row[k] / double(of_category.size());
    for (std::size_t k = 0; k < sum.size(); ++k)
      mean[k] += sum[k] / double(rows.size());
    count += of_category.size();
    print_row(category, of_category.size(), sum);
  }
  print_row("MEAN", count, mean);
  std::fflush(stdout);
}

Options parsed(int argc, char** argv)
{
  Options options;
  benchmark::Command_line words(argc, argv);
  while (!words.is_at_end()) {
    const std::string& word = words.word();
    if (word == "--form")
      options.form = words.value();
    else if (word == "--folds")
      options.folds = benchmark::whole_number(words.value(), word);
    else if (word == "--trees")
      options.partness.trees = int(benchmark::whole_number(words.value(), word));
    else if (word == "--leaves")
      options.partness.leaves = int(benchmark::whole_number(words.value(), word));
    else if (word == "--turns")
      options.turns = true;
    else {
      benchmark::refuse_option(word);
      options.folders.push_back(word);
    }
  }
  if (options.folders.empty()) throw std::invalid_argument("no folder of labelled shapes");
  return options;
}

void validate(const Options& options)
{
  std::vector<IO::Labelled_shape> labels;
  for (const std::string& folder : options.folders)
    for (IO::Labelled_shape& shape : IO::read_part_labels(folder))
      labels.push_back(std::move(shape));
  std::vector<Shape> shapes(labels.size());
  for_each_index(labels.size(), true, [&](std::size_t i) { shapes[i] = read_shape(labels[i], options.form == "one"); });
  std::map<std::string, std::size_t> of_source;
  for (const Shape& shape : shapes)
    ++of_source[shape.source];
  std::vector<std::pair<std::size_t, std::string>> sources;
  for (const auto& [source, n] : of_source)
    sources.push_back({n, source});
  std::stable_sort(sources.begin(), sources.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::size_t> load(options.folds, 0);
  std::map<std::string, std::size_t> fold;
  for (const auto& [n, source] : sources) {
    const auto least = std::min_element(load.begin(), load.end());
    fold[source] = std::size_t(least - load.begin());
    *least += n;
  }
  double patches = 0;
  for (Shape& shape : shapes) {
    shape.fold = fold[shape.source];
    patches += double(shape.surface.patches.size()) / double(shapes.size());
  }
  std::printf("%zu shapes, %zu sources, %.0f patches a shape\n", shapes.size(), sources.size(), patches);
  std::vector<Pairs> pairs(shapes.size());
  for_each_index(shapes.size(), true, [&](std::size_t i) { pairs[i] = pairs_of(shapes[i]); });
  std::vector<Boosted_trees> affinities(options.folds);
  for_each_index(options.folds, true,
                 [&](std::size_t k) { affinities[k] = learned_affinity(shapes, pairs, k, options.affinity); });
  for_each_index(shapes.size(), true, [&](std::size_t i) { grow_tree(shapes[i], affinities[shapes[i].fold]); });
  double seconds = 0;
  for (const Shape& shape : shapes)
    seconds = std::max(seconds, shape.seconds);
  std::printf("affinity: %zu nodes; slowest shape %.2f s\n", affinities[0].number_of_nodes(), seconds);
  std::set<std::string> categories;
  std::map<std::string, std::vector<Row>> ideal;
  for (const Shape& shape : shapes) {
    categories.insert(shape.category);
    ideal[shape.category].push_back(measured(shape, best_cut(shape.nodes, true_values(shape))));
  }
  print("best cut of the tree", ideal);
  for (const std::string who : {"own category", "all categories", "other categories"}) {
    std::vector<std::pair<std::string, std::size_t>> jobs;
    for (const std::string& category : categories)
      for (std::size_t k = 0; k < options.folds; ++k)
        jobs.push_back({category, k});
    std::map<std::string, std::vector<Row>> rows;
    std::mutex mutex;
    for_each_index(jobs.size(), true, [&](std::size_t job) {
      const auto& [category, k] = jobs[job];
      std::vector<const Shape*> training, test;
      for (const Shape& shape : shapes)
        if (shape.fold == k && shape.category == category)
          test.push_back(&shape);
        else if (shape.fold != k &&
                 (who == "all categories" || (shape.category == category) == (who == "own category")))
          training.push_back(&shape);
      if (test.empty() || training.empty()) return;
      const Boosted_trees partness = learned_partness(training, options.partness);
      for (const Shape* shape : test) {
        const Row row = measured(*shape, best_cut(shape->nodes, values_of(*shape, partness)));
        const std::lock_guard<std::mutex> lock(mutex);
        rows[category].push_back(row);
      }
    });
    print(who, rows);
  }
}

} // namespace

int main(int argc, char** argv)
{
  try {
    validate(parsed(argc, argv));
  } catch (const std::invalid_argument& error) {
    std::cerr << "validate_parts: " << error.what() << '\n' << usage;
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "validate_parts: " << error.what() << '\n';
    return 1;
  }
}
