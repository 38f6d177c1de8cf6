// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/Once.h"
#include "energy/Matching_problem.h"
#include "matching/Shape_features.h"
#include "roles/Shape_roles.h"

#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <array>
#include <memory>
#include <mutex>
#include <vector>

namespace CGAL::Shape_correspondence {

/// A shape by quarter turn about the up axis. Everything is computed when it is first asked for; threads may share it.
struct Prepared_shape::Alignments
{
  explicit Alignments(const Structural_graph& graph) : graph_(graph) {}

  Matching_problem::Shared_shape aligned(int quarter_turns);

  /// Of the options that were asked for last: a shape is hardly ever matched with several.
  std::shared_ptr<const internal::Shape_features> features(int quarter_turns, const Part_matching_options& options);

  /// Of the model that was asked for last. The turns are from the given orientation.
  std::shared_ptr<const internal::Shape_roles> roles(const std::shared_ptr<const Role_model>& model,
                                                     int quarter_turns = 0);

  internal::Turned_roles roles_by_turn(const std::shared_ptr<const Role_model>& model);

  /// The front of a shape of a category, `internal::likely_front()`.
  int front(const std::shared_ptr<const Role_model>& model, std::size_t category, const Part_matching_options& options);

private:
  // A front that is known.
  struct Front
  {
    std::size_t category;
    double clearly_better; // the option that it depends on
    int turn;
  };

  // \pre `roles_mutex_` is held
  const std::shared_ptr<const internal::Shape_roles>& roles_of(const std::shared_ptr<const Role_model>& model,
                                                               int quarter_turns);

  static constexpr std::size_t turns = 4;

  const Structural_graph& graph_;
  std::array<internal::Once, turns> is_aligned_;
  std::array<Matching_problem::Shared_shape, turns> shapes_;
  std::mutex features_mutex_;
  std::array<std::shared_ptr<const internal::Shape_features>, turns> features_;
  std::mutex roles_mutex_;
  std::shared_ptr<const Role_model> role_model_;
  internal::Turned_roles turned_roles_;
  std::vector<Front> fronts_; // of this model
};

} // namespace CGAL::Shape_correspondence
