// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "io/read/model_parts.h"

#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// Reads what a model names of its looks: libraries of materials (MTL) and textures (PNG, JPEG), relative to the
/// model's folder or beside it. What is missing, damaged or too large is left out, with a warning. Makes all values
/// finite and within their ranges.
void complete_appearance(const std::string& model_file, Model_content& content, std::vector<std::string>& warnings);

} // namespace CGAL::Shape_correspondence::IO
