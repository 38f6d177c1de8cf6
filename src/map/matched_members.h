// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_MAP_MATCHED_MEMBERS_H
#define CGAL_SHAPE_CORRESPONDENCE_MAP_MATCHED_MEMBERS_H

#include "map/Charted_shape.h"

#include <CGAL/Shape_correspondence/Part_correspondence.h>

namespace CGAL {
namespace Shape_correspondence {
namespace internal {

/// Which part becomes which. Where one part corresponds to several, it becomes all of them, or all of them become it,
/// as the pairs say. Of sets of several parts on either side, a method may have paired every part with every other:
/// their members are matched by their places, which are those of the surfaces at hand.
Part_pairs matched_members(const Charted_shape& source, const Charted_shape& target, const Part_pairs& pairs);

} // namespace internal
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_MAP_MATCHED_MEMBERS_H
