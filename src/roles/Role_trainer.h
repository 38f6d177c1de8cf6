// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "roles/Role_model_data.h"

#include <CGAL/Shape_correspondence/Role_model.h>

#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

// The weight of a real shape in the training, where a generated one weighs 1.
constexpr double weight_of_real_shapes = 3;

// Learns roles from labelled shapes or subsets of them, for which features are computed only once.
class Role_trainer
{
public:
  // \param known what was learned from other labelled shapes before
  // \throw Invalid_input if a shape or an option cannot be used
  Role_trainer(const std::vector<Labelled_graph>& shapes, const Role_training_options& options,
               const Role_model_data& known = {});

  const Role_evidence& evidence(std::size_t shape) const { return evidence_[shape]; }
  // The model learned from all shapes; it includes the categories that were known before.
  Role_model_data model() const;
  // A category learned from the shapes that are not left out; without roles if none is left.
  Category_roles category(const std::string& name, const std::vector<char>& is_left_out) const;

private:
  const std::vector<Labelled_graph>& shapes_;
  Role_training_options options_;
  Role_model_data known_;
  std::vector<Role_evidence> evidence_; // indexed by shape
};

} // namespace CGAL::Shape_correspondence::internal
