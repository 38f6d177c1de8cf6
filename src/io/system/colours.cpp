// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/system/colours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>

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

/// A colour in Oklab as seen by normal vision, and by vision without red or green cones.
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

// Colours in sRGB, none so dark that it hides the form of a part
constexpr std::array<unsigned, 20> palette = {0x3b8ede, 0xe8912d, 0x3aa655, 0xe0699a, 0x8c6bd1, 0xdcc331, 0x2fb5b5,
                                              0xcf4a3c, 0x8f9a34, 0xa0714a, 0x8fc7ee, 0xf0a58a, 0x557f66, 0x5566b5,
                                              0xb35bb3, 0xa3d65f, 0x6fd0b0, 0xcdb37e, 0xd4b5ec, 0xb8325f};

// Indices in the palette, different for roles that occur in one category
const std::map<std::string, std::size_t> place_of_role = {
    {"apron", 4},       {"arm", 1},      {"armrest", 3},   {"axle", 12},    {"back", 1},       {"back_rail", 12},
    {"backsplash", 18}, {"base", 9},     {"basket", 17},   {"bedding", 5},  {"body", 13},      {"boom", 8},
    {"bottom", 10},     {"brake", 11},   {"bulb", 5},      {"bumper", 6},   {"cabinet", 17},   {"canard", 14},
    {"canopy", 8},      {"cargo", 17},   {"caster", 7},    {"chain", 6},    {"chassis", 16},   {"cornice", 16},
    {"cushion", 10},    {"deck", 2},     {"desk", 15},     {"divider", 14}, {"door", 11},      {"drawer", 7},
    {"drivetrain", 14}, {"engine", 7},   {"faucet", 9},    {"fender", 2},   {"footboard", 14}, {"fork", 6},
    {"frame", 0},       {"fuselage", 0}, {"gear", 3},      {"grille", 14},  {"h_stab", 2},     {"handle", 3},
    {"handlebar", 4},   {"handrim", 5},  {"headboard", 1}, {"hub", 10},     {"interior", 11},  {"knob", 8},
    {"ladder", 11},     {"leaf", 2},     {"leg", 2},       {"light", 5},    {"mattress", 0},   {"mirror", 15},
    {"mudguard", 13},   {"ornament", 3}, {"panel", 10},    {"pedal", 7},    {"pillow", 10},    {"plinth", 12},
    {"post", 8},        {"pot", 9},      {"propeller", 6}, {"pylon", 5},    {"rack", 12},      {"radome", 12},
    {"rail", 4},        {"roof", 0},     {"saddle", 9},    {"seat", 0},     {"seat_frame", 4}, {"shade", 0},
    {"shelf", 5},       {"side", 6},     {"side_rail", 4}, {"sill", 7},     {"sink", 17},      {"slat", 6},
    {"soil", 17},       {"spokes", 15},  {"stairs", 13},   {"stem", 8},     {"step", 16},      {"stretcher", 6},
    {"strut", 9},       {"tabletop", 0}, {"tank", 1},      {"top", 19},     {"tray", 5},       {"underbody", 9},
    {"v_stab", 4},      {"wheel", 8},    {"window", 10},   {"wing", 1}};

Colour colour_of(unsigned srgb) { return linear_colour(Colour(srgb >> 16, srgb >> 8 & 255, srgb & 255) / 255); }

/// The n-th shade of a colour, counted from 0: shade 0 is the colour itself.
Colour shade(const Colour& colour, std::size_t n)
{
  constexpr std::array<double, 5> steps = {0, .09, -.09, .05, -.05}; // steps of lightness in [0, 1]
  Oklab lab = oklab_of(colour);
  lab[0] += steps[n % steps.size()];
  return n % steps.size() == 0 ? colour : Colour(linear_rgb(lab).cwiseMax(0).cwiseMin(1));
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

Colour role_colour(const std::string& role)
{
  const auto known = place_of_role.find(role);
  if (known != place_of_role.end()) return colour_of(palette[known->second]);
  std::size_t sum = 0; // a hash that does not depend on the standard library
  for (unsigned char c : role)
    sum = (31 * sum + c) % 65521;
  return colour_of(palette[sum % palette.size()]);
}

std::vector<Colour> colours_of_roles(const std::vector<std::string>& roles)
{
  const std::vector<Colour> distinct = distinct_colours(roles.size());
  std::map<std::string, std::size_t> counts;
  std::vector<Colour> result;
  for (const std::string& role : roles) {
    const std::size_t number = counts[role]++;
    result.push_back(role.empty() ? distinct[number] : shade(role_colour(role), number));
  }
  return result;
}

std::string css_colour(const Colour& linear)
{
  const Colour c = 255 * srgb_colour(linear);
  std::array<char, 8> text;
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", unsigned(std::lround(c[0])), unsigned(std::lround(c[1])),
                unsigned(std::lround(c[2])));
  return text.data();
}

} // namespace CGAL::Shape_correspondence::IO
