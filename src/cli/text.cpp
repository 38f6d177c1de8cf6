// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/text.h"
#include "io/system/quoting.h"

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <ostream>
#include <regex>
#include <sstream>

namespace CGAL::Shape_correspondence::cli {
namespace {

/// Number of characters of a UTF-8 text.
std::size_t width(const std::string& text)
{
  return std::count_if(text.begin(), text.end(), [](unsigned char c) { return (c & 0xC0) != 0x80; });
}

/// Levenshtein distance: the least number of insertions, deletions and replacements of a letter.
std::size_t edit_distance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] != b[j]);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

/// Length of the first part of a long word: up to the last separator that fits; 0 if there is none.
std::size_t end_of_piece(const std::string& word, std::size_t length)
{
  const std::size_t sign = word.find_last_of("_-./#", length - 1);
  return sign == std::string::npos || sign + 1 == word.size() ? 0 : sign + 1;
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
    for (std::size_t end; width(lines.back()) > length && (end = end_of_piece(lines.back(), length)) > 0;) {
      const std::string rest = lines.back().substr(end);
      lines.back().erase(end);
      lines.push_back(rest);
    }
  }
  return lines;
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

std::string decimals(double number, int count)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", count, number);
  return text;
}

std::string percentage(double share) { return decimals(100 * share, 0) + " %"; }

std::string listed(const std::vector<std::string>& words)
{
  return words.empty() ? "-" : boost::algorithm::join(words, ", ");
}

std::string suggestion(const std::string& word, const std::vector<std::string>& known)
{
  std::size_t nearest = 1 + (word.size() + 1) / 3; // a third of the letters may be wrong
  std::string result;
  for (const std::string& candidate : known) {
    const bool begins_so = word.size() > 2 && candidate.rfind(word, 0) == 0;
    const std::size_t distance = begins_so ? 0 : edit_distance(word, candidate);
    if (distance >= nearest) continue;
    nearest = distance;
    result = "; did you mean '" + candidate + "'?";
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::cli
