// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <charconv>
#include <string>
#include <string_view>
#include <type_traits>

namespace CGAL::Shape_correspondence::internal {

/// Replacements of `std::from_chars()` and `std::to_chars()` for floating-point numbers, where the standard library has
/// these functions for integers only. The locale must be "C".
std::from_chars_result real_of_text(const char* begin, const char* end, double& number);
std::string text_of_real(double number, bool is_single);

/// Reads the number at the beginning of `text`, in any locale, as `std::from_chars()` does.
template <typename Number>
std::from_chars_result read_number(std::string_view text, Number& number)
{
  const char *const begin = text.data(), *const end = begin + text.size();
#ifndef __cpp_lib_to_chars
  if constexpr (std::is_floating_point_v<Number>) {
    double read = 0;
    const std::from_chars_result result = real_of_text(begin, end, read);
    if (result.ec == std::errc()) number = Number(read);
    return result;
  } else
#endif
    return std::from_chars(begin, end, number);
}

/// The shortest text that reads as the same number.
template <typename Number>
std::string number_text(Number number)
{
#ifndef __cpp_lib_to_chars
  if constexpr (std::is_floating_point_v<Number>)
    return text_of_real(number, std::is_same_v<Number, float>);
  else
#endif
  {
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, number).ptr};
  }
}

} // namespace CGAL::Shape_correspondence::internal
