// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SHAPE_CORRESPONDENCE_TEST_DAMAGED_MESHES_H
#define SHAPE_CORRESPONDENCE_TEST_DAMAGED_MESHES_H

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <cmath>
#include <cstdint>
#include <vector>

/// Part meshes with every kind of damage, reproducible by seed on all machines.
namespace damaged_meshes {

using namespace CGAL::Shape_correspondence;

/// A small random number generator with the same results on all machines (SplitMix64).
class Random
{
public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits()
  {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
  }
  double uniform(double low, double high) { return low + (high - low) * std::ldexp(double(bits() >> 11), -53); }
  int below(int n) { return static_cast<int>(bits() % static_cast<std::uint64_t>(n)); }
  bool with_probability(double p) { return uniform(0, 1) < p; }

private:
  std::uint64_t state_;
};

/// A closed grid of rings from pole to pole, or around a torus: bars, plates, balls, spindles, rings.
inline Part_mesh random_solid(Random& random, int rings, int sides)
{
  const bool is_torus = random.with_probability(0.2);
  const double power = random.uniform(0.15, 1); // exponent of a superellipsoid; small values are box-like
  const Point size(random.uniform(0.02, 1), random.uniform(0.02, 1), random.uniform(0.02, 1));
  const auto bent = [&](double x) { return std::copysign(std::pow(std::abs(x), power), x); };
  Part_mesh mesh;
  mesh.points.resize(3, rings * sides);
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < sides; ++j) {
      const double v = 2 * EIGEN_PI * j / sides;
      const double u = is_torus ? 2 * EIGEN_PI * i / rings : EIGEN_PI * (i + 0.5) / rings;
      const double r = is_torus ? 1 + 0.3 * size.x() * std::cos(u) : bent(std::sin(u));
      const double h = is_torus ? 0.3 * size.x() * std::sin(u) : bent(std::cos(u));
      mesh.points.col(i * sides + j) << size.x() * r * bent(std::cos(v)), size.y() * h,
          size.z() * r * bent(std::sin(v));
    }
  }
  std::vector<Eigen::Vector3i> triangles;
  const auto add_quad = [&](int a, int b, int c, int d) {
    triangles.emplace_back(a, b, c);
    triangles.emplace_back(a, c, d);
  };
  for (int i = 0; i + (is_torus ? 0 : 1) < rings; ++i) {
    for (int j = 0; j < sides; ++j) {
      const int next = (i + 1) % rings * sides, k = (j + 1) % sides;
      add_quad(i * sides + j, i * sides + k, next + k, next + j);
    }
  }
  for (int j = 1; !is_torus && j + 1 < sides; ++j) {
    triangles.emplace_back(0, j + 1, j);
    triangles.emplace_back((rings - 1) * sides, (rings - 1) * sides + j, (rings - 1) * sides + j + 1);
  }
  mesh.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
  for (std::size_t t = 0; t < triangles.size(); ++t)
    mesh.triangles.col(static_cast<Eigen::Index>(t)) = triangles[t];
  return mesh;
}

inline void keep_triangles(Part_mesh& mesh, const std::vector<Eigen::Index>& kept)
{
  Eigen::Matrix3Xi triangles(3, static_cast<Eigen::Index>(kept.size()));
  for (std::size_t t = 0; t < kept.size(); ++t)
    triangles.col(static_cast<Eigen::Index>(t)) = mesh.triangles.col(kept[t]);
  mesh.triangles = triangles;
}

/// Deletes, duplicates, flips and flattens triangles, displaces vertices, and pushes the mesh through itself, each with
/// some probability and to a random extent.
inline void damage(Part_mesh& mesh, Random& random)
{
  const auto extent = [&](double probability, double most) {
    return random.with_probability(probability) ? std::pow(10, random.uniform(-4, 0)) * most : 0;
  };
  const double noise = extent(0.4, 0.3), deleted = extent(0.4, 0.9), doubled = extent(0.3, 0.5),
               flipped = extent(0.3, 1), flattened = extent(0.3, 0.5);
  for (Eigen::Index i = 0; noise > 0 && i < mesh.points.size(); ++i)
    mesh.points.data()[i] += random.uniform(-noise, noise);
  if (random.with_probability(0.1)) mesh.points.row(random.below(3)) *= random.with_probability(0.5) ? 0 : 1e-7;
  if (random.with_probability(0.15)) { // pushes one half through the other
    const double shift = random.uniform(-1, 1);
    for (Eigen::Index v = 0; v < mesh.points.cols() / 2; ++v)
      mesh.points.col(v) += Point(shift, 0.3 * shift, 0);
  }
  std::vector<Eigen::Index> kept;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    if (random.with_probability(deleted)) continue;
    kept.push_back(t);
    if (random.with_probability(doubled)) kept.push_back(t);
    if (random.with_probability(flipped)) std::swap(mesh.triangles(0, t), mesh.triangles(1, t));
    if (random.with_probability(flattened)) mesh.triangles(0, t) = mesh.triangles(random.below(3), t);
  }
  keep_triangles(mesh, kept);
}

/// \param largest approximate limit for the number of triangles
inline Part_mesh damaged_mesh(std::uint64_t seed, double largest)
{
  Random random(seed);
  const double triangles = std::exp(random.uniform(std::log(12.), std::log(largest)));
  const int sides = 3 + random.below(static_cast<int>(std::sqrt(triangles)));
  const int rings = std::max(3, static_cast<int>(triangles / (2 * sides)));
  Part_mesh mesh = random_solid(random, rings, sides);
  damage(mesh, random);
  if (random.with_probability(0.05))
    mesh.triangles = mesh.triangles.leftCols(std::min<Eigen::Index>(1, mesh.triangles.cols())).eval();
  return mesh;
}

} // namespace damaged_meshes

#endif // SHAPE_CORRESPONDENCE_TEST_DAMAGED_MESHES_H
