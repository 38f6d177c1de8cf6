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

// The votes of a forest for the parts of a shape, indexed as in the structural graph.
struct Role_votes
{
  Eigen::MatrixXi roles;          // number of trees that vote for each role: part × role
  std::vector<Part_label> labels; // the finer label with most votes of the role with most votes; the first of equals
};

// The roles of a shape by a model, for each category computed when they are first asked for. Threads may share it.
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
  std::size_t index = 0;   // index of the category; the number of categories if there is none
  std::string note;        // sentence that says why there is none
  std::size_t nearest = 0; // index of the nearest category, even if it is not clear; 0 in a model without categories
};

// The nearest category. None if the shapes are far from its labelled parts, or not much nearer to them than to those of
// other categories, or if they clearly are of two different categories.
Pair_category category_of_pair(const Shape_roles& source, const Shape_roles& target, const Role_model_data& model,
                               const Role_options& options = {});

// The roles of a shape, indexed by the quarter turns about up from its given orientation.
using Turned_roles = std::array<std::shared_ptr<const Shape_roles>, 4>;

// The quarter turns with which a shape of a category may face +z: those at which the trees agree on its roles nearly as
// much as at the best one. Ascending.
std::vector<int> front_turns(const Turned_roles& shape, std::size_t category, int trees,
                             const Role_options& options = {});

// The number of quarter turns with which a shape of a category faces +z: that with the greatest sum of the agreement of
// trees and the nearness of the parts to labelled ones. 0 if the sum is not clearly greater than for all other numbers,
// the parts are then clearly farther from labelled ones than at 0, or another category is nearer.
int likely_front(const Turned_roles& shape, std::size_t category, int trees, const Role_options& options = {});

// The nearest category of two shapes of unknown front.
Pair_category category_of_pair(const Turned_roles& source, const Turned_roles& target, const Role_model_data& model,
                               const Role_options& options = {});

// Cosine of the angle between the role votes of each source part and each target part: source × target.
Eigen::MatrixXd agreement_of_votes(const Role_votes& source, const Role_votes& target);

// The terms of all pairs of parts, source by source, without the geometric terms, which are 0.
// \param source_parts, target_parts the parts to pair, by index in the votes
Pair_terms role_terms(const Role_votes& source, const std::vector<std::size_t>& source_parts, const Role_votes& target,
                      const std::vector<std::size_t>& target_parts);

// Sets the geometric terms. \param costs of substituting parts: source × target \param pairs of the geometric match
Pair_terms with_geometric_terms(Pair_terms role_terms, const Eigen::MatrixXd& costs,
                                const std::vector<Part_correspondence>& pairs);

} // namespace CGAL::Shape_correspondence::internal
