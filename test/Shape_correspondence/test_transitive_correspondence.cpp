// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/transitive_correspondence.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/kruskal_min_spanning_tree.hpp>

#include <catch2/catch.hpp>

#include <iterator>
#include <random>

using namespace CGAL::Shape_correspondence;

namespace {

using Shapes = std::vector<std::size_t>;

Eigen::MatrixXd random_distances(Eigen::Index n, unsigned seed)
{
  std::mt19937 random(seed);
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < i; ++j)
      result(i, j) = result(j, i) = 1 + double(random() % 1000);
  return result;
}

double sum_of(const std::vector<Shape_pair>& tree, const Eigen::MatrixXd& distances)
{
  double sum = 0;
  for (const auto& [a, b] : tree)
    sum += distances(Eigen::Index(a), Eigen::Index(b));
  return sum;
}

double kruskal_sum(const Eigen::MatrixXd& distances)
{
  using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                                      boost::property<boost::edge_weight_t, double>>;
  Graph graph{std::size_t(distances.rows())};
  for (Eigen::Index i = 0; i < distances.rows(); ++i)
    for (Eigen::Index j = 0; j < i; ++j)
      add_edge(std::size_t(i), std::size_t(j), distances(i, j), graph);
  std::vector<Graph::edge_descriptor> edges;
  kruskal_minimum_spanning_tree(graph, std::back_inserter(edges));
  double sum = 0;
  for (const auto& edge : edges)
    sum += get(boost::edge_weight, graph, edge);
  return sum;
}

} // namespace

TEST_CASE("The spanning tree is as short as Kruskal's, and joins all shapes")
{
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Eigen::Index n = 2 + Eigen::Index(seed);
    const Eigen::MatrixXd distances = random_distances(n, seed);
    const std::vector<Shape_pair> tree = minimum_spanning_tree(distances);
    CHECK(tree.size() == std::size_t(n - 1));
    CHECK(sum_of(tree, distances) == kruskal_sum(distances));
    for (std::size_t i = 0; i < std::size_t(n); ++i)
      CHECK(best_chains(distances, tree, 0)[i].shapes.back() == i);
  }
  CHECK(minimum_spanning_tree(Eigen::MatrixXd::Zero(1, 1)).empty());
}

TEST_CASE("A chain is taken only where it costs less, the shortest among equals")
{
  Eigen::MatrixXd energies(4, 4); // a path of three steps of 1; the distance of 0 and 2 is 2, that of 0 and 3 is 9
  energies << 0, 1, 2, 9,         //
      1, 0, 1, 4,                 //
      2, 1, 0, 1,                 //
      9, 5, 1, 0;
  const std::vector<Shape_pair> tree = minimum_spanning_tree(symmetric_distances(energies));
  CHECK(tree == std::vector<Shape_pair>{{0, 1}, {1, 2}, {2, 3}});
  const std::vector<Shape_chain> chains = best_chains(energies, tree, 0);
  CHECK(chains[0].shapes == Shapes{0});
  CHECK(chains[2].is_direct());
  CHECK(chains[3].shapes == Shapes{0, 2, 3}); // the path along the tree costs the same, with more steps
  CHECK(chains[3].energy == 3);
  CHECK(best_chains(energies, tree, 1)[3].shapes == Shapes{1, 2, 3}); // the energy from 1 to 3 is 4, back 5
  energies(0, 2) = 7;
  CHECK(best_chains(energies, tree, 0)[3].shapes == Shapes{0, 1, 2, 3});
  CHECK(best_chains(Eigen::MatrixXd::Ones(2, 2), {{0, 1}}, 0)[1].is_direct());
}

TEST_CASE("The map is composed along the chain; one that loses all parts is not taken")
{
  Energy_matrix matrix;
  matrix.energies.resize(3, 3);
  matrix.energies << 0, 1, 5, 1, 0, 1, 5, 1, 0;
  matrix.maps.resize(9);
  matrix.maps[0 * 3 + 1] = {{{0, 0, 1}, {1, 1, .5}, {1, 2, .5}}};
  matrix.maps[1 * 3 + 2] = {{{1, 0, .5}, {2, 0, 1}, {2, 1, 1}}};
  matrix.maps[0 * 3 + 2] = {{{0, 1, .1}}};
  const std::vector<Shape_pair> tree{{0, 1}, {1, 2}};
  Transitive_correspondence result = transitive_correspondence(matrix, tree, 0, 2);
  CHECK(result.chain.shapes == Shapes{0, 1, 2});
  CHECK(result.chain.energy == 2);
  CHECK(result.direct_energy == 5);
  CHECK(result.map == Part_map{{{1, 0, .5}, {1, 1, .5}}});
  CHECK(transitive_correspondence(matrix, tree, 0, 1).map == matrix.map(0, 1));
  matrix.maps[1 * 3 + 2] = {{{5, 0, 1}}};
  result = transitive_correspondence(matrix, tree, 0, 2);
  CHECK(result.chain.is_direct());
  CHECK(result.chain.energy == 5);
  CHECK(result.map == matrix.map(0, 2));
}
