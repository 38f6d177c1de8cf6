// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/text_table.h"
#include "io/system/quoting.h"

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <ostream>
#include <regex>
#include <sstream>

namespace CGAL::Shape_correspondence::cli {
namespace {

/// Characters of a UTF-8 text.
std::size_t width(const std::string& text)
{
  return std::count_if(text.begin(), text.end(), [](unsigned char c) { return (c & 0xC0) != 0x80; });
}

} // namespace

void write_table(std::ostream& out, std::vector<std::vector<std::string>> rows)
{
  for (std::vector<std::string>& row : rows)
    for (std::string& field : row)
      field = IO::quote_terminal(field);
  std::vector<std::size_t> widths;
  for (const std::vector<std::string>& row : rows) {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (std::size_t i = 0; i < row.size(); ++i)
      widths[i] = std::max(widths[i], width(row[i]));
  }
  for (std::size_t r = 0; r < rows.size(); ++r) {
    std::string line = " ";
    for (std::size_t i = 0; i < rows[r].size(); ++i)
      line += " " + rows[r][i] + std::string(widths[i] - width(rows[r][i]) + 1, ' ');
    line.erase(line.find_last_not_of(' ') + 1);
    out << line << '\n';
    if (r > 0) continue;
    std::string rule = " ";
    for (std::size_t w : widths)
      rule += " " + std::string(w, '-') + " ";
    rule.pop_back();
    out << rule << '\n';
  }
}

std::vector<std::string> wrapped(const std::string& text, std::size_t length)
{
  std::vector<std::string> lines{""};
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (!lines.back().empty() && width(lines.back()) + 1 + width(word) > length) lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : " ") + word;
  }
  return lines;
}

void write_wrapped(std::ostream& out, const std::string& text)
{
  const char* indent = "";
  for (const std::string& line : wrapped(text, line_width - 2)) {
    out << indent << line << '\n';
    indent = "  ";
  }
}

void write_notes(std::ostream& out, const std::vector<std::string>& notes, bool all)
{
  static const std::regex library_option(R"( \(`[^`]*`\))");
  if (notes.size() > 1 && !all) {
    out << notes.size() << " notes; -v shows them\n";
    return;
  }
  for (const std::string& note : notes)
    out << "note: " << IO::quote_terminal(std::regex_replace(note, library_option, "")) << '\n';
}

std::string short_number(double number)
{
  std::ostringstream out;
  out.precision(4);
  out << number;
  return out.str();
}

std::string listed(const std::vector<std::string>& words)
{
  return words.empty() ? "-" : boost::algorithm::join(words, ", ");
}

} // namespace CGAL::Shape_correspondence::cli
