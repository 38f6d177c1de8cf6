// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "io/write/Json.h"

#include <CGAL/Shape_correspondence/IO/collection_json.h>

namespace CGAL::Shape_correspondence::IO {

/// The shapes of a collection, the medoid and the spanning tree in the format of `write_collection_json()`: the part of
/// the document that is linear in the number of shapes.
Json collection_outline_json(const Collection& collection);

} // namespace CGAL::Shape_correspondence::IO
