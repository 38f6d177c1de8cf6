// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base/quantized.h"
#include "energy/rod_kernel.h"

#include <CGAL/Shape_correspondence/Deformation_energy.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Shape_correspondence {

double deformation_energy(const Energy_terms& terms, const Energy_weights& weights)
{
  return weights.distortion * terms.distortion + weights.connectedness * terms.connectedness +
         weights.split * terms.split + terms.unmatched + weights.roles * terms.roles;
}

double norm_loss(double mean_square) { return 1 - std::sqrt(mean_square); }

double rod_rotation(const Point& before, const Point& after)
{
  const double least = internal::zero_rod;
  if (before.squaredNorm() < least) return 1;
  return std::max(0.0, before.dot(after)) / std::sqrt(before.squaredNorm() * std::max(least, after.squaredNorm()));
}

double distortion_energy(double mean_squared_cosine) { return norm_loss(std::min(1.0, mean_squared_cosine)); }

double connectedness_energy(double shortest_before, double shortest_after, double longest_before)
{
  if (shortest_after <= shortest_before + internal::comparison_grid) return 0;
  return longest_before > 0 ? std::min(1.0, shortest_after / longest_before) : 1.0;
}

double split_energy(const std::vector<double>& solidity_ratios)
{
  if (solidity_ratios.empty()) return 0;
  double sum = 0;
  for (double s : solidity_ratios)
    sum += s * s;
  return norm_loss(sum / double(solidity_ratios.size()));
}

} // namespace CGAL::Shape_correspondence
