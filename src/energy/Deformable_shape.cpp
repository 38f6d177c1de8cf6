// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "energy/Deformable_shape.h"
#include "energy/deform_to_fit.h"

#include <mutex>
#include <utility>

namespace CGAL::Shape_correspondence {

struct Deformable_shape::Measures
{
  std::once_flag has_rods, has_distances;
  std::vector<Contact_rods> rods;
  Eigen::MatrixXd distances;
};

namespace {

// The number of samples of a part, or that of a sheet.
Eigen::Index sample_count(const Sampled_part& part, bool lift)
{
  return lift ? samples_per_side * samples_per_side : part.samples.cols();
}

Deformable_shape::Contact_rods contact_rods(const Sampled_part& first, const Sampled_part& second)
{
  using Kind = Sampled_part::Kind;
  Deformable_shape::Contact_rods rods;
  for (bool lift_first : {false, true})
    for (bool lift_second : {false, true}) {
      if ((lift_first && first.kind == Kind::SHEET) || (lift_second && second.kind == Kind::SHEET)) continue;
      rods[2 * std::size_t(lift_first) + std::size_t(lift_second)] =
          Structural_rods(lifted_samples(first, sample_count(first, lift_first)),
                          lifted_samples(second, sample_count(second, lift_second)));
    }
  return rods;
}

Eigen::MatrixXd least_distances(const std::vector<Sampled_part>& parts)
{
  const Eigen::Index n = Eigen::Index(parts.size());
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < i; ++j)
      result(i, j) = result(j, i) = least_distance(parts[std::size_t(i)].samples, parts[std::size_t(j)].samples);
  return result;
}

} // namespace

Deformable_shape::Deformable_shape(Aligned_shape shape)
    : Aligned_shape(std::move(shape)), measures_(std::make_shared<Measures>())
{}

const std::vector<Deformable_shape::Contact_rods>& Deformable_shape::rods() const
{
  std::call_once(measures_->has_rods, [&] {
    for (const Contact& contact : contacts)
      measures_->rods.push_back(contact_rods(parts[contact.parts[0]], parts[contact.parts[1]]));
  });
  return measures_->rods;
}

const Eigen::MatrixXd& Deformable_shape::part_distances() const
{
  std::call_once(measures_->has_distances, [&] { measures_->distances = least_distances(parts); });
  return measures_->distances;
}

Deformable_shape Deformable_shape::ungrouped() const
{
  Deformable_shape result(Shape_correspondence::ungrouped(*this));
  result.measures_ = measures_;
  return result;
}

} // namespace CGAL::Shape_correspondence
