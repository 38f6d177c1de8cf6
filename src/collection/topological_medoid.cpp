// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/topological_medoid.h>

#include <CGAL/assertions.h>

#include <limits>

namespace CGAL::Shape_correspondence {

std::size_t topological_medoid(const Eigen::Ref<const Eigen::MatrixXd>& distances)
{
  CGAL_precondition(distances.rows() > 0 && distances.rows() == distances.cols());
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < distances.rows(); ++i) {
    double sum = 0; // summed one by one: the order of Eigen's sum depends on the processor
    for (Eigen::Index j = 0; j < distances.cols(); ++j)
      sum += distances(j, i); // the matrix is symmetric, and columns are contiguous
    if (sum < least) least = sum, best = std::size_t(i);
  }
  return best;
}

} // namespace CGAL::Shape_correspondence
