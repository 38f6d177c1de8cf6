// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "matching/match_parts.h"
#include "roles/Role_trainer.h"
#include "roles/Shape_roles.h"

#include <CGAL/Shape_correspondence/ground_truth.h>

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

// Two labelled shapes of a category, by index.
using Shape_pair = std::array<std::size_t, 2>;

// A pair of labelled shapes, and what a model that was learned without them predicts. Terms are without the geometric
// match.
struct Unseen_pair
{
  Shape_pair shapes{};
  std::string category;   // of both shapes
  Ground_truth truth;     // by their labels
  Pair_terms own_terms;   // in their category; empty if the model does not have it
  std::string found;      // the category that the model finds; empty: none
  Pair_terms found_terms; // in the category found
  std::string nearest;    // the nearest category, clear or not
};

// \param source, target the roles of the shapes of the pair by `model` \param category_known as if it were given
Unseen_pair unseen_pair(const std::vector<Labelled_graph>& shapes, const Shape_pair& pair, const Shape_roles& source,
                        const Shape_roles& target, const Role_model_data& model, bool category_known = false);

// The match by geometry alone, by index in the structural graphs.
Part_matching geometric_match(const Structural_graph& source, const Structural_graph& target,
                              const Part_matching_options& options = {});

// The weights of matching with roles, fitted to pairs of shapes that the models had not seen.
class Role_fit
{
public:
  // \param pairs, geometric the pairs, which are kept as a reference, and their geometric matches
  // \param by_category whether the weights of a category may differ from those of all others
  Role_fit(const std::vector<Unseen_pair>& pairs, const std::vector<Part_matching>& geometric,
           const Part_matching_options& options = {}, bool by_category = true);

  // Fitted to the pairs of all categories but one; of all if it is empty. Every category weighs the same, and every
  // pair within it. The usual weights where there are few pairs.
  Match_weights of_others(const std::string& category) const;

  // Fitted to the pairs of a category that have none of the shapes left out; the fewer there are, the nearer to the
  // weights of the others.
  Pair_weights weights(const std::string& category, const std::vector<std::size_t>& left_out) const;
  Confidence_weights confidence(const std::string& category, const std::vector<std::size_t>& left_out) const;
  // The same of what geometry alone matches, fitted to the pairs with this nearest category.
  Confidence_weights geometric_confidence(const std::string& nearest, const std::string& category,
                                          const std::vector<std::size_t>& left_out) const;

  // `weights()` without the shapes of a pair.
  const Pair_weights& weights_of_pair(std::size_t pair) const { return weights_of_pair_[pair]; }

  // Sets the weights of all categories of a model, and those for shapes without a category.
  void apply(Role_model_data& model) const;

private:
  // \param examples by pair
  template <typename Examples>
  auto fitted_without(const std::string& category, const Examples& examples) const;
  // \param group category that a pair counts for
  template <typename Examples, typename Weights>
  Weights fitted_of(const std::string& category, std::string Unseen_pair::*group, const Examples& examples,
                    const Weights& expected, const Weights& penalties, const std::vector<std::size_t>& left_out) const;

  const std::vector<Unseen_pair>& pairs_;
  bool by_category_;
  std::vector<Judged_terms> terms_; // by pair, in its own category
  std::vector<Pair_weights> weights_of_pair_;
  // By pair, of the parts that are matched: by roles where its category is found, by geometry alone where none is
  std::vector<Judged_confidences> confidences_, geometric_confidences_;
  std::map<std::string, Match_weights> of_others_; // by category of a pair
};

} // namespace CGAL::Shape_correspondence::internal
