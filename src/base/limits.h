// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <cstddef>
#include <cstdint>
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

// Limits of inputs (manual, "Limits"). `benchmark_limits` measures times and memory at them.

/// Largest absolute value of a coordinate. Products of volumes stay far inside the range of double.
constexpr double largest_coordinate = 1e15;

/// Largest absolute value of other numbers in documents: volumes, areas, ratios.
constexpr double largest_number = 1e50;

/// Largest number of parts of a shape: contacts and matching take time and memory quadratic in it.
constexpr std::size_t most_parts = 2000;

inline std::string too_many_parts(std::size_t parts)
{
  return std::to_string(parts) + " parts, of at most " + std::to_string(most_parts) +
         "; join small parts, or leave them out";
}

/// Largest number of pairs of parts of a shape that are in contact.
constexpr std::size_t most_contacts = 50'000;

/// Largest number of triangles at one vertex: assembling a surface from them takes time quadratic in it.
constexpr std::size_t most_triangles_of_vertex = 10000;

/// Largest number of triangles of a model of one piece that is divided into segments by default.
constexpr std::size_t most_segmented_triangles = 200000;

/// Largest number of loose pieces that are grouped into parts: grouping takes time quadratic in it.
constexpr std::size_t most_grouped_pieces = 10000;

/// Number of pairs of congruent parts that are tried as the first two parts of a row; after it, no more rows are looked
/// for. It suffices for any shape of 1000 parts whose rows are found in ten rounds.
constexpr std::size_t most_row_beginnings = 10'000'000;

/// Largest numbers of symmetry groups of the shape that a search for the least energy deforms: beam search takes time
/// cubic in it, and exact search needs memory for all pairs of labels of each contact.
constexpr std::size_t most_beam_groups = 150, most_exact_groups = 500;

constexpr int most_frames = 10000;

inline void check_number_of_frames(int frames)
{
  if (frames < 2 || frames > most_frames)
    throw Invalid_input("a blend has between 2 and " + std::to_string(most_frames) + " frames, not " +
                        std::to_string(frames));
}

/// Largest size in bytes of a JSON or XML document, and largest nesting depth of its values.
constexpr std::size_t largest_document = std::size_t(1) << 28;
constexpr std::size_t deepest_document = 100;

/// Limit of the memory in bytes for the values of a JSON document, which is a multiple of the size of its text if
/// values are short.
constexpr std::uint64_t most_memory_of_values = std::uint64_t(2) << 30;

} // namespace CGAL::Shape_correspondence::internal
