// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/system/colours.h"
#include "io/write/part_labels.h"
#include "viewer/pages.h"

#include <CGAL/Shape_correspondence/IO/role_model.h>
#include <CGAL/Shape_correspondence/IO/structural_graph_json.h>
#include <CGAL/Shape_correspondence/IO/write_glb.h>
#include <CGAL/Shape_correspondence/IO/write_html.h>

#include <sstream>

namespace CGAL::Shape_correspondence::IO {

std::vector<std::string> likeliest_roles(const Structural_graph& graph)
{
  std::vector<std::string> result;
  const std::shared_ptr<const Role_model> model = shipped_role_model();
  if (!model || structure(graph).parts.size() < 2) return result;
  for (const Part_label& label : part_roles(graph, *model).labels)
    result.push_back(label.coarse);
  return result;
}

void write_structural_graph_html(std::ostream& out, const Structural_graph& graph, const Segmented_shape* shape)
{
  std::ostringstream json, glb;
  write_structural_graph_json(json, graph);
  const Page_models models({shape}, largest_page_triangles);
  write_structural_graph_glb(glb, graph, models[0]);
  std::vector<std::string> names, colours, roles = likeliest_roles(graph);
  for (const Part_abstraction& part : structure(graph).parts)
    names.push_back(part.name);
  Json looks{{"labels", part_labels(names, roles)}, {"roles", roles}};
  for (const Colour& colour : colours_of_roles(roles))
    colours.push_back(css_colour(colour));
  looks["colours"] = colours;
  write_page(out,
             {structure(graph).name, {{"graph", json.str()}, {"looks", looks.line()}}, {{"graph.glb", glb.str()}}});
}

void write_correspondence_html(std::ostream& out, const Correspondence& correspondence, const Structural_graph& source,
                               const Structural_graph& target, const Segmented_shape* source_shape,
                               const Segmented_shape* target_shape)
{
  write_page(out, match_page({correspondence}, source, target, source_shape, target_shape, structure(source).name,
                             structure(target).name, {}));
}

} // namespace CGAL::Shape_correspondence::IO
