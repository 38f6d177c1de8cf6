// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/Role_training_set.h"
#include "cli/Command.h"

#include <utility>

namespace CGAL::Shape_correspondence::cli {
using namespace internal;

Role_training_set::Role_training_set(const std::vector<std::string>& real, const std::vector<std::string>& generated,
                                     std::size_t most_pairs, const Common_options& common)
{
  add(real, common);
  number_of_real = models.size();
  pairs = listed_pairs(models, most_pairs);
  add(generated, common);
  for (const Labelled_model& model : models) {
    const bool is_real = shapes.size() < number_of_real;
    const double weight = is_real ? weight_of_real_shapes : 1;
    shapes.push_back({{&model.graph, model.labels.category, model.part_labels, weight},
                      is_real ? model.labels.source : "generated",
                      !is_real});
  }
}

void Role_training_set::add(const std::vector<std::string>& folders, const Common_options& common)
{
  for (const std::string& folder : folders)
    for (Labelled_model& model : load_labelled_models(folder, common))
      models.push_back(std::move(model));
}

} // namespace CGAL::Shape_correspondence::cli
