// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "cli/collection_options.h"
#include "cli/collection_shapes.h"
#include "cli/collection_work.h"

#include <CGAL/Shape_correspondence/IO/collection_json.h>
#include <CGAL/Shape_correspondence/co_analysis.h>

#include <vector>

namespace CGAL::Shape_correspondence::cli {

/// What is found out, and the maps that it is made of.
struct Analysis
{
  IO::Collection collection;
  std::vector<Shape_pair_map> maps;
};

/// Reads all pairs twice, first the energies and then those maps that are clustered or on bridges. Memory for n shapes:
/// 16 n² bytes for energies and distances; then 8 n² and, for each of 64 n maps at most, some hundred bytes and those
/// of `co_analysis()`.
Analysis analysed(const Collection_shapes& shapes, const Collection_options& options, Collection_work& work);

} // namespace CGAL::Shape_correspondence::cli
