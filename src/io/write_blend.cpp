// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/for_each_index.h"
#include "base/limits.h"
#include "io/Json.h"
#include "io/drawn_shape.h"
#include "io/picture_geometry.h"
#include "io/quoting.h"

#include <CGAL/Shape_correspondence/IO/write_blend.h>
#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <ostream>

namespace CGAL::Shape_correspondence::IO {
namespace {

constexpr double hold_seconds = 0.5, motion_seconds = 2;

const char* task_name(Blend_task_type type)
{
  static constexpr const char* names[] = {"morph", "split", "merge", "shrink", "grow"};
  return names[int(type)];
}

/// The same bytes on every machine.
template <typename Number, typename Bits>
void append_little_endian(std::string& bytes, Number number)
{
  Bits bits;
  std::memcpy(&bits, &number, sizeof(bits));
  for (std::size_t byte = 0; byte < sizeof(bits); ++byte)
    bytes.push_back(static_cast<char>(bits >> (8 * byte) & 0xFF));
}

/// The shape at an end, seen from `begin` to `end`.
int add_end(Glb_builder& glb, const Segmented_shape& shape, int side, const int* materials, double begin, double end)
{
  std::vector<int> nodes;
  for (std::size_t part = 0; part < shape.parts().size(); ++part) {
    const Part_mesh& mesh = shape.parts()[part].mesh;
    nodes.push_back(glb.add_node(shape.parts()[part].name, {{shaded(mesh.points, mesh.triangles), materials[part]}}));
    std::array<int, 2> parts{-1, -1};
    parts[side] = int(part);
    glb.set_node_extras(nodes.back(), {{"parts", Json::array({parts[0], parts[1]})}});
  }
  const int node = glb.add_node(shape.name(), nodes, Point::Zero());
  glb.animate_visibility(node, begin, end);
  return node;
}

Json quality_json(const Blend_quality& quality)
{
  return {{"gap", quality.gap},       {"apart", quality.apart},       {"asymmetry", quality.asymmetry},
          {"ground", quality.ground}, {"thinning", quality.thinning}, {"area", quality.area},
          {"volume", quality.volume}, {"torn", quality.torn},         {"overlap", quality.overlap},
          {"wobble", quality.wobble}};
}

/// \param asymmetry of the ends
Json tolerances_json(double asymmetry)
{
  return {{"gap", Shape_blend::contact_tolerance},   {"asymmetry", asymmetry + Shape_blend::symmetry_tolerance},
          {"ground", Shape_blend::ground_tolerance}, {"thinning", Shape_blend::thinning_tolerance},
          {"area", Shape_blend::area_tolerance},     {"volume", Shape_blend::volume_tolerance},
          {"torn", Shape_blend::torn_tolerance},     {"overlap", Shape_blend::overlap_tolerance},
          {"wobble", Shape_blend::wobble_tolerance}};
}

void check_number_of_frames(int frames)
{
  if (frames < 2 || frames > internal::most_frames)
    throw Invalid_input("a blend has between 2 and " + std::to_string(internal::most_frames) + " frames, not " +
                        std::to_string(frames));
}

} // namespace

void write_segmented_shape_obj(std::ostream& out, const Segmented_shape& shape)
{
  const auto precision = out.precision(17);
  int first = 1;
  for (const Shape_part& part : shape.parts()) {
    out << "o " << quote_obj(part.name) << '\n';
    for (Eigen::Index i = 0; i < part.mesh.points.cols(); ++i)
      out << "v " << part.mesh.points(0, i) << ' ' << part.mesh.points(1, i) << ' ' << part.mesh.points(2, i) << '\n';
    for (Eigen::Index t = 0; t < part.mesh.triangles.cols(); ++t)
      out << "f " << part.mesh.triangles(0, t) + first << ' ' << part.mesh.triangles(1, t) + first << ' '
          << part.mesh.triangles(2, t) + first << '\n';
    first += static_cast<int>(part.mesh.points.cols());
  }
  out.precision(precision);
}

void write_segmented_shape_ply(std::ostream& out, const Segmented_shape& shape)
{
  Eigen::Index points = 0, triangles = 0;
  out << "ply\nformat binary_little_endian 1.0\n";
  int number = 0;
  for (const Shape_part& part : shape.parts()) {
    out << "comment part " << number++ << ' ' << quote_ply(part.name) << '\n';
    points += part.mesh.points.cols();
    triangles += part.mesh.triangles.cols();
  }
  out << "element vertex " << points << "\nproperty double x\nproperty double y\nproperty double z\nelement face "
      << triangles << "\nproperty list uchar int vertex_indices\nproperty int part\nend_header\n";
  std::string vertices, faces;
  std::int32_t first = 0;
  number = 0;
  for (const Shape_part& part : shape.parts()) {
    for (Eigen::Index i = 0; i < part.mesh.points.size(); ++i)
      append_little_endian<double, std::uint64_t>(vertices, part.mesh.points.data()[i]);
    for (Eigen::Index t = 0; t < part.mesh.triangles.cols(); ++t) {
      faces.push_back(3);
      for (int corner : part.mesh.triangles.col(t))
        append_little_endian<std::int32_t, std::uint32_t>(faces, first + corner);
      append_little_endian<std::int32_t, std::uint32_t>(faces, number);
    }
    first += static_cast<std::int32_t>(part.mesh.points.cols());
    ++number;
  }
  out << vertices << faces;
}

void write_blend_glb(std::ostream& out, const Shape_blend& blend, const Correspondence& correspondence, int frames)
{
  check_number_of_frames(frames);
  const Segmented_shape source = blend(0), target = blend(1);
  Glb_builder glb;
  const std::vector<int> materials =
      add_match_materials(glb, correspondence, source.parts().size(), target.parts().size());
  const auto time = [&](double t) { return hold_seconds + t * motion_seconds; };
  std::vector<int> roots = {add_end(glb, source, 0, materials.data(), 0, hold_seconds)};

  const std::vector<Blend_surface> surfaces = blend.surfaces();
  std::vector<std::vector<Points>> shapes(surfaces.size());
  std::vector<std::vector<double>> times(surfaces.size());
  std::vector<std::vector<Points>> points(static_cast<std::size_t>(frames)); // by frame and surface
  internal::for_each_index<CGAL::Parallel_if_available_tag>(
      points.size(), [&](std::size_t frame) { points[frame] = blend.points(double(frame) / (frames - 1)); });
  for (int frame = 0; frame < frames; ++frame) {
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
      // One more before and after the frames in which it is there
      const double first = std::floor(surfaces[s].begin * (frames - 1));
      const double last = std::ceil(surfaces[s].end * (frames - 1));
      if (surfaces[s].begin >= surfaces[s].end || frame < first || frame > last) continue;
      shapes[s].push_back(std::move(points[static_cast<std::size_t>(frame)][s]));
      times[s].push_back(time(double(frame) / (frames - 1)));
    }
  }
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    if (shapes[s].empty()) continue;
    const Blend_task& task = surfaces[s].task;
    const std::size_t part = task.source != Blend_task::no_part ? task.source : source.parts().size() + task.target;
    const int node = glb.add_morphing_node(surfaces[s].name, shapes[s], surfaces[s].triangles, materials[part]);
    glb.animate_shapes(node, times[s]);
    glb.animate_visibility(node, time(surfaces[s].begin), time(surfaces[s].end));
    Json parts = Json::array();
    for (std::size_t end : {task.source, task.target})
      parts.push_back(end == Blend_task::no_part ? -1 : int(end));
    glb.set_node_extras(node, {{"parts", parts}});
    roots.push_back(node);
  }
  roots.push_back(add_end(glb, target, 1, materials.data() + source.parts().size(), time(1), time(1) + hold_seconds));
  glb.set_animation_extras({{"begin", time(0)}, {"end", time(1)}});
  glb.write(out, {{"blend", roots}});
}

void write_blend_json(std::ostream& out, const Shape_blend& blend, const Structural_graph& source,
                      const Structural_graph& target, const std::string& source_file, const std::string& target_file,
                      const std::string& output, int frames, const std::vector<std::string>& warnings)
{
  check_number_of_frames(frames);
  Json result;
  result["format"] = "shape_correspondence/blend";
  result["version"] = 1;
  result["source"] = source_file;
  result["target"] = target_file;
  result["output"] = output;
  result["tasks"] = Json::array();
  for (const Blend_task& task : blend.schedules()[0].tasks) {
    Json line = {{"task", task_name(task.type)}, {"begin", task.begin}, {"end", task.end}};
    if (task.source != Blend_task::no_part) line["source"] = structure(source).parts[task.source].name;
    if (task.target != Blend_task::no_part) line["target"] = structure(target).parts[task.target].name;
    result["tasks"].push_back(line);
  }
  result["schedules"] = Json::array();
  for (const Blend_schedule& schedule : blend.schedules())
    result["schedules"].push_back({{"name", schedule.name}, {"quality", quality_json(schedule.quality)}});
  std::vector<Blend_check> checks(static_cast<std::size_t>(frames));
  internal::for_each_index<CGAL::Parallel_if_available_tag>(
      checks.size(), [&](std::size_t frame) { checks[frame] = blend.check(double(frame) / (frames - 1)); });
  result["tolerances"] = tolerances_json(std::max(checks.front().quality.asymmetry, checks.back().quality.asymmetry));
  result["frames"] = Json::array();
  for (int frame = 0; frame < frames; ++frame) {
    const Blend_check& check = checks[static_cast<std::size_t>(frame)];
    result["frames"].push_back(
        {{"t", double(frame) / (frames - 1)}, {"quality", quality_json(check.quality)}, {"faults", check.faults}});
  }
  result["warnings"] = warnings;
  result.write(out);
}

} // namespace CGAL::Shape_correspondence::IO
