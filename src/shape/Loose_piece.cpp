// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shape/Loose_piece.h"

#include "base/Disjoint_sets.h"
#include "shape/canonical_surface.h"
#include "shape/first_in_place.h"
#include "shape/triangle_distance.h"

#include <algorithm>
#include <map>
#include <utility>

namespace CGAL::Shape_correspondence::internal {
namespace {

using Indices = std::vector<std::size_t>;

std::size_t corner(const Part_mesh& mesh, std::size_t t, int k)
{
  return std::size_t(mesh.triangles(k, Eigen::Index(t)));
}

/// Whether an even number of triangles meets at every edge.
bool is_closed(const Part_mesh& mesh)
{
  const std::vector<int> place = first_in_place(mesh.points);
  std::vector<std::pair<int, int>> edges; // places of their ends
  for (std::size_t t = 0; t < std::size_t(mesh.triangles.cols()); ++t)
    for (int k = 0; k < 3; ++k) {
      const int a = place[corner(mesh, t, k)], b = place[corner(mesh, t, (k + 1) % 3)];
      if (a != b) edges.emplace_back(std::min(a, b), std::max(a, b));
    }
  std::sort(edges.begin(), edges.end());
  for (auto edge = edges.begin(); edge != edges.end();) {
    const auto next = std::upper_bound(edge, edges.end(), *edge);
    if ((next - edge) % 2 != 0) return false;
    edge = next;
  }
  return true;
}

/// For each corner, three for each triangle, the number of its place; each material has place numbers of its own.
Indices places_of_corners(const Part_mesh& mesh, const std::vector<int>& materials)
{
  const std::vector<int> place = first_in_place(mesh.points);
  Indices result;
  std::map<std::pair<int, int>, std::size_t> number;
  for (std::size_t t = 0; t < std::size_t(mesh.triangles.cols()); ++t)
    for (int k = 0; k < 3; ++k) {
      const int at = place[corner(mesh, t, k)];
      result.push_back(materials.empty() ? std::size_t(at)
                                         : number.emplace(std::pair(at, materials[t]), number.size()).first->second);
    }
  return result;
}

} // namespace

Part_mesh extracted(const Part_mesh& mesh, const Indices& triangles, std::vector<int>& number)
{
  Part_mesh result;
  result.triangles.resize(3, Eigen::Index(triangles.size()));
  Indices used;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const std::size_t v = corner(mesh, triangles[i], k);
      if (number[v] < 0) {
        number[v] = int(used.size());
        used.push_back(v);
      }
      result.triangles(k, Eigen::Index(i)) = number[v];
    }
  result.points.resize(3, Eigen::Index(used.size()));
  for (std::size_t i = 0; i < used.size(); ++i) {
    result.points.col(Eigen::Index(i)) = mesh.points.col(Eigen::Index(used[i]));
    number[used[i]] = -1;
  }
  return result;
}

std::vector<Loose_piece> loose_pieces(std::size_t object, const Part_mesh& mesh, double tolerance,
                                      const std::vector<int>& materials)
{
  const Indices place = places_of_corners(mesh, materials);
  const std::size_t places = place.empty() ? 0 : 1 + *std::max_element(place.begin(), place.end());
  Disjoint_sets sets(places);
  const auto triangles = std::size_t(mesh.triangles.cols());
  for (std::size_t t = 0; t < triangles; ++t)
    for (std::size_t k = 1; k < 3; ++k)
      sets.unite(place[3 * t], place[3 * t + k]);
  constexpr std::size_t none = std::size_t(-1);
  Indices piece_of_set(places, none);
  std::vector<Indices> pieces;
  for (std::size_t t = 0; t < triangles; ++t) {
    std::size_t& piece = piece_of_set[sets[place[3 * t]]];
    if (piece == none) {
      piece = pieces.size();
      pieces.emplace_back();
    }
    pieces[piece].push_back(t);
  }
  std::vector<Loose_piece> result;
  std::vector<int> number(std::size_t(mesh.points.cols()), -1);
  for (const Indices& piece : pieces) {
    result.push_back(loose_piece(object, extracted(mesh, piece, number), tolerance));
    result.back().triangles = piece;
  }
  return result;
}

double size_of(const Points& points, const Point& middle)
{
  Eigen::Index farthest = 0;
  (points.colwise() - middle).colwise().squaredNorm().maxCoeff(&farthest);
  const Point from = points.col(farthest);
  return (points.colwise() - from).colwise().norm().maxCoeff();
}

Loose_piece loose_piece(std::size_t object, Part_mesh mesh, double tolerance)
{
  Loose_piece result;
  result.object = object;
  result.surface = canonical_surface(mesh, tolerance);
  result.mesh = std::move(mesh);
  for (Eigen::Index t = 0; t < result.surface.triangles.cols(); ++t) {
    const contacts::Triangle corners = triangle_of(result.surface, t);
    const double twice = contacts::area_vector(corners).norm();
    result.area += twice / 2;
    result.middle += twice / 6 * (corners[0] + corners[1] + corners[2]);
  }
  const Points& points = result.surface.points;
  result.middle = result.area > 0 ? Point(result.middle / result.area) : Point(points.rowwise().mean());
  result.size = size_of(points, result.middle);
  result.closed = is_closed(result.surface);
  return result;
}

} // namespace CGAL::Shape_correspondence::internal
