// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_CART_DESIGNS_H
#define CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_CART_DESIGNS_H

#include "../velocipedes.h"

namespace CGAL {
namespace Shape_correspondence {
namespace generator {

/// A wheelbarrow, a handcart with two wheels, and a wagon with four. The handles are in front (+z), but for the
/// wheelbarrow, which has its wheel in front.
std::vector<Assembly> carts();

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_GENERATOR_BENCHMARK_CART_DESIGNS_H
