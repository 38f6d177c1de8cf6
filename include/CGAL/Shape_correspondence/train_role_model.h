// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_TRAIN_ROLE_MODEL_H
#define CGAL_SHAPE_CORRESPONDENCE_TRAIN_ROLE_MODEL_H

#include <CGAL/Shape_correspondence/Role_model.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceRoles
/// Learns roles from labelled shapes. The same shapes and pairs, in any order, and the same seed give the same model,
/// byte for byte, on any number of threads.
/// \param shapes the labelled shapes
/// \param options the options
/// \param pairs pairs of shapes of one category, by index. Each is matched by geometry, and its roles are predicted by
/// a model that has seen neither shape; the weights of both and the confidences are fitted to these matches, over all
/// categories from 50 pairs on, and for each category. Empty: usual weights, by the number of shapes of a category
/// \throw Invalid_input if a shape has no category, a part no role, a pair is not of two shapes of a category, or a
/// number is out of its range
Role_model train_role_model(const std::vector<Labelled_graph>& shapes, const Role_training_options& options = {},
                            const std::vector<std::array<std::size_t, 2>>& pairs = {});

/// \ingroup PkgShapeCorrespondenceRoles
/// Learns roles from labelled shapes in addition to those that a model was learned from, such as a few shapes of your
/// own. A category that the model has is learned anew from the old and the new shapes together, whose labels must have
/// the same meaning; other categories are added. The forests get as many trees as those of the model.
/// \throw Invalid_input as `train_role_model()`
Role_model extend_role_model(const Role_model& model, const std::vector<Labelled_graph>& shapes,
                             const Role_training_options& options = {});

/// \ingroup PkgShapeCorrespondenceRoles
/// How well labelled shapes of a category match each other, with and without learning from them.
struct Gain_of_examples
{
  std::string category;  ///< of the shapes
  std::size_t pairs = 0; ///< of these shapes, that were matched; none of fewer than three shapes
  double with = 0;       ///< mean F1 over the pairs, with what is learned from the others
  double without = 0;    ///< the same without it
  bool is_clear() const; ///< whether the gain is more than chance
};

/// \ingroup PkgShapeCorrespondenceRoles
/// Whether it helps to extend a model by labelled shapes, for each of their categories, sorted. Up to 20 pairs of a
/// category are matched: with `model`, and, given the category, with the model that is extended by the shapes that are
/// not in the pair.
/// \throw Invalid_input as `train_role_model()`
std::vector<Gain_of_examples> gains_of_examples(const Role_model& model, const std::vector<Labelled_graph>& shapes,
                                                const Role_training_options& options = {});

} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_TRAIN_ROLE_MODEL_H
