// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "../designs.h"

namespace CGAL::Shape_correspondence::generator {

/// A rowing boat with a pair of oars, a dinghy with one mast, and a yawl with two; bows point to +z.
std::vector<Assembly> boats();

/// A wheelbarrow, a handcart with two wheels, and a wagon with four. The handles are in front (+z), but for the
/// wheelbarrow, which has its wheel in front.
std::vector<Assembly> carts();

} // namespace CGAL::Shape_correspondence::generator
