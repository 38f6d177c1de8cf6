// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/colours.h"

#include <algorithm>
#include <cmath>

// Colours are spread in Oklab (B. Ottosson, 2020), a space in which distances are differences that people see.

namespace CGAL::Shape_correspondence::IO {
namespace {

using Oklab = Eigen::Vector3d; // lightness, green-red, blue-yellow

Colour linear_rgb(const Oklab& lab)
{
  const double l = lab[0] + 0.3963377774 * lab[1] + 0.2158037573 * lab[2];
  const double m = lab[0] - 0.1055613458 * lab[1] - 0.0638541728 * lab[2];
  const double s = lab[0] - 0.0894841775 * lab[1] - 1.2914855480 * lab[2];
  const Eigen::Vector3d lms(l * l * l, m * m * m, s * s * s);
  Eigen::Matrix3d to_rgb;
  to_rgb << 4.0767416621, -3.3077115913, 0.2309699292, //
      -1.2684380046, 2.6097574011, -0.3413193965,      //
      -0.0041960863, -0.7034186147, 1.7076147010;
  return to_rgb * lms;
}

bool is_displayable(const Colour& colour) { return colour.minCoeff() >= 0 && colour.maxCoeff() <= 1; }

/// Colours of some lightnesses and saturations around the circle of hues, a blue first.
std::vector<Oklab> candidates()
{
  const double first_hue = 4.4, two_pi = 6.283185307179586;
  const int hues = 48;
  std::vector<Oklab> result;
  for (double lightness : {0.65, 0.80, 0.50}) {
    for (double chroma : {0.17, 0.12}) {
      for (int i = 0; i < hues; ++i) {
        const double hue = first_hue + two_pi * i / hues;
        const Oklab lab(lightness, chroma * std::cos(hue), chroma * std::sin(hue));
        if (is_displayable(linear_rgb(lab))) result.push_back(lab);
      }
    }
  }
  return result;
}

} // namespace

std::vector<Colour> distinct_colours(std::size_t n)
{
  static const std::vector<Oklab> all = candidates();
  std::vector<double> distance(all.size(), 1e9); // of each candidate to the colours taken, greys among them
  for (std::size_t i = 0; i < all.size(); ++i)
    distance[i] = all[i].tail<2>().norm() + 0.05;
  std::vector<Colour> colours;
  for (std::size_t best = 0; colours.size() < n;) {
    colours.push_back(linear_rgb(all[best]));
    for (std::size_t i = 0; i < all.size(); ++i)
      distance[i] = std::min(distance[i], (all[i] - all[best]).norm());
    best = static_cast<std::size_t>(std::max_element(distance.begin(), distance.end()) - distance.begin());
  }
  return colours;
}

} // namespace CGAL::Shape_correspondence::IO
