// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/IO/correspondence_json.h>
#include <CGAL/Shape_correspondence/IO/read_part_labels.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// A result, and the file by which messages and reports name it.
struct Named_result
{
  std::string file;
  IO::Named_correspondence correspondence;
};

std::vector<Named_result> read_results(const std::vector<std::string>& inputs);

/// Reads the labels of all shapes in files and folders. \throw Invalid_input
std::vector<IO::Labelled_shape> read_labels(const std::vector<std::string>& paths);

/// Scores the results. \throw Invalid_input if a result has shapes without labels
void write_evaluation_json(std::ostream& out, const std::vector<Named_result>& results,
                           const std::vector<IO::Labelled_shape>& shapes);

} // namespace CGAL::Shape_correspondence::cli
