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

/// A model by name.
struct Model
{
  std::string name;
  Assembly (*make)();
};

/// All models; the name is that of the shape that is made.
const std::vector<Model>& models();

} // namespace generator
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_GENERATOR_MODELS_H
