// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>
#include <string_view>

namespace CGAL::Shape_correspondence::IO {

/// The entire content of a stream. \throw Invalid_input if it is larger than `largest_document`; names `file`
std::string read_document(std::istream& in, const std::string& file);

/// Throws `Invalid_input` for nesting beyond `deepest_document`: parsers and their results' destructors recurse.
void check_json_depth(std::string_view text, const std::string& file);
void check_xml_depth(std::string_view text, const std::string& file);

} // namespace CGAL::Shape_correspondence::IO
