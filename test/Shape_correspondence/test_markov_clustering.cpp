// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "model_files.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/markov_clustering.h>

#include <Eigen/SparseCore>

#include <catch2/catch.hpp>

#include <cstdlib>
#include <map>
#include <random>
#include <sstream>
#include <tuple>

using namespace CGAL::Shape_correspondence;

namespace {

using Weights = Eigen::SparseMatrix<double>;
using Labels = std::vector<std::size_t>;

Weights weights_of(int n, const std::vector<std::tuple<int, int, double>>& edges)
{
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& [i, j, weight] : edges) {
    entries.emplace_back(i, j, weight);
    entries.emplace_back(j, i, weight);
  }
  Weights result(n, n);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

// A random graph of groups of nodes; `within` and `between` are the probabilities of edges in and between groups.
Weights planted(int groups, int size, double within, double between, unsigned seed)
{
  std::mt19937 random(seed);
  const auto unit = [&] { return double(random() % 1000) / 1000; };
  std::vector<std::tuple<int, int, double>> edges;
  for (int i = 0; i < groups * size; ++i)
    for (int j = 0; j < i; ++j)
      if (unit() < (i / size == j / size ? within : between)) edges.emplace_back(i, j, .2 + .8 * unit());
  return weights_of(groups * size, edges);
}

// The clusters found by van Dongen's program.
Labels labels_by_mcl(const Weights& weights, double inflation)
{
  const model_files::Temporary_folder folder;
  std::ostringstream edges;
  edges.precision(17);
  for (int j = 0; j < weights.outerSize(); ++j) {
    edges << j << ' ' << j << " 0\n"; // declares isolated nodes
    for (Weights::InnerIterator entry(weights, j); entry; ++entry)
      edges << entry.row() << ' ' << j << ' ' << entry.value() << '\n';
  }
  const std::string in = folder.write("graph", edges.str()), out = folder.path("clusters");
  REQUIRE(std::system(("mcl " + in + " --abc -I " + std::to_string(inflation) + " -o " + out + " >" +
                       folder.path("log") + " 2>&1")
                          .c_str()) == 0);
  Labels labels(std::size_t(weights.cols()), std::size_t(-1));
  std::istringstream lines(model_files::text_of(out));
  std::string line;
  for (std::size_t cluster = 0; std::getline(lines, line); ++cluster) {
    std::istringstream nodes(line);
    for (std::size_t node; nodes >> node;)
      labels[node] = cluster;
  }
  return labels;
}

// Labels in the order of first nodes, as in markov_clustering().
Labels renumbered(const Labels& labels)
{
  std::map<std::size_t, std::size_t> number;
  Labels result;
  for (std::size_t label : labels)
    result.push_back(number.emplace(label, number.size()).first->second);
  return result;
}

} // namespace

TEST_CASE("Components are clusters, lonely nodes too")
{
  const Markov_clustering result = markov_clustering(weights_of(6, {{0, 2, 1}, {2, 5, 1}, {0, 5, 1}, {1, 4, .3}}));
  CHECK(result.labels == Labels{0, 1, 0, 2, 1, 0});
  CHECK(result.number_of_clusters == 3);
  CHECK(result.converged);
  CHECK(markov_clustering(Weights(0, 0)).labels.empty());
}

TEST_CASE("A weak edge between two dense groups is cut")
{
  std::vector<std::tuple<int, int, double>> edges;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < i; ++j) {
      edges.emplace_back(i, j, 1);
      edges.emplace_back(i + 4, j + 4, 1);
    }
  edges.emplace_back(3, 4, 1);
  CHECK(markov_clustering(weights_of(8, edges)).labels == Labels{0, 0, 0, 0, 1, 1, 1, 1});
}

TEST_CASE("Two connected nodes share their flow half and half, which is a fixed point, and are one cluster")
{
  const Markov_clustering result = markov_clustering(weights_of(2, {{0, 1, .7}}));
  CHECK(result.labels == Labels{0, 0});
  CHECK(result.iterations == 1);
}

TEST_CASE("More inflation makes no fewer clusters")
{
  const Weights weights = planted(5, 8, .7, .1, 3);
  Markov_clustering_options low, high;
  low.inflation = 1.3;
  high.inflation = 4;
  CHECK(markov_clustering(weights, low).number_of_clusters <= markov_clustering(weights, high).number_of_clusters);
}

TEST_CASE("The scale of weights and the entries of the diagonal change nothing")
{
  const Weights weights = planted(4, 6, .8, .1, 1);
  Weights other = 8 * weights;
  other.coeffRef(2, 2) = 100;
  CHECK(markov_clustering(other).labels == markov_clustering(weights).labels);
}

TEST_CASE("The same clusters as van Dongen's program mcl")
{
  if (std::system("mcl --version >/dev/null 2>&1") != 0) {
    WARN("mcl is not installed; not compared");
    return;
  }
  for (unsigned seed = 0; seed < 6; ++seed)
    for (double inflation : {1.4, 2., 3.}) {
      const Weights weights = planted(6, 10, .7, .04, seed);
      Markov_clustering_options options;
      options.inflation = inflation;
      CHECK(markov_clustering(weights, options).labels == renumbered(labels_by_mcl(weights, inflation)));
    }
}

TEST_CASE("Dense groups are found with a limit on all entries together, too")
{
  const Weights weights = planted(20, 8, 1, .01, 5);
  Markov_clustering_options options;
  options.entry_limit = 160 * 10; // ten for each column
  const Markov_clustering result = markov_clustering(weights, options);
  CHECK(result.number_of_clusters == 20);
  CHECK(result.labels == markov_clustering(weights).labels);
  options.entry_limit = 0;
  CHECK_THROWS_AS(markov_clustering(weights, options), Invalid_input);
}

TEST_CASE("Weights and options that cannot be used are refused")
{
  CHECK_THROWS_AS(markov_clustering(weights_of(2, {{0, 1, -1}})), Invalid_input);
  CHECK_THROWS_AS(markov_clustering(weights_of(2, {{0, 1, std::nan("")}})), Invalid_input);
  Markov_clustering_options options;
  options.inflation = 1;
  CHECK_THROWS_AS(markov_clustering(weights_of(2, {{0, 1, 1}}), options), Invalid_input);
}
