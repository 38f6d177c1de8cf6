// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/train_role_model.h>

#include "roles/Role_trainer.h"

namespace CGAL::Shape_correspondence {
using namespace internal;

Role_model train_role_model(const std::vector<Labelled_graph>& shapes, const Role_training_options& options)
{
  return Role_model_access::model(Role_trainer(shapes, options).model());
}

Role_model extend_role_model(const Role_model& model, const std::vector<Labelled_graph>& shapes,
                             const Role_training_options& options)
{
  Role_training_options of_all = options;
  const Role_model_data& known = Role_model_access::data(model);
  if (!known.categories.empty()) of_all.trees = known.trees;
  return Role_model_access::model(Role_trainer(shapes, of_all, known).model());
}

} // namespace CGAL::Shape_correspondence
