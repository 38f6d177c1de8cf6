// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "matching/Role_model_data.h"
#include "matching/match_parts.h"

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

// What a model tells of the parts of a shape, computed once; threads may share it. Rows are parts of the graph.
class Shape_roles
{
public:
  // The shape looks to +z.
  Shape_roles(const Structural_graph& graph, const Role_model& model);
  Shape_roles(Role_features features, const Role_model& model);

  // From the labelled parts of a category, see `Role_distances::mean_distance()`.
  double distance(std::size_t category) const { return distances_[category]; }
  // How many trees vote for each role of a category: part × role.
  const Eigen::MatrixXi& votes(std::size_t category) const;

private:
  struct Votes
  {
    std::once_flag is_counted;
    Eigen::MatrixXi votes;
  };

  Role_model model_;
  Role_features features_;
  std::vector<double> distances_;
  std::unique_ptr<Votes[]> votes_;
};

// The category whose labelled parts are nearest to both shapes; the number of categories if there are none.
std::size_t nearest_category(const Shape_roles& source, const Shape_roles& target, const Role_model_data& model);

// How well two shapes go with a category: mean over both of the mean share of the votes for a part's likeliest role,
// less the distance. At most 1; about 0 for shapes of other categories.
double familiarity(const Shape_roles& source, const Shape_roles& target, std::size_t category, int trees);

// The category that two shapes are taken to be of.
struct Pair_category
{
  std::size_t index = 0; // the number of categories: none
  std::string note;      // why there is none, a whole sentence
};

// The nearest category, or none where the shapes do not go well with it.
Pair_category category_of_pair(const Shape_roles& source, const Shape_roles& target, const Role_model_data& model);

// By part, the name of the role that most trees vote for.
std::vector<std::string> likeliest_roles(const Eigen::MatrixXi& votes, const Category_roles& category);

// Joins the roles of parts with their geometric match, as far as they are trusted:
// a pair of the match stays if the trees vote alike for its parts; in full trust, the parts that a
// role is most likely for in one shape correspond to those in the other, all to all, or, where they are as many in
// either shape and the match has a pair of nearly all of them, by the pairs of the match.
// `source_parts`, `target_parts`: the rows of the votes that the parts of the match have.
void join_roles(const Eigen::MatrixXi& source, const std::vector<std::size_t>& source_parts,
                const Eigen::MatrixXi& target, const std::vector<std::size_t>& target_parts,
                const Role_model_data& model, Role_trust trust, Part_matching& matching);

} // namespace CGAL::Shape_correspondence::internal
