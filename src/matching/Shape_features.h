// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "matching/Normalized_shape.h"

#include <CGAL/Shape_correspondence/Search_options.h>

#include <cstddef>

namespace CGAL::Shape_correspondence::internal {

// What `match_parts()` knows of a shape.
struct Shape_features
{
  const Aligned_shape& shape;
  Part_assemblies assemblies; // as far as the options ask for them
  Normalized_shape normalized;

  Shape_features(const Aligned_shape& shape, const Part_matching_options& options);

  std::size_t size() const { return shape.parts.size(); }
  bool has_chain() const;
};

} // namespace CGAL::Shape_correspondence::internal
