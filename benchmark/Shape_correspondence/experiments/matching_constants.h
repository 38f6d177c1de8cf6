// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// The constants of the match by parts, and the header that has them.
#ifndef CGAL_SHAPE_CORRESPONDENCE_EXPERIMENTS_MATCHING_CONSTANTS_H
#define CGAL_SHAPE_CORRESPONDENCE_EXPERIMENTS_MATCHING_CONSTANTS_H

#include <CGAL/Shape_correspondence/Part_matching_options.h>

#include <cstdio>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace experiments {

/// A constant, with what its documentation says.
struct Matching_constant
{
  const char* name;
  std::variant<double Part_cost_weights::*, double Part_matching_options::*, std::size_t Part_matching_options::*>
      member;
  bool is_fitted;      ///< to labelled shapes; not a count
  const char* meaning; ///< with the unit

  bool is_weight() const { return member.index() == 0; }

  double value(const Part_matching_options& options) const
  {
    if (const auto weight = std::get_if<0>(&member)) return options.weights.*(*weight);
    if (const auto bound = std::get_if<1>(&member)) return options.*(*bound);
    return double(options.*std::get<2>(member));
  }

  void set(double value, Part_matching_options& options) const
  {
    if (const auto weight = std::get_if<0>(&member))
      options.weights.*(*weight) = value;
    else if (const auto bound = std::get_if<1>(&member))
      options.*(*bound) = value;
    else
      options.*std::get<2>(member) = std::size_t(value);
  }
};

inline const std::vector<Matching_constant>& matching_constants()
{
  using W = Part_cost_weights;
  using O = Part_matching_options;
  static const std::vector<Matching_constant> constants{
      {"overlap", &W::overlap, true, "share of the smaller bounding box that lies outside of the other one"},
      {"extent", &W::extent, true, "|log of the ratio of the sides of the bounding boxes|, summed over the axes"},
      {"ground", &W::ground, true, "one part stands on the ground and the other does not; half for upright boards"},
      {"place", &W::place, true, "level distance of the centres of the bounding boxes, summed over the axes"},
      {"orientation", &W::orientation, true,
       "Frobenius distance of the normalized square roots of the covariances of the surfaces"},
      {"chamfer", &W::chamfer, true, "mean distance of points of either surface from the other one"},
      {"whole", &O::whole, true,
       "Cost. Added where a part corresponds to a panel or a regular arrangement as a whole."},
      {"tolerance", &O::tolerance, true,
       "Length. What is shorter is as good as 0: added to the sides of bounding boxes, and the height up to which a "
       "part stands on the ground. Parts that pair one to one at no more than this cost are the same."},
      {"anchor", &O::anchor, true,
       "Likelihood, in [0, 1]. Pairs above it warp one shape towards the other; staying in place has this weight."},
      {"warp_width", &O::warp_width, true, "Length. Standard deviation of the influence of such a pair."},
      {"excess", &O::excess, true,
       "Cost. A pair is matched if its cost is the least one of either part and exceeds the least costs of both parts "
       "by at most this sum. Smaller values give fewer pairs of higher precision."},
      {"confident_excess", &O::confident_excess, true,
       "Cost. The same bound for pairs that decide which sets of parts correspond."},
      {"main_surface", &O::main_surface, true,
       "Share. A seat or table top covers at least this much of the shape as seen from above, and is no thicker than "
       "this much of its shorter side."},
      {"side_depth", &O::side_depth, true,
       "Length. What lies in one side of the shape is no thicker, and no farther from it."},
      {"wall_width", &O::wall_width, true, "Length. A wider part on the ground is a wall, not a leg."},
      {"repetition", &O::repetition, false,
       "Count, at least 2. A regular arrangement has this number of parts or more."}};
  return constants;
}

/// Two significant digits.
inline std::string short_number(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", value);
  return text;
}

/// include/CGAL/Shape_correspondence/Part_matching_options.h with these values.
inline std::string matching_header(const Part_matching_options& options)
{
  std::ostringstream out;
  const auto comment = [&out](const std::string& text) {
    std::istringstream words(text);
    std::string line = "  ///";
    for (std::string word; words >> word; line += ' ' + word)
      if (line.size() + 1 + word.size() > 120) {
        out << line << '\n';
        line = "  ///";
      }
    out << line << '\n';
  };
  const auto declare = [&](bool weights) {
    for (const Matching_constant& constant : matching_constants())
      if (constant.is_weight() == weights) {
        comment(constant.meaning);
        out << "  " << (constant.member.index() == 2 ? "std::size_t " : "double ") << constant.name << " = "
            << short_number(constant.value(options)) << ";\n";
      }
  };
  out << R"(// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

// In the form that `experiments fit` writes. Values were chosen on labelled and generated shapes; the fit kept them,
// since fitted ones scored less on categories left out (benchmark/Shape_correspondence/RESULTS.md). To change a
// comment, change experiments/matching_constants.h.

#ifndef CGAL_SHAPE_CORRESPONDENCE_PART_MATCHING_OPTIONS_H
#define CGAL_SHAPE_CORRESPONDENCE_PART_MATCHING_OPTIONS_H

#include <CGAL/Shape_correspondence/Role_model.h>

#include <cstddef>

namespace CGAL {
namespace Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceOptions
/// Weights of the terms in the cost of substituting one part for another. Lengths are fractions of the extents of the
/// shapes: along each axis of the common frame, either shape extends from 0 to 1. Weights are not negative; 0 switches
/// a term off.
struct Part_cost_weights
{
)";
  declare(true);
  out << R"(};

/// \ingroup PkgShapeCorrespondenceOptions
/// Options of `Search_method::PARTS`. Costs are in the unit of `Part_cost_weights`, lengths as there. They are not
/// negative; `tolerance`, `anchor` and `warp_width` are above 0.
struct Part_matching_options : Role_options
{
  Part_cost_weights weights; ///< weights of the terms of a cost
)";
  declare(false);
  out << R"(  bool panels = true;  ///< match panels as sets: rows of parts, and boards in one side of the shape
  bool support = true; ///< match the parts that support a seat or table top as a set
};

} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_PART_MATCHING_OPTIONS_H
)";
  return out.str();
}

} // namespace experiments
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_EXPERIMENTS_MATCHING_CONSTANTS_H
