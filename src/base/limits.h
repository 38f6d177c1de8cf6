// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace CGAL::Shape_correspondence::internal {

// Limits of inputs, as in the section "Limits" of the manual. `benchmark_limits` measures times and memory at them.

/// No coordinate is farther from 0. Products of volumes stay far inside the range of double.
constexpr double largest_coordinate = 1e15;

/// No other number in a document is greater: volumes, areas, ratios.
constexpr double largest_number = 1e50;

/// Parts of a shape: contacts and matching take time and memory quadratic in them.
constexpr std::size_t most_parts = 2000;

inline std::string too_many_parts(std::size_t parts)
{
  return std::to_string(parts) + " parts, of at most " + std::to_string(most_parts) +
         "; join small parts, or leave them out";
}

/// Pairs of parts of a shape that touch.
constexpr std::size_t most_contacts = 50'000;

/// Triangles at one vertex: they are put together to a surface in time quadratic in them.
constexpr std::size_t most_triangles_of_vertex = 10000;

/// Triangles of a model of one piece that is divided into segments without being asked to.
constexpr std::size_t most_segmented_triangles = 200000;

/// Loose pieces that are grouped into parts, in time quadratic in them.
constexpr std::size_t most_grouped_pieces = 10000;

/// Pairs of congruent parts that rows of parts are looked for from, until no more are looked for: any shape of 1000
/// parts whose rows are found in ten rounds is below it.
constexpr std::size_t most_row_beginnings = 10'000'000;

/// Groups of parts that a search for the least energy deforms: the time of the beam search is cubic in them, and exact
/// search needs memory for all pairs of labels of each contact.
constexpr std::size_t most_beam_groups = 150, most_exact_groups = 500;

/// Frames of a blend.
constexpr int most_frames = 10000;

inline void check_number_of_frames(int frames)
{
  if (frames < 2 || frames > most_frames)
    throw Invalid_input("a blend has between 2 and " + std::to_string(most_frames) + " frames, not " +
                        std::to_string(frames));
}

/// Bytes of a JSON or XML document, and how deep its values may be nested.
constexpr std::size_t largest_document = std::size_t(1) << 28;
constexpr std::size_t deepest_document = 100;

/// Bytes of memory that the values of a JSON document take, which are many times those of its text if values are short.
constexpr std::uint64_t most_memory_of_values = std::uint64_t(2) << 30;

} // namespace CGAL::Shape_correspondence::internal
