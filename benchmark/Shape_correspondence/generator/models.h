// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_GENERATOR_MODELS_H
#define CGAL_SHAPE_CORRESPONDENCE_GENERATOR_MODELS_H

#include "assembly.h"

namespace CGAL {
namespace Shape_correspondence {
namespace generator {

/// The name of a model, and the function that makes it.
struct Model
{
  std::string name;
  Assembly (*make)();
};

/// The models of data/; each has the name of the shape that `make()` returns.
const std::vector<Model>& models();

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_GENERATOR_MODELS_H
