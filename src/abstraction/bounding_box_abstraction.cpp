// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "abstraction/bounding_box.h"

#include <CGAL/Shape_correspondence/abstract_part.h>

namespace CGAL::Shape_correspondence {
using namespace internal;

Part_abstraction Bounding_box_abstraction::operator()(const Shape_part& part, const Abstraction_options& options) const
{
  const Oriented_box box = oriented_box(part.mesh.points);
  const Abstraction_kind kind = options.kind_of(part.name);
  const bool is_sheet = kind == Abstraction_kind::AUTOMATIC ? is_flat(box.extents) : kind == Abstraction_kind::SHEET;
  Part_abstraction result;
  if (is_sheet)
    result.geometry = medial_sheet(box, options.sheet_points);
  else
    result.geometry = medial_curve(box, options.curve_points);
  result.report.method = Abstraction_report::Method::BOUNDING_BOX;
  result.report.blob = !is_sheet && is_compact(box.extents);
  return result;
}

} // namespace CGAL::Shape_correspondence
