// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "io/write/pictures.h"
#include "base/library_call.h"
#include "shape/meshes.h"
#include "shape/triangle_distance.h"

#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace CGAL::Shape_correspondence::IO {
namespace {

constexpr double cosine_of_smooth_edge = 0.82; // of 35°, the largest angle of faces at a smooth edge
constexpr int tube_sides = 12;
constexpr double two_pi = 6.283185307179586;

Point unit(const Point& v)
{
  const double length = v.norm();
  return length > 0 ? Point(v / length) : Point::UnitY(); // the normal of a degenerate face is arbitrary
}

/// Normals of triangles, of length twice the area.
Points face_normals(const Points& points, const Eigen::Matrix3Xi& triangles)
{
  Points normals(3, triangles.cols());
  for (Eigen::Index t = 0; t < triangles.cols(); ++t)
    normals.col(t) = internal::contacts::area_vector(internal::triangle_of(points, triangles, t));
  return normals;
}

/// The mean normal of those faces at a vertex that are nearly parallel to the given one.
Point smooth_normal(const std::vector<int>& faces, int face, const Points& normals)
{
  const Point own = unit(normals.col(face));
  Point sum = Point::Zero();
  for (int other : faces) {
    if (unit(normals.col(other)).dot(own) > cosine_of_smooth_edge) sum += normals.col(other);
  }
  return unit(sum);
}

/// Triangles of a grid of vertices. The last row is joined to the first if `ring_rows`, the last column if `ring_cols`.
Eigen::Matrix3Xi grid_triangles(int rows, int cols, bool ring_rows, bool ring_cols)
{
  const int row_steps = ring_rows ? rows : rows - 1, col_steps = ring_cols ? cols : cols - 1;
  Eigen::Matrix3Xi triangles(3, 2 * row_steps * col_steps);
  int t = 0;
  for (int i = 0; i < row_steps; ++i) {
    for (int j = 0; j < col_steps; ++j) {
      const int i1 = (i + 1) % rows, j1 = (j + 1) % cols;
      triangles.col(t++) << i * cols + j, i1 * cols + j1, i1 * cols + j;
      triangles.col(t++) << i * cols + j, i * cols + j1, i1 * cols + j1;
    }
  }
  return triangles;
}

Points without_repetitions(const Points& polyline)
{
  Points result(3, polyline.cols());
  Eigen::Index n = 0;
  for (Eigen::Index i = 0; i < polyline.cols(); ++i) {
    if (n == 0 || polyline.col(i) != result.col(n - 1)) result.col(n++) = polyline.col(i);
  }
  return result.leftCols(n);
}

Drawn_mesh sphere(const Point& centre, double radius)
{
  const int rows = 7, cols = tube_sides;
  Drawn_mesh mesh;
  mesh.normals.resize(3, Eigen::Index(rows) * cols);
  for (int i = 0; i < rows; ++i) {
    const double latitude = two_pi / 2 * i / (rows - 1);
    for (int j = 0; j < cols; ++j) {
      const double longitude = two_pi * j / cols;
      mesh.normals.col(i * cols + j) << std::sin(latitude) * std::cos(longitude), std::cos(latitude),
          std::sin(latitude) * std::sin(longitude);
    }
  }
  mesh.points = (radius * mesh.normals).colwise() + centre;
  mesh.triangles = grid_triangles(rows, cols, false, true);
  return mesh;
}

void append(const Drawn_mesh& more, Drawn_mesh& all)
{
  const Eigen::Index points = all.points.cols();
  all.points.conservativeResize(3, points + more.points.cols());
  all.normals.conservativeResize(3, all.points.cols());
  all.triangles.conservativeResize(3, all.triangles.cols() + more.triangles.cols());
  all.points.rightCols(more.points.cols()) = more.points;
  all.normals.rightCols(more.points.cols()) = more.normals;
  all.triangles.rightCols(more.triangles.cols()) = more.triangles.array() + static_cast<int>(points);
}

constexpr std::size_t fewest_triangles = 24; // least number of triangles for a part: that of two boxes
constexpr double margin = 0.05; // width around the triangles at an edge, over the diagonal of their bounding box

/// The placement of Lindstrom and Turk, or the midpoint of the edge where that is far away, as on thin pieces, where
/// the planes that determine it nearly meet in a line.
class Near_placement
{
public:
  template <class Profile>
  auto operator()(const Profile& profile) const
  {
    auto place = anywhere_(profile);
    if (place && !box_of(profile).contains(internal::to_point(*place)))
      *place = CGAL::midpoint(profile.p0(), profile.p1());
    return place;
  }

private:
  /// The bounding box of the triangles at an edge, with a margin.
  template <class Profile>
  static Eigen::AlignedBox3d box_of(const Profile& profile)
  {
    Eigen::AlignedBox3d box(internal::to_point(profile.p0()));
    box.extend(internal::to_point(profile.p1()));
    for (const auto vertex : profile.link())
      box.extend(internal::to_point(get(profile.vertex_point_map(), vertex)));
    const Point side = Point::Constant(margin * box.diagonal().norm());
    return {box.min() - side, box.max() + side};
  }

  Surface_mesh_simplification::LindstromTurk_placement<internal::Halfedge_mesh> anywhere_;
};

/// Stops when few enough edges are left; the names of CGAL's own predicate differ between versions.
struct Edge_limit
{
  template <class Cost, class Profile>
  bool operator()(const Cost&, const Profile&, std::size_t, std::size_t edges) const
  {
    return edges < limit;
  }

  std::size_t limit;
};

Part_mesh collapsed(const Part_mesh& mesh, std::size_t most_triangles)
{
  internal::Halfedge_mesh surface = internal::manifold_surface(mesh);
  const std::size_t edges = most_triangles * 3 / 2; // exact for a closed surface
  Surface_mesh_simplification::edge_collapse(surface, Edge_limit{edges},
                                             CGAL::parameters::get_placement(Near_placement()));
  surface.collect_garbage();
  return surface.number_of_faces() > 0 ? internal::to_part_mesh(surface) : mesh;
}

Part_mesh simplified_part(const Part_mesh& mesh, std::size_t most_triangles)
{
  if (std::size_t(mesh.triangles.cols()) <= most_triangles) return mesh;
  return internal::library_call(
      "simplification", [&] { return collapsed(mesh, most_triangles); }, [&] { return mesh; });
}

} // namespace

Drawn_mesh shaded(const Points& points, const Eigen::Matrix3Xi& triangles)
{
  const Points normals = face_normals(points, triangles);
  std::vector<std::vector<int>> faces(points.cols()), copies(points.cols());
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    for (int k = 0; k < 3; ++k)
      faces[triangles(k, t)].push_back(static_cast<int>(t));
  }
  Drawn_mesh mesh{Points(3, triangles.size()), Points(3, triangles.size()), Eigen::Matrix3Xi(3, triangles.cols())};
  int used = 0;
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int v = triangles(k, t);
      const Point normal = smooth_normal(faces[v], static_cast<int>(t), normals);
      // Corners at one point with nearly the same normal share a vertex
      const auto copy = std::find_if(copies[v].begin(), copies[v].end(),
                                     [&](int i) { return mesh.normals.col(i).dot(normal) > 1 - 1e-6; });
      mesh.triangles(k, t) = copy == copies[v].end() ? used : *copy;
      if (copy != copies[v].end()) continue;
      copies[v].push_back(used);
      mesh.points.col(used) = points.col(v);
      mesh.normals.col(used++) = normal;
    }
  }
  mesh.points.conservativeResize(3, used);
  mesh.normals.conservativeResize(3, used);
  return mesh;
}

Drawn_mesh open_tube(const Points& polyline, bool closed, double radius, int sides)
{
  const Points centres = without_repetitions(polyline);
  const int n = static_cast<int>(centres.cols());
  Drawn_mesh mesh;
  if (n < 2) return mesh;
  mesh.points.resize(3, Eigen::Index(n) * sides);
  mesh.normals.resize(3, Eigen::Index(n) * sides);
  Point across = unit(centres.col(1) - centres.col(0)).unitOrthogonal();
  for (int i = 0; i < n; ++i) {
    const int before = closed ? (i + n - 1) % n : std::max(i - 1, 0);
    const int after = closed ? (i + 1) % n : std::min(i + 1, n - 1);
    const Point along = unit(centres.col(after) - centres.col(before));
    const Point projected = across - across.dot(along) * along;
    // The previous direction across the tube, projected, so that the tube does not twist
    across = projected.norm() > 1e-6 ? unit(projected) : along.unitOrthogonal();
    for (int k = 0; k < sides; ++k) {
      const double angle = two_pi * k / sides;
      const Point normal = std::cos(angle) * across + std::sin(angle) * along.cross(across);
      mesh.normals.col(i * sides + k) = unit(normal);
      mesh.points.col(i * sides + k) = centres.col(i) + radius * normal;
    }
  }
  mesh.triangles = grid_triangles(n, sides, closed, true);
  return mesh;
}

Drawn_mesh tube(const Points& polyline, bool closed, double radius)
{
  Drawn_mesh mesh = open_tube(polyline, closed, radius, tube_sides);
  if (closed || mesh.empty()) return mesh;
  const double round = radius * 1.05; // slightly more than the tube, so that the ends look round
  append(sphere(polyline.col(0), round), mesh);
  append(sphere(polyline.col(polyline.cols() - 1), round), mesh);
  return mesh;
}

Drawn_mesh patch(const Points& grid, int rows, int cols)
{
  return shaded(grid, grid_triangles(rows, cols, false, false));
}

std::size_t number_of_triangles(const Segmented_shape& shape)
{
  std::size_t result = 0;
  for (const Shape_part& part : shape.parts())
    result += std::size_t(part.mesh.triangles.cols());
  return result;
}

Segmented_shape simplified_shape(const Segmented_shape& shape, std::size_t most_triangles)
{
  const std::size_t all = number_of_triangles(shape);
  if (all <= most_triangles) return shape;
  Segmented_shape result(shape.name(), shape.up());
  for (const Shape_part& part : shape.parts()) {
    const double share = double(part.mesh.triangles.cols()) / double(all);
    result.add_part(
        part.name, simplified_part(part.mesh, std::max(fewest_triangles, std::size_t(share * double(most_triangles)))));
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::IO
