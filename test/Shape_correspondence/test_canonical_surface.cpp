// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

// Results depend on the shape, not on its triangulation.
#include "part_meshes.h"
#include "shape/canonical_surface.h"
#include "shape/divide_polygon.h"

#include <CGAL/Shape_correspondence/IO/read_segmented_shape.h>
#include <CGAL/Shape_correspondence/IO/role_model.h>
#include <CGAL/Shape_correspondence/abstract_part.h>
#include <CGAL/Shape_correspondence/build_structural_graph.h>
#include <CGAL/Shape_correspondence/find_correspondence.h>
#include <CGAL/Shape_correspondence/segment_mesh.h>

#include <catch2/catch.hpp>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace CGAL::Shape_correspondence;
using namespace CGAL::Shape_correspondence::internal;

namespace {

using Edge = std::pair<int, int>;
using Triangles = std::vector<std::array<int, 3>>;

Edge edge(int a, int b) { return std::minmax(a, b); }

Triangles triangles_of_mesh(const Part_mesh& mesh)
{
  Triangles result;
  for (const auto& t : mesh.triangles.colwise())
    result.push_back({t[0], t[1], t[2]});
  return result;
}

Part_mesh mesh_of(const std::vector<Point>& points, const Triangles& triangles)
{
  Part_mesh result;
  result.points.resize(3, Eigen::Index(points.size()));
  result.triangles.resize(3, Eigen::Index(triangles.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    result.points.col(Eigen::Index(i)) = points[i];
  for (std::size_t t = 0; t < triangles.size(); ++t)
    result.triangles.col(Eigen::Index(t)) << triangles[t][0], triangles[t][1], triangles[t][2];
  return result;
}

std::vector<Point> points_of_mesh(const Part_mesh& mesh)
{
  std::vector<Point> result;
  for (const auto& p : mesh.points.colwise())
    result.emplace_back(p);
  return result;
}

using Random = std::mt19937;

/// Shuffles the vertices, the triangles and the corners of triangles.
Part_mesh shuffled(const Part_mesh& mesh, Random& random)
{
  const std::vector<Point> points = points_of_mesh(mesh);
  std::vector<int> number(points.size());
  for (std::size_t i = 0; i < number.size(); ++i)
    number[i] = int(i);
  std::shuffle(number.begin(), number.end(), random);
  std::vector<Point> moved(points.size());
  for (std::size_t i = 0; i < number.size(); ++i)
    moved[std::size_t(number[i])] = points[i];
  Triangles triangles = triangles_of_mesh(mesh);
  for (auto& t : triangles) {
    for (int& v : t)
      v = number[std::size_t(v)];
    std::rotate(t.begin(), t.begin() + std::ptrdiff_t(random() % 3), t.end());
  }
  std::shuffle(triangles.begin(), triangles.end(), random);
  return mesh_of(moved, triangles);
}

/// Swaps the diagonals of flat convex quadrangles.
Part_mesh with_other_diagonals(const Part_mesh& mesh, Random&)
{
  Triangles triangles = triangles_of_mesh(mesh);
  std::map<Edge, std::vector<std::size_t>> sides; // indices: 3 * triangle + side
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      sides[edge(triangles[t][k], triangles[t][(k + 1) % 3])].push_back(3 * t + k);
  const double size = (mesh.points.rowwise().maxCoeff() - mesh.points.rowwise().minCoeff()).norm();
  std::vector<char> is_used(triangles.size(), 0);
  for (const auto& [ends, of] : sides) {
    if (of.size() != 2) continue;
    const std::size_t s = of[0] / 3, t = of[1] / 3;
    const int a = triangles[s][of[0] % 3], b = triangles[s][(of[0] + 1) % 3], c = triangles[s][(of[0] + 2) % 3],
              d = triangles[t][(of[1] + 2) % 3];
    if (is_used[s] || is_used[t] || c == d || triangles[t][of[1] % 3] != b || sides.count(edge(c, d)) > 0) continue;
    const auto area = [&](int i, int j, int k) -> Point {
      const Point p = mesh.points.col(i), q = mesh.points.col(j), r = mesh.points.col(k);
      return (q - p).cross(r - p);
    };
    const Point normal = area(a, b, c).normalized();
    const double least = 1e-6 * size * size;
    if (std::abs(normal.dot(Point(mesh.points.col(d) - mesh.points.col(a)))) > 1e-9 * size) continue;
    if (!(area(a, d, c).dot(normal) > least && area(d, b, c).dot(normal) > least)) continue;
    triangles[s] = {a, d, c};
    triangles[t] = {d, b, c};
    is_used[s] = is_used[t] = 1;
  }
  return mesh_of(points_of_mesh(mesh), triangles);
}

/// Splits edges at their midpoints, where `is_split()`.
Part_mesh split(const Part_mesh& mesh, const std::function<bool()>& is_split)
{
  std::vector<Point> points = points_of_mesh(mesh);
  std::map<Edge, int> middles;
  const auto middle = [&](int a, int b) {
    const auto [found, is_new] = middles.try_emplace(edge(a, b), -1);
    if (is_new && is_split()) {
      found->second = int(points.size());
      points.emplace_back((points[std::size_t(a)] + points[std::size_t(b)]) / 2);
    }
    return found->second;
  };
  Triangles result;
  const std::function<void(int, int, int)> add = [&](int a, int b, int c) {
    const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    if (ab < 0 && bc < 0 && ca < 0) {
      result.push_back({a, b, c});
    } else if (ab >= 0 && bc >= 0 && ca >= 0) {
      for (const auto& t : Triangles{{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
        result.push_back(t);
    } else if (ab < 0) {
      add(b, c, a); // rotates the corners until the first side is split
    } else if (bc >= 0) {
      for (const auto& t : Triangles{{ab, b, bc}, {a, ab, bc}, {a, bc, c}})
        result.push_back(t);
    } else if (ca >= 0) {
      for (const auto& t : Triangles{{a, ab, ca}, {ab, b, c}, {ca, ab, c}})
        result.push_back(t);
    } else {
      for (const auto& t : Triangles{{a, ab, c}, {ab, b, c}})
        result.push_back(t);
    }
  };
  for (const auto& t : triangles_of_mesh(mesh))
    add(t[0], t[1], t[2]);
  return mesh_of(points, result);
}

Part_mesh subdivided(const Part_mesh& mesh, Random&)
{
  return split(mesh, [] { return true; });
}

Part_mesh refined(const Part_mesh& mesh, Random& random)
{
  return split(mesh, [&] { return random() % 4 == 0; });
}

using Change = std::function<Part_mesh(const Part_mesh&, Random&)>;

Segmented_shape changed(const Segmented_shape& shape, const Change& change)
{
  Segmented_shape result(shape.name(), shape.up());
  Random random(1);
  for (const Shape_part& part : shape.parts())
    result.add_part(part.name, change(part.mesh, random));
  return result;
}

Segmented_shape model(const std::string& name)
{
  return IO::read_segmented_shape(std::string(SHAPE_CORRESPONDENCE_DATA_DIR) + "/" + name);
}

const Structural_graph& graph_of(const std::string& name)
{
  static std::map<std::string, Structural_graph> known;
  const auto found = known.find(name);
  return found != known.end()
             ? found->second
             : known.emplace(name, build_structural_graph<CGAL::Parallel_if_available_tag>(model(name))).first->second;
}

using Names = std::vector<std::string>;

/// Of twelve pairs of shapes, those whose corresponding parts differ after `change` of the meshes of the source.
/// \param to_the_bit whether confidences are compared, too
Names changed_pairs(const Change& change, bool to_the_bit)
{
  const std::vector<std::pair<std::string, std::string>> pairs{{"chair_four_legged", "chair_swivel"},
                                                               {"chair_slatted", "chair_spindle"},
                                                               {"chair_spindle", "stool"},
                                                               {"chair_swivel", "chair_slatted"},
                                                               {"stool", "table_pedestal"},
                                                               {"table_four_legged", "table_trestle"},
                                                               {"table_pedestal", "table_four_legged"},
                                                               {"table_trestle", "bed_slatted"},
                                                               {"airplane_propeller", "airplane_twin_engine"},
                                                               {"bicycle", "tricycle"},
                                                               {"lamp_desk", "stool"},
                                                               {"bed_slatted", "chair_four_legged"}};
  Search_options options;
  options.roles = IO::shipped_role_model();
  Names result;
  for (const auto& [source, target] : pairs) {
    const auto pairs_of = [&](const Structural_graph& graph) {
      std::vector<Part_correspondence> found = find_correspondence(graph, graph_of(target), options).pairs;
      if (!to_the_bit)
        for (Part_correspondence& pair : found)
          pair.confidence = 0;
      return found;
    };
    const Segmented_shape shape = changed(model(source), change);
    if (pairs_of(build_structural_graph<CGAL::Parallel_if_available_tag>(shape)) != pairs_of(graph_of(source)))
      result.push_back(source + " " + target);
  }
  return result;
}

bool are_equal(const Part_mesh& a, const Part_mesh& b)
{
  return a.points.cols() == b.points.cols() && a.triangles.cols() == b.triangles.cols() && a.points == b.points &&
         a.triangles == b.triangles;
}

std::ptrdiff_t number_of_copies(const std::vector<Part_abstraction>& parts)
{
  return std::count_if(parts.begin(), parts.end(), [](const Part_abstraction& part) {
    return part.report.method == Abstraction_report::Method::COPY;
  });
}

constexpr double tolerance = 1e-6;

} // namespace

TEST_CASE("The canonical surface of a box has twelve triangles, however it is divided")
{
  const Part_mesh box = part_meshes::box({0, 0, 0}, {1, 2, 3}), expected = canonical_surface(box, tolerance);
  CHECK(expected.points.cols() == 8);
  CHECK(expected.triangles.cols() == 12);
  Random random(1);
  for (const auto& change : {shuffled, with_other_diagonals, subdivided, refined}) {
    Part_mesh other = box;
    for (int i = 0; i < 3; ++i) {
      other = change(other, random);
      CHECK(are_equal(canonical_surface(other, tolerance), expected));
    }
  }
}

TEST_CASE("The canonical surface of a curved mesh has as many triangles as the mesh")
{
  const Part_mesh curved = part_meshes::bipyramid(7), expected = canonical_surface(curved, tolerance);
  CHECK(expected.points.cols() == curved.points.cols());
  CHECK(expected.triangles.cols() == curved.triangles.cols());
  Random random(1);
  for (const auto& change : {shuffled, subdivided, refined})
    CHECK(are_equal(canonical_surface(change(curved, random), tolerance), expected));
}

TEST_CASE("A flat face with a hole keeps it in its canonical surface")
{
  // An open square frame of eight triangles
  std::vector<Point> points;
  for (const double size : {3., 1.})
    for (const auto& [x, y] : {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)})
      points.emplace_back(size * x, size * y, 0);
  Triangles triangles;
  for (int k = 0; k < 4; ++k) {
    const int next = (k + 1) % 4;
    triangles.push_back({k, next, 4 + next});
    triangles.push_back({k, 4 + next, 4 + k});
  }
  const Part_mesh frame = mesh_of(points, triangles), expected = canonical_surface(frame, tolerance);
  CHECK(expected.triangles.cols() == 8);
  double area = 0;
  for (const auto& t : expected.triangles.colwise()) {
    const Point p = expected.points.col(t[0]), q = expected.points.col(t[1]), r = expected.points.col(t[2]);
    area += (q - p).cross(r - p).z() / 2;
  }
  CHECK(area == Approx(32));
  Random random(1);
  for (const auto& change : {shuffled, with_other_diagonals, subdivided, refined})
    CHECK(are_equal(canonical_surface(change(frame, random), tolerance), expected));
}

TEST_CASE("A part whose surface cannot be retriangulated keeps its triangles")
{
  // Three triangles at one edge, the reverse of one of them, and a triangle without area
  const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}, {2, 0, 0}};
  const Part_mesh mesh = mesh_of(points, {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}, {2, 1, 0}, {0, 1, 5}});
  const Part_mesh result = canonical_surface(mesh, tolerance);
  CHECK(result.triangles.cols() >= 3);
  CHECK(result.triangles.maxCoeff() < result.points.cols());
}

TEST_CASE("A strut that is turned, mirrored or divided otherwise is a copy")
{
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Point(1, 2, 3).normalized()).toRotationMatrix();
  const Eigen::Matrix3d mirror = Point(-1, 1, 1).asDiagonal();
  Eigen::Matrix3d shear = Eigen::Matrix3d::Identity();
  shear(0, 2) = 0.3;
  shear(1, 2) = 0.1;
  Random random(1);
  for (const Eigen::Matrix3d& form : {Eigen::Matrix3d(Eigen::Matrix3d::Identity()), shear}) {
    const Part_mesh strut = part_meshes::moved(part_meshes::box({0, 0, 0}, {0.05, 0.05, 1}), form, {0.1, 0, 0});
    Segmented_shape shape;
    shape.add_part("strut", strut);
    shape.add_part("turned", part_meshes::moved(strut, turn, {1, 0, 0}));
    shape.add_part("mirrored", part_meshes::moved(with_other_diagonals(strut, random), mirror, {2, 0, 0}));
    shape.add_part("both", part_meshes::moved(subdivided(strut, random), mirror * turn, {3, 0, 0}));
    shape.add_part("refined", part_meshes::moved(refined(strut, random), turn * turn, {4, 0, 0}));
    CHECK(number_of_copies(abstract_parts(shape, {})) == 4);
  }
}

TEST_CASE("Parts with the same corners but other faces are no copies")
{
  // A cube without two opposite sides, and two cubes without two adjacent sides, one of which is a copy
  const Part_mesh cube = part_meshes::box({0, 0, 0}, {1, 1, 1});
  const auto without = [&](const Point& first, const Point& second) {
    Triangles kept;
    for (const auto& t : triangles_of_mesh(cube)) {
      const Point p = cube.points.col(t[0]), q = cube.points.col(t[1]), r = cube.points.col(t[2]);
      const Point normal = (q - p).cross(r - p).normalized();
      if (normal.dot(first) < 0.5 && normal.dot(second) < 0.5) kept.push_back(t);
    }
    return mesh_of(points_of_mesh(cube), kept);
  };
  Segmented_shape shape;
  shape.add_part("opposite", without(Point::UnitX(), -Point::UnitX()));
  shape.add_part("adjacent", without(Point::UnitX(), Point::UnitY()));
  shape.add_part("others", without(-Point::UnitX(), Point::UnitZ()));
  Abstraction_options options;
  options.time_limit = 0; // bounding boxes suffice
  CHECK(number_of_copies(abstract_parts(shape, {}, options)) == 1);
}

TEST_CASE("Of the eight struts of a table seven are copies")
{
  std::vector<Part_abstraction> struts = structure(graph_of("table_trestle")).parts;
  const auto is_other = [](const Part_abstraction& part) { return part.name.rfind("strut", 0) != 0; };
  struts.erase(std::remove_if(struts.begin(), struts.end(), is_other), struts.end());
  CHECK(struts.size() == 8);
  CHECK(number_of_copies(struts) == 7);
}

TEST_CASE("The order of triangles and of vertices changes no segment of a mesh")
{
  const Part_mesh mesh = part_meshes::torus(1, 0.2);
  Random random(1);
  const Segmented_shape expected = segment_mesh(mesh).shape, found = segment_mesh(shuffled(mesh, random)).shape;
  REQUIRE(found.parts().size() == expected.parts().size());
  for (std::size_t i = 0; i < found.parts().size(); ++i)
    CHECK(are_equal(found.parts()[i].mesh, expected.parts()[i].mesh));
}

TEST_CASE("The order of triangles and of vertices changes no match in the least")
{
  CHECK(changed_pairs(shuffled, true) == Names{});
}

TEST_CASE("Other diagonals of flat quadrangles change no match in the least")
{
  CHECK(changed_pairs(with_other_diagonals, true) == Names{});
}

TEST_CASE("Subdivision changes no match of twelve") { CHECK(changed_pairs(subdivided, false) == Names{}); }

TEST_CASE("Uneven refinement changes no match of twelve") { CHECK(changed_pairs(refined, false) == Names{}); }

TEST_CASE("Noise of a millionth of the size changes no match of twelve")
{
  const auto noisy = [](const Part_mesh& mesh, Random& random) {
    Part_mesh result = mesh;
    const double size = (mesh.points.rowwise().maxCoeff() - mesh.points.rowwise().minCoeff()).norm();
    for (double& x : result.points.reshaped())
      x += 1e-6 * size * (2. * random() / double(Random::max()) - 1);
    return result;
  };
  CHECK(changed_pairs(noisy, false) == Names{});
}

TEST_CASE("A turn by less than 45 degrees changes no match")
{
  const auto turned = [](const Part_mesh& mesh, Random&) {
    return Part_mesh{Eigen::AngleAxisd(0.5, Point::UnitY()).toRotationMatrix() * mesh.points, mesh.triangles};
  };
  CHECK(changed_pairs(turned, false) == Names{});
}

TEST_CASE("A polygon with a gap in its border is not divided")
{
  std::vector<Point> points;
  std::vector<Link> border;
  const int n = 7;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * double(EIGEN_PI) * i / n;
    points.push_back({std::cos(angle), std::sin(angle), 0});
    border.push_back({i, (i + 1) % n});
  }
  const Eigen::Matrix3d stretch = Eigen::Matrix3d::Identity();
  CHECK(divide_polygon(points, border, {}, Point::UnitZ(), stretch).size() == std::size_t(n - 2));
  for (int gap = 0; gap < n; ++gap) {
    std::vector<Link> open = border;
    open.erase(open.begin() + gap);
    CHECK(divide_polygon(points, open, {}, Point::UnitZ(), stretch).empty());
  }
}
