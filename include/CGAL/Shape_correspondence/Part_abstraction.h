// Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
//
// This file is part of the CGAL package Shape_correspondence.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : the Shape_correspondence developers

#ifndef CGAL_SHAPE_CORRESPONDENCE_PART_ABSTRACTION_H
#define CGAL_SHAPE_CORRESPONDENCE_PART_ABSTRACTION_H

#include <CGAL/Shape_correspondence/Points.h>

#include <string>
#include <variant>

namespace CGAL::Shape_correspondence {

/// \ingroup PkgShapeCorrespondenceAbstraction
/// The abstraction of an elongated part: a polyline, parametrized by t in [0, 1], the fraction of its length.
struct Curve
{
  Points points;       ///< at least 2 control points; a closed curve does not repeat its first one
  bool closed = false; ///< whether the last control point is joined to the first one

  /// The point at parameter `t`, linear in between control points. O(number of points).
  Point operator()(double t) const;
};

/// \ingroup PkgShapeCorrespondenceAbstraction
/// The abstraction of a plate-like part: a grid of control points with bilinear interpolation, parametrized by (u, v)
/// in [0, 1]²; u runs over the rows, v over the columns.
struct Sheet
{
  Points points; ///< control point (row i, column j) is column i * cols + j
  int rows = 0;  ///< number of rows, at least 2
  int cols = 0;  ///< number of columns, at least 2

  /// The point at parameters (`u`, `v`). O(1).
  Point operator()(double u, double v) const;
};

/// \ingroup PkgShapeCorrespondenceAbstraction
/// Time of each phase of an abstraction, in milliseconds.
struct Phase_milliseconds
{
  double measure = 0; ///< time for the area, the hull and the surface samples
  double repair = 0;  ///< time for making the surface closed
  double remesh = 0;  ///< time for isotropic remeshing
  double flow = 0;    ///< time for the mean curvature flow
  double fit = 0;     ///< time for the decision on curve or sheet, and for fitting it
};

/// \ingroup PkgShapeCorrespondenceAbstraction
/// How an abstraction was made, and how well it fits.
struct Abstraction_report
{
  /// The object to which a curve or sheet was fitted.
  enum class Method {
    SKELETON,      ///< the curve skeleton, by mean curvature flow until convergence
    MESO_SKELETON, ///< the meso-skeleton, by mean curvature flow until little of the enclosed volume is left
    MEDIAL_AXIS,   ///< the medial axis
    AXIS,          ///< none: the axis of a body of revolution or of a block
    PRISM,         ///< none: the axis or the middle layer of a prism whose faces show it, such as a box or a cylinder
    BOUNDING_BOX,  ///< the bounding box
    COPY,          ///< none: the abstraction of a congruent part, moved
    GIVEN          ///< unknown: from a file or another abstractor
  };
  /// How the surface of a part was closed.
  enum class Repair {
    NONE,  ///< nothing was changed
    SOUP,  ///< double and degenerate triangles were removed, others oriented
    HOLES, ///< holes were filled
    WRAP   ///< the surface was wrapped (`CGAL::alpha_wrap_3()`)
  };

  Method method = Method::GIVEN; ///< object to which the curve or sheet was fitted
  Repair repair = Repair::NONE;  ///< how the surface was closed
  bool tube = false; ///< whether the part is a hollow tube, abstracted by its axis of revolution or a sheet across it
  bool blob = false; ///< whether the part is neither elongated nor flat: its curve is an axis or a skeleton
  bool branching = false;          ///< whether the curve or sheet is a rough approximation: `coverage` is less than 0.8
  bool several_components = false; ///< whether the part's surface is disconnected
  bool hull_of_box = false; ///< whether the hull is that of the part's bounding box, since it could not be computed
  bool time_limit = false;  ///< whether the time limit was reached
  std::string fallback;     ///< reason for using the bounding box (for a copy: of its original); empty: it was not used
  std::string copy_of;      ///< name of the original, if the part is a copy
  double residual = 0;      ///< root mean square distance from the points it was fitted to, over the part's diagonal
  double coverage = 1;      ///< of a curve: its length over that of the skeleton; of a sheet: its share inside the part
  int iterations = 0;       ///< number of steps of the flow
  double milliseconds = 0;  ///< time of the abstraction; not saved in files
  Phase_milliseconds phases; ///< time of each phase

  /// Whether the bounding box was used because no skeleton could be computed.
  bool is_fallback() const { return !fallback.empty(); }
};

/// \ingroup PkgShapeCorrespondenceAbstraction
/// The abstraction of a part: a curve or a sheet, and measures of its mesh.
struct Part_abstraction
{
  std::string name;                    ///< name of the part
  std::variant<Curve, Sheet> geometry; ///< the curve or sheet, in world coordinates
  double volume = 0;                   ///< volume of the enclosed solid; 0 if unknown
  double hull_volume = 0;              ///< volume of the convex hull; 0 if unknown or flat
  double area = 0;                     ///< area of the surface; 0 if unknown
  Points surface; ///< points spread evenly over the surface, as are the first n of them for any n; empty: unknown
  Points hull;    ///< vertices of the convex hull; empty if unknown
  Abstraction_report report; ///< how the abstraction was made

  /// Whether `geometry` is a sheet.
  bool is_sheet() const { return std::holds_alternative<Sheet>(geometry); }
  /// Whether `geometry` is a closed curve.
  bool is_closed_curve() const { return !is_sheet() && std::get<Curve>(geometry).closed; }
  /// The control points of the curve or sheet.
  const Points& control_points() const;
};

/// \ingroup PkgShapeCorrespondenceAbstraction
/// Samples of a curve at e uniform parameters (0, 1/(e-1), …, 1; closed: 0, 1/e, …, (e-1)/e), or of a sheet at e × e
/// uniform parameters, row by row (paper, section 4.3, "Sampling").
/// \pre `e >= 2`
Points sample(const Curve& curve, int e);
/// \ingroup PkgShapeCorrespondenceAbstraction
/// Samples of a sheet at e × e uniform parameters, row by row.
Points sample(const Sheet& sheet, int e);
/// \ingroup PkgShapeCorrespondenceAbstraction
/// Samples of a part's curve or sheet, see `sample(const Curve&, int)`.
Points sample(const Part_abstraction& part, int e);

/// \ingroup PkgShapeCorrespondenceAbstraction
/// The parameters of the point of the abstraction nearest to `p`: (t, 0) on a curve, (u, v) on a sheet.
Eigen::Vector2d nearest_parameter(const Part_abstraction& part, const Point& p);

/// \ingroup PkgShapeCorrespondenceAbstraction
/// The point of the abstraction at a parameter: (t, 0) on a curve, (u, v) on a sheet.
Point evaluate(const Part_abstraction& part, const Eigen::Vector2d& parameter);

/// \ingroup PkgShapeCorrespondenceAbstraction
/// Solidity (paper, section 4.3): volume over that of the convex hull, at most 1; 1 if either is unknown or 0.
double solidity(double volume, double hull_volume);

} // namespace CGAL::Shape_correspondence

#endif // CGAL_SHAPE_CORRESPONDENCE_PART_ABSTRACTION_H
