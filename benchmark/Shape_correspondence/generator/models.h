// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "assembly.h"

namespace CGAL::Shape_correspondence::generator {

/// A model by name.
struct Model
{
  std::string name;
  Assembly (*make)();
};

/// All models; the name is that of the shape that is made.
const std::vector<Model>& models();

} // namespace CGAL::Shape_correspondence::generator
