// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "shape/patch_contacts.h"

#include "base/eigen_system.h"
#include "base/quantized.h"
#include "shape/canonical_surface.h"
#include "shape/sample_triangles.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace CGAL::Shape_correspondence::internal {
namespace {

// Lengths are fractions of the diagonal of the model's box.

constexpr double concave_height = 1e-6; // least height of a triangle over its neighbour's plane at a concave edge
constexpr int all_samples = 8000;       // number of sample points on all patches together
constexpr int fewest_samples = 12;      // least number of sample points on a patch, unless there are many patches
// Margin by which a patch may reach out of another one's box and still count as inside; gap that such a pair is assumed
// to have.
constexpr double box_margin = 0.01, gap_in_box = 0.03;
constexpr std::size_t most_in_box = 20; // greatest number of patches that are paired with the one whose box holds them
constexpr std::size_t most_patches_in_boxes = 150; // if there are more patches, none are paired by boxes

class Patch_measures
{
public:
  Patch_measures(const Welded_triangles& triangles, const Triangle_pieces& pieces, Surface_patches& surface)
      : triangles_(triangles), pieces_(pieces), surface_(surface)
  {
    measure();
    find_borders();
    find_near();
    find_common_places();
    find_in_boxes();
    find_shapes();
    for (const auto& [pair, contact] : contacts_)
      surface.contacts.push_back({pair.first, pair.second, contact});
  }

private:
  /// The triangles of a patch, whatever the triangles into which the file divides its flat faces.
  std::vector<std::array<Point, 3>> canonical_triangles(const Numbers& triangles) const
  {
    Part_mesh mesh;
    mesh.points.resize(3, 3 * Eigen::Index(triangles.size()));
    mesh.triangles.resize(3, Eigen::Index(triangles.size()));
    for (std::size_t i = 0; i < triangles.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        mesh.points.col(3 * Eigen::Index(i) + k) = triangles_.corner(triangles[i], k);
        mesh.triangles(k, Eigen::Index(i)) = 3 * int(i) + k;
      }
    const Part_mesh canonical = canonical_surface(mesh, flatness_tolerance(1));
    std::vector<std::array<Point, 3>> result;
    for (Eigen::Index t = 0; t < canonical.triangles.cols(); ++t)
      result.push_back(triangle_of(canonical, t));
    return result;
  }

  void measure()
  {
    std::vector<Numbers> triangles(numbers_in(pieces_.patches));
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      triangles[pieces_.patches[t]].push_back(t);
    for (const Numbers& of_patch : triangles) {
      surface_.patches.push_back({{},
                                  {},
                                  triangles_.objects[of_patch[0]],
                                  pieces_.sheets[of_patch[0]],
                                  pieces_.components[of_patch[0]],
                                  0,
                                  canonical_triangles(of_patch)});
      Surface_patch& patch = surface_.patches.back();
      surfaces_.emplace_back();
      for (const std::array<Point, 3>& t : patch.triangles) {
        const double area = (t[1] - t[0]).cross(t[2] - t[0]).norm() / 2;
        const Point sum = t[0] + t[1] + t[2];
        Eigen::Matrix3d second = sum * sum.transpose();
        for (const Point& p : t) {
          second += p * p.transpose();
          patch.box.extend(p);
        }
        patch.moments += {area, area / 3 * sum, area / 12 * second};
        surfaces_.back().push_back({t[0], t[1] - t[0], t[2] - t[0], area});
      }
    }
  }

  Patch_contact& contact(std::size_t i, std::size_t j, double gap)
  {
    Patch_contact& result = contacts_.try_emplace(std::minmax(i, j), Patch_contact{gap}).first->second;
    result.gap = std::min(result.gap, gap);
    return result;
  }

  void find_borders()
  {
    triangles_.for_each_neighbours(pieces_.sheets, [&](const Triangle_side& a, const Triangle_side& b) {
      const std::size_t i = pieces_.patches[a.triangle], j = pieces_.patches[b.triangle];
      if (i == j) return;
      Patch_contact& border = contact(i, j, 0);
      const double l = triangles_.length(a);
      border.border += l;
      border.flat_border += l * triangles_.cosine(a, b);
      const Point off = triangles_.middle(b.triangle) - triangles_.middle(a.triangle);
      if (triangles_.normals[a.triangle].dot(off) > concave_height) border.concave_border += l;
    });
  }

  /// Finds pairs of patches within `patch_reach`, their gaps and the areas near each other, by samples.
  void find_near()
  {
    std::vector<Point> samples;
    Numbers of_patch, count;
    const int fewest = std::clamp(all_samples / int(surfaces_.size()), 3, fewest_samples);
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
      const double share = surface_.patches[i].moments.area / surface_.area;
      const int number = std::max(fewest, int(std::lround(share * all_samples)));
      const auto found = contacts::sample_triangles(surfaces_[i], number);
      samples.insert(samples.end(), found.points.begin(), found.points.end());
      of_patch.resize(samples.size(), i);
      count.push_back(found.points.size());
    }
    Points points(3, Eigen::Index(samples.size()));
    for (std::size_t k = 0; k < samples.size(); ++k)
      points.col(Eigen::Index(k)) = samples[k];
    const Point_grid grid(points, patch_reach);
    constexpr double far = std::numeric_limits<double>::infinity();
    std::vector<double> nearest(surfaces_.size(), far); // indexed by patch: squared distance of the current sample
    Numbers found;
    for (std::size_t k = 0; k < samples.size(); ++k) {
      const std::size_t own = of_patch[k];
      grid.for_each_near(k, patch_reach, samples.size(), [&](std::size_t other, double squared) {
        const std::size_t patch = of_patch[other];
        if (patch == own) return;
        if (nearest[patch] == far) found.push_back(patch);
        nearest[patch] = std::min(nearest[patch], squared);
      });
      for (std::size_t patch : found) {
        contact(own, patch, std::sqrt(nearest[patch])).near[own < patch ? 0 : 1] +=
            surface_.patches[own].moments.area / double(count[own]);
        nearest[patch] = far;
      }
      found.clear();
    }
  }

  /// Marks the contacts of patches of different sheets that have common vertices.
  void find_common_places()
  {
    for (const Numbers& at : triangles_.triangles_of_places()) {
      std::set<std::size_t> patches;
      for (std::size_t t : at)
        patches.insert(pieces_.patches[t]);
      constexpr std::size_t most = 7; // number of patches at a point; with more, it is a hub, which tells nothing
      if (patches.size() > most) continue;
      for (auto i = patches.begin(); i != patches.end(); ++i)
        for (auto j = std::next(i); j != patches.end(); ++j)
          if (surface_.patches[*i].sheet != surface_.patches[*j].sheet) contact(*i, *j, 0).has_common_places = true;
    }
  }

  /// Adds contacts of patches with those whose boxes contain them, so that they may be merged.
  void find_in_boxes()
  {
    if (surface_.patches.size() > most_patches_in_boxes) return;
    for (std::size_t i = 0; i < surface_.patches.size(); ++i) {
      Eigen::AlignedBox3d box = surface_.patches[i].box;
      box.min().array() -= box_margin;
      box.max().array() += box_margin;
      std::size_t count = 0;
      for (std::size_t j = 0; j < surface_.patches.size() && count < most_in_box; ++j)
        if (j != i && box.contains(surface_.patches[j].box)) {
          contact(i, j, gap_in_box);
          ++count;
        }
    }
  }

  /// Gives patches of about the same area and principal lengths the same shape number.
  void find_shapes()
  {
    std::vector<Eigen::Array4d> sizes;
    for (const Surface_patch& patch : surface_.patches) {
      const double area = std::max(patch.moments.area, 1e-12);
      const Point centre = patch.moments.first / area;
      const Eigen::Vector3d variances =
          eigen_system(patch.moments.second / area - centre * centre.transpose()).values.cwiseMax(0);
      sizes.push_back({std::sqrt(area), std::sqrt(variances[0]), std::sqrt(variances[1]), std::sqrt(variances[2])});
    }
    Numbers order(sizes.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return quantized(sizes[a][0]) > quantized(sizes[b][0]); });
    // Tolerances of lengths, as a length plus a share of the root of the area; and of that root, as a share of it
    constexpr double same_length = 0.004, same_share = 0.04, same_area = 0.015;
    std::vector<bool> is_known(sizes.size(), false);
    std::size_t number = 0;
    for (std::size_t i : order) {
      if (is_known[i]) continue;
      for (std::size_t j : order)
        if (!is_known[j] && ((sizes[i] - sizes[j]).abs() <= same_length + same_share * sizes[i][0]).all() &&
            std::abs(sizes[i][0] - sizes[j][0]) <= same_area * sizes[i][0]) {
          is_known[j] = true;
          surface_.patches[j].shape = number;
        }
      ++number;
    }
  }

  const Welded_triangles& triangles_;
  const Triangle_pieces& pieces_;
  Surface_patches& surface_;
  std::vector<std::vector<contacts::Sampled_triangle>> surfaces_; // indexed by patch; canonical
  std::map<std::pair<std::size_t, std::size_t>, Patch_contact> contacts_;
};

} // namespace

void measure_patches(const Welded_triangles& triangles, const Triangle_pieces& pieces, Surface_patches& surface)
{
  if (const std::size_t count = numbers_in(pieces.patches); count > most_patches)
    surface.patches.resize(count);
  else
    Patch_measures(triangles, pieces, surface);
}

} // namespace CGAL::Shape_correspondence::internal
