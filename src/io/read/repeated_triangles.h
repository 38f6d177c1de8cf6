// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstdint>
#include <string>

namespace CGAL::Shape_correspondence::IO {

/// Triangles of a model beyond one a byte of its files, as strips have at most. Nodes that use the same mesh take
/// hardly any bytes, but their triangles take memory and time as all others.
constexpr std::uint64_t most_repeated_triangles = 1'000'000;

inline bool are_repeated_too_often(std::uint64_t triangles, std::uint64_t bytes)
{
  return triangles > most_repeated_triangles && triangles - most_repeated_triangles > bytes;
}

const std::string repeated_too_often =
    "its nodes use the same meshes again and again, which makes more than a million triangles beyond what is in the "
    "file; simplify these meshes, or leave out some of the nodes";

} // namespace CGAL::Shape_correspondence::IO
