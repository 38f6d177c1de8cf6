// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "roles/Part_model.h"
#include "roles/Role_forest.h"
#include "roles/pair_model.h"

#include <CGAL/Shape_correspondence/Role_model.h>

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

// A class that trees vote for: a role, or a finer label of a role.
struct Role_class
{
  std::uint8_t role = 0; // index
  std::string fine;      // finer label without the side; empty: none
  bool has_side = false; // whether left and right parts have labels of their own

  friend bool operator<(const Role_class& a, const Role_class& b)
  {
    return std::tie(a.role, a.fine) < std::tie(b.role, b.fine);
  }
};

// The weights of the roles of a category and of the geometric match.
struct Match_weights
{
  Pair_weights weights = usual_pair_weights();
  Confidence_weights confidence = usual_confidence_weights();
  // Calibrates confidences for shapes matched by geometry alone, since they are nearest to this category, but not
  // clearly.
  Confidence_weights geometric_confidence = usual_confidence_weights();
};

// The roles of a category, and what predicts them.
struct Category_roles : Match_weights
{
  std::string name;
  std::vector<std::string> roles;  // sorted
  std::vector<Role_class> classes; // sorted, at most `maximum_classes`
  Role_forest forest;
  std::vector<Role_example> examples; // labelled parts, with the index of the class as role; sorted
};

constexpr std::size_t maximum_classes = 255;
constexpr int maximum_trees = 1000; // limit of the trees of a forest

struct Role_model_data
{
  std::vector<Category_roles> categories; // sorted by name
  int trees = 0;                          // number of trees of every forest
  // Calibrates confidences of pairs matched by geometry alone if the nearest category has no weights of its own.
  Confidence_weights geometric_confidence = usual_confidence_weights();
  std::shared_ptr<const Part_model> parts; // null: nothing was learned about dividing models into parts

  // The index of a category; `categories.size()` if there is none of this name.
  std::size_t index(const std::string& category) const;
};

// Reads what `Role_model::write()` has written. \throw Invalid_input if it is damaged; the message begins with `name`
Role_model_data read_role_model_data(Stored_bytes bytes, const std::string& name);

// Distances of parts from labelled ones, every feature in units of its standard deviation over all labelled parts.
class Role_distances
{
public:
  explicit Role_distances(const std::vector<Category_roles>& categories);

  // Mean over the parts of the mean absolute difference of features from the nearest labelled part of a category. Parts
  // have about the root of their area as weight, since small ones, such as knobs, are alike in all categories.
  double mean_distance(const Role_features& parts, std::size_t category) const;

private:
  // Bytes of a row: the number of features, rounded up to a multiple of 16 for vector instructions.
  static constexpr int row_length = (ROLE_FEATURE_COUNT + 15) / 16 * 16;
  using Rows = Eigen::Array<std::uint8_t, Eigen::Dynamic, row_length, Eigen::RowMajor>;

  // \param features function that returns the features of the row of an index
  template <typename Features>
  Rows standardised(Eigen::Index rows, const Features& features) const;

  std::array<std::array<std::uint8_t, 256>, ROLE_FEATURE_COUNT> standard_; // indexed by feature and value
  std::vector<Rows> examples_;                                             // indexed by category; standardised
};

// Access to the data in a role model, which its public class does not show.
struct Role_model_access
{
  static Role_model model(Role_model_data data) { return Role_model(std::move(data)); }
  static const Role_model_data& data(const Role_model& model) { return *model.data_; }
  static const Role_distances& distances(const Role_model& model) { return *model.distances_; }
};

// What the labels of parts are predicted from, indexed by part of the structural graph.
struct Role_evidence
{
  Role_features features;
  std::vector<Side> sides;
};

// \param quarter_turns turns about the up axis after which the shape, as its file orients it, faces +z
Role_evidence role_evidence(const Structural_graph& graph, int quarter_turns = 0);
// \param shape the graph, aligned so that it faces +z
Role_evidence role_evidence(const Structural_graph& graph, const Aligned_shape& shape);

} // namespace CGAL::Shape_correspondence::internal
