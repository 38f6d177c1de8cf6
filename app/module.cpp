// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

// What the page calls: models are files of the module's own file system, and so are results.

#include <CGAL/Shape_correspondence/IO/correspondence_json.h>
#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/IO/role_model.h>
#include <CGAL/Shape_correspondence/IO/structural_graph_json.h>
#include <CGAL/Shape_correspondence/IO/write_glb.h>
#include <CGAL/Shape_correspondence/IO/write_html.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>

#include <fstream>
#include <new>
#include <string>

namespace {

namespace SC = CGAL::Shape_correspondence;

SC::Search_options options_of(const std::string& method, const std::string& category)
{
  SC::Search_options options = method == "paper" ? SC::paper_options() : SC::Search_options();
  if (method == "exact") options.method = SC::Search_method::EXACT;
  options.roles = SC::IO::shipped_role_model();
  options.category = category;
  return options;
}

void match(const std::string& source_file, const std::string& target_file, const SC::Search_options& options,
           const SC::Point& up)
{
  const SC::Segmented_shape source_shape = SC::IO::read_segmented_shape(source_file, up),
                            target_shape = SC::IO::read_segmented_shape(target_file, up);
  const SC::Structural_graph source = SC::build_structural_graph(source_shape),
                             target = SC::build_structural_graph(target_shape);
  const SC::Correspondence found = SC::find_correspondence(source, target, options);
  std::ofstream json("match.json"), glb("match.glb", std::ios::binary), page("match.html");
  SC::IO::write_correspondence_json(json, found, source, target, source_file, target_file, {});
  SC::IO::write_correspondence_glb(glb, found, source, target, &source_shape, &target_shape);
  SC::IO::write_correspondence_html(page, found, source, target, &source_shape, &target_shape);
}

} // namespace

/// Matches two models and writes `match.json`, `match.glb` and `match.html`.
/// \param method `parts`, `paper` or `exact` \param category of both, or empty \param up `y` or `z`
/// \return what is wrong, for the user; empty if nothing is. It is there until the next call
extern "C" const char* match_models(const char* source, const char* target, const char* method, const char* category,
                                    const char* up)
{
  static std::string error;
  error.clear();
  try {
    match(source, target, options_of(method, category), *up == 'z' ? SC::Point(0, 0, 1) : SC::Point(0, 1, 0));
  } catch (const std::bad_alloc&) {
    error = "the models take more than the 2 GB of memory that there are; simplify them";
  } catch (const std::exception& failure) {
    error = failure.what();
  }
  return error.c_str();
}
