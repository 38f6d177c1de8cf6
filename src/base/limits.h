// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <cstddef>

namespace CGAL::Shape_correspondence::internal {

// What inputs may be like. The manual, section "Limits", says the same.

/// No coordinate is farther from 0. Products of volumes stay far inside the range of double.
constexpr double largest_coordinate = 1e15;

/// No other number in a document is greater: volumes, areas, ratios.
constexpr double largest_number = 1e50;

/// Parts of a shape. Detecting symmetry and contacts takes time quadratic in them.
constexpr std::size_t most_parts = 3000;

/// Bytes of a JSON or XML document, and how deep its values may be nested.
constexpr std::size_t largest_document = std::size_t(1) << 28;
constexpr std::size_t deepest_document = 100;

} // namespace CGAL::Shape_correspondence::internal
