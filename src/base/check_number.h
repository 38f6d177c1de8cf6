// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <cstddef>
#include <limits>
#include <sstream>
#include <string>

namespace CGAL::Shape_correspondence::internal {

// Checks of numbers that callers give to the library, made once, in its public functions. NaN is out of every range.

constexpr double no_limit = std::numeric_limits<double>::infinity();

inline void refuse_number(const std::string& name, double value, const std::string& range)
{
  std::ostringstream text;
  text << name << " must be " << range << ", not " << value;
  throw Invalid_input(text.str());
}

/// Throws `Invalid_input` unless least <= value <= greatest.
inline void check_number(const std::string& name, double value, double least, double greatest = no_limit)
{
  std::ostringstream range;
  if (greatest < no_limit)
    range << "between " << least << " and " << greatest;
  else
    range << "at least " << least;
  if (!(value >= least && value <= greatest)) refuse_number(name, value, range.str());
}

/// Throws `Invalid_input` unless the value is positive and finite.
inline void check_positive(const std::string& name, double value)
{
  if (!(value > 0 && value < no_limit)) refuse_number(name, value, "more than 0 and finite");
}

/// Throws `Invalid_input` unless index < count. \param what the kind of thing that is indexed, for example "shape"
inline void check_index(const std::string& function, const std::string& what, std::size_t index, std::size_t count)
{
  if (index >= count)
    throw Invalid_input(function + ": there is no " + what + " number " + std::to_string(index) + ", there are " +
                        std::to_string(count) + ", numbered from 0");
}

} // namespace CGAL::Shape_correspondence::internal
