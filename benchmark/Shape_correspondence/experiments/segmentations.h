// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// How correspondences depend on the segmentation: Figures 17, 18 and 19.
#pragma once

#include "methods.h"
#include "options.h"

#include <CGAL/Shape_correspondence/segment_mesh.h>

#include <map>
#include <numeric>

namespace CGAL::Shape_correspondence::experiments {

/// Joins the parts of a shape to one mesh and segments it; a segment takes the label of the part of its first vertex.
inline void segment_automatically(const std::string& folder, const Structural_graph& graph,
                                  const std::vector<Part_label>& labels, Structural_graph& segmented,
                                  std::vector<Part_label>& segment_labels, const std::string& cache)
{
  const Segmented_shape shape = IO::read_segmented_shape(folder);
  std::map<std::array<double, 3>, std::size_t> part_of_point;
  Part_mesh all;
  for (const Shape_part& part : shape.parts()) {
    const auto& parts = structure(graph).parts;
    const auto index = std::size_t(
        std::find_if(parts.begin(), parts.end(), [&](const auto& p) { return p.name == part.name; }) - parts.begin());
    const Eigen::Index points = all.points.cols(), triangles = all.triangles.cols();
    all.points.conservativeResize(3, points + part.mesh.points.cols());
    all.points.rightCols(part.mesh.points.cols()) = part.mesh.points;
    all.triangles.conservativeResize(3, triangles + part.mesh.triangles.cols());
    all.triangles.rightCols(part.mesh.triangles.cols()) = part.mesh.triangles.array() + int(points);
    for (Eigen::Index k = 0; k < part.mesh.points.cols(); ++k)
      part_of_point[{part.mesh.points(0, k), part.mesh.points(1, k), part.mesh.points(2, k)}] = index;
  }
  const Segmented_shape segments = segment_mesh(all, {}, shape.name()).shape;
  segmented = load_graph(segments, cache);
  segment_labels.clear();
  for (const Part_abstraction& part : structure(segmented).parts) {
    const auto found = std::find_if(segments.parts().begin(), segments.parts().end(),
                                    [&](const Shape_part& segment) { return segment.name == part.name; });
    const Points& points = found->mesh.points;
    segment_labels.push_back(labels[part_of_point.at({points(0, 0), points(1, 0), points(2, 0)})]);
  }
}

/// Figure 17: scores with the given parts of the targets, and with targets that are segmented automatically.
inline void figure17(const Dataset& dataset, const Options& options)
{
  Dataset automatic = dataset;
  std::size_t parts = 0, segments = 0;
  for (Category& category : automatic) {
    const std::size_t n = category.shapes.size();
    for (std::size_t i = 0; i < n; ++i) {
      Structural_graph graph;
      std::vector<Part_label> labels;
      segment_automatically(category.folders[i], category.graphs[i], category.labels[i], graph, labels, options.cache);
      parts += category.labels[i].size();
      segments += labels.size();
      category.shapes.push_back(category.shapes[i] + " (automatic)");
      category.graphs.push_back(std::move(graph));
      category.labels.push_back(std::move(labels));
    }
    for (peers::Shape_pair& pair : category.pairs)
      pair[1] += n;
  }
  std::cout << "Parts: " << parts << ", automatic segments: " << segments << "\n\n";
  write_run_heading(dataset, "segmentation of the target");
  for (const Search_options& method : {default_options(), paper_options()}) {
    const std::string name = method.method == Search_method::BEAM ? ", paper" : ", default";
    write_run_row("as made" + name, run(dataset, ours(method)));
    write_run_row("automatic" + name, run(automatic, ours(method)));
  }
}

inline void figure18(const Dataset& dataset, const Options& options)
{
  write_run_heading(dataset, "shapes");
  for (const Search_options& method : {default_options(), paper_options()}) {
    const std::string name = method.method == Search_method::BEAM ? ", paper" : ", default";
    for (const std::string& folder : options.data)
      write_run_row(fs::path(folder).filename().string() + name, run(load(folder, options), ours(method)));
  }
}

/// The rank of each value, 0 for the smallest.
inline std::vector<double> ranks(const std::vector<double>& values)
{
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> result(values.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    result[order[k]] = double(k);
  return result;
}

inline double rank_correlation(const std::vector<double>& a, const std::vector<double>& b)
{
  const std::vector<double> ra = ranks(a), rb = ranks(b);
  const Eigen::Map<const Eigen::ArrayXd> x(ra.data(), Eigen::Index(ra.size())), y(rb.data(), Eigen::Index(rb.size()));
  const Eigen::ArrayXd dx = x - x.mean(), dy = y - y.mean();
  return (dx * dy).sum() / std::sqrt(dx.square().sum() * dy.square().sum());
}

/// Figure 19: the sources of DATA are deformed to the targets of each folder, which differ in the segmentation;
/// energies are per contact of the source.
inline void figure19(const Dataset& dataset, const Options& options)
{
  write_heading({"segmentation of the target", "parts", "energy / contact", "F1"});
  std::vector<double> energies, scores;
  Search_options search = paper_options();
  search.both_directions = false;
  for (const std::string& folder : options.data) {
    const Dataset other = load(folder, options);
    double energy = 0, f1 = 0, parts = 0, n = 0;
    for (std::size_t c = 0; c < dataset.size(); ++c)
      for (const auto& [s, t] : dataset[c].pairs) {
        const Structural_graph &source = dataset[c].graphs[s], &target = other[c].graphs.at(t);
        const Correspondence found = find_correspondence(source, target, search);
        const double contacts = double(std::max<std::size_t>(structure(source).contacts.size(), 1));
        const Correspondence_score scored =
            evaluate_correspondence(part_pairs(found.pairs), ground_truth(dataset[c].labels[s], other[c].labels[t]));
        energies.push_back(found.energy / contacts);
        scores.push_back(scored.f1());
        energy += energies.back();
        f1 += scores.back();
        parts += double(structure(target).parts.size());
        ++n;
      }
    write_row({fs::path(folder).filename().string(), text(parts / n, 1), text(energy / n, 4), text(f1 / n)});
  }
  std::cout << "\nRank correlation of energy and F1 over all " << energies.size()
            << " correspondences: " << text(rank_correlation(energies, scores), 2) << '\n';
}

} // namespace CGAL::Shape_correspondence::experiments
