// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/train_role_model.h>

#include "base/for_each_index.h"
#include "matching/Role_fit.h"
#include "roles/Role_trainer.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <utility>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

void check(const std::vector<Labelled_graph>& shapes, const Shape_pair& pair)
{
  if (pair[0] >= shapes.size() || pair[1] >= shapes.size() || pair[0] == pair[1] ||
      shapes[pair[0]].category != shapes[pair[1]].category)
    throw Invalid_input("train_role_model: the pair " + std::to_string(pair[0]) + ", " + std::to_string(pair[1]) +
                        " is not of two shapes of a category");
}

// What a model learned from all other shapes predicts for a pair. \param all learned from all shapes
Unseen_pair predicted_without(const std::vector<Labelled_graph>& shapes, const Shape_pair& pair,
                              const Role_trainer& trainer, const Role_model_data& all)
{
  std::vector<char> is_left_out(shapes.size(), 0);
  is_left_out[pair[0]] = is_left_out[pair[1]] = 1;
  const Role_model model = Role_model_access::model(trainer.model_without(all, shapes[pair[0]].category, is_left_out));
  return unseen_pair(shapes, pair, Shape_roles(trainer.evidence(pair[0]), model),
                     Shape_roles(trainer.evidence(pair[1]), model), Role_model_access::data(model));
}

} // namespace

Role_model train_role_model(const std::vector<Labelled_graph>& shapes, const Role_training_options& options,
                            const std::vector<Shape_pair>& pairs)
{
  for (const Shape_pair& pair : pairs)
    check(shapes, pair);
  const Role_trainer trainer(shapes, options);
  Role_model_data model = trainer.model();
  if (!pairs.empty()) {
    std::vector<Unseen_pair> unseen(pairs.size());
    std::vector<Part_matching> geometric(pairs.size());
    for_each_index(pairs.size(), true, [&](std::size_t i) {
      unseen[i] = predicted_without(shapes, pairs[i], trainer, model);
      geometric[i] = geometric_match(*shapes[pairs[i][0]].graph, *shapes[pairs[i][1]].graph);
    });
    Role_fit(unseen, geometric).apply(model);
  }
  return Role_model_access::model(std::move(model));
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
