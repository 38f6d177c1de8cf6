// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Shape_correspondence/Deformation_energy.h>
#include <CGAL/Shape_correspondence/Pairwise_energy.h>

#include <algorithm>

namespace CGAL::Shape_correspondence {

double Pairwise_energy::Root_term::operator()(double sum) const { return weight * norm_loss(sum / count); }

double Pairwise_energy::root_sum(const Root_term& term, const Assignment& assignment) const
{
  double sum = 0;
  for (std::size_t v = 0; v < unary.size(); ++v)
    sum += term.unary[v][assignment[v]];
  for (std::size_t e = 0; e < term.edge.size(); ++e)
    sum += term.edge[e](assignment[edges[e].first], assignment[edges[e].second]);
  return sum;
}

double Pairwise_energy::operator()(const Assignment& assignment) const
{
  double sum = 0;
  for (std::size_t v = 0; v < unary.size(); ++v)
    sum += unary[v][assignment[v]];
  for (const Edge& edge : edges)
    sum += edge.cost(assignment[edge.first], assignment[edge.second]);
  for (const Root_term& term : root_terms)
    sum += term(root_sum(term, assignment));
  return sum;
}

double Pairwise_energy::lower_bound() const
{
  double sum = 0;
  for (const Eigen::VectorXd& costs : unary)
    sum += costs.minCoeff();
  for (const Edge& edge : edges)
    sum += edge.cost.minCoeff();
  for (const Root_term& term : root_terms) {
    double most = 0;
    for (const Eigen::VectorXd& shares : term.unary)
      most += shares.maxCoeff();
    for (const Eigen::MatrixXd& shares : term.edge)
      most += shares.maxCoeff();
    sum += term(std::min(most, term.count));
  }
  return sum;
}

} // namespace CGAL::Shape_correspondence
