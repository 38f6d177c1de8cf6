// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "viewer/match_page.h"
#include "viewer/page_models.h"

#include <sstream>

namespace CGAL::Shape_correspondence::IO {

Page match_page(const std::vector<Correspondence>& ranked, const Structural_graph& source,
                const Structural_graph& target, const Segmented_shape* source_shape,
                const Segmented_shape* target_shape, const std::string& source_file, const std::string& target_file,
                const Match_seconds& seconds, const Add_scenes& add_scenes)
{
  std::ostringstream json, glb;
  write_correspondences_json(json, ranked, source, target, source_file, target_file, seconds);
  const Page_models models({source_shape, target_shape}, largest_page_triangles);
  write_correspondence_glb(glb, ranked.front(), source, target, models[0], models[1], add_scenes);
  return {
      structure(source).name + " and " + structure(target).name, {{"match", json.str()}}, {{"match.glb", glb.str()}}};
}

} // namespace CGAL::Shape_correspondence::IO
