// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <string>

namespace CGAL::Shape_correspondence::IO {

// Names of parts and shapes are text that anybody may have written. Inside the library they are UTF-8; every format
// that they are written into has its function here. JSON, and with it GLB and web pages, is quoted by `Json`.

/// The same text in UTF-8: bytes that are no UTF-8 are taken for Latin-1, in which every byte is a character.
std::string utf8_text(const std::string& bytes);

/// A name in a statement of an OBJ file, and in a comment of a PLY file: one line, in which control characters, blanks
/// at the ends and what would begin a comment or continue the line are %XX, their bytes in hexadecimal digits; so is a
/// % before two such digits.
std::string quote_obj(const std::string& name);
std::string quote_ply(const std::string& name);

/// The same with the character that it stands for in place of each %XX.
std::string percent_decoded(const std::string& text);

/// A name for a file on any system: what one of them forbids is _, and it is not longer than they allow.
std::string file_name(const std::string& name);

/// A name as a quoted string of Graphviz's language.
std::string quote_dot(const std::string& name);

/// A name in GraphML: control characters, which XML cannot hold, are %XX. Boost's writer escapes markup.
std::string quote_graphml(const std::string& name);

/// A text in a table with commas (RFC 4180). One that a spreadsheet would take for a formula begins with '.
std::string quote_csv(const std::string& field);

/// Text for a terminal: control characters and those that turn the direction of writing are \xNN or \u{NNNN}.
/// \param keeps_lines whether line ends are left
std::string quote_terminal(const std::string& text, bool keeps_lines = false);

} // namespace CGAL::Shape_correspondence::IO
