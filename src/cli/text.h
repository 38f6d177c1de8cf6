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

/// Writes rows with their columns aligned; the first row is a heading.
void write_table(std::ostream& out, std::vector<std::vector<std::string>> rows);

constexpr std::size_t line_width = 80; ///< characters

/// Words in lines of at most `width` characters; a longer one is broken after a sign that names are made of, if it has
/// any.
std::vector<std::string> wrapped(const std::string& text, std::size_t width);

/// Writes notes, one a line; of several only how many they are, unless all are wanted. Names of the library's options
/// are left out.
void write_notes(std::ostream& out, const std::vector<std::string>& notes, bool all);

/// A number with four significant digits.
std::string short_number(double number);

/// A number with three decimals, or others.
std::string decimals(double number, int count = 3);

/// A share in whole percent.
std::string percentage(double share);

/// A member of each element, or what a function makes of it.
template <typename Range, typename Of>
auto mapped(const Range& range, const Of& of)
{
  std::vector<std::decay_t<decltype(std::invoke(of, *std::begin(range)))>> result;
  for (const auto& element : range)
    result.push_back(std::invoke(of, element));
  return result;
}

/// Appends all of `more`.
template <typename Value>
void append(std::vector<Value>& all, const std::vector<Value>& more)
{
  all.insert(all.end(), more.begin(), more.end());
}

/// The messages, each after the path that it is about.
inline std::vector<std::string> about(const std::string& path, const std::vector<std::string>& messages)
{
  return mapped(messages, [&](const std::string& message) { return path + ": " + message; });
}

/// The words with commas in between; "-" for none.
std::string listed(const std::vector<std::string>& words);

/// "; did you mean 'WORD'?" with the known word that begins so, else the one that is spelt most alike by edit distance;
/// empty if none is near.
std::string suggestion(const std::string& word, const std::vector<std::string>& known);

} // namespace CGAL::Shape_correspondence::cli
