// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// What the default method owes to each of its costs and rules, to the pose, and how sure it may be.
#ifndef CGAL_SHAPE_CORRESPONDENCE_EXPERIMENTS_DEFAULT_METHOD_H
#define CGAL_SHAPE_CORRESPONDENCE_EXPERIMENTS_DEFAULT_METHOD_H

#include "chart.h"
#include "options.h"
#include "tables.h"

#include <memory>
#include <random>

namespace CGAL {
namespace Shape_correspondence {
namespace experiments {

/// The same, and by halves of the shapes, on one of which constants were set.
inline void compare_by_halves(const Dataset& dataset, const std::vector<std::pair<std::string, peers::Peer>>& methods,
                              const std::string& what)
{
  write_run_heading(dataset, what, {"half A F1", "half B F1", "across F1"});
  for (const auto& [name, method] : methods) {
    const Run of_all = run(dataset, method);
    write_run_row(name, of_all, f1_of_halves(dataset, of_all));
  }
}

inline void ablation(const Dataset& dataset)
{
  std::vector<std::pair<std::string, peers::Peer>> methods{{"all", ours(default_options())}};
  const std::pair<const char*, double Part_cost_weights::*> weights[] = {
      {"no overlap of boxes", &Part_cost_weights::overlap}, {"no extents", &Part_cost_weights::extent},
      {"no ground contact", &Part_cost_weights::ground},    {"no place", &Part_cost_weights::place},
      {"no orientation", &Part_cost_weights::orientation},  {"no chamfer distance", &Part_cost_weights::chamfer}};
  for (const auto& [name, weight] : weights) {
    Search_options options;
    options.parts.weights.*weight = 0;
    methods.emplace_back(name, ours(options));
  }
  const std::tuple<const char*, double Part_matching_options::*, double> rules[] = {
      {"best pairs of parts only", &Part_matching_options::excess, 0},
      {"no confident pairs, so no blocks", &Part_matching_options::confident_excess, 0}};
  for (const auto& [name, rule, value] : rules) {
    Search_options options;
    options.parts.*rule = value;
    methods.emplace_back(name, ours(options));
  }
  const std::pair<const char*, bool Part_matching_options::*> wholes[] = {
      {"no panels", &Part_matching_options::panels}, {"no support", &Part_matching_options::support}};
  for (const auto& [name, whole] : wholes) {
    Search_options options;
    options.parts.*whole = false;
    methods.emplace_back(name, ours(options));
  }
  Search_options plain;
  plain.parts.panels = plain.parts.support = false;
  methods.emplace_back("no panels or support", ours(plain));
  plain.parts.excess = 2;
  methods.emplace_back("nor their bound: excess 2", ours(plain));
  methods.emplace_back("no symmetry groups", without_symmetry(ours(default_options())));
  compare_by_halves(dataset, methods, "costs and rules");
}

/// The graph turned about the up axis, as if its meshes had been.
inline Structural_graph turned(const Structural_graph& graph, double angle)
{
  Structural_graph result = graph;
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Point::UnitY()).toRotationMatrix();
  Shape_structure& shape = structure(result);
  for (Part_abstraction& part : shape.parts) {
    part.surface = (turn * part.surface).eval();
    std::visit([&](auto& geometry) { geometry.points = (turn * geometry.points).eval(); }, part.geometry);
  }
  shape.frame.axes = turn * shape.frame.axes;
  shape.frame.origin = turn * shape.frame.origin;
  for (std::size_t v = 0; v < num_vertices(result); ++v) {
    result[v].symmetry.point = turn * result[v].symmetry.point;
    result[v].symmetry.direction = turn * result[v].symmetry.direction;
  }
  return result;
}

/// A method on shapes that were turned: every source by an angle and every target by another.
template <typename Angle>
peers::Peer on_turned(const Search_options& options, const Angle& angle)
{
  return [options, angle](const std::vector<Structural_graph>& shapes, const std::vector<peers::Shape_pair>& pairs) {
    std::vector<Part_pairs> result;
    for (const auto& [s, t] : pairs) {
      const Structural_graph source = turned(shapes[s], angle(true)), target = turned(shapes[t], angle(false));
      result.push_back(part_pairs(find_correspondence(source, target, options).pairs));
    }
    return result;
  };
}

/// The pairs of shapes that have one mirror plane; categories without such pairs are left out.
inline Dataset of_shapes_with_front(const Dataset& dataset)
{
  Dataset result;
  for (Category category : dataset) {
    const auto has_front = [&](std::size_t shape) {
      const Shape_frame& frame = structure(category.graphs[shape]).frame;
      return frame.mirror_x != frame.mirror_z;
    };
    const auto is_left_out = [&](const peers::Shape_pair& pair) { return !has_front(pair[0]) || !has_front(pair[1]); };
    category.pairs.erase(std::remove_if(category.pairs.begin(), category.pairs.end(), is_left_out),
                         category.pairs.end());
    if (!category.pairs.empty()) result.push_back(std::move(category));
  }
  return result;
}

inline void pose(const Dataset& dataset)
{
  constexpr double degree = EIGEN_PI / 180;
  const auto by = [&](double source, double target) {
    return [=](bool is_source) { return (is_source ? source : target) * degree; };
  };
  const auto any = [random = std::make_shared<std::mt19937>(1)](bool) {
    return 2 * EIGEN_PI * double((*random)()) / double(std::mt19937::max());
  };
  Search_options automatic;
  automatic.alignments = 0;
  compare(dataset,
          {{"as given", ours(default_options())},
           {"both turned by 40°", on_turned(default_options(), by(40, 40))},
           {"by 40° and -40°", on_turned(default_options(), by(40, -40))},
           {"as given, --front auto", ours(automatic)},
           {"by any angles, --front auto", on_turned(automatic, any)},
           {"by any angles, front as given", on_turned(default_options(), any)}},
          "pose");
  const Dataset with_front = of_shapes_with_front(dataset);
  std::size_t pairs = 0;
  for (const Category& category : with_front)
    pairs += category.pairs.size();
  std::cout << "\nThe " << pairs
            << " pairs of shapes that have one mirror plane, so that they tell where their front is:\n\n";
  if (pairs == 0) return;
  compare(with_front,
          {{"as given", ours(default_options())}, {"by any angles, --front auto", on_turned(automatic, any)}}, "pose");
}

inline void reliability(const Dataset& dataset, const Options& options)
{
  constexpr int bins = 10;
  std::vector<double> confidence(bins, 0), right(bins, 0), count(bins, 0);
  double error = 0, total = 0;
  for (const Category& category : dataset)
    for (const auto& [s, t] : category.pairs) {
      const Correspondence c = find_correspondence(category.graphs[s], category.graphs[t]);
      const Ground_truth truth = ground_truth(category.labels[s], category.labels[t]);
      for (const Part_correspondence& pair : c.pairs) {
        const int bin = std::min(int(pair.confidence * bins), bins - 1);
        const std::pair<std::size_t, std::size_t> parts(pair.source, pair.target);
        confidence[std::size_t(bin)] += pair.confidence;
        right[std::size_t(bin)] += std::binary_search(truth.pairs.begin(), truth.pairs.end(), parts);
        ++count[std::size_t(bin)];
        ++total;
      }
    }
  write_heading({"confidence", "pairs", "right"});
  Chart chart;
  chart.x_title = "confidence of pairs, mean of a tenth";
  chart.y_title = "share of them that is right";
  chart.lines = {{"measured", "#0a62c4", {}, false}, {"as stated", "#c43b0a", {{0, 0}, {1, 1}}, true}};
  for (std::size_t b = 0; b < bins; ++b) {
    if (count[b] == 0) continue;
    const Eigen::Vector2d point(confidence[b] / count[b], right[b] / count[b]);
    error += count[b] / total * std::abs(point.x() - point.y());
    write_row({text(point.x(), 2), std::to_string(int(count[b])), text(point.y(), 2)});
    chart.lines[0].points.push_back(point);
  }
  std::cout << "\nExpected calibration error: " << text(error) << '\n';
  std::ofstream out = picture(options, "reliability.svg");
  chart.write(out);
}

} // namespace experiments
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_EXPERIMENTS_DEFAULT_METHOD_H
