// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/read/model_parts.h"
#include "base/number_text.h"
#include "io/read/Gltf_document.h"
#include "io/read/text_words.h"
#include "shape/first_in_place.h"
#include "shape/meshes.h"

#include <CGAL/Shape_correspondence/Invalid_input.h>

#include <cmath>

namespace CGAL::Shape_correspondence::IO {

Model_content read_gltf_parts(std::string_view text, const std::string& file, const Reading_options& options)
{
  try {
    return read_gltf(text, file, options, nullptr);
  } catch (const Needs_import& needs) {
    try {
      return import_parts(file, options);
    } catch (const Invalid_input& error) {
      throw Invalid_input(error.what() + (" (it needs " + needs.what + ")"));
    }
  }
}

namespace {

constexpr std::string_view beginning_of_mark = "shape_correspondence parts, up ";

} // namespace

std::string mark_of_parts(const Point& up)
{
  std::string result(beginning_of_mark);
  for (int axis = 0; axis < 3; ++axis)
    result += (axis > 0 ? " " : "") + internal::number_text(up[axis]);
  return result;
}

std::optional<Point> up_in_mark(std::string_view comment)
{
  if (!begins_with(comment, beginning_of_mark)) return std::nullopt;
  comment.remove_prefix(beginning_of_mark.size());
  Point up;
  for (double& coordinate : up)
    if (!parse(next_word(comment), coordinate)) return std::nullopt;
  if (!(std::abs(up.norm() - 1) < 1e-6)) return std::nullopt; // NaN fails as well
  return up;
}

Part_mesh weld(const std::vector<Point>& corners, std::vector<std::size_t>* kept)
{
  const double* coordinates = corners.empty() ? nullptr : corners[0].data();
  const Eigen::Map<const Points> points(coordinates, 3, Eigen::Index(corners.size()));
  const std::vector<int> first = internal::first_in_place(points);
  std::vector<int> vertex(corners.size(), -1);
  std::vector<int> used; // representative corner of each vertex
  std::vector<int> triangles;
  for (std::size_t t = 0; t + 2 < corners.size(); t += 3) {
    const Eigen::Vector3i c(first[t], first[t + 1], first[t + 2]);
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) continue;
    if (kept) kept->push_back(t / 3);
    for (int corner : c) {
      if (vertex[corner] < 0) {
        vertex[corner] = static_cast<int>(used.size());
        used.push_back(corner);
      }
      triangles.push_back(vertex[corner]);
    }
  }
  Part_mesh mesh;
  mesh.points = points(Eigen::indexing::all, used);
  mesh.triangles = Eigen::Map<const Eigen::Matrix3Xi>(triangles.data(), 3, Eigen::Index(triangles.size() / 3));
  return mesh;
}

std::pair<Part_mesh, Part_appearance> joined_parts(const Segmented_shape& shape, const Shape_appearance& appearance,
                                                   const std::vector<std::size_t>& parts)
{
  std::vector<const Part_mesh*> meshes;
  std::size_t triangles = 0;
  Part_appearance looks;
  for (std::size_t part : parts) {
    meshes.push_back(&shape.parts()[part].mesh);
    const auto more = std::size_t(meshes.back()->triangles.cols());
    add_appearance(part < appearance.parts.size() ? appearance.parts[part] : Part_appearance(), more, triangles, looks);
    triangles += more;
  }
  return {internal::joined(meshes), std::move(looks)};
}

} // namespace CGAL::Shape_correspondence::IO
