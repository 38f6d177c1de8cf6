// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "assembly.h"

namespace CGAL::Shape_correspondence::generator {

/// The name of a model, and the function that makes it.
struct Model
{
  std::string name;
  Assembly (*make)();
};

/// The models of data/; each has the name of the shape that `make()` returns.
const std::vector<Model>& models();

} // namespace CGAL::Shape_correspondence::generator
