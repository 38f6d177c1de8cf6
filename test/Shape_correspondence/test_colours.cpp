// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/system/colours.h"

#include <CGAL/Shape_correspondence/IO/role_model.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <set>

using namespace CGAL::Shape_correspondence;

namespace {

/// A linear colour as seen without cones for long or medium waves (F. Viénot, H. Brettel, J. D. Mollon, 1999).
IO::Colour without_red(const IO::Colour& c)
{
  return {0.11238 * c[0] + 0.88762 * c[1], 0.11238 * c[0] + 0.88762 * c[1], 0.00401 * c[0] - 0.00401 * c[1] + c[2]};
}
IO::Colour without_green(const IO::Colour& c)
{
  return {0.29275 * c[0] + 0.70725 * c[1], 0.29275 * c[0] + 0.70725 * c[1], -0.02234 * c[0] + 0.02234 * c[1] + c[2]};
}

/// CIE L*a*b* of a linear colour.
Eigen::Vector3d lab(const IO::Colour& c)
{
  Eigen::Matrix3d to_xyz;
  to_xyz << 0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522, 0.0721750, 0.0193339, 0.1191920, 0.9503041;
  const Eigen::Vector3d white(0.95047, 1, 1.08883);
  Eigen::Vector3d f = (to_xyz * c).cwiseQuotient(white);
  for (int k = 0; k < 3; ++k)
    f[k] = f[k] > 0.008856 ? std::cbrt(f[k]) : 7.787 * f[k] + 16. / 116;
  return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

template <typename See>
double least_difference(const std::vector<IO::Colour>& colours, const See& see)
{
  double result = 1e9;
  for (std::size_t i = 0; i < colours.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      result = std::min(result, (lab(see(colours[i])) - lab(see(colours[j]))).norm());
  return result;
}

} // namespace

TEST_CASE("Colours differ, also for people who do not see red or green")
{
  const auto all = [](const IO::Colour& c) { return c; };
  for (const auto& [n, least] : {std::pair(8, 20.), std::pair(16, 10.), std::pair(30, 5.)}) {
    const std::vector<IO::Colour> colours = IO::distinct_colours(std::size_t(n));
    INFO(n);
    CHECK(least_difference(colours, all) > least);
    CHECK(least_difference(colours, without_red) > least / 2);
    CHECK(least_difference(colours, without_green) > least / 2);
  }
}

TEST_CASE("Colours can be shown, are not grey, and the first ones stay when more are wanted")
{
  const std::vector<IO::Colour> many = IO::distinct_colours(60), few = IO::distinct_colours(7);
  for (const IO::Colour& colour : many) {
    CHECK(colour.minCoeff() >= 0);
    CHECK(colour.maxCoeff() <= 1);
    CHECK(lab(colour).tail<2>().norm() > 15);
  }
  for (std::size_t i = 0; i < few.size(); ++i)
    CHECK(few[i] == many[i]);
}

TEST_CASE("Roles of a category have colours of their own, and further parts of a role shades of it")
{
  const std::shared_ptr<const Role_model> model = IO::shipped_role_model();
  for (const std::string& category : model->categories()) {
    std::set<std::string> colours;
    for (const std::string& role : model->roles(category)) {
      INFO(category << ": " << role);
      colours.insert(IO::css_colour(IO::role_colour(role)));
      CHECK(lab(IO::role_colour(role))[0] > 40); // CIE lightness: light enough for shading to show the form
    }
    INFO(category);
    CHECK(colours.size() + 1 >=
          model->roles(category).size()); // one role that is not in the table of colours may have the colour of another
  }
  const std::vector<IO::Colour> colours = IO::colours_of_roles({"leg", "seat", "leg", "", ""});
  CHECK(colours[0] == IO::role_colour("leg"));
  CHECK(colours[1] == IO::role_colour("seat"));
  const double to_shade = (lab(colours[2]) - lab(colours[0])).norm();
  CHECK(to_shade > 3);
  CHECK(to_shade < (lab(colours[1]) - lab(colours[0])).norm());
  CHECK(colours[3] != colours[4]);
  CHECK(IO::css_colour(IO::role_colour("a role of one's own")) ==
        IO::css_colour(IO::role_colour("a role of one's own")));
}
