// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matching/nearest_points_kernel.h"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <string>

using namespace CGAL::Shape_correspondence;

TEST_CASE("Every kernel, the plain one and the machine's widest too, finds the nearest points of a loop to the bit")
{
  const auto kernels = internal::available_nearest_squared_kernels();
  CHECK(kernels.front().name == std::string("plain"));
#if defined(__x86_64__) && defined(__GNUC__)
  REQUIRE(kernels.size() > 1);
  if (kernels.back().name != std::string("avx512"))
    WARN("this machine has no AVX-512: that kernel is not tested, the widest one is " << kernels.back().name);
#endif
  std::srand(7);
  for (const int n : {1, 6, 37})
    for (const int m : {1, 8, 36}) {
      const Eigen::ArrayX3d a = Eigen::ArrayX3d::Random(n, 3), b = Eigen::ArrayX3d::Random(m, 3);
      Eigen::ArrayXXd squared(n, m);
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < m; ++j) {
          const double x = b(j, 0) - a(i, 0), y = b(j, 1) - a(i, 1), z = b(j, 2) - a(i, 2);
          squared(i, j) = x * x + y * y + z * z;
        }
      const internal::Point_lanes p(a), q(b);
      for (const internal::Nearest_squared_kernel& kernel : kernels) {
        CAPTURE(kernel.name, n, m);
        Eigen::ArrayXd p_from_q(p.padded()), q_from_p(q.padded());
        kernel.run(p, q, p_from_q.data(), q_from_p.data());
        CHECK((p_from_q.head(n) == squared.rowwise().minCoeff()).all());
        CHECK((q_from_p.head(m) == squared.colwise().minCoeff().transpose()).all());
      }
    }
}
