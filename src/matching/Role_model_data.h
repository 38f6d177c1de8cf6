// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "matching/Role_forest.h"

#include <CGAL/Shape_correspondence/Role_model.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

// What is known of the roles in a category.
struct Category_roles
{
  std::string name;
  std::vector<std::string> roles; // sorted, at most `maximum_roles`
  Role_trust trust = Role_trust::FULL;
  Role_forest forest;
  Role_features examples; // of the labelled parts
};

constexpr std::size_t maximum_roles = 255;

// How often pairs of parts correspond by the probability that they have the same role: at 0, 0.1, … 1, linear in
// between.
using Confidence_table = std::array<double, 11>;
constexpr Confidence_table uncalibrated_confidences{0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1};
double confidence(const Confidence_table& table, double same_role);

struct Role_model_data
{
  std::vector<Category_roles> categories; // by name
  int trees = 0;                          // of every forest
  Confidence_table confidences = uncalibrated_confidences;

  // The index of a category; `categories.size()` if there is none of the name.
  std::size_t index(const std::string& category) const;
};

// Distances of parts from labelled ones, every feature in units of its standard deviation over all labelled parts.
class Role_distances
{
public:
  explicit Role_distances(const std::vector<Category_roles>& categories);

  // Mean over the parts of the mean over the features of the difference from the nearest labelled part of a category.
  double mean_distance(const Role_features& parts, std::size_t category) const;

private:
  Role_features standardised(const Role_features& parts) const;

  std::array<double, ROLE_FEATURE_COUNT> scales_; // steps a byte
  std::vector<Role_features> examples_;           // by category, standardised
};

// A shape that looks to +z, as given.
Role_features given_role_features(const Structural_graph& graph);

} // namespace CGAL::Shape_correspondence::internal
