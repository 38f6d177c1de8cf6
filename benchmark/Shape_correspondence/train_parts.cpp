// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Learns what parts look like from labelled shapes, and measures how well the parts of other shapes are found again
// after their meshes are joined.

#include "base/for_each_index.h"
#include "command_line.h"
#include "roles/Part_model.h"
#include "roles/Role_model_data.h"

#include <CGAL/Shape_correspondence/IO/read_part_labels.h>
#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/IO/role_model.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <random>
#include <set>

using namespace CGAL::Shape_correspondence;
using namespace CGAL::Shape_correspondence::internal;

namespace {

const char* const usage =
    "Usage: train_parts [--test FOLDER]... [--folds] [--roles FILE -o FILE] FOLDER...\n"
    "Learns what parts look like from labelled shapes. --test leaves out the sources of the shapes in a folder and\n"
    "prints how well their parts are found again; --folds does so with each fifth of all sources; -o writes the role\n"
    "model of --roles with what was learned.\n";

struct Options
{
  std::vector<std::string> folders, test;
  std::string roles, output;
  bool folds = false;
};

/// A shape whose parts are joined to one object, or to three, where parts of one role are in the same object. `parts`
/// has the index of the labelled part, by object and triangle.
struct Joined
{
  Segmented_shape shape;
  std::vector<std::vector<std::size_t>> parts;
  bool is_one = true;
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
  Joined result{Segmented_shape(labelled.name(), labelled.up()), {}, one};
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

/// A shape as it is read, and what is learned from it.
struct Example
{
  Joined model;
  Part_example shape;
};

Example example_of(const IO::Labelled_shape& labels, bool one)
{
  const Segmented_shape labelled =
      IO::read_segmented_shape((std::filesystem::path(labels.file).parent_path() / "parts").string());
  std::vector<std::string> roles;
  for (const Shape_part& part : labelled.parts()) {
    const std::size_t i = labels.index(part.name);
    roles.push_back(i < labels.labels.size() ? labels.labels[i].coarse : "");
  }
  Example result;
  result.model = joined(labelled, roles, one);
  result.shape = part_example(result.model.shape, result.model.parts, labels.category,
                              labels.source.empty() ? labels.name : labels.source);
  return result;
}

// Share of the true parts that are recovered, their mean overlap, number of found parts over that of true parts, share
// of the found parts that are in one true part, F1.
using Row = std::array<double, 5>;

Row measured(const Part_example& shape, const std::vector<Part_node>& nodes, const std::vector<std::size_t>& cut)
{
  const Eigen::MatrixXd areas = shape.areas_of(nodes), overlaps = shape.overlaps_of(nodes);
  Row row{};
  std::vector<double> best(std::size_t(areas.cols()), 0);
  for (std::size_t i : cut) {
    for (std::size_t j = 0; j < best.size(); ++j)
      best[j] = std::max(best[j], overlaps(Eigen::Index(i), Eigen::Index(j)));
    row[3] += areas.row(Eigen::Index(i)).maxCoeff() >= 0.9 * areas.row(Eigen::Index(i)).sum();
  }
  const double parts = double(best.size()), found = double(cut.size());
  double recovered = 0;
  for (double overlap : best) {
    recovered += overlap >= same_part_overlap;
    row[1] += overlap / parts;
  }
  row[0] = recovered / parts;
  row[2] = found / parts;
  row[3] /= found;
  row[4] = 2 * recovered / (parts + found);
  return row;
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

std::vector<IO::Labelled_shape> labels_of(const std::vector<std::string>& folders)
{
  std::vector<IO::Labelled_shape> result;
  for (const std::string& folder : folders)
    for (IO::Labelled_shape& shape : IO::read_part_labels(folder))
      result.push_back(std::move(shape));
  return result;
}

Options parsed(int argc, char** argv)
{
  Options options;
  benchmark::Command_line words(argc, argv);
  while (!words.is_at_end()) {
    const std::string& word = words.word();
    if (word == "--test")
      options.test.push_back(words.value());
    else if (word == "--folds")
      options.folds = true;
    else if (word == "--roles")
      options.roles = words.value();
    else if (word == "-o")
      options.output = words.value();
    else {
      benchmark::refuse_option(word);
      options.folders.push_back(word);
    }
  }
  if (options.folders.empty()) throw std::invalid_argument("no folder of labelled shapes");
  return options;
}

/// Examples of shapes in both forms, as one object and as three.
std::vector<Example> examples_of(const std::vector<IO::Labelled_shape>& labels)
{
  std::vector<Example> result(2 * labels.size());
  for_each_index(result.size(), true, [&](std::size_t i) { result[i] = example_of(labels[i / 2], i % 2 == 0); });
  return result;
}

/// How well parts are found, by title (number of objects of a shape, and way to find parts) and category.
using Tables = std::map<std::string, std::map<std::string, std::vector<Row>>>;

const Part_model::Category* category_of(const Part_example& shape, const Part_model& model)
{
  for (const Part_model::Category& category : model.categories)
    if (category.name == shape.category) return &category;
  return nullptr;
}

/// The cut through the tree of `nodes` that recovers the most true parts.
std::vector<std::size_t> ideal_cut(const Part_example& shape, const std::vector<Part_node>& nodes)
{
  const Eigen::MatrixXd overlaps = shape.overlaps_of(nodes);
  std::vector<double> values;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const double overlap = overlaps.row(Eigen::Index(k)).maxCoeff();
    values.push_back((overlap >= same_part_overlap) + 1e-3 * overlap * nodes[k].moments.area / shape.surface.area);
  }
  return best_cut(nodes, values);
}

void measure(const std::vector<const Example*>& examples, const Part_model& model, Tables& tables)
{
  std::vector<std::array<Row, 3>> rows(examples.size());
  for_each_index(examples.size(), true, [&](std::size_t i) {
    const Part_example& shape = examples[i]->shape;
    const std::vector<Part_node> nodes = part_candidates(shape.surface, model);
    const std::vector<std::size_t> ideal = ideal_cut(shape, nodes),
                                   cut = likeliest_parts(shape.surface, nodes, model, category_of(shape, model));
    rows[i] = {measured(shape, nodes, ideal), measured(shape, nodes, cut),
               measured(shape, nodes, likeliest_parts(shape.surface, nodes, model, nullptr))};
  });
  for (std::size_t i = 0; i < examples.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::string form = examples[i]->model.is_one ? "one object: " : "three objects: ";
      tables[form + std::array{"best cut", "category known", "category unknown"}[k]][examples[i]->shape.category]
          .push_back(rows[i][k]);
    }
}

Part_model learned(const std::vector<Example>& examples, const std::set<std::string>& unseen)
{
  std::vector<Part_example> training;
  for (const Example& example : examples)
    if (unseen.count(example.shape.source) == 0) training.push_back(example.shape);
  std::printf("%zu shapes to learn from\n", training.size() / 2);
  std::fflush(stdout);
  Part_model result = train_part_model(training);
  for (const Part_model::Category& category : result.categories)
    std::printf("%s %.2f%s", category.name.c_str(), category.worth,
                &category == &result.categories.back() ? "\n" : ", ");
  std::fflush(stdout);
  return result;
}

void measure_unseen(const std::vector<Example>& training, const std::vector<Example>& test,
                    const std::set<std::string>& sources, Tables& tables)
{
  std::vector<const Example*> unseen;
  for (const Example& example : test)
    if (sources.count(example.shape.source)) unseen.push_back(&example);
  measure(unseen, learned(training, sources), tables);
}

void run(const Options& options)
{
  const std::vector<Example> training = examples_of(labels_of(options.folders));
  Tables tables;
  if (!options.test.empty()) {
    const std::vector<Example> test = examples_of(labels_of(options.test));
    std::set<std::string> sources;
    for (const Example& example : test)
      sources.insert(example.shape.source);
    measure_unseen(training, test, sources, tables);
  }
  if (options.folds) {
    std::vector<std::set<std::string>> folds(training_folds);
    std::vector<std::string> sources;
    for (const Example& example : training)
      sources.push_back(example.shape.source);
    for (const auto& [source, fold] : folds_of_sources(sources))
      folds[fold].insert(source);
    for (const std::set<std::string>& of_fold : folds)
      measure_unseen(training, training, of_fold, tables);
  }
  for (const auto& [title, rows] : tables)
    print(title, rows);
  if (options.output.empty()) return;
  Role_model_data data = Role_model_access::data(IO::read_role_model(options.roles));
  data.parts = std::make_shared<Part_model>(learned(training, {}));
  IO::write_role_model(options.output, Role_model_access::model(std::move(data)));
}

} // namespace
int main(int argc, char** argv)
{
  try {
    run(parsed(argc, argv));
  } catch (const std::invalid_argument& error) {
    std::cerr << "train_parts: " << error.what() << '\n' << usage;
    return 2;
  } catch (const std::exception& error) {
    std::cerr << "train_parts: " << error.what() << '\n';
    return 1;
  }
}
