// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_CLI_TEXT_TABLE_H
#define CGAL_SHAPE_CORRESPONDENCE_CLI_TEXT_TABLE_H

#include <iosfwd>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace cli {

/// Writes rows with their columns aligned; the first row is a heading.
void write_table(std::ostream& out, const std::vector<std::vector<std::string>>& rows);

/// A number with four significant digits.
std::string short_number(double number);

/// The words with commas in between; "-" for none.
std::string listed(const std::vector<std::string>& words);

} // namespace cli
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_CLI_TEXT_TABLE_H
