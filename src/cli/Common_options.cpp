// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cli/Common_options.h"

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <sstream>

namespace CGAL::Shape_correspondence::cli {

namespace {

// More than any shape needs, and little memory
constexpr int most_curve_points = 1000;
constexpr int most_sheet_points = 200; // along a side

void check_between(const std::string& option, double value, double least, double most)
{
  if (value >= least && value <= most) return;
  std::ostringstream message;
  message << "--" << option << " must be between " << least << " and " << most << ", not " << value;
  throw Usage_error(message.str());
}

void check_positive(const std::string& option, double value)
{
  if (!(value > 0)) throw Usage_error("--" + option + " must be more than 0");
}

void check_abstraction(const Abstraction_options& options)
{
  check_positive("edge-length", options.edge_length);
  check_positive("stop-volume", options.stop_volume);
  check_positive("time-limit", options.time_limit);
  check_at_least("triangles", options.triangles, 100);
  check_at_least("max-iterations", options.maximum_iterations, 1);
  check_from_to("curve-points", options.curve_points, 2, most_curve_points);
  check_from_to("sheet-points", options.sheet_points, 2, most_sheet_points);
}

} // namespace

Common_options Common_options::of_input(std::size_t index) const
{
  Common_options result = *this;
  if (index >= of_pair.size()) return result;
  if (!of_pair[index].up.empty()) result.up = of_pair[index].up;
  if (!of_pair[index].parts_from.empty()) result.parts_from = of_pair[index].parts_from;
  return result;
}

Point Common_options::up_vector() const
{
  return up == "x" ? Point::UnitX() : up == "z" ? Point::UnitZ() : Point::UnitY();
}

Symmetry_options Common_options::symmetry_options() const
{
  Symmetry_options result;
  result.enabled = !no_symmetry;
  result.tolerance = symmetry_tolerance;
  const auto allows = [words = words_of(symmetries)](const char* kind) {
    return std::find(words.begin(), words.end(), kind) != words.end();
  };
  result.reflection = allows("reflection");
  result.rotation = allows("rotation");
  result.translation = allows("translation");
  return result;
}

std::vector<std::string> words_of(const std::string& list)
{
  std::vector<std::string> words;
  std::istringstream in(list);
  for (std::string word; std::getline(in, word, ',');)
    words.push_back(word);
  return words;
}

void check(const Common_options& options)
{
  const std::vector<std::string> axes{"x", "y", "z", "auto"};
  if (!options.up.empty()) check_word("up", options.up, axes);
  for (std::size_t i : {0, 1})
    if (!options.of_pair[i].up.empty()) check_word(i == 0 ? "source-up" : "target-up", options.of_pair[i].up, axes);
  check_word("parts", options.parts, {"auto", "file", "components", "segments"});
  for (const std::string& kind : words_of(options.symmetries))
    check_word("symmetries", kind, {"reflection", "rotation", "translation"});
  check_between("symmetry-tolerance", options.symmetry_tolerance, 0, 0.5);
  check_between("contact-tolerance", options.contact_tolerance, 0, 0.5);
  check_word("progress", options.progress, {"auto", "always", "never"});
  check_abstraction(options.abstraction);
}

void check_word(const std::string& option, const std::string& value, const std::vector<std::string>& known)
{
  if (std::find(known.begin(), known.end(), value) != known.end()) return;
  throw Usage_error("--" + option + " cannot be '" + value + "'; known are: " + boost::algorithm::join(known, ", "));
}

void check_from_to(const std::string& option, int value, int least, int most)
{
  check_at_least(option, value, least);
  if (value > most)
    throw Usage_error("--" + option + " must be at most " + std::to_string(most) + ", not " + std::to_string(value));
}

void check_at_least(const std::string& option, int value, int least)
{
  if (value < least)
    throw Usage_error("--" + option + " must be at least " + std::to_string(least) + ", not " + std::to_string(value));
}

} // namespace CGAL::Shape_correspondence::cli
