// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/number_text.h"
#include "io/system/input_file.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/Points.h>

#include <algorithm>
#include <string>
#include <string_view>

namespace CGAL::Shape_correspondence::IO {

/// The text without leading and trailing blanks.
inline std::string_view trimmed(std::string_view text)
{
  const char* const blanks = " \t\r\n\v\f";
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

inline bool begins_with(std::string_view text, std::string_view beginning)
{
  return text.substr(0, beginning.size()) == beginning;
}

/// Removes the first word from `text` and returns it; empty if there is none.
inline std::string_view next_word(std::string_view& text)
{
  const char* const blanks = " \t\r\n\v\f";
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(blanks));
  text.remove_prefix(word.size());
  return word;
}

inline std::string lower(std::string_view word)
{
  std::string result(word);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  return result;
}

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF"; ///< some programs start UTF-8 files with it

/// Removes the first line from `text` and returns it without its end (LF, CR LF or CR) and without a byte order mark.
inline std::string_view next_line(std::string_view& text)
{
  const auto is_end = [](char c) { return c == '\n' || c == '\r'; };
  const auto size = std::size_t(std::find_if(text.begin(), text.end(), is_end) - text.begin());
  std::string_view line = text.substr(0, size);
  text.remove_prefix(std::min(text.size(), size + (text.substr(size, 2) == "\r\n" ? 2 : 1)));
  if (begins_with(line, byte_order_mark)) line.remove_prefix(byte_order_mark.size());
  return line;
}

/// A line without its comment. A # inside a word starts none, since names contain it.
inline std::string_view without_comment(std::string_view line)
{
  std::size_t hash = line.find('#');
  while (hash != std::string_view::npos && hash > 0 && line[hash - 1] != ' ' && line[hash - 1] != '\t')
    hash = line.find('#', hash + 1);
  return line.substr(0, hash);
}

/// Reads a number that must be the entire word, in any locale.
template <typename Number>
bool parse(std::string_view word, Number& number)
{
  if (!word.empty() && word[0] == '+') word.remove_prefix(1);
  const auto [end, error] = internal::read_number(word, number);
  return error == std::errc() && end == word.data() + word.size();
}

/// A word of a file, quoted for messages: truncated if it is long; zero bytes, which would end a message, become ?.
inline std::string cited(std::string_view word, std::size_t longest = 40)
{
  std::string begin(word.substr(0, longest));
  std::replace(begin.begin(), begin.end(), '\0', '?');
  return "'" + begin + (word.size() > longest ? "...'" : "'");
}

/// The name of a file, quoted for messages.
inline std::string cited_file(std::string_view name)
{
  constexpr std::size_t longest_path = 255;
  return name.empty() ? "without a name" : cited(name, longest_path);
}

/// The lines of a text file with a model; errors name the file and the line.
class Model_lines
{
public:
  Model_lines(std::string_view text, const std::string& file) : rest_(text), file_(file) {}

  std::string_view rest() const { return rest_; }

  std::string_view next()
  {
    ++number_;
    return next_line(rest_);
  }

  [[noreturn]] void fail(const std::string& what, const char* remedy = remedy::correct_text) const
  {
    refuse(file_ + ", line " + std::to_string(number_) + ": " + what, remedy);
  }

  /// The coordinates in the words of a line.
  Point vertex(std::string_view words) const
  {
    Point result;
    for (double& coordinate : result) {
      const std::string_view word = next_word(words);
      if (!parse(word, coordinate)) fail("a vertex needs three numbers, and " + cited(word) + " is none");
    }
    return result;
  }

private:
  std::string_view rest_;
  const std::string& file_;
  std::size_t number_ = 0;
};

} // namespace CGAL::Shape_correspondence::IO
