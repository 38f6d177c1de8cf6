// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/Common_options.h"

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// Checks the output files that options name, before long work; empty ones are not asked for. `-` is standard output.
/// \param inputs files and folders that are read
/// \throw Usage_error if two are the same file, however they are spelt, or one is an input; Invalid_input if one cannot
/// be written
void check_outputs(const std::vector<std::string>& files, const std::vector<std::string>& inputs);

/// Warns on standard error, unless the options are to be quiet.
void warn(const Common_options& options, const std::string& message);

/// Writes an output file, all of it or nothing; none if it is not asked for. \throw Invalid_input if that fails
void write_output(const std::string& file, const std::function<void(std::ostream&)>& write);

} // namespace CGAL::Shape_correspondence::cli
