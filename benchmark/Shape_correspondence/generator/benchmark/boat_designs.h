// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "../assembly.h"
#include "../primitives.h"

namespace CGAL::Shape_correspondence::generator {

/// A rowing boat with a pair of oars, a dinghy with one mast, and a yawl with two; bows look to +z.
std::vector<Assembly> boats();

} // namespace CGAL::Shape_correspondence::generator
