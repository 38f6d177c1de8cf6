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

#include <cstdint>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence {

namespace internal {
struct Role_model_data;
class Role_distances;
struct Role_model_access;
}

/// \ingroup PkgShapeCorrespondenceRoles
/// The roles of parts, such as legs and seat of a chair, learned from labelled shapes. For each category, a model has a
/// forest of extremely randomised trees (P. Geurts, D. Ernst, L. Wehenkel, *Extremely randomized trees*, 2006), which
/// predicts the role and the fine label (a front leg) of a part from its position, size and form in the upright shape
/// that faces +z; the features of the labelled parts, by which a shape's category is detected; and weights for the
/// probability that a pair of parts corresponds, given predicted labels and the geometric match. Names and the order of
/// parts are not used. Copies share their data. Thread-safe.
class Role_model
{
public:
  /// A model without categories.
  Role_model();

  /// Names of the categories, sorted.
  std::vector<std::string> categories() const;
  /// Names of the roles of a category, sorted. \throw Invalid_input if the model does not have the category
  const std::vector<std::string>& roles(const std::string& category) const;

  /// Writes the model; the bytes do not depend on the machine.
  void write(std::ostream& out) const;
  /// Reads a model written by `write()`, to the end of the stream. \throw Invalid_input if it is damaged; the message
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
  /// A shape belongs to a category only if its distance from the category's labelled parts is at most this multiple of
  /// its distance from those of every other category.
  double category_ratio = 0.82;
  /// Largest distance of a shape from the labelled parts of its category (`Part_roles::distance`), in standard
  /// deviations of a feature.
  double category_distance = 0.45;
  /// Share, less than 1, by which another front must be more likely, or another alignment cost less, than the given one
  /// to be taken in its place.
  double clearly_better = 0.05;
};

/// \ingroup PkgShapeCorrespondenceRoles
/// The roles of the parts of a shape, as predicted by a model.
struct Part_roles
{
  std::string category;           ///< category of the shape; empty: none of the model's
  std::vector<std::string> roles; ///< names of the roles of the category
  Eigen::MatrixXd probabilities;  ///< part × role; rows sum to 1
  std::vector<Part_label> labels; ///< the most probable label of every part
  /// Distance from the labelled parts of the category: the mean, over parts and features, of the difference from the
  /// nearest labelled part, in standard deviations of the feature. Large parts weigh more than small ones.
  double distance = 0;
};

/// \ingroup PkgShapeCorrespondenceRoles
/// The roles of the parts of a shape that is upright and faces +z.
/// \param graph the shape
/// \param model the role model
/// \param category category of the shape; empty: the one with the nearest labelled parts, or none, see `Role_options`
/// \throw Invalid_input if the model does not have the category
Part_roles part_roles(const Structural_graph& graph, const Role_model& model, const std::string& category = "");

/// \ingroup PkgShapeCorrespondenceRoles
/// A labelled shape for training.
struct Labelled_graph
{
  const Structural_graph* graph = nullptr; ///< the shape, upright, facing +z
  std::string category;                    ///< category of the shape
  /// Labels of all parts; `Part_label::coarse` is the role. Fine labels such as `leg_front_left` are learned if all
  /// parts of a role have one; `left` and `right` in them are replaced by the side of the part.
  std::vector<Part_label> labels;
  double weight = 1; ///< weight in the training, above 0; smaller for generated shapes than for real ones
  /// Whether the shape was made by a generator. Every tree is trained on some of these shapes only
  /// (`Role_training_options::generated_per_tree`); distances from a category are measured to its other shapes, if any.
  bool is_generated = false;
};

/// \ingroup PkgShapeCorrespondenceOptions
/// Options of `train_role_model()`.
struct Role_training_options
{
  int trees = 80;              ///< number of trees in the forest of a category, from 1 to 1000
  int generated_per_tree = 40; ///< largest number of generated shapes that a tree is trained on, from 0
  std::uint64_t seed = 0;      ///< seed of the random numbers
};

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_ROLE_MODEL_H
