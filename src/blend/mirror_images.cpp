// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/mirror_images.h"
#include "base/quantized.h"
#include "blend/surface_components.h"
#include "map/Charted_mesh.h"
#include "map/piece_of.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace CGAL::Shape_correspondence::internal {
namespace {

/// Whether the mirror image of a box is near to another box.
bool are_mirror_images(const contacts::Box& box, const contacts::Box& other, double tolerance)
{
  Point low = mirrored(box.min()), high = mirrored(box.max());
  std::swap(low.x(), high.x());
  return (low - other.min()).cwiseAbs().maxCoeff() <= tolerance &&
         (high - other.max()).cwiseAbs().maxCoeff() <= tolerance;
}

/// From the coordinates of a point in one chart to those of its mirror image in the other, as nearly as axes and their
/// signs can tell.
Eigen::Matrix3d mirror_turn(const Part_chart& chart, const Part_chart& image)
{
  const Eigen::Matrix3d wanted = -(image.axes().transpose() * Point(-1, 1, 1).asDiagonal() * chart.axes());
  Eigen::Matrix3d best = Eigen::Matrix3d::Identity();
  for (const Eigen::Matrix3d& turn : cube_rotations())
    if (quantized(turn.cwiseProduct(wanted).sum()) > quantized(best.cwiseProduct(wanted).sum())) best = turn;
  return -best;
}

/// Whether a chart of a part that is its own mirror image has coordinates that are their own mirror image, too.
bool is_mirrored(const Part_chart& chart)
{
  constexpr double upright = 0.05; // sine of an angle; also of the height
  const Eigen::Matrix3d axes = chart.axes(), image = Point(-1, 1, 1).asDiagonal() * axes;
  return std::abs(chart(Point::Zero()).x()) <= upright &&
         (axes * mirror_turn(chart, chart) - image).cwiseAbs().maxCoeff() <= upright;
}

/// A rotation near to `axes` with one column along x, so that mirroring in x = 0 keeps all of their directions.
/// \param kept the column that is turned least
Eigen::Matrix3d mirrored_axes(const Eigen::Matrix3d& axes, int kept)
{
  const auto along_x = [&](int column) { return Point(axes(0, column) < 0 ? -1 : 1, 0, 0); };
  const auto in_plane = [&](int column) {
    return unit_or(Point(0, axes(1, column), axes(2, column)), Point(Point::UnitY()));
  };
  const int next = (kept + 1) % 3, last = (kept + 2) % 3;
  const bool kept_is_x = std::abs(axes(0, kept)) > std::sqrt(0.5);
  const bool next_is_x = quantized(std::abs(axes(0, next))) >= quantized(std::abs(axes(0, last)));
  Eigen::Matrix3d result;
  result.col(kept) = kept_is_x ? along_x(kept) : in_plane(kept);
  if (kept_is_x || !next_is_x) {
    result.col(last) = kept_is_x ? in_plane(last) : along_x(last);
    result.col(next) = result.col(last).cross(result.col(kept));
  } else {
    result.col(next) = along_x(next);
    result.col(last) = result.col(kept).cross(result.col(next));
  }
  return result;
}

/// The points of a part and of its mirror image in the mirror.
Points with_image(const Points& part, const Points& image)
{
  Points result(3, part.cols() + image.cols());
  result << part, mirrored(image);
  return result;
}

/// A chart of a part that is its own mirror image with coordinates that are their own mirror image, too: the mean of
/// the given one and its image if they are alike, or else a straight one.
Part_chart mirrored_chart(const Part_chart& chart, const Points& surface)
{
  const Points both = with_image(surface, surface);
  const Eigen::Matrix3d turn = mirror_turn(chart, chart);
  const int kept = chart.is_sheet() ? 2 : 0;
  if (is_mirrored(chart) && turn(kept, kept) != 0) return chart.symmetrised(turn).fitted(both);
  const Eigen::Matrix3d axes = mirrored_axes(chart.axes(), kept);
  return chart.is_sheet() ? Part_chart::plate(both, axes) : Part_chart::box(both, axes);
}

} // namespace

double mirror_distance(const Points& points, const contacts::Triangle_tree& surface)
{
  constexpr Eigen::Index samples = 24;
  const Eigen::Index n = std::min(points.cols(), samples);
  double sum = 0;
  std::size_t triangle = 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const Point image = mirrored(Point(points.col(i * points.cols() / n)));
    sum += (surface.nearest(image, triangle) - image).squaredNorm();
  }
  return std::sqrt(sum / double(n));
}

double mirror_residual(const std::vector<const Points*>& surfaces,
                       const std::vector<std::optional<contacts::Triangle_tree>>& trees)
{
  constexpr Eigen::Index samples = 24; // of a surface
  double sum = 0;
  int count = 0;
  std::size_t last = 0; // what is nearest to a point is likely to be that to the next one, too
  for (const Points* points : surfaces) {
    const Eigen::Index n = std::min(points->cols(), samples);
    for (Eigen::Index i = 0; i < n; ++i) {
      Point p = mirrored(Point(points->col(i * points->cols() / n))), nearest;
      std::size_t triangle;
      double squared = std::numeric_limits<double>::infinity();
      const auto improve = [&](std::size_t tree) {
        if (trees[tree] && contacts::squared_distance(trees[tree]->box(), p) < squared &&
            trees[tree]->improve_nearest(p, nearest, squared, triangle))
          last = tree;
      };
      improve(last);
      for (std::size_t tree = 0; tree < trees.size(); ++tree)
        improve(tree);
      sum += squared;
      ++count;
    }
  }
  return std::sqrt(sum / count);
}

/// Pairs of parts nearest to being mirror images of each other come first.
Mirror_images::Mirror_images(const std::vector<Part_mesh>& parts) : images_(parts.size(), none)
{
  constexpr double tolerance = 0.05; // of the height: how far a part is from the mirror image of another at most
  const std::vector<contacts::Triangle_tree> trees = trees_of(parts);
  std::vector<std::tuple<Steps, std::size_t, std::size_t>> likely;
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t j = i; j < parts.size(); ++j) {
      if (!are_mirror_images(trees[i].box(), trees[j].box(), 2 * tolerance)) continue;
      const double distance =
          std::max(mirror_distance(parts[i].points, trees[j]), mirror_distance(parts[j].points, trees[i]));
      if (distance <= tolerance) likely.emplace_back(quantized(distance), i, j);
    }
  std::sort(likely.begin(), likely.end());
  for (const auto& [distance, i, j] : likely)
    if (images_[i] == none && images_[j] == none) images_[i] = j, images_[j] = i;
}

void add_mirrored(Part_pairs& pairs, const Mirror_images& source, const Mirror_images& target)
{
  for (std::size_t i = 0, count = pairs.size(); i < count; ++i) {
    const std::size_t s = source[pairs[i].first], t = target[pairs[i].second];
    if (s != Mirror_images::none && t != Mirror_images::none) pairs.emplace_back(s, t);
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

void mirror_charts(const std::vector<Part_mesh>& parts, const Mirror_images& images, std::vector<Part_chart>& charts)
{
  for (std::size_t part = 0; part < parts.size(); ++part) {
    const std::size_t image = images[part];
    if (image == Mirror_images::none || image < part) continue;
    if (image == part) {
      charts[part] = mirrored_chart(charts[part], parts[part].points);
    } else {
      charts[part] = charts[part].fitted(with_image(parts[part].points, parts[image].points));
      charts[image] = charts[part].image();
    }
  }
}

std::optional<Eigen::Matrix3d> mirrored_turn(const Piece_pair& pair, const Charted_shape& source,
                                             const Charted_shape& target)
{
  const auto [from, to] = piece_charts(pair, source, target);
  if (!is_mirrored(from) || !is_mirrored(to)) return {};
  const Eigen::Matrix3d before = mirror_turn(from, from), after = mirror_turn(to, to);
  return best_turn(from, to, pair_kind(pair, source, target), [&, from = from, to = to](const Eigen::Matrix3d& turn) {
    const Eigen::Matrix3d rotation = to.axes() * turn * from.axes().transpose();
    return (after * turn).isApprox(turn * before) && rotation(0, 0) > 0; // it turns about x only
  });
}

} // namespace CGAL::Shape_correspondence::internal
