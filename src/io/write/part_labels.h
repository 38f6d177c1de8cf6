// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// The displayed names of parts, all different: without a prefix of most of them and, for an exporter's
/// OBJECT_OBJECT_MATERIAL, without the second OBJECT and, if an object has only one material, without MATERIAL.
std::vector<std::string> part_labels(const std::vector<std::string>& names);

/// A list of labels in which three or more with consecutive numbers are replaced by a range: "seat, leg_1–4".
std::vector<std::string> with_ranges(const std::vector<std::string>& labels);

} // namespace CGAL::Shape_correspondence::IO
