// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/collection.h"
#include "cli/load_shape.h"
#include "cli/run.h"

#include <CGAL/Shape_correspondence/nearest_shapes.h>
#include <CGAL/Shape_correspondence/topological_medoid.h>
#include <CGAL/Shape_correspondence/transitive_correspondence.h>

#include <algorithm>
#include <map>
#include <set>

namespace CGAL::Shape_correspondence::cli {
namespace {

constexpr std::size_t largest_clustered_whole = 100; // number of shapes up to which all maps are clustered by default
constexpr std::size_t usual_neighbours = 32;         // default of `Collection_options::neighbours` for more shapes
constexpr std::size_t largest_bridged = 1000;        // number of shapes up to which bridges are found, in cubic time
constexpr std::size_t listed_bridges = 100;          // limit for bridges in the result, those of largest gain

/// A symmetric matrix of the distances between shapes, accessed by columns.
using Distances = Eigen::Ref<const Eigen::MatrixXd>;

/// Ordered pairs of shapes.
using Pairs = std::set<std::pair<std::size_t, std::size_t>>;

/// The pairs of a shape and one of its nearest `neighbours`, in both orders, whose maps are clustered.
Pairs clustered_pairs(const Distances& distances, std::size_t neighbours)
{
  const auto n = std::size_t(distances.rows());
  if (neighbours == 0) neighbours = n > largest_clustered_whole ? usual_neighbours : n;
  Pairs pairs;
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<std::pair<double, std::size_t>> others;
    for (std::size_t j = 0; j < n; ++j)
      if (j != i) others.emplace_back(distances(Eigen::Index(j), Eigen::Index(i)), j);
    const std::size_t k = std::min(neighbours, others.size());
    std::partial_sort(others.begin(), others.begin() + std::ptrdiff_t(k), others.end());
    for (std::size_t m = 0; m < k; ++m) {
      pairs.emplace(i, others[m].second);
      pairs.emplace(others[m].second, i);
    }
  }
  return pairs;
}

/// The ordered pairs with a chain of matches of less energy than the direct match, the largest gain first.
std::vector<IO::Collection::Bridge> bridges_of(const Eigen::MatrixXd& energies, const std::vector<Shape_pair>& tree)
{
  std::vector<IO::Collection::Bridge> result;
  for (std::size_t source = 0; source < std::size_t(energies.rows()); ++source) {
    std::vector<Shape_chain> chains = best_chains(energies, tree, source);
    for (std::size_t target = 0; target < chains.size(); ++target) {
      if (chains[target].is_direct()) continue;
      const double direct = energies(Eigen::Index(source), Eigen::Index(target));
      result.push_back({source, target, {std::move(chains[target]), direct, {}}});
    }
  }
  const auto gain = [](const IO::Collection::Bridge& bridge) {
    return bridge.correspondence.direct_energy - bridge.correspondence.chain.energy;
  };
  std::stable_sort(result.begin(), result.end(), [&](const auto& a, const auto& b) { return gain(a) > gain(b); });
  return result;
}

void add_chain(const Shape_chain& chain, Pairs& pairs)
{
  for (std::size_t k = 1; k < chain.shapes.size(); ++k)
    pairs.emplace(chain.shapes[k - 1], chain.shapes[k]);
}

Part_map composed_map(const Shape_chain& chain, const std::map<std::pair<std::size_t, std::size_t>, Part_map>& maps)
{
  Part_map map = maps.at({chain.shapes[0], chain.shapes[1]});
  for (std::size_t k = 2; k < chain.shapes.size(); ++k)
    map = composed(map, maps.at({chain.shapes[k - 1], chain.shapes[k]}));
  return map;
}

std::vector<Shape_distances> shape_distances(const Distances& distances)
{
  std::vector<Shape_distances> result;
  for (Eigen::Index i = 0; i < distances.rows(); ++i) {
    Eigen::Index nearest = i == 0 ? 1 : 0;
    double sum = 0;
    for (Eigen::Index j = 0; j < distances.rows(); ++j) {
      sum += distances(j, i);
      if (j != i && distances(j, i) < distances(nearest, i)) nearest = j;
    }
    result.push_back({sum / double(distances.rows() - 1), std::size_t(nearest), distances(nearest, i)});
  }
  return result;
}

/// Sets the energies and the results that depend on them alone. \return the pairs of shapes whose maps are clustered
Pairs analyse_energies(const Collection_options& options, Collection_work& work, Analysis& analysis)
{
  IO::Collection& result = analysis.collection;
  const auto n = Eigen::Index(result.shapes.size());
  Eigen::MatrixXd& energies = analysis.energies;
  const auto take = [&](std::size_t source, std::size_t target, const Rated_map& rated) {
    energies(Eigen::Index(source), Eigen::Index(target)) = rated.energy;
  };
  work.for_each_pair([](std::size_t, std::size_t) { return false; }, take);
  const Eigen::MatrixXd distances = symmetric_distances(energies);
  const Eigen::Map<const Eigen::MatrixXd> stable(energies.data(), n, n); // valid even after the analysis is moved
  result.energy = [stable](std::size_t i, std::size_t j) { return stable(Eigen::Index(i), Eigen::Index(j)); };
  analysis.distances = shape_distances(distances);
  result.medoid = topological_medoid(distances);
  result.tree = minimum_spanning_tree(distances);
  if (result.shapes.size() <= largest_bridged)
    result.bridges = bridges_of(energies, result.tree);
  else
    result.warnings.push_back("Bridges are looked for in collections of up to " + std::to_string(largest_bridged) +
                              " shapes only.");
  result.bridge_count = result.bridges.size();
  if (result.bridges.size() > listed_bridges) result.bridges.resize(listed_bridges);
  return clustered_pairs(distances, options.neighbours);
}

IO::Collection::Shape entry_of(const Collection_shape& shape) { return {shape.name, shape.path, shape.parts}; }

} // namespace

Analysis analysed(const Collection_shapes& shapes, const Collection_options& options, Collection_work& work)
{
  const auto n = Eigen::Index(shapes.size());
  Analysis analysis{Eigen::MatrixXd::Zero(n, n), {}, {}, {}};
  IO::Collection& result = analysis.collection;
  result.warnings = shapes.skipped();
  result.shapes = mapped(shapes.shapes(), entry_of);
  for (const Collection_shape& shape : shapes.shapes())
    append(result.warnings, about(shape.path, shape.warnings));
  const Pairs clustered = analyse_energies(options, work, analysis);
  Pairs wanted = clustered;
  for (const IO::Collection::Bridge& bridge : result.bridges)
    add_chain(bridge.correspondence.chain, wanted);

  std::map<std::pair<std::size_t, std::size_t>, Part_map> maps;
  const auto is_wanted = [&](std::size_t i, std::size_t j) { return wanted.count({i, j}) > 0; };
  work.for_each_pair(is_wanted, [&](std::size_t i, std::size_t j, const Rated_map& rated) {
    if (is_wanted(i, j)) maps[{i, j}] = rated.map;
  });
  for (IO::Collection::Bridge& bridge : result.bridges)
    bridge.correspondence.map = composed_map(bridge.correspondence.chain, maps);
  for (const auto& [i, j] : clustered)
    analysis.maps.push_back({i, j, std::move(maps.at({i, j}))});
  const auto number_of_parts = [](const Collection_shape& shape) { return shape.parts.size(); };
  result.co_analysis = co_analysis(mapped(shapes.shapes(), number_of_parts), analysis.maps, options.co_analysis);
  result.co_analysis_shape_pairs = clustered.size() / 2;
  if (options.agreeing) analysis.maps = agreeing_maps(std::move(analysis.maps), result.co_analysis);
  if (options.matches) result.matches = analysis.maps;
  return analysis;
}

IO::Nearest_in_collection nearest_in_collection(const Structural_graph& query, const std::string& file,
                                                const Collection_shapes& shapes, std::size_t count,
                                                const Energy_matrix_options& matching)
{
  IO::Nearest_in_collection result;
  result.query = {structure(query).name, file, part_names(query)};
  result.shapes = mapped(shapes.shapes(), entry_of);
  result.warnings = shapes.skipped();
  result.nearest = nearest_shapes<CGAL::Parallel_if_available_tag>(
      query, shapes.size(), [&](std::size_t i) { return shapes.graph(i); }, count, matching);
  return result;
}

} // namespace CGAL::Shape_correspondence::cli
