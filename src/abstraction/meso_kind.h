// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "abstraction/intrinsic_extent.h"

#include <CGAL/Shape_correspondence/Segmented_shape.h>

#include <cmath>

namespace CGAL::Shape_correspondence::internal {

enum class Meso_kind { CURVE, SHEET, BLOB };

/// Measures of a meso-skeleton after most of the part's volume is gone.
struct Meso_measures
{
  double area_kept = 0; ///< area of the meso-skeleton over that of the part
  /// Intrinsic extents, as if its points were spread evenly in a box; longest first.
  Eigen::Vector3d extents = Eigen::Vector3d::Zero();
  double thickness = 0; ///< thickness of the part: its volume over half of its area
};

inline Meso_measures meso_measures(const Part_mesh& meso_skeleton, double area_kept, double thickness)
{
  const double box_over_root_mean_square = std::sqrt(12.);
  const Spatial_graph graph = edge_graph(meso_skeleton);
  return {area_kept, box_over_root_mean_square * intrinsic_layout(Spatial_graph_view(graph)).extents, thickness};
}

/// Thresholds at 2 % of the volume, chosen on the generated parts, whose kinds are known.
struct Meso_thresholds
{
  double sheet_area = 0.36;      ///< share of the area that only sheets keep; that of a rod falls as √volume, to 0.14
  double thin_sheet_area = 0.14; ///< share of the area that thin sheets keep, whose rims the flow draws in far
  double thin_sheet_width = 5;   ///< least width of a thin sheet, over its thickness
};

inline Meso_kind meso_kind(const Meso_measures& measures, const Meso_thresholds& thresholds = {})
{
  const double blob_width = 0.2; // ratio to the length
  const double blob_depth = 0.5; // ratio to the width
  const Eigen::Vector3d& extents = measures.extents;
  const bool is_thin_sheet =
      measures.area_kept > thresholds.thin_sheet_area && extents[1] > thresholds.thin_sheet_width * measures.thickness;
  if (is_thin_sheet || measures.area_kept > thresholds.sheet_area) {
    return Meso_kind::SHEET;
  }
  return extents[1] > blob_width * extents[0] && extents[2] >= blob_depth * extents[1] ? Meso_kind::BLOB
                                                                                       : Meso_kind::CURVE;
}

} // namespace CGAL::Shape_correspondence::internal
