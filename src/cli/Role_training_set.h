// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/labelled_models.h"
#include "matching/cross_validate_roles.h"

#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

struct Common_options;

/// Labelled shapes that roles are learned from, the real ones first, and pairs of real ones.
struct Role_training_set
{
  std::vector<Labelled_model> models;
  std::vector<internal::Validation_shape> shapes; ///< the same
  std::vector<internal::Validation_pair> pairs;
  std::size_t number_of_real = 0;

  /// \param real folders of labelled shapes
  /// \param generated folders of shapes that are never left out and have less weight
  /// \param most_pairs of a category and folder that has no list of pairs
  Role_training_set(const std::vector<std::string>& real, const std::vector<std::string>& generated,
                    std::size_t most_pairs, const Common_options& common);

private:
  void add(const std::vector<std::string>& folders, const Common_options& common);
};

} // namespace CGAL::Shape_correspondence::cli
