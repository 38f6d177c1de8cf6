// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "roles/Role_model_data.h"

#include <CGAL/Shape_correspondence/Search_options.h>
#include <CGAL/Shape_correspondence/evaluate_correspondence.h>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

// A labelled shape of a cross-validation.
struct Validation_shape
{
  Labelled_graph labelled;
  std::string source; // where it is from
  bool is_generated = false;
};

constexpr double weight_of_real_shapes = 3; // in the training, where generated ones weigh 1

// Two labelled shapes of a category, by index.
using Validation_pair = std::array<std::size_t, 2>;

// What the training does not see of a pair's category.
enum class Left_out {
  SHAPES,  // the two shapes
  SOURCES, // all shapes of their sources
  CATEGORY // all of it
};

// How shapes are turned about the up axis, each by an angle drawn for the pair.
enum class Validation_turns {
  NONE,
  QUARTERS, // by a multiple of 90°
  ANY       // by any angle
};

// As `match --front` has it.
enum class Validation_fronts { GIVEN, LIKELY, AUTO };

struct Validation_options
{
  Left_out left_out = Left_out::SHAPES;
  // How many shapes of the category that are not generated the training sees at most, drawn for every pair; with
  // `Left_out::CATEGORY` it sees these of all the category.
  std::optional<std::size_t> examples;
  bool category_is_told = false; // to the matcher
  Validation_turns turns = Validation_turns::NONE;
  // What the matcher does about fronts. Where it finds them, the confidences of pairs are of what it finds.
  Validation_fronts fronts = Validation_fronts::GIVEN;
  // Not 0: the correspondences of least energy are compared, without roles and with roles of this weight in the energy.
  double role_weight = 0;

  bool orients_shapes() const { return turns != Validation_turns::NONE || fronts != Validation_fronts::GIVEN; }
};

// A pair of parts that was matched: how probable that was, whether it is right, and whether the coarse labels are
// equal.
struct Judged_pair
{
  double confidence;
  bool is_right, has_one_role;
};

// How many shapes have their front among those that roles leave possible, and as the only one.
struct Front_count
{
  int shapes = 0, possible = 0, sure = 0;
};

struct Validated_pair
{
  Validation_pair shapes{};
  std::string category;                   // as the matcher finds it; empty: none
  Correspondence_score geometric, joined; // by geometry alone, and as the matcher does it
  // The share of the target's parts that get their coarse label from the source.
  double labels_by_geometry = 0, labels_joined = 0;
  Front_count fronts;              // of the two shapes, with the category told
  std::vector<Judged_pair> judged; // of the matcher's pairs; none of least energy, which have no confidence
};

struct Pair_evidence;
class Pair_validator;

// Matches of pairs of shapes that the training did not see. The weights of the terms, and of confidences, follow from
// pairs of other categories and from those of their own category that share no shape with the one at hand; where
// examples are limited, from pairs of other categories that were matched with as few.
class Role_validation
{
public:
  Role_validation(const std::vector<Validation_shape>& shapes, const std::vector<Validation_pair>& pairs,
                  const Validation_options& options, const Role_training_options& training);
  ~Role_validation();

  // Matches the pairs again by other options. What roles tell stays as it is.
  void match(const Part_matching_options& parts);

  const std::vector<Validated_pair>& pairs() const { return pairs_; }

  // Fitted to all pairs; the usual ones where they are few.
  Pair_weights weights() const;
  // What all shapes teach, with weights fitted to all pairs.
  Role_model model() const;

private:
  // Fitted to all pairs but those of a category; the usual ones where they are few.
  Pair_weights weights_without(const std::string& category) const;
  // Fitted to the pairs of a category with none of these shapes; the fewer there are, the nearer to the expected ones.
  Pair_weights weights_of(const std::string& category, const Pair_weights& expected,
                          const std::vector<std::size_t>& left_out) const;

  // The same, of confidences.
  Confidence_weights confidence_without(const std::string& category,
                                        const std::vector<Judged_confidences>& examples) const;
  Confidence_weights confidence_of(const std::string& category, const Confidence_weights& expected,
                                   const std::vector<std::size_t>& left_out) const;
  // Of pairs that geometry alone matches, fitted to those with this nearest category.
  Confidence_weights geometric_confidence_of(const std::string& nearest, const Confidence_weights& expected,
                                             const std::vector<std::size_t>& left_out) const;

  // With shapes in the training or not, and weights of their own category or of others only.
  template <typename Examples>
  auto fitted_without(const std::string& category, const Examples& examples) const;
  // \param group of every pair, the category that it counts for
  template <typename Examples, typename Weights>
  Weights fitted_of(const std::string& category, const std::vector<std::string>& group, const Examples& examples,
                    const Weights& expected, const Weights& charges, const std::vector<std::size_t>& left_out) const;

  const std::vector<Validation_shape>& shapes_;
  Validation_options options_;
  std::vector<Labelled_graph> labelled_;
  std::unique_ptr<Pair_validator> validator_;
  std::vector<Pair_evidence> evidence_, with_others_; // by pair; the latter with no more left out than its shapes
  std::vector<Validated_pair> pairs_;
  std::vector<std::string> categories_, nearest_; // of the pairs: their own, and the one found to be nearest
  std::vector<Judged_terms> examples_;            // by pair, with the category told and neither shape in the training
  // By pair, of the parts that are matched: by roles where the category is found, by geometry alone where none is
  std::vector<Judged_confidences> confidences_, geometric_confidences_;
};

} // namespace CGAL::Shape_correspondence::internal
