// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// Writes rows with their columns aligned; the first row is a heading.
void write_table(std::ostream& out, std::vector<std::vector<std::string>> rows);

/// A number with four significant digits.
std::string short_number(double number);

/// A share in whole percent.
std::string percentage(double share);

/// The words with commas in between; "-" for none.
std::string listed(const std::vector<std::string>& words);

/// "; did you mean 'WORD'?" with the known word that is spelt most alike by edit distance; empty if none is near.
std::string suggestion(const std::string& word, const std::vector<std::string>& known);

} // namespace CGAL::Shape_correspondence::cli
