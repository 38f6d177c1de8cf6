// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Role_model.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <array>
#include <cstddef>

namespace CGAL::Shape_correspondence::internal {

/// Distance of a shape from the nearest category, in standard deviations of a feature; infinite without categories.
double distance_of_nearest_category(const Structural_graph& graph, const Role_model& model);

/// The axis with which the parts of a shape are nearest to labelled parts of a category.
struct Up_by_roles
{
  std::size_t axis = 1;
  bool is_nearer = false; ///< whether nearer than with any other axis by the share `Role_options::clearly_better`
  bool is_clear = false;  ///< whether nearer by the ratio `Role_options::category_ratio`
};

/// Compares the three axes. \param frames of the shape with x, y or z up
Up_by_roles up_by_roles(const Structural_graph& graph, const std::array<Shape_frame, 3>& frames,
                        const Role_model& model, const Role_options& options = {});

} // namespace CGAL::Shape_correspondence::internal
