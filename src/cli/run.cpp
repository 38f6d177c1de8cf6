// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/run.h"
#include "base/for_each_index.h"
#include "io/system/atomic_file.h"
#include "io/system/operating_system.h"
#include "io/system/quoting.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <numeric>
#include <ostream>
#include <sstream>
#include <vector>

namespace CGAL::Shape_correspondence::cli {
namespace {

constexpr std::size_t bar_width = 30;
constexpr const char* erase_line = "\r\033[K";
constexpr double interval = 0.1; // seconds between two drawings of the bar
constexpr double moment = 2;     // seconds before the remaining time is estimated

std::string time_text(double seconds)
{
  const long s = std::lround(seconds);
  if (s < 60) return std::to_string(s) + " s";
  if (s < 3600) return std::to_string(s / 60) + " min " + std::to_string(s % 60) + " s";
  return std::to_string(s / 3600) + " h " + std::to_string(s % 3600 / 60) + " min";
}

bool is_enabled(const Common_options& options)
{
  if (options.quiet || options.progress == "never") return false;
  return options.progress == "always" || IO::errors_are_on_terminal();
}

/// The outputs written by the command so far, for the message if another one fails.
std::vector<std::string>& whole_outputs()
{
  static std::vector<std::string> result;
  return result;
}

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

void start_outputs() { whole_outputs().clear(); }

void write_output(const std::string& file, const std::function<void(std::ostream&)>& write)
{
  if (file.empty()) return;
  try {
    IO::write_atomically(file, write);
  } catch (const Invalid_input& error) {
    if (whole_outputs().empty()) throw;
    throw Invalid_input(error.what() + ("; what was written before is whole: " + listed(whole_outputs())));
  }
  output_is_whole(file);
}

void output_is_whole(const std::string& file) { whole_outputs().push_back(file == "-" ? "standard output" : file); }

std::string in_program_words(std::string message)
{
  for (const auto& [of_library, of_program] : std::initializer_list<std::pair<const char*, const char*>>{
           {"set `Reading_options::allow_outside_files`", "add --allow-outside-files"},
           {"`Reading_options::allow_outside_files`", "--allow-outside-files"},
           {"name it in `Reading_options::face_labels`", "say so with --parts-from"},
           {"`write_parts_json()`", "`shape_correspondence graph --parts-json`"},
           {"`train_role_model()`", "`shape_correspondence roles train`"}})
    boost::algorithm::replace_all(message, of_library, of_program);
  return message;
}

void warn(const Common_options& options, const std::string& message)
{
  if (!options.quiet)
    std::cerr << "shape_correspondence: note: " + IO::quote_terminal(in_program_words(message)) + '\n';
}

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

std::shared_ptr<void> limit_threads(int threads) { return threads > 0 ? internal::limit_threads(threads) : nullptr; }

Progress_bar::Progress_bar(const Common_options& options, std::string label, std::string unit)
    : enabled_(is_enabled(options)),
      on_progress_(options.on_progress),
      label_(IO::quote_terminal(label)),
      unit_(std::move(unit)),
      begin_(now())
{}

Progress_bar::~Progress_bar()
{
  if (shown_) std::cerr << erase_line << std::flush;
}

void Progress_bar::show(std::size_t done, std::size_t total)
{
  if (on_progress_) return on_progress_(label_, done, total);
  const double time = now();
  if (!enabled_ || total == 0 || (shown_ && done < total && time - last_shown_ < interval)) return;
  const std::size_t filled = bar_width * done / total;
  std::cerr << erase_line << '[' << std::string(filled, '#') << std::string(bar_width - filled, '.') << "] " << label_
            << ": " << unit_ << ' ' << done << " of " << total;
  const double left = done > 0 ? (time - begin_) * double(total - done) / double(done) : 0;
  if (time - begin_ > moment && done < total) std::cerr << ", " << time_text(left) << " left";
  std::cerr << std::flush;
  last_shown_ = time;
  shown_ = true;
}

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
  if (notes.size() > 1 && !all) {
    out << notes.size() << " notes; -v shows them\n";
    return;
  }
  for (const std::string& note : notes)
    out << "note: " << IO::quote_terminal(in_program_words(note)) << '\n';
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
  std::size_t nearest = 1 + (word.size() + 1) / 3; // so that a third of the letters may be wrong
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
