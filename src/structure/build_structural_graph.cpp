// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "abstraction/surface_samples.h"
#include "base/limits.h"
#include "shape/Shape_in_frame.h"
#include "structure/align_shapes.h"
#include "structure/outline_graph.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>
#include <CGAL/Shape_correspondence/abstract_part.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>
#include <CGAL/Shape_correspondence/detect_contacts.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

void check_number_of_parts(const std::string& name, std::size_t parts)
{
  if (parts < 2)
    throw Invalid_input("shape '" + name + "': has " + (parts == 0 ? "no part" : "only one part") +
                        "; give a shape that is segmented into two parts or more");
  if (parts > most_parts) throw Invalid_input("shape '" + name + "': has " + too_many_parts(parts));
}

/// Refuses a shape of the caller with coordinates, volumes or part indices out of range.
void check_numbers(const Shape_structure& shape)
{
  const auto fail = [&shape](const std::string& what) {
    throw Invalid_input("shape '" + shape.name + "': " + what + "; build its graph anew, or correct it");
  };
  const Shape_frame& frame = shape.frame;
  if (!frame.origin.allFinite() || !frame.axes.allFinite() || !(frame.height > 0) || !std::isfinite(frame.height))
    fail("its frame is not finite, or has no height");
  for (const Part_abstraction& part : shape.parts) {
    const Points& points = part.control_points();
    if (points.cols() < 2) fail("part '" + part.name + "' has fewer than two control points");
    if (!(points.array().abs() <= largest_coordinate).all()) // NaN fails as well
      fail("part '" + part.name + "' has a control point that is not finite or beyond 1e15");
    for (double measure : {part.volume, part.hull_volume, part.area})
      if (!(measure >= 0 && measure <= largest_number))
        fail("part '" + part.name + "' has a volume or an area that is negative, not finite or beyond 1e50");
  }
  for (const Contact& contact : shape.contacts)
    if (std::max(contact.parts[0], contact.parts[1]) >= shape.parts.size() || contact.parts[0] == contact.parts[1])
      fail("a contact does not name two of its parts");
}

/// Checks the options; those of the abstraction are checked where they are used.
void check_options(const Structure_options& options)
{
  check_number("build_structural_graph: the tolerance of symmetry", options.symmetry.tolerance, 0, 1);
  check_number("build_structural_graph: the tolerance of contacts", options.contacts.tolerance, 0, 1);
}

/// Refuses groups from the caller that overlap or name a part that does not exist.
void check_groups(const std::vector<Part_group>& groups, std::size_t parts)
{
  std::vector<char> is_in_group(parts, 0);
  for (const Part_group& group : groups)
    for (std::size_t part : group.parts) {
      check_index("complete_structural_graph", "part", part, parts);
      if (std::exchange(is_in_group[part], 1) != 0)
        throw Invalid_input("complete_structural_graph: part number " + std::to_string(part) +
                            " is in two groups; leave it in one");
    }
}

void warn_of_fallbacks(const std::vector<Part_abstraction>& parts, std::vector<std::string>& warnings)
{
  for (const Part_abstraction& part : parts) {
    const Abstraction_report& report = part.report;
    if (report.hull_of_box)
      warnings.push_back("Part '" + part.name + "': its convex hull could not be computed; that of its box is used.");
    if (!report.is_fallback()) continue;
    warnings.push_back("Part '" + part.name + "' is abstracted by its bounding box: " +
                       (report.copy_of.empty() ? "" : "it is a copy of part '" + report.copy_of + "', and ") +
                       report.fallback + ".");
  }
}

/// Warns of branching parts, which are neither curves nor sheets.
void warn_of_branches(const std::vector<Part_abstraction>& parts, std::vector<std::string>& warnings)
{
  std::string names;
  for (const Part_abstraction& part : parts)
    if (part.report.branching) names += (names.empty() ? "'" : ", '") + part.name + "'";
  if (!names.empty())
    warnings.push_back("Parts that branch, so that a curve or sheet stands for each only roughly: " + names +
                       ". Divide them into parts of one branch, for example into segments.");
}

/// Detects groups, unless they are given, and builds the graph.
Structural_graph assemble(Shape_structure shape, std::vector<Part_group> groups, const Structure_options& options)
{
  if (groups.empty()) groups = detect_symmetry_groups(shape.parts, shape.frame, options.symmetry, &shape.warnings);
  return make_structural_graph(std::move(shape), std::move(groups));
}

} // namespace

template <typename ConcurrencyTag>
Structural_graph build_structural_graph(const Segmented_shape& given, const Structure_options& options,
                                        Structure_times* times)
{
  check_options(options);
  check_number_of_parts(given.name(), given.parts().size());
  CGAL::Real_timer timer;
  timer.start();
  Shape_structure result;
  result.name = given.name();
  const Shape_in_frame placed(given);
  const Segmented_shape& shape = placed.shape;
  result.frame = placed.frame;
  const double before = timer.time();
  result.parts = abstract_parts<ConcurrencyTag>(shape, result.frame, options.abstraction);
  const double abstraction = timer.time() - before;
  warn_of_fallbacks(result.parts, result.warnings);
  warn_of_branches(result.parts, result.warnings);
  result.contacts =
      detect_contacts<ConcurrencyTag>(shape, result.parts, result.frame, options.contacts, result.warnings);
  Structural_graph graph = assemble(std::move(result), {}, options);
  if (times) *times = {abstraction, timer.time() - abstraction};
  return graph;
}

Structural_graph complete_structural_graph(Shape_structure shape, std::vector<Part_group> groups,
                                           const Structure_options& options)
{
  check_options(options);
  check_number_of_parts(shape.name, shape.parts.size());
  check_numbers(shape);
  check_groups(groups, shape.parts.size());
  if (shape.contacts.empty())
    shape.contacts = detect_contacts(shape.parts, shape.frame, options.contacts, shape.warnings);
  return assemble(std::move(shape), std::move(groups), options);
}

template Structural_graph build_structural_graph<CGAL::Sequential_tag>(const Segmented_shape&, const Structure_options&,
                                                                       Structure_times*);
template Structural_graph build_structural_graph<CGAL::Parallel_tag>(const Segmented_shape&, const Structure_options&,
                                                                     Structure_times*);

} // namespace CGAL::Shape_correspondence

namespace CGAL::Shape_correspondence::internal {
namespace {

Part_abstraction outline(const Shape_part& part)
{
  const Part_mesh& mesh = part.mesh;
  Part_abstraction result;
  result.name = part.name;
  Curve diagonal;
  diagonal.points.resize(3, 2);
  diagonal.points << mesh.points.rowwise().minCoeff(), mesh.points.rowwise().maxCoeff();
  result.geometry = diagonal;
  result.surface = sample_surface(mesh, surface_samples);
  result.area = surface_area(mesh);
  return result;
}

/// The structure of a shape whose parts are abstracted by `outline()`, without contacts.
Shape_structure outlines(const Segmented_shape& shape, const Shape_frame& frame)
{
  Shape_structure result;
  result.name = shape.name();
  result.frame = frame;
  for (const Shape_part& part : shape.parts())
    result.parts.push_back(outline(part));
  return result;
}

Structural_graph graph_of_parts(Shape_structure shape)
{
  std::vector<Part_group> groups(shape.parts.size());
  for (std::size_t i = 0; i < groups.size(); ++i)
    groups[i].parts = {i};
  return make_structural_graph(std::move(shape), std::move(groups));
}

} // namespace

Structural_graph outline_graph(const Segmented_shape& given)
{
  const Shape_in_frame placed(given);
  Shape_structure result = outlines(placed.shape, placed.frame);
  result.contacts =
      detect_contacts<CGAL::Sequential_tag>(placed.shape, result.parts, result.frame, {}, result.warnings);
  return graph_of_parts(std::move(result));
}

Structural_graph outline_graph(const Segmented_shape& shape, const Shape_frame& frame,
                               const std::set<std::array<std::size_t, 2>>& touching)
{
  Shape_structure result = outlines(shape, frame);
  for (const std::array<std::size_t, 2>& parts : touching)
    result.contacts.push_back({parts, {Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()}, {}});
  return graph_of_parts(std::move(result));
}

} // namespace CGAL::Shape_correspondence::internal
