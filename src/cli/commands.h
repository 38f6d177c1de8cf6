// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// The commands of the program; they throw `Usage_error` and `Invalid_input`.
void run_parts(const std::vector<std::string>& arguments);
void run_graph(const std::vector<std::string>& arguments);
void run_match(const std::vector<std::string>& arguments);
void run_evaluate(const std::vector<std::string>& arguments);
void run_collection(const std::vector<std::string>& arguments);
void run_roles(const std::vector<std::string>& arguments);
void run_blend(const std::vector<std::string>& arguments);

} // namespace CGAL::Shape_correspondence::cli
