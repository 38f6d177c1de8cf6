// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "energy/divide_sheets.h"
#include "base/clamped.h"
#include "base/divide_box.h"

#include <CGAL/assertions.h>

#include <algorithm>
#include <functional>
#include <utility>

namespace CGAL::Shape_correspondence {
using namespace internal;

namespace {

constexpr int e = samples_per_side;

bool is_sheet(const Sampled_part& part) { return part.kind == Sampled_part::Kind::SHEET; }

Point sample(const Sampled_part& sheet, int u, int v) { return sheet.samples.col(u * e + v); }

// The mean directions of a sheet along u, along v, and its normal.
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

// The rectangles of parameters that divide a sheet among some parts.
std::vector<Eigen::AlignedBox3d> rectangles(const Sampled_part& sheet, const std::vector<const Sampled_part*>& parts)
{
  const Eigen::Matrix3d directions = axes(sheet).transpose();
  std::vector<Share> shares;
  for (const Sampled_part* part : parts) {
    const Points samples = directions * part->samples;
    shares.push_back({samples.rowwise().mean(), (samples.rowwise().maxCoeff() - samples.rowwise().minCoeff()) / 2});
  }
  return divide_box({Point::Zero(), Point::Ones()}, shares);
}

// Divides a sheet among the parts on the other side of its images.
void divide_among(const Sampled_part& sheet, const std::vector<Sampled_part>& others,
                  const std::vector<Piece_image*>& images, Piece Piece_image::*divided, Piece Piece_image::*other)
{
  std::vector<const Sampled_part*> parts;
  for (const Piece_image* image : images)
    parts.push_back(&others[(image->*other).part]);
  const std::vector<Eigen::AlignedBox3d> boxes = rectangles(sheet, parts);
  for (std::size_t i = 0; i < images.size(); ++i) {
    Piece& piece = images[i]->*divided;
    for (std::size_t axis : {0, 1}) {
      piece.low[axis] = boxes[i].min()[Eigen::Index(axis)];
      piece.high[axis] = boxes[i].max()[Eigen::Index(axis)];
    }
  }
}

} // namespace

Sampled_part rectangle(const Sampled_part& sheet, const std::array<double, 2>& low, const std::array<double, 2>& high)
{
  CGAL_precondition(is_sheet(sheet));
  Sampled_part result;
  result.kind = Sampled_part::Kind::SHEET;
  result.samples.resize(3, Eigen::Index(e) * e);
  std::array<std::array<std::pair<int, double>, e>, 2> places; // by axis: index of the cell, fraction of it
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

void divide_sheets(const Aligned_shape& source, const Aligned_shape& target, Group_label& label)
{
  std::vector<std::size_t> targets;
  for (std::vector<Piece_image>& images : label.images) {
    std::vector<Piece_image*> of_part;
    for (Piece_image& image : images) {
      of_part.push_back(&image);
      targets.push_back(image.target.part);
    }
    if (of_part.size() > 1 && is_sheet(source.parts[images[0].source.part]))
      divide_among(source.parts[images[0].source.part], target.parts, of_part, &Piece_image::source,
                   &Piece_image::target);
  }
  std::sort(targets.begin(), targets.end());
  targets.erase(std::unique(targets.begin(), targets.end()), targets.end());
  for (std::size_t part : targets) {
    if (!is_sheet(target.parts[part])) continue;
    std::vector<Piece_image*> of_part;
    for (std::vector<Piece_image>& images : label.images)
      for (Piece_image& image : images)
        if (image.target.part == part) of_part.push_back(&image);
    if (of_part.size() > 1)
      divide_among(target.parts[part], source.parts, of_part, &Piece_image::target, &Piece_image::source);
  }
}

} // namespace CGAL::Shape_correspondence
