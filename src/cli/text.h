// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <functional>
#include <iosfwd>
#include <iterator>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// Writes rows with aligned columns; the first row is the heading.
void write_table(std::ostream& out, std::vector<std::vector<std::string>> rows);

constexpr std::size_t line_width = 80; ///< characters

/// Words wrapped to lines of at most `width` characters; a longer word is broken after a separator, if it has one.
std::vector<std::string> wrapped(const std::string& text, std::size_t width);

/// Writes one note in each line, or unless `all` only the number of several. Names of the library's options are
/// removed.
void write_notes(std::ostream& out, const std::vector<std::string>& notes, bool all);

/// A number with four significant digits.
std::string short_number(double number);

std::string decimals(double number, int count = 3);

std::string percentage(double share);

/// The result of a member or a function for each element.
template <typename Range, typename Of>
auto mapped(const Range& range, const Of& of)
{
  std::vector<std::decay_t<decltype(std::invoke(of, *std::begin(range)))>> result;
  for (const auto& element : range)
    result.push_back(std::invoke(of, element));
  return result;
}

template <typename Value>
void append(std::vector<Value>& all, const std::vector<Value>& more)
{
  all.insert(all.end(), more.begin(), more.end());
}

/// The messages, each prefixed with the path.
inline std::vector<std::string> about(const std::string& path, const std::vector<std::string>& messages)
{
  return mapped(messages, [&](const std::string& message) { return path + ": " + message; });
}

/// The words, separated by commas; "-" if there are none.
std::string listed(const std::vector<std::string>& words);

/// "; did you mean 'WORD'?" with the known word that starts like `word`, or the nearest by edit distance; empty: none.
std::string suggestion(const std::string& word, const std::vector<std::string>& known);

} // namespace CGAL::Shape_correspondence::cli
