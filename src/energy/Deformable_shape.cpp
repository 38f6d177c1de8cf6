// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "energy/Deformable_shape.h"
#include "base/Once.h"

#include <utility>
#include <vector>

namespace CGAL::Shape_correspondence {
using namespace internal;

struct Deformable_shape::Measures
{
  struct Lazy_rods
  {
    Once is_found;
    Structural_rods rods;
  };

  explicit Measures(std::size_t contacts) : rods(new Lazy_rods[4 * contacts]) {}

  std::unique_ptr<Lazy_rods[]> rods; // index: 4 contact + 2 (first part is repeated) + (second part is repeated)
  Once has_distances;
  Eigen::MatrixXd distances;
};

namespace {

Eigen::MatrixXd least_distances(const std::vector<Sampled_part>& parts)
{
  const Eigen::Index n = Eigen::Index(parts.size());
  std::vector<Sample_lanes> lanes;
  for (const Sampled_part& part : parts)
    lanes.emplace_back(part.samples);
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < i; ++j) {
      const std::size_t a = std::size_t(i), b = std::size_t(j);
      result(i, j) = result(j, i) =
          least_distance(lanes[a], int(parts[a].samples.cols()), lanes[b], int(parts[b].samples.cols()));
    }
  return result;
}

} // namespace

Deformable_shape::Deformable_shape(Aligned_shape shape)
    : Aligned_shape(std::move(shape)), measures_(std::make_shared<Measures>(contacts.size()))
{}

const Structural_rods& Deformable_shape::rods(std::size_t contact, int first_repeats, int second_repeats) const
{
  Measures::Lazy_rods& lazy = measures_->rods[4 * contact + (first_repeats > 1 ? 2 : 0) + (second_repeats > 1 ? 1 : 0)];
  lazy.is_found([&] {
    const auto& ends = contacts[contact].parts;
    lazy.rods = Structural_rods(parts[ends[0]].samples, parts[ends[1]].samples, first_repeats, second_repeats);
  });
  return lazy.rods;
}

const Eigen::MatrixXd& Deformable_shape::part_distances() const
{
  measures_->has_distances([&] { measures_->distances = least_distances(parts); });
  return measures_->distances;
}

Deformable_shape Deformable_shape::ungrouped() const
{
  Deformable_shape result(Shape_correspondence::ungrouped(*this));
  result.measures_ = measures_;
  return result;
}

Deformable_shape Deformable_shape::regrouped(const std::vector<std::vector<std::size_t>>& sets) const
{
  Deformable_shape result(Shape_correspondence::regrouped(*this, sets));
  result.measures_ = measures_;
  return result;
}

} // namespace CGAL::Shape_correspondence
