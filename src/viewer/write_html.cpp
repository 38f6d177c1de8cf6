// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "viewer/match_page.h"
#include "viewer/page_models.h"

#include <CGAL/Shape_correspondence/IO/structural_graph_json.h>
#include <CGAL/Shape_correspondence/IO/write_glb.h>
#include <CGAL/Shape_correspondence/IO/write_html.h>

#include <sstream>

namespace CGAL::Shape_correspondence::IO {

void write_structural_graph_html(std::ostream& out, const Structural_graph& graph, const Segmented_shape* shape)
{
  std::ostringstream json, glb;
  write_structural_graph_json(json, graph);
  const Page_models models({shape}, largest_page_triangles);
  write_structural_graph_glb(glb, graph, models[0]);
  write_page(out, {structure(graph).name, {{"graph", json.str()}}, {{"graph.glb", glb.str()}}});
}

void write_correspondence_html(std::ostream& out, const Correspondence& correspondence, const Structural_graph& source,
                               const Structural_graph& target, const Segmented_shape* source_shape,
                               const Segmented_shape* target_shape)
{
  write_page(out, match_page({correspondence}, source, target, source_shape, target_shape, structure(source).name,
                             structure(target).name, {}));
}

} // namespace CGAL::Shape_correspondence::IO
