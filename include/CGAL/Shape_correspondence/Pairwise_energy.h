// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_PAIRWISE_ENERGY_H
#define CGAL_SHAPE_CORRESPONDENCE_PAIRWISE_ENERGY_H

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceSearch
/// The index of the label of every variable; `unassigned` for a variable without a label.
using Assignment = std::vector<int>;
/// \ingroup PkgShapeCorrespondenceSearch
/// The label of a variable that is not assigned yet.
constexpr int unassigned = -1;

/// \ingroup PkgShapeCorrespondenceSearch
/// The energy of an assignment of labels to variables, as tables: terms of one and of two variables, and terms of the
/// form w (1 - sqrt(Q / n)) where Q is again a sum of such terms (E_s of Eq. 5 is one; so is a pooled E_d).
struct Pairwise_energy
{
  /// An edge between two variables, with a value for every pair of their labels.
  struct Edge
  {
    std::size_t first;    ///< the smaller variable
    std::size_t second;   ///< the larger variable; a pair of variables has one edge at most
    Eigen::MatrixXd cost; ///< indexed by label of `first` and label of `second`
  };

  /// w (1 - sqrt(Q / n)), `norm_loss()` with a weight.
  /// \pre 0 <= Q <= n for every assignment
  struct Root_term
  {
    double weight = 0;                  ///< w, not negative
    double count = 1;                   ///< n, the number of squares that Q sums, each at most 1
    std::vector<Eigen::VectorXd> unary; ///< contribution to Q, by variable and label
    std::vector<Eigen::MatrixXd> edge;  ///< contribution to Q, by edge and pair of labels; empty: none

    /// The value of the term for a given Q.
    double operator()(double sum) const;
  };

  std::vector<Eigen::VectorXd> unary; ///< cost of each label, by variable
  std::vector<Edge> edges;            ///< the terms of two variables
  std::vector<Root_term> root_terms;  ///< the terms with a root

  /// Number of variables.
  std::size_t number_of_variables() const { return unary.size(); }
  /// Number of labels of a variable.
  std::size_t number_of_labels(std::size_t variable) const { return std::size_t(unary[variable].size()); }

  /// The sum Q under the root of a term, w (1 - sqrt(Q / n)), for an assignment.
  double root_sum(const Root_term& term, const Assignment& assignment) const;

  /// The energy of a complete assignment.
  double operator()(const Assignment& assignment) const;

  /// A lower bound of the energy: the sum of the least values of all terms.
  double lower_bound() const;
};

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_PAIRWISE_ENERGY_H
