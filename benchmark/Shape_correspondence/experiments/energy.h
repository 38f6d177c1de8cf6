// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// The paper's experiments with the energy and its search: Figures 4, 10 and 11, flips, and coarse to fine.
#pragma once

#include "chart.h"
#include "options.h"
#include "tables.h"

#include <CGAL/Timer.h>

#include <algorithm>
#include <numeric>

namespace CGAL::Shape_correspondence::experiments {

inline void figure4(const Dataset& dataset)
{
  std::vector<std::pair<std::string, peers::Peer>> methods{{"all terms", ours(paper_options())}};
  const std::pair<const char*, double Energy_weights::*> terms[] = {
      {"no distortion", &Energy_weights::distortion},
      {"no connectedness", &Energy_weights::connectedness},
      {"no split", &Energy_weights::split}};
  for (const auto& [name, term] : terms) {
    Search_options options = paper_options();
    options.energy.weights.*term = 0;
    methods.emplace_back(name, ours(options));
  }
  compare(dataset, methods, "energy");
}

/// The paper's method, and variants of it with the direction, the fit or the proximity of the default, or all three.
inline void switches(const Dataset& dataset)
{
  std::vector<std::pair<std::string, peers::Peer>> methods{{"the paper's method", ours(paper_options())}};
  const auto add = [&](const char* name, const std::function<void(Search_options&)>& change) {
    Search_options options = paper_options();
    change(options);
    methods.emplace_back(name, ours(options));
  };
  add("less energy per connected pair", [](Search_options& o) { o.direction_by_energy = false; });
  add("deform-to-fit by samples", [](Search_options& o) { o.energy.fit = Deform_to_fit::SAMPLES; });
  add("soft proximity", [](Search_options& o) { o.energy.hard_proximity = false; });
  add("all three", [](Search_options& o) {
    o.direction_by_energy = o.energy.hard_proximity = false;
    o.energy.fit = Deform_to_fit::SAMPLES;
  });
  compare(dataset, methods, "method");
}

/// Flips: beam and exact search over all alignments that the shapes' symmetry allows, as in the paper, and over only
/// the alignment nearest to the given orientation.
inline void alignments(const Dataset& dataset)
{
  std::vector<std::pair<std::string, peers::Peer>> methods;
  for (const auto& [name, method] : {std::make_pair("beam", paper_options()), std::make_pair("exact", exact_options())})
    for (const int count : {0, 1}) {
      Search_options options = method;
      options.alignments = count;
      methods.emplace_back(std::string(name) + (count ? ", nearest alignment" : ", all alignments"), ours(options));
    }
  compare(dataset, methods, "search");
}

/// Energy of beam search relative to the proven least energy, mean over pairs, for some values of one of its options.
class Beam_trade_off
{
public:
  Beam_trade_off(std::string name, int Beam_options::*option, std::vector<int> values)
      : name_(std::move(name)),
        option_(option),
        values_(std::move(values)),
        excess_(values_.size(), 0),
        seconds_(values_.size(), 0),
        reached_(values_.size(), 0)
  {}

  /// Adds a pair of shapes whose least energy is proven.
  void add(const Structural_graph& source, const Structural_graph& target, double least_energy)
  {
    ++pairs_;
    for (std::size_t i = 0; i < values_.size(); ++i) {
      Search_options beam = paper_options();
      beam.alignments = 1;
      beam.both_directions = false;
      beam.beam.*option_ = values_[i];
      const double begin = now();
      const double energy = find_correspondence(source, target, beam).energy;
      seconds_[i] += now() - begin;
      excess_[i] += energy / least_energy;
      reached_[i] += energy < least_energy * (1 + 1e-6);
    }
  }

  void write(const Options& options, const std::string& file) const
  {
    std::cout << '\n';
    write_heading({name_, "energy / least energy", "reaches it", "s / pair"});
    Chart chart;
    chart.x_title = name_;
    chart.y_title = "energy / least energy, mean";
    chart.lines = {{"beam search", "#0a62c4", {}, false}, {"proven least energy", "#c43b0a", {}, true}};
    chart.y_low = chart.y_high = 1;
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const double mean = excess_[i] / pairs_;
      write_row({std::to_string(values_[i]), text(mean), text(100. * double(reached_[i]) / pairs_, 1) + " %",
                 text(seconds_[i] / pairs_, 4)});
      chart.x_marks.push_back(std::to_string(values_[i]));
      chart.lines[0].points.emplace_back(double(i), mean);
      chart.lines[1].points.emplace_back(double(i), 1);
      chart.y_high = std::max(chart.y_high, mean);
    }
    chart.y_low = 1 - .1 * (chart.y_high - 1);
    std::ofstream out = picture(options, file);
    chart.write(out);
  }

private:
  std::string name_;
  int Beam_options::*option_;
  std::vector<int> values_;
  std::vector<double> excess_, seconds_;
  std::vector<std::size_t> reached_;
  double pairs_ = 0;
};

/// Figure 10: energy of beam search over the least energy, by number of expansions k, as in the paper, and by width K.
inline void figure10(const Dataset& dataset, const Options& options)
{
  Beam_trade_off expansions("expansions k, K = 20", &Beam_options::expansions, {1, 2, 4, 8, 16}),
      width("beam width K, k = 4", &Beam_options::beam_width, {1, 2, 5, 10, 20, 50, 100});
  std::size_t proven = 0;
  for (const Category& category : dataset)
    for (const auto& [s, t] : category.pairs) {
      Search_options exact = paper_options(); // minimizes the same energy as the beam search
      exact.method = Search_method::EXACT;
      exact.exact.node_limit = exact_options().exact.node_limit;
      exact.alignments = 1;
      exact.both_directions = false;
      const Correspondence best = find_correspondence(category.graphs[s], category.graphs[t], exact);
      if (!best.optimal || !(best.energy > 0)) continue;
      ++proven;
      for (Beam_trade_off* trade_off : {&expansions, &width})
        trade_off->add(category.graphs[s], category.graphs[t], best.energy);
    }
  if (proven == 0) throw Invalid_input("the least energy of no pair is proven; there is nothing to compare with");
  std::cout << "Pairs whose least energy is proven: " << proven << '\n';
  expansions.write(options, "figure10_k.svg");
  width.write(options, "figure10.svg");
}

inline void figure11(const Dataset& dataset)
{
  write_heading({"most prominent parts", "method", "coarse P", "P", "R of all parts", "s / pair"});
  Search_options both_shapes = paper_options();
  both_shapes.coarse_target = true;
  const std::pair<const char*, Search_options> methods[] = {{"default, of both shapes", default_options()},
                                                            {"paper", paper_options()},
                                                            {"beam, of both shapes", both_shapes}};
  for (const int parts : {2, 4, 8, 16, 0})
    for (auto [name, options] : methods) {
      options.maximum_parts = parts;
      const Run of_parts = run(dataset, ours(options));
      const Mean_estimates& mean = of_parts.evaluation.mean;
      write_row({parts ? std::to_string(parts) : "all", name, text(mean.coarse_precision.mean),
                 text(mean.precision.mean), text(mean.recall.mean), text(of_parts.seconds, 4)});
    }
}

/// Coarse-to-fine search relative to the search of all parts at once, on the pairs with most parts: energy and time.
inline void coarse_to_fine(const Dataset& dataset)
{
  constexpr std::size_t most_pairs = 50;
  using Pair = std::pair<const Structural_graph*, const Structural_graph*>;
  std::vector<Pair> pairs;
  for (const Category& category : dataset)
    for (const auto& [s, t] : category.pairs)
      pairs.emplace_back(&category.graphs[s], &category.graphs[t]);
  const auto parts = [](const Pair& pair) {
    return structure(*pair.first).parts.size() + structure(*pair.second).parts.size();
  };
  std::stable_sort(pairs.begin(), pairs.end(), [&](const Pair& a, const Pair& b) { return parts(a) > parts(b); });
  pairs.resize(std::min(pairs.size(), most_pairs));
  std::cout << pairs.size() << " pairs of " << parts(pairs.back()) << " to " << parts(pairs.front()) << " parts\n";

  write_heading({"search", "parts matched first", "energy, mean", "median", "largest", "time, median"});
  for (const auto& [name, method] :
       {std::pair("beam", Search_method::BEAM), std::pair("exact", Search_method::EXACT)}) {
    std::vector<double> energies, seconds; // of the search of all parts at once
    for (const int first : {0, 6, 10, 15}) {
      Search_options options;
      options.method = method;
      options.both_directions = false;
      options.coarse_to_fine = first;
      std::vector<double> of_energies, of_seconds;
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        CGAL::Timer timer;
        timer.start();
        const double energy = find_correspondence(*pairs[i].first, *pairs[i].second, options).energy;
        if (first == 0) {
          energies.push_back(energy);
          seconds.push_back(timer.time());
        }
        of_energies.push_back(energies[i] > 0 ? energy / energies[i] : 1);
        of_seconds.push_back(seconds[i] > 0 ? timer.time() / seconds[i] : 1);
      }
      std::sort(of_energies.begin(), of_energies.end());
      std::sort(of_seconds.begin(), of_seconds.end());
      const double sum = std::accumulate(of_energies.begin(), of_energies.end(), 0.);
      write_row({name, first ? std::to_string(first) : "all", text(sum / double(pairs.size())),
                 text(of_energies[pairs.size() / 2]), text(of_energies.back()), text(of_seconds[pairs.size() / 2])});
    }
  }
}

} // namespace CGAL::Shape_correspondence::experiments
