// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Space_warp.h"

namespace CGAL::Shape_correspondence::internal {

/// How an unmatched part follows a warp: by the simplest motion that keeps it at its contacts. What is straight or flat
/// stays so but for the last one: it is stretched along the axes of the world, mapped affinely, or bent as space is.
class Straight_motion
{
public:
  /// \param contacts places of contacts of the part \param ways of the warp, half-way of the blend
  Straight_motion(const Part_chart& chart, const Points& contacts, const Space_warp& warp, const Points& ways);

  Points moved(const Points& points, const Space_warp& warp, const Points& ways) const;

private:
  enum class Kind { STRETCH, AFFINE, FREE };
  using Affine = Eigen::Matrix<double, 3, 4>;

  Affine fitted(const Space_warp& warp, const Points& ways) const;

  Kind kind_ = Kind::STRETCH;
  Points samples_; ///< a lattice in the part's chart, then the contacts
};

} // namespace CGAL::Shape_correspondence::internal
