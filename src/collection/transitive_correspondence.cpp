// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/limits.h"

#include <CGAL/Shape_correspondence/Correspondence.h>
#include <CGAL/Shape_correspondence/Part_map.h>
#include <CGAL/Shape_correspondence/transitive_correspondence.h>

#include <algorithm>
#include <limits>
#include <map>

namespace CGAL::Shape_correspondence {

Part_map part_map(const Correspondence& correspondence)
{
  Part_map result;
  for (const Part_correspondence& pair : correspondence.pairs)
    result.pairs.push_back({pair.source, pair.target, pair.has_confidence() ? pair.confidence : 1});
  return result;
}

Part_map identity_part_map(std::size_t parts)
{
  Part_map result;
  for (std::size_t part = 0; part < parts; ++part)
    result.pairs.push_back({part, part, 1});
  return result;
}

Part_map inverse(const Part_map& map)
{
  Part_map result;
  for (const Part_correspondence& pair : map.pairs)
    result.pairs.push_back(inverse(pair));
  std::sort(result.pairs.begin(), result.pairs.end(), is_before);
  return result;
}

Part_map composed(const Part_map& first, const Part_map& second)
{
  std::map<std::pair<std::size_t, std::size_t>, double> confidences;
  for (const Part_correspondence& pair : first.pairs) {
    const Part_correspondence begin{pair.target, 0};
    for (auto next = std::lower_bound(second.pairs.begin(), second.pairs.end(), begin, is_before);
         next != second.pairs.end() && next->source == pair.target; ++next) {
      double& confidence = confidences[{pair.source, next->target}];
      confidence = std::max(confidence, pair.confidence * next->confidence);
    }
  }
  Part_map result;
  for (const auto& [pair, confidence] : confidences)
    result.pairs.push_back({pair.first, pair.second, confidence});
  return result;
}

namespace {

double energy_of(const Eigen::MatrixXd& energies, std::size_t source, std::size_t target)
{
  return energies(Eigen::Index(source), Eigen::Index(target));
}

Shape_chain chain_of(const Eigen::MatrixXd& energies, std::vector<std::size_t> shapes)
{
  Shape_chain chain{std::move(shapes), 0};
  for (std::size_t k = 1; k < chain.shapes.size(); ++k)
    chain.energy += energy_of(energies, chain.shapes[k - 1], chain.shapes[k]);
  return chain;
}

constexpr std::size_t no_shape = std::size_t(-1);

// The parent of each shape in the tree, the root being its own; `no_shape` for shapes that the tree does not connect.
std::vector<std::size_t> towards(std::size_t root, const std::vector<Shape_pair>& tree)
{
  std::vector<std::vector<std::size_t>> neighbours(tree.size() + 1);
  internal::check_index("best_chains", "shape", root, neighbours.size());
  for (const auto& [a, b] : tree) {
    for (std::size_t shape : {a, b})
      internal::check_index("best_chains", "shape", shape, neighbours.size());
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
  }
  std::vector<std::size_t> next(neighbours.size(), no_shape), found{root};
  next[root] = root;
  for (std::size_t k = 0; k < found.size(); ++k)
    for (std::size_t neighbour : neighbours[found[k]])
      if (next[neighbour] == no_shape) {
        next[neighbour] = found[k];
        found.push_back(neighbour);
      }
  return next;
}

std::vector<std::size_t> way(std::size_t from, const std::vector<std::size_t>& next)
{
  if (from >= next.size() || next[from] == no_shape)
    throw Invalid_input("best_chains: the tree does not connect the two shapes; give one that connects all");
  std::vector<std::size_t> path{from};
  while (next[path.back()] != path.back())
    path.push_back(next[path.back()]);
  return path;
}

// The chain via one intermediate shape with the least sum of energies; the direct one if there is no third shape.
Shape_chain bridge_chain(const Eigen::MatrixXd& energies, std::size_t source, std::size_t target)
{
  std::vector<std::size_t> best{source, target};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < std::size_t(energies.rows()); ++i) {
    if (i == source || i == target) continue;
    const double sum = energy_of(energies, source, i) + energy_of(energies, i, target);
    if (sum < least) least = sum, best = {source, i, target};
  }
  return chain_of(energies, best);
}

// The chain of least energy among all; `best` if tied.
Shape_chain cheapest(Shape_chain best, const std::vector<Shape_chain>& others)
{
  for (const Shape_chain& chain : others)
    if (chain.energy < best.energy) best = chain;
  return best;
}

// The best chain to a target. \param next for each shape, the next shape in the tree towards the source
Shape_chain best_chain(const Eigen::MatrixXd& energies, std::size_t source, std::size_t target,
                       const std::vector<std::size_t>& next)
{
  std::vector<std::size_t> path = way(target, next);
  std::reverse(path.begin(), path.end());
  return cheapest(chain_of(energies, {source, target}),
                  {bridge_chain(energies, source, target), chain_of(energies, std::move(path))});
}

} // namespace

std::vector<Shape_pair> minimum_spanning_tree(const Eigen::Ref<const Eigen::MatrixXd>& distances)
{
  const auto n = std::size_t(distances.rows());
  std::vector<Shape_pair> tree;
  if (n == 0) return tree;
  std::vector<double> distance(n, std::numeric_limits<double>::infinity()); // distance from the tree
  std::vector<std::size_t> nearest(n, 0);                                   // nearest shape in the tree
  std::vector<char> is_in_tree(n, 0);
  for (std::size_t last = 0; tree.size() + 1 < n;) {
    is_in_tree[last] = 1;
    std::size_t next = n;
    for (std::size_t i = 0; i < n; ++i) {
      if (is_in_tree[i]) continue;
      const double d = distances(Eigen::Index(i), Eigen::Index(last));
      if (d < distance[i]) distance[i] = d, nearest[i] = last;
      if (next == n || distance[i] < distance[next]) next = i;
    }
    tree.emplace_back(std::min(nearest[next], next), std::max(nearest[next], next));
    last = next;
  }
  return tree;
}

std::vector<Shape_chain> best_chains(const Eigen::MatrixXd& energies, const std::vector<Shape_pair>& tree,
                                     std::size_t source)
{
  const std::vector<std::size_t> next = towards(source, tree);
  std::vector<Shape_chain> result;
  for (std::size_t target = 0; target < std::size_t(energies.rows()); ++target)
    result.push_back(target == source ? Shape_chain{{source}, 0} : best_chain(energies, source, target, next));
  return result;
}

Transitive_correspondence transitive_correspondence(const Energy_matrix& matrix, const std::vector<Shape_pair>& tree,
                                                    std::size_t source, std::size_t target)
{
  Transitive_correspondence result{best_chain(matrix.energies, source, target, towards(source, tree)),
                                   energy_of(matrix.energies, source, target),
                                   {}};
  const std::vector<std::size_t>& shapes = result.chain.shapes;
  result.map = matrix.map(shapes[0], shapes[1]);
  for (std::size_t k = 2; k < shapes.size(); ++k)
    result.map = composed(result.map, matrix.map(shapes[k - 1], shapes[k]));
  if (result.map.pairs.empty() && !result.chain.is_direct()) {
    result.chain = chain_of(matrix.energies, {source, target});
    result.map = matrix.map(source, target);
  }
  return result;
}

} // namespace CGAL::Shape_correspondence
