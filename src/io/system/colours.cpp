// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/system/colours.h"

#include <algorithm>
#include <array>
#include <cmath>

// Colours are spread in Oklab (B. Ottosson, 2020), a perceptually uniform space, also as seen with red-green colour
// blindness (G. M. Machado, M. M. Oliveira, L. A. F. Fernandes, 2009).

namespace CGAL::Shape_correspondence::IO {
namespace {

using Oklab = Eigen::Vector3d; // lightness, green-red, blue-yellow

Colour linear_rgb(const Oklab& lab)
{
  const double l = lab[0] + 0.3963377774 * lab[1] + 0.2158037573 * lab[2];
  const double m = lab[0] - 0.1055613458 * lab[1] - 0.0638541728 * lab[2];
  const double s = lab[0] - 0.0894841775 * lab[1] - 1.2914855480 * lab[2];
  const Eigen::Vector3d lms(l * l * l, m * m * m, s * s * s);
  const Eigen::Matrix3d to_rgb{{4.0767416621, -3.3077115913, 0.2309699292},
                               {-1.2684380046, 2.6097574011, -0.3413193965},
                               {-0.0041960863, -0.7034186147, 1.7076147010}};
  return to_rgb * lms;
}

Oklab oklab_of(const Colour& rgb)
{
  const Eigen::Matrix3d to_lms{{0.4122214708, 0.5363325363, 0.0514459929},
                               {0.2119034982, 0.6806995451, 0.1073969566},
                               {0.0883024619, 0.2817188376, 0.6299787005}};
  const Eigen::Matrix3d to_lab{{0.2104542553, 0.7936177850, -0.0040720468},
                               {1.9779984951, -2.4285922050, 0.4505937099},
                               {0.0259040371, 0.7827717662, -0.8086757660}};
  return to_lab * Eigen::Vector3d((to_lms * rgb).array().max(0).pow(1. / 3));
}

/// A colour in Oklab: by normal vision, and by vision without red or green cones.
struct Seen_colour
{
  explicit Seen_colour(const Oklab& lab) : by_all(lab)
  {
    const Eigen::Matrix3d protanopia{
        {0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}};
    const Eigen::Matrix3d deuteranopia{
        {0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}};
    by_some = {oklab_of(protanopia * linear_rgb(lab)), oklab_of(deuteranopia * linear_rgb(lab))};
  }

  Oklab by_all;
  std::array<Oklab, 2> by_some;
};

double difference(const Seen_colour& a, const Seen_colour& b)
{
  constexpr double share_of_some = 1.5; // factor for the smaller differences seen with colour blindness
  double result = (a.by_all - b.by_all).norm();
  for (std::size_t k = 0; k < 2; ++k)
    result = std::min(result, share_of_some * (a.by_some[k] - b.by_some[k]).norm());
  return result;
}

bool is_displayable(const Colour& colour) { return colour.minCoeff() >= 0 && colour.maxCoeff() <= 1; }

/// Colours of several lightnesses and saturations around the circle of hues, starting with blue.
std::vector<Seen_colour> candidates()
{
  const double first_hue = 4.4, two_pi = 6.283185307179586;
  const int hues = 48;
  std::vector<Seen_colour> result;
  for (double lightness : {0.65, 0.80, 0.50, 0.40}) {
    for (double chroma : {0.17, 0.12}) {
      for (int i = 0; i < hues; ++i) {
        const double hue = first_hue + two_pi * i / hues;
        const Oklab lab(lightness, chroma * std::cos(hue), chroma * std::sin(hue));
        if (is_displayable(linear_rgb(lab))) result.emplace_back(lab);
      }
    }
  }
  return result;
}

} // namespace

std::vector<Colour> distinct_colours(std::size_t n)
{
  static const std::vector<Seen_colour> all = candidates();
  std::vector<double> distance(all.size(), 1e9); // distance of each candidate from the colours taken and from grey
  for (std::size_t i = 0; i < all.size(); ++i)
    distance[i] = all[i].by_all.tail<2>().norm() + 0.05;
  std::vector<Colour> colours;
  for (std::size_t best = 0; colours.size() < n;) {
    colours.push_back(linear_rgb(all[best].by_all));
    for (std::size_t i = 0; i < all.size(); ++i)
      distance[i] = std::min(distance[i], difference(all[i], all[best]));
    best = static_cast<std::size_t>(std::max_element(distance.begin(), distance.end()) - distance.begin());
  }
  return colours;
}

} // namespace CGAL::Shape_correspondence::IO
