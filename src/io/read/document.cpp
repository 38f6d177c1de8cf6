// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/document.h"
#include "base/limits.h"
#include "io/read/text_words.h"
#include "io/system/input_file.h"
#include "io/system/remedies.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <istream>

namespace CGAL::Shape_correspondence::IO {
namespace {

void check_depth(std::size_t depth, const std::string& file)
{
  if (depth > internal::deepest_document)
    refuse(file + ": it is nested deeper than " + std::to_string(internal::deepest_document) + " levels",
           remedy::check_kind);
}

void skip_past(std::string_view end, std::string_view& text)
{
  const std::size_t at = text.find(end);
  text.remove_prefix(at == std::string_view::npos ? text.size() : at + end.size());
}

/// Skips an opening tag, whose attributes are quoted. \return whether it is an empty element
bool skip_tag(std::string_view& text)
{
  char quote = 0;
  for (std::size_t i = 1; i < text.size(); ++i) {
    if (quote == 0 && text[i] == '>') {
      const bool closes = text[i - 1] == '/';
      text.remove_prefix(i + 1);
      return closes;
    }
    if (text[i] == quote)
      quote = 0;
    else if (quote == 0 && (text[i] == '"' || text[i] == '\''))
      quote = text[i];
  }
  text = {};
  return false;
}

} // namespace

std::string read_document(std::istream& in, const std::string& file)
{
  std::string text;
  std::string buffer(std::size_t(1) << 16, '\0');
  while (in) {
    in.read(buffer.data(), std::streamsize(buffer.size()));
    text.append(buffer, 0, std::size_t(in.gcount()));
    if (text.size() > internal::largest_document)
      refuse(file + ": it is longer than " + std::to_string(internal::largest_document >> 20) + " MB",
             remedy::make_smaller);
  }
  check_is_not_wide(text, file);
  return text;
}

void check_json_depth(std::string_view text, const std::string& file)
{
  std::size_t depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"')
      in_string = !in_string;
    else if (in_string && c == '\\')
      ++i;
    else if (!in_string && (c == '[' || c == '{'))
      check_depth(++depth, file);
    else if (!in_string && depth > 0 && (c == ']' || c == '}'))
      --depth;
  }
}

void check_xml_depth(std::string_view text, const std::string& file)
{
  std::size_t depth = 0;
  while (text = text.substr(std::min(text.find('<'), text.size())), !text.empty()) {
    if (begins_with(text, "<!--")) {
      skip_past("-->", text);
    } else if (begins_with(text, "<![CDATA[")) {
      skip_past("]]>", text);
    } else if (begins_with(text, "<!") || begins_with(text, "<?")) {
      skip_past(">", text);
    } else if (begins_with(text, "</")) {
      depth -= depth > 0 ? 1 : 0;
      skip_past(">", text);
    } else if (!skip_tag(text)) {
      check_depth(++depth, file);
    }
  }
}

} // namespace CGAL::Shape_correspondence::IO
