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

// Forest votes per part of a shape, by index in the structural graph.
struct Role_votes
{
  Eigen::MatrixXi roles;          // number of trees that vote for each role: part × role
  std::vector<Part_label> labels; // the likeliest finer label of the likeliest role; the first of equals
};

// The roles of a shape by a model, each computed when it is first asked for. Threads may share it.
class Shape_roles
{
public:
  // \param quarter_turns as of `role_evidence()`
  Shape_roles(const Structural_graph& graph, const Role_model& model, int quarter_turns = 0);
  Shape_roles(Role_evidence evidence, const Role_model& model);
  // The evidence is computed when it is first needed.
  Shape_roles(std::function<Role_evidence()> find_evidence, const Role_model& model);

  // Distance from the labelled parts of a category, see `Role_distances::mean_distance()`.
  double distance(std::size_t category) const;
  // Whether no other category is nearer.
  bool is_nearest(std::size_t category) const;
  const Role_votes& votes(std::size_t category) const;

private:
  // The results for one category.
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
  std::string note;        // a sentence: why there is none
  std::size_t nearest = 0; // even if it is not clear; the number of categories: there are none
};

// The nearest category. None where the shapes are far from its labelled parts or not much nearer to them than to those
// of others, or where each of them clearly is of a category of its own.
Pair_category category_of_pair(const Shape_roles& source, const Shape_roles& target, const Role_model_data& model,
                               const Role_options& options = {});

// The roles of a shape by quarter turns about up from its given orientation.
using Turned_roles = std::array<std::shared_ptr<const Shape_roles>, 4>;

// The quarter turns with which a shape of a category may face +z: those at which the trees agree on its roles nearly as
// much as at the best one. Ascending.
std::vector<int> front_turns(const Turned_roles& shape, std::size_t category, int trees,
                             const Role_options& options = {});

// The quarter turn with which a shape of a category faces +z. Not 0 only if, at another one, the agreement of the trees
// and the nearness of the parts to labelled ones are together clearly greater than at any other one, the parts are not
// clearly farther from them than as given, and no other category is nearer.
int likely_front(const Turned_roles& shape, std::size_t category, int trees, const Role_options& options = {});

// The nearest category of two shapes of unknown front.
Pair_category category_of_pair(const Turned_roles& source, const Turned_roles& target, const Role_model_data& model,
                               const Role_options& options = {});

// Cosine of the votes for the roles of every source part and every target part.
Eigen::MatrixXd agreement_of_votes(const Role_votes& source, const Role_votes& target);

// The terms by roles of all pairs of parts, source by source.
// \param source_parts, target_parts the parts to pair, by index in the votes
Pair_terms role_terms(const Role_votes& source, const std::vector<std::size_t>& source_parts, const Role_votes& target,
                      const std::vector<std::size_t>& target_parts);

// Adds the terms of the geometric match of the parts.
Pair_terms with_geometric_terms(Pair_terms role_terms, const Eigen::MatrixXd& costs,
                                const std::vector<Part_correspondence>& pairs);

} // namespace CGAL::Shape_correspondence::internal
