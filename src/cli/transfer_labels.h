// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/Collection_options.h"
#include "cli/collection_shapes.h"

#include <CGAL/Shape_correspondence/Search_options.h>

namespace CGAL::Shape_correspondence::cli {

/// Transfers the labels of the shape of `--labels-from` to all shapes of a collection, and writes them.
void transfer_labels(const Collection_shapes& shapes, const Collection_options& options, const Search_options& search,
                     const Common_options& common);

} // namespace CGAL::Shape_correspondence::cli
