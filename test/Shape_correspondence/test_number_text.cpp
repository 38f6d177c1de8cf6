// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// The replacements for number conversions missing in standard libraries give the standard results.
#include "base/number_text.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace CGAL::Shape_correspondence::internal;

namespace {

template <typename Number, typename Bits>
std::vector<Number> any_numbers()
{
  std::mt19937_64 random(1);
  std::vector<Number> result{0,
                             Number(-0.),
                             1,
                             Number(0.1),
                             Number(1e22),
                             Number(123456),
                             Number(1e-5),
                             Number(9007199254740993.),
                             std::numeric_limits<Number>::max(),
                             std::numeric_limits<Number>::min(),
                             std::numeric_limits<Number>::denorm_min(),
                             std::numeric_limits<Number>::infinity()};
  for (int i = 0; i < 2000; ++i) {
    const Bits bits = Bits(random());
    Number number;
    std::memcpy(&number, &bits, sizeof number);
    if (!std::isnan(number)) result.push_back(number);
    result.push_back(Number(std::int64_t(random() >> 40)) / 1000);
  }
  return result;
}

template <typename Number>
std::string standard_text(Number number)
{
  char text[400];
  return {text, std::to_chars(text, text + sizeof text, number).ptr};
}

} // namespace

TEST_CASE("Numbers are written with the digits of std::to_chars()")
{
  for (double number : any_numbers<double, std::uint64_t>())
    CHECK(text_of_real(number, false) == standard_text(number));
  for (float number : any_numbers<float, std::uint32_t>())
    CHECK(text_of_real(number, true) == standard_text(number));
}

TEST_CASE("Numbers are read as by std::from_chars()")
{
  std::vector<std::string> texts{"",       "+1",    "-1",       " 1",  "1 2", "0x1p3",     "1e",   "1e+",   "1e5x",
                                 ".5",     "5.",    ".",        "-",   "inf", "-infinity", "nan",  "1e400", "-1e400",
                                 "1e-400", "0e999", "0.0e-999", "1,5", "--1", "1e5e5",     "1_000"};
  for (double number : any_numbers<double, std::uint64_t>())
    texts.push_back(standard_text(number));
  for (const std::string& text : texts) {
    INFO(text);
    double expected = 7, found = 7;
    const auto standard = std::from_chars(text.data(), text.data() + text.size(), expected);
    const auto own = real_of_text(text.data(), text.data() + text.size(), found);
    CHECK(own.ec == standard.ec);
    CHECK(own.ptr - text.data() == standard.ptr - text.data());
    CHECK((found == expected || (std::isnan(found) && std::isnan(expected))));
  }
}
