// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// "; did you mean 'WORD'?" with the known word that is spelt most alike by edit distance; empty if none is near.
std::string suggestion(const std::string& word, const std::vector<std::string>& known);

} // namespace CGAL::Shape_correspondence::cli
