// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Part_abstraction.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <optional>
#include <variant>

namespace CGAL::Shape_correspondence::internal {

/// The axis of a long prism, or the middle layer of a flat one, as `Fitted_abstraction` finds them on its medial axis.
/// A prism is a part that fills the extrusion of its outline along a normal of its faces: a box, a cylinder, a plate.
/// None for other parts, and for prisms that are neither clearly long nor clearly flat. O(n log n) for n vertices.
/// \param volume volume enclosed by the mesh
/// \pre `mesh` is closed and connected
std::optional<std::variant<Curve, Sheet>> recognize_prism(const Part_mesh& mesh, double volume, int curve_points,
                                                          int sheet_points);

} // namespace CGAL::Shape_correspondence::internal
