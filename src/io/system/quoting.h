// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <string>

namespace CGAL::Shape_correspondence::IO {

// Names of parts and shapes are arbitrary text. Inside the library they are UTF-8; every output format has its quoting
// function here. JSON, including that in GLB and web pages, is quoted by `Json`.

/// The text in UTF-8: bytes that are invalid as UTF-8 are taken for Latin-1, in which every byte is a character.
std::string utf8_text(const std::string& bytes);

/// A name in a statement of an OBJ file, or in a comment of a PLY file: one line, in which control characters, leading
/// and trailing blanks, and characters that would start a comment or a continuation are replaced by %XX, their bytes in
/// hexadecimal; so is a % before two hexadecimal digits.
std::string quote_obj(const std::string& name);
std::string quote_ply(const std::string& name);

std::string percent_decoded(const std::string& text);

/// A file name valid on all systems: characters forbidden on any of them become _, and the length is limited.
std::string file_name(const std::string& name);

std::string quote_dot(const std::string& name);

/// A name in GraphML: control characters, which XML cannot represent, become %XX. Boost's writer escapes markup.
std::string quote_graphml(const std::string& name);

/// A field of a comma-separated table (RFC 4180). One that a spreadsheet would take for a formula gets the prefix '.
std::string quote_csv(const std::string& field);

/// Text for a terminal: control characters and those that change the direction of writing become \xNN or \u{NNNN}.
/// \param keeps_lines whether line ends are kept
std::string quote_terminal(const std::string& text, bool keeps_lines = false);

} // namespace CGAL::Shape_correspondence::IO
