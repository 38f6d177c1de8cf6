// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "energy/cut_curves.h"
#include "base/optimal_assignment.h"
#include "energy/Unit_box.h"

#include <CGAL/assertions.h>

#include <algorithm>

namespace CGAL::Shape_correspondence {
using namespace internal;

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

namespace {

bool is_open_curve(const Sampled_part& part) { return part.kind == Sampled_part::Kind::CURVE; }

// The segment of a curve that corresponds to each of several curves: optimal assignment by places in the unit boxes.
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

} // namespace

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

} // namespace CGAL::Shape_correspondence
