// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SHAPE_CORRESPONDENCE_ABSTRACTION_ERROR_H
#define CGAL_SHAPE_CORRESPONDENCE_ABSTRACTION_ERROR_H

#include <CGAL/Shape_correspondence/Part_abstraction.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <numeric>
#include <string>
#include <vector>

namespace CGAL {
namespace Shape_correspondence {
namespace benchmark {

/// The value below which a fraction of the values lies; 0 of none.
inline double quantile(std::vector<double> values, double fraction)
{
  if (values.empty()) return 0;
  const auto k = static_cast<std::size_t>(fraction * static_cast<double>(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(k), values.end());
  return values[k];
}

inline double diagonal(const Points& points)
{
  return (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
}

inline Points read_points(const nlohmann::json& list)
{
  Points result(3, static_cast<Eigen::Index>(list.size()));
  for (std::size_t i = 0; i < list.size(); ++i)
    result.col(static_cast<Eigen::Index>(i)) << list[i][0].get<double>(), list[i][1].get<double>(),
        list[i][2].get<double>();
  return result;
}

/// The mid-lines and mid-surfaces that a model's structure.json states, by part; empty if the folder has none.
inline std::map<std::string, Part_abstraction> stated_abstractions(const std::string& folder)
{
  std::map<std::string, Part_abstraction> result;
  std::ifstream file(folder + "/structure.json");
  if (!file) return result;
  const nlohmann::json document = nlohmann::json::parse(file);
  for (const nlohmann::json& part : document.at("parts")) {
    Part_abstraction& stated = result[part.at("name").get<std::string>()];
    if (part.at("type") == "curve") {
      stated.geometry = Curve{read_points(part.at("points")), part.at("closed").get<bool>()};
      continue;
    }
    Sheet sheet;
    for (const nlohmann::json& row : part.at("grid")) {
      const Points points = read_points(row);
      sheet.cols = static_cast<int>(points.cols());
      sheet.points.conservativeResize(3, sheet.points.cols() + points.cols());
      sheet.points.rightCols(points.cols()) = points;
      ++sheet.rows;
    }
    stated.geometry = sheet;
  }
  return result;
}

inline bool same_kind(const Part_abstraction& a, const Part_abstraction& b)
{
  return a.is_sheet() == b.is_sheet() && a.is_closed_curve() == b.is_closed_curve();
}

/// Distances of points spread over one abstraction from the other, and the other way round.
inline std::vector<double> deviations(const Part_abstraction& a, const Part_abstraction& b)
{
  const int samples_of_curve = 64, samples_of_sheet = 12;
  std::vector<double> result;
  for (const auto& [from, to] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    const Points points = sample(*from, from->is_sheet() ? samples_of_sheet : samples_of_curve);
    for (Eigen::Index i = 0; i < points.cols(); ++i)
      result.push_back((points.col(i) - evaluate(*to, nearest_parameter(*to, points.col(i)))).norm());
  }
  return result;
}

/// A plane's cut through a mesh, the connected piece nearest to a point.
struct Cross_section
{
  Point centre = Point::Zero();
  double radius = 0; ///< mean distance of the outline from its centre; 0: the plane misses the mesh
};

inline Cross_section cross_section(const Part_mesh& mesh, const Point& p, const Point& normal)
{
  struct Segment
  {
    Point a, b;
    std::size_t edges[2];
  };
  std::vector<Segment> segments;
  std::map<std::pair<int, int>, std::size_t> edges;
  const Eigen::RowVectorXd heights = normal.transpose() * (mesh.points.colwise() - p);
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    Segment segment;
    int crossings = 0;
    for (int k = 0; k < 3; ++k) {
      const int u = mesh.triangles(k, t), v = mesh.triangles((k + 1) % 3, t);
      if ((heights[u] > 0) == (heights[v] > 0)) continue;
      const double f = heights[u] / (heights[u] - heights[v]);
      (crossings == 0 ? segment.a : segment.b) = (1 - f) * mesh.points.col(u) + f * mesh.points.col(v);
      segment.edges[crossings++] = edges.emplace(std::minmax(u, v), edges.size()).first->second;
    }
    if (crossings == 2) segments.push_back(segment);
  }
  std::vector<std::size_t> parent(edges.size());
  std::iota(parent.begin(), parent.end(), std::size_t(0));
  const auto find = [&](std::size_t i) {
    while (parent[i] != i)
      i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const Segment& s : segments)
    parent[find(s.edges[0])] = find(s.edges[1]);
  std::size_t nearest = 0;
  double least = 1e300;
  for (const Segment& s : segments) {
    const double distance = (0.5 * (s.a + s.b) - p).norm();
    if (distance < least) {
      least = distance;
      nearest = find(s.edges[0]);
    }
  }
  Cross_section result;
  double length = 0;
  for (const Segment& s : segments) {
    if (find(s.edges[0]) != nearest) continue;
    length += (s.b - s.a).norm();
    result.centre += (s.b - s.a).norm() * 0.5 * (s.a + s.b);
  }
  if (!(length > 0)) return Cross_section();
  result.centre /= length;
  for (const Segment& s : segments)
    if (find(s.edges[0]) == nearest)
      result.radius += (s.b - s.a).norm() / length * (0.5 * (s.a + s.b) - result.centre).norm();
  return result;
}

/// How far points inside a curve are from the centres of their cross-sections, over the radii of those.
inline std::vector<double> medialness(const Curve& curve, const Part_mesh& mesh)
{
  const int samples = 20, left_out = 3; // at the ends, where there is no cross-section to speak of
  const Points points = sample(curve, samples);
  std::vector<double> result;
  for (int i = curve.closed ? 1 : left_out; i < samples - (curve.closed ? 1 : left_out); ++i) {
    const Point direction = (points.col(i + 1) - points.col(i - 1)).normalized();
    const Cross_section section = cross_section(mesh, points.col(i), direction);
    if (section.radius > 0) result.push_back((points.col(i) - section.centre).norm() / section.radius);
  }
  return result;
}

} // namespace benchmark
} // namespace Shape_correspondence
} // namespace CGAL

#endif // CGAL_SHAPE_CORRESPONDENCE_ABSTRACTION_ERROR_H
