// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "assembly.h"

#include <map>
#include <string>

namespace CGAL::Shape_correspondence::generator {

/// Contents of files by their path, relative to the output folder.
using Files = std::map<std::string, std::string>;

/// Largest gap between parts in contact, over the shape's diagonal.
constexpr double contact_tolerance = 0.02;

constexpr const char* model_license = "GPL-3.0-or-later";

std::string number(double x);

/// The mesh as OBJ, after `shift` earlier points of the file.
std::string obj_text(const Part& part, int shift = 0);

std::string part_file(const Part& part);

std::string labels_text(const Assembly& shape);

/// The folder of a shape: one file for each part, its labels, and its structure if groups are known.
Files folder_files(const Assembly& shape);

/// The shape as one file with all parts.
Files single_file(const Assembly& shape);

/// The shape as models often are: one file, z up, one object for all parts of each coarse label.
Files raw_file(const Assembly& shape);

} // namespace CGAL::Shape_correspondence::generator
