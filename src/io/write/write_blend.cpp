// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/for_each_index.h"
#include "base/limits.h"
#include "base/number_text.h"
#include "io/read/model_parts.h"
#include "io/system/bytes.h"
#include "io/system/quoting.h"
#include "io/write/Json.h"
#include "io/write/ply_file.h"

#include <CGAL/Shape_correspondence/IO/write_blend.h>

#include <cstdint>
#include <ostream>

namespace CGAL::Shape_correspondence::IO {
namespace {

const char* task_name(Blend_task_type type)
{
  static constexpr const char* names[] = {"morph", "split", "merge", "shrink", "grow", "exchange"};
  return names[int(type)];
}

const char* obstacle_name(Blend_obstacle obstacle)
{
  static constexpr const char* names[] = {"", "torn", "unlike"};
  return names[int(obstacle)];
}

/// What a part does during a task, in words.
const char* told(const Blend_task& task)
{
  if (task.obstacle != Blend_obstacle::NONE) return "is exchanged";
  return task.type == Blend_task_type::SHRINK ? "vanishes" : task.type == Blend_task_type::GROW ? "grows" : "morphs";
}

const char* reason(const Blend_task& task)
{
  if (task.obstacle == Blend_obstacle::TORN) return "its surface is too different from that of its counterpart";
  if (task.obstacle == Blend_obstacle::UNLIKE)
    return "parts of its row would move far, come off what they touch, or be cut into other proportions";
  if (task.type == Blend_task_type::EXCHANGE) return "neither has a counterpart, and they are in the same place";
  const bool is_alone = task.source == Blend_task::no_part || task.target == Blend_task::no_part;
  return is_alone ? "it has no counterpart" : "the parts correspond";
}

Json quality_json(const Blend_quality& quality) { return {{"support", quality.support}, {"apart", quality.apart}}; }

/// Appends a line with a keyword and numbers: the shortest decimals that read as the same numbers.
template <typename Numbers>
void append_line(std::string& lines, char keyword, const Numbers& numbers)
{
  lines += keyword;
  for (const auto number : numbers)
    (lines += ' ') += internal::number_text(number);
  lines += '\n';
}

} // namespace

void write_segmented_shape_obj(std::ostream& out, const Segmented_shape& shape)
{
  std::string lines = "# " + mark_of_parts(shape.up()) + '\n';
  int first = 1;
  for (const Shape_part& part : shape.parts()) {
    lines += "o " + quote_obj(part.name) + '\n';
    for (const auto& p : part.mesh.points.colwise())
      append_line(lines, 'v', p);
    for (const auto& corners : part.mesh.triangles.colwise())
      append_line(lines, 'f', (corners.array() + first).matrix());
    first += static_cast<int>(part.mesh.points.cols());
    out << lines;
    lines.clear();
  }
}

void write_ply(std::ostream& out, const Point& up, const std::vector<Ply_part>& parts,
               const std::vector<std::string>& labels)
{
  const bool has_colours = !parts.empty() && !parts[0].colours.empty();
  std::string vertices, faces;
  std::int32_t points = 0, triangles = 0, number = 0;
  out << "ply\nformat binary_little_endian 1.0\ncomment " << mark_of_parts(up) << '\n';
  for (const Ply_part& part : parts) {
    out << "comment part " << number << ' ' << quote_ply(part.name) << '\n';
    for (Eigen::Index v = 0; v < part.mesh.points.cols(); ++v) {
      for (double coordinate : part.mesh.points.col(v))
        append_little_endian(vertices, coordinate);
      if (has_colours) vertices.append(reinterpret_cast<const char*>(&part.colours[3 * std::size_t(v)]), 3);
    }
    for (Eigen::Index t = 0; t < part.mesh.triangles.cols(); ++t) {
      faces.push_back(3);
      for (int corner : part.mesh.triangles.col(t))
        append_little_endian(faces, points + corner);
      append_little_endian(faces, number);
      if (!labels.empty()) append_little_endian(faces, part.labels[std::size_t(t)]);
    }
    points += static_cast<std::int32_t>(part.mesh.points.cols());
    triangles += static_cast<std::int32_t>(part.mesh.triangles.cols());
    ++number;
  }
  for (std::size_t i = 0; i < labels.size(); ++i)
    out << "comment label " << i << ' ' << quote_ply(labels[i]) << '\n';
  out << "element vertex " << points << "\nproperty double x\nproperty double y\nproperty double z\n"
      << (has_colours ? "property uchar red\nproperty uchar green\nproperty uchar blue\n" : "") << "element face "
      << triangles << "\nproperty list uchar int vertex_indices\nproperty int part\n"
      << (labels.empty() ? "" : "property int label\n") << "end_header\n"
      << vertices << faces;
}

void write_segmented_shape_ply(std::ostream& out, const Segmented_shape& shape)
{
  std::vector<Ply_part> parts;
  for (const Shape_part& part : shape.parts())
    parts.push_back({part.name, part.mesh});
  write_ply(out, shape.up(), parts);
}

void write_blend_json(std::ostream& out, const Shape_blend& blend, const Structural_graph& source,
                      const Structural_graph& target, const std::string& source_file, const std::string& target_file,
                      const std::string& output, int frames, const std::vector<std::string>& warnings)
{
  internal::check_number_of_frames(frames);
  Json result;
  result["format"] = "shape_correspondence/blend";
  result["version"] = 2;
  result["source"] = source_file;
  result["target"] = target_file;
  result["output"] = output;
  result["tasks"] = Json::array();
  for (const Blend_task& task : blend.schedules()[0].tasks) {
    Json line = {{"task", task_name(task.type)},
                 {"what", told(task)},
                 {"reason", reason(task)},
                 {"begin", task.begin},
                 {"end", task.end}};
    if (task.source != Blend_task::no_part) line["source"] = structure(source).parts[task.source].name;
    if (task.target != Blend_task::no_part) line["target"] = structure(target).parts[task.target].name;
    if (task.obstacle != Blend_obstacle::NONE) line["obstacle"] = obstacle_name(task.obstacle);
    result["tasks"].push_back(line);
  }
  result["schedules"] = Json::array();
  for (const Blend_schedule& schedule : blend.schedules())
    result["schedules"].push_back({{"name", schedule.name}, {"quality", quality_json(schedule.quality)}});
  std::vector<Blend_quality> qualities(static_cast<std::size_t>(frames));
  const auto time = [&](std::size_t frame) { return double(frame) / (frames - 1); };
  internal::for_each_index<CGAL::Parallel_if_available_tag>(
      qualities.size(), [&](std::size_t frame) { qualities[frame] = blend.quality(time(frame)); });
  result["frames"] = Json::array();
  for (std::size_t frame = 0; frame < qualities.size(); ++frame)
    result["frames"].push_back({{"t", time(frame)}, {"quality", quality_json(qualities[frame])}});
  result["warnings"] = warnings;
  result.write(out);
}

} // namespace CGAL::Shape_correspondence::IO
