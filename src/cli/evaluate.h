// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/Common_options.h"
#include "io/write/Json.h"

#include <CGAL/Shape_correspondence/IO/correspondence_json.h>
#include <CGAL/Shape_correspondence/IO/read_part_labels.h>
#include <CGAL/Shape_correspondence/evaluate_correspondence.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

struct Evaluate_options
{
  std::vector<std::string> labels; ///< files and folders
  std::size_t worst = 0;           ///< results that are listed
  Evaluation_options evaluation;
};

/// Adds the options of the command `evaluate`.
void add_evaluate_options(Option_table& table, Evaluate_options& options, Common_options& common);

/// A mean with its confidence interval.
IO::Json estimate_json(const Estimate& estimate);

/// A result, and the file that messages and reports name it by.
struct Named_result
{
  std::string file;
  IO::Named_correspondence correspondence;
};

/// The results in files and folders. \throw Invalid_input
std::vector<Named_result> read_results(const std::vector<std::string>& inputs);

/// The labels of all shapes in files and folders. \throw Invalid_input
std::vector<IO::Labelled_shape> read_labels(const std::vector<std::string>& paths);

/// Scores the results. \throw Invalid_input if one is of shapes that have no labels
void write_evaluation_json(std::ostream& out, const std::vector<Named_result>& results,
                           const std::vector<IO::Labelled_shape>& shapes, const Evaluation_options& options);

} // namespace CGAL::Shape_correspondence::cli
