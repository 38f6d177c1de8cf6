// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "../velocipedes.h"

namespace CGAL::Shape_correspondence::generator {

/// A wheelbarrow, a handcart with two wheels, and a wagon with four; what one pulls or pushes looks to +z, but for the
/// barrow, whose wheel does.
std::vector<Assembly> carts();

} // namespace CGAL::Shape_correspondence::generator
