// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "matching/Normalized_shape.h"

#include <CGAL/Shape_correspondence/Search_options.h>

#include <cstddef>

namespace CGAL::Shape_correspondence::internal {

// What `match_parts()` knows of a shape. Threads may share it.
struct Shape_features
{
  const Aligned_shape& shape;
  Part_matching_options options;
  Part_assemblies assemblies; // as far as the options ask for them
  Normalized_shape normalized;

  Shape_features(const Aligned_shape& shape, const Part_matching_options& options);

  std::size_t size() const { return shape.parts.size(); }
};

// Whether features that were made by one of the two are those of the other.
bool are_same(const Part_matching_options& a, const Part_matching_options& b);

} // namespace CGAL::Shape_correspondence::internal
