// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/Role_training_set.h"
#include "io/write/Json.h"

#include <CGAL/Shape_correspondence/Role_model.h>

#include <cstdint>
#include <iosfwd>
#include <string>

namespace CGAL::Shape_correspondence::cli {

/// A line a category: scores by geometry and with roles, how well confidences are calibrated, and how often fronts and
/// labels are found.
/// \param seed of the bootstrap intervals
void write_role_table(std::ostream& out, const Role_training_set& set, const internal::Role_validation& validation,
                      std::uint64_t seed);

/// What `roles evaluate --json` writes.
/// \param left_out as the option --leave-out has it
IO::Json role_evaluation_json(const Role_training_set& set, const internal::Role_validation& validation,
                              const std::string& left_out, std::uint64_t seed);

/// What a model was learned from, and how good it is.
/// \param date empty: not written
IO::Json role_manifest_json(const Role_training_set& set, const internal::Role_validation& validation,
                            const Role_model& model, const std::string& date, const Role_training_options& training);

} // namespace CGAL::Shape_correspondence::cli
