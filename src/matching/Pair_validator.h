// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "roles/Role_trainer.h"
#include "roles/Shape_roles.h"
#include "matching/cross_validate_roles.h"

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

// What roles tell of a pair of shapes that the training did not see.
struct Pair_evidence
{
  Ground_truth truth;
  std::size_t target_size = 0;
  Pair_terms told;      // of roles, with the category told; empty if the training saw nothing of it
  std::string category; // as the matcher finds it; empty: none
  std::string nearest;  // even if it is not clear
  Pair_terms found;     // of roles, in the one that is found
  Front_count fronts;   // with the category told
  // Of least energy, without and with roles; by index in the structural graphs
  std::array<std::vector<Part_correspondence>, 2> least_energy;
};

// What the matcher finds of shapes that were turned.
struct Turned_match
{
  std::vector<Part_correspondence> without_roles, with_roles;
  std::string category;
};

// Tells what roles say of pairs of shapes when the training has seen neither of them.
class Pair_validator
{
public:
  Pair_validator(const std::vector<Validation_shape>& shapes, const std::vector<Labelled_graph>& labelled,
                 const Role_training_options& options);

  const Role_model_data& model() const { return all_; }

  std::vector<Pair_evidence> run(const std::vector<Validation_pair>& pairs, const Validation_options& options);

  // Both shapes turned by angles that are drawn by the number of the pair. \param weights, confidence of the category
  Turned_match turned_match(const Validation_pair& pair, std::size_t number, const Validation_options& options,
                            const Part_matching_options& parts, const Pair_weights& weights,
                            const Confidence_weights& confidence) const;

private:
  // What the training teaches without what is left out for a pair; the pair's category is the first result.
  std::pair<std::size_t, Role_model_data> left_out_model(const Validation_pair& pair, std::size_t number,
                                                         const Validation_options& options) const;
  Turned_roles turned_roles(std::size_t shape, const Role_model& model) const;
  Pair_evidence evidence(const Validation_pair& pair, std::size_t number, const Validation_options& options) const;

  const std::vector<Validation_shape>& shapes_;
  Role_trainer trainer_;
  Role_model_data all_;
  std::vector<std::vector<Role_evidence>> turned_; // by shape, by quarter turns; of those that are in a pair
};

} // namespace CGAL::Shape_correspondence::internal
