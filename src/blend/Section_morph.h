// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "blend/Part_morph.h"
#include "blend/Section_outline.h"

#include <array>
#include <memory>

namespace CGAL::Shape_correspondence::internal {

/// The morph of a part to its counterpart by outlines of their cross-sections: a *stand-in*, the surface of the outlines
/// between, moves from the source to the target. The source's surface slides onto it until the target's replaces it.
class Section_morph : public Part_morph
{
public:
  /// \param charts charts of curves
  Section_morph(const Pair_charts& charts, const Part_mesh& source, const Part_mesh& target);

  Points points(int surface, double t) const override;
  /// Whether the surfaces are near the stand-in at their ends, and coincide when one replaces the other.
  bool is_faithful() const;
  /// Root mean square distance of the surfaces from the stand-in at their ends, over their diagonals: the larger one.
  double error() const { return error_; }

private:
  struct Sliding_surface
  {
    Points places;  ///< relative to the outline
    Points offsets; ///< from there to the surface at its end, in the frames of the chart
  };

  std::array<Part_chart, 2> charts_;
  std::vector<Section_outline> outlines_;
  std::array<Sliding_surface, 2> sliding_;
  double error_ = 0;
};

/// The morph with the least error, along the curves of the parts or the axes of their boxes.
std::shared_ptr<const Section_morph> best_section_morph(const Pair_charts& boxes, const Part_mesh& source, const Part_mesh& target);

} // namespace CGAL::Shape_correspondence::internal
