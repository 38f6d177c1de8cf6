// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "io/write/pictures.h"
#include "viewer/page.h"

#include <CGAL/Shape_correspondence/IO/correspondence_json.h>
#include <CGAL/Shape_correspondence/blend_shapes.h>

#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::IO {

/// The page of a match: its JSON, and its GLB, in which large surfaces are simplified.
/// \param ranked the best one first \param source_shape may be null \param target_shape may be null
/// \param add_scenes adds further scenes to the GLB, such as shapes with their materials; may be empty
Page match_page(const std::vector<Correspondence>& ranked, const Structural_graph& source,
                const Structural_graph& target, const Segmented_shape* source_shape,
                const Segmented_shape* target_shape, const std::string& source_file, const std::string& target_file,
                const Match_seconds& seconds, const Add_scenes& add_scenes = {});

/// Adds the blend of the matched shapes to the page of a match. \param json as `write_blend_json()` writes it
void add_blend(Page& page, const std::string& json, const Shape_blend& blend, const Correspondence& correspondence,
               int frames);

} // namespace CGAL::Shape_correspondence::IO
