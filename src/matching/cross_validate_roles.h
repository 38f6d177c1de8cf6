// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "matching/Role_model_data.h"

#include <CGAL/Shape_correspondence/Search_options.h>
#include <CGAL/Shape_correspondence/evaluate_correspondence.h>

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

// A labelled shape of a cross-validation.
struct Validation_shape
{
  Labelled_graph labelled;
  std::string source;             // where it is from
  std::vector<Part_label> labels; // by part; empty: it is trained on, but is in no pair
};

// Two labelled shapes of a category, by index.
using Validation_pair = std::array<std::size_t, 2>;

// What the training does not see of a pair's category.
enum class Left_out {
  SHAPES,  // the two shapes
  SOURCES, // all shapes of their sources
  CATEGORY // all of it
};

// A pair of parts that was matched: how probable it is that both have the same role, and whether it is right.
struct Judged_pair
{
  double same_role;
  bool is_right;
};

struct Validated_pair
{
  Validation_pair shapes{};
  std::array<Correspondence_score, 3> scores{};   // by `Role_trust`, where the category is told
  std::array<std::vector<Judged_pair>, 3> judged; // the same
  std::string category;                           // as the matcher finds it; empty: none
  Role_trust trust = Role_trust::NONE;            // in that category, by the pairs of other shapes
  Correspondence_score joined;                    // as the matcher does it
};

// Geometric matches and those with roles, of pairs that the training did not see. How far roles are trusted follows
// from the pairs of other shapes.
class Role_validation
{
public:
  Role_validation(const std::vector<Validation_shape>& shapes, const std::vector<Validation_pair>& pairs,
                  Left_out left_out, const Role_training_options& options);

  const std::vector<Validated_pair>& pairs() const { return pairs_; }

  // How far roles are trusted by all pairs.
  Role_trust trust(const std::string& category) const;
  // What all shapes teach, with this trust.
  Role_model model() const;

private:
  Confidence_table confidences() const;
  Role_trust trust(const std::string& category, const std::vector<char>& is_left_out) const;

  const std::vector<Validation_shape>& shapes_;
  Role_model_data all_;
  std::vector<Validated_pair> pairs_;
  std::vector<std::array<Correspondence_score, 3>> told_; // by pair, that trust follows from
};

} // namespace CGAL::Shape_correspondence::internal
