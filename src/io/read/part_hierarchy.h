// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

struct Part_files
{
  std::string name;
  std::vector<std::string> files;
};

/// The hierarchy of parts in a PartNet folder: the content of `result_after_merging.json`, or else `result.json`, which
/// name files in its folder `objs`. None if there is neither file.
std::optional<std::string> hierarchy_in(const std::string& folder);

/// The parts of such a hierarchy: every node becomes a part of the files listed in the node itself.
/// \throw Invalid_input
std::vector<Part_files> parts_of_hierarchy(const std::string& hierarchy);

} // namespace CGAL::Shape_correspondence::IO
