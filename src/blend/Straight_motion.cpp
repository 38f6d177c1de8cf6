// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "blend/Straight_motion.h"

namespace CGAL::Shape_correspondence::internal {
namespace {

constexpr int steps = 3, lattice = steps * steps * steps; // numbers of samples along an axis, and of all

Points mapped(const Eigen::Matrix<double, 3, 4>& affine, const Points& points)
{
  return (affine.leftCols<3>() * points).colwise() + affine.col(3);
}

} // namespace

Straight_motion::Straight_motion(const Part_chart& chart, const Points& contacts, const Space_warp& warp,
                                 const Points& ways)
    : samples_(3, lattice + contacts.cols())
{
  constexpr double most = 0.015; // distance from where the warp takes a contact, over the height
  const auto coordinate = [](int i) { return 2. * (i % steps) / (steps - 1) - 1; };
  for (int i = 0; i < lattice; ++i)
    samples_.col(i) = chart({coordinate(i / steps / steps), coordinate(i / steps), coordinate(i)});
  samples_.rightCols(contacts.cols()) = contacts;
  const Points due = warp.moved(contacts, ways);
  const auto is_off = [&] {
    return contacts.cols() > 0 && (mapped(fitted(warp, ways), contacts) - due).colwise().norm().maxCoeff() > most;
  };
  if (is_off()) kind_ = Kind::AFFINE;
  if (kind_ == Kind::AFFINE && is_off()) kind_ = Kind::FREE;
}

/// The map of the kind that is next to the warp at the samples; contacts weigh as much as the lattice.
Straight_motion::Affine Straight_motion::fitted(const Space_warp& warp, const Points& ways) const
{
  constexpr double thin = 0.02; // extent, over the height, along which a part is hardly stretched
  const Points ways_of_samples = warp.moved(samples_, ways) - samples_;
  const Eigen::Index contacts = samples_.cols() - lattice;
  const auto weight = [&](Eigen::Index i) { return i < lattice ? 1. / lattice : 1. / double(contacts); };
  Point middle = Point::Zero(), way = Point::Zero();
  double sum = 0;
  for (Eigen::Index i = 0; i < samples_.cols(); ++i) {
    middle += weight(i) * samples_.col(i);
    way += weight(i) * ways_of_samples.col(i);
    sum += weight(i);
  }
  middle /= sum, way /= sum;
  Eigen::Matrix3d spread = sum * thin * thin * Eigen::Matrix3d::Identity(), product = Eigen::Matrix3d::Zero();
  for (Eigen::Index i = 0; i < samples_.cols(); ++i) {
    const Point off = samples_.col(i) - middle;
    spread += weight(i) * off * off.transpose();
    product += weight(i) * (ways_of_samples.col(i) - way) * off.transpose();
  }
  Affine result;
  if (kind_ == Kind::STRETCH)
    result.leftCols<3>() = product.diagonal().cwiseQuotient(spread.diagonal()).asDiagonal();
  else
    result.leftCols<3>() = product * spread.inverse();
  result.leftCols<3>() += Eigen::Matrix3d::Identity();
  result.col(3) = middle + way - result.leftCols<3>() * middle;
  return result;
}

Points Straight_motion::moved(const Points& points, const Space_warp& warp, const Points& ways) const
{
  return kind_ == Kind::FREE ? warp.moved(points, ways) : mapped(fitted(warp, ways), points);
}

} // namespace CGAL::Shape_correspondence::internal
