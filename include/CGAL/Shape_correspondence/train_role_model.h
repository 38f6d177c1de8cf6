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

#include <vector>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceRoles
/// Learns roles from labelled shapes. The same shapes, in any order, and the same seed give the same model, byte for
/// byte, on any number of threads. The weights that give the probabilities of pairs of parts are not learned, but
/// defaults for the number of a category's shapes.
/// \param shapes the labelled shapes
/// \param options the options
/// \throw Invalid_input if a shape has no category, a part no role, or a number is out of its range
Role_model train_role_model(const std::vector<Labelled_graph>& shapes, const Role_training_options& options = {});

/// \ingroup PkgShapeCorrespondenceRoles
/// Learns roles from labelled shapes in addition to those of a model, such as a few shapes of your own. A category of
/// the model is learned again from the old and the new shapes together, whose labels must have the same meaning; new
/// categories are added. The new forests have as many trees as those of the model.
/// \throw Invalid_input see `train_role_model()`
Role_model extend_role_model(const Role_model& model, const std::vector<Labelled_graph>& shapes,
                             const Role_training_options& options = {});

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_TRAIN_ROLE_MODEL_H
