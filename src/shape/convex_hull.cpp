// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shape/convex_hull.h"
#include "base/library_call.h"
#include "base/planar_hull.h"
#include "shape/meshes.h"
#include "shape/oriented_box.h"

#include <CGAL/Convex_hull_traits_3.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/convex_hull_3.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <tuple>
#include <vector>

namespace CGAL::Shape_correspondence::internal {

/// Gives the hull, and so the triangulation within CGAL's algorithm, types of our own, which `std::less` can order.
struct Hull_mesh_tag;

using Hull_traits = CGAL::Convex_hull_traits_3<Mesh_kernel, Hull_mesh_tag, CGAL::Tag_true>;
using Hull_triangulation =
    CGAL::Triangulation_data_structure_2<CGAL::Convex_hull_vertex_base_2<CGAL::GT3_for_CH3<Hull_traits>>,
                                         CGAL::Convex_hull_face_base_2<Hull_traits>>;

} // namespace CGAL::Shape_correspondence::internal

/// `CGAL::convex_hull_3()` walks the border of the faces that a point sees from the first vertex of a `std::map`, which
/// is inside of the function and takes no other order. By default that is the vertex of the lowest address: the order
/// of the hull's vertices and faces would differ from run to run.
template <>
struct std::less<CGAL::Shape_correspondence::internal::Hull_triangulation::Vertex_handle>
{
  using Vertex_handle = CGAL::Shape_correspondence::internal::Hull_triangulation::Vertex_handle;

  bool operator()(const Vertex_handle& a, const Vertex_handle& b) const { return a->point() < b->point(); }
};

namespace CGAL::Shape_correspondence::internal {
namespace {

// Largest number of points whose hull is computed without rotating them. CGAL's time is quadratic in the number of
// points that are exactly in one plane, like the corners of a large polygon, and nearly linear otherwise.
constexpr std::size_t most_coplanar_points = 2000;

Halfedge_mesh hull_of(const std::vector<Mesh_point>& points)
{
  Halfedge_mesh result;
  CGAL::convex_hull_3(points.begin(), points.end(), result, Hull_traits());
  return result;
}

/// Many points are rotated first, so that rounding noise moves them out of common planes.
Halfedge_mesh hull_of(const Points& points)
{
  std::vector<Mesh_point> input;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    input.push_back(to_mesh_point(points.col(i)));
  if (input.size() <= most_coplanar_points) return hull_of(input);
  const Eigen::Matrix3d turn = Eigen::Quaterniond(0.8, 0.3, 0.4, 0.33).normalized().toRotationMatrix();
  std::vector<Mesh_point> turned;
  for (std::size_t i = 0; i < input.size(); ++i)
    turned.push_back(to_mesh_point(turn * points.col(Eigen::Index(i))));
  std::vector<std::size_t> order(input.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return std::tie(turned[a], a) < std::tie(turned[b], b); });
  Halfedge_mesh hull = hull_of(turned);
  std::vector<Mesh_point> vertices;
  for (const auto v : hull.vertices()) {
    const auto original = std::lower_bound(order.begin(), order.end(), hull.point(v),
                                           [&](std::size_t i, const Mesh_point& p) { return turned[i] < p; });
    vertices.push_back(hull.point(v) = input[*original]);
  }
  return vertices.size() <= most_coplanar_points ? hull_of(vertices) : hull;
}

/// The corners of a box along right-handed axes; bit k of a corner's number is its side along axis k.
Points corners(Oriented_box box)
{
  box.axes.col(2) = box.axes.col(0).cross(box.axes.col(1));
  Points result(3, 8);
  for (int i = 0; i < 8; ++i) {
    const Point sides(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5);
    result.col(i) = box.centre + box.axes * box.extents.cwiseProduct(sides);
  }
  return result;
}

/// The convex hull of points that do not lie in a plane, with triangles as faces; a box around them if CGAL fails.
struct Hull_mesh
{
  Halfedge_mesh mesh;
  bool is_box = false;
};

Hull_mesh convex_hull_mesh(const Points& points)
{
  return library_call(
      "convex hull", [&] { return Hull_mesh{hull_of(points)}; },
      [&] {
        const Points box = corners(oriented_box(points));
        const auto p = [&](int i) { return to_mesh_point(box.col(i)); };
        Hull_mesh result{{}, true};
        CGAL::make_hexahedron(p(0), p(1), p(3), p(2), p(6), p(4), p(5), p(7), result.mesh);
        return result;
      });
}

/// The hull of points that lie in the plane of a box's first two axes: a polygon without volume.
Convex_hull flat_hull(const Points& points, const Oriented_box& box)
{
  Planar_points flat;
  const Points turned = box.axes.transpose() * (points.colwise() - box.centre);
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    flat.push_back(turned.col(i).head<2>());
  const Planar_points outline = planar_hull(flat);
  Convex_hull result;
  result.vertices.resize(3, Eigen::Index(outline.size()));
  for (std::size_t i = 0; i < outline.size(); ++i)
    result.vertices.col(Eigen::Index(i)) = box.centre + box.axes.leftCols<2>() * outline[i];
  return result;
}

/// The box along the principal axes. Its least extent tells whether points are flat: volume would be rounding noise.
Oriented_box thinnest_box(const Points& points)
{
  const Points centred = points.colwise() - points.rowwise().mean();
  return box_along(points, eigen_system(scatter_matrix(centred)).vectors);
}

/// A number of twice the digits of a double (Dekker 1971): the sum high + low, with |low| at most half a unit
/// in the last place of high.
struct Double_double
{
  double high = 0, low = 0;

  static Double_double sum(double a, double b)
  {
    const double high = a + b, part = high - a;
    return {high, (a - (high - part)) + (b - part)};
  }
  /// The exact product, without `std::fma()`, which rounds twice on some systems.
  static Double_double product(double a, double b)
  {
    const auto half = [](double x) { return 0x8000001p0 * x - (0x8000001p0 * x - x); }; // its first 26 digits
    const double high = a * b, a1 = half(a), a2 = a - a1, b1 = half(b), b2 = b - b1;
    return {high, ((a1 * b1 - high) + a1 * b2 + a2 * b1) + a2 * b2};
  }
  friend Double_double operator+(const Double_double& a, const Double_double& b)
  {
    const Double_double high = sum(a.high, b.high), low = sum(a.low, b.low);
    const Double_double result = sum(high.high, high.low + low.high);
    return sum(result.high, result.low + low.low);
  }
  friend Double_double operator-(const Double_double& a, const Double_double& b)
  {
    return a + Double_double{-b.high, -b.low};
  }
  friend Double_double operator*(const Double_double& a, const Double_double& b)
  {
    const Double_double high = product(a.high, b.high);
    return sum(high.high, high.low + (a.high * b.low + a.low * b.high));
  }
};

/// Six times the signed volume of the tetrahedron of an apex and a triangle.
Double_double six_volumes(const Point& apex, const std::array<Point, 3>& corners)
{
  std::array<std::array<Double_double, 3>, 3> m;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      m[i][k] = Double_double::sum(corners[i][Eigen::Index(k)], -apex[Eigen::Index(k)]);
  Double_double result;
  for (std::size_t k = 0; k < 3; ++k)
    result = result + m[0][k] * (m[1][(k + 1) % 3] * m[2][(k + 2) % 3] - m[1][(k + 2) % 3] * m[2][(k + 1) % 3]);
  return result;
}

/// The sorted vertices of a hull, and its volume as a sum over sorted triangles, whatever the order in the mesh.
Convex_hull measured_hull(const Halfedge_mesh& mesh)
{
  std::vector<Halfedge_mesh::Vertex_index> sorted(mesh.vertices().begin(), mesh.vertices().end());
  std::sort(sorted.begin(), sorted.end(), [&](auto a, auto b) { return mesh.point(a) < mesh.point(b); });
  std::vector<int> order(mesh.number_of_vertices());
  Convex_hull result;
  result.vertices.resize(3, Eigen::Index(sorted.size()));
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    order[std::size_t(sorted[i])] = int(i);
    result.vertices.col(Eigen::Index(i)) = to_point(mesh.point(sorted[i]));
  }
  std::vector<std::array<int, 3>> triangles;
  for (auto f : mesh.faces()) {
    std::vector<int> face;
    for (auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      face.push_back(order[std::size_t(v)]);
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    for (std::size_t k = 2; k < face.size(); ++k)
      triangles.push_back({face[0], face[k - 1], face[k]});
  }
  std::sort(triangles.begin(), triangles.end());
  // Summed nearly exactly, so that the way CGAL divides flat faces into triangles changes no digit
  Double_double sum;
  for (const auto& [a, b, c] : triangles)
    sum = sum +
          six_volumes(result.vertices.col(0), {result.vertices.col(a), result.vertices.col(b), result.vertices.col(c)});
  result.volume = std::abs(sum.high) / 6;
  return result;
}

constexpr double flat = 1e-6; // thickness over width below which the volume of a hull is rounding noise

/// The points, replaced in every direction in which they have no extent by two copies, `thickness` apart.
Points thickened(const Points& points, double thickness)
{
  const Point middle = points.rowwise().mean();
  const Eigen::Matrix3d axes = eigen_system(scatter_matrix(points.colwise() - middle)).vectors;
  Points result = points;
  for (int k = 0; k < 3; ++k) {
    const Point axis = axes.col(k);
    const Eigen::RowVectorXd along = axis.transpose() * (points.colwise() - middle);
    if (along.maxCoeff() - along.minCoeff() > flat * thickness) continue;
    const Points thin = result;
    result.resize(3, 2 * thin.cols());
    result << thin.colwise() + thickness / 2 * axis, thin.colwise() - thickness / 2 * axis;
  }
  return result;
}

} // namespace

Convex_hull convex_hull(const Points& points)
{
  const double thinnest = 1e-6; // ratio of the least to the largest extent, up to which points lie in a plane
  if (points.cols() == 0) return {};
  const Oriented_box box = thinnest_box(points);
  if (box.extents[2] <= thinnest * box.extents[0]) return flat_hull(points, box);
  const Hull_mesh hull = convex_hull_mesh(points);
  Convex_hull result = measured_hull(hull.mesh);
  result.is_box = hull.is_box;
  return result;
}

Hull_planes::Hull_planes(const Points& points, double thickness)
{
  const Halfedge_mesh hull = convex_hull_mesh(thickened(points, thickness)).mesh;
  const auto faces = Eigen::Index(hull.number_of_faces());
  normals_.resize(3, faces);
  offsets_.resize(faces);
  Eigen::Index k = 0;
  for (const auto face : hull.faces()) {
    const auto h = hull.halfedge(face);
    const Point a = to_point(hull.point(hull.source(h))), b = to_point(hull.point(hull.target(h))),
                c = to_point(hull.point(hull.target(hull.next(h))));
    normals_.col(k) = (b - a).cross(c - a).normalized();
    offsets_[k] = normals_.col(k).dot(a);
    ++k;
  }
}

double Hull_planes::share_inside(const Points& points, double tolerance) const
{
  Eigen::Index inside = 0;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    inside += ((normals_.transpose() * points.col(i) - offsets_).array() <= tolerance).all();
  return double(inside) / double(points.cols());
}

} // namespace CGAL::Shape_correspondence::internal
