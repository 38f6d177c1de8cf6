// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/Once.h"
#include "roles/Role_model_data.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

// What trees tell of the parts of a shape. Rows are parts of the graph.
struct Role_votes
{
  Eigen::MatrixXi roles;          // how many trees vote for each role: part × role
  std::vector<Part_label> labels; // the likeliest finer label of the likeliest role; the first of equals
};

// What a model tells of the parts of a shape, computed once; threads may share it.
class Shape_roles
{
public:
  // The shape looks to +z once it was turned so often by 90°.
  Shape_roles(const Structural_graph& graph, const Role_model& model, int quarter_turns = 0);
  Shape_roles(Role_evidence evidence, const Role_model& model);
  // The evidence is looked for when it is first needed.
  Shape_roles(std::function<Role_evidence()> find_evidence, const Role_model& model);

  // From the labelled parts of a category, see `Role_distances::mean_distance()`.
  double distance(std::size_t category) const;
  // Whether no other category is nearer.
  bool is_nearest(std::size_t category) const;
  const Role_votes& votes(std::size_t category) const;

private:
  // Of a category; found when they are asked for.
  struct Findings
  {
    Once distance_is_found, votes_are_counted;
    double distance;
    Role_votes votes;
  };

  const Role_evidence& evidence() const;

  Role_model model_;
  std::function<Role_evidence()> find_evidence_;
  mutable Once has_evidence_;
  mutable Role_evidence evidence_;
  std::unique_ptr<Findings[]> findings_;
};

// The category that two shapes are taken to be of.
struct Pair_category
{
  std::size_t index = 0;   // the number of categories: none
  std::string note;        // why there is none, a whole sentence
  std::size_t nearest = 0; // even if it is not clear; the number of categories: there are none
};

// The nearest category, or none where the shapes are not much nearer to its labelled parts than to those of others.
Pair_category category_of_pair(const Shape_roles& source, const Shape_roles& target, const Role_model_data& model,
                               const Role_options& options = {});

// A shape by how often it was turned by 90° from the orientation that it was given in.
using Turned_roles = std::array<std::shared_ptr<const Shape_roles>, 4>;

// The turns with which a shape of a category may look to +z: where the trees agree on the roles of its parts nearly as
// much as anywhere. Ascending, so the given one is first.
std::vector<int> front_turns(const Turned_roles& shape, std::size_t category, int trees,
                             const Role_options& options = {});

// The turn with which a shape of a category looks to +z: 0 unless with another one the trees agree so much more, and
// the parts are so much nearer to labelled ones, that it is clear; and if the shape is nearer to another category.
int likely_front(const Turned_roles& shape, std::size_t category, int trees, const Role_options& options = {});

// The nearest category of two shapes whose fronts are not known.
Pair_category category_of_pair(const Turned_roles& source, const Turned_roles& target, const Role_model_data& model,
                               const Role_options& options = {});

// Cosine of the votes for the roles of every source part and every target part.
Eigen::MatrixXd agreement_of_votes(const Role_votes& source, const Role_votes& target);

// What roles tell of all pairs of parts, source by source. `source_parts`, `target_parts`: the rows of the votes that
// the parts of the match have.
Pair_terms role_terms(const Role_votes& source, const std::vector<std::size_t>& source_parts, const Role_votes& target,
                      const std::vector<std::size_t>& target_parts);

// The same with what the geometric match of the parts tells: its costs and its pairs.
Pair_terms with_geometric_terms(Pair_terms role_terms, const Eigen::MatrixXd& costs,
                                const std::vector<Part_correspondence>& pairs);

} // namespace CGAL::Shape_correspondence::internal
