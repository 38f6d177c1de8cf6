// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <CGAL/Shape_correspondence/Role_model.h>
#include <CGAL/Shape_correspondence/split_parts.h>

namespace CGAL::Shape_correspondence::IO {

/// The same as `split_parts()`, but in mode `AUTO` pieces end where the material changes only if with this the parts
/// are nearer to labelled parts of a category.
/// \param roles null: they never do
Part_split split_parts_by_roles(const Segmented_shape& objects, const Part_splitting_options& options,
                                const Role_model* roles);

} // namespace CGAL::Shape_correspondence::IO
