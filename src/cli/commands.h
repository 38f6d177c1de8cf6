// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_CLI_COMMANDS_H
#define CGAL_SHAPE_CORRESPONDENCE_CLI_COMMANDS_H

#include <string>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace cli {

/// The commands of the program; they throw `Usage_error` and `Invalid_input`.
void run_graph(const std::vector<std::string>& arguments);
void run_match(const std::vector<std::string>& arguments);
void run_evaluate(const std::vector<std::string>& arguments);
void run_collection(const std::vector<std::string>& arguments);
void run_blend(const std::vector<std::string>& arguments);

} // namespace cli
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_CLI_COMMANDS_H
