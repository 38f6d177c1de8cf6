// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/Once.h"
#include "energy/Matching_problem.h"
#include "matching/Shape_features.h"
#include "roles/Shape_roles.h"

#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace CGAL::Shape_correspondence {

namespace internal {

/// A shape turned by quarter turns about the up axis; each is aligned on demand. Thread-safe.
class Turned_shapes
{
public:
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

/// The data that all matches of a shape share, computed on demand. Thread-safe.
struct Prepared_shape::Alignments
{
  explicit Alignments(const Structural_graph& graph) : shapes_(std::make_shared<internal::Turned_shapes>(graph)) {}

  Matching_problem::Shared_shape aligned(int quarter_turns) { return shapes_->aligned(quarter_turns); }

  /// The features in an alignment; cached for the last options only, since shapes are hardly ever matched with several.
  std::shared_ptr<const internal::Shape_features> features(int quarter_turns, const Part_matching_options& options);

  /// The roles predicted by a model for the four quarter turns of the shape from its given orientation.
  internal::Turned_roles roles(const std::shared_ptr<const Role_model>& model);

private:
  std::shared_ptr<internal::Turned_shapes> shapes_;
  std::mutex features_mutex_;
  std::array<std::shared_ptr<const internal::Shape_features>, internal::Turned_shapes::turns> features_;
  std::mutex roles_mutex_;
  std::map<std::shared_ptr<const Role_model>, internal::Turned_roles> roles_;
};

} // namespace CGAL::Shape_correspondence
