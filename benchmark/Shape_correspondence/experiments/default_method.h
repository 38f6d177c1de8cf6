// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// What the default method owes to each of its costs and rules, to the pose, and how sure it may be.
#ifndef CGAL_SHAPE_CORRESPONDENCE_EXPERIMENTS_DEFAULT_METHOD_H
#define CGAL_SHAPE_CORRESPONDENCE_EXPERIMENTS_DEFAULT_METHOD_H

#include "chart.h"
#include "options.h"
#include "role_validation.h"
#include "tables.h"

#include <memory>
#include <random>

namespace CGAL {
namespace Shape_correspondence {
namespace experiments {

/// Also by halves of the shapes, on one of which constants were set.
inline void ablation(const Dataset& dataset)
{
  std::vector<std::pair<std::string, peers::Peer>> methods{{"all", ours(default_options())}};
  const auto add = [&](const char* name, void (*change)(Part_matching_options&)) {
    Search_options options;
    change(options.parts);
    methods.emplace_back(name, ours(options));
  };
  using O = Part_matching_options;
  add("no overlap of boxes", [](O& o) { o.weights.overlap = 0; });
  add("no extents", [](O& o) { o.weights.extent = 0; });
  add("no ground contact", [](O& o) { o.weights.ground = 0; });
  add("no place", [](O& o) { o.weights.place = 0; });
  add("no orientation", [](O& o) { o.weights.orientation = 0; });
  add("no chamfer distance", [](O& o) { o.weights.chamfer = 0; });
  add("best pairs of parts only", [](O& o) { o.excess = 0; });
  add("no confident pairs, so no blocks", [](O& o) { o.confident_excess = 0; });
  add("no panels", [](O& o) { o.panels = false; });
  add("no support", [](O& o) { o.support = false; });
  Search_options plain;
  plain.parts.panels = plain.parts.support = false;
  methods.emplace_back("no panels or support", ours(plain));
  plain.parts.excess = 2;
  methods.emplace_back("nor their bound: excess 2", ours(plain));
  methods.emplace_back("no symmetry groups", without_symmetry(ours(default_options())));
  write_run_heading(dataset, "costs and rules", {"half A F1", "half B F1", "across F1"});
  for (const auto& [name, method] : methods) {
    const Run of_all = run(dataset, method);
    write_run_row(name, of_all, f1_of_halves(dataset, of_all));
  }
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
