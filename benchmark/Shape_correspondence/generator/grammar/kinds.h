// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "Sketch.h"

#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::generator {

// Each function adds the parts of a shape of its category to an empty sketch.
void draw_aeroplane(Sketch& s);
void draw_bed(Sketch& s);
void draw_car(Sketch& s);
void draw_chair(Sketch& s);
void draw_lamp(Sketch& s);
void draw_plant(Sketch& s);
void draw_shelf(Sketch& s);
void draw_sofa(Sketch& s);
void draw_table(Sketch& s);
void draw_velocipede(Sketch& s);

/// A shape of a category of the grammar; the seed determines it.
Assembly drawn_shape(const std::string& category, std::uint64_t seed);

/// `count` shapes of all categories in turn, each with a seed of its own.
std::vector<Assembly> drawn_shapes(std::size_t count, std::uint64_t seed);

/// The shapes that methods are compared on: fifteen of each of six categories.
std::vector<Assembly> compared_shapes(std::uint64_t seed = 1);

} // namespace CGAL::Shape_correspondence::generator
