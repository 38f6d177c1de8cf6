// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// The names of a shape's parts as people read them, all different: without the prefix that most of them have, and
/// where an exporter wrote OBJECT_OBJECT_MATERIAL, without the second OBJECT, and without the material if the object
/// has no other one.
std::vector<std::string> part_labels(const std::vector<std::string>& names);

/// Labels in a list; of three or more with consecutive numbers the first and the last: "seat, leg_1–4".
std::vector<std::string> with_ranges(const std::vector<std::string>& labels);

} // namespace CGAL::Shape_correspondence::IO
