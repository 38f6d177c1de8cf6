// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstdint>
#include <random>

namespace CGAL::Shape_correspondence::generator {

/// Random numbers that are the same with every standard library.
class Random
{
public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  double between(double low, double high)
  {
    return low + (high - low) * double(engine_() >> 11) * 0x1p-53; // a double has a mantissa of 53 bits
  }

  /// A random number that differs from `value` by at most `fraction` of it.
  double about(double value, double fraction = 0.12) { return between(value * (1 - fraction), value * (1 + fraction)); }

  std::size_t below(std::size_t n) { return std::size_t(engine_() % n); }

private:
  std::mt19937_64 engine_;
};

} // namespace CGAL::Shape_correspondence::generator
