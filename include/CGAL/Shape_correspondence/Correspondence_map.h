// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_CORRESPONDENCE_MAP_H
#define CGAL_SHAPE_CORRESPONDENCE_CORRESPONDENCE_MAP_H

#include <CGAL/Shape_correspondence/Correspondence.h>
#include <CGAL/Shape_correspondence/Structural_graph.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceMaps
/// A location on the abstraction of a part.
struct Part_parameter
{
  std::size_t part = 0;      ///< index of the part
  Eigen::Vector2d parameter; ///< (t, 0) on a curve, (u, v) on a sheet, see `evaluate()`
};

/// \ingroup PkgShapeCorrespondenceMaps
/// The piecewise continuous map between the curves and sheets of two shapes that extends their part correspondence
/// (paper, section 1).
///
/// Parts that correspond one to one are mapped as a whole, in the direction in which they are fitted to each other. A
/// part that corresponds to several is divided among them by their positions: a curve into intervals of its parameter,
/// a sheet into rectangles, each mapped to one part. Counterparts side by side across the curve or sheet get the same
/// piece, which is mapped to all of them. A curve is mapped to the middle of a sheet, in the longer direction. The map
/// is continuous within every piece.
class Correspondence_map
{
public:
  /// The map of a correspondence of two graphs.
  Correspondence_map(const Structural_graph& source, const Structural_graph& target,
                     const Correspondence& correspondence);

  /// The images of a location on the source: none if its part has no counterpart, otherwise one or several; on the
  /// border between two pieces, the images under both. Linear in the number of pieces of the part.
  std::vector<Part_parameter> operator()(const Part_parameter& place) const;

  /// The map from the target to the source.
  Correspondence_map inverse() const;

private:
  struct Pieces;

  explicit Correspondence_map(std::shared_ptr<const Pieces> pieces);

  std::shared_ptr<const Pieces> pieces_;
};

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_CORRESPONDENCE_MAP_H
