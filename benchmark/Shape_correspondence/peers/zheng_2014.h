// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "structure/align_shapes.h"
#include "tevs_2014.h"

namespace CGAL::Shape_correspondence::peers {

/// A symmetry group and one of the groups that it touches, its neighbour.
struct Arrangement
{
  std::size_t group;
  Symmetry_type type, neighbour_type;
  Eigen::Matrix<double, 9, 1> geometry; ///< middle and extents of the group, middle of the neighbour; in unit boxes
};

inline std::vector<Arrangement> arrangements(const Boxed_shape& shape)
{
  std::vector<Arrangement> result;
  for (std::size_t g = 0; g < shape.groups.size(); ++g) {
    std::vector<char> seen(shape.groups.size(), 0);
    for (std::size_t part : shape.groups[g])
      for (std::size_t other : shape.neighbours[part]) {
        const std::size_t h = shape.group_of[other];
        if (h == g || seen[h]) continue;
        seen[h] = 1;
        const Eigen::AlignedBox3d box = box_of_group(shape, g);
        Arrangement a{g, shape.symmetries[g].type, shape.symmetries[h].type, {}};
        a.geometry << box.center(), box.diagonal(), box_of_group(shape, h).center();
        result.push_back(a);
      }
  }
  return result;
}

inline double similarity(const Arrangement& a, const Arrangement& b)
{
  constexpr double width = 0.3, other_type = 0.5; // width of the Gaussian of differences; factor for each other type
  const double kind = (a.type == b.type ? 1 : other_type) * (a.neighbour_type == b.neighbour_type ? 1 : other_type);
  return kind * std::exp(-(a.geometry - b.geometry).squaredNorm() / (width * width));
}

/// Number of shapes of the collection that have an arrangement similar to `a`.
inline int recurrence(const Arrangement& a, const std::vector<std::vector<Arrangement>>& shapes)
{
  constexpr double alike = 0.5; // similarity above which arrangements are similar
  int count = 0;
  for (const std::vector<Arrangement>& of_shape : shapes)
    for (const Arrangement& b : of_shape)
      if (similarity(a, b) > alike) {
        ++count;
        break;
      }
  return count;
}

/// Y. Zheng et al., *Recurring part arrangements in shape collections*, 2014: groups of parts correspond when they take
/// part in similar arrangements, weighted by how often these recur in the collection. Simplified: an arrangement is a
/// group and a group that it touches, compared by place and size in unit boxes; two groups are matched if each has most
/// votes of the arrangements of the other.
inline std::vector<Part_pairs> match_zheng_2014(const std::vector<Structural_graph>& graphs,
                                                const std::vector<Shape_pair>& pairs)
{
  std::vector<Boxed_shape> shapes;
  std::vector<std::vector<Arrangement>> all;
  for (const Structural_graph& graph : graphs) {
    const int turns = alignment_turns(structure(graphs[0]).frame, structure(graph).frame).front();
    shapes.push_back(boxed(graph, turns));
    all.push_back(arrangements(shapes.back()));
  }
  std::vector<std::vector<int>> recurrences;
  for (const std::vector<Arrangement>& of_shape : all) {
    recurrences.emplace_back();
    for (const Arrangement& a : of_shape)
      recurrences.back().push_back(recurrence(a, all));
  }
  std::vector<Part_pairs> result;
  for (const auto& [s, t] : pairs) {
    const Boxed_shape &source = shapes[s], &target = shapes[t];
    Eigen::MatrixXd votes = Eigen::MatrixXd::Zero(source.groups.size(), target.groups.size());
    for (std::size_t i = 0; i < all[s].size(); ++i)
      for (std::size_t j = 0; j < all[t].size(); ++j)
        votes(Eigen::Index(all[s][i].group), Eigen::Index(all[t][j].group)) +=
            similarity(all[s][i], all[t][j]) * (recurrences[s][i] + recurrences[t][j]);
    const Eigen::MatrixXd cost = part_distances(source, target, chamfer);
    Part_pairs matched;
    for (const auto& [g, h] : strong_entries(votes, 1))
      if (votes(Eigen::Index(g), Eigen::Index(h)) > 0) add_set_pairs(cost, source.groups[g], target.groups[h], matched);
    result.push_back(matched);
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::peers
