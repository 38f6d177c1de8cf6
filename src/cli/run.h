// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/Common_options.h"

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <iterator>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// Clears the list of written outputs.
void start_outputs();

/// Writes an output file atomically; does nothing if `file` is empty.
/// \throw Invalid_input, naming the outputs that were written before, on failure
void write_output(const std::string& file, const std::function<void(std::ostream&)>& write);

/// Records an output that was not written by `write_output()`, for the messages of later failures.
void output_is_whole(const std::string& file);

/// A message of the library with switches and commands in place of the names of C++ options and functions.
std::string in_program_words(std::string message);

/// Prints a warning to standard error unless the options are quiet.
void warn(const Common_options& options, const std::string& message);

/// Wall-clock time in seconds since an arbitrary moment.
double now();

/// Limits the number of working threads as long as the result lives. \param threads 0: no limit
std::shared_ptr<void> limit_threads(int threads);

/// A progress bar on standard error that shows the estimated remaining time after two seconds, and is erased at the
/// end. If the options have a function for progress, that is called instead.
class Progress_bar
{
public:
  /// \param label name of the work or of its input \param unit name of the counted items
  Progress_bar(const Common_options& options, std::string label, std::string unit = "part");
  ~Progress_bar();
  Progress_bar(const Progress_bar&) = delete;
  Progress_bar& operator=(const Progress_bar&) = delete;

  void show(std::size_t done, std::size_t total);

private:
  bool enabled_;
  bool shown_ = false;
  std::function<void(const std::string&, std::size_t, std::size_t)> on_progress_;
  std::string label_, unit_;
  double begin_, last_shown_ = 0; // times in seconds, see `now()`
};

/// Writes rows with aligned columns; the first row is the heading.
void write_table(std::ostream& out, std::vector<std::vector<std::string>> rows);

constexpr std::size_t line_width = 80; ///< characters in a line of output

/// Words wrapped to lines of at most `width` characters; a longer word is broken after a separator, if it has one.
std::vector<std::string> wrapped(const std::string& text, std::size_t width);

/// Writes notes, one in each line, or only their number if there are several and `all` is false.
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
