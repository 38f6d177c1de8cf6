// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/suggestion.h"

#include <algorithm>
#include <numeric>

namespace CGAL::Shape_correspondence::cli {
namespace {

/// Levenshtein's: the fewest insertions, deletions and replacements of a letter.
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

} // namespace

std::string suggestion(const std::string& word, const std::vector<std::string>& known)
{
  std::size_t nearest = 1 + (word.size() + 1) / 3; // a third of the letters may be wrong
  std::string result;
  for (const std::string& candidate : known) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance >= nearest) continue;
    nearest = distance;
    result = "; did you mean '" + candidate + "'?";
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::cli
