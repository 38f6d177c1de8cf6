// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SHAPE_CORRESPONDENCE_TEST_RANDOM_TABLES_H
#define SHAPE_CORRESPONDENCE_TEST_RANDOM_TABLES_H

#include <CGAL/Shape_correspondence/Pairwise_energy.h>

#include <algorithm>
#include <cstddef>
#include <random>

// A pairwise energy of random costs in which every variable has edges to the `width` variables before it.
inline CGAL::Shape_correspondence::Pairwise_energy random_tables(std::mt19937& random, std::size_t variables,
                                                                 int labels, std::size_t width)
{
  std::uniform_real_distribution<double> unit(0, 1);
  using CGAL::Shape_correspondence::Pairwise_energy;
  Pairwise_energy energy;
  Pairwise_energy::Root_term split{0.4, double(variables), {}, {}};
  for (std::size_t v = 0; v < variables; ++v) {
    energy.unary.push_back(Eigen::VectorXd::NullaryExpr(labels, [&] { return unit(random); }));
    split.unary.push_back(Eigen::VectorXd::NullaryExpr(labels, [&] { return unit(random); }));
    // No edge spans more than `width` variables, which bounds the treewidth of the graph by `width`
    for (std::size_t u = v - std::min(v, width); u < v; ++u)
      energy.edges.push_back({u, v, Eigen::MatrixXd::NullaryExpr(labels, labels, [&] { return unit(random); })});
  }
  energy.root_terms.push_back(split);
  return energy;
}

#endif // SHAPE_CORRESPONDENCE_TEST_RANDOM_TABLES_H
