// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// A part and the files of its meshes.
struct Part_files
{
  std::string name;
  std::vector<std::string> files;
};

/// The hierarchy of parts that a folder of PartNet has: `result_after_merging.json`, or else `result.json`, which name
/// files of its folder `objs`. None if it has neither.
std::optional<std::string> hierarchy_in(const std::string& folder);

/// The parts that such a hierarchy names: each node has the files that it lists and no node below it. \throw
/// Invalid_input
std::vector<Part_files> parts_of_hierarchy(const std::string& hierarchy);

} // namespace CGAL::Shape_correspondence::IO
