// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_ROLE_MODEL_H
#define CGAL_SHAPE_CORRESPONDENCE_ROLE_MODEL_H

#include <CGAL/Shape_correspondence/Structural_graph.h>
#include <CGAL/Shape_correspondence/ground_truth.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {

namespace internal {
struct Role_model_data;
class Role_distances;
struct Role_model_access;
}

/// \ingroup PkgShapeCorrespondenceRoles
/// The roles of parts, such as legs and seat of a chair, learned from labelled shapes. For each category, a model has a
/// forest of extremely randomised trees (P. Geurts, D. Ernst, L. Wehenkel, *Extremely randomized trees*, 2006), which
/// predicts the role and the fine label (a front leg) of a part from its place, size and shape in the upright shape
/// that faces +z; the features of the labelled parts, by which a shape's category is detected; and weights for the
/// probability that a pair of parts corresponds, given predicted labels and the geometric match. Names and the order of
/// parts are not used. Copies share their data; threads may share a model.
class Role_model
{
public:
  /// A model without categories: it knows no roles.
  Role_model();

  /// Names of the categories, sorted.
  std::vector<std::string> categories() const;
  /// Names of the roles of a category, sorted. \throw Invalid_input if the model does not have the category
  const std::vector<std::string>& roles(const std::string& category) const;

  /// Writes the model, in bytes that are the same on all machines.
  void write(std::ostream& out) const;
  /// Reads what `write()` has written, and the stream to its end. \throw Invalid_input if it is damaged; the message
  /// begins with `name`
  static Role_model read(std::istream& in, const std::string& name);

private:
  friend struct internal::Role_model_access;
  explicit Role_model(internal::Role_model_data data);

  std::shared_ptr<const internal::Role_model_data> data_;
  std::shared_ptr<const internal::Role_distances> distances_;
};

/// \ingroup PkgShapeCorrespondenceOptions
/// Thresholds for the category of shapes and for the direction that they face.
struct Role_options
{
  /// Ratio. Shapes are of a category if their distance from its labelled parts is at most this much of that from any
  /// other one,
  double category_ratio = 0.85;
  /// and at most this on average, in standard deviations of a feature.
  double category_distance = 0.35;
  /// Share, less than 1. Another front or alignment is preferred to the given one if it is better by more than this.
  double clearly_better = 0.05;
};

/// \ingroup PkgShapeCorrespondenceRoles
/// The roles of the parts of a shape, as far as a model knows them.
struct Part_roles
{
  std::string category;           ///< category of the shape; empty: none that the model knows
  std::vector<std::string> roles; ///< names of the roles of the category
  Eigen::MatrixXd probabilities;  ///< part × role; every row sums up to 1
  std::vector<Part_label> labels; ///< the most probable label of every part
  /// Distance from the labelled parts of the category: mean over parts and features of the difference from the nearest
  /// labelled part, in standard deviations of the feature.
  double distance = 0;
};

/// \ingroup PkgShapeCorrespondenceRoles
/// The roles of the parts of a shape that is upright and faces +z.
/// \param graph the shape
/// \param model the role model
/// \param category of the shape; empty: the one whose labelled parts are nearest, or none if by `Role_options` it is none
/// \throw Invalid_input if the model does not have the category
Part_roles part_roles(const Structural_graph& graph, const Role_model& model, const std::string& category = "");

/// \ingroup PkgShapeCorrespondenceRoles
/// A shape that roles are learned from.
struct Labelled_graph
{
  const Structural_graph* graph = nullptr; ///< the shape, upright, facing +z
  std::string category;                    ///< of the shape
  /// Of every part; `Part_label::coarse` is its role. Fine labels such as `leg_front_left` are learned where all parts
  /// of a role have one; `left` and `right` in them are replaced by the side on which a part lies.
  std::vector<Part_label> labels;
  double weight = 1; ///< in the training, above 0; less for generated shapes than for real ones
  /// Every tree sees some of the generated shapes only, and if a category has others, its distance is from these alone.
  bool is_generated = false;
};

/// \ingroup PkgShapeCorrespondenceOptions
/// Options of `train_role_model()`.
struct Role_training_options
{
  int trees = 80;              ///< number of trees in the forest of a category, from 1 to 1000
  int generated_per_tree = 40; ///< number of generated shapes of the category that a tree sees at most, from 0
  std::uint64_t seed = 0;      ///< seed of the random numbers
};

} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_ROLE_MODEL_H
