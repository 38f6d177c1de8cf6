// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// The names of a shape's parts as people read them, all different and of at most 24 characters: without the prefix
/// that most of them have; without the second OBJECT and the material where an exporter wrote OBJECT_OBJECT_MATERIAL;
/// without words and numbers of modellers, such as Cylinder.001; pieces of an object with numbers (arm 1, arm 2). A
/// name that says nothing (Object_4), that has no English word for a part (silla_pata), or that parts of different
/// roles share, becomes the role with a number (leg 3).
/// \param roles of the parts; empty if they are not known, as the roles of single parts may be
std::vector<std::string> part_labels(const std::vector<std::string>& names, const std::vector<std::string>& roles = {});

/// A role in words: without underscores and abbreviations. The viewer's `roleText()` has the same words.
std::string role_text(std::string role);

/// A list of labels in which three or more with consecutive numbers are replaced by a range: "seat, leg_1–4".
std::vector<std::string> with_ranges(const std::vector<std::string>& labels);

} // namespace CGAL::Shape_correspondence::IO
