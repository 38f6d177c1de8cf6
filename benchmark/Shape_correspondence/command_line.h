// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::benchmark {

/// Reads the words of a command line one by one. Messages of the `std::invalid_argument` it throws are for the user.
class Command_line
{
public:
  Command_line(int argc, char** argv) : words_(argv + 1, argv + argc) {}

  bool is_at_end() const { return next_ == words_.size(); }
  /// The next word. \pre `!is_at_end()`
  const std::string& word() { return words_[next_++]; }
  /// The next word, which is the value of the option read before it.
  const std::string& value()
  {
    if (is_at_end()) throw std::invalid_argument(words_.back() + " needs a value");
    return word();
  }

private:
  std::vector<std::string> words_;
  std::size_t next_ = 0;
};

/// Throws `std::invalid_argument` if `word`, which is no known option, is empty or begins with a hyphen.
inline void refuse_option(const std::string& word)
{
  if (word.empty() || word[0] == '-') throw std::invalid_argument("unknown option '" + word + "'");
}

/// The whole number that `text` consists of. \param meaning name of the number in the error message
inline std::uint64_t whole_number(const std::string& text, const std::string& meaning)
{
  constexpr std::size_t most_digits = 18;
  if (text.empty() || text.size() > most_digits || text.find_first_not_of("0123456789") != std::string::npos)
    throw std::invalid_argument(meaning + " is a whole number, not '" + text + "'");
  return std::stoull(text);
}

/// The words of a comma-separated list.
inline std::vector<std::string> words_of(const std::string& list)
{
  std::vector<std::string> result;
  std::istringstream in(list);
  for (std::string word; std::getline(in, word, ',');)
    result.push_back(word);
  return result;
}

} // namespace CGAL::Shape_correspondence::benchmark
