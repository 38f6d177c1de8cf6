// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// Runs experiments, most of them those of the paper, on folders of labelled shapes; prints their tables as Markdown.

#include "experiments/abstraction.h"
#include "experiments/energy.h"
#include "experiments/gallery.h"
#include "experiments/segmentations.h"
#include "experiments/tables.h"

#include <functional>
#include <map>

using namespace CGAL::Shape_correspondence::experiments;

namespace {

constexpr int bad_input = 1, bad_usage = 2;

const char* const help_text =
    R"(Usage: experiments EXPERIMENT DATA [FURTHER_DATA...] [--out FOLDER] [--cache FOLDER] [--category A,B] [--pairs N]

DATA contains CATEGORY/SHAPE/labels.json and CATEGORY/SHAPE/parts; `generate_models --benchmark DATA` makes one. All pairs
of shapes of a category are matched, or those of DATA/pairs.json: [[CATEGORY, SOURCE, TARGET], ...].

  gallery      Figures 1 and 9: correspondences by the paper's method, on FURTHER_DATA, too; FOLDER/gallery.html
  table1       sizes of shapes and times of the search, all pairs of the gallery
  table2       co-analysis: coarse precision of labels that are consistent over a category
  table3       precision and recall against Xu et al. 2012, and without symmetry
  peers        all methods side by side
  alignments   the least energy over all alignments, or for the one nearest to the given orientation
  figure4      the energy with each term switched off
  switches     the paper's ways of fitting, of proximity and of choosing a direction, and the default's
  figure10     energy against k and K, and the proven optimum; FOLDER/figure10_k.svg, FOLDER/figure10.svg
  figure11     coarse correspondences of the most prominent parts
  coarse_to_fine  the 50 largest pairs, the most prominent parts first, against the search at once: energy and time
  figure13     correspondences through a third shape
  figure14     medoids of the categories
  figure15     ground truth of the gallery; FOLDER/figure15.html
  figure16     the most prominent parts, and Tevs et al. 2014; FOLDER/figure16.html
  figure17     automatic segmentations in place of one shape of every pair
  figure18     FURTHER_DATA damaged (generate_models --degrade): scores on each
  figure19     FURTHER_DATA segmented in other ways: energy against the quality of the correspondence
  abstraction  methods of part abstraction: deviation from structure.json, kinds, residual, scores, seconds
  reliability  how often pairs of a confidence are right; FOLDER/reliability.svg

  --out FOLDER      where pictures go; default: the current one
  --cache FOLDER    keep structural graphs there
  --category A,B    only these categories
  --pairs N         match every n-th pair only, so that a category has at most N pairs
)";

using Experiment = std::function<void(const Dataset&, const Options&)>;

template <typename Function>
Experiment of_data_alone(Function function)
{
  return [function](const Dataset& dataset, const Options&) { function(dataset); };
}

Experiment experiment(const std::string& name)
{
  const std::map<std::string, Experiment> experiments{{"gallery", gallery},
                                                      {"table1", table1},
                                                      {"table2", of_data_alone(table2)},
                                                      {"table3", of_data_alone(table3)},
                                                      {"peers", of_data_alone(compare_peers)},
                                                      {"alignments", of_data_alone(alignments)},
                                                      {"figure4", of_data_alone(figure4)},
                                                      {"switches", of_data_alone(switches)},
                                                      {"figure10", figure10},
                                                      {"figure11", of_data_alone(figure11)},
                                                      {"coarse_to_fine", of_data_alone(coarse_to_fine)},
                                                      {"figure13", of_data_alone(figure13)},
                                                      {"figure14", of_data_alone(figure14)},
                                                      {"figure15", figure15},
                                                      {"figure16", figure16},
                                                      {"figure17", figure17},
                                                      {"figure18", figure18},
                                                      {"figure19", figure19},
                                                      {"abstraction", of_data_alone(compare_abstractions)},
                                                      {"reliability", reliability}};
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
