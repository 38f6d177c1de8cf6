// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// The experiments of the paper, and others, on folders of labelled shapes; tables as Markdown on standard output.

#include "experiments/chart.h"
#include "experiments/dataset.h"
#include "experiments/methods.h"
#include "peers/peers.h"

#include <CGAL/Shape_correspondence/IO/write_html.h>
#include <CGAL/Shape_correspondence/segment_mesh.h>

#include <memory>
#include <numeric>
#include <random>
#include <set>
#include <sstream>

namespace SC = CGAL::Shape_correspondence;
namespace fs = std::filesystem;

using namespace CGAL::Shape_correspondence;
using namespace CGAL::Shape_correspondence::experiments;

namespace {

constexpr int bad_input = 1, bad_usage = 2;

const char* const help_text =
    R"(Usage: experiments EXPERIMENT DATA [FURTHER_DATA...] [--out FOLDER] [--cache FOLDER] [--category A,B] [--pairs N]

DATA holds CATEGORY/SHAPE/labels.json and CATEGORY/SHAPE/parts; `generate_models --benchmark DATA` makes one. All pairs
of shapes of a category are matched, or those of DATA/pairs.json: [[CATEGORY, SOURCE, TARGET], ...].

  table1       sizes of shapes and times of the search
  table2       co-analysis: coarse precision of labels that are consistent over a category
  table3       precision and recall against Xu et al. 2012, and without symmetry
  peers        all methods side by side
  figure4      the energy with each term switched off
  figure10     energy against beam width, the proven optimum beside it; FOLDER/figure10.svg
  figure11     coarse correspondences of the most prominent parts
  figure17     automatic segmentations in place of one shape of every pair
  figure18     FURTHER_DATA made worse (generate_models --degrade): scores on each
  figure19     FURTHER_DATA segmented otherwise: energy against the quality of the correspondence
  ablation     the default method without each of its costs and rules; by halves of the shapes, too
  pose         the default method on shapes turned about the up axis
  reliability  how often pairs of a confidence are right; FOLDER/reliability.svg
  worst        the twenty worst results with pictures; FOLDER/worst.html

  --out FOLDER      where pictures go; default: the current one
  --cache FOLDER    keep structural graphs there
  --category A,B    only these categories
  --pairs N         only every so manyth pair, so that a category has at most N
)";

struct Options
{
  std::string experiment, out = ".", cache;
  std::vector<std::string> data, categories;
  std::size_t pairs = 0; ///< 0: all
};

Dataset load(const std::string& folder, const Options& options)
{
  Dataset dataset = load_dataset(folder, options.cache, options.categories);
  for (Category& category : dataset) {
    if (options.pairs == 0 || category.pairs.size() <= options.pairs) continue;
    std::vector<peers::Shape_pair> some;
    for (std::size_t k = 0; k < options.pairs; ++k)
      some.push_back(category.pairs[k * category.pairs.size() / options.pairs]);
    category.pairs = some;
  }
  return dataset;
}

std::ofstream picture(const Options& options, const std::string& name)
{
  fs::create_directories(options.out);
  const std::string path = (fs::path(options.out) / name).string();
  std::ofstream out(path, std::ios::binary);
  if (!out) throw Invalid_input(path + ": it cannot be written");
  std::cout << '\n' << "Picture: " << name << '\n';
  return out;
}

void compare(const Dataset& dataset, const std::vector<std::pair<std::string, peers::Peer>>& methods,
             const std::string& what = "method")
{
  write_run_heading(dataset, what);
  for (const auto& [name, method] : methods)
    write_run_row(name, run(dataset, method));
}

/// The same, and by halves of the shapes, on one of which constants were set.
void compare_by_halves(const Dataset& dataset, const std::vector<std::pair<std::string, peers::Peer>>& methods,
                       const std::string& what)
{
  write_run_heading(dataset, what, {"half A F1", "half B F1", "across F1"});
  for (const auto& [name, method] : methods) {
    const Run of_all = run(dataset, method);
    write_run_row(name, of_all, f1_of_halves(dataset, of_all));
  }
}

/// The share of the pairs of equal coarse labels that was found, mean of pairs by category, then of categories.
double coarse_recall(const Dataset& dataset, const Run& run)
{
  double sum = 0;
  for (std::size_t c = 0; c < dataset.size(); ++c) {
    double of_category = 0;
    for (std::size_t k = 0; k < dataset[c].pairs.size(); ++k) {
      const auto [s, t] = dataset[c].pairs[k];
      Ground_truth truth = ground_truth(dataset[c].labels[s], dataset[c].labels[t]);
      truth.pairs = truth.coarse_pairs;
      of_category += evaluate_correspondence(run.matches[c][k], truth).recall();
    }
    sum += of_category / double(dataset[c].pairs.size());
  }
  return sum / double(dataset.size());
}

/// The largest and the smallest pair of each category, by numbers of parts.
void table1(const Dataset& dataset)
{
  write_heading({"pair", "#P_s", "#P_t", "#G_s", "#G_t", "beam s", "exact s", "proven", "parts s"});
  for (const Category& category : dataset) {
    const auto size = [&](const peers::Shape_pair& pair) {
      return num_vertices(category.graphs[pair[0]]) * num_vertices(category.graphs[pair[1]]);
    };
    const auto smaller = [&](const auto& a, const auto& b) { return size(a) < size(b); };
    const auto [least, most] = std::minmax_element(category.pairs.begin(), category.pairs.end(), smaller);
    for (const peers::Shape_pair& pair : {*least, *most}) {
      const Structural_graph &source = category.graphs[pair[0]], &target = category.graphs[pair[1]];
      std::vector<std::string> cells{category.shapes[pair[0]] + " – " + category.shapes[pair[1]],
                                     std::to_string(structure(source).parts.size()),
                                     std::to_string(structure(target).parts.size()),
                                     std::to_string(num_vertices(source)), std::to_string(num_vertices(target))};
      for (const Search_options& options : {paper_options(), exact_options(), default_options()}) {
        const double begin = now();
        const Correspondence c = find_correspondence(source, target, options);
        cells.push_back(text(now() - begin, 4));
        if (options.method == Search_method::EXACT) cells.push_back(c.optimal ? "yes" : "no");
      }
      write_row(cells);
    }
  }
}

void table2(const Dataset& dataset)
{
  const auto ours_by = [](const Search_options& options) {
    return co_analyzed([options](const Structural_graph& source, const Structural_graph& target) {
      return part_map(find_correspondence(source, target, options));
    });
  };
  const auto xu = co_analyzed([](const Structural_graph& source, const Structural_graph& target) {
    const auto [a, b] = peers::boxed_pair(source, target);
    const Part_pairs pairs = peers::match_xu_2012(a, b);
    return Part_map{pairs, std::vector<double>(pairs.size(), 1)};
  });
  std::vector<std::string> heading{"method"};
  for (const Category& category : dataset)
    heading.push_back(category.name);
  heading.insert(heading.end(), {"mean coarse P", "95 %", "mean coarse R"});
  write_heading(heading);
  const std::pair<const char*, peers::Peer> methods[] = {{"Xu et al. 2012, clustered", xu},
                                                         {"Zheng et al. 2014", peers::match_zheng_2014},
                                                         {"Kim et al. 2013", peers::match_kim_2013},
                                                         {"the paper's method", ours_by(paper_options())},
                                                         {"default", ours_by(default_options())}};
  for (const auto& [name, method] : methods) {
    const Run of_set = run(dataset, method);
    std::vector<std::string> cells{name};
    for (const auto& [category, mean] : of_set.evaluation.categories)
      cells.push_back(text(mean.coarse_precision.mean, 2));
    const Estimate& precision = of_set.evaluation.mean.coarse_precision;
    cells.push_back(text(precision.mean));
    cells.push_back(text(precision.low, 2) + "–" + text(precision.high, 2));
    cells.push_back(text(coarse_recall(dataset, of_set)));
    write_row(cells);
  }
}

void table3(const Dataset& dataset)
{
  const peers::Peer paper = ours(paper_options());
  compare(dataset, {{"Xu et al. 2012", peers::pairwise(peers::match_xu_2012)},
                    {"the paper's method, no symmetry", without_symmetry(paper)},
                    {"the paper's method", paper},
                    {"default, no symmetry", without_symmetry(ours(default_options()))},
                    {"default", ours(default_options())}});
}

void compare_peers(const Dataset& dataset)
{
  std::vector<std::pair<std::string, peers::Peer>> methods{{"default", ours(default_options())},
                                                           {"the paper's method (beam)", ours(paper_options())},
                                                           {"least energy (exact)", ours(exact_options())}};
  for (const peers::Named_peer& peer : peers::all_peers())
    methods.emplace_back(peer.name, peer.match);
  compare(dataset, methods);
  std::cout << "\nSimplified:\n";
  for (const peers::Named_peer& peer : peers::all_peers())
    if (peer.simplified != "-") std::cout << "- " << peer.name << ": " << peer.simplified << '\n';
}

void figure4(const Dataset& dataset)
{
  std::vector<std::pair<std::string, peers::Peer>> methods{{"all terms", ours(paper_options())}};
  const std::pair<const char*, double Energy_weights::*> terms[] = {
      {"no distortion", &Energy_weights::distortion},
      {"no connectedness", &Energy_weights::connectedness},
      {"no split", &Energy_weights::split}};
  for (const auto& [name, term] : terms) {
    Search_options options = paper_options();
    options.matching.weights.*term = 0;
    methods.emplace_back(name, ours(options));
  }
  compare(dataset, methods, "energy");
}

/// Over all pairs, energies relative to the least proven one.
void figure10(const Dataset& dataset, const Options& options)
{
  const std::vector<int> widths{1, 2, 5, 10, 20, 50, 100};
  std::vector<double> excess(widths.size(), 0), seconds(widths.size(), 0);
  std::vector<std::size_t> reached(widths.size(), 0);
  std::size_t proven = 0;
  for (const Category& category : dataset)
    for (const auto& [s, t] : category.pairs) {
      Search_options exact = exact_options();
      exact.both_directions = false;
      const Correspondence best = find_correspondence(category.graphs[s], category.graphs[t], exact);
      if (!best.optimal || !(best.energy > 0)) continue;
      ++proven;
      for (std::size_t k = 0; k < widths.size(); ++k) {
        Search_options beam = paper_options();
        beam.both_directions = false;
        beam.beam.beam_width = widths[k];
        const double begin = now();
        const double energy = find_correspondence(category.graphs[s], category.graphs[t], beam).energy;
        seconds[k] += now() - begin;
        excess[k] += energy / best.energy;
        reached[k] += energy < best.energy * (1 + 1e-6);
      }
    }
  if (proven == 0) throw Invalid_input("the least energy of no pair is proven; there is nothing to compare with");
  std::cout << "Pairs whose least energy is proven: " << proven << "\n\n";
  write_heading({"beam width K", "energy / least energy", "reaches it", "s / pair"});
  Chart chart;
  chart.x_title = "beam width K";
  chart.y_title = "energy / least energy, mean";
  chart.lines = {{"beam search, k = 4", "#0a62c4", {}, false}, {"proven least energy", "#c43b0a", {}, true}};
  chart.y_low = chart.y_high = 1;
  for (std::size_t k = 0; k < widths.size(); ++k) {
    const double mean = excess[k] / double(proven);
    write_row({std::to_string(widths[k]), text(mean), text(100. * double(reached[k]) / double(proven), 1) + " %",
               text(seconds[k] / double(proven), 4)});
    chart.x_marks.push_back(std::to_string(widths[k]));
    chart.lines[0].points.emplace_back(double(k), mean);
    chart.lines[1].points.emplace_back(double(k), 1);
    chart.y_high = std::max(chart.y_high, mean);
  }
  chart.y_low = 1 - .1 * (chart.y_high - 1);
  std::ofstream out = picture(options, "figure10.svg");
  chart.write(out);
}

void figure11(const Dataset& dataset)
{
  write_heading({"most prominent parts", "method", "coarse P", "P", "R of all parts", "s / pair"});
  for (const int parts : {2, 4, 8, 16, 0})
    for (Search_options options : {default_options(), paper_options()}) {
      options.maximum_parts = parts;
      const Run of_parts = run(dataset, ours(options));
      const Mean_score& mean = of_parts.evaluation.mean;
      write_row({parts ? std::to_string(parts) : "all", options.method == Search_method::BEAM ? "paper" : "default",
                 text(mean.coarse_precision.mean), text(mean.precision.mean), text(mean.recall.mean),
                 text(of_parts.seconds, 4)});
    }
}

/// The shape as one mesh, segmented by the shape diameter function; a segment has the label of the part it is of.
void segment_automatically(const std::string& folder, const Structural_graph& graph,
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

/// The targets are segmented automatically.
void figure17(const Dataset& dataset, const Options& options)
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

void figure18(const Dataset& dataset, const Options& options)
{
  write_run_heading(dataset, "shapes");
  for (const Search_options& method : {default_options(), paper_options()}) {
    const std::string name = method.method == Search_method::BEAM ? ", paper" : ", default";
    for (const std::string& folder : options.data)
      write_run_row(fs::path(folder).filename().string() + name, run(load(folder, options), ours(method)));
  }
}

/// The place of each value among all, the smallest first.
std::vector<double> ranks(const std::vector<double>& values)
{
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> result(values.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    result[order[k]] = double(k);
  return result;
}

double rank_correlation(const std::vector<double>& a, const std::vector<double>& b)
{
  const std::vector<double> ra = ranks(a), rb = ranks(b);
  const Eigen::Map<const Eigen::ArrayXd> x(ra.data(), Eigen::Index(ra.size())), y(rb.data(), Eigen::Index(rb.size()));
  const Eigen::ArrayXd dx = x - x.mean(), dy = y - y.mean();
  return (dx * dy).sum() / std::sqrt(dx.square().sum() * dy.square().sum());
}

/// Sources as made are deformed into targets of each segmentation; energies are per pair of connected parts.
void figure19(const Dataset& dataset, const Options& options)
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
            evaluate_correspondence(found.pairs, ground_truth(dataset[c].labels[s], other[c].labels[t]));
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

void ablation(const Dataset& dataset)
{
  std::vector<std::pair<std::string, peers::Peer>> methods{{"all", ours(default_options())}};
  const std::pair<const char*, double Part_cost_weights::*> weights[] = {
      {"no overlap of boxes", &Part_cost_weights::overlap}, {"no extents", &Part_cost_weights::extent},
      {"no ground contact", &Part_cost_weights::ground},    {"no place sideways", &Part_cost_weights::side},
      {"no place to the front", &Part_cost_weights::front}, {"no orientation", &Part_cost_weights::orientation},
      {"no chamfer distance", &Part_cost_weights::chamfer}, {"no contacts", &Part_cost_weights::contacts}};
  for (const auto& [name, weight] : weights) {
    Search_options options;
    options.parts.weights.*weight = 0;
    methods.emplace_back(name, ours(options));
  }
  constexpr double never = 1e6;
  const std::tuple<const char*, double Part_matching_options::*, double> rules[] = {
      {"best pairs of parts only", &Part_matching_options::excess, 0},
      {"no sure pairs, so no blocks", &Part_matching_options::sure_excess, 0},
      {"no siblings", &Part_matching_options::sibling, 0},
      {"nothing turned over", &Part_matching_options::upside_down, never}};
  for (const auto& [name, rule, value] : rules) {
    Search_options options;
    options.parts.*rule = value;
    methods.emplace_back(name, ours(options));
  }
  const std::pair<const char*, bool Part_matching_options::*> wholes[] = {
      {"no panels", &Part_matching_options::panels},
      {"no support", &Part_matching_options::support},
      {"no alike legs", &Part_matching_options::alike_legs},
      {"no chains", &Part_matching_options::chains}};
  for (const auto& [name, whole] : wholes) {
    Search_options options;
    options.parts.*whole = false;
    methods.emplace_back(name, ours(options));
  }
  Search_options plain;
  plain.parts.panels = plain.parts.support = plain.parts.chains = false;
  plain.parts.upside_down = never;
  methods.emplace_back("nothing turned over, no panels, support or chains", ours(plain));
  plain.parts.excess = 2;
  plain.parts.sibling = 4;
  methods.emplace_back("nor their bounds: excess 2, sibling 4", ours(plain));
  methods.emplace_back("no symmetry groups", without_symmetry(ours(default_options())));
  compare_by_halves(dataset, methods, "costs and rules");
}

/// The graph turned about the up axis, as if its meshes had been.
Structural_graph turned(const Structural_graph& graph, double angle)
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
      result.push_back(find_correspondence(source, target, options).pairs);
    }
    return result;
  };
}

/// The pairs of shapes that have one mirror plane; categories without such pairs are left out.
Dataset of_shapes_with_front(const Dataset& dataset)
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

void pose(const Dataset& dataset)
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

void reliability(const Dataset& dataset, const Options& options)
{
  constexpr int bins = 10;
  std::vector<double> confidence(bins, 0), right(bins, 0), count(bins, 0);
  double error = 0, total = 0;
  for (const Category& category : dataset)
    for (const auto& [s, t] : category.pairs) {
      const Correspondence c = find_correspondence(category.graphs[s], category.graphs[t]);
      const Ground_truth truth = ground_truth(category.labels[s], category.labels[t]);
      for (std::size_t k = 0; k < c.confidences.size(); ++k) {
        const int bin = std::min(int(c.confidences[k] * bins), bins - 1);
        confidence[std::size_t(bin)] += c.confidences[k];
        right[std::size_t(bin)] += std::binary_search(truth.pairs.begin(), truth.pairs.end(), c.pairs[k]);
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

std::string named_pairs(const Part_pairs& pairs, const Category& category, std::size_t s, std::size_t t)
{
  std::string result;
  for (const auto& [i, j] : pairs) {
    const auto name = [&](std::size_t shape, std::size_t part) {
      const Part_label& label = category.labels[shape][part];
      return structure(category.graphs[shape]).parts[part].name + " (" +
             (label.fine.empty() ? label.coarse : label.fine) + ")";
    };
    result += (result.empty() ? "" : ", ") + name(s, i) + " – " + name(t, j);
  }
  return result.empty() ? "none" : result;
}

Part_pairs difference(const Part_pairs& a, const Part_pairs& b)
{
  Part_pairs result;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

/// Pages of the results of least F1, and an index of them with what is wrong and what is missed.
void worst(const Dataset& dataset, const Options& options)
{
  struct Result
  {
    const Category* category;
    peers::Shape_pair pair;
    Correspondence correspondence;
    Correspondence_score score;
  };
  constexpr std::size_t shown = 20;
  std::vector<Result> results;
  for (const Category& category : dataset)
    for (const auto& pair : category.pairs) {
      Correspondence c = find_correspondence(category.graphs[pair[0]], category.graphs[pair[1]]);
      const Ground_truth truth = ground_truth(category.labels[pair[0]], category.labels[pair[1]]);
      const Correspondence_score scored = evaluate_correspondence(c.pairs, truth);
      results.push_back({&category, pair, std::move(c), scored});
    }
  std::stable_sort(results.begin(), results.end(),
                   [](const Result& a, const Result& b) { return a.score.f1() < b.score.f1(); });
  results.resize(std::min(results.size(), shown));
  std::ofstream index = picture(options, "worst.html");
  index << "<!DOCTYPE html><meta charset=\"utf-8\"><title>Worst results</title><style>body{font:14px sans-serif}"
           "iframe{width:100%;height:480px;border:1px solid #ccc}</style>\n";
  write_heading({"category", "source", "target", "P", "R", "F1"});
  for (std::size_t k = 0; k < results.size(); ++k) {
    const auto& [category, pair, correspondence, scored] = results[k];
    const auto [s, t] = pair;
    write_row({category->name, category->shapes[s], category->shapes[t], text(scored.precision(), 2),
               text(scored.recall(), 2), text(scored.f1(), 2)});
    const Segmented_shape source = IO::read_segmented_shape(category->folders[s]),
                          target = IO::read_segmented_shape(category->folders[t]);
    const std::string page = "worst_" + std::to_string(k + 1) + ".html";
    std::ofstream out((fs::path(options.out) / page).string(), std::ios::binary);
    IO::write_correspondence_html(out, correspondence, category->graphs[s], category->graphs[t], &source, &target);
    const Ground_truth truth = ground_truth(category->labels[s], category->labels[t]);
    index << "<h3>" << k + 1 << ". " << category->name << ": " << category->shapes[s] << " – " << category->shapes[t]
          << ", F1 " << text(scored.f1(), 2)
          << "</h3><p>Wrong: " << named_pairs(difference(correspondence.pairs, truth.pairs), *category, s, t)
          << "</p><p>Missed: " << named_pairs(difference(truth.pairs, correspondence.pairs), *category, s, t)
          << "</p><details><summary>Picture</summary><iframe loading=\"lazy\" src=\"" << page
          << "\"></iframe></details>\n";
  }
}

std::vector<std::string> words(const std::string& list)
{
  std::vector<std::string> result;
  std::istringstream in(list);
  for (std::string word; std::getline(in, word, ',');)
    result.push_back(word);
  return result;
}

Options parsed(int argc, char** argv)
{
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    const auto value = [&] {
      if (++i == argc) throw std::invalid_argument(argument + " needs a value");
      return std::string(argv[i]);
    };
    if (argument == "--out")
      options.out = value();
    else if (argument == "--cache")
      options.cache = value();
    else if (argument == "--category")
      options.categories = words(value());
    else if (argument == "--pairs") {
      const std::string number = value();
      if (number.empty() || number.size() > 9 || number.find_first_not_of("0123456789") != std::string::npos)
        throw std::invalid_argument("--pairs is a number, not '" + number + "'");
      options.pairs = std::stoul(number);
    } else if (argument.empty() || argument[0] == '-')
      throw std::invalid_argument("unknown option '" + argument + "'");
    else if (options.experiment.empty())
      options.experiment = argument;
    else
      options.data.push_back(argument);
  }
  if (options.data.empty()) throw std::invalid_argument("no experiment, or no data");
  return options;
}

using Experiment = std::function<void(const Dataset&, const Options&)>;

template <typename Function>
Experiment of_data_alone(Function function)
{
  return [function](const Dataset& dataset, const Options&) { function(dataset); };
}

Experiment experiment(const std::string& name)
{
  const std::map<std::string, Experiment> experiments{{"table1", of_data_alone(table1)},
                                                      {"table2", of_data_alone(table2)},
                                                      {"table3", of_data_alone(table3)},
                                                      {"peers", of_data_alone(compare_peers)},
                                                      {"figure4", of_data_alone(figure4)},
                                                      {"figure10", figure10},
                                                      {"figure11", of_data_alone(figure11)},
                                                      {"figure17", figure17},
                                                      {"figure18", figure18},
                                                      {"figure19", figure19},
                                                      {"ablation", of_data_alone(ablation)},
                                                      {"pose", of_data_alone(pose)},
                                                      {"reliability", reliability},
                                                      {"worst", worst}};
  const auto found = experiments.find(name);
  if (found == experiments.end()) throw std::invalid_argument("there is no experiment '" + name + "'");
  return found->second;
}

} // namespace

int main(int argc, char** argv)
{
  if (argc == 2 && (std::string(argv[1]) == "--help" || std::string(argv[1]) == "-h")) {
    std::cout << help_text;
    return 0;
  }
  try {
    const Options options = parsed(argc, argv);
    const Experiment made = experiment(options.experiment);
    made(load(options.data[0], options), options);
  } catch (const std::invalid_argument& error) {
    std::cerr << "experiments: " << error.what() << " (see --help)\n";
    return bad_usage;
  } catch (const std::exception& error) {
    std::cerr << "experiments: " << error.what() << '\n';
    return bad_input;
  }
}
