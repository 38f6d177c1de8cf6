// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "energy/cut_parts.h"
#include "base/clamped.h"
#include "base/divide_box.h"
#include "base/optimal_assignment.h"

#include <CGAL/assertions.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

constexpr int e = samples_per_side;

bool is_open_curve(const Sampled_part& part) { return part.kind == Sampled_part::Kind::CURVE; }

// The segment of a curve that corresponds to each of several curves, by optimal assignment in the unit boxes.
std::vector<std::size_t> matching_segments(const Sampled_part& curve, const Unit_box& curve_box,
                                           const std::vector<Point>& centroids, const Unit_box& box)
{
  const int count = int(centroids.size());
  Eigen::MatrixXd cost(count, count);
  for (int j = 0; j < count; ++j) {
    const Point place = curve_box(segment(curve, j, count).centroid);
    for (int i = 0; i < count; ++i)
      cost(i, j) = quantized_distance(box(centroids[std::size_t(i)]), place);
  }
  return optimal_assignment(cost);
}

bool is_sheet(const Sampled_part& part) { return part.kind == Sampled_part::Kind::SHEET; }

Point sample(const Sampled_part& sheet, int u, int v) { return sheet.samples.col(u * e + v); }

// The mean directions of a sheet along u and along v, and its normal, as columns.
Eigen::Matrix3d axes(const Sampled_part& sheet)
{
  Point u = Point::Zero(), v = Point::Zero();
  for (int i = 0; i < e; ++i) {
    u += sample(sheet, e - 1, i) - sample(sheet, 0, i);
    v += sample(sheet, i, e - 1) - sample(sheet, i, 0);
  }
  Eigen::Matrix3d result;
  result.col(0) = u.stableNormalized();
  result.col(1) = (v - result.col(0).dot(v) * result.col(0)).stableNormalized();
  result.col(2) = Point(result.col(0)).cross(Point(result.col(1)));
  return result;
}

// Divides a sheet among its counterparts into rectangles of its parameter domain.
void divide_among(const Sampled_part& sheet, const std::vector<Sampled_part>& others,
                  const std::vector<Piece_image*>& images, Piece Piece_image::*divided, Piece Piece_image::*other)
{
  const Eigen::Matrix3d directions = axes(sheet).transpose();
  std::vector<Share> shares;
  for (const Piece_image* image : images) {
    const Points samples = directions * others[(image->*other).part].samples;
    shares.push_back({samples.rowwise().mean(), (samples.rowwise().maxCoeff() - samples.rowwise().minCoeff()) / 2});
  }
  const std::vector<Eigen::AlignedBox3d> boxes = divide_box({Point::Zero(), Point::Ones()}, shares);
  for (std::size_t i = 0; i < images.size(); ++i) {
    Piece& piece = images[i]->*divided;
    for (std::size_t axis : {0, 1}) {
      piece.low[axis] = boxes[i].min()[Eigen::Index(axis)];
      piece.high[axis] = boxes[i].max()[Eigen::Index(axis)];
    }
  }
}

} // namespace

Sampled_part segment(const Sampled_part& curve, int index, int count)
{
  CGAL_precondition(curve.kind == Sampled_part::Kind::CURVE && 0 <= index && index < count);
  // Samples are equally spaced along the curve
  Sampled_part result;
  result.samples.resize(3, samples_per_side);
  for (int i = 0; i < samples_per_side; ++i) {
    const double at = (index * (samples_per_side - 1) + i) / double(count);
    const int before = std::min(int(at), samples_per_side - 2);
    result.samples.col(i) =
        curve.samples.col(before) + (at - before) * (curve.samples.col(before + 1) - curve.samples.col(before));
  }
  result.centroid = result.samples.rowwise().mean();
  return result;
}

Sampled_part rectangle(const Sampled_part& sheet, const std::array<double, 2>& low, const std::array<double, 2>& high)
{
  CGAL_precondition(is_sheet(sheet));
  Sampled_part result;
  result.kind = Sampled_part::Kind::SHEET;
  result.samples.resize(3, Eigen::Index(e) * e);
  std::array<std::array<std::pair<int, double>, e>, 2> places; // by axis: index of the cell and fraction within it
  for (std::size_t axis : {0, 1})
    for (int i = 0; i < e; ++i) {
      const double at = (low[axis] + (high[axis] - low[axis]) * i / (e - 1)) * (e - 1);
      const int cell = clamped_cell(at, e - 2);
      places[axis][std::size_t(i)] = {cell, at - cell};
    }
  for (int i = 0; i < e; ++i)
    for (int j = 0; j < e; ++j) {
      const auto [u, s] = places[0][std::size_t(i)];
      const auto [v, t] = places[1][std::size_t(j)];
      result.samples.col(i * e + j) = (1 - s) * ((1 - t) * sample(sheet, u, v) + t * sample(sheet, u, v + 1)) +
                                      s * ((1 - t) * sample(sheet, u + 1, v) + t * sample(sheet, u + 1, v + 1));
    }
  result.centroid = result.samples.rowwise().mean();
  return result;
}

Group_label cut_curves(const Aligned_shape& source, std::size_t source_group, const Aligned_shape& target,
                       const Group_label& label)
{
  const auto &from = source.group(source_group).parts, &to = target.group(label.target_group).parts;
  Group_label result = label;
  const auto centroids = [](const Aligned_shape& shape, const std::vector<std::size_t>& parts) {
    std::vector<Point> points;
    for (std::size_t part : parts)
      points.push_back(shape.parts[part].centroid);
    return points;
  };
  const auto all_curves = [](const Aligned_shape& shape, const std::vector<std::size_t>& parts) {
    return std::all_of(parts.begin(), parts.end(), [&](std::size_t part) { return is_open_curve(shape.parts[part]); });
  };
  const Unit_box from_box(source.boxes[source_group]), to_box(target.boxes[label.target_group]);

  for (std::vector<Piece_image>& images : result.images) {
    const std::size_t part = images[0].source.part;
    std::vector<std::size_t> parts;
    for (const Piece_image& image : images)
      parts.push_back(image.target.part);
    if (parts.size() < 2 || !is_open_curve(source.parts[part]) || !all_curves(target, parts)) continue;
    const auto segments = matching_segments(source.parts[part], from_box, centroids(target, parts), to_box);
    for (std::size_t i = 0; i < images.size(); ++i)
      images[i].source = {part, int(segments[i]), int(parts.size())};
    result.operation = Operation::CUT;
  }
  for (std::size_t part : to) {
    std::vector<std::size_t> members, parts;
    for (std::size_t i = 0; i < from.size(); ++i)
      if (result.images[i].size() == 1 && result.images[i][0].target.part == part)
        members.push_back(i), parts.push_back(from[i]);
    if (parts.size() < 2 || !is_open_curve(target.parts[part]) || !all_curves(source, parts)) continue;
    const auto segments = matching_segments(target.parts[part], to_box, centroids(source, parts), from_box);
    for (std::size_t i = 0; i < members.size(); ++i)
      result.images[members[i]][0].target = {part, int(segments[i]), int(parts.size())};
    result.operation = Operation::JOIN;
  }
  return result;
}

void divide_sheets(const Aligned_shape& source, const Aligned_shape& target, Group_label& label)
{
  std::map<std::size_t, std::vector<Piece_image*>> of_target;
  for (std::vector<Piece_image>& images : label.images) {
    std::vector<Piece_image*> of_part;
    for (Piece_image& image : images) {
      of_part.push_back(&image);
      of_target[image.target.part].push_back(&image);
    }
    if (of_part.size() > 1 && is_sheet(source.parts[images[0].source.part]))
      divide_among(source.parts[images[0].source.part], target.parts, of_part, &Piece_image::source,
                   &Piece_image::target);
  }
  for (const auto& [part, of_part] : of_target)
    if (of_part.size() > 1 && is_sheet(target.parts[part]))
      divide_among(target.parts[part], source.parts, of_part, &Piece_image::target, &Piece_image::source);
}

} // namespace CGAL::Shape_correspondence
