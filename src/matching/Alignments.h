// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/Once.h"
#include "energy/Matching_problem.h"
#include "matching/Normalized_shape.h"
#include "roles/Shape_roles.h"

#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <array>
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <vector>

namespace CGAL::Shape_correspondence {

namespace internal {

/// A shape by quarter turns about the up axis, each aligned when it is first asked for. Threads may share it.
class Turned_shapes
{
public:
  /// Keeps the graph by reference.
  explicit Turned_shapes(const Structural_graph& graph) : graph_(graph) {}

  const Structural_graph& graph() const { return graph_; }
  Matching_problem::Shared_shape aligned(int quarter_turns);

  static constexpr std::size_t turns = 4;

private:
  const Structural_graph& graph_;
  std::array<Once, turns> is_aligned_;
  std::array<Matching_problem::Shared_shape, turns> shapes_;
};

} // namespace internal

/// What matches of a shape share. Everything is computed when it is first asked for; threads may share it.
struct Prepared_shape::Alignments
{
  explicit Alignments(const Structural_graph& graph) : shapes_(std::make_shared<internal::Turned_shapes>(graph)) {}

  Matching_problem::Shared_shape aligned(int quarter_turns) { return shapes_->aligned(quarter_turns); }

  /// Cached for the options that were asked for last, since a shape is hardly ever matched with several.
  std::shared_ptr<const internal::Shape_features> features(int quarter_turns, const Part_matching_options& options);

  /// The roles by a model, in the shape turned from its given orientation.
  std::shared_ptr<const internal::Shape_roles> roles(const std::shared_ptr<const Role_model>& model,
                                                     int quarter_turns = 0);
  internal::Turned_roles roles_by_turn(const std::shared_ptr<const Role_model>& model);

  /// The front of a shape of a category, `internal::likely_front()`.
  int front(const std::shared_ptr<const Role_model>& model, std::size_t category, const Part_matching_options& options);

private:
  struct Front
  {
    std::size_t category;
    double clearly_better; // the option that it depends on
    int turn;
  };

  struct Roles_by_model
  {
    std::shared_ptr<const Role_model> model;
    internal::Turned_roles roles;
    std::vector<Front> fronts; // those that are known
  };

  // \pre `roles_mutex_` is held
  Roles_by_model& roles_by_model(const std::shared_ptr<const Role_model>& model);

  std::shared_ptr<internal::Turned_shapes> shapes_;
  std::mutex features_mutex_;
  std::array<std::shared_ptr<const internal::Shape_features>, internal::Turned_shapes::turns> features_;
  std::mutex roles_mutex_;
  std::deque<Roles_by_model> roles_; // of every model that was asked for
};

} // namespace CGAL::Shape_correspondence
