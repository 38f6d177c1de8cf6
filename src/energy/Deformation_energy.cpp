// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/Deformation_energy.h>

#include <cmath>

namespace CGAL {
namespace Shape_correspondence {

double split_energy(const std::vector<double>& solidity_ratios)
{
  if (solidity_ratios.empty()) return 0;
  double sum = 0;
  for (double s : solidity_ratios)
    sum += s * s;
  return 1 - std::sqrt(sum / double(solidity_ratios.size()));
}

double deformation_energy(const Energy_terms& terms, const Energy_weights& weights)
{
  return weights.distortion * terms.distortion + weights.connectedness * terms.connectedness +
         weights.split * terms.split + terms.unmatched;
}

} // namespace Shape_correspondence
} // namespace CGAL
