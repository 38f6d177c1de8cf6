// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/number_text.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace CGAL::Shape_correspondence {

std::from_chars_result internal::real_of_text(const char* begin, const char* end, double& number)
{
  const std::string_view all(begin, std::size_t(end - begin));
  // `std::strtod()` reads, but `std::from_chars()` does not read, hexadecimal digits, blanks and a plus sign
  const std::string text(all.substr(0, all.find_first_of("xX \t\r\n\v\f")));
  char* last = nullptr;
  const double read = text.empty() || text[0] == '+' ? 0 : std::strtod(text.c_str(), &last);
  if (!last || last == text.c_str()) return {begin, std::errc::invalid_argument};
  const char* const stop = begin + (last - text.c_str());
  const bool is_word = text.find_first_of("iInN") != std::string::npos; // an infinity or NaN
  if (!is_word && (std::isinf(read) || (read == 0 && text.find_first_of("123456789") < text.find_first_of("eE"))))
    return {stop, std::errc::result_out_of_range};
  number = read;
  return {stop, std::errc()};
}

std::string internal::text_of_real(double number, bool is_single)
{
  const auto formatted = [&](const char* format, int digits) {
    char text[400];
    return std::string(text, std::size_t(std::snprintf(text, sizeof text, format, digits, number)));
  };
  const auto is_same = [&](const std::string& text) {
    return is_single ? std::strtof(text.c_str(), nullptr) == float(number)
                     : std::strtod(text.c_str(), nullptr) == number;
  };
  if (!std::isfinite(number)) return formatted("%.*f", 0);
  int decimals = 0;
  while (!is_same(formatted("%.*e", decimals)))
    ++decimals;
  std::string scientific = formatted("%.*e", decimals);
  const int exponent = std::atoi(scientific.c_str() + scientific.find('e') + 1);
  std::string fixed = formatted("%.*f", decimals > exponent ? decimals - exponent : 0);
  return fixed.size() <= scientific.size() ? fixed : scientific;
}

} // namespace CGAL::Shape_correspondence
