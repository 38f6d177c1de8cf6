// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// Pictures and uses of correspondences in the paper: Figures 1, 9 and 13 to 16, and Table 1.
#pragma once

#include "../peers/peers.h"
#include "methods.h"
#include "options.h"

#include <CGAL/Shape_correspondence/IO/write_html.h>
#include <CGAL/Shape_correspondence/energy_matrix.h>
#include <CGAL/Shape_correspondence/topological_medoid.h>

#include <algorithm>
#include <numeric>

namespace CGAL::Shape_correspondence::experiments {

/// The paper's main example: a bicycle and a tricycle.
constexpr const char* main_example[] = {"velocipede_1", "velocipede_10"};

/// The pairs of a category that are shown: the main example, if it is in the category, and the smallest, the median and
/// the largest pair by the product of the numbers of groups.
inline std::vector<peers::Shape_pair> gallery_pairs(const Category& category)
{
  std::vector<peers::Shape_pair> pairs = category.pairs;
  const auto size = [&](const peers::Shape_pair& pair) {
    return num_vertices(category.graphs[pair[0]]) * num_vertices(category.graphs[pair[1]]);
  };
  std::stable_sort(pairs.begin(), pairs.end(), [&](const auto& a, const auto& b) { return size(a) < size(b); });
  std::vector<peers::Shape_pair> shown = pairs;
  if (pairs.size() > 3) shown = {pairs.front(), pairs[pairs.size() / 2], pairs.back()};
  for (const auto& [s, t] : pairs) {
    const std::string &source = category.shapes[s], &target = category.shapes[t];
    if (source == main_example[0] && target == main_example[1]) shown.insert(shown.begin(), {s, t});
    if (source == main_example[1] && target == main_example[0]) shown.insert(shown.begin(), {t, s});
  }
  return shown;
}

/// HTML pages with one picture each, and an index page that embeds them.
class Picture_pages
{
public:
  Picture_pages(const Options& options, const std::string& name, const std::string& title)
      : options_(options), name_(name), index_(picture(options, name + ".html"))
  {
    index_
        << "<!DOCTYPE html><meta charset=\"utf-8\"><title>" << title
        << "</title><style>body{font:14px sans-serif}iframe{width:100%;height:480px;border:1px solid #ccc}</style>\n";
  }

  /// Adds the page of a correspondence. \param text HTML below the heading
  void add(const std::string& heading, const Category& category, const peers::Shape_pair& pair,
           const Correspondence& correspondence, const std::string& text = "")
  {
    const auto [s, t] = pair;
    const Segmented_shape source = IO::read_segmented_shape(category.folders[s]),
                          target = IO::read_segmented_shape(category.folders[t]);
    const std::string page = name_ + "_" + std::to_string(++count_) + ".html";
    std::ofstream out((fs::path(options_.out) / page).string(), std::ios::binary);
    IO::write_correspondence_html(out, correspondence, category.graphs[s], category.graphs[t], &source, &target);
    index_ << "<h3>" << count_ << ". " << heading << "</h3>" << text
           << "<details><summary>Picture</summary><iframe loading=\"lazy\" src=\"" << page
           << "\"></iframe></details>\n";
  }

private:
  const Options& options_;
  std::string name_;
  std::ofstream index_;
  std::size_t count_ = 0;
};

inline std::string pair_name(const Category& category, const peers::Shape_pair& pair)
{
  return category.shapes[pair[0]] + " – " + category.shapes[pair[1]];
}

/// Figures 1 and 9: correspondences by the paper's method, matched parts in one colour, unmatched parts grey.
inline void gallery(const Dataset& of_data, const Options& options)
{
  const Dataset dataset = with_further_data(of_data, options);
  Picture_pages pages(options, "gallery", "Correspondences by the paper's method");
  write_heading({"pair", "energy", "deformed", "pairs of parts", "unmatched"});
  for (const Category& category : dataset)
    for (const peers::Shape_pair& pair : gallery_pairs(category)) {
      const Correspondence c = find_correspondence(category.graphs[pair[0]], category.graphs[pair[1]], paper_options());
      pages.add(pair_name(category, pair), category, pair, c);
      write_row({pair_name(category, pair), text(c.energy),
                 c.direction == Direction::SOURCE_TO_TARGET ? "source" : "target", std::to_string(c.pairs.size()),
                 std::to_string(c.unmatched_source.size() + c.unmatched_target.size())});
    }
}

/// Table 1: numbers of parts (#P) and groups (#G), and seconds of each search, for the pairs of the gallery.
inline void table1(const Dataset& of_data, const Options& options)
{
  const Dataset dataset = with_further_data(of_data, options);
  write_heading({"pair", "#P_s", "#P_t", "#G_s", "#G_t", "beam s", "exact s", "proven", "parts s"});
  for (const Category& category : dataset)
    for (const peers::Shape_pair& pair : gallery_pairs(category)) {
      const Structural_graph &source = category.graphs[pair[0]], &target = category.graphs[pair[1]];
      std::vector<std::string> cells{pair_name(category, pair), std::to_string(structure(source).parts.size()),
                                     std::to_string(structure(target).parts.size()),
                                     std::to_string(num_vertices(source)), std::to_string(num_vertices(target))};
      for (const Search_options& search : {paper_options(), exact_options(), default_options()}) {
        const double begin = now();
        const Correspondence c = find_correspondence(source, target, search);
        cells.push_back(text(now() - begin, 4));
        if (search.method == Search_method::EXACT) cells.push_back(c.optimal ? "yes" : "no");
      }
      write_row(cells);
    }
}

/// The energies of all ordered pairs of a category by the paper's method.
inline Energy_matrix paper_energies(const Category& category)
{
  Energy_matrix_options options;
  options.search = paper_options();
  return energy_matrix<Parallel_if_available_tag>(category.graphs, options);
}

/// Figure 13: pairs with less energy by way of a third shape; F1 of the direct and of the composed correspondence.
inline void figure13(const Dataset& dataset)
{
  write_heading(
      {"category", "pairs", "by way of a third shape", "energy over the direct one", "F1 directly", "F1 by way of it"});
  for (const Category& category : dataset) {
    const Energy_matrix matrix = paper_energies(category);
    std::size_t bridged = 0;
    double ratio = 0, direct = 0, by_way = 0;
    for (const auto& [s, t] : category.pairs) {
      const double energy = matrix.energies(Eigen::Index(s), Eigen::Index(t));
      Eigen::VectorXd by_bridge =
          matrix.energies.row(Eigen::Index(s)).transpose() + matrix.energies.col(Eigen::Index(t));
      for (std::size_t end : {s, t})
        by_bridge[Eigen::Index(end)] = energy;
      Eigen::Index bridge;
      if (!(by_bridge.minCoeff(&bridge) < energy)) continue;
      const Part_map map = composed(matrix.map(s, std::size_t(bridge)), matrix.map(std::size_t(bridge), t));
      const Ground_truth truth = ground_truth(category.labels[s], category.labels[t]);
      ++bridged;
      ratio += by_bridge[bridge] / energy;
      direct += evaluate_correspondence(part_pairs(matrix.map(s, t).pairs), truth).f1();
      by_way += evaluate_correspondence(part_pairs(map.pairs), truth).f1();
    }
    const auto mean = [&](double sum) { return bridged ? text(sum / double(bridged)) : "-"; };
    write_row({category.name, std::to_string(category.pairs.size()), std::to_string(bridged), mean(ratio), mean(direct),
               mean(by_way)});
  }
}

/// Figure 14: the medoid of each category by the paper's energy, and the shape that is farthest from the others.
inline void figure14(const Dataset& dataset)
{
  write_heading({"category", "shapes", "medoid", "mean distance", "farthest shape", "mean distance"});
  for (const Category& category : dataset) {
    if (category.graphs.size() < 2) continue;
    const Eigen::MatrixXd distances = symmetric_distances(paper_energies(category).energies);
    const Eigen::VectorXd means = distances.rowwise().sum() / double(distances.rows() - 1);
    const std::size_t medoid = topological_medoid(distances);
    Eigen::Index farthest;
    means.maxCoeff(&farthest);
    write_row({category.name, std::to_string(category.shapes.size()), category.shapes[medoid],
               text(means[Eigen::Index(medoid)]), category.shapes[std::size_t(farthest)], text(means[farthest])});
  }
}

inline Correspondence correspondence_of(const Part_pairs& pairs)
{
  Correspondence result;
  result.complete = true;
  for (const auto& [i, j] : pairs)
    result.pairs.push_back({i, j});
  return result;
}

/// Figure 15: the ground truth by fine and by coarse labels, for the pairs of the gallery.
inline void figure15(const Dataset& of_data, const Options& options)
{
  const Dataset dataset = with_further_data(of_data, options);
  Picture_pages pages(options, "figure15", "Ground truth");
  write_heading({"pair", "pairs of parts", "with equal coarse labels"});
  for (const Category& category : dataset)
    for (const peers::Shape_pair& pair : gallery_pairs(category)) {
      const Ground_truth truth = ground_truth(category.labels[pair[0]], category.labels[pair[1]]);
      for (const Part_pairs* pairs : {&truth.pairs, &truth.coarse_pairs}) {
        const char* level = pairs == &truth.pairs ? ", fine" : ", coarse";
        pages.add(pair_name(category, pair) + level, category, pair, correspondence_of(*pairs));
      }
      write_row(
          {pair_name(category, pair), std::to_string(truth.pairs.size()), std::to_string(truth.coarse_pairs.size())});
    }
}

/// A method, restricted to pairs whose source part is one of the `count` parts of largest volume.
inline peers::Peer of_prominent_parts(const peers::Peer& method, std::size_t count)
{
  return [method, count](const std::vector<Structural_graph>& shapes, const std::vector<peers::Shape_pair>& pairs) {
    std::vector<Part_pairs> result = method(shapes, pairs);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const auto& parts = structure(shapes[pairs[k][0]]).parts;
      std::vector<std::size_t> order(parts.size());
      std::iota(order.begin(), order.end(), std::size_t(0));
      std::stable_sort(order.begin(), order.end(),
                       [&](std::size_t a, std::size_t b) { return parts[a].volume > parts[b].volume; });
      order.resize(std::min(order.size(), count));
      const auto is_lesser = [&](const auto& pair) {
        return std::find(order.begin(), order.end(), pair.first) == order.end();
      };
      result[k].erase(std::remove_if(result[k].begin(), result[k].end(), is_lesser), result[k].end());
    }
    return result;
  };
}

/// Figure 16: precision on the most prominent parts, also of Tevs et al. 2014; pictures of the pairs of the gallery.
inline void figure16(const Dataset& dataset, const Options& options)
{
  constexpr std::size_t counts[] = {2, 4, 8}, pictured = 4;
  const std::pair<const char*, peers::Peer> methods[] = {{"Tevs et al. 2014", peers::pairwise(peers::match_tevs_2014)},
                                                         {"the paper's method", ours(paper_options())},
                                                         {"default", ours(default_options())}};
  Picture_pages pages(options, "figure16", "The " + std::to_string(pictured) + " most prominent parts");
  for (const Category& category : dataset)
    for (const peers::Shape_pair& pair : gallery_pairs(category))
      for (const auto& [name, method] : methods) {
        const Part_pairs pairs = of_prominent_parts(method, pictured)(category.graphs, {pair}).front();
        pages.add(pair_name(category, pair) + ", " + name, category, pair, correspondence_of(pairs));
      }
  write_heading({"most prominent parts of the source", "method", "P", "coarse P", "R of all parts"});
  for (const std::size_t count : counts)
    for (const auto& [name, method] : methods) {
      const Mean_estimates mean = run(dataset, of_prominent_parts(method, count)).evaluation.mean;
      write_row({std::to_string(count), name, text(mean.precision.mean), text(mean.coarse_precision.mean),
                 text(mean.recall.mean)});
    }
}

} // namespace CGAL::Shape_correspondence::experiments
