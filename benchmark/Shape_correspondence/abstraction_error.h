// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "base/Disjoint_sets.h"

#include <CGAL/Shape_correspondence/Part_abstraction.h>
#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <Eigen/Geometry>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace CGAL::Shape_correspondence::benchmark {

/// The value of rank `fraction` (0: the least, 0.5: the median, 1: the greatest); 0 if there are no values.
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

/// Distances of sample points of each of two abstractions from the other one.
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

/// The cut of a mesh by a plane: line segments, each with the number of the connected piece that it belongs to.
class Plane_cut
{
public:
  struct Segment
  {
    Point a, b;
    std::size_t piece = 0; ///< segments of the same connected piece have the same number

    Point middle() const { return 0.5 * (a + b); }
    double length() const { return (b - a).norm(); }
  };

  Plane_cut(const Part_mesh& mesh, const Point& p, const Point& normal)
  {
    std::map<std::pair<int, int>, std::size_t> edges;
    std::vector<std::array<std::size_t, 2>> edges_of_segments;
    const Eigen::RowVectorXd heights = normal.transpose() * (mesh.points.colwise() - p);
    for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
      Segment segment;
      std::array<std::size_t, 2> cut_edges;
      std::size_t crossings = 0;
      for (int k = 0; k < 3; ++k) {
        const int u = mesh.triangles(k, t), v = mesh.triangles((k + 1) % 3, t);
        if ((heights[u] > 0) == (heights[v] > 0)) continue;
        const double f = heights[u] / (heights[u] - heights[v]);
        (crossings == 0 ? segment.a : segment.b) = (1 - f) * mesh.points.col(u) + f * mesh.points.col(v);
        cut_edges[crossings++] = edges.emplace(std::minmax(u, v), edges.size()).first->second;
      }
      if (crossings != 2) continue;
      segments_.push_back(segment);
      edges_of_segments.push_back(cut_edges);
    }
    internal::Disjoint_sets pieces(edges.size());
    for (const auto& [e, f] : edges_of_segments)
      pieces.unite(e, f);
    for (std::size_t i = 0; i < segments_.size(); ++i)
      segments_[i].piece = pieces[edges_of_segments[i][0]];
  }

  const std::vector<Segment>& segments() const { return segments_; }

  /// The piece nearest to a point, and all pieces that are joined to it by a chain of gaps smaller than `gap`.
  std::set<std::size_t> pieces_near(const Point& p, double gap) const
  {
    std::set<std::size_t> result;
    if (segments_.empty()) return result;
    const auto nearer = [&p](const Segment& s, const Segment& t) { return distance(s, p) < distance(t, p); };
    std::vector<const Segment*> queue{&*std::min_element(segments_.begin(), segments_.end(), nearer)};
    result.insert(queue.front()->piece);
    for (const Segment& s : segments_)
      if (s.piece == queue.front()->piece) queue.push_back(&s);
    for (std::size_t next = 0; next < queue.size(); ++next)
      for (const Segment& s : segments_)
        if (result.count(s.piece) == 0 && distance(s, queue[next]->middle()) < gap) {
          result.insert(s.piece);
          for (const Segment& other : segments_)
            if (other.piece == s.piece) queue.push_back(&other);
        }
    return result;
  }

private:
  static double distance(const Segment& s, const Point& p)
  {
    const Point along = s.b - s.a;
    const double t = along.squaredNorm() > 0 ? (p - s.a).dot(along) / along.squaredNorm() : 0;
    return (s.a + std::clamp(t, 0., 1.) * along - p).norm();
  }

  std::vector<Segment> segments_;
};

struct Cross_section
{
  Point centre = Point::Zero();
  double radius = 0; ///< mean distance of the outline from `centre`; 0: the plane misses the mesh
};

/// The cross-section by a plane near `p`: the piece nearest to `p`, and pieces near that one, such as the second shell
/// of a hollow part or the tyre on a rim. Their gap is below the alpha of the wrap that closes such parts.
inline Cross_section cross_section(const Part_mesh& mesh, const Point& p, const Point& normal)
{
  const double gap = diagonal(mesh.points) / 20;
  const Plane_cut cut(mesh, p, normal);
  const std::set<std::size_t> pieces = cut.pieces_near(p, gap);
  Cross_section result;
  double length = 0;
  for (const Plane_cut::Segment& s : cut.segments()) {
    if (pieces.count(s.piece) == 0) continue;
    length += s.length();
    result.centre += s.length() * s.middle();
  }
  if (!(length > 0)) return Cross_section();
  result.centre /= length;
  for (const Plane_cut::Segment& s : cut.segments())
    if (pieces.count(s.piece) > 0) result.radius += s.length() / length * (s.middle() - result.centre).norm();
  return result;
}

/// For points of a curve: distance from the centre of the cross-section, relative to its radius (0: medial).
inline std::vector<double> medialness(const Curve& curve, const Part_mesh& mesh)
{
  const int samples = 20, left_out = 3; // samples skipped at each end of an open curve, where the part is cut obliquely
  const Points points = sample(curve, samples);
  std::vector<double> result;
  for (int i = curve.closed ? 1 : left_out; i < samples - (curve.closed ? 1 : left_out); ++i) {
    const Point direction = (points.col(i + 1) - points.col(i - 1)).normalized();
    const Cross_section section = cross_section(mesh, points.col(i), direction);
    if (section.radius > 0) result.push_back((points.col(i) - section.centre).norm() / section.radius);
  }
  return result;
}

} // namespace CGAL::Shape_correspondence::benchmark
